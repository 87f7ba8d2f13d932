// Shapes of the fields of shipped scenes, as a page gets them.
#include "session/drawn_shapes.h"

#include <cmath>
#include <cstring>

#include "designs.h"
#include "session/scene_field.h"

namespace delos::session {
namespace {

constexpr double kNoEnd = std::numeric_limits<double>::infinity();

/// Cells of a grid that have a value at each corner, and all of them.
std::pair<std::size_t, std::size_t> cells_of(const DrawnField& drawn) {
  const auto& grid = std::get<GridShape>(drawn.field.samples.parts.at(0).shape);
  const std::int64_t nx = grid.counts.x(), ny = grid.counts.y();
  std::size_t whole = 0, all = 0;
  for (std::int64_t z = 0; z + 1 < grid.counts.z(); ++z)
    for (std::int64_t y = 0; y + 1 < ny; ++y)
      for (std::int64_t x = 0; x + 1 < nx; ++x, ++all) {
        bool has = true;
        for (std::int64_t c = 0; c < 8; ++c) {
          const auto i = static_cast<std::size_t>(
              x + (c & 1) + nx * (y + (c >> 1 & 1) + ny * (z + (c >> 2))));
          has = has && drawn.mask[i] == Drawn::value;
        }
        whole += has;
      }
  return {whole, all};
}

// Without ends a body is all cells that see, by volume: 363 of 2541 samples are blind.
TEST(DrawnShapes, HaveNothingOfWhatIsBlind) {
  const DrawnField drawn = draw_field(design_of("02-eight-cameras").loaded(), 0, {});
  const auto& grid = std::get<GridShape>(drawn.field.samples.parts.at(0).shape);
  const auto [whole, all] = cells_of(drawn);
  ASSERT_LT(whole, all);
  const auto meshes = shapes_of(drawn, BetweenShape{-kNoEnd, kNoEnd}, nullptr);
  ASSERT_EQ(meshes.size(), 1u);
  const double volume = grid.step.prod() * static_cast<double>(whole);
  EXPECT_NEAR(shapes::volume_of(meshes[0].mesh), volume, 1e-9 * volume);
}

// Two bodies that share an end are one.
TEST(DrawnShapes, AddUp) {
  const DrawnField drawn = draw_field(design_of("01-acoustic").loaded(), 0, {});
  const auto volume = [&](double low, double high) {
    return shapes::volume_of(
        shapes_of(drawn, BetweenShape{low, high}, nullptr).at(0).mesh);
  };
  EXPECT_NEAR(volume(-kNoEnd, 0.03) + volume(0.03, kNoEnd), volume(-kNoEnd, kNoEnd),
              1e-9);
  EXPECT_GT(volume(0.02, 0.03), 0);
}

TEST(DrawnShapes, OfReliefsAreAsHighAsTheField) {
  const DrawnField drawn = draw_field(design_of("04-motion-capture").loaded(), 0, {});
  const Extreme least = summarize(drawn.field).min;
  const ReliefShape raised{shapes::AxisPlane{2, least.at.z()},
                           {0, least.value, false, 2.0}};
  const auto meshes = shapes_of(drawn, raised, nullptr);
  ASSERT_EQ(meshes.size(), 1u);
  bool met = false;
  for (std::size_t k = 0; k < meshes[0].values.size(); ++k) {
    const Eigen::Vector3d& p = meshes[0].mesh.vertices[k];
    EXPECT_NEAR(p.z() - least.at.z(), 2 * meshes[0].values[k] / least.value, 1e-9);
    if ((p - least.at).head<2>().norm() < 1e-9) {
      met = true;
      EXPECT_EQ(meshes[0].values[k], least.value);
    }
  }
  EXPECT_TRUE(met);
}

TEST(DrawnShapes, AreTheLeavesThatTheFieldWasMadeOf) {
  Design design = design_of("06-furnished-lab");
  change(design, {{"sample.volume.adaptive.depth", "3"}});
  const Evaluation evaluation = evaluate_scene(design.loaded(), {});
  const std::size_t leaves = evaluation.octree->report().leaves;
  const DrawnField drawn = draw_field(design.loaded(), 0, {});
  EXPECT_EQ(leaves_of(drawn, std::nullopt).leaves, leaves);
  const std::size_t some = leaves_of(drawn, shapes::AxisPlane{2, 1.0}).leaves;
  EXPECT_TRUE(some > 0 && some < leaves) << some;
  EXPECT_EQ(leaves_of(draw_field(design.loaded(), 500, {}), std::nullopt).leaves, 0u)
      << "a coarse one isn't read from it";
}

TEST(DrawnShapes, ArePacked) {
  const DrawnField drawn = draw_field(design_of("01-acoustic").loaded(), 0, {});
  MadeShapes made;
  made.meshes.push_back({});
  made.meshes.push_back(shapes_of(drawn, BetweenShape{0.02, 0.03}, nullptr));
  const shapes::ShapeMesh& shape = made.meshes[1].at(0);
  const std::string bytes = packed_shapes(made, true, 5);
  EXPECT_EQ(bytes.substr(0, 4), "DLS1");
  std::uint32_t length = 0;
  std::memcpy(&length, bytes.data() + 4, sizeof length);
  const Json head = Json::parse(bytes.substr(8, length));
  EXPECT_EQ(head["revision"], 5);
  EXPECT_EQ(head["level"], "coarse");
  EXPECT_TRUE(head["leaves"].is_null());
  ASSERT_EQ(head["meshes"].size(), 1u);
  const Json& mesh = head["meshes"][0];
  EXPECT_EQ(mesh["shape"], 1);
  EXPECT_EQ(mesh["vertices"], shape.values.size());
  EXPECT_EQ(mesh["caps"], 3 * shape.caps);
  const auto number_at = [&](const char* key, std::size_t i, auto number) {
    std::memcpy(
        &number,
        bytes.data() + 8 + length + mesh[key].get<std::size_t>() + i * sizeof number,
        sizeof number);
    return number;
  };
  for (std::size_t i = 0; i < shape.values.size(); ++i) {
    EXPECT_EQ(number_at("values", i, 0.0f), static_cast<float>(shape.values[i]));
    for (std::size_t k = 0; k < 3; ++k) {
      const auto axis = static_cast<Eigen::Index>(k);
      EXPECT_EQ(number_at("positions", 3 * i + k, 0.0f),
                static_cast<float>(shape.mesh.vertices[i][axis]));
      EXPECT_EQ(number_at("normals", 3 * i + k, 0.0f),
                static_cast<float>(shape.normals[i][axis]));
    }
  }
  ASSERT_EQ(mesh["corners"], 3 * shape.mesh.triangles.size());
  for (std::size_t i = 0; i < shape.mesh.triangles.size(); ++i)
    EXPECT_EQ(number_at("triangles", 3 * i + 2, 0u), shape.mesh.triangles[i][2]);
}

}  // namespace
}  // namespace delos::session

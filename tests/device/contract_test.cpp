// What every device owes the kernel, on all devices of the build and of the plugin
// folders.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <cctype>
#include <cmath>
#include <numbers>
#include <optional>
#include <random>
#include <set>
#include <sstream>
#include <thread>

#include "device/devices.h"
#include "support/heap_count.h"

namespace delos::test {
namespace {

struct Case {
  std::string id;
  std::string yaml;
};

void PrintTo(const Case& c, std::ostream* os) { *os << c.id << " " << c.yaml; }

std::vector<Case> cases() {
  std::vector<Case> all;
  for (const std::string& id : all_ids()) {
    for (const std::string& yaml : examples(id)) all.push_back({id, yaml});
  }
  return all;
}

/// The columns of H before those of the device's own states.
int span_columns(const Device& device) {
  switch (device.span()) {
    case Span::point:
      return 3;
    case Span::pose:
      return 6;
    case Span::motion:
      return 18;
    case Span::state:
      return device.state_size();
  }
  return 0;
}

int columns(const Device& device) {
  return span_columns(device) + static_cast<int>(device.states().size());
}

/// A target, and the view that looks at it.
struct Seen {
  int view = 0;
  Target target;
};

/// A direction in a cone, or any where the cone is wide.
Eigen::Vector3d direction(const ViewCone& cone, std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform(0, 1);
  const Eigen::Vector3d any =
      Eigen::Vector3d(normal(random), normal(random), normal(random)).normalized();
  if (cone.half_angle >= 1) return any;
  const double angle = cone.half_angle * std::sqrt(uniform(random));
  const Eigen::Vector3d aside = cone.axis.cross(any).normalized();
  return std::cos(angle) * cone.axis + std::sin(angle) * aside;
}

/// Targets in the cones of all views in turn, 5 cm to 50 m away, turned, moving, off
/// the linearisation and facing the device more or less.
std::vector<Seen> cloud(const Device& device, int size) {
  std::mt19937_64 random(20240607);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> decades(std::log(0.05), std::log(50));
  const auto vector = [&](int n) -> Eigen::VectorXd {
    return Eigen::VectorXd::NullaryExpr(n, [&] { return normal(random); });
  };
  std::vector<Seen> targets(size);
  for (int i = 0; i < size; ++i) {
    const int view = i % device.views();
    const ViewCone cone = device.view_cone(view);
    targets[static_cast<std::size_t>(i)].view = view;
    Target& t = targets[static_cast<std::size_t>(i)].target;
    const Eigen::Vector3d way = direction(cone, random);
    t.p_ST = cone.apex + way * std::exp(decades(random));
    t.n_ST = (-way + 0.5 * vector(3)).normalized();
    t.R_ST = Eigen::Quaterniond(Eigen::Vector4d(vector(4).normalized())).matrix();
    t.velocity = vector(6);
    t.acceleration = vector(6);
    t.state = vector(device.state_size());
    t.own = vector(static_cast<int>(device.states().size()));
  }
  return targets;
}

/// The target with column `c` of the Jacobian's variables moved by h.
Seen moved(Seen seen, const Device& device, int c, double h) {
  Target& t = seen.target;
  if (c >= span_columns(device)) {
    t.own(c - span_columns(device)) += h;
  } else if (device.span() == Span::state) {
    t.state(c) += h;
  } else if (c < 3) {
    t.p_ST(c) += h;
  } else if (c < 6) {
    t.R_ST = Eigen::AngleAxisd(h, Eigen::Vector3d::Unit(c - 3)) * t.R_ST;
  } else if (c < 12) {
    t.velocity(c - 6) += h;
  } else {
    t.acceleration(c - 12) += h;
  }
  return seen;
}

bool observe(const Device& device, const Seen& at, Observation& out) {
  return device.observe_view(at.view, at.target, out);
}

/// All numbers of an answer in one row, nothing where the target isn't seen.
using Answer = std::optional<Eigen::VectorXd>;

Answer answer(const Device& device, const Seen& target, Observation& out) {
  if (!observe(device, target, out)) return {};
  Eigen::VectorXd all(out.z.size() + out.H.size() + out.R.size());
  all << out.z, out.H.reshaped(), out.R.reshaped();
  return all;
}

class DeviceContract : public testing::TestWithParam<Case> {
 protected:
  void SetUp() override {
    info_ = plugin(GetParam().id);
    ASSERT_TRUE(info_);
    device_ = device(GetParam().id, GetParam().yaml);
  }
  const PluginInfo* info_ = nullptr;
  std::shared_ptr<const Device> device_;
};

TEST_P(DeviceContract, TableIsSane) {
  std::set<std::string> names;
  for (std::uint32_t i = 0; i < info_->n_params; ++i) {
    const ParamSpec& s = info_->params[i];
    SCOPED_TRACE(s.name);
    EXPECT_TRUE(names.insert(s.name).second) << "two parameters of one name";
    EXPECT_TRUE(std::isalpha(static_cast<unsigned char>(s.name[0])));
    EXPECT_STRNE(s.unit, "");
    EXPECT_STRNE(s.help, "");
    EXPECT_LT(s.lower, s.upper);
    EXPECT_TRUE(s.scale == ParamScale::linear || s.lower > 0) << "log needs lower > 0";
    EXPECT_EQ(s.choices != nullptr, s.kind == ParamKind::choice);
    if (s.kind == ParamKind::number) {
      EXPECT_FALSE(s.text) << "the default of a number is `initial`";
      EXPECT_FALSE(s.initial < s.lower || s.initial > s.upper) << s.initial;
    } else {
      EXPECT_TRUE(std::isnan(s.initial)) << "only a number's default is `initial`";
    }
    if (s.kind == ParamKind::choice && s.text) {
      std::istringstream words(s.choices);
      std::set<std::string> choices;
      for (std::string word; std::getline(words, word, '|');) choices.insert(word);
      EXPECT_TRUE(choices.contains(s.text)) << s.text << " isn't in " << s.choices;
    }
  }
  EXPECT_STRNE(info_->summary, "");
  EXPECT_EQ(GetParam().id, info_->id);
}

TEST_P(DeviceContract, SizesAreConsistentAndSomethingIsSeen) {
  if (device_->span() == Span::state) {
    ASSERT_GE(device_->state_size(), 1);
    ASSERT_LE(device_->state_size(), kMaxState);
  } else {
    ASSERT_EQ(device_->state_size(), 0);
  }
  std::set<std::string> names;
  for (const OwnState& state : device_->states()) {
    EXPECT_TRUE(names.insert(state.name).second) << "two states of one name";
    EXPECT_NE(state.unit, "");
    EXPECT_GT(state.time_constant, 0);
    EXPECT_GE(state.density, 0);
  }
  int seen = 0;
  for (const Seen& t : cloud(*device_, 4000)) {
    Observation out;
    if (!observe(*device_, t, out)) continue;
    ++seen;
    ASSERT_GE(out.z.size(), 1);
    ASSERT_EQ(out.H.rows(), out.z.size());
    ASSERT_EQ(out.H.cols(), columns(*device_));
    ASSERT_EQ(out.R.rows(), out.z.size());
    ASSERT_EQ(out.R.cols(), out.z.size());
    ASSERT_TRUE(out.z.allFinite() && out.H.allFinite() && out.R.allFinite());
  }
  // Fewer, and the other tests would hold of nothing.
  EXPECT_GE(seen, 50);
}

TEST_P(DeviceContract, JacobianMatchesCentralDifferences) {
  for (const Seen& t : cloud(*device_, 4000)) {
    Observation here, plus, minus;
    if (!observe(*device_, t, here)) continue;
    for (int c = 0; c < columns(*device_); ++c) {
      // Error h²z‴/6 + ε z/h, least about here for readings that vary over the range.
      const double h = 1e-5 * (c < 3 ? t.target.p_ST.norm() : 1);
      if (!observe(*device_, moved(t, *device_, c, h), plus)) continue;
      if (!observe(*device_, moved(t, *device_, c, -h), minus)) continue;
      const Eigen::VectorXd slope = (plus.z - minus.z) / (2 * h);
      ASSERT_LT((slope - here.H.col(c)).norm(), 1e-6 * (1e-3 + here.H.norm()))
          << "column " << c << " at " << t.target.p_ST.transpose() << ": H says "
          << here.H.col(c).transpose() << ", differences " << slope.transpose();
    }
  }
}

TEST_P(DeviceContract, NoiseIsSymmetricAndNotNegative) {
  for (const Seen& t : cloud(*device_, 4000)) {
    Observation out;
    if (!observe(*device_, t, out)) continue;
    ASSERT_EQ(out.R, out.R.transpose());
    const Eigen::VectorXd values =
        Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(out.R).eigenvalues();
    ASSERT_GE(values(0), -1e-14 * values.cwiseAbs().maxCoeff());
  }
}

// What points have in common is less than the noise of each.
TEST_P(DeviceContract, SharedNoiseIsAPartOfTheNoise) {
  const Eigen::Vector3d shared = device_->shared_variance();
  if (shared.isZero(0)) return;
  ASSERT_EQ(device_->span(), Span::point);
  for (const Seen& t : cloud(*device_, 4000)) {
    Observation out;
    if (!observe(*device_, t, out)) continue;
    ASSERT_LE(out.z.size(), 3);
    ASSERT_TRUE(out.R.isDiagonal(0));
    for (Eigen::Index r = 0; r < out.z.size(); ++r) {
      ASSERT_GE(shared(r), 0);
      ASSERT_LT(shared(r), out.R(r, r));
    }
  }
}

TEST_P(DeviceContract, ForgetsWhatOutHeldBefore) {
  Observation used;
  for (const Seen& t : cloud(*device_, 1000)) {
    Observation fresh;
    const double nan = std::nan("");
    used.z.setConstant(kMaxRows, nan);
    used.H.setConstant(kMaxRows, kMaxState, nan);
    used.R.setConstant(kMaxRows, kMaxRows, nan);
    ASSERT_EQ(answer(*device_, t, fresh), answer(*device_, t, used));
  }
}

// What a view sees lies in its cone, and observe() sees what any view sees.
TEST_P(DeviceContract, ViewsSeeInTheirConesOnly) {
  ASSERT_GE(device_->views(), 1);
  std::mt19937_64 random(9);
  std::normal_distribution<double> normal;
  std::set<std::string> names;
  for (int view = 0; view < device_->views(); ++view) {
    EXPECT_TRUE(names.insert(device_->view_name(view)).second);
    const ViewCone cone = device_->view_cone(view);
    EXPECT_NEAR(cone.axis.norm(), 1, 1e-12);
    EXPECT_GT(cone.half_angle, 0);
  }
  for (const Seen& center : cloud(*device_, 4000)) {
    Seen at = center;
    const ViewCone cone = device_->view_cone(at.view);
    // As often outside of the cone as inside.
    const double off = 0.5 * std::min(cone.half_angle, 1.0) * at.target.p_ST.norm();
    at.target.p_ST +=
        off * Eigen::Vector3d(normal(random), normal(random), normal(random));
    Observation out;
    if (!observe(*device_, at, out)) continue;
    EXPECT_TRUE(device_->observe(at.target, out));
    const Eigen::Vector3d way = at.target.p_ST - cone.apex;
    EXPECT_LE(way.norm(), cone.range);
    if (cone.half_angle < std::numbers::pi) {
      EXPECT_LE(std::atan2(cone.axis.cross(way).norm(), cone.axis.dot(way)),
                cone.half_angle);
    }
  }
}

// The faster entry, where there is one, against observe() of each point.
TEST_P(DeviceContract, LanesAgreeWithSinglePoints) {
  const std::vector<Seen> targets = cloud(*device_, 4000);
  const double nan = std::nan("");
  for (std::size_t first = 0; first < targets.size(); first += kLanes) {
    PointLanes points;
    points.count =
        static_cast<int>(std::min<std::size_t>(kLanes, targets.size() - first));
    for (int i = 0; i < 3; ++i) {
      std::fill_n(points.p[i], kLanes, nan);
      for (int l = 0; l < points.count; ++l) {
        points.p[i][l] = targets[first + static_cast<std::size_t>(l)].target.p_ST(i);
      }
    }
    RowLanes rows;
    if (!device_->observe_lanes(points, rows)) return;
    ASSERT_EQ(device_->span(), Span::point);
    ASSERT_GE(rows.rows, 1);
    ASSERT_LE(rows.rows, kMaxLaneRows);
    for (int l = 0; l < points.count; ++l) {
      Observation one;
      const Target& target = targets[first + static_cast<std::size_t>(l)].target;
      ASSERT_EQ(device_->observe(target, one), rows.seen[l] != 0);
      if (!rows.seen[l]) continue;
      ASSERT_EQ(one.z.size(), rows.rows);
      EXPECT_TRUE(one.R.isDiagonal(0));
      for (int r = 0; r < rows.rows; ++r) {
        EXPECT_NEAR(rows.variance[r][l], one.R(r, r), 1e-14 * one.R(r, r));
        for (int i = 0; i < 3; ++i) {
          EXPECT_NEAR(rows.H[r][i][l], one.H(r, i), 1e-14 * one.H.row(r).norm());
        }
      }
    }
  }
}

// The same of beacons through each view.
TEST_P(DeviceContract, LanesOfViewsAgreeWithSingleBeacons) {
  const std::vector<Seen> targets = cloud(*device_, 4000);
  const auto views = static_cast<std::size_t>(device_->views());
  const double nan = std::nan("");
  int seen = 0;
  for (std::size_t view = 0; view < views; ++view) {
    BeaconLanes beacons;
    for (int i = 0; i < 3; ++i) {
      std::fill_n(beacons.p[i], kLanes, nan);
      std::fill_n(beacons.n[i], kLanes, nan);
    }
    // As many as a view may have, and every third of those all around.
    beacons.count = static_cast<int>(std::min<std::size_t>(50, 4000 / views));
    const auto target = [&](int l) {
      Target t = targets[view + static_cast<std::size_t>(l) * views].target;
      if (l % 3 == 0) t.n_ST.setZero();
      return t;
    };
    for (int l = 0; l < beacons.count; ++l) {
      for (int i = 0; i < 3; ++i) {
        beacons.p[i][l] = target(l).p_ST(i);
        beacons.n[i][l] = target(l).n_ST(i);
      }
    }
    RowLanes rows;
    const auto number = static_cast<int>(view);
    if (!device_->observe_view_lanes(number, beacons, rows)) return;
    ASSERT_EQ(device_->span(), Span::point);
    ASSERT_GE(rows.rows, 1);
    ASSERT_LE(rows.rows, kMaxLaneRows);
    for (int l = 0; l < beacons.count; ++l) {
      Observation one;
      ASSERT_EQ(device_->observe_view(number, target(l), one), rows.seen[l] != 0);
      if (rows.seen[l] == 0) continue;
      ++seen;
      ASSERT_EQ(one.z.size(), rows.rows);
      EXPECT_TRUE(one.R.isDiagonal(0));
      for (int r = 0; r < rows.rows; ++r) {
        EXPECT_NEAR(rows.variance[r][l], one.R(r, r), 1e-14 * one.R(r, r));
        for (int i = 0; i < 3; ++i) {
          EXPECT_NEAR(rows.H[r][i][l], one.H(r, i), 1e-14 * one.H.row(r).norm());
        }
      }
    }
  }
  EXPECT_GT(seen, 50);
}

// In view, what goes on smoothly is what is observed; the margin says which that is.
TEST_P(DeviceContract, SmoothRowsAgreeWithSinglePoints) {
  SmoothRows rows;
  if (!device_->observe_smoothly({0.1, 0.2, 1}, rows)) return;
  ASSERT_EQ(device_->span(), Span::point);
  for (const Seen& at : cloud(*device_, 4000)) {
    const Target& target = at.target;
    ASSERT_TRUE(device_->observe_smoothly(target.p_ST, rows));
    Observation one;
    const bool seen = device_->observe(target, one);
    if (std::abs(rows.margin) > 1e-12) {
      ASSERT_EQ(seen, rows.margin > 0);
    }
    ASSERT_TRUE(rows.H.topRows(rows.rows).allFinite());
    ASSERT_TRUE((rows.variance.head(rows.rows).array() > 0).all());
    if (!seen) continue;
    ASSERT_EQ(one.z.size(), rows.rows);
    EXPECT_TRUE(one.R.isDiagonal(0));
    for (int r = 0; r < rows.rows; ++r) {
      EXPECT_NEAR(rows.variance(r), one.R(r, r), 1e-14 * one.R(r, r));
      for (int i = 0; i < 3; ++i)
        EXPECT_NEAR(rows.H(r, i), one.H(r, i), 1e-14 * one.H.row(r).norm());
    }
  }
}

// Central differences of what goes on smoothly, in view and out of it. A margin has
// kinks where another edge becomes the nearest: few points of the cloud are there.
TEST_P(DeviceContract, SmoothSlopesMatchCentralDifferences) {
  SmoothRows here, to, from;
  if (!device_->observe_smoothly({0.1, 0.2, 1}, here)) return;
  int kinks = 0, points = 0;
  for (const Seen& at : cloud(*device_, 1000)) {
    const Eigen::Vector3d p = at.target.p_ST;
    ASSERT_TRUE(device_->observe_smoothly(p, here));
    const double h = 1e-5 * p.norm();
    for (int k = 0; k < 3; ++k, ++points) {
      device_->observe_smoothly(p + h * Eigen::Vector3d::Unit(k), to);
      device_->observe_smoothly(p - h * Eigen::Vector3d::Unit(k), from);
      const auto slope = [&](const auto& a, const auto& b) {
        return ((a - b) / (2 * h)).eval();
      };
      const double margin_slope = (to.margin - from.margin) / (2 * h);
      if (std::abs(here.margin_slope(k) - margin_slope) >
          1e-6 * (std::abs(margin_slope) + here.margin_slope.norm()))
        ++kinks;
      const auto top = [&](const auto& m) { return m.topRows(here.rows).eval(); };
      EXPECT_LT((top(here.H_slope[k]) - slope(top(to.H), top(from.H))).norm(),
                1e-6 * top(here.H).norm() / p.norm());
      EXPECT_LT((top(here.variance_slope).col(k) -
                 slope(top(to.variance), top(from.variance)))
                    .norm(),
                1e-6 * top(here.variance).norm() / p.norm());
    }
  }
  EXPECT_LT(kinks, points / 200);
}

// What a device says of a ball holds at points of it.
TEST_P(DeviceContract, ViewsOfBallsHoldForTheirPoints) {
  if (device_->span() != Span::point) return;
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform(0, 1);
  int decided = 0;
  for (const Seen& seen : cloud(*device_, 1000)) {
    const Target& center = seen.target;
    const double radius = 0.3 * uniform(random) * center.p_ST.norm();
    const View view = device_->view_of_ball(center.p_ST, radius);
    if (view == View::unknown || view == View::crossing) continue;
    ++decided;
    for (int i = 0; i < 30; ++i) {
      const Eigen::Vector3d way(normal(random), normal(random), normal(random));
      Target at = center;
      at.p_ST += radius * way.normalized();
      Observation out;
      ASSERT_EQ(device_->observe(at, out), view == View::inside) << at.p_ST.transpose();
    }
  }
  if (device_->view_of_ball({0, 0, 1}, 0) != View::unknown) {
    EXPECT_GT(decided, 100);
  }
}

TEST_P(DeviceContract, TakesNothingFromTheHeap) {
  const std::vector<Seen> targets = cloud(*device_, 1000);
  Observation out;
  int seen = 0;
  EXPECT_EQ(allocations([&] {
              for (const Seen& t : targets) seen += observe(*device_, t, out);
            }),
            0u);
  EXPECT_GT(seen, 0);
}

TEST_P(DeviceContract, AnswersTheSameFromSeveralThreads) {
  const std::vector<Seen> targets = cloud(*device_, 1000);
  const auto answers = [&] {
    std::vector<Answer> all;
    Observation out;
    for (const Seen& t : targets) all.push_back(answer(*device_, t, out));
    return all;
  };
  const std::vector<Answer> alone = answers();
  std::vector<std::vector<Answer>> together(4);
  {
    std::vector<std::jthread> threads;
    for (auto& mine : together) threads.emplace_back([&] { mine = answers(); });
  }
  for (const auto& mine : together) EXPECT_TRUE(mine == alone);
}

INSTANTIATE_TEST_SUITE_P(Devices, DeviceContract, testing::ValuesIn(cases()),
                         [](const auto& i) {
                           return i.param.id + "_" + std::to_string(i.index);
                         });

TEST(HeapCount, SeesThisProgramAndItsLibraries) {
  void* volatile kept = nullptr;  // or the compiler drops the pair
  EXPECT_EQ(allocations([&] {
              kept = std::malloc(100);
              std::free(kept);
            }),
            1u);
  // Paths in a vector, made within the kernel's library.
  EXPECT_GT(allocations([] { (void)plugin_folders(); }), 0u);
}

}  // namespace
}  // namespace delos::test

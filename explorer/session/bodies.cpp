#include "session/bodies.h"

#include <algorithm>

#include "delos/text/units.h"
#include "session/description.h"
#include "session/form_edits.h"
#include "session/refusal.h"
#include "session/scene_changes.h"
#include "session/value_tree.h"

namespace delos::session {
namespace {

/// A body of a scene, with where it stands.
struct BodyAt {
  Body* body;
  Placement* placement;
};

template <class Entry>
std::optional<BodyAt> find_body(std::vector<Entry>& entries, const std::string& name) {
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const std::string& own = entries[i].name;
    if ((own.empty() ? std::to_string(i) : own) == name)
      return BodyAt{&entries[i].body, &entries[i].placement};
  }
  return std::nullopt;
}

BodyAt body_at(Scene& scene, const std::string& path) {
  const std::vector<std::string> parts = segments_of(path);
  std::optional<BodyAt> found;
  if (parts.size() == 2 && parts[0] == "occluders")
    found = find_body(scene.occluders, parts[1]);
  if (parts.size() == 2 && parts[0] == "regions")
    found = find_body(scene.regions, parts[1]);
  if (!found) throw Refusal(Blame::question, "there is no body " + path);
  return *found;
}

Eigen::Vector3d middle_of(const BodyAt& at) {
  Eigen::AlignedBox3d bounds;
  for (const Eigen::Vector3d& v :
       transformed(body_mesh(*at.body), pose_of(*at.placement)).vertices)
    bounds.extend(v);
  return bounds.center();
}

/// A box that has no place but its corners is moved by them.
void move_by(const BodyAt& at, const Eigen::Vector3d& step) {
  auto* box = std::get_if<BoxShape>(at.body);
  if (box && *at.placement == Placement{}) {
    box->min += step;
    box->max += step;
    return;
  }
  at.placement->at += step;
  if (auto* aim = std::get_if<Aim>(&at.placement->facing)) aim->at += step;
}

/// What a hand has drawn, to a tenth of a millimetre.
Eigen::Vector3d tidy(const Eigen::Vector3d& v) {
  return (v * 1e4).array().round() / 1e4;
}

Json corner(const Eigen::Vector3d& v) {
  return {shortest(v.x()), shortest(v.y()), shortest(v.z())};
}

std::vector<Override> one_more_set(const Scene& scene, const Eigen::AlignedBox3d& box) {
  constexpr double kAlong = 12;  // samples of the longest side
  const double step =
      tidy(Eigen::Vector3d::Constant(box.sizes().maxCoeff() / kAlong)).x();
  Json sets = value_tree(scene)["sample"];
  if (!sets.is_array()) sets = Json::array({sets});
  std::vector<std::string> names;
  for (Json& set : sets) {
    if (!set.contains("name")) {
      Json named{{"name", free_among(names, "all")}};
      named.update(set);
      set = std::move(named);
    }
    names.push_back(set["name"]);
  }
  sets.push_back({{"name", free_among(names, "part")},
                  {"volume",
                   {{"min", corner(box.min())},
                    {"max", corner(box.max())},
                    {"step", shortest(step)}}}});
  return edits(scene, {{"sample", sets.dump()}});
}

}  // namespace

std::vector<Override> shaping(const Scene& scene, const std::string& path,
                              const std::optional<Eigen::Vector3d>& p,
                              const std::optional<Eigen::Vector3d>& size) {
  Scene changed = scene;
  const BodyAt at = body_at(changed, path);
  if (size) {
    auto* box = std::get_if<BoxShape>(at.body);
    if (!box)
      throw Refusal(Blame::question, path + " is no box: change its own numbers");
    if (!(size->minCoeff() > 0))
      throw Refusal(Blame::question, path + ": a box has three sides above 0");
    const Eigen::Vector3d c = (box->min + box->max) / 2;
    box->min = c - *size / 2;
    box->max = c + *size / 2;
  }
  if (p) move_by(at, *p - middle_of(at));
  return changes_between(scene, changed);
}

std::vector<Override> painting(const LoadedScene& loaded, const std::string& what,
                               Eigen::AlignedBox3d box) {
  const Scene& scene = loaded.scene;
  const Eigen::AlignedBox3d samples = sample_box(scene);
  if (box.isEmpty() || box.sizes().x() < 1e-3 || box.sizes().y() < 1e-3)
    throw Refusal(Blame::question, "draw a rectangle of a millimetre or more");
  if (box.sizes().z() < 1e-3) {
    const double height = samples.sizes().z();
    box.max().z() = box.min().z() + (height > 1e-3 ? height : box.sizes().maxCoeff());
  }
  box = {tidy(box.min()), tidy(box.max())};
  const Json shape{{"box", {{"min", corner(box.min())}, {"max", corner(box.max())}}}};
  std::vector<std::string> names;
  if (what == "region") {
    for (const RegionEntry& region : scene.regions) names.push_back(region.name);
    return edits(scene, {{"regions." + free_among(names, "region"), shape.dump()}});
  }
  if (what == "occluder") {
    for (const OccluderEntry& body : scene.occluders) names.push_back(body.name);
    Json entry{{"name", free_among(names, "body")}};
    entry.update(shape);
    return edits(scene, {{"occluders.+", entry.dump()}});
  }
  if (what == "samples") return one_more_set(scene, box);
  throw Refusal(Blame::question,
                "'" + what + "': a box can be a region, an occluder or samples");
}

}  // namespace delos::session

#include "server/verbs.h"

#include <cmath>

#include "delos/model/symmetric.h"
#include "session/description.h"
#include "session/device_worth.h"
#include "session/drawn_field.h"
#include "session/placing.h"
#include "session/point_answer.h"

namespace delos::server {
namespace {

using session::LoadedScene;

/// Samples that devices are weighed on.
constexpr std::size_t kWorthSamples = 4000;

const Json& member(const Json& request, const char* key) {
  const auto found = request.find(key);
  if (found == request.end()) throw BadRequest(std::string("'") + key + "' is missing");
  return *found;
}

/// @param n how many
Eigen::VectorXd numbers_at(const Json& list, const char* key, Eigen::Index n) {
  const BadRequest wrong("'" + std::string(key) + "' must be " + std::to_string(n) +
                         " finite numbers");
  if (!list.is_array() || static_cast<Eigen::Index>(list.size()) != n) throw wrong;
  Eigen::VectorXd v(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const Json& item = list[static_cast<std::size_t>(i)];
    if (!item.is_number()) throw wrong;
    v(i) = item.get<double>();
    if (!std::isfinite(v(i))) throw wrong;
  }
  return v;
}

std::string gesture_of(const Json& request) {
  return request.contains("gesture") ? text_at(request, "gesture") : "";
}

/// Take a change over, and describe what came of it.
Reply changed(const Work& work, std::vector<Override> changes) {
  if (changes.empty()) throw BadRequest("there is nothing to change");
  Diagnostics findings;
  if (!work.visitor.design.change(std::move(changes), gesture_of(work.request),
                                  work.plugins, findings)) {
    return refusal(Status::unprocessable,
                   findings.empty() ? "" : findings.front().message, findings);
  }
  ++work.visitor.revision;
  return json_reply(described(work.visitor, work.plugins));
}

Reply describe(const Work& work) {
  return json_reply(described(work.visitor, work.plugins));
}

Reply around(const Work& work) {
  return json_reply(session::surroundings(work.visitor.design));
}

Reply change(const Work& work) {
  const Json& set = member(work.request, "set");
  if (!set.is_array()) throw BadRequest("'set' must be a list of {path, value}");
  std::vector<Override> changes;
  for (const Json& one : set) {
    if (!one.is_object()) throw BadRequest("'set' must be a list of {path, value}");
    changes.push_back({text_at(one, "path"), text_at(one, "value")});
  }
  return changed(work, std::move(changes));
}

Reply place(const Work& work) {
  const Json& request = work.request;
  std::optional<Eigen::Vector3d> p;
  std::optional<Eigen::Matrix3d> R;
  if (request.contains("p")) p = numbers_at(request["p"], "p", 3);
  if (request.contains("q")) {
    const Eigen::Vector4d q = numbers_at(request["q"], "q", 4);
    if (q.norm() < 1e-6) throw BadRequest("'q' has no length");
    R = Eigen::Quaterniond(q(0), q(1), q(2), q(3)).normalized().toRotationMatrix();
  }
  auto changes = session::placing(work.visitor.design.loaded().scene,
                                  text_at(request, "device"), p, R);
  if (const auto* why = std::get_if<std::string>(&changes))
    return refusal(Status::unprocessable, *why);
  return changed(work, std::get<std::vector<Override>>(std::move(changes)));
}

/// After undo and redo: where there was nothing to do, all stays.
Reply stepped(const Work& work, bool done) {
  if (done) ++work.visitor.revision;
  return describe(work);
}

Reply undo(const Work& work) {
  return stepped(work, work.visitor.design.undo(work.plugins));
}

Reply redo(const Work& work) {
  return stepped(work, work.visitor.design.redo(work.plugins));
}

Reply superseded() {
  return refusal(Status::conflict, "a newer request took its place");
}

FieldOptions options_of(const Work& work) {
  FieldOptions options;
  options.threads = work.threads;
  options.cancel = work.stop;
  return options;
}

Reply field(const Work& work) {
  std::size_t most = 0;
  if (work.request.contains("most")) {
    const Json& json = work.request["most"];
    if (!json.is_number_unsigned())
      throw BadRequest("'most' must be a whole number of samples, 0 for all");
    most = json.get<std::size_t>();
  }
  const session::DrawnField drawn =
      session::draw_field(work.visitor.design.loaded(), most, options_of(work));
  if (*work.stop) return superseded();
  return {Status::ok, "application/octet-stream",
          session::packed(drawn, work.visitor.revision)};
}

/// σ and directions of the position's covariance: {sigma: [3], axes: rows of unit
/// vectors}; null where a direction of the position is lost, or there is no position.
Json ellipsoid(const LoadedScene& loaded, const session::PointAnswer& answer) {
  const FusedState& state = answer.report.state;
  const StateMatrix& P =
      loaded.system.covariance == CovarianceKind::prior ? state.prior : state.posterior;
  const bool placed = loaded.system.motion.layout.pose != PoseState::orientation;
  if (!placed || state.status != RiccatiStatus::converged || P.rows() < 3) return {};
  const SymmetricEigen axes = symmetric_eigen(P.topLeftCorner(3, 3));
  return {{"sigma", session::numbers(axes.values.cwiseMax(0).cwiseSqrt())},
          {"axes", session::rows(axes.vectors.transpose())}};
}

Reply point(const Work& work) {
  const Eigen::Vector3d at = numbers_at(member(work.request, "at"), "at", 3);
  const LoadedScene& loaded = work.visitor.design.loaded();
  const session::PointAnswer answer = session::answer_point(
      loaded, at, loaded.scene.orientations.rpy.front(), Solver::automatic);
  if (*work.stop) return superseded();
  return json_reply({{"revision", work.visitor.revision},
                     {"point", session::point_json(answer, loaded)},
                     {"words", session::lost_words(answer, loaded)},
                     {"ellipsoid", ellipsoid(loaded, answer)}});
}

Reply worth(const Work& work) {
  const LoadedScene& loaded = work.visitor.design.loaded();
  const Samples samples =
      make_samples(session::coarser(loaded.scene.samples, kWorthSamples));
  const auto all = session::device_worth(loaded, samples, options_of(work));
  if (*work.stop) return superseded();
  Json json = session::worth_json(all, samples);
  json["revision"] = work.visitor.revision;
  return json_reply(json);
}

Reply text(const Work& work) {
  return {Status::ok, "application/yaml", work.visitor.design.text()};
}

constexpr Verb kVerbs[] = {
    {"describe", describe, false}, {"around", around, false}, {"change", change, true},
    {"place", place, true},        {"undo", undo, true},      {"redo", redo, true},
    {"field", field, false},       {"point", point, false},   {"worth", worth, false},
    {"text", text, false},
};

}  // namespace

const Verb* find_verb(const std::string& name) {
  for (const Verb& verb : kVerbs)
    if (name == verb.name) return &verb;
  return nullptr;
}

Json described(Visitor& visitor, PluginRegistry& plugins) {
  return session::description(visitor.design, visitor.revision, plugins);
}

std::string text_at(const Json& request, const char* key) {
  const Json& json = member(request, key);
  if (!json.is_string()) throw BadRequest(std::string("'") + key + "' must be a text");
  return json.get<std::string>();
}

}  // namespace delos::server

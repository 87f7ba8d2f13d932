#include "session/point_answer.h"

#include <limits>

#include "delos/scene/definition.h"
#include "session/lost_directions.h"

namespace delos::session {
namespace {

/// What one more device would do; null: none of those tried would.
Json mending_json(const Mending& mending, const Metric& metric) {
  if (!mending.best) return {};
  return {{"like", mending.best->like},           {"type", mending.best->type},
          {"at", numbers(mending.best->at)},      {"metric", metric.name},
          {"value", number(mending.best->value)}, {"unit", metric.unit}};
}

}  // namespace

PointAnswer answer_point(const LoadedScene& loaded, const Eigen::Vector3d& at,
                         const Eigen::Vector3d& rpy, Solver solver) {
  PointAnswer answer{evaluate_point(loaded.system, {rotation_from_rpy(rpy), at},
                                    loaded.metric, solver),
                     rpy,
                     std::nullopt,
                     {}};
  answer.mending =
      mend_by_one_device(loaded.system, answer.report, rpy, loaded.metric, solver);
  answer.sightings = seen_beacons(loaded.system, answer.report.pose);
  return answer;
}

StateMatrix with_infinities(StateMatrix P, const StateMatrix& unobservable) {
  if (unobservable.cols() == 0) return P;
  for (Eigen::Index i = 0; i < unobservable.rows(); ++i) {
    if (unobservable.row(i).cwiseAbs().maxCoeff() < 1e-9) continue;
    P.row(i).setConstant(std::numeric_limits<double>::infinity());
    P.col(i).setConstant(std::numeric_limits<double>::infinity());
  }
  return P;
}

std::vector<std::string> lost_words(const PointAnswer& answer,
                                    const LoadedScene& loaded) {
  std::vector<std::string> lines = lost_directions(loaded.system, answer.report);
  if (answer.mending) lines.push_back(words_of(*answer.mending, loaded.metric));
  return lines;
}

Json point_json(const PointAnswer& answer, const LoadedScene& loaded) {
  const PointReport& report = answer.report;
  const FusedState& state = report.state;
  const auto covariance = [&](const StateMatrix& P) {
    return rows(with_infinities(P, state.unobservable));
  };
  Json json;
  json["scene"] = loaded.scene.name;
  json["at"] = numbers(report.pose.p);
  json["rpy"] = numbers(answer.rpy);
  json["fusion"] = to_string(loaded.system.fusion);
  if (loaded.system.lag > 0) json["lag"] = loaded.system.lag;
  json["solver"] = to_string(report.solver);
  json["covariance_of"] = to_string(state.of);
  json["state"] = loaded.system.motion.layout.names();
  json["units"] = loaded.system.motion.layout.units();
  json["inside"] = report.inside;
  json["observable"] = state.status == RiccatiStatus::converged;
  json["unobservable_directions"] = rows(state.unobservable.transpose());
  if (answer.mending)
    json["one_more_device"] = mending_json(*answer.mending, loaded.metric);
  json["metrics"] = Json::object();
  for (std::size_t m = 0; m < report.metrics.size(); ++m) {
    Json& metric = json["metrics"][report.metrics[m].metric.name];
    metric = {{"value", number(report.metrics[m].value)},
              {"unit", report.metrics[m].metric.unit}};
    if (!report.budget) continue;
    metric["scatter"] = number(report.budget->scatter[m]);
    metric["bias"] = number(report.budget->bias[m]);
    metric["total"] = number(report.budget->total[m]);
  }
  if (report.budget) {
    json["error"] = to_string(loaded.system.error);
    const auto& plain = report.budget->plain;
    json["plain_least_squares"] = plain ? Json({{"metric", loaded.metric.name},
                                                {"scatter", number(plain->scatter)},
                                                {"bias", number(plain->bias)},
                                                {"total", number(plain->total)},
                                                {"unit", loaded.metric.unit}})
                                        : Json();
  }
  for (const CommonErrorShare& common :
       report.budget ? report.budget->common : std::vector<CommonErrorShare>{})
    json["common_errors"].push_back(
        {{"name", common.name}, {"calibration", number(common.calibration)}});
  // Before a single reading nothing is known.
  json["P_prior"] = loaded.system.covariance == CovarianceKind::single
                        ? Json()
                        : covariance(state.prior);
  json["P_posterior"] = covariance(state.posterior);
  if (state.worst_prior.size() > 0) {
    json["P_worst_prior"] = covariance(state.worst_prior);
    json["P_best_posterior"] = covariance(state.best_posterior);
  }
  json["residual"] = number(report.residual);
  json["devices"] = Json::array();
  for (const DeviceShare& d : report.devices) {
    json["devices"].push_back({{"name", d.name},
                               {"type", d.type},
                               {"visible", d.visible},
                               {"share", number(d.share)}});
    if (report.budget) json["devices"].back()["calibration"] = number(d.calibration);
  }
  if (answer.sightings.empty()) return json;
  json["sightings"] = Json::array();
  for (const SeenBeacon& s : answer.sightings) {
    json["sightings"].push_back({{"device", s.device},
                                 {"view", s.view},
                                 {"beacon", numbers(s.at)},
                                 {"distance", number(s.distance)},
                                 {"share", number(s.share)}});
  }
  return json;
}

}  // namespace delos::session

#include <cmath>
#include <limits>

#include "delos/field/evaluate.h"
#include "delos/sampling/sets.h"
#include "measured/comparison.h"
#include "measured/curve.h"
#include "measured/predicted.h"

namespace delos::measured {

std::vector<Eigen::Vector3d> predicted_at(const System& system,
                                          const std::vector<Eigen::Vector3d>& places,
                                          const Eigen::Vector3d& rpy) {
  const StateLayout& layout = system.motion.layout;
  std::vector<Eigen::Vector3d> sigma(
      places.size(),
      Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN()));
  Orientations orientations;
  orientations.rpy = {rpy};
  for (int k = 0; k < layout.positions(); ++k) {
    const auto names = layout.names();
    const auto metric = std::get<Metric>(
        parse_metric("sigma_" + names[static_cast<std::size_t>(k)], layout));
    const Field field = evaluate_field(
        system, make_samples({{"", PointSampling{"", places}}}), orientations, metric);
    for (std::size_t i = 0; i < places.size(); ++i) sigma[i](k) = field.value[i];
  }
  return sigma;
}

namespace {

/// Rows of three, and what is left of NaN: an axis that a state doesn't have.
Eigen::MatrixXd rows_of(const std::vector<Eigen::Vector3d>& points) {
  Eigen::MatrixXd rows(static_cast<Eigen::Index>(points.size()), 3);
  for (std::size_t i = 0; i < points.size(); ++i)
    rows.row(static_cast<Eigen::Index>(i)) = points[i].transpose();
  return rows;
}

}  // namespace

std::variant<PosesComparison, std::string> compare_poses(
    const System& system, const std::vector<MeasuredPath>& paths, int degree,
    const Eigen::Vector3d& rpy) {
  const int axes = system.motion.layout.positions();
  if (axes == 0) return std::string("the scene's state has no position to compare");
  PosesComparison all;
  all.scatter = all.predicted = Eigen::Vector3d::Zero();
  double places = 0, seen_places = 0;
  for (const MeasuredPath& path : paths) {
    const bool known = !path.truth.empty();
    Eigen::MatrixXd rows = rows_of(path.p);
    if (known) rows -= rows_of(path.truth);
    auto fitted = fit_curve(path.t, rows, degree);
    if (const auto* problem = std::get_if<std::string>(&fitted))
      return "path '" + path.name + "' " + *problem;
    const auto& fit = std::get<CurveFit>(fitted);
    PathComparison of{path.name,       path.p.size(),           std::nullopt,
                      fit.deviation(), Eigen::Vector3d::Zero(), 0};
    const Eigen::MatrixXd where = known ? rows_of(path.truth) : fit.curve;
    std::vector<Eigen::Vector3d> at;
    for (Eigen::Index i = 0; i < where.rows(); ++i)
      at.emplace_back(where.row(i).transpose());
    const auto sigma = predicted_at(system, at, rpy);
    double seen = 0;
    for (std::size_t i = 0; i < at.size(); ++i) {
      const Eigen::Vector3d left =
          fit.scatter.row(static_cast<Eigen::Index>(i)).transpose();
      all.places.push_back({at[i], left.head(axes).norm(), sigma[i].head(axes).norm()});
      if (!std::isfinite(all.places.back().predicted)) {
        ++of.blind;
        continue;
      }
      of.predicted += sigma[i].cwiseAbs2();
      ++seen;
    }
    if (known)
      of.bias = (fit.curve.colwise().squaredNorm().transpose() /
                 static_cast<double>(fit.curve.rows()))
                    .cwiseSqrt();
    const auto count = static_cast<double>(of.places);
    all.scatter += count * of.scatter.cwiseAbs2();
    all.predicted += of.predicted;
    places += count;
    seen_places += seen;
    of.predicted = (of.predicted / seen).cwiseSqrt();
    all.paths.push_back(std::move(of));
  }
  all.scatter = (all.scatter / places).cwiseSqrt();
  all.predicted = (all.predicted / seen_places).cwiseSqrt();
  return all;
}

}  // namespace delos::measured

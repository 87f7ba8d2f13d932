// A distance, whatever measures it: radio, sound, light, a string.
//
//   z = ‖p‖ + v,   v ~ N(0, σ²),   ∂z/∂p = pᵀ/‖p‖
//
// p is the point in the device's frame, whose z axis is the middle of a cone that it
// sees. σ is one of
//
//   growing     σ² = sigma² + (growth d)²
//   expression  σ = a formula of d, metres
//   table       σ between rows [d, σ] on straight lines, beyond them as at the ends
//
// with d = ‖p‖. Sources: README.md.
#include <delos/device/faults.h>
#include <delos/device/point_device.h>
#include <delos/expression/expression.h>
#include <delos/plugin.h>

#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using delos::number;

/// σ by a formula of the distance.
/// @throws delos::Unbuildable it is none
delos::Expression formula_of(const std::string& text) {
  auto parsed = delos::parse_expression(text, {{"d"}, "", {}});
  if (const auto* problem = std::get_if<delos::ExpressionProblem>(&parsed))
    throw delos::Unbuildable(problem->sentence, "expression", problem->at);
  return std::get<delos::Expression>(parsed);
}

class Range final : public delos::PointDevice<Range, 1> {
 public:
  static constexpr delos::ParamSpec kParams[] = {
      delos::choice("noise", "growing|expression|table",
                    "Which law the standard deviation follows.")
          .initially("growing"),
      number("sigma", "m",
             "Standard deviation of a range to a point nearby, for "
             "noise: growing.")
          .initially(0.1)
          .between(1e-9, 1e6)
          .by_factors(),
      number("growth", "1",
             "Standard deviation per metre of range, whose variance "
             "comes on top.")
          .initially(0)
          .at_least(0),
      delos::text("expression",
                  "Standard deviation as a formula of the distance d, in "
                  "metres, for noise: expression.")
          .initially("0.1"),
      delos::matrix("table",
                    "Rows [distance, standard deviation], in metres, the "
                    "distances rising, for noise: table.")
          .initially("[[0, 0.1]]"),
      number("reach", "m", "Farthest point that is measured.")
          .initially(100)
          .at_least(0),
      number("cone", "rad",
             "Half-angle about the z axis in which it measures; 180 "
             "deg: all around.")
          .initially(std::numbers::pi)
          .between(1e-3, std::numbers::pi),
  };

  explicit Range(const delos::ParamValues& p)
      : constant_(p["sigma"] * p["sigma"]),
        growing_(p["growth"] * p["growth"]),
        reach_(p["reach"]),
        half_angle_(p["cone"]),
        sine_(std::sin(half_angle_)),
        cosine_(std::cos(half_angle_)) {
    if (p.choice("noise") == "expression") {
      law_ = Law::expression;
      sigma_ = formula_of(p.choice("expression"));
    }
    if (p.choice("noise") == "table") {
      law_ = Law::table;
      read_table(p.matrix("table"));
    }
  }

  template <class T>
  void read(const delos::Point<T>& p, delos::Reading<T, 1>& out) const {
    using std::min, std::sqrt;
    const T d = sqrt(squared_norm(p));
    out.z[0] = d;
    out.variance[0] = variance(d);
    out.inside = reach_ - d;
    if (half_angle_ == std::numbers::pi) return;
    // The distance to the cone's edge. On the axis ρ would have no slope.
    const T rho = sqrt(p.x * p.x + p.y * p.y + kNothing);
    out.inside = min(out.inside, p.z * sine_ - rho * cosine_);
  }

  [[nodiscard]] delos::ViewCone view_cone(int) const override {
    return {.half_angle = half_angle_ == std::numbers::pi ? 3.15 : half_angle_ + 1e-9,
            .range = reach_ * (1 + 1e-12)};
  }

 private:
  enum class Law { growing, expression, table };
  /// A straight piece of the table, from its first distance on.
  struct Piece {
    double from, sigma, slope;
  };
  static constexpr double kNothing = 1e-24;  // m²

  void read_table(const Eigen::MatrixXd& rows) {
    if (rows.cols() != 2)
      throw std::invalid_argument(
          "table must have rows [distance, standard deviation]");
    for (Eigen::Index i = 0; i < rows.rows(); ++i) {
      if (!(rows(i, 1) > 0) || !(rows(i, 0) >= 0))
        throw std::invalid_argument(
            "table must have distances of at least 0 and "
            "standard deviations above 0");
      if (i > 0 && !(rows(i, 0) > rows(i - 1, 0)))
        throw std::invalid_argument("table must have rising distances");
      if (i > 0)
        pieces_.back().slope =
            (rows(i, 1) - rows(i - 1, 1)) / (rows(i, 0) - rows(i - 1, 0));
      pieces_.push_back({rows(i, 0), rows(i, 1), 0});
    }
  }

  template <class T>
  T variance(const T& d) const {
    if (law_ == Law::growing) return constant_ + growing_ * d * d;
    T sigma;
    if (law_ == Law::expression) {
      sigma = delos::evaluate<T>(sigma_, &d);
    } else {
      const Piece* piece = pieces_.data();
      for (const Piece& next : pieces_)
        if (next.from <= delos::plain(d)) piece = &next;
      sigma = piece->sigma;
      if (delos::plain(d) >= piece->from)
        sigma = sigma + piece->slope * (d - piece->from);
    }
    return sigma * sigma;
  }

  Law law_ = Law::growing;
  double constant_;            // m²
  double growing_;             // dimensionless
  delos::Expression sigma_;    // of d, m
  std::vector<Piece> pieces_;  // one or more, of a table
  double reach_;               // m
  double half_angle_;          // rad
  double sine_, cosine_;       // of half_angle_
};

}  // namespace

DELOS_DEVICE_PLUGIN(Range, "range", "1.0.0",
                    "Distance to a point; with a `clock`, pseudorange or TDoA.");

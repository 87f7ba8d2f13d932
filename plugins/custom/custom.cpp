// A device by formulas, for who doesn't write C++.
//
//   z_i = reading_i(x, y, z, R) + v_i,   v_i ~ N(0, sigma_i(x, y, z, R)²)
//
// x, y, z is the target in the device's frame and R[row, column] its orientation there.
// H is exact: formulas are evaluated over numbers that carry their slopes
// (delos/expression/dual.h). Where the target turns by δθ, R ← exp(δθ) R, so that
// column c of R moves by δθ × R_c. Source: Griewank, Walther (2008), Evaluating
// Derivatives, 2nd ed., §3.1.
#include <delos/device/faults.h>
#include <delos/device/reading.h>
#include <delos/expression/expression.h>
#include <delos/plugin.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

namespace {

using delos::Dual;
using delos::Expression;

/// Along δp and δθ.
using Pose6 = Dual<double, 6>;

/// Most formulas that a device has, of each kind.
constexpr std::size_t kMost = 9;

/// The names that formulas may use: of places in the list of values.
delos::ExpressionNames names_of(Eigen::Index constants) {
  delos::ExpressionNames names{{"x", "y", "z"}, "R", {"x", "y", "z"}};
  for (Eigen::Index i = 0; i < constants; ++i)
    names.words.push_back('p' + std::to_string(i + 1));
  return names;
}

/// Formulas that ';' separates.
/// @throws delos::Unbuildable one of them is none, at its character
std::vector<Expression> formulas_of(const delos::ParamValues& values,
                                    const std::string& parameter,
                                    const delos::ExpressionNames& names) {
  const std::string_view text = values.choice(parameter);
  std::vector<Expression> all;
  for (std::size_t from = 0; from <= text.size();) {
    const std::size_t to = std::min(text.find(';', from), text.size());
    auto parsed = delos::parse_expression(text.substr(from, to - from), names);
    if (const auto* problem = std::get_if<delos::ExpressionProblem>(&parsed))
      throw delos::Unbuildable(problem->sentence, parameter, from + problem->at);
    if (all.size() == kMost)
      throw delos::Unbuildable("has more than " + std::to_string(kMost) + " formulas",
                               parameter, from);
    all.push_back(std::move(std::get<Expression>(parsed)));
    from = to + 1;
  }
  return all;
}

class Custom final : public delos::Device {
 public:
  static constexpr delos::ParamSpec kParams[] = {
      delos::text("reading",
                  "What it reads: a formula of x, y, z and R[row, column], or "
                  "several, separated by ';'."),
      delos::text("sigma",
                  "Standard deviation of each reading: a formula, or as many as "
                  "readings."),
      delos::text("period",
                  "After how much a reading comes back to itself, such as 2*pi of an "
                  "angle that is read all around; 0: never. One formula, or as many as "
                  "readings.")
          .initially("0"),
      delos::text("inside", "At least 0 where the target is seen, in metres.")
          .initially("1"),
      delos::vector("p", "1", 0,
                    "Constants that formulas call p1, p2, …; searches may "
                    "change them.")
          .initially("[]"),
      delos::choice("beyond", "undefined|smooth",
                    "Whether readings and noise go on smoothly where `inside` is below "
                    "0, so that searches have exact slopes and feel that edge.")
          .initially("undefined"),
      delos::choice("sight", "needed|not_needed",
                    "Whether bodies between the device and the target hide it.")
          .initially("needed"),
  };

  explicit Custom(const delos::ParamValues& p) {
    const Eigen::MatrixXd& constants = p.matrix("p");
    names_ = names_of(constants.size());
    readings_ = formulas_of(p, "reading", names_);
    sigmas_ = formulas_of(p, "sigma", names_);
    if (sigmas_.size() != 1 && sigmas_.size() != readings_.size())
      throw delos::Unbuildable("has " + std::to_string(sigmas_.size()) +
                                   " formulas; give one, or one a reading, which are " +
                                   std::to_string(readings_.size()),
                               "sigma", 0);
    read_periods(formulas_of(p, "period", {}));
    const std::vector<Expression> inside = formulas_of(p, "inside", names_);
    if (inside.size() != 1)
      throw delos::Unbuildable("must be one formula", "inside", 0);
    inside_ = inside.front();
    constants_.assign(constants.data(), constants.data() + constants.size());
    needs_sight_ = p.choice("sight") == "needed";
    smooth_ = p.choice("beyond") == "smooth";
    const auto turns = [&](const Expression& formula) {
      return std::any_of(formula.names.begin(), formula.names.end(),
                         [&](int name) { return name >= names_.entry(0, 0); });
    };
    turns_ = turns(inside_) || std::any_of(readings_.begin(), readings_.end(), turns) ||
             std::any_of(sigmas_.begin(), sigmas_.end(), turns);
  }

  delos::Span span() const override {
    return turns_ ? delos::Span::pose : delos::Span::point;
  }
  bool needs_sight() const override { return needs_sight_; }

  double period(int row) const override {
    return periods_.size() == 1 ? periods_.front()
                                : periods_[static_cast<std::size_t>(row)];
  }

  bool observe(const delos::Target& target, delos::Observation& out) const override {
    const int columns = turns_ ? 6 : 3;
    Pose6 p[3], R[3][3];
    for (int i = 0; i < 3; ++i) {
      p[i] = Pose6(target.p_ST(i), i);
      for (int c = 0; c < 3; ++c) {
        R[i][c] = target.R_ST(i, c);
        // δθ × R_c: row i turns rows i + 1 and i + 2 into each other.
        R[i][c].slope[3 + (i + 1) % 3] = target.R_ST((i + 2) % 3, c);
        R[i][c].slope[3 + (i + 2) % 3] = -target.R_ST((i + 1) % 3, c);
      }
    }
    const auto value = [&](const Expression& formula) {
      return evaluated<Pose6>(formula, p, [&](int i, int c) { return R[i][c]; });
    };
    if (!(value(inside_).value >= 0)) return false;
    const auto rows = static_cast<Eigen::Index>(readings_.size());
    out.z.resize(rows);
    out.H.resize(rows, columns);
    out.R.setZero(rows, rows);
    for (Eigen::Index r = 0; r < rows; ++r) {
      const Pose6 z = value(readings_[static_cast<std::size_t>(r)]);
      const double sigma = value(sigma_of(static_cast<std::size_t>(r))).value;
      out.z(r) = z.value;
      for (int k = 0; k < columns; ++k) out.H(r, k) = z.slope[k];
      out.R(r, r) = sigma * sigma;
      // A place where a formula has no value or slope isn't measured.
      if (!std::isfinite(z.value) || !out.H.row(r).allFinite() || !std::isfinite(sigma))
        return false;
    }
    return true;
  }

  /// Of at most three formulas of x, y and z.
  bool observe_smoothly(const Eigen::Vector3d& at,
                        delos::SmoothRows& out) const override {
    using T = delos::SecondOrder;
    if (!smooth_ || turns_ || readings_.size() > delos::kMaxLaneRows || at.isZero(0))
      return false;
    const auto once = delos::independent(at.x(), at.y(), at.z());
    const auto twice = delos::independent(once.x, once.y, once.z);
    const T p[3] = {twice.x, twice.y, twice.z};
    const auto value = [&](const Expression& formula) {
      return evaluated<T>(formula, p, [](int, int) { return T(); });
    };
    const T margin = value(inside_) / sqrt(squared_norm(twice));
    out.rows = static_cast<int>(readings_.size());
    out.margin = margin.value.value;
    bool finite = std::isfinite(out.margin);
    for (int k = 0; k < 3; ++k) out.margin_slope(k) = margin.value.slope[k];
    for (int r = 0; r < out.rows; ++r) {
      const T z = value(readings_[static_cast<std::size_t>(r)]),
              sigma = value(sigma_of(static_cast<std::size_t>(r))),
              variance = sigma * sigma;
      out.variance(r) = variance.value.value;
      finite = finite && out.variance(r) > 0;
      for (int i = 0; i < 3; ++i) {
        out.variance_slope(r, i) = variance.value.slope[i];
        out.H(r, i) = z.value.slope[i];
        for (int k = 0; k < 3; ++k) out.H_slope[k](r, i) = z.slope[k].slope[i];
        finite = finite && std::isfinite(out.H(r, i));
      }
    }
    return finite;
  }

 private:
  void read_periods(const std::vector<Expression>& formulas) {
    if (formulas.size() != 1 && formulas.size() != readings_.size())
      throw delos::Unbuildable("has " + std::to_string(formulas.size()) +
                                   " formulas; give one, or one a reading, which are " +
                                   std::to_string(readings_.size()),
                               "period", 0);
    for (const Expression& formula : formulas) {
      periods_.push_back(delos::evaluate<double>(formula, nullptr));
      if (!(periods_.back() >= 0 && std::isfinite(periods_.back())))
        throw delos::Unbuildable("must be 0 or more", "period", 0);
    }
  }

  const Expression& sigma_of(std::size_t row) const {
    return sigmas_.size() == 1 ? sigmas_.front() : sigmas_[row];
  }

  /// @param p three coordinates @param R(i, c) an entry of the orientation
  template <class T, class Orientation>
  T evaluated(const Expression& formula, const T* p, Orientation&& R) const {
    T values[delos::kMostNames];
    const int words = static_cast<int>(names_.words.size());
    for (std::size_t i = 0; i < formula.names.size(); ++i) {
      const int name = formula.names[i], entry = name - words;
      if (entry >= 0)
        values[i] = R(entry / 3, entry % 3);
      else
        values[i] =
            name < 3 ? p[name] : T(constants_[static_cast<std::size_t>(name - 3)]);
    }
    return delos::evaluate<T>(formula, values);
  }

  delos::ExpressionNames names_;
  std::vector<Expression> readings_, sigmas_;
  Expression inside_;            // m
  std::vector<double> periods_;  // in the readings' units
  std::vector<double> constants_;
  bool needs_sight_ = true;
  bool smooth_ = false;  // so do formulas beyond the view
  bool turns_ = false;   // a formula reads the orientation
};

}  // namespace

DELOS_DEVICE_PLUGIN(Custom, "custom", "1.0.0",
                    "Readings and noise by formulas in the scene.");

// A measurement that is linear in the filter's state, whatever that state is.
//
//   z = H x + v,   v ~ N(0, R)
//
// x is the whole state in the order of the motion model, z has m readings, H is m×n and
// R m×m. Source: Kalman (1960), J. Basic Engineering 82(1), 35–45,
// doi:10.1115/1.3662552.
#include <delos/model/symmetric.h>
#include <delos/plugin.h>

#include <limits>
#include <stdexcept>
#include <string>

namespace {

using delos::matrix;

std::string shape(const Eigen::MatrixXd& m) {
  return std::to_string(m.rows()) + "×" + std::to_string(m.cols());
}

void check_covariance(const Eigen::MatrixXd& R) {
  if (R.rows() != R.cols()) {
    throw std::invalid_argument("R must be square, it is " + shape(R));
  }
  for (int i = 0; i < R.rows(); ++i) {
    for (int j = 0; j < i; ++j) {
      if (R(i, j) == R(j, i)) continue;
      throw std::invalid_argument("R must be symmetric, row " + std::to_string(j + 1) +
                                  " differs from column " + std::to_string(j + 1));
    }
  }
  // A singular R is a perfect reading; rounding may turn its 0 into a little less.
  const delos::StateVector values = delos::symmetric_eigenvalues(R);
  const double rounding =
      R.rows() * std::numeric_limits<double>::epsilon() * values.cwiseAbs().maxCoeff();
  if (values(0) < -rounding) {
    throw std::invalid_argument("R must have no negative eigenvalue, it has " +
                                std::to_string(values(0)));
  }
}

class Linear final : public delos::Device {
 public:
  static constexpr delos::ParamSpec kParams[] = {
      matrix("H", "Readings per state, a row for each reading, in SI units."),
      matrix("R",
             "Covariance of the readings, symmetric, with no negative eigenvalue."),
  };

  explicit Linear(const delos::ParamValues& p) {
    const Eigen::MatrixXd& H = p.matrix("H");
    const Eigen::MatrixXd& R = p.matrix("R");
    if (H.size() == 0 || H.rows() > delos::kMaxRows || H.cols() > delos::kMaxState) {
      throw std::invalid_argument(
          "H must be 1×1 to " + std::to_string(delos::kMaxRows) + "×" +
          std::to_string(delos::kMaxState) + ", it is " + shape(H));
    }
    check_covariance(R);
    if (R.rows() != H.rows()) {
      throw std::invalid_argument("R must have as many rows as H, it is " + shape(R) +
                                  " and H is " + shape(H));
    }
    model_.H = H;
    model_.R = R;
  }

  delos::Span span() const override { return delos::Span::state; }
  int state_size() const override { return static_cast<int>(model_.H.cols()); }

  bool observe(const delos::Target& target, delos::Observation& out) const override {
    out.z = model_.H.lazyProduct(target.state);
    out.H = model_.H;
    out.R = model_.R;
    return true;
  }

 private:
  delos::Observation model_;  // H and R
};

}  // namespace

DELOS_DEVICE_PLUGIN(Linear, "linear", "1.0.0",
                    "Readings that are a given matrix times the state.");

// A magnetic tracker: three crossed coils fixed in the room, driven one after the
// other, and three crossed coils on the target that read their field.
//
//   z = R_STᵀ B(p) + v,   v ~ N(0, sigma² I),   nine numbers
//
//   B_ij(p) = c (3 p_i p_j/r² − δ_ij)/r³,   c = µ0 moment/4π,   r = ‖p‖
//
// p and R_ST are the sensor's place and orientation in the source's frame; column j is
// the field of a dipole along the source's axis j. With B symmetric,
//
//   ∂B_ij/∂p_k = 3c/r⁵ (δ_ik p_j + δ_jk p_i + δ_ij p_k − 5 p_i p_j p_k/r²)
//   ∂z/∂θ_k = −R_STᵀ (e_k × B)
//
// Source: F. H. Raab, E. B. Blood, T. O. Steiner, H. R. Jones (1979), Magnetic position
// and orientation tracking system, IEEE Trans. AES 15(5), 709–718.
#include <delos/plugin.h>

#include <Eigen/Geometry>

namespace {

using delos::number;

constexpr double kVacuum = 1e-7;  // µ0/4π, T m/A

class MagneticDipole final : public delos::Device {
 public:
  static constexpr delos::ParamSpec kParams[] = {
      number("moment", "A*m^2", "Magnetic moment of each coil of the source.")
          .at_least(1e-12)
          .by_factors(),
      number("sigma", "T",
             "Noise floor: standard deviation of each of the nine fields.")
          .at_least(1e-30)
          .by_factors(),
      number("near", "m", "Least distance, nearer than which coils are no dipoles.")
          .initially(0.05)
          .at_least(1e-3),
      number("reach", "m", "Greatest distance.").initially(3).at_least(0),
  };

  explicit MagneticDipole(const delos::ParamValues& p)
      : strength_(kVacuum * p["moment"]),
        variance_(p["sigma"] * p["sigma"]),
        near_(p["near"]),
        reach_(p["reach"]) {}

  delos::Span span() const override { return delos::Span::pose; }

  bool observe(const delos::Target& target, delos::Observation& out) const override {
    const Eigen::Vector3d& p = target.p_ST;
    const double r = p.norm();
    if (!(r >= near_ && r <= reach_)) return false;
    const Eigen::Matrix3d R_TS = target.R_ST.transpose();
    const double c = strength_ / (r * r * r);
    const Eigen::Vector3d u = p / r;
    const Eigen::Matrix3d B = c * (3 * u * u.transpose() - Eigen::Matrix3d::Identity());
    out.z.resize(9);
    out.H.resize(9, 6);
    for (int j = 0; j < 3; ++j) {
      out.z.segment<3>(3 * j) = R_TS * B.col(j);
      for (int k = 0; k < 3; ++k) {
        Eigen::Vector3d slope = -5 * u(j) * u(k) * u;
        slope(k) += u(j);
        slope(j) += u(k);
        if (j == k) slope += u;
        out.H.block<3, 1>(3 * j, k) = 3 * c / r * (R_TS * slope);
        const Eigen::Vector3d turned = Eigen::Vector3d::Unit(k).cross(B.col(j));
        out.H.block<3, 1>(3 * j, 3 + k) = -(R_TS * turned);
      }
    }
    out.R.setIdentity(9, 9);
    out.R *= variance_;
    return true;
  }

 private:
  double strength_;  // c, T m³
  double variance_;  // T²
  double near_;      // m
  double reach_;     // m
};

}  // namespace

DELOS_DEVICE_PLUGIN(MagneticDipole, "magnetic_dipole", "1.0.0",
                    "Magnetic tracker: three-axis source and sensor, full pose.");

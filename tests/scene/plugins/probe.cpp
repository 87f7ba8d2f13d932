// A device whose table has every kind of parameter, and whose constructor may refuse.
#include <delos/plugin.h>

#include <stdexcept>

namespace {

class Probe final : public delos::Device {
 public:
  static constexpr delos::ParamSpec kParams[] = {
      {.name = "r", .unit = "m", .lower = 0, .upper = 2, .help = "Noise of a range."},
      {.name = "focal",
       .unit = "m",
       .initial = 0.05,
       .lower = 1e-3,
       .help = "Focal length."},
      {.name = "near", .unit = "m", .initial = 0.1, .help = "Nearest target."},
      {.name = "far", .unit = "m", .initial = 10, .help = "Farthest target."},
      {.name = "gain", .initial = 0.5, .lower = 0, .upper = 1, .help = "A share."},
      {.name = "shape",
       .kind = delos::ParamKind::choice,
       .text = "round",
       .choices = "round|square|hexagonal",
       .help = "Shape of the aperture."},
      {.name = "resolution",
       .kind = delos::ParamKind::vector,
       .unit = "px",
       .lower = 1,
       .text = "[640, 480]",
       .length = 2,
       .help = "Pixels along x and y."},
      {.name = "mix",
       .kind = delos::ParamKind::matrix,
       .text = "[[1, 0, 0], [0, 1, 0]]",
       .help = "Weights."},
  };

  explicit Probe(const delos::ParamValues& p) {
    if (p["near"] >= p["far"])
      throw std::invalid_argument("near must be below far; exchange them");
  }

  bool observe(const delos::Target&, delos::Observation&) const override {
    return false;
  }
};

}  // namespace

DELOS_DEVICE_PLUGIN(Probe, "probe", "1.0.0", "Measures nothing, with many parameters.");

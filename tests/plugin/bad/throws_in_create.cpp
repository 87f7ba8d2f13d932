// Finds its parameters clashing, whatever they are.
#include <delos/plugin.h>

#include <stdexcept>

namespace {

class Throws final : public delos::Device {
 public:
  static constexpr delos::ParamSpec kParams[] = {
      {.name = "scale", .initial = 1, .help = "Metres to units."}};
  explicit Throws(const delos::ParamValues&) {
    throw std::invalid_argument("scale clashes with itself");
  }
  bool observe(const delos::Target&, delos::Observation&) const override {
    return false;
  }
};

}  // namespace

DELOS_DEVICE_PLUGIN(Throws, PLUGIN_ID, "1.0.0", "Can't be made.");

// A device that measures a state of a given size.
#include <delos/plugin.h>

namespace {

class StateProbe final : public delos::Device {
 public:
  static constexpr delos::ParamSpec kParams[] = {
      {.name = "size", .lower = 0, .upper = 30, .help = "Entries of the state."},
  };

  explicit StateProbe(const delos::ParamValues& p)
      : size_(static_cast<int>(p["size"])) {}

  delos::Span span() const override { return delos::Span::state; }
  int state_size() const override { return size_; }
  bool observe(const delos::Target&, delos::Observation&) const override {
    return false;
  }

 private:
  int size_;
};

}  // namespace

DELOS_DEVICE_PLUGIN(StateProbe, "state_probe", "1.0.0",
                    "Measures a state of some size.");

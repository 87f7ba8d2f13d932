#include "guess.h"

namespace delos {
namespace {

class Guess final : public Device {
 public:
  explicit Guess(double variance) : variance_(variance) {}
  [[nodiscard]] Span span() const override { return Span::pose; }
  [[nodiscard]] bool observe(const Target& target, Observation& out) const override {
    out.z.setZero(6);
    out.z.head<3>() = target.p_ST;
    out.H.setIdentity(6, 6);
    out.R.setZero(6, 6);
    out.R.diagonal().setConstant(variance_);
    return true;
  }

 private:
  double variance_;
};

}  // namespace

bool takes_guess(const System& system) {
  return system.fusion != Fusion::sequential && system.fusion != Fusion::artemis;
}

double guess_information(const System& system, double sigma) {
  const double weight =
      system.fusion == Fusion::continuous ? 1 / system.devices.front().period : 1;
  return takes_guess(system) ? weight / (sigma * sigma) : 0;
}

void add_guess(System& system, double sigma) {
  if (!takes_guess(system)) return;
  PlacedDevice guess;
  guess.name = guess.type = "guess";
  guess.device = std::make_shared<Guess>(sigma * sigma);
  guess.period = system.devices.front().period;
  guess.phase = system.devices.front().phase;
  system.devices.push_back(std::move(guess));
}

}  // namespace delos

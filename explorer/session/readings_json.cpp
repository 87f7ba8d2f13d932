#include "session/readings_json.h"

namespace delos::session {

PowerAnswer answer_power(const readings::PowerTest& test, std::optional<double> effect,
                         std::optional<double> count, std::optional<double> power) {
  PowerAnswer answer{test, effect.value_or(0), count.value_or(0), power.value_or(0)};
  if (!count)
    answer.count = readings::readings_for(test, *effect, *power);
  else if (!effect)
    answer.effect = readings::effect_for(test, *count, *power);
  if (answer.count > 0)
    answer.power = readings::power_of(test, answer.effect, answer.count);
  return answer;
}

Json power_json(const PowerAnswer& answer) {
  return {{"test", answer.test.known ? "z" : "t"},
          {"means", answer.test.two_means ? 2 : 1},
          {"sides", answer.test.two_sided ? 2 : 1},
          {"sigma", number(answer.test.sigma)},
          {"alpha", number(answer.test.alpha)},
          {"effect", number(answer.effect)},
          {"readings", number(answer.count)},
          {"power", number(answer.power)}};
}

NoiseAnswer answer_noise(const readings::Amplifier& amplifier, double current, double x,
                         double readings, const std::vector<double>& windows) {
  NoiseAnswer answer{amplifier, current, x, readings, windows, {}};
  for (const double window : windows)
    answer.noise.push_back(
        readings::position_noise(amplifier, current, x, window, readings));
  return answer;
}

Json noise_json(const NoiseAnswer& answer) {
  Json json{{"current", number(answer.current)},
            {"x", number(answer.x)},
            {"readings", number(answer.readings)},
            {"windows", Json::array()}};
  for (std::size_t i = 0; i < answer.windows.size(); ++i) {
    const readings::PositionNoise& noise = answer.noise[i];
    Json one{{"window", number(answer.windows[i])},
             {"linear", number(noise.linear)},
             {"independent", number(noise.independent)},
             {"ends", Json::array()}};
    for (std::size_t end = 0; end < 2; ++end) {
      Json sources = Json::object();
      for (std::size_t s = 0; s < readings::kSources; ++s)
        sources[readings::kSourceNames[s]] = {
            {"density", number(noise.sources[end][s].density)},
            {"rms", number(noise.sources[end][s].rms)}};
      one["ends"].push_back({{"current", number(noise.current[end])},
                             {"rms", number(noise.rms[end])},
                             {"sources", std::move(sources)}});
    }
    json["windows"].push_back(std::move(one));
  }
  return json;
}

Json shutter_json(const readings::CodedWindow& window) {
  const readings::Smear smear = readings::smear_of(window);
  Json motion = Json::object();
  const char* names[] = {"position", "position_velocity",
                         "position_velocity_acceleration"};
  for (int order = 1; order <= 3; ++order)
    motion[names[order - 1]] = number(readings::motion_of(window, order));
  return {{"chops", window.open.size()},
          {"duration", number(window.duration())},
          {"light", number(window.light())},
          {"mean_age", number(-readings::lever_of(window, 1))},
          {"spread", number(readings::spread_of(window))},
          {"motion", std::move(motion)},
          {"least_spectrum", number(smear.least)},
          {"noise_gain", number(smear.noise_gain)}};
}

}  // namespace delos::session

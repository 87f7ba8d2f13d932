#include "scene/sample_time_keys.h"

#include <cmath>

#include "delos/scene/definition.h"
#include "delos/text/units.h"
#include "document/node_text.h"
#include "scene/words.h"

namespace delos {
namespace {

using namespace shapes;
using Written = std::optional<Node>;

/// The worst fit of a table that is taken for one: relative, root mean square.
constexpr double kWorstFit = 0.3;

constexpr std::array<Key<Timing>, 3> kTimingKeys = {{
    other_key<&Timing::processing>("processing", Need::optional,
                                   "what an update takes beside its exposure, s",
                                   number("s", at_least(0))),
    other_key<&Timing::idle>("idle", Need::optional, "how long it then waits, s",
                             number("s", at_least(0))),
    other_key<&Timing::windows>(
        "windows", Need::optional,
        "windows of one exposure that an update takes, such as 2, light and dark",
        number("1", above(0))),
}};

void read_table(Reader& reader, const Place& at, NoiseOverTime& out) {
  const auto rows = reader.matrix(at, [](int, int j) { return j == 0 ? "s" : "1"; });
  if (!rows) return;
  if (rows->cols() != 2 || rows->rows() < 3)
    return reader.error(at,
                        "takes three pairs of an exposure and a variance or more, "
                        "[[1 ms, 4e-6], …]");
  const auto refuse = [&](Eigen::Index i, const char* problem) {
    const auto row = static_cast<std::size_t>(i);
    reader.error(Place(at, std::to_string(i), at.node().items[row]), problem);
  };
  const std::size_t before = reader.findings.errors();
  for (Eigen::Index i = 0; i < rows->rows(); ++i) {
    const double exposure = (*rows)(i, 0), variance = (*rows)(i, 1);
    if (!(exposure > 0)) refuse(i, "its exposure must be above 0");
    if (!(variance > 0)) refuse(i, "its variance must be above 0");
    if (i > 0 && !(exposure > (*rows)(i - 1, 0)))
      refuse(i, "its exposure isn't longer than the one before; sort the table");
    out.table.push_back({exposure, variance});
  }
  if (reader.findings.errors() > before) return;
  const double error = fit_bench(out.table).error;
  if (error > kWorstFit)
    reader.error(at,
                 "no a + b/tau + c/tau^2 with parts of 0 or more is near it: the "
                 "best is off by " +
                     shortest(std::round(100 * error)) +
                     " %; a variance that doesn't fall with the exposure needs "
                     "law: expression");
}

constexpr std::pair<const char*, NoiseLaw> kNoiseLawWords[] = {
    {"constant", NoiseLaw::constant},     {"inverse", NoiseLaw::inverse},
    {"samples", NoiseLaw::samples},       {"photon", NoiseLaw::photon},
    {"photodiode", NoiseLaw::photodiode}, {"table", NoiseLaw::table},
    {"expression", NoiseLaw::expression},
};

constexpr std::array<Key<NoiseOverTime>, 8> kNoiseKeys = {{
    {"law", Need::required,
     "constant, inverse, samples, photon, photodiode, table or expression",
     choice<kNoiseLawWords>(),
     [](Reader& r, const Place& p, NoiseOverTime& n) {
       if (const auto law = r.choice(p, kNoiseLawWords)) n.law = *law;
     },
     [](const NoiseOverTime& n) -> Written {
       return to_node(word_of(kNoiseLawWords, n.law));
     }},
    other_key<&NoiseOverTime::at>("at", Need::optional,
                                  "the exposure that the noise in `params` is of, s",
                                  number("s", above(0))),
    other_key<&NoiseOverTime::read>(
        "read", Need::optional,
        "photon: what part of the variance reading out has at `at`, 0 to 1",
        number("1", between(0, 1))),
    other_key<&NoiseOverTime::frequency>("frequency", Need::optional,
                                         "samples: how often it samples, Hz",
                                         number("1/s", above(0))),
    other_key<&NoiseOverTime::bandwidth>("bandwidth", Need::optional,
                                         "photodiode: of its amplifier, Hz",
                                         number("1/s", above(0))),
    other_key<&NoiseOverTime::gap>(
        "gap", Need::optional, "photodiode: between the light and the dark window, s",
        number("s", at_least(0))),
    {"table", Need::optional, "table: [[exposure, variance], …], measured",
     list([] { return numbers(nullptr, 2, 2); }, 3), read_table,
     [](const NoiseOverTime& n) -> Written {
       if (n.table.empty()) return std::nullopt;
       Eigen::MatrixXd rows(static_cast<Eigen::Index>(n.table.size()), 2);
       for (Eigen::Index i = 0; i < rows.rows(); ++i) {
         const BenchReading& reading = n.table[static_cast<std::size_t>(i)];
         rows.row(i) << reading.exposure, reading.variance;
       }
       return matrix_node(rows);
     }},
    other_key<&NoiseOverTime::expression>("expression", Need::optional,
                                          "expression: the variance by tau, seconds",
                                          text()),
}};

/// Each law has its own keys, and needs them.
void check_law(Reader& reader, const Place& at, const NoiseOverTime& noise) {
  struct Rule {
    const char* key;
    NoiseLaw law;
    Need need;
  };
  constexpr Rule kRules[] = {{"read", NoiseLaw::photon, Need::optional},
                             {"frequency", NoiseLaw::samples, Need::required},
                             {"bandwidth", NoiseLaw::photodiode, Need::required},
                             {"gap", NoiseLaw::photodiode, Need::optional},
                             {"table", NoiseLaw::table, Need::required},
                             {"expression", NoiseLaw::expression, Need::required}};
  for (const Rule& rule : kRules) {
    const Node* given = at.node().find(rule.key);
    if (given && rule.law != noise.law)
      reader.error_within(
          at, given->mark, rule.key,
          std::string("goes with law: ") + word_of(kNoiseLawWords, rule.law));
    if (!given && rule.law == noise.law && rule.need == Need::required)
      reader.error_within(at, at.node().mark, rule.key, "missing: this law needs it");
  }
  const Node* of = at.node().find("at");
  if (noise.law == NoiseLaw::constant) {
    if (of)
      reader.error_within(at, of->mark, "at",
                          "has no meaning where the noise is constant");
  } else if (!of) {
    reader.error_within(at, at.node().mark, "at",
                        "missing: the exposure that the noise in `params` is of");
  }
}

}  // namespace

std::vector<KeyShape> timing_keys() { return keys_of<kTimingKeys>(); }
std::vector<KeyShape> noise_over_time_keys() { return keys_of<kNoiseKeys>(); }

void read_timing(Reader& reader, const Place& at, DeviceEntry& out) {
  const std::size_t before = reader.findings.errors();
  Timing timing;
  if (!read_map(reader, at, kTimingKeys, timing)) return;
  if (reader.findings.errors() == before) out.timing = timing;
}

Written write_timing(const DeviceEntry& device) {
  if (!device.timing) return std::nullopt;
  return write_map(kTimingKeys, *device.timing);
}

void read_noise_over_time(Reader& reader, const Place& at, DeviceEntry& out) {
  const std::size_t before = reader.findings.errors();
  NoiseOverTime noise;
  if (!read_map(reader, at, kNoiseKeys, noise)) return;
  if (reader.findings.errors() == before) check_law(reader, at, noise);
  if (reader.findings.errors() == before && noise.law == NoiseLaw::expression) {
    const std::string problem = expression_problem(noise);
    if (!problem.empty())
      reader.error_within(at, at.node().find("expression")->mark, "expression",
                          problem);
  }
  // With a finding, the rest of the device is read as if its noise were constant.
  if (reader.findings.errors() == before) out.noise_over_time = std::move(noise);
}

Written write_noise_over_time(const DeviceEntry& device) {
  if (!device.noise_over_time) return std::nullopt;
  return write_map(kNoiseKeys, *device.noise_over_time);
}

void check_sample_time(Reader& reader, const Place& at, const DeviceEntry& device) {
  const Node *rate = at.node().find("rate"), *timing = at.node().find("timing"),
             *exposure = at.node().find("exposure");
  if (!rate && !timing)
    reader.error_within(at, at.node().mark, "rate",
                        "missing: updates a second, such as 50 Hz");
  if (rate && timing)
    return reader.error_within(at, timing->mark, "timing",
                               "says the rate, which is given, too; keep one of them");
  if (device.timing && !(period_of(*device.timing, device.exposure) > 0))
    return reader.error_within(at, timing->mark, "timing",
                               "leaves an update no time; give it an exposure, or "
                               "processing or idle time");
  if (!(rate_of(device) > 0)) return;
  if (const std::string problem = exposure_problem(device); !problem.empty())
    reader.error_within(at, exposure->mark, "exposure", problem);
  if (const std::string problem = noise_problem(device); !problem.empty())
    reader.error_within(
        at, exposure ? exposure->mark : at.node().find("noise_over_time")->mark,
        "exposure", problem);
}

}  // namespace delos

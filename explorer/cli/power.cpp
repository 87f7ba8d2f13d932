// delos power: how many readings show a difference.
#include "readings/power.h"

#include <iostream>
#include <memory>

#include "command.h"
#include "delos/text/words.h"
#include "json.h"
#include "session/readings_json.h"

namespace delos::cli {
namespace {

struct PowerCommand {
  readings::PowerTest test;
  std::optional<double> effect, count, power;
  bool one_sided = false, estimated = false, json = false;
};

int run(const PowerCommand& command) {
  readings::PowerTest test = command.test;
  test.two_sided = !command.one_sided;
  test.known = !command.estimated;
  if (!command.effect && !command.count)
    throw Failure{kUsage, "give --effect, --readings or both"};
  // Given both of the others, the power is what is asked for.
  constexpr double kUsual = 0.8;
  std::optional<double> power = command.power;
  if (!power && !(command.effect && command.count)) power = kUsual;
  if (power && command.effect && command.count)
    throw Failure{kUsage, "--effect, --readings and --power: give two, ask for one"};
  if (const std::string problem =
          readings::power_problem(test, power.value_or((1 + test.alpha) / 2));
      !problem.empty())
    throw Failure{kUsage, problem};
  if (command.effect && !(*command.effect > 0))
    throw Failure{kUsage, "--effect must be above 0"};
  const double least = test.known ? 1 : 2;
  if (command.count && !(*command.count >= least && *command.count <= 1e12))
    throw Failure{kUsage, "--readings must be from " +
                              std::string(least > 1 ? "2" : "1") + " to 10^12"};
  const session::PowerAnswer answer =
      session::answer_power(test, command.effect, command.count, power);
  if (answer.count == 0)
    throw Failure{kDiagnostics, "10^12 readings aren't enough for so small an effect"};
  if (command.json) {
    print_document(session::power_json(answer));
    return kDone;
  }
  const std::string readings =
      counted(static_cast<std::size_t>(answer.count), "reading");
  char found[120];
  std::snprintf(found, sizeof found, "a difference of %.4g with a power of %.4g",
                answer.effect, answer.power);
  std::cout << (test.two_means ? "Two means of " + readings + " each find "
                               : "A mean of " + readings + " finds ")
            << found << " (" << (test.known ? "z" : "t") << " test, "
            << (test.two_sided ? "two-sided" : "one-sided") << ", alpha " << test.alpha
            << ")\n";
  return kDone;
}

}  // namespace

void add_power_command(CLI::App& program, int& exit_code) {
  auto command = std::make_shared<PowerCommand>();
  CLI::App* app = program.add_subcommand(
      "power", "How many readings show a difference, or how small a one they show");
  app->add_option("--sigma", command->test.sigma,
                  "Standard deviation of a reading, in any unit")
      ->required();
  app->add_option("--effect", command->effect, "Difference of means, in that unit");
  app->add_option("--readings", command->count, "Readings of each mean");
  app->add_option("--power", command->power,
                  "How often the difference is found, 1 - beta; default 0.8");
  app->add_option("--alpha", command->test.alpha,
                  "How often one is found that isn't there")
      ->capture_default_str();
  app->add_flag("--two-means", command->test.two_means,
                "Against the mean of as many other readings, not a known value");
  app->add_flag("--one-sided", command->one_sided, "Differences one way only");
  app->add_flag("--estimated", command->estimated,
                "sigma is estimated from the readings: t instead of z");
  app->add_flag("--json", command->json, "JSON on stdout");
  app->footer(
      "Examples:\n"
      "  delos power --sigma 0.5 --effect 0.1\n"
      "  delos power --sigma 2 --readings 64 --two-means --estimated\n"
      "  delos power --sigma 2 --effect 1 --readings 20 --one-sided --json");
  app->callback([command, &exit_code] { exit_code = run(*command); });
}

}  // namespace delos::cli

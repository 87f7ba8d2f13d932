#include "session/kept_simulation.h"

#include <fstream>
#include <iterator>
#include <sstream>

#include "delos/scene/io.h"
#include "output/write.h"

namespace delos::session {
namespace {

constexpr const char* kKind = "delos simulate 1\n";

}  // namespace

std::string identity_of_runs(const LoadedScene& loaded, const SimulatedPlace& place,
                             const SimulationOptions& options) {
  std::ostringstream text;
  text.precision(17);
  text << "filter " << to_string(options.filter) << "\nseed " << options.seed
       << "\nseconds " << options.seconds << "\nat " << place.pose.p.transpose()
       << "\nR " << place.pose.R.reshaped().transpose() << "\n";
  if (options.path)
    for (std::size_t i = 0; i < options.path->t.size(); ++i)
      text << options.path->t[i] << " " << options.path->p[i].transpose() << "\n";
  text << write_scene(loaded.scene);
  return text.str();
}

KeptRuns kept_runs(const std::filesystem::path& file, const std::string& identity) {
  std::ifstream in(file, std::ios::binary);
  if (!in) return {};
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  if (!text.starts_with(kKind))
    return {"", file.string() + " isn't a file of simulated runs; name another"};
  const std::string head = kKind + identity + '\0';
  if (!text.starts_with(head))
    return {"", file.string() +
                    " has runs of another scene, place, filter or seed; name another "
                    "file, or remove it"};
  return {text.substr(head.size()), ""};
}

std::string save_runs(const std::filesystem::path& file, const std::string& identity,
                      const std::string& sums) {
  return write_text(file, kKind + identity + '\0' + sums);
}

}  // namespace delos::session

#include "crew/crew_job.h"

#include <fstream>
#include <iterator>
#include <set>

#include "crew/bytes.h"

namespace delos {
namespace {

/// FNV-1a, 64 bits.
std::uint64_t hash_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (std::istreambuf_iterator<char> at(in), end; at != end; ++at)
    hash = (hash ^ static_cast<unsigned char>(*at)) * 0x100000001b3u;
  return hash;
}

/// The plugins that a scene needs, as this process has them.
std::string plugins_text(const Scene& scene, PluginRegistry& plugins) {
  std::set<std::string> types;
  for (const DeviceEntry& device : scene.devices) types.insert(device.type);
  std::string text;
  for (const std::string& type : types) {
    const PluginLoad& load = plugins.find(type);
    text += type + ' ' + (load.info ? load.info->version : "missing") + ' ' +
            std::to_string(hash_of(load.path)) + '\n';
  }
  return text;
}

}  // namespace

void compare_plugins(Crew& crew, const Scene& scene, PluginRegistry& plugins) {
  compare_plugins(crew, plugins_text(scene, plugins));
}

void compare_plugins(Crew& crew, const std::string& mine) {
  ByteWriter said;
  said.put(crew.host());
  said.put(mine);
  std::string first;
  const std::vector<std::string> all = crew.exchange(said.bytes());
  for (std::size_t rank = 0; rank < all.size(); ++rank) {
    ByteReader of(all[rank]);
    const std::string host = of.text(), theirs = of.text();
    if (rank == 0) first = theirs;
    if (theirs == first) continue;
    std::size_t at = 0;
    while (at < theirs.size() && at < first.size() && theirs[at] == first[at]) ++at;
    const std::size_t line = first.rfind('\n', at > 0 ? at - 1 : 0);
    const std::string from = first.substr(line == std::string::npos ? 0 : line + 1);
    throw std::runtime_error("process " + std::to_string(rank) + " on " + host +
                             " has another plugin '" + from.substr(0, from.find(' ')) +
                             "' than process 0; install the same Delos on all "
                             "machines, and the same DELOS_PLUGIN_PATH");
  }
}

}  // namespace delos

// Finds, checks and opens device plugins.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

#include "delos/api.h"
#include "delos/plugin.h"

namespace delos {

/// Where plugins are looked for, first match wins: `extra` (--plugin-dir), then the
/// colon- separated DELOS_PLUGIN_PATH, then the folder `delos` beside the kernel's
/// library.
[[nodiscard]] DELOS_API std::vector<std::filesystem::path> plugin_folders(
    const std::vector<std::filesystem::path>& extra = {});

/// What came of opening one plugin.
struct PluginLoad {
  const PluginInfo* info = nullptr;  ///< null where it could not be used
  std::filesystem::path path;        ///< the library, empty where none was found
  std::string error;  ///< one sentence that says what is wrong and what to do
};

/// The device plugins of a program. Libraries are opened on first use and never closed,
/// since devices and tables live in them. May be asked from several threads at once.
class DELOS_API PluginRegistry {
 public:
  explicit PluginRegistry(
      std::vector<std::filesystem::path> folders = plugin_folders());

  /// Have a device of the program's own; of one id the last counts from then on.
  /// @param info kept by reference, for as long as any device of it lives
  /// @throws std::invalid_argument a library in the folders has its id
  void add(const PluginInfo& info);

  /// The plugin with this id: `<folder>/<id>.so` in the first folder that has it.
  /// The stamp is compared before any C++ object is touched. The answer is kept.
  const PluginLoad& find(std::string_view id);

  /// Every plugin in the folders and of the program, sorted by id, the broken ones with
  /// their errors.
  std::vector<PluginLoad> all();

  /// Their ids, sorted, without opening libraries.
  [[nodiscard]] std::vector<std::string> ids() const;

  [[nodiscard]] const std::vector<std::filesystem::path>& folders() const {
    return folders_;
  }

 private:
  std::vector<std::filesystem::path> folders_;
  std::vector<std::string> own_;  // ids of the program's
  std::mutex mutex_;              // of the answers, which stay where they are
  std::map<std::string, PluginLoad, std::less<>> loaded_;
};

/// Compare a plugin's stamp with the kernel's, field by field.
/// @returns empty where they agree; else which field differs, both values, and what to
/// do.
[[nodiscard]] DELOS_API std::string stamp_difference(const AbiStamp& plugin);

/// Create a device.
/// @throws Unbuildable what the plugin's constructor says, when values clash, or that
///         it says nothing
/// @throws std::bad_alloc memory is short
[[nodiscard]] DELOS_API std::shared_ptr<const Device> make_device(
    const PluginInfo& info, const ParamValues& params);

}  // namespace delos

#include "delos/plugin/registry.h"

#include <algorithm>
#include <boost/dll/shared_library.hpp>
#include <cerrno>
#include <mutex>
#include <new>
#include <set>
#include <stdexcept>
#include <system_error>

#include "delos/device/faults.h"
#include "plugin/elf_symbols.h"
#include "text/nearest.h"

namespace delos {
namespace {

namespace fs = std::filesystem;

constexpr const char* kEntry = "delos_plugin";

/// Open a library and keep it open until the program ends: devices, tables and
/// exceptions that live in it may outlast every registry.
boost::dll::shared_library& open_for_good(const fs::path& file) {
  static std::mutex mutex;
  // Never destroyed, since destroying it would close them while objects are still
  // about.
  static auto& open = *new std::vector<std::unique_ptr<boost::dll::shared_library>>;
  auto library = std::make_unique<boost::dll::shared_library>(
      fs::absolute(file),
      boost::dll::load_mode::rtld_now | boost::dll::load_mode::rtld_local);
  const std::lock_guard lock(mutex);
  return *open.emplace_back(std::move(library));
}

/// What is wrong with a file that isn't opened for it, empty where nothing is.
std::string unfit_to_open(const fs::path& file) {
  switch (inspect_library(file, kEntry)) {
    case LibraryFile::exports:
      return {};
    case LibraryFile::lacks_symbol:
      return "has no symbol delos_plugin; end its source with DELOS_DEVICE_PLUGIN";
    case LibraryFile::not_a_library:
      return "is not a shared library; rebuild it with delos_add_device() or remove it";
    case LibraryFile::unreadable:
      break;
  }
  return "cannot be read (" + std::generic_category().message(errno) +
         "); check that it exists and may be read";
}

/// What the dynamic linker said; Boost wraps it up, and adds an errno of something
/// else.
std::string linker_message(const std::string& wrapped) {
  constexpr std::string_view kBefore = "(dlerror system message: ";
  const std::size_t begin = wrapped.find(kBefore), end = wrapped.rfind("): ");
  if (begin == std::string::npos || end == std::string::npos) return wrapped;
  const std::size_t first = begin + kBefore.size();
  return end < first ? wrapped : wrapped.substr(first, end - first);
}

/// Sets info, or says what is wrong with the library.
std::string open_plugin(const fs::path& file, const PluginInfo*& info) {
  if (std::string unfit = unfit_to_open(file); !unfit.empty()) return unfit;

  const PluginInfo* found = nullptr;
  try {
    found = open_for_good(file).get<const PluginInfo*()>(kEntry)();
  } catch (const std::exception& e) {
    return "cannot be opened (" + linker_message(e.what()) +
           "); rebuild it against this kernel, or install what it needs";
  }
  if (!found) return "says nothing of itself; end its source with DELOS_DEVICE_PLUGIN";
  if (std::string other = stamp_difference(found->abi); !other.empty()) return other;

  const std::string stem = file.stem();
  if (found->id != stem) {
    return std::string("calls itself '") + found->id + "'; name the file " + found->id +
           ".so or the plugin '" + stem + "'";
  }
  info = found;
  return {};
}

/// Folders for an error message, those that aren't there marked.
std::string folders_text(const std::vector<fs::path>& folders) {
  std::string text;
  for (const fs::path& folder : folders) {
    std::error_code ignored;
    if (!text.empty()) text += ", ";
    text += folder.string();
    if (!fs::is_directory(folder, ignored)) text += " (no such folder)";
  }
  return text.empty() ? "no folder at all" : text;
}

/// The library of an id in the first folder that has it, else empty. Ids are names,
/// never paths: a scene must not reach libraries outside the folders.
fs::path locate(const std::vector<fs::path>& folders, std::string_view id) {
  if (id.empty() || id.find('/') != std::string_view::npos) return {};
  for (const fs::path& folder : folders) {
    const fs::path file = folder / (std::string(id) + ".so");
    // Dangling links count: they are reported as unreadable rather than passed over.
    std::error_code ignored;
    if (fs::exists(fs::symlink_status(file, ignored))) return file;
  }
  return {};
}

}  // namespace

PluginRegistry::PluginRegistry(std::vector<fs::path> folders)
    : folders_(std::move(folders)) {}

void PluginRegistry::add(const PluginInfo& info) {
  const std::lock_guard lock(mutex_);
  if (!locate(folders_, info.id).empty())
    throw std::invalid_argument(std::string("there is a plugin '") + info.id +
                                "' already; choose another id");
  // What was looked for in vain before is found from now on.
  loaded_[info.id] = {&info, {}, {}};
  if (std::find(own_.begin(), own_.end(), info.id) == own_.end())
    own_.emplace_back(info.id);
}

const PluginLoad& PluginRegistry::find(std::string_view id) {
  const std::lock_guard lock(mutex_);
  if (const auto it = loaded_.find(id); it != loaded_.end()) return it->second;

  PluginLoad load;
  load.path = locate(folders_, id);
  if (load.path.empty()) {
    const std::string meant = nearest(id, ids());
    load.error = "there is no plugin '" + std::string(id) + "' in " +
                 folders_text(folders_) + "; " +
                 (meant.empty() ? "put its library there, or its folder into "
                                  "DELOS_PLUGIN_PATH"
                                : "did you mean '" + meant + "'?");
  } else if (std::string wrong = open_plugin(load.path, load.info); !wrong.empty()) {
    load.error = load.path.string() + " " + wrong;
  }
  return loaded_.emplace(id, std::move(load)).first->second;
}

std::vector<PluginLoad> PluginRegistry::all() {
  std::vector<PluginLoad> loads;
  for (const std::string& id : ids()) loads.push_back(find(id));
  return loads;
}

std::vector<std::string> PluginRegistry::ids() const {
  std::set<std::string> found(own_.begin(), own_.end());
  for (const fs::path& folder : folders_) {
    // A folder that can't be read has no plugins; find() says so where it matters.
    std::error_code ignored;
    for (const auto& entry : fs::directory_iterator(folder, ignored)) {
      if (entry.path().extension() == ".so" && !entry.is_directory(ignored)) {
        found.insert(entry.path().stem());
      }
    }
  }
  return {found.begin(), found.end()};
}

std::shared_ptr<const Device> make_device(const PluginInfo& info,
                                          const ParamValues& params) {
  const std::string plugin = std::string("plugin '") + info.id + '\'';
  Device* device = nullptr;
  try {
    device = info.create(params);
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const Unbuildable&) {
    throw;
  } catch (const std::exception& clash) {
    const std::string why = clash.what();
    throw Unbuildable(why.empty() ? plugin + " refuses these values without a reason"
                                  : why);
  } catch (...) {
    throw Unbuildable(plugin + " throws what isn't a std::exception");
  }
  if (!device) throw Unbuildable(plugin + " created no device");
  return std::shared_ptr<Device>(device, info.destroy);
}

}  // namespace delos

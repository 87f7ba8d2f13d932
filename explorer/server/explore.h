// The explorer: a page in the browser, on this machine only.
#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <string>

#include "delos/plugin/registry.h"

namespace delos::server {

struct ExploreOptions {
  std::filesystem::path scene;  ///< offered first; empty: none
  unsigned short port = 0;      ///< of 127.0.0.1; 0: a free one
  int threads = 0;              ///< of an evaluation; 0: one a core
};

/// Serve until it is to stop.
/// @param stop looked at ten times a second
/// @param listening called once with the address, "http://127.0.0.1:8042/"
/// @throws std::system_error the port can't be had
void explore(const ExploreOptions& options, PluginRegistry& plugins,
             const std::atomic<bool>& stop,
             const std::function<void(const std::string& address)>& listening);

}  // namespace delos::server

// Runs the built program as a user would, in time that is bounded.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "support/folder.h"

namespace delos::test {

using Json = nlohmann::json;

/// A file's bytes; empty where there is none.
std::string read_file(const std::filesystem::path& file);

/// A scene of the source tree: "01-acoustic".
std::string scene(const std::string& name);

/// What a run left behind.
struct Finished {
  int code = -1;  ///< exit code; 128 + the signal that ended it
  std::string out, err;

  /// The whole of stdout as one document; fails the test where it isn't.
  [[nodiscard]] Json json() const;
};

/// The program at work; killed where it outlives this object.
class Running {
 public:
  /// @param at working folder; empty: the test's
  /// @param out where stdout goes; empty: a file of this object
  explicit Running(const std::vector<std::string>& arguments,
                   const std::filesystem::path& at = {}, std::string out = {});
  ~Running();
  Running(const Running&) = delete;
  Running& operator=(const Running&) = delete;

  void send(int signal) const;
  [[nodiscard]] pid_t pid() const { return pid_; }
  /// What it wrote to stderr so far.
  [[nodiscard]] std::string err() const;
  [[nodiscard]] bool ended();
  /// Wait for its end, two minutes at most.
  Finished wait();

 private:
  Folder streams_;
  pid_t pid_ = -1;
  int status_ = 0;
};

/// Run it to its end.
Finished run(const std::vector<std::string>& arguments,
             const std::filesystem::path& at = {}, const std::string& out = {});

}  // namespace delos::test

#include "program.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <thread>

extern char** environ;

namespace delos::test {
namespace {

constexpr std::chrono::minutes kLongest{2};

/// The test's own, with nothing that changes where plugins are looked for. What
/// Fontconfig keeps to the end counts as no leak of the program's.
std::vector<std::string> environment() {
  std::vector<std::string> all = {
      "LSAN_OPTIONS=print_suppressions=0:suppressions=" DELOS_LEAK_SUPPRESSIONS};
  for (char** entry = environ; *entry != nullptr; ++entry) {
    const std::string text = *entry;
    if (text.rfind("DELOS_PLUGIN_PATH=", 0) == 0) continue;
    if (text.rfind("LSAN_OPTIONS=", 0) == 0) continue;
    all.push_back(text);
  }
  return all;
}

std::vector<char*> pointers(std::vector<std::string>& texts) {
  std::vector<char*> list;
  for (std::string& text : texts) list.push_back(text.data());
  list.push_back(nullptr);
  return list;
}

}  // namespace

std::string read_file(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

std::string scene(const std::string& name) {
  return std::string(DELOS_SCENES) + "/" + name + ".yaml";
}

Json Finished::json() const {
  Json document = Json::parse(out, nullptr, false);
  EXPECT_FALSE(document.is_discarded()) << "not one JSON document:\n" << out << err;
  return document;
}

Running::Running(const std::vector<std::string>& arguments,
                 const std::filesystem::path& at, std::string out) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  if (out.empty()) out = (streams_.path() / "out").string();
  const std::string err = (streams_.path() / "err").string();
  const int flags = O_WRONLY | O_CREAT | O_TRUNC;
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, out.c_str(), flags, 0600);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, err.c_str(), flags, 0600);
  if (!at.empty()) posix_spawn_file_actions_addchdir_np(&actions, at.c_str());

  std::vector<std::string> words = {DELOS_PROGRAM};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<std::string> settings = environment();
  const int error = posix_spawn(&pid_, DELOS_PROGRAM, &actions, nullptr,
                                pointers(words).data(), pointers(settings).data());
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0) throw std::runtime_error("can't start " DELOS_PROGRAM);
}

Running::~Running() {
  if (ended()) return;
  send(SIGKILL);
  waitpid(pid_, &status_, 0);
}

void Running::send(int signal) const { kill(pid_, signal); }

std::string Running::err() const { return read_file(streams_.path() / "err"); }

bool Running::ended() {
  if (pid_ > 0 && waitpid(pid_, &status_, WNOHANG) == pid_) pid_ = -1;
  return pid_ < 0;
}

Finished Running::wait() {
  const auto last = std::chrono::steady_clock::now() + kLongest;
  while (!ended() && std::chrono::steady_clock::now() < last) {
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  if (!ended()) {
    ADD_FAILURE() << "the program didn't end in two minutes";
    return {};
  }
  Finished finished;
  finished.code = WIFEXITED(status_) ? WEXITSTATUS(status_) : 128 + WTERMSIG(status_);
  finished.out = read_file(streams_.path() / "out");
  finished.err = read_file(streams_.path() / "err");
  return finished;
}

Finished run(const std::vector<std::string>& arguments, const std::filesystem::path& at,
             const std::string& out) {
  return Running(arguments, at, out).wait();
}

}  // namespace delos::test

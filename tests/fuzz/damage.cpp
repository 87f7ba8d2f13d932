#include "fuzz/damage.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>
#ifdef __SANITIZE_ADDRESS__
#include <sanitizer/common_interface_defs.h>
#endif

#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <random>

namespace delos::fuzz {
namespace {

// For the handler of signals, which may neither allocate nor wait.
std::string g_file, g_text;

void leave_text() {
  const int file = open(g_file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  if (file < 0) return;
  if (write(file, g_text.data(), g_text.size()) < 0) return;
  close(file);
}

void die(int signal) {
  leave_text();
  ::signal(signal, SIG_DFL);
  raise(signal);
}

/// Leave the text whichever way this process ends.
void watch(const std::string& name) {
  g_file = "fuzz-" + name;
#ifdef __SANITIZE_ADDRESS__
  __sanitizer_set_death_callback(leave_text);  // it reports signals itself
  ::signal(SIGALRM, die);
#else
  for (const int signal : {SIGSEGV, SIGABRT, SIGFPE, SIGBUS, SIGALRM})
    ::signal(signal, die);
#endif
}

double setting(const char* name, double otherwise) {
  const char* text = std::getenv(name);
  return text ? std::atof(text) : otherwise;
}

/// Numbers that readers stumble over.
const std::vector<std::string> kNumbers = {
    "0",     "-1",   "1e308",      "-1e-320",
    "1e999", "nan",  "inf",        "007",
    "1.",    "0x10", "2147483648", "4294967295",
    "-0",    "1e",   "+",          "9999999999999999999"};

class Damager {
 public:
  Damager(const std::vector<std::string>& seeds, const std::vector<std::string>& words,
          unsigned seed)
      : seeds_(seeds), words_(words), random_(seed) {
    words_.insert(words_.end(), kNumbers.begin(), kNumbers.end());
  }

  std::string operator()() {
    std::string text = any(seeds_);
    for (std::size_t edits = 1 + upto(3); edits > 0; --edits) edit(text);
    return text;
  }

 private:
  std::size_t upto(std::size_t n) {
    return static_cast<std::size_t>(random_() % (n + 1));
  }
  const std::string& any(const std::vector<std::string>& of) {
    return of[upto(of.size() - 1)];
  }

  void edit(std::string& text) {
    constexpr char kLiteral[] =
        "[]{}:,-#&*!|>'\"%@`~?.0123456789eE+xn \n\t\r\\/\0\xff\xc3";
    static const std::string kBytes(kLiteral, sizeof kLiteral - 1);
    const std::size_t at = upto(text.size());
    const char byte =
        upto(3) > 0 ? kBytes[upto(kBytes.size() - 1)] : static_cast<char>(upto(255));
    switch (upto(7)) {
      case 0:
        if (at < text.size()) text[at] = byte;
        return;
      case 1:
        text.erase(at, 1 + upto(8));
        return;
      case 2:
        text.insert(at, 1, byte);
        return;
      case 3:
        text.insert(at, text.substr(upto(text.size()), 1 + upto(40)));
        return;
      case 4: {
        const std::string& other = any(seeds_);
        text.insert(at, other.substr(upto(other.size()), 1 + upto(60)));
        return;
      }
      case 5:
        text.resize(at);
        return;
      case 6:
        text.insert(at, any(words_));
        return;
      default: {
        // Another number in the place of one.
        const std::size_t first = text.find_first_of("0123456789", at);
        if (first == std::string::npos) return;
        const std::size_t end = text.find_first_not_of("0123456789.", first);
        text.replace(first, std::min(end, text.size()) - first, any(words_));
      }
    }
  }

  const std::vector<std::string>& seeds_;
  std::vector<std::string> words_;
  std::mt19937 random_;
};

}  // namespace

void damage(const std::string& name, const std::vector<std::string>& seeds,
            const std::vector<std::string>& words, const Taker& take) {
  for (const std::string& seed : seeds) ASSERT_EQ(take(seed), "") << seed;
  watch(name);
  const double seconds = setting("DELOS_FUZZ_SECONDS", 2);
  Damager damaged(seeds, words, static_cast<unsigned>(setting("DELOS_FUZZ_SEED", 1)));
  const std::clock_t start = std::clock();
  const auto spent = [&] {
    return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  };
  std::size_t count = 0;
  for (; spent() < seconds; ++count) {
    g_text = damaged();
    alarm(20);
    const std::string wrong = take(g_text);
    alarm(0);
    if (wrong.empty()) continue;
    leave_text();
    FAIL() << wrong << "\nafter " << count << " texts, by what is in " << g_file;
  }
  testing::Test::RecordProperty("texts", static_cast<int>(count));
  EXPECT_GT(count, 20u);
}

ScratchFile::ScratchFile(const std::string& suffix)
    : path_((std::filesystem::temp_directory_path() /
             ("delos-fuzz-" + std::to_string(getpid()) + suffix))
                .string()) {}

ScratchFile::~ScratchFile() {
  std::error_code ignored;
  std::filesystem::remove(path_, ignored);
}

void ScratchFile::write(std::string_view bytes) const {
  std::ofstream(path_, std::ios::binary) << bytes;
}

}  // namespace delos::fuzz

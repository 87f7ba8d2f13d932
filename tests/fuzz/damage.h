// Damages files at random: what a reader makes of them is either good or refused.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace delos::fuzz {

/// What takes a text and says what is wrong with how it was taken; empty: nothing.
using Taker = std::function<std::string(const std::string& text)>;

/// Damage texts and have them taken, for DELOS_FUZZ_SECONDS (2) of processor time, with
/// the seed DELOS_FUZZ_SEED (1). What was being taken when a test fails, or the program
/// ends or hangs for 20 s, is left in the file fuzz-<name>.
/// @param seeds texts that are taken well
/// @param words that are put in now and then, of which a reader makes much
void damage(const std::string& name, const std::vector<std::string>& seeds,
            const std::vector<std::string>& words, const Taker& take);

/// A file of this process's own; its suffix tells readers the format.
class ScratchFile {
 public:
  explicit ScratchFile(const std::string& suffix);
  ~ScratchFile();
  ScratchFile(const ScratchFile&) = delete;
  ScratchFile& operator=(const ScratchFile&) = delete;

  void write(std::string_view bytes) const;
  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  std::string path_;
};

}  // namespace delos::fuzz

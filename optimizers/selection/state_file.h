// A selection that is kept in a file.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "selection/branch_and_bound.h"

namespace delos {

/// What a file of a selection is about: it may only go on with the same.
struct SelectionKey {
  std::string scene;  ///< as YAML
  std::size_t samples = 0;
  std::uint64_t seed = 1;
};

/// An SQLite file with the state of a search. Each save is one transaction, with a
/// checksum: bounds are proofs, but which nodes were closed can't be told any more.
class SelectionFile {
 public:
  /// Open it, or make it.
  /// @throws std::runtime_error it can't be, or it is about another selection
  SelectionFile(const std::filesystem::path& file, const SelectionKey& key);
  ~SelectionFile();

  /// Where the search was; nullopt: it hasn't begun.
  /// @throws std::runtime_error the file is damaged: it isn't what was saved, or no
  ///         state of a search by these rules
  [[nodiscard]] std::optional<BranchState> load(
      ChoiceCost& cost, const ChoiceRules& rules,
      const std::vector<Decision>& decisions) const;
  /// @throws std::runtime_error the disk is full, …; the last state stays then
  void save(const BranchState& state);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace delos

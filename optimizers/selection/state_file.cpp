#include "selection/state_file.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <stdexcept>

#include "selection/exchange.h"
#include "study/database.h"

namespace delos {
namespace {

constexpr const char* kSelectionTables =
    "CREATE TABLE selection (scene TEXT, samples INTEGER, seed INTEGER);"
    "CREATE TABLE selection_state (best TEXT, cost REAL, closed REAL, nodes INTEGER,"
    " root_w BLOB, root_value REAL, root_bound REAL, if_in BLOB, if_out BLOB,"
    " checksum INTEGER);"
    "CREATE TABLE selection_node (bound REAL, number INTEGER, decisions TEXT, w BLOB);";

/// One character a candidate.
std::string as_text(const std::vector<Decision>& decisions) {
  std::string text;
  for (const Decision d : decisions)
    text += d == Decision::in ? '1' : d == Decision::out ? '0' : '?';
  return text;
}

std::vector<Decision> as_decisions(const std::string& text) {
  std::vector<Decision> decisions;
  for (const char c : text)
    decisions.push_back(c == '1'   ? Decision::in
                        : c == '0' ? Decision::out
                                   : Decision::open);
  return decisions;
}

/// Fowler, Noll and Vo's FNV-1a of all that a state holds, 64 bits.
class Checksum {
 public:
  explicit Checksum(const BranchState& state) {
    add(state.best.chosen);
    add(state.best.cost);
    add(state.closed);
    add(state.nodes);
    add(state.root.w);
    add(state.root.value);
    add(state.root.bound);
    add(state.root.linear.if_in);
    add(state.root.linear.if_out);
    add(state.open.size());
    for (const BranchNode& node : state.open) {
      add(node.bound);
      add(node.number);
      add(node.decisions);
      add(node.w);
    }
  }
  [[nodiscard]] std::int64_t value() const { return static_cast<std::int64_t>(sum_); }

 private:
  template <class T>
  void add(const T& number) {
    unsigned char bytes[sizeof(T)];
    std::memcpy(bytes, &number, sizeof(T));
    for (const unsigned char byte : bytes)
      sum_ = (sum_ ^ byte) * std::uint64_t{0x100000001b3};
  }
  template <class T>
  void add(const std::vector<T>& list) {
    add(list.size());
    for (const T& item : list) add(item);
  }

  std::uint64_t sum_ = 0xcbf29ce484222325;
};

/// Whether there are n numbers from 0 to `most`, but for rounding.
bool are_numbers(const std::vector<double>& list, std::size_t n, double most) {
  return list.size() == n && std::all_of(list.begin(), list.end(), [most](double x) {
           return x >= -1e-9 && x <= most + 1e-9;
         });
}

/// Whether a choice or a node decides as was decided in advance.
template <class Differs>
bool keeps(const std::vector<Decision>& decisions, Differs&& differs) {
  for (std::size_t i = 0; i < decisions.size(); ++i)
    if (decisions[i] != Decision::open && differs(i)) return false;
  return true;
}

/// Whether a search by these rules can be in such a state.
bool is_possible(const BranchState& state, const ChoiceRules& rules,
                 const std::vector<Decision>& decisions) {
  constexpr double kAny = std::numeric_limits<double>::infinity();
  const std::size_t n = rules.size();
  const std::vector<char>& chosen = state.best.chosen;
  if (chosen.size() != n || !rules.allow(chosen) || !(state.closed >= 0) ||
      !keeps(decisions, [&](std::size_t i) {
        return (chosen[i] != 0) != (decisions[i] == Decision::in);
      }))
    return false;
  const Relaxation& root = state.root;
  if (!are_numbers(root.w, n, 1) || !are_numbers(root.linear.if_in, n, kAny) ||
      !are_numbers(root.linear.if_out, n, kAny) || !(root.bound >= 0))
    return false;
  return std::all_of(state.open.begin(), state.open.end(), [&](const BranchNode& node) {
    return node.decisions.size() == n && are_numbers(node.w, n, 1) && node.bound >= 0 &&
           node.number < state.nodes && keeps(decisions, [&](std::size_t i) {
             return node.decisions[i] != decisions[i];
           });
  });
}

}  // namespace

struct SelectionFile::State {
  Database database;
  std::filesystem::path file;
};

SelectionFile::SelectionFile(const std::filesystem::path& file,
                             const SelectionKey& key) {
  if (!std::filesystem::exists(file)) {
    // Made under another name, so that it is whole or isn't there.
    const std::filesystem::path unborn = file.string() + ".new";
    std::filesystem::remove(unborn);
    {
      const Database database(unborn, true);
      database.run("BEGIN IMMEDIATE");
      database.run(kSelectionTables);
      database.prepare("INSERT INTO selection VALUES (?, ?, ?)")
          .bind(1, key.scene)
          .bind(2, static_cast<std::int64_t>(key.samples))
          .bind(3, static_cast<std::int64_t>(key.seed))
          .step();
      database.run("COMMIT");
    }
    std::filesystem::rename(unborn, file);
  }
  state_ = std::make_unique<State>(State{Database(file, false), file});
  Statement known =
      state_->database.prepare("SELECT 1 FROM sqlite_master WHERE name = 'selection'");
  if (!known.step())
    throw std::runtime_error(file.string() + " isn't a file of a selection");
  Statement about = state_->database.prepare("SELECT * FROM selection");
  if (!about.step() || about.text(0) != key.scene ||
      about.integer(1) != static_cast<std::int64_t>(key.samples) ||
      about.integer(2) != static_cast<std::int64_t>(key.seed))
    throw std::runtime_error(
        file.string() +
        " is about another scene, seed or number of samples; choose another name");
}

SelectionFile::~SelectionFile() = default;

std::optional<BranchState> SelectionFile::load(
    ChoiceCost& cost, const ChoiceRules& rules,
    const std::vector<Decision>& decisions) const {
  Statement row = state_->database.prepare("SELECT * FROM selection_state");
  if (!row.step()) return std::nullopt;
  BranchState state;
  for (const char c : row.text(0)) state.best.chosen.push_back(c == '1');
  state.best.cost = row.real(1);
  state.closed = row.real(2);
  state.nodes = static_cast<std::size_t>(row.integer(3));
  state.root.w = row.numbers(4);
  state.root.value = row.real(5);
  state.root.bound = row.real(6);
  state.root.linear.if_in = row.numbers(7);
  state.root.linear.if_out = row.numbers(8);
  Statement node = state_->database.prepare("SELECT * FROM selection_node");
  while (node.step())
    state.open.push_back({node.real(0), static_cast<std::size_t>(node.integer(1)),
                          as_decisions(node.text(2)), node.numbers(3)});
  // What the choice costs is asked again: another version may see it otherwise.
  const bool whole =
      Checksum(state).value() == row.integer(9) && is_possible(state, rules, decisions);
  if (!whole || !(std::abs(cost_of(cost, state.best.chosen) - state.best.cost) <=
                  1e-9 * state.best.cost))
    throw std::runtime_error(state_->file.string() +
                             " is damaged, or of another version; delete it to start "
                             "again");
  return state;
}

void SelectionFile::save(const BranchState& state) {
  const Database& database = state_->database;
  database.run("BEGIN IMMEDIATE");
  try {
    database.run("DELETE FROM selection_state; DELETE FROM selection_node");
    std::string best;
    for (const char c : state.best.chosen) best += c ? '1' : '0';
    database
        .prepare("INSERT INTO selection_state VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?)")
        .bind(1, best)
        .bind(2, state.best.cost)
        .bind(3, state.closed)
        .bind(4, static_cast<std::int64_t>(state.nodes))
        .bind(5, std::span<const double>(state.root.w))
        .bind(6, state.root.value)
        .bind(7, state.root.bound)
        .bind(8, std::span<const double>(state.root.linear.if_in))
        .bind(9, std::span<const double>(state.root.linear.if_out))
        .bind(10, Checksum(state).value())
        .step();
    for (const BranchNode& node : state.open)
      database.prepare("INSERT INTO selection_node VALUES (?, ?, ?, ?)")
          .bind(1, node.bound)
          .bind(2, static_cast<std::int64_t>(node.number))
          .bind(3, as_text(node.decisions))
          .bind(4, std::span<const double>(node.w))
          .step();
    database.run("COMMIT");
  } catch (...) {
    database.run("ROLLBACK");
    throw;
  }
}

}  // namespace delos

#include "selection/state_file.h"

#include <stdexcept>

#include "study/database.h"

namespace delos {
namespace {

constexpr const char* kTables =
    "CREATE TABLE selection (scene TEXT, samples INTEGER, seed INTEGER);"
    "CREATE TABLE selection_state (best TEXT, cost REAL, closed REAL, nodes INTEGER,"
    " root_w BLOB, root_value REAL, root_bound REAL, if_in BLOB, if_out BLOB);"
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

}  // namespace

struct SelectionFile::State {
  Database database;
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
      database.run(kTables);
      database.prepare("INSERT INTO selection VALUES (?, ?, ?)")
          .bind(1, key.scene)
          .bind(2, static_cast<std::int64_t>(key.samples))
          .bind(3, static_cast<std::int64_t>(key.seed))
          .step();
      database.run("COMMIT");
    }
    std::filesystem::rename(unborn, file);
  }
  state_ = std::make_unique<State>(State{Database(file, false)});
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

std::optional<BranchState> SelectionFile::load() const {
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
  return state;
}

void SelectionFile::save(const BranchState& state) {
  const Database& database = state_->database;
  database.run("BEGIN IMMEDIATE");
  try {
    database.run("DELETE FROM selection_state; DELETE FROM selection_node");
    std::string best;
    for (const char c : state.best.chosen) best += c ? '1' : '0';
    database.prepare("INSERT INTO selection_state VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?)")
        .bind(1, best)
        .bind(2, state.best.cost)
        .bind(3, state.closed)
        .bind(4, static_cast<std::int64_t>(state.nodes))
        .bind(5, std::span<const double>(state.root.w))
        .bind(6, state.root.value)
        .bind(7, state.root.bound)
        .bind(8, std::span<const double>(state.root.linear.if_in))
        .bind(9, std::span<const double>(state.root.linear.if_out))
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

// What a kept selection says is checked before it is believed.
#include <gtest/gtest.h>

#include <numeric>

#include "delos/optimize/select.h"
#include "optimizers/scenes.h"
#include "selection/state_file.h"
#include "study/database.h"
#include "support/folder.h"

namespace delos::test {
namespace {

/// Three of six anchors. @param nodes after which to stop
SelectResult chosen_anchors(const std::filesystem::path& study, std::size_t nodes) {
  static const Scene scene = parse(kOneTarget + R"(devices:
  - {name: a, type: uwb_range, rate: 10 Hz, at: [0, 0, 2], params: &u {sigma: 10 cm}}
  - {name: b, type: uwb_range, rate: 10 Hz, at: [5, 5, 0], params: *u}
  - {name: c, type: uwb_range, rate: 10 Hz, at: [1, 5, 1], params: *u}
  - {name: d, type: uwb_range, rate: 10 Hz, at: [5, 0, 3], params: *u}
  - {name: e, type: uwb_range, rate: 10 Hz, at: [3, -4, 1], params: *u}
  - {name: f, type: uwb_range, rate: 10 Hz, at: [-3, 4, -2], params: *u}
objective: {minimize: mean, of: eigmax}
selection: {count: 3, candidates: [{devices: "*"}]}
)");
  SelectOptions options;
  options.gap = 0;
  std::atomic<bool> cancel = false;
  options.cancel = &cancel;
  options.progress = [&](const SelectProgress& at) { cancel = at.nodes >= nodes; };
  options.threads = 1;
  options.study = study;
  return select(scene, plugins(), options);
}

TEST(KeptSelections, AreRefusedWhereTheirFileWasChanged) {
  const Folder folder;
  const auto kept = folder / "kept", edited = folder / "edited";
  EXPECT_EQ(chosen_anchors(kept, 1).stop, SelectStop::cancelled);
  std::vector<std::string> edits = {
      "UPDATE selection_state SET best = ''",
      "UPDATE selection_state SET best = '1'",
      "UPDATE selection_state SET best = '111111'",
      "UPDATE selection_state SET best = best || '1'",
      "UPDATE selection_state SET best = 3.5",
      "UPDATE selection_state SET best = '101010'",
      "DELETE FROM selection_node",
      "INSERT INTO selection_node SELECT * FROM selection_node",
      "UPDATE selection_node SET decisions = ''",
      "UPDATE selection_node SET decisions = substr(decisions, 1, 3)",
      "UPDATE selection_node SET decisions = decisions || '?'",
      "UPDATE selection_node SET decisions = '000000'",
      "UPDATE selection_node SET decisions = NULL"};
  const auto each = [&](const std::string& table, const std::string& column,
                        const std::vector<std::string>& values) {
    for (const std::string& value : values)
      edits.push_back("UPDATE " + table + " SET " + column + " = " + value);
  };
  for (const char* column : {"root_w", "if_in", "if_out"}) {
    const std::string name = column;
    each("selection_state", name,
         {"x''", "substr(" + name + ", 1, 8)", "substr(" + name + ", 1, 45)",
          "zeroblob(4800)", "'many'", "7", "NULL"});
  }
  each("selection_node", "w",
       {"x''", "substr(w, 1, 8)", "substr(w, 1, 45)", "zeroblob(4800)", "'many'", "7",
        "NULL"});
  for (const char* column : {"cost", "closed", "nodes", "root_value", "root_bound"})
    each("selection_state", column, {"0", "1e9", "-1", "'many'", "NULL", "x''"});
  each("selection_node", "bound", {"1e9", "-1", "'9'", "NULL"});
  each("selection_node", "number", {"1e9", "-1", "'9'"});  // it is 0
  each("selection_state", "checksum", {"0", "NULL"});

  for (const std::string& edit : edits) {
    SCOPED_TRACE(edit);
    std::filesystem::copy_file(kept, edited,
                               std::filesystem::copy_options::overwrite_existing);
    {
      const Database database(edited, false);
      database.run(edit.c_str());
      // Into the file itself, so that no log is left to a copy.
      database.run("PRAGMA journal_mode = DELETE");
    }
    try {
      (void)chosen_anchors(edited, 1000);
      ADD_FAILURE() << "isn't refused";
    } catch (const std::runtime_error& refusal) {
      EXPECT_NE(std::string(refusal.what()).find("edited is damaged"),
                std::string::npos)
          << refusal.what();
    }
    for (const char* log : {"edited-wal", "edited-shm"})
      std::filesystem::remove(folder / log);
  }
  // As it was, it goes on, and ends where a search without a file does.
  const SelectResult whole = chosen_anchors({}, 1000),
                     resumed = chosen_anchors(kept, 1000);
  EXPECT_EQ(resumed.stop, SelectStop::proven);
  EXPECT_EQ(resumed.chosen, whole.chosen);
  EXPECT_NEAR(resumed.lower_bound, whole.lower_bound, 1e-6 * whole.lower_bound);
}

/// 10 − Σ w.
class TenLess final : public ChoiceCost {
 public:
  [[nodiscard]] std::size_t size() const override { return 3; }
  [[nodiscard]] double value(std::span<const double> w) override {
    return 10 - std::accumulate(w.begin(), w.end(), 0.0);
  }
  [[nodiscard]] std::vector<double> changed(std::span<const char>,
                                            std::span<const Change>) override {
    return {};
  }
  bool tangent(std::span<const double>, double, Tangent&) override { return false; }
  [[nodiscard]] const std::vector<std::size_t>& whole_ones() const override {
    return none_;
  }
  void exclude(std::span<const char>) override {}

 private:
  std::vector<std::size_t> none_;
};

// A checksum says only that a file is as it was written.
TEST(KeptSelections, AreRefusedWhereNoSearchCanBe) {
  const Folder folder;
  TenLess cost;
  const ChoiceRules rules{{1, 1, 1}, {-1, -1, -1}, 2};
  const std::vector<Decision> decisions = {Decision::open, Decision::in,
                                           Decision::open};
  BranchState good;
  good.best = {{1, 1, 0}, 8};
  good.closed = 8;
  good.nodes = 3;
  good.root.w = {0.5, 1, 0.5};
  good.root.bound = 8;
  good.root.linear = {0, {0, 0, 0}, {1, 0, 1}};
  good.open = {{8, 2, {Decision::out, Decision::in, Decision::open}, {0, 1, 1}}};
  int files = 0;
  const auto loaded = [&](const std::function<void(BranchState&)>& change) {
    BranchState state = good;
    change(state);
    SelectionFile file(folder / std::to_string(files++), {"a scene", 1, 1});
    file.save(state);
    try {
      return file.load(cost, rules, decisions).has_value();
    } catch (const std::runtime_error&) {
      return false;
    }
  };
  EXPECT_TRUE(loaded([](BranchState&) {}));
  const std::vector<std::function<void(BranchState&)>> changes = {
      [](BranchState& s) { s.best.chosen = {}; },
      [](BranchState& s) {
        s.best.chosen = {1, 1};
      },
      [](BranchState& s) {
        s.best = {{1, 1, 1}, 7};
      },
      [](BranchState& s) {
        s.best = {{1, 0, 1}, 8};
      },
      [](BranchState& s) { s.best.cost = 0; },
      [](BranchState& s) { s.best.cost = 9; },
      [](BranchState& s) { s.closed = -1; },
      [](BranchState& s) { s.closed = std::nan(""); },
      [](BranchState& s) { s.root.w.pop_back(); },
      [](BranchState& s) { s.root.w[0] = 2; },
      [](BranchState& s) { s.root.w[0] = std::nan(""); },
      [](BranchState& s) { s.root.bound = std::nan(""); },
      [](BranchState& s) { s.root.linear.if_in = {}; },
      [](BranchState& s) { s.root.linear.if_out.pop_back(); },
      [](BranchState& s) { s.root.linear.if_out[0] = -1; },
      [](BranchState& s) { s.open[0].w = {}; },
      [](BranchState& s) { s.open[0].w[1] = -1; },
      [](BranchState& s) { s.open[0].decisions.pop_back(); },
      [](BranchState& s) { s.open[0].decisions[1] = Decision::open; },
      [](BranchState& s) { s.open[0].bound = -1; },
      [](BranchState& s) { s.open[0].number = 3; }};
  for (std::size_t i = 0; i < changes.size(); ++i)
    EXPECT_FALSE(loaded(changes[i])) << i;
}

}  // namespace
}  // namespace delos::test

// Problems too large to enumerate, against GLPK: its linear relaxation bounds ours, its
// optimum is ours.
#include <glpk.h>
#include <gtest/gtest.h>

#include <map>
#include <memory>

#include "cover/instances.h"
#include "cover/lagrangian.h"

namespace delos::test {
namespace {

using Program = std::unique_ptr<glp_prob, decltype(&glp_delete_prob)>;

Program program_of(const CoverProblem& p) {
  Program lp(glp_create_prob(), &glp_delete_prob);
  std::map<int, std::vector<int>> groups;
  for (int j = 0; j < p.candidates() && !p.group.empty(); ++j)
    if (p.group[j] >= 0) groups[p.group[j]].push_back(j);
  glp_add_rows(lp.get(), p.samples + static_cast<int>(groups.size()));
  glp_add_cols(lp.get(), p.candidates());
  for (int i = 0; i < p.samples; ++i)
    glp_set_row_bnds(lp.get(), i + 1, GLP_LO, p.demand[i], 0);
  for (int j = 0; j < p.candidates(); ++j) {
    glp_set_col_kind(lp.get(), j + 1, GLP_BV);
    glp_set_obj_coef(lp.get(), j + 1, p.cost[j]);
    std::vector<int> rows = {0};
    for (auto k = p.start[j]; k < p.start[j + 1]; ++k) rows.push_back(p.seen[k] + 1);
    const std::vector<double> ones(rows.size(), 1);
    glp_set_mat_col(lp.get(), j + 1, static_cast<int>(rows.size()) - 1, rows.data(),
                    ones.data());
  }
  int row = p.samples;
  for (const auto& [group, members] : groups) {
    glp_set_row_bnds(lp.get(), ++row, GLP_UP, 0, 1);
    std::vector<int> columns = {0};
    for (const int j : members) columns.push_back(j + 1);
    const std::vector<double> ones(columns.size(), 1);
    glp_set_mat_row(lp.get(), row, static_cast<int>(members.size()), columns.data(),
                    ones.data());
  }
  return lp;
}

double relaxed(glp_prob* lp) {
  glp_smcp options;
  glp_init_smcp(&options);
  options.msg_lev = GLP_MSG_OFF;
  EXPECT_EQ(glp_simplex(lp, &options), 0);
  return glp_get_obj_val(lp);
}

double whole(glp_prob* lp) {
  glp_iocp options;
  glp_init_iocp(&options);
  options.msg_lev = GLP_MSG_OFF;
  options.presolve = GLP_ON;
  EXPECT_EQ(glp_intopt(lp, &options), 0);
  return glp_mip_obj_val(lp);
}

CoverProblem instance(int seed) {
  Variety variety{.samples = 50, .candidates = 80, .density = 0.08};
  variety.most_demand = 1 + seed % 2;
  variety.costs = seed % 3 > 0;
  variety.whole = seed % 3 == 1;
  variety.groups = seed % 4 == 3;
  return random_cover(variety, 1000 + seed);
}

TEST(Glpk, LagrangianIsCloseBelowTheLinearRelaxation) {
  int looked_at = 0;
  for (int seed = 0; seed < 24; ++seed) {
    const CoverProblem problem = instance(seed);
    if (!uncoverable(problem).empty()) continue;
    const double linear = relaxed(program_of(problem).get());
    const CoverCore core = core_of(problem);
    Lagrangian dual(core);
    for (int k = 0; k < 20000 && !dual.settled(); ++k) dual.step(1.1 * linear);
    EXPECT_LE(dual.bound(), linear + 1e-7) << seed;
    EXPECT_GE(dual.bound(), 0.98 * linear) << seed;
    ++looked_at;
  }
  EXPECT_GE(looked_at, 12);
}

TEST(Glpk, FindsNoCheaperCover) {
  int looked_at = 0;
  for (int seed = 0; seed < 60; ++seed) {
    const CoverProblem problem = instance(seed);
    if (!uncoverable(problem).empty()) continue;
    CoverOptions options;
    options.seconds = 1e9;  // a busy machine proves them too
    options.threads = 1;
    const CoverAnswer answer = solve_cover(problem, options);
    ASSERT_EQ(answer.stop, CoverStop::proven) << seed;
    EXPECT_TRUE(is_cover(problem, answer.chosen)) << seed;
    EXPECT_NEAR(answer.cost, whole(program_of(problem).get()), 1e-6) << seed;
    ++looked_at;
  }
  EXPECT_GE(looked_at, 30);
}

}  // namespace
}  // namespace delos::test

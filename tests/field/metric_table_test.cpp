// Every row of the table of metrics against what it says of itself, on random
// covariances.
#include "delos/model/metric_table.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "delos/model/lanes.h"

namespace delos {
namespace {

class MetricTable : public ::testing::Test {
 protected:
  /// n×n, with eigenvalues over some decades, none near 0.
  StateMatrix covariance() {
    const int n = layout_.size();
    StateMatrix X(n, 2 * n);
    for (double& x : X.reshaped()) x = normal_(random_);
    for (int i = 0; i < n; ++i) X.row(i) *= std::pow(10, i / (2.0 * n) - 0.25);
    return X * X.transpose() / n;
  }
  StateMatrix change() {
    StateMatrix X(layout_.size(), layout_.size());
    for (double& x : X.reshaped()) x = normal_(random_);
    return X + X.transpose();
  }

  /// body(row, metric) of the first three metrics of each row that reads P.
  template <class Body>
  void each_metric(Body&& body) {
    std::size_t rows = 0;
    for (const PoseState pose : {PoseState::pose, PoseState::orientation,
                                 PoseState::planar, PoseState::planar_pose}) {
      layout_ = {.pose = pose, .order = 2, .extra = {}};
      for (const std::string& name : metric_names(layout_)) {
        const Metric metric = std::get<Metric>(parse_metric(name, layout_));
        const MetricRow& row = row_of(metric.kind);
        if (!row.value) continue;
        SCOPED_TRACE(name);
        body(row, metric);
        ++rows;
      }
    }
    // Deviations of the states, and the others.
    EXPECT_EQ(rows, 12u + 8 + 6 + 6 + 4 + 7 + 6 + 8);
  }

  StateLayout layout_;
  std::mt19937_64 random_{20071};
  std::normal_distribution<double> normal_;
};

TEST_F(MetricTable, SlopesAreCentralDifferences) {
  each_metric([&](const MetricRow& row, const Metric& metric) {
    const auto [first, size] = place_of(metric, layout_);
    for (int i = 0; i < 10; ++i) {
      const StateMatrix P = covariance(), D = change();
      const double h = 1e-6;
      const StateMatrix up = P + h * D, down = P - h * D;
      const double weight = 0.7;
      StateMatrix Y = StateMatrix::Zero(P.rows(), P.cols());
      const double value = smooth_metric(metric, layout_, P, weight, &Y);
      EXPECT_EQ(value, smooth_metric(metric, layout_, P, 0, nullptr));
      const double difference = (smooth_metric(metric, layout_, up, 0, nullptr) -
                                 smooth_metric(metric, layout_, down, 0, nullptr)) /
                                (2 * h);
      // The rounding of a difference is ε value/h.
      EXPECT_NEAR(Y.cwiseProduct(D).sum(), weight * difference,
                  1e-6 * Y.norm() * D.norm() + 1e-9 * value);

      const auto block = [&](const StateMatrix& of) {
        return StateMatrix(of.block(first, first, size, size));
      };
      MetricParts parts, above, below;
      row.parts(block(P), true, parts);
      row.parts(block(up), false, above);
      row.parts(block(down), false, below);
      for (int k = 0; k < parts.count; ++k)
        EXPECT_NEAR(parts.slope[k].cwiseProduct(block(D)).sum(),
                    (above.value[k] - below.value[k]) / (2 * h),
                    1e-6 * parts.slope[k].norm() * D.norm() + 1e-9 * parts.value[k]);
    }
  });
}

TEST_F(MetricTable, AMetricIsTheLargestOfItsPartsOrItsRoot) {
  each_metric([&](const MetricRow& row, const Metric& metric) {
    const StateMatrix P = covariance();
    const auto [first, size] = place_of(metric, layout_);
    MetricParts parts;
    row.parts(P.block(first, first, size, size), false, parts);
    const double phi = *std::max_element(parts.value, parts.value + parts.count);
    const double value = metric_value(metric, layout_, P);
    EXPECT_DOUBLE_EQ(variance_value(metric, layout_, P), phi);
    EXPECT_DOUBLE_EQ(value, row.root ? std::sqrt(phi) : phi);
    // 3^(1/2p), where all three eigenvalues are one.
    EXPECT_GE(smooth_metric(metric, layout_, P, 0, nullptr), value * (1 - 1e-15));
    EXPECT_LE(smooth_metric(metric, layout_, P, 0, nullptr), 1.035 * value);
  });
}

TEST_F(MetricTable, ConvexRowsLieBelowTheirChordsAndTheOthersDoNot) {
  each_metric([&](const MetricRow& row, const Metric& metric) {
    int above = 0;
    for (int i = 0; i < 200; ++i) {
      const StateMatrix A = covariance(), B = covariance(), middle = (A + B) / 2;
      const double chord =
          (variance_value(metric, layout_, A) + variance_value(metric, layout_, B)) / 2;
      if (variance_value(metric, layout_, middle) > chord * (1 + 1e-12)) ++above;
    }
    EXPECT_EQ(above > 0, !row.convex) << above;
  });
}

TEST_F(MetricTable, MoreUncertaintyIsNeverBetter) {
  each_metric([&](const MetricRow& row, const Metric& metric) {
    EXPECT_EQ(metric.larger_is_better, row.larger_is_better);
    for (int i = 0; i < 50; ++i) {
      const StateMatrix P = covariance();
      StateVector v(layout_.size());
      for (double& x : v) x = normal_(random_);
      const double before = metric_value(metric, layout_, P),
                   after = metric_value(metric, layout_, P + v * v.transpose());
      EXPECT_LT(row.larger_is_better ? after : before,
                row.larger_is_better ? before : after);
    }
  });
}

TEST_F(MetricTable, NothingOutsideItsBlockMatters) {
  each_metric([&](const MetricRow&, const Metric& metric) {
    const StateMatrix P = covariance();
    const auto [first, size] = place_of(metric, layout_);
    StateMatrix other = StateMatrix::Identity(P.rows(), P.cols());
    other.block(first, first, size, size) = P.block(first, first, size, size);
    EXPECT_EQ(metric_value(metric, layout_, other), metric_value(metric, layout_, P));
    const bool within = first + size <= layout_.coordinates();
    EXPECT_EQ(need_of(metric, layout_) == MetricNeed::pose_block, within);
  });
}

TEST_F(MetricTable, LanesAreTheSameBitForBit) {
  each_metric([&](const MetricRow&, const Metric& metric) {
    if (need_of(metric, layout_) != MetricNeed::pose_block) return;
    const int d = layout_.coordinates();
    std::vector<double> packed(static_cast<std::size_t>(packed_index(d, 0)) * kLanes);
    std::vector<StateMatrix> all;
    for (int l = 0; l < kLanes; ++l) {
      all.push_back(covariance());
      for (int i = 0; i < d; ++i)
        for (int j = 0; j <= i; ++j)
          packed[static_cast<std::size_t>(packed_index(i, j) * kLanes + l)] =
              all.back()(i, j);
    }
    double values[kLanes];
    metric_values(metric, layout_, packed.data(), values);
    for (std::size_t l = 0; l < kLanes; ++l)
      EXPECT_EQ(values[l],
                metric_value(metric, layout_, all[l].selfadjointView<Eigen::Lower>()));
  });
}

TEST(MetricRows, ListEveryKindOnceAndReadNothingOfPWhereTheyHaveNoValue) {
  int count = 0;
  for (const MetricRow& row : metric_table()) {
    EXPECT_EQ(&row_of(row.kind), &row);
    EXPECT_EQ(row.value == nullptr, row.parts == nullptr);
    const bool reads = row.reads != MetricReads::devices &&
                       row.reads != MetricReads::closed_loop &&
                       row.reads != MetricReads::readings;
    EXPECT_EQ(row.value != nullptr, reads) << row.name;
    ++count;
  }
  EXPECT_EQ(count, static_cast<int>(MetricKind::unscented_ratio) + 1);
}

}  // namespace
}  // namespace delos

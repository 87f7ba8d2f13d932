#include "selection/field_cost.h"

#include <omp.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "delos/model/infinity.h"
#include "delos/model/lanes.h"
#include "delos/sampling/samples.h"

namespace delos {
namespace {

/// Samples that one thread takes at a time, in how many parts at most: sums run in the
/// order of the parts.
constexpr std::size_t kParts = 32;

std::vector<TargetPose> poses_of(const Samples& samples,
                                 const Orientations& orientations) {
  std::vector<TargetPose> poses;
  for (const Eigen::Vector3d& p : samples.points)
    for (const Eigen::Vector3d& rpy : orientations.rpy)
      poses.push_back({rotation_from_rpy(rpy), p});
  return poses;
}

bool reads_pose_alone(const std::vector<VarianceTerm>& terms,
                      const StateLayout& layout) {
  return std::all_of(terms.begin(), terms.end(), [&](const VarianceTerm& t) {
    return t.metric.kind != MetricKind::sigma || t.metric.state < layout.coordinates();
  });
}

/// The block of P that a metric reads: its first row and its size.
struct Block {
  Eigen::Index first, size;
};
Block block_of(const Metric& metric, const StateLayout& layout) {
  if (metric.kind == MetricKind::sigma) return {metric.state, 1};
  if (metric.kind == MetricKind::sigma_orientation) return {layout.positions(), 3};
  return {0, 3};
}

/// log Σ exp(s x) / s, and the shares exp(s x)/Σ. @pre x isn't empty
double soft_maximum(double s, std::span<const double> x, std::vector<double>& shares) {
  const double most = *std::max_element(x.begin(), x.end());
  double sum = 0;
  shares.resize(x.size());
  for (std::size_t i = 0; i < x.size(); ++i)
    sum += shares[i] = std::exp(s * (x[i] - most));
  for (double& share : shares) share /= sum;
  return most + std::log(sum) / s;
}

/// Something whose largest one counts: a value of P and ∂value/∂P over the block.
struct Atom {
  double value;
  Eigen::Matrix3d slope;
};

/// φ(P) as the largest of some atoms.
std::vector<Atom> atoms_of(const Metric& metric, const StateLayout& layout,
                           const StateMatrix& P) {
  const Block at = block_of(metric, layout);
  std::vector<Atom> atoms;
  Eigen::Matrix3d slope = Eigen::Matrix3d::Zero();
  if (at.size == 1) {
    slope(0, 0) = 1;
    return {{P(at.first, at.first), slope}};
  }
  const Eigen::Matrix3d B = P.block<3, 3>(at.first, at.first);
  switch (metric.kind) {
    case MetricKind::eigmax: {
      const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(B);
      for (int i = 0; i < 3; ++i) {
        const Eigen::Vector3d u = eigen.eigenvectors().col(i);
        atoms.push_back({eigen.eigenvalues()(i), u * u.transpose()});
      }
      return atoms;
    }
    case MetricKind::eiglen:
      return {{B.norm(), B / B.norm()}};
    default:
      return {{B.trace(), Eigen::Matrix3d::Identity()}};
  }
}

}  // namespace

std::string variance_problem(const Metric& metric) {
  switch (metric.kind) {
    case MetricKind::sigma:
    case MetricKind::sigma_position:
    case MetricKind::sigma_orientation:
    case MetricKind::eigmax:
    case MetricKind::eiglen:
    case MetricKind::trace:
      return "";
    default:
      return metric.name +
             " isn't a convex function of the covariance, so that no bound is known; "
             "use sigma_x, …, sigma_position, sigma_orientation, eigmax, eiglen or "
             "trace";
  }
}

bool is_deviation(const Metric& metric) { return metric.kind != MetricKind::trace; }

/// What one sample adds.
struct FieldCost::Sample {
  std::vector<double> smooth, level;       // terms
  std::vector<std::vector<double>> slope;  // terms: turns × packed, ∂smooth/∂S
};

FieldCost::FieldCost(const System& system, const CandidateScene& all,
                     const Samples& samples, const Orientations& orientations,
                     std::vector<VarianceTerm> terms, int threads)
    : layout_(system.motion.layout),
      combine_(orientations.combine),
      terms_(std::move(terms)),
      map_(system, !reads_pose_alone(terms_, layout_)),
      known_(
          candidate_information(system, all, poses_of(samples, orientations), threads)),
      excluded_(all.candidates.size(), 0),
      size_(all.candidates.size()),
      samples_(samples.points.size()),
      turns_(orientations.rpy.size()),
      packed_(static_cast<std::size_t>(packed_index(known_.columns, 0))),
      threads_(threads > 0 ? threads : omp_get_max_threads()) {
  std::vector<char> whole(size_, 0);
  for (const ExactRow& row : known_.exact)
    if (row.candidate >= 0) whole[static_cast<std::size_t>(row.candidate)] = 1;
  for (std::size_t c = 0; c < size_; ++c)
    if (whole[c]) whole_ones_.push_back(c);

  seen_by_.resize(size_);
  const auto sees = [&](int candidate, std::size_t sample) {
    auto& seen = seen_by_[static_cast<std::size_t>(candidate)];
    if (seen.empty() || seen.back() != sample)
      seen.push_back(static_cast<std::uint32_t>(sample));
  };
  for (std::size_t p = 0; p < known_.poses(); ++p) {
    for (std::size_t e = known_.first[p]; e < known_.first[p + 1]; ++e)
      sees(known_.candidate[e], p / turns_);
    for (std::size_t e = known_.first_exact[p]; e < known_.first_exact[p + 1]; ++e)
      if (known_.exact[e].candidate >= 0) sees(known_.exact[e].candidate, p / turns_);
  }
  const std::vector<double> everything(size_, 1.0);
  std::vector<double> values(terms_.size());
  scale_.assign(terms_.size(), std::vector<double>(samples_, 1));
  for (std::size_t s = 0; s < samples_; ++s) {
    if (!hard(everything, s, values.data())) continue;
    for (std::size_t t = 0; t < terms_.size(); ++t)
      if (values[t] > 0) scale_[t][s] = values[t];
  }
}

void FieldCost::exclude(std::span<const char> out) {
  excluded_.assign(out.begin(), out.end());
}

template <class Body>
void FieldCost::each_chunk(Body&& body) const {
  const std::size_t length = (samples_ + kParts - 1) / kParts;
  // A few poses are sooner done than shared out.
  constexpr std::size_t kWorthSharing = 256;
  const int threads = samples_ * turns_ < kWorthSharing ? 1 : threads_;
#pragma omp parallel for schedule(dynamic) num_threads(threads)
  for (std::size_t c = 0; c < kParts; ++c)
    body(c, std::min(samples_, c * length), std::min(samples_, (c + 1) * length));
}

void FieldCost::information(std::span<const double> w, std::size_t pose,
                            StateMatrix& S) const {
  double sum[packed_index(kMaxState, 0)];
  std::copy_n(&known_.always[pose * packed_], packed_, sum);
  for (std::size_t e = known_.first[pose]; e < known_.first[pose + 1]; ++e) {
    const double weight = w[static_cast<std::size_t>(known_.candidate[e])];
    if (weight == 0) continue;
    const double* of_entry = &known_.information[e * packed_];
    for (std::size_t k = 0; k < packed_; ++k) sum[k] += weight * of_entry[k];
  }
  S.resize(known_.columns, known_.columns);
  for (int i = 0; i < known_.columns; ++i)
    for (int j = 0; j <= i; ++j) S(i, j) = S(j, i) = sum[packed_index(i, j)];
}

void FieldCost::exact_rows(std::span<const double> w, bool fractions, std::size_t pose,
                           Eigen::MatrixXd& rows) const {
  rows.resize(0, known_.columns);
  for (std::size_t e = known_.first_exact[pose]; e < known_.first_exact[pose + 1];
       ++e) {
    const ExactRow& row = known_.exact[e];
    if (row.candidate >= 0) {
      const auto c = static_cast<std::size_t>(row.candidate);
      if (fractions ? excluded_[c] : w[c] < 1) continue;
    }
    rows.conservativeResize(rows.rows() + 1, known_.columns);
    rows.bottomRows(1) = row.h;
  }
}

bool FieldCost::solve(std::span<const double> w, bool fractions, std::size_t pose,
                      CovarianceMap::Solution& out) const {
  StateMatrix S;
  Eigen::MatrixXd exact;
  information(w, pose, S);
  exact_rows(w, fractions, pose, exact);
  return settles(S, exact, out);
}

bool FieldCost::settles(const StateMatrix& S, const Eigen::MatrixXd& exact,
                        CovarianceMap::Solution& out) const {
  const RiccatiStatus status = map_.solve(S, exact, out);
  if (status == RiccatiStatus::iteration_limit) unsettled_ = true;
  return status == RiccatiStatus::converged;
}

/// φ of each term at one sample; false where it isn't finite.
bool FieldCost::hard(std::span<const double> w, std::size_t sample,
                     double* values) const {
  CovarianceMap::Solution at;
  StateMatrix S, of_turn;
  Eigen::MatrixXd exact;
  std::fill_n(values, terms_.size(), 0.0);
  const bool by_information = combine_ == OrientationRule::information;
  const double share = 1 / static_cast<double>(turns_);
  if (by_information) {
    for (std::size_t t = 0; t < turns_; ++t) {
      information(w, sample * turns_ + t, of_turn);
      S = t == 0 ? StateMatrix(of_turn * share) : StateMatrix(S + of_turn * share);
    }
    exact_rows(w, false, sample * turns_, exact);
  }
  for (std::size_t t = 0; t < (by_information ? 1 : turns_); ++t) {
    const bool finite = by_information ? settles(S, exact, at)
                                       : solve(w, false, sample * turns_ + t, at);
    if (!finite) {
      std::fill_n(values, terms_.size(), kInfinity);
      return false;
    }
    for (std::size_t k = 0; k < terms_.size(); ++k) {
      double largest = 0;
      for (const Atom& atom : atoms_of(terms_[k].metric, layout_, at.P))
        largest = std::max(largest, atom.value);
      if (combine_ == OrientationRule::mean)
        values[k] += share * largest;
      else
        values[k] = std::max(values[k], largest);
    }
  }
  return true;
}

/// φ̃, its minorant and its slopes at one sample.
bool FieldCost::soft(std::span<const double> w, double sharpness, std::size_t sample,
                     Sample& out) const {
  const bool by_information = combine_ == OrientationRule::information;
  const std::size_t count = by_information ? 1 : turns_;
  const double share = 1 / static_cast<double>(turns_);
  std::vector<CovarianceMap::Solution> at(count);
  if (by_information) {
    StateMatrix S, of_turn;
    Eigen::MatrixXd exact;
    for (std::size_t t = 0; t < turns_; ++t) {
      information(w, sample * turns_ + t, of_turn);
      S = t == 0 ? StateMatrix(of_turn * share) : StateMatrix(S + of_turn * share);
    }
    exact_rows(w, true, sample * turns_, exact);
    if (!settles(S, exact, at[0])) return false;
  } else {
    for (std::size_t t = 0; t < turns_; ++t)
      if (!solve(w, true, sample * turns_ + t, at[t])) return false;
  }
  out.smooth.assign(terms_.size(), 0);
  out.level.assign(terms_.size(), 0);
  out.slope.assign(terms_.size(), std::vector<double>(turns_ * packed_, 0.0));
  const bool mean = combine_ == OrientationRule::mean;
  std::vector<double> values, shares;
  for (std::size_t k = 0; k < terms_.size(); ++k) {
    const Block block = block_of(terms_[k].metric, layout_);
    const double s = sharpness / scale_[k][sample];
    std::vector<std::vector<Atom>> atoms;
    values.clear();
    for (std::size_t t = 0; t < count; ++t) {
      atoms.push_back(atoms_of(terms_[k].metric, layout_, at[t].P));
      for (const Atom& atom : atoms.back()) values.push_back(atom.value);
    }
    const std::size_t each = atoms.front().size();
    std::vector<double> weight(values.size());  // ∂φ̃/∂atom
    for (std::size_t group = 0; group < (mean ? count : 1); ++group) {
      const std::size_t from = mean ? group * each : 0;
      const std::size_t length = mean ? each : values.size();
      const double part = mean ? share : 1;
      out.smooth[k] +=
          part * soft_maximum(s, std::span(values).subspan(from, length), shares);
      for (std::size_t i = 0; i < length; ++i) {
        weight[from + i] = part * shares[i];
        out.level[k] += weight[from + i] * values[from + i];
      }
    }
    for (std::size_t t = 0; t < count; ++t) {
      StateMatrix Y = StateMatrix::Zero(at[t].P.rows(), at[t].P.cols());
      for (std::size_t i = 0; i < each; ++i)
        Y.block(block.first, block.first, block.size, block.size) +=
            weight[t * each + i] *
            atoms[t][i].slope.topLeftCorner(block.size, block.size);
      const StateMatrix G = map_.adjoint(at[t], Y);
      // S_ij stands for both of its places.
      for (std::size_t turn = by_information ? 0 : t;
           turn < (by_information ? turns_ : t + 1); ++turn)
        for (int i = 0; i < known_.columns; ++i)
          for (int j = 0; j <= i; ++j)
            out.slope[k]
                     [turn * packed_ + static_cast<std::size_t>(packed_index(i, j))] =
                (by_information ? share : 1) * G(i, j) * (i == j ? 1 : 2);
    }
  }
  return true;
}

/// slope_c += Σ_terms pull ⟨∂φ̃/∂S, S_c⟩
void FieldCost::accumulate(std::size_t sample, const Sample& part,
                           std::span<const double> pull, double* slope) const {
  double G[packed_index(kMaxState, 0)];
  for (std::size_t turn = 0; turn < turns_; ++turn) {
    std::fill_n(G, packed_, 0.0);
    for (std::size_t k = 0; k < terms_.size(); ++k)
      for (std::size_t i = 0; i < packed_; ++i)
        G[i] += pull[k] * part.slope[k][turn * packed_ + i];
    const std::size_t pose = sample * turns_ + turn;
    for (std::size_t e = known_.first[pose]; e < known_.first[pose + 1]; ++e) {
      const double* S = &known_.information[e * packed_];
      double sum = 0;
      for (std::size_t i = 0; i < packed_; ++i) sum += G[i] * S[i];
      slope[known_.candidate[e]] += sum;
    }
  }
}

/// @param values samples × terms; +∞ where P∞ isn't finite
double FieldCost::total(const std::vector<double>& values) const {
  const std::size_t count = terms_.size();
  double total = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const VarianceTerm& term = terms_[k];
    double of_term = 0;
    for (std::size_t s = 0; s < samples_; ++s) {
      if (term.samples[s] == 0) continue;
      const double value = values[s * count + k];
      of_term =
          term.maximum ? std::max(of_term, value) : of_term + term.samples[s] * value;
    }
    total += term.weight * of_term;
  }
  return total;
}

double FieldCost::value(std::span<const double> w) {
  const std::size_t count = terms_.size();
  std::vector<double> values(samples_ * count);
  each_chunk([&](std::size_t, std::size_t first, std::size_t end) {
    for (std::size_t s = first; s < end; ++s) hard(w, s, &values[s * count]);
  });
  return total(values);
}

std::vector<double> FieldCost::changed(std::span<const char> chosen,
                                       std::span<const Change> changes) {
  const std::size_t count = terms_.size();
  const std::vector<double> w(chosen.begin(), chosen.end());
  std::vector<double> before(samples_ * count);
  each_chunk([&](std::size_t, std::size_t first, std::size_t end) {
    for (std::size_t s = first; s < end; ++s) hard(w, s, &before[s * count]);
  });
  std::vector<double> costs(changes.size());
#pragma omp parallel num_threads(threads_)
  {
    std::vector<double> own = w, values = before;
#pragma omp for schedule(dynamic)
    for (std::size_t i = 0; i < changes.size(); ++i) {
      const auto each_seen = [&](auto&& body) {
        for (const std::size_t c : {changes[i].in, changes[i].out})
          if (c != Change::kNobody)
            for (const std::uint32_t s : seen_by_[c]) body(s);
      };
      if (changes[i].in != Change::kNobody) own[changes[i].in] = 1;
      if (changes[i].out != Change::kNobody) own[changes[i].out] = 0;
      each_seen([&](std::size_t s) { hard(own, s, &values[s * count]); });
      costs[i] = total(values);
      each_seen([&](std::size_t s) {
        std::copy_n(&before[s * count], count, &values[s * count]);
      });
      if (changes[i].in != Change::kNobody) own[changes[i].in] = w[changes[i].in];
      if (changes[i].out != Change::kNobody) own[changes[i].out] = w[changes[i].out];
    }
  }
  return costs;
}

bool FieldCost::tangent(std::span<const double> w, double sharpness, Tangent& out) {
  const std::size_t count = terms_.size();
  std::vector<Sample> parts(samples_);
  std::vector<char> finite(kParts, 1);
  each_chunk([&](std::size_t c, std::size_t first, std::size_t end) {
    for (std::size_t s = first; s < end && finite[c]; ++s)
      finite[c] = soft(w, sharpness, s, parts[s]);
  });
  if (std::find(finite.begin(), finite.end(), 0) != finite.end()) return false;

  out.smooth = out.level = 0;
  std::vector<std::vector<double>> pull(samples_, std::vector<double>(count, 0.0));
  for (std::size_t k = 0; k < count; ++k) {
    const VarianceTerm& term = terms_[k];
    std::vector<std::size_t> of_term;
    std::vector<double> values, shares;
    double scale = 0;
    for (std::size_t s = 0; s < samples_; ++s) {
      if (term.samples[s] == 0) continue;
      of_term.push_back(s);
      values.push_back(parts[s].smooth[k]);
      scale = std::max(scale, scale_[k][s]);
    }
    if (term.maximum) {
      out.smooth += term.weight * soft_maximum(sharpness / scale, values, shares);
    } else {
      shares.clear();
      for (const std::size_t s : of_term) shares.push_back(term.samples[s]);
      for (std::size_t i = 0; i < values.size(); ++i)
        out.smooth += term.weight * shares[i] * values[i];
    }
    for (std::size_t i = 0; i < of_term.size(); ++i) {
      pull[of_term[i]][k] = term.weight * shares[i];
      out.level += pull[of_term[i]][k] * parts[of_term[i]].level[k];
    }
  }
  std::vector<double> slopes(kParts * size_, 0.0);
  each_chunk([&](std::size_t c, std::size_t first, std::size_t end) {
    for (std::size_t s = first; s < end; ++s)
      accumulate(s, parts[s], pull[s], &slopes[c * size_]);
  });
  out.slope.assign(size_, 0.0);
  for (std::size_t c = 0; c < kParts; ++c)
    for (std::size_t i = 0; i < size_; ++i) out.slope[i] += slopes[c * size_ + i];
  return true;
}

std::size_t FieldCost::blind_sample(std::span<const double> w) {
  std::vector<double> values(terms_.size());
  for (std::size_t s = 0; s < samples_; ++s)
    if (!hard(w, s, values.data())) return s;
  return samples_;
}

}  // namespace delos

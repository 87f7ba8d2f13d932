#include "selection/field_cost.h"

#include <algorithm>
#include <cmath>

#include "delos/model/infinity.h"
#include "delos/model/lanes.h"
#include "delos/model/metric_table.h"
#include "delos/parallel/each.h"
#include "delos/sampling/samples.h"
#include "delos/steady/combine.h"
#include "delos/steady/state_metric.h"

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

std::vector<Metric> metrics_of(const std::vector<VarianceTerm>& terms) {
  std::vector<Metric> metrics;
  for (const VarianceTerm& term : terms) metrics.push_back(term.metric);
  return metrics;
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

}  // namespace

std::string variance_problem(const Metric& metric) {
  const MetricRow& row = row_of(metric.kind);
  if (row.convex && !row.larger_is_better) return "";
  return metric.name +
         " isn't a convex function of the covariance, so that no bound is known; use "
         "sigma_x, …, sigma_position, sigma_orientation, eigmax, eiglen or trace";
}

/// One orientation of a sample, solved.
struct FieldCost::Turn {
  SteadyEquation at;
  FusedState state;
  MetricParts parts;
};

/// Memory of one thread, made once.
struct FieldCost::Scratch {
  explicit Scratch(const FieldCost& cost)
      : turns(cost.solved_), of_turns(cost.solved_ * cost.terms_.size()) {
    for (Turn& turn : turns) turn.at = cost.solver_->equation();
  }
  std::vector<Turn> turns;
  std::vector<double> of_turns;  // solved turns × terms
};

/// What one sample adds.
struct FieldCost::Sample {
  std::vector<double> smooth, level;       // terms
  std::vector<std::vector<double>> slope;  // terms: turns × packed, ∂smooth/∂S
};

FieldCost::FieldCost(const System& system, const CandidateScene& all,
                     const Samples& samples, const Orientations& orientations,
                     std::vector<VarianceTerm> terms, double guess, int threads)
    : layout_(system.motion.layout),
      combine_(orientations.combine),
      terms_(std::move(terms)),
      kind_(system.covariance),
      solver_(make_smooth_steady_solver(system)),
      request_(request_for(system, metrics_of(terms_))),
      known_(candidate_information(system, all, poses_of(samples, orientations),
                                   threads, solver_->reads_rows())),
      excluded_(all.candidates.size(), 0),
      prior_(system.prior),
      guess_(guess),
      size_(all.candidates.size()),
      samples_(samples.points.size()),
      turns_(orientations.rpy.size()),
      solved_(solved_turns(combine_, turns_)),
      packed_(static_cast<std::size_t>(packed_index(known_.columns, 0))),
      threads_(thread_count(threads)) {
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
  guess_the_blind();
  const std::vector<double> everything(size_, 1.0);
  std::vector<double> values(terms_.size());
  Scratch scratch(*this);
  scale_.assign(terms_.size(), std::vector<double>(samples_, 1));
  for (std::size_t s = 0; s < samples_; ++s) {
    hard(everything, s, scratch, values.data());
    for (std::size_t t = 0; t < terms_.size(); ++t)
      if (values[t] > 0 && !is_blind(values[t])) scale_[t][s] = values[t];
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
  each(kParts, {.threads = threads}, [&](std::size_t c) {
    body(c, std::min(samples_, c * length), std::min(samples_, (c + 1) * length));
  });
}

/// S of a pose, packed, times a share.
void FieldCost::add_information(std::span<const double> w, std::size_t pose,
                                double share, SteadyEquation& at) const {
  double sum[packed_index(kMaxState, 0)];
  std::copy_n(&known_.always[pose * packed_], packed_, sum);
  for (std::size_t e = known_.first[pose]; e < known_.first[pose + 1]; ++e) {
    const double weight = w[static_cast<std::size_t>(known_.candidate[e])];
    if (weight == 0) continue;
    const double* of_entry = &known_.information[e * packed_];
    for (std::size_t k = 0; k < packed_; ++k) sum[k] += weight * of_entry[k];
  }
  for (std::size_t k = 0; k < packed_; ++k) sum[k] *= share;
  at.add(0, sum);
  if (known_.first_reading.empty()) return;
  for (std::size_t e = known_.first_reading[pose]; e < known_.first_reading[pose + 1];
       ++e) {
    const std::int32_t reader = known_.reader[e];
    const double weight = reader < 0 ? 1 : w[static_cast<std::size_t>(reader)];
    if (weight == 0) continue;
    const auto columns = static_cast<std::size_t>(known_.columns);
    at.add_reading(0,
                   Eigen::Map<const Eigen::RowVectorXd>(&known_.readings[e * columns],
                                                        known_.columns),
                   weight * share);
  }
}

void FieldCost::add_perfect_rows(std::span<const double> w, bool fractions,
                                 std::size_t pose, SteadyEquation& at) const {
  for (std::size_t e = known_.first_exact[pose]; e < known_.first_exact[pose + 1];
       ++e) {
    const ExactRow& row = known_.exact[e];
    if (row.candidate >= 0) {
      const auto c = static_cast<std::size_t>(row.candidate);
      if (fractions ? excluded_[c] : w[c] < 1) continue;
    }
    at.add_perfect(0, row.h.transpose());
  }
}

/// @param guess information about each coordinate of the pose besides
void FieldCost::solve(std::span<const double> w, bool fractions, double guess,
                      std::size_t sample, std::size_t turn, Turn& out) const {
  const std::size_t pose = sample * turns_ + turn, merged = turns_ / solved_;
  out.at.clear();
  for (std::size_t t = 0; t < merged; ++t)
    add_information(w, pose + t, 1 / static_cast<double>(merged), out.at);
  out.at.steps.front()
      .measurement.information.diagonal()
      .segment(out.at.block.first, layout_.coordinates())
      .array() += guess;
  out.at.besides = prior_ + guess;
  add_perfect_rows(w, fractions, pose, out.at);
  solver_->solve(out.at, request_, out.state);
  // A tangent can be done without.
  if (!fractions && out.state.status == RiccatiStatus::iteration_limit)
    unsettled_ = true;
}

bool FieldCost::sees(const Turn& turn, std::size_t sample, std::size_t term) const {
  return terms_[term].samples[sample] == 0 ||
         std::isfinite(
             state_metric(terms_[term].metric, layout_, turn.state, kind_, {}));
}

bool FieldCost::counts(std::size_t sample) const {
  return std::any_of(terms_.begin(), terms_.end(), [&](const VarianceTerm& term) {
    return term.samples[sample] > 0;
  });
}

/// φ of each term at one sample.
void FieldCost::hard(std::span<const double> w, std::size_t sample, Scratch& scratch,
                     double* values) const {
  const std::size_t count = terms_.size();
  for (std::size_t t = 0; t < solved_; ++t) {
    Turn& turn = scratch.turns[t];
    double* of_turn = &scratch.of_turns[t * count];
    const auto read = [&] {
      bool all = true;
      for (std::size_t k = 0; k < count; ++k) {
        if (!is_blind(of_turn[k])) continue;
        if (sees(turn, sample, k))
          of_turn[k] =
              variance_value(terms_[k].metric, layout_, turn.state.covariance(kind_));
        else
          of_turn[k] = kBlindCost * std::max<double>(1, turn.state.unobservable.cols());
        all &= !is_blind(of_turn[k]);
      }
      return all;
    };
    std::fill_n(of_turn, count, kInfinity);
    solve(w, false, 0, sample, t, turn);
    if (read() || guess_ == 0 || !guessed_[sample * solved_ + t]) continue;
    solve(w, false, guess_, sample, t, turn);
    read();
  }
  for (std::size_t k = 0; k < count; ++k)
    values[k] = combine(combine_, solved_, false, [&](std::size_t t) {
                  return scratch.of_turns[t * count + k];
                }).value;
}

/// Solve what has a tangent: with the guess where blind samples are judged by it, or
/// where directions are lost that no term reads.
bool FieldCost::soft_turn(std::span<const double> w, std::size_t sample,
                          std::size_t turn, Turn& out) const {
  const bool guessed = guessed_[sample * solved_ + turn];
  solve(w, true, guessed ? guess_ : 0, sample, turn, out);
  if (out.state.status == RiccatiStatus::converged) return true;
  if (guessed || guess_ == 0) return false;
  for (std::size_t k = 0; k < terms_.size(); ++k)
    if (!sees(out, sample, k)) return false;
  solve(w, true, guess_, sample, turn, out);
  return out.state.status == RiccatiStatus::converged;
}

/// φ̃, its minorant and its slopes at one sample.
bool FieldCost::soft(std::span<const double> w, double sharpness, std::size_t sample,
                     Scratch& scratch, Sample& out) const {
  for (std::size_t t = 0; t < solved_; ++t)
    if (!soft_turn(w, sample, t, scratch.turns[t])) return false;
  out.smooth.assign(terms_.size(), 0);
  out.level.assign(terms_.size(), 0);
  out.slope.assign(terms_.size(), std::vector<double>(turns_ * packed_, 0.0));
  for (std::size_t k = 0; k < terms_.size(); ++k)
    soft_term(k, sharpness / scale_[k][sample], scratch, out);
  return true;
}

// φ̃ is the soft maximum of all parts of φ in all orientations, or the mean over the
// orientations of the soft maxima of each one's parts.
void FieldCost::soft_term(std::size_t term, double sharpness, Scratch& scratch,
                          Sample& out) const {
  const MetricRow& row = row_of(terms_[term].metric.kind);
  const auto [first, size] = place_of(terms_[term].metric, layout_);
  std::vector<double> values, shares;
  for (Turn& turn : scratch.turns) {
    const StateMatrix& P = turn.state.covariance(kind_);
    row.parts(P.block(first, first, size, size), true, turn.parts);
    values.insert(values.end(), turn.parts.value, turn.parts.value + turn.parts.count);
  }
  const bool mean = combine_ == OrientationRule::mean;
  const std::size_t each = values.size() / solved_;
  const std::size_t length = mean ? each : values.size();
  const double part = mean ? 1 / static_cast<double>(solved_) : 1;
  std::vector<double> weight(values.size());  // ∂φ̃/∂φ_i
  for (std::size_t from = 0; from < values.size(); from += length) {
    out.smooth[term] +=
        part * soft_maximum(sharpness, std::span(values).subspan(from, length), shares);
    for (std::size_t i = 0; i < length; ++i) {
      weight[from + i] = part * shares[i];
      out.level[term] += weight[from + i] * values[from + i];
    }
  }
  for (std::size_t t = 0; t < solved_; ++t) {
    const Turn& turn = scratch.turns[t];
    const StateMatrix& P = turn.state.covariance(kind_);
    StateMatrix Y = StateMatrix::Zero(P.rows(), P.cols());
    for (std::size_t i = 0; i < each; ++i)
      Y.block(first, first, size, size) += weight[t * each + i] * turn.parts.slope[i];
    spread(solver_->adjoint(turn.at, Y), t, out.slope[term]);
  }
}

/// ∂φ̃/∂S of a solved turn, packed, where each of its poses has a share in S.
void FieldCost::spread(const StateMatrix& G, std::size_t turn,
                       std::vector<double>& slope) const {
  const std::size_t merged = turns_ / solved_;
  for (std::size_t pose = turn; pose < turn + merged; ++pose)
    for (int i = 0; i < known_.columns; ++i)
      for (int j = 0; j <= i; ++j)
        // S_ij stands for both of its places.
        slope[pose * packed_ + static_cast<std::size_t>(packed_index(i, j))] =
            G(i, j) * (i == j ? 1 : 2) / static_cast<double>(merged);
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

/// @param values samples × terms
double FieldCost::total(const std::vector<double>& values) const {
  const std::size_t count = terms_.size();
  double total = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const VarianceTerm& term = terms_[k];
    double of_term = 0;
    for (std::size_t s = 0; s < samples_; ++s) {
      if (term.samples[s] == 0) continue;
      const double value = values[s * count + k];
      // Of what is blind, the more the worse.
      of_term = term.maximum && !is_blind(value) ? std::max(of_term, value)
                                                 : of_term + term.samples[s] * value;
    }
    total += term.weight * of_term;
  }
  return total;
}

double FieldCost::value(std::span<const double> w) {
  const std::size_t count = terms_.size();
  std::vector<double> values(samples_ * count);
  each_chunk([&](std::size_t, std::size_t first, std::size_t end) {
    Scratch scratch(*this);
    for (std::size_t s = first; s < end; ++s) hard(w, s, scratch, &values[s * count]);
  });
  return total(values);
}

std::vector<double> FieldCost::changed(std::span<const char> chosen,
                                       std::span<const Change> changes) {
  const std::size_t count = terms_.size();
  const std::vector<double> w(chosen.begin(), chosen.end());
  std::vector<double> before(samples_ * count);
  each_chunk([&](std::size_t, std::size_t first, std::size_t end) {
    Scratch scratch(*this);
    for (std::size_t s = first; s < end; ++s) hard(w, s, scratch, &before[s * count]);
  });
  std::vector<double> costs(changes.size());
  each_with(changes.size(), {.threads = threads_}, [&] {
    return
        [&, own = w, values = before, scratch = Scratch(*this)](std::size_t i) mutable {
          const auto each_seen = [&](auto&& body) {
            for (const std::size_t c : {changes[i].in, changes[i].out})
              if (c != Change::kNobody)
                for (const std::uint32_t s : seen_by_[c]) body(s);
          };
          if (changes[i].in != Change::kNobody) own[changes[i].in] = 1;
          if (changes[i].out != Change::kNobody) own[changes[i].out] = 0;
          each_seen([&](std::size_t s) { hard(own, s, scratch, &values[s * count]); });
          costs[i] = total(values);
          each_seen([&](std::size_t s) {
            std::copy_n(&before[s * count], count, &values[s * count]);
          });
          if (changes[i].in != Change::kNobody) own[changes[i].in] = w[changes[i].in];
          if (changes[i].out != Change::kNobody)
            own[changes[i].out] = w[changes[i].out];
        };
  });
  return costs;
}

bool FieldCost::tangent(std::span<const double> w, double sharpness, Tangent& out) {
  const std::size_t count = terms_.size();
  std::vector<Sample> parts(samples_);
  std::vector<char> finite(kParts, 1);
  each_chunk([&](std::size_t c, std::size_t first, std::size_t end) {
    Scratch scratch(*this);
    for (std::size_t s = first; s < end && finite[c]; ++s)
      if (counts(s)) finite[c] = soft(w, sharpness, s, scratch, parts[s]);
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
      if (counts(s)) accumulate(s, parts[s], pull[s], &slopes[c * size_]);
  });
  out.slope.assign(size_, 0.0);
  for (std::size_t c = 0; c < kParts; ++c)
    for (std::size_t i = 0; i < size_; ++i) out.slope[i] += slopes[c * size_ + i];
  return true;
}

std::size_t FieldCost::hopeless_sample() {
  const std::vector<double> everything(size_, 1.0);
  std::vector<double> values(terms_.size());
  Scratch scratch(*this);
  for (std::size_t s = 0; s < samples_; ++s) {
    hard(everything, s, scratch, values.data());
    for (std::size_t k = 0; k < terms_.size(); ++k)
      if (terms_[k].samples[s] > 0 && is_blind(values[k])) return s;
  }
  return samples_;
}

void FieldCost::guess_the_blind() { guessed_.assign(samples_ * solved_, 1); }

void FieldCost::guess_the_always_blind(std::span<const char> available) {
  const std::vector<double> w(available.begin(), available.end());
  each_chunk([&](std::size_t, std::size_t first, std::size_t end) {
    Scratch scratch(*this);
    for (std::size_t s = first; s < end; ++s)
      for (std::size_t t = 0; t < solved_; ++t) {
        solve(w, false, 0, s, t, scratch.turns[t]);
        char& guessed = guessed_[s * solved_ + t];
        guessed = 0;
        for (std::size_t k = 0; k < terms_.size(); ++k)
          guessed |= !sees(scratch.turns[t], s, k);
      }
  });
}

std::vector<std::size_t> FieldCost::blind_samples(std::span<const char> chosen) {
  const std::vector<double> w(chosen.begin(), chosen.end());
  Scratch scratch(*this);
  std::vector<std::size_t> blind;
  for (std::size_t s = 0; s < samples_; ++s) {
    bool sees_all = true;
    for (std::size_t t = 0; t < solved_; ++t) {
      solve(w, false, 0, s, t, scratch.turns[t]);
      for (std::size_t k = 0; k < terms_.size(); ++k)
        sees_all &= sees(scratch.turns[t], s, k);
    }
    if (!sees_all) blind.push_back(s);
  }
  return blind;
}

}  // namespace delos

#include "observe/answers.h"

#include <Eigen/Cholesky>
#include <new>

#include "delos/device/faults.h"

namespace delos {
namespace {

/// Rounding that a covariance may show, relative to its largest variance.
constexpr double kRounding = 1e-9;

const char* noise_fault(const decltype(Observation::R)& R) {
  if (!R.allFinite()) return "answers with an R that isn't finite";
  const double largest = R.diagonal().maxCoeff();
  if (R.diagonal().minCoeff() < 0) return "answers with a variance below 0";
  if (R.isDiagonal(0)) return nullptr;
  if (!((R - R.transpose()).cwiseAbs().maxCoeff() <= kRounding * largest))
    return "answers with an R that isn't symmetric";
  const Eigen::LDLT<decltype(Observation::R)> split(R);
  if (!(split.vectorD().minCoeff() >= -kRounding * largest))
    return "answers with an R that isn't a covariance: some combination of its rows "
           "would have a variance below 0";
  return nullptr;
}

}  // namespace

void blame(const PlacedDevice& placed, const std::string& fault) {
  throw DeviceFault(placed.name + " (" + placed.type + "): its plugin " + fault);
}

void rethrow_named(const PlacedDevice& placed) {
  try {
    throw;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const DeviceFault&) {
    throw;
  } catch (const std::exception& e) {
    const std::string what = e.what();
    blame(placed, "fails" + (what.empty() ? " without a reason" : ": " + what));
  } catch (...) {
    blame(placed, "throws what isn't a std::exception");
  }
}

const char* answer_fault(const Observation& answer, Eigen::Index columns) {
  const Eigen::Index rows = answer.H.rows();
  if (answer.H.cols() != columns)
    return "answers with an H of the wrong number of columns";
  if (answer.R.rows() != rows || answer.R.cols() != rows)
    return "answers with an R that doesn't have a row and a column for each row of H";
  if (!answer.H.allFinite()) return "answers with an H that isn't finite";
  return rows == 0 ? nullptr : noise_fault(answer.R);
}

bool observe_smoothly(const PlacedDevice& placed, const Eigen::Vector3d& p,
                      SmoothRows& out) {
  const bool has_entry = ask(
      placed, [&](const Device& device) { return device.observe_smoothly(p, out); });
  if (!has_entry) return false;
  if (out.rows < 0 || out.rows > kMaxLaneRows)
    blame(placed, "answers smoothly with " + std::to_string(out.rows) +
                      " rows, not 0 to " + std::to_string(kMaxLaneRows));
  for (int r = 0; r < out.rows; ++r) {
    if (!(out.variance(r) > 0) || !std::isfinite(out.variance(r)))
      blame(placed, "answers smoothly with a variance that isn't finite and above 0");
    if (!out.H.row(r).allFinite())
      blame(placed, "answers smoothly with an H that isn't finite");
  }
  return true;
}

}  // namespace delos

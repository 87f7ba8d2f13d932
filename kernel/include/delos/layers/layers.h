// Information layers: what each device knows at each pose. The expensive stage, kept.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "delos/api.h"
#include "delos/model/lanes.h"
#include "delos/rig/system.h"

namespace delos {

/// What the devices know at up to kLanes poses, packed as model/lanes.h says.
struct LayerBlock {
  int lanes = 0;                    ///< poses in the block
  std::vector<double> layers;       ///< devices × packed × kLanes: S of each device
  std::vector<double> groups;       ///< weighted sums over 8 devices each
  std::vector<double> total;        ///< packed × kLanes: weighted sum, and the prior
  std::vector<std::uint64_t> seen;  ///< one word a device: the lanes that it sees
  std::vector<std::uint64_t> perfect;  ///< likewise: lanes with rows of no noise
};

struct LayerShape;  // how the layers of a system are stored and weighted

/// How layers are held.
struct LayerOptions {
  /// Bytes that may be kept; a larger set of layers is recomputed block by block at
  /// every use instead.
  std::size_t memory_limit = std::size_t{1} << 30;
  int threads = 0;  ///< 0: as many as OpenMP gives
};

/// Per-device information at a list of poses.
///
/// A change of motion, metric, rate or prior recomputes no device; a moved device
/// recomputes its own layer and two levels of partial sums. Sums run in the order of
/// the devices, in groups of eight, so that an updated set is equal, bit for bit, to a
/// fresh one.
class DELOS_API InformationLayers {
 public:
  InformationLayers(const System& system, std::vector<TargetPose> poses,
                    const LayerOptions& options = {});

  InformationLayers(InformationLayers&&) noexcept;
  InformationLayers& operator=(InformationLayers&&) noexcept;
  ~InformationLayers();

  /// Take over another state of the same rig, recomputing only the layers of devices
  /// that are new, moved or changed.
  /// @returns the number of layers that were recomputed (0 where layers are not kept).
  std::size_t update(const System& system);

  /// The layers of the system without one of its devices, bit for bit as fresh ones;
  /// where layers are kept no device is asked again.
  [[nodiscard]] InformationLayers without(std::size_t device) const;

  /// Bytes that all layers need; kept() tells whether they are held.
  [[nodiscard]] std::size_t bytes() const;
  [[nodiscard]] bool kept() const { return kept_; }

  [[nodiscard]] const System& system() const { return system_; }
  [[nodiscard]] const std::vector<TargetPose>& poses() const { return poses_; }
  [[nodiscard]] std::size_t block_count() const;

  /// The block b of up to 64 poses: the kept one, or made in `scratch`, which is
  /// reused.
  const LayerBlock& block(std::size_t b, LayerBlock& scratch) const;

 private:
  InformationLayers();
  [[nodiscard]] std::span<const TargetPose> poses_of(std::size_t b) const;
  void fill(std::size_t b, LayerBlock& block) const;
  void fill_all();

  System system_;
  std::unique_ptr<LayerShape> shape_;
  std::vector<TargetPose> poses_;
  LayerOptions options_;
  bool kept_ = false;
  std::vector<LayerBlock> blocks_;
};

/// Whitened rows R^(−1/2) H of every device at one pose, stacked, and the rows measured
/// without noise; columns as information_size(). What the careful solver reads.
struct WhitenedRows {
  Eigen::MatrixXd rows;          ///< M×c
  Eigen::MatrixXd exact;         ///< E×c
  std::vector<int> device;       ///< M: whose row it is
  std::vector<double> variance;  ///< M: R of the row, in the device's unit squared
  std::vector<double> share;     ///< M: how much of an update it is; 1 but for beacons
};
[[nodiscard]] DELOS_API WhitenedRows whitened_rows(const System& system,
                                                   const TargetPose& pose);

}  // namespace delos

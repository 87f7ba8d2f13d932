// Cameras of a scene as matrices, for programs that reconstruct.
#pragma once

#include <string>
#include <vector>

#include "delos/rig/system.h"
#include "imports/calibration.h"

namespace delos::imports {

/// How matrices are written.
enum class MatrixFormat {
  opencv_yaml,  ///< cv::FileStorage, as EasyMocap names things: K_NAME, dist_NAME, …
  json,         ///< a list of objects
  csv,          ///< a row a camera, with a header
  matrix,       ///< of each a line with its name, and the rows of its 3×4 matrix
};

/// The cameras that stand in the world, of any plugin that has a camera's table or a
/// lens and a pitch; X_WC is where they stand.
[[nodiscard]] std::vector<CalibratedCamera> cameras_of(const System& system);

/// P = K [R | t], pixels from metres; what a lens bends isn't in it.
[[nodiscard]] Eigen::Matrix<double, 3, 4> projection(const CalibratedCamera& camera);

/// @pre every camera has a place
[[nodiscard]] std::string matrices_text(const std::vector<CalibratedCamera>& cameras,
                                        MatrixFormat format);

}  // namespace delos::imports

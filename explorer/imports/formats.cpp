#include "imports/formats.h"

namespace delos::imports {

std::span<const CalibrationFormat> calibration_formats() {
  static const CalibrationFormat kAll[] = {kQualisys, kVicon,   kMotive,    kCaliscope,
                                           kPose2Sim, kAnipose, kKalibr,    kHuman36M,
                                           kMrcal,    kRos,     kEasyMocap, kOpenCv};
  return kAll;
}

}  // namespace delos::imports

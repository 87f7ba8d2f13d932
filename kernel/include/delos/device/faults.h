// What a rig can turn out to be while it is built and asked.
#pragma once

#include <stdexcept>

#include "delos/api.h"

namespace delos {

/// A design that can't be: a device refuses its parameters, a place isn't there. One
/// sentence. A search takes such a design for as bad as can be, and nothing else.
class DELOS_API Unbuildable : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A device that throws, or answers with what no measurement can be: a fault of its
/// plugin, one sentence that names the device.
class DELOS_API DeviceFault : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace delos

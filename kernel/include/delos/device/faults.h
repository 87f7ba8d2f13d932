// What a rig can turn out to be while it is built and asked.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>

#include "delos/api.h"

namespace delos {

/// A design that can't be: a device refuses its parameters, a place isn't there. One
/// sentence. A search takes such a design for as bad as can be, and nothing else.
class DELOS_API Unbuildable : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
  /// Of one parameter, wrong from this character of its text on, counted from 0.
  Unbuildable(const std::string& sentence, std::string parameter, std::size_t character)
      : runtime_error(sentence),
        parameter_(std::move(parameter)),
        character_(character) {}

  /// Empty where it isn't of one.
  [[nodiscard]] const std::string& parameter() const { return parameter_; }
  [[nodiscard]] std::size_t character() const { return character_; }

 private:
  std::string parameter_;
  std::size_t character_ = 0;
};

/// A device that throws, or answers with what no measurement can be: a fault of its
/// plugin, one sentence that names the device.
class DELOS_API DeviceFault : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace delos

// What requests hold, or a sentence that says what is missing.
#pragma once

#include <Eigen/Core>
#include <stdexcept>
#include <string>

#include "server/reply.h"

namespace delos::server {

/// Thrown by what reads a request: one sentence that says what is wrong with it.
class BadRequest : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// What stands under a key. @throws BadRequest
[[nodiscard]] const Json& member(const Json& request, const char* key);

/// The text under a key. @throws BadRequest
[[nodiscard]] std::string text_at(const Json& request, const char* key);

/// The same; where there is no such key, nothing. @throws BadRequest
[[nodiscard]] std::string text_or_empty(const Json& request, const char* key);

/// A list of n finite numbers. @param key what it is called. @throws BadRequest
[[nodiscard]] Eigen::VectorXd numbers_at(const Json& list, const char* key,
                                         Eigen::Index n);

/// A number from least to most, whole or not; `usual` where there is none.
/// @throws BadRequest
[[nodiscard]] double number_or(const Json& request, const char* key, double usual,
                               double most, double least = 0);

/// The greatest number of samples under "most"; 0, for all, where there is none.
/// @throws BadRequest
[[nodiscard]] std::size_t most_samples(const Json& request);

}  // namespace delos::server

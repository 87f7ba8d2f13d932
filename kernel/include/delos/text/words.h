// What sentences for people are made of: lists, counts, shares and places.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "delos/api.h"

namespace delos {

/// "a, b, c", or with something else between them.
[[nodiscard]] DELOS_API std::string joined(std::span<const std::string> words,
                                           std::string_view between = ", ");

/// "a, b and c"; of more than eight, seven and how many more there are.
[[nodiscard]] DELOS_API std::string listed(std::span<const std::string> names);

/// "1 sample", "2 samples".
[[nodiscard]] DELOS_API std::string counted(std::size_t count, std::string_view noun);

/// "33.4 %" of a part of 1.
[[nodiscard]] DELOS_API std::string percent(double part);

/// "(1.5, -2, 0.25)", with up to `digits` significant digits each.
[[nodiscard]] DELOS_API std::string coordinates(const Eigen::Vector3d& p,
                                                int digits = 4);

/// Whether a name fits a pattern in which '*' stands for anything.
[[nodiscard]] DELOS_API bool fits(std::string_view name, std::string_view pattern);

}  // namespace delos

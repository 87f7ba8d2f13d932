// Sums over runs as bytes, to go on with later.
#pragma once

#include <string>
#include <string_view>

#include "simulation/tally.h"

namespace delos {

/// Every number of a tally, bit for bit.
[[nodiscard]] std::string bytes_of(const Tally& tally);

/// @param[in,out] tally of the same expectation and instants as the one that was saved
/// @returns false where the bytes aren't of such a one; the tally is spoilt then
[[nodiscard]] bool read_bytes(std::string_view bytes, Tally& tally);

}  // namespace delos

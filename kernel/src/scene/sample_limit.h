// Refuses sample sets that are too large, and says which step would do.
#pragma once

#include <cstdint>
#include <string>

#include "delos/scene/scene.h"

namespace delos {

/// "1,000,000,000 samples would need about 40 GB; at most 50,000,000: use step 0.0028
/// or coarser", with a step or counts that fit, rounded to two digits.
[[nodiscard]] std::string too_many_samples(const SampleSet& set, std::int64_t most);

/// "1,000,000,000 samples would need about 40 GB; at most 50,000,000"
[[nodiscard]] std::string too_many_samples(std::int64_t count, std::int64_t most);

}  // namespace delos

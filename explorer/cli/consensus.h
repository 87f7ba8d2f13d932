// What the best layouts of a study have in common, for people.
#pragma once

#include <iosfwd>

#include "session/consensus_answer.h"

namespace delos::cli {

void print_consensus(std::ostream& out, const session::StudyConsensus& found);

}  // namespace delos::cli

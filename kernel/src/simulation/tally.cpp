#include "simulation/tally.h"

#include <algorithm>

namespace delos {

Tally::Tally(const Expectation& expected, std::size_t instants, int n, int states) {
  InstantTally instant;
  instant.error = instant.square = instant.filter = StateVector::Zero(n);
  instant.information = StateMatrix::Zero(states, states);
  this->instants.assign(instants, instant);
  LookTally look;
  look.sum = look.squares = look.filter = StateMatrix::Zero(n, n);
  looks.assign(expected.looks.size(), look);
}

void Tally::clear() {
  runs = tracked = lost = coasting = dropped = 0;
  longest_gap = 0;
  for (InstantTally& i : instants) {
    i.at.setZero();
    i.error.setZero();
    i.square.setZero();
    i.filter.setZero();
    i.information.setZero();
    i.nees = i.nis = 0;
    i.nis_rows = i.seen = 0;
  }
  for (LookTally& l : looks) {
    l.sum.setZero();
    l.squares.setZero();
    l.filter.setZero();
  }
}

void Tally::add(const Tally& more) {
  runs += more.runs;
  tracked += more.tracked;
  lost += more.lost;
  coasting += more.coasting;
  dropped += more.dropped;
  longest_gap = std::max(longest_gap, more.longest_gap);
  perfect |= more.perfect;
  for (std::size_t i = 0; i < instants.size(); ++i) {
    InstantTally& to = instants[i];
    const InstantTally& from = more.instants[i];
    to.at += from.at;
    to.error += from.error;
    to.square += from.square;
    to.filter += from.filter;
    to.information += from.information;
    to.nees += from.nees;
    to.nis += from.nis;
    to.nis_rows += from.nis_rows;
    to.seen += from.seen;
  }
  for (std::size_t l = 0; l < looks.size(); ++l) {
    looks[l].sum += more.looks[l].sum;
    looks[l].squares += more.looks[l].squares;
    looks[l].filter += more.looks[l].filter;
  }
}

}  // namespace delos

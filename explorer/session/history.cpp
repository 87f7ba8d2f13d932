#include "session/history.h"

#include <algorithm>
#include <utility>

namespace delos::session {
namespace {

/// Whether one path leads to the other's value or into it: their order matters.
bool touch(const std::string& a, const std::string& b) {
  const std::string& shorter = a.size() < b.size() ? a : b;
  const std::string& longer = a.size() < b.size() ? b : a;
  return longer.rfind(shorter, 0) == 0 &&
         (longer.size() == shorter.size() || longer[shorter.size()] == '.');
}

/// "+" adds a member and "-" takes one away, each time.
bool counts_members(const std::string& path) {
  return path.ends_with(".+") || path.ends_with(".-") || path == "-";
}

/// Add a change to others; an earlier one of its path goes where none after it cares.
void put(std::vector<Override>& all, Override change) {
  for (std::size_t i = all.size(); !counts_members(change.path) && i-- > 0;) {
    if (counts_members(all[i].path)) break;  // what was called so may be another
    if (!touch(all[i].path, change.path)) continue;
    if (all[i].path == change.path)
      all.erase(all.begin() + static_cast<std::ptrdiff_t>(i));
    break;
  }
  all.push_back(std::move(change));
}

}  // namespace

void History::add(std::vector<Override> changes, const std::string& gesture) {
  steps_.resize(done_);
  if (gesture.empty() || steps_.empty() || steps_.back().gesture != gesture)
    steps_.push_back({gesture, {}});
  for (Override& change : changes) put(steps_.back().changes, std::move(change));
  if (steps_.size() > kMostSteps) {
    for (Override& change : steps_.front().changes) put(settled_, std::move(change));
    steps_.pop_front();
    ++settled_steps_;
  }
  done_ = steps_.size();
}

bool History::undo() {
  if (done_ == 0) return false;
  --done_;
  end_gesture();
  return true;
}

bool History::redo() {
  if (done_ == steps_.size()) return false;
  ++done_;
  end_gesture();
  return true;
}

void History::end_gesture() {
  if (done_ > 0) steps_[done_ - 1].gesture.clear();
}

std::vector<Override> History::changes_after(std::size_t steps) const {
  std::vector<Override> all;
  for (std::size_t i = steps - settled_steps_; i < done_; ++i)
    all.insert(all.end(), steps_[i].changes.begin(), steps_[i].changes.end());
  return all;
}

std::vector<Override> History::changes() const {
  std::vector<Override> all = settled_;
  const std::vector<Override> later = changes_after(settled_steps_);
  all.insert(all.end(), later.begin(), later.end());
  return all;
}

}  // namespace delos::session

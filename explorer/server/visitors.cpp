#include "server/visitors.h"

#include <algorithm>
#include <random>

namespace delos::server {
namespace {

/// 128 bits of the system's entropy, in hexadecimal.
std::string random_name() {
  static constexpr char kDigits[] = "0123456789abcdef";
  std::random_device random;
  std::string name;
  for (int word = 0; word < 4; ++word) {
    std::uint32_t bits = random();
    for (int digit = 0; digit < 8; ++digit, bits >>= 4) name += kDigits[bits & 15];
  }
  return name;
}

}  // namespace

Stop Visitor::newest(const std::string& kind) {
  Stop& stop = at_work_[kind];
  if (stop) *stop = true;
  stop = std::make_shared<std::atomic<bool>>(false);
  return stop;
}

void Visitor::stop_all() {
  for (auto& [kind, stop] : at_work_)
    if (stop) *stop = true;
}

void Visitor::leave() {
  stop_all();
  if (const auto job = searches.job()) job->pause();
}

std::string Visitors::add(std::shared_ptr<Visitor> visitor) {
  latest_first_.push_front({random_name(), std::move(visitor)});
  if (latest_first_.size() > kMost) {
    latest_first_.back().visitor->leave();
    latest_first_.pop_back();
  }
  return latest_first_.front().name;
}

std::shared_ptr<Visitor> Visitors::find(const std::string& name) {
  const auto found =
      std::find_if(latest_first_.begin(), latest_first_.end(),
                   [&](const Named& named) { return named.name == name; });
  if (found == latest_first_.end()) return nullptr;
  latest_first_.splice(latest_first_.begin(), latest_first_, found);
  return latest_first_.front().visitor;
}

void Visitors::stop_all() {
  for (const Named& named : latest_first_) named.visitor->leave();
}

}  // namespace delos::server

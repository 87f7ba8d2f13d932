// Where searches are done: threads beside those that answer, and files that go.
#pragma once

#include <atomic>
#include <boost/asio/thread_pool.hpp>
#include <filesystem>
#include <memory>

#include "session/job.h"

namespace delos::server {

class SearchPlace {
 public:
  /// So many search at once; others wait for their turn.
  static constexpr int kAtOnce = 4;

  SearchPlace();
  ~SearchPlace();
  SearchPlace(const SearchPlace&) = delete;
  SearchPlace& operator=(const SearchPlace&) = delete;

  /// Let it work; what is drawn goes first where the processor is scarce.
  void launch(std::shared_ptr<session::Job> job);
  /// A file for a study that nobody named. @throws std::filesystem::filesystem_error
  [[nodiscard]] std::filesystem::path unnamed();
  /// Wait until all have stopped. @pre they are asked to
  void join();

 private:
  boost::asio::thread_pool threads_{kAtOnce};
  std::filesystem::path folder_;
  std::atomic<int> files_ = 0;
};

}  // namespace delos::server

#include "server/search_place.h"

#include <stdlib.h>
#include <sys/resource.h>
#include <unistd.h>

#include <boost/asio/post.hpp>
#include <cerrno>
#include <string>
#include <system_error>
#include <utility>

namespace delos::server {
namespace {

/// Of a thread and of those that it begins; 19 would be the last of all.
constexpr int kNiceness = 5;

}  // namespace

SearchPlace::SearchPlace() {
  std::string name =
      (std::filesystem::temp_directory_path() / "delos-searches-XXXXXX").string();
  if (!mkdtemp(name.data()))
    throw std::system_error(errno, std::generic_category(), name);
  folder_ = name;
}

SearchPlace::~SearchPlace() {
  threads_.join();
  std::error_code ignored;
  std::filesystem::remove_all(folder_, ignored);
}

void SearchPlace::launch(std::shared_ptr<session::Job> job) {
  boost::asio::post(threads_, [job = std::move(job)] {
    // Linux counts it thread by thread: setpriority(2), bugs.
    setpriority(PRIO_PROCESS, static_cast<id_t>(gettid()), kNiceness);
    job->work();
  });
}

std::filesystem::path SearchPlace::unnamed() {
  return folder_ / (std::to_string(++files_) + ".study");
}

void SearchPlace::join() { threads_.join(); }

}  // namespace delos::server

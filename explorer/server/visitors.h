// The designs that pages work on, one a tab.
#pragma once

#include <atomic>
#include <boost/asio/strand.hpp>
#include <boost/asio/thread_pool.hpp>
#include <cstdint>
#include <list>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "server/kept_fields.h"
#include "server/searches.h"
#include "session/design.h"
#include "session/difference.h"

namespace delos::server {

using Strand = boost::asio::strand<boost::asio::thread_pool::executor_type>;

/// A request to stop, shared by who works and who asks.
using Stop = std::shared_ptr<std::atomic<bool>>;

/// A design that others are compared with.
struct Pinned {
  session::Baseline baseline;
  session::Json description;  ///< as it was then
};

/// A tab: its design, the strand on which all that touches the design runs, and what is
/// being worked out of it.
class Visitor {
 public:
  Visitor(session::Design opened, Strand on)
      : design(std::move(opened)), strand(std::move(on)) {}

  session::Design design;        ///< on the strand only
  std::uint64_t revision = 0;    ///< likewise; grows with each change
  std::optional<Pinned> pinned;  ///< likewise
  Searches searches;             ///< see there
  KeptFields fields;             ///< on any thread
  Strand strand;
  int watchers = 0;    ///< of its searches; on the server's own thread only
  bool waits = false;  ///< likewise: a search stopped since nobody watched it

  /// The newest request of a kind takes the place of the one before.
  [[nodiscard]] Stop newest(const std::string& kind);
  /// Nothing that is being worked out is of use any more.
  void stop_all();
  /// Nor is it being searched for.
  void leave();

 private:
  std::map<std::string, Stop> at_work_;  // on the server's own thread only
};

/// The tabs, by names that can't be guessed. Of more than kMost, the one that was quiet
/// longest is forgotten.
class Visitors {
 public:
  static constexpr std::size_t kMost = 64;

  /// @returns its name
  std::string add(std::shared_ptr<Visitor> visitor);
  /// @returns null where there is none of that name
  [[nodiscard]] std::shared_ptr<Visitor> find(const std::string& name);
  void stop_all();

 private:
  struct Named {
    std::string name;
    std::shared_ptr<Visitor> visitor;
  };
  std::list<Named> latest_first_;
};

}  // namespace delos::server

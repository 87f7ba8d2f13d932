// The explorer's server at work, and somebody who talks HTTP to it, byte for byte.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "cli/program.h"

namespace delos::test {

/// What came back on a connection, until it ended.
struct Answer {
  int status = 0;  ///< 0: it ended without an answer
  std::string head, body;

  /// The body as a document; fails the test where it isn't one.
  Json json() const;
  /// The text at the head of packed arrays, which begin with four letters.
  [[nodiscard]] Json packed_head(const std::string& letters) const;
  /// The message of a refusal.
  [[nodiscard]] std::string error() const;
};

/// A TCP connection to 127.0.0.1; reading gives up after half a minute.
class Connection {
 public:
  explicit Connection(int port);
  ~Connection();
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  void send(const std::string& bytes) const;
  /// All that comes until the other side ends it.
  [[nodiscard]] Answer answer() const;

 private:
  int socket_ = -1;
};

/// `delos explore --no-open` while it runs.
class Explorer {
 public:
  explicit Explorer(const std::vector<std::string>& arguments = {});

  [[nodiscard]] int port() const { return port_; }
  [[nodiscard]] std::string host() const;

  /// One request on a connection of its own, with these headers instead of the usual.
  [[nodiscard]] Answer get(const std::string& path,
                           std::map<std::string, std::string> headers = {}) const;
  [[nodiscard]] Answer post(const std::string& verb, const std::string& body,
                            std::map<std::string, std::string> headers = {}) const;
  /// Of a design. @param more keys beside the session
  Answer ask(const std::string& verb, const std::string& session,
             Json more = Json::object()) const;
  /// @returns the description, with its session
  [[nodiscard]] Json open(const std::string& scene) const;

  /// What it has in memory now, bytes; proc(5), VmRSS.
  [[nodiscard]] std::size_t resident() const;

  /// Ctrl-C. @returns how it ended
  Finished end();

 private:
  Folder folder_;
  Running program_;
  int port_ = 0;
};

/// The bytes of a request.
std::string request_text(const std::string& method, const std::string& path,
                         const std::map<std::string, std::string>& headers,
                         const std::string& body = "");

}  // namespace delos::test

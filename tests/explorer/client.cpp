#include "client.h"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/socket.h>
#include <unistd.h>

#include <chrono>
#include <cstring>
#include <sstream>
#include <stdexcept>
#include <thread>

namespace delos::test {
namespace {

constexpr std::chrono::seconds kToStart{30};

}  // namespace

Json Answer::json() const {
  Json document = Json::parse(body, nullptr, false);
  EXPECT_FALSE(document.is_discarded()) << "not a JSON document:\n" << head << body;
  return document;
}

Json Answer::packed_head(const std::string& letters) const {
  EXPECT_EQ(status, 200) << body;
  EXPECT_EQ(body.substr(0, 4), letters);
  std::uint32_t length = 0;
  if (body.size() >= 8) std::memcpy(&length, body.data() + 4, sizeof length);
  return body.size() >= 8 ? Json::parse(body.substr(8, length)) : Json();
}

std::string Answer::error() const {
  return json().value(Json::json_pointer("/error/message"), std::string());
}

Connection::Connection(int port) : socket_(::socket(AF_INET, SOCK_STREAM, 0)) {
  const timeval patience{30, 0};
  ::setsockopt(socket_, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
  sockaddr_in there{};
  there.sin_family = AF_INET;
  there.sin_port = htons(static_cast<std::uint16_t>(port));
  there.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  if (::connect(socket_, reinterpret_cast<const sockaddr*>(&there), sizeof there) != 0)
    throw std::runtime_error("can't connect");
}

Connection::~Connection() { ::close(socket_); }

void Connection::send(const std::string& bytes) const {
  for (std::size_t sent = 0; sent < bytes.size();) {
    const ssize_t n =
        ::send(socket_, bytes.data() + sent, bytes.size() - sent, MSG_NOSIGNAL);
    if (n <= 0) return;  // the other side has heard enough
    sent += static_cast<std::size_t>(n);
  }
}

Answer Connection::answer() const {
  std::string all;
  char part[65536];
  for (ssize_t n = 0; (n = ::recv(socket_, part, sizeof part, 0)) > 0;)
    all.append(part, static_cast<std::size_t>(n));
  Answer answer;
  const std::size_t end = all.find("\r\n\r\n");
  if (end == std::string::npos) return answer;
  answer.head = all.substr(0, end);
  answer.body = all.substr(end + 4);
  if (std::sscanf(answer.head.c_str(), "HTTP/1.%*d %d", &answer.status) != 1)
    ADD_FAILURE() << answer.head;
  return answer;
}

Explorer::Explorer(const std::vector<std::string>& arguments)
    : program_(
          [&] {
            std::vector<std::string> words = {"explore", "--no-open"};
            words.insert(words.end(), arguments.begin(), arguments.end());
            return words;
          }(),
          {}, (folder_ / "said").string()) {
  const auto last = std::chrono::steady_clock::now() + kToStart;
  std::string said;
  while (said.find("/\n") == std::string::npos) {
    if (std::chrono::steady_clock::now() > last || program_.ended())
      throw std::runtime_error("the explorer didn't start: " + program_.err());
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    said = read_file(folder_ / "said");
  }
  if (std::sscanf(said.c_str(), "The explorer is at http://127.0.0.1:%d/", &port_) != 1)
    throw std::runtime_error("no address in: " + said);
}

std::string Explorer::host() const { return "127.0.0.1:" + std::to_string(port_); }

std::string request_text(const std::string& method, const std::string& path,
                         const std::map<std::string, std::string>& headers,
                         const std::string& body) {
  std::string text = method + " " + path + " HTTP/1.1\r\n";
  for (const auto& [name, value] : headers)
    if (!value.empty()) text += name + ": " + value + "\r\n";
  return text + "Connection: close\r\n\r\n" + body;
}

Answer Explorer::get(const std::string& path,
                     std::map<std::string, std::string> headers) const {
  headers.insert({"Host", host()});
  const Connection connection(port_);
  connection.send(request_text("GET", path, headers));
  return connection.answer();
}

Answer Explorer::post(const std::string& verb, const std::string& body,
                      std::map<std::string, std::string> headers) const {
  headers.insert({"Host", host()});
  headers.insert({"Origin", "http://" + host()});
  headers.insert({"Content-Type", "application/json"});
  headers.insert({"Content-Length", std::to_string(body.size())});
  const Connection connection(port_);
  connection.send(request_text("POST", "/api/" + verb, headers, body));
  return connection.answer();
}

Answer Explorer::ask(const std::string& verb, const std::string& session,
                     Json more) const {
  more["session"] = session;
  return post(verb, more.dump());
}

Json Explorer::open(const std::string& scene) const {
  const Answer answer = post("open", Json{{"scene", scene}}.dump());
  EXPECT_EQ(answer.status, 200) << answer.body;
  return answer.json();
}

std::size_t Explorer::resident() const {
  std::istringstream lines(
      read_file("/proc/" + std::to_string(program_.pid()) + "/status"));
  std::string word;
  std::size_t kibibytes = 0;
  while (lines >> word && word != "VmRSS:") {
  }
  lines >> kibibytes;
  return 1024 * kibibytes;
}

Finished Explorer::end() {
  program_.send(SIGINT);
  return program_.wait();
}

}  // namespace delos::test

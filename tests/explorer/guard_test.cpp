// Who may ask, and how much: everybody else is told why not, and the server lives on.
#include <gtest/gtest.h>

#include <chrono>
#include <list>
#include <regex>
#include <sstream>

#include "client.h"

namespace delos::test {
namespace {

class Guard : public testing::Test {
 protected:
  /// It still answers, as if nothing had been.
  ~Guard() override {
    EXPECT_EQ(explorer.get("/").status, 200);
    const Finished done = explorer.end();
    EXPECT_EQ(done.code, 0) << done.err;
    EXPECT_EQ(done.err, "");
  }
  Explorer explorer;
};

TEST_F(Guard, AnswersToItsTwoNamesOnly) {
  const std::string port = std::to_string(explorer.port());
  EXPECT_EQ(explorer.get("/", {{"Host", "localhost:" + port}}).status, 200);
  for (const std::string host :
       {"evil.example", "evil.example:", "127.0.0.1", "127.0.0.1:1", "localhost",
        "127.0.0.1.evil.example:", "[::1]:", "0.0.0.0:", " "}) {
    const std::string name = host.ends_with(":") ? host + port : host;
    EXPECT_EQ(explorer.get("/", {{"Host", name}}).status, 421) << name;
    EXPECT_EQ(
        explorer.post("open", R"({"scene": "01-acoustic"})", {{"Host", name}}).status,
        421)
        << name;
  }
  EXPECT_EQ(explorer.get("/", {{"Host", ""}}).status, 421) << "none at all";
}

TEST_F(Guard, AnswersItsOwnPageOnly) {
  const std::string body = R"({"scene": "01-acoustic"})";
  EXPECT_EQ(explorer.post("open", body).status, 200);
  for (const std::string& origin :
       {std::string("http://evil.example"), std::string("null"),
        "https://" + explorer.host(), "http://" + explorer.host() + ".evil.example",
        std::string("http://localhost")}) {
    EXPECT_EQ(explorer.post("open", body, {{"Origin", origin}}).status, 403) << origin;
    EXPECT_EQ(explorer.get("/api/scenes", {{"Origin", origin}}).status, 403) << origin;
  }
}

/// What a form of another site can send without being asked by the browser.
TEST_F(Guard, TakesNoForms) {
  for (const std::string type : {"text/plain", "application/x-www-form-urlencoded",
                                 "multipart/form-data; boundary=x"})
    EXPECT_EQ(explorer.post("open", "{}", {{"Content-Type", type}}).status, 415)
        << type;
  EXPECT_EQ(explorer.post("open", "{}", {{"Content-Type", ""}}).status, 415);
}

TEST_F(Guard, HasFiveFilesAndNoOthers) {
  for (const std::string path :
       {"/", "/explorer.js", "/explorer.css", "/icon.svg", "/licences.txt"})
    EXPECT_EQ(explorer.get(path).status, 200) << path;
  for (const std::string path :
       {"/../../../etc/passwd", "/..%2f..%2fetc/passwd", "//etc/passwd", "/index.html",
        "/explorer.js/../explorer.js", "/%2e%2e/", "/explorer.js%00", "/?x", "/api/",
        "/api/open", "/scenes/01-acoustic.yaml"})
    EXPECT_EQ(explorer.get(path).status, 404) << path;
  for (const std::string scene : {"../../etc/passwd", "/etc/passwd", "",
                                  "01-acoustic.yaml", "hiball/../01-acoustic"})
    EXPECT_EQ(explorer.post("open", Json{{"scene", scene}}.dump()).status, 404)
        << scene;
}

TEST_F(Guard, TellsBrowsersToTrustNobodyElse) {
  const std::string head = explorer.get("/").head;
  EXPECT_NE(head.find("default-src 'self'"), std::string::npos) << head;
  EXPECT_NE(head.find("frame-ancestors 'none'"), std::string::npos);
  EXPECT_NE(head.find("X-Content-Type-Options: nosniff"), std::string::npos);
  EXPECT_EQ(head.find("Access-Control"), std::string::npos);
}

TEST_F(Guard, TakesTwoMethods) {
  for (const std::string method :
       {"PUT", "DELETE", "OPTIONS", "HEAD", "TRACE", "FROB"}) {
    const Connection connection(explorer.port());
    connection.send(request_text(method, "/api/open", {{"Host", explorer.host()}}));
    const int status = connection.answer().status;
    EXPECT_TRUE(status == 405 || status == 400) << method << " " << status;
  }
}

TEST_F(Guard, ReadsNoBodyThatIsTooLarge) {
  const Answer announced =
      explorer.post("open", "{", {{"Content-Length", "1073741824"}});
  EXPECT_EQ(announced.status, 413);
  EXPECT_EQ(announced.error(), "the request is larger than 256 KiB");
  EXPECT_EQ(explorer.post("open", std::string(300'000, ' ')).status, 413);

  // Pieces that don't say how many there will be.
  const Connection connection(explorer.port());
  connection.send(request_text("POST", "/api/open",
                               {{"Host", explorer.host()},
                                {"Content-Type", "application/json"},
                                {"Transfer-Encoding", "chunked"}}));
  const std::string piece = "10000\r\n" + std::string(0x10000, ' ') + "\r\n";
  for (int i = 0; i < 64; ++i) connection.send(piece);
  EXPECT_NE(connection.answer().status, 200);
}

TEST_F(Guard, ReadsNoHeadThatIsTooLarge) {
  const Answer answer = explorer.get("/", {{"X", std::string(100'000, 'x')}});
  EXPECT_NE(answer.status, 200);
}

TEST_F(Guard, SaysWhereJsonIsMalformed) {
  const Answer answer = explorer.post("open", "{\"scene\": \"01-acoustic\",\n  oops}");
  EXPECT_EQ(answer.status, 400);
  EXPECT_NE(answer.error().find("at line 2, column 3"), std::string::npos)
      << answer.error();
  for (const std::string body :
       {"", "[]", "1", "null", "{\"scene\": 1}", "{}", "\xff\xfe", "{\"a\": 1e999}"})
    EXPECT_EQ(explorer.post("open", body).status, 400) << body;
  // Depth that would exhaust the stack of what reads by recursion.
  EXPECT_EQ(explorer.post("open", std::string(200'000, '[')).status, 400);
}

TEST_F(Guard, OutlivesWhatIsNotHttp) {
  for (const std::string& bytes :
       {std::string("\0\1\2\3\r\n\r\n", 8), std::string("GET / HTTP/9.9\r\n\r\n"),
        std::string(200'000, 'A'), std::string("\x16\x03\x01\x02\x00\x01", 6),
        std::string("GET /\r\n\r\n")}) {
    const Connection connection(explorer.port());
    connection.send(bytes + "\r\n\r\n");
    EXPECT_NE(connection.answer().status, 200);
  }
  const Connection silent(explorer.port());  // says nothing, and goes
  const Connection half(explorer.port());
  half.send("POST /api/open HTTP/1.1\r\nContent-Le");
}

TEST_F(Guard, BoundsItsConnections) {
  std::list<Connection> many;
  for (int i = 0; i < 128; ++i) many.emplace_back(explorer.port());
  EXPECT_EQ(explorer.get("/").status, 503);
  many.clear();
  const auto last = std::chrono::steady_clock::now() + std::chrono::seconds(10);
  while (explorer.get("/").status != 200 && std::chrono::steady_clock::now() < last) {
  }
}

/// The kernel's own list of who listens: proc(5), net/tcp, in network order as read by
/// a little-endian machine.
TEST_F(Guard, ListensOnTheLoopbackOnly) {
  char port[16];
  std::snprintf(port, sizeof port, ":%04X", explorer.port());
  int listening = 0;
  for (const char* table : {"/proc/net/tcp", "/proc/net/tcp6"}) {
    std::istringstream lines(read_file(table));
    for (std::string line; std::getline(lines, line);) {
      std::istringstream words(line);
      std::string number, local, remote, state;
      words >> number >> local >> remote >> state;
      if (state != "0A" || !local.ends_with(port)) continue;
      ++listening;
      EXPECT_EQ(local, std::string("0100007F") + port);
    }
  }
  EXPECT_EQ(listening, 1);
}

TEST(Explore, SaysWhichPortIsTaken) {
  Explorer first;
  const Finished second =
      run({"explore", "--no-open", "--port", std::to_string(first.port())});
  EXPECT_EQ(second.code, 2);
  EXPECT_NE(second.err.find("port " + std::to_string(first.port())), std::string::npos)
      << second.err;
  EXPECT_EQ(first.end().code, 0);
}

TEST(Explore, RefusesASceneThatIsNotInOrder) {
  const Folder folder;
  const auto file = folder.write("bad.yaml", "delos: 1\nname: x\n");
  const Finished done = run({"explore", "--no-open", file.string()});
  EXPECT_EQ(done.code, 1);
  EXPECT_NE(done.err.find("bad.yaml:"), std::string::npos) << done.err;
}

}  // namespace
}  // namespace delos::test

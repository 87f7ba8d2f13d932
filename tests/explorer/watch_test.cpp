// A page is told of its own search as it goes on, over a WebSocket.
#include <gtest/gtest.h>

#include "room.h"

namespace delos::test {
namespace {

/// The head of a WebSocket's request (RFC 6455, section 4.1).
std::string upgrade(const Explorer& explorer, const std::string& session,
                    const std::string& origin) {
  return "GET /api/watch?session=" + session + " HTTP/1.1\r\nHost: " + explorer.host() +
         "\r\nOrigin: " + origin +
         "\r\nUpgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: "
         "13\r\n"
         "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n\r\n";
}

TEST(Watching, AreToldAsTheyGoOn) {
  const Room room;
  const Connection watching(room.explorer.port());
  watching.send(upgrade(room.explorer, room.session, "http://" + room.explorer.host()));
  room.ask("search_start", {{"starts", 2}});
  room.until_phase("ended");
  std::this_thread::sleep_for(std::chrono::milliseconds(500));
  // A close, masked by zeros: the end.
  watching.send(std::string("\x88\x80\0\0\0\0", 6));
  const Answer told = watching.answer();
  EXPECT_EQ(told.status, 101) << told.head;
  // The key's answer is RFC 6455's own example, section 1.3.
  EXPECT_NE(told.head.find("s3pPLMBiTxaQ9kYGzzhZRbK+xOo="), std::string::npos);
  EXPECT_EQ(told.body.substr(0, 1), "\x81") << "a text, whole";
  EXPECT_NE(told.body.find(R"("phase":"running")"), std::string::npos);
  EXPECT_NE(told.body.find(R"("phase":"ended")"), std::string::npos);
  // Each incumbent once.
  const std::string second = R"("number":1})";
  const std::size_t first = told.body.find(second);
  EXPECT_NE(first, std::string::npos);
  EXPECT_EQ(told.body.find(second, first + 1), std::string::npos);
}

TEST(Watching, AreToldToTheirOwnPageOnly) {
  Room room;
  const auto asked = [&](const std::string& session, const std::string& origin) {
    const Connection connection(room.explorer.port());
    connection.send(upgrade(room.explorer, session, origin));
    return connection.answer().status;
  };
  EXPECT_EQ(asked(room.session, "http://evil.example"), 403);
  const std::string own = "http://" + room.explorer.host();
  // What isn't a WebSocket for it is asked again on the same connection, until it
  // tires.
  {
    const Connection wrong(room.explorer.port());
    wrong.send(upgrade(room.explorer, "0123", own) + "GARBAGE\r\n\r\n");
    EXPECT_EQ(wrong.answer().status, 404);
  }
  // Frames that no client may send: without a mask, of a reserved kind, of 2^62 bytes.
  for (const std::string& frame :
       {std::string("\x81\x01x", 3), std::string("\x83\x80\0\0\0\0", 6),
        std::string("\x81\xff\x40\0\0\0\0\0\0\0\0\0\0\0", 14)}) {
    const Connection connection(room.explorer.port());
    connection.send(upgrade(room.explorer, room.session, own));
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    connection.send(frame);
    EXPECT_EQ(connection.answer().status, 101);
  }
  EXPECT_EQ(room.explorer.get("/").status, 200);
  EXPECT_EQ(room.explorer.end().code, 0);
}

TEST(Watching, StopWhenNobodyWatchesAnyMore) {
  Room room;
  const std::string own = "http://" + room.explorer.host();
  room.ask("search_start", {{"starts", 200}});
  {
    const Connection watching(room.explorer.port());
    watching.send(upgrade(room.explorer, room.session, own));
    room.until_found(2);
  }
  const Json left = room.until_phase("paused");
  const Connection again(room.explorer.port());
  again.send(upgrade(room.explorer, room.session, own));
  room.until([&](const Json& search) {
    return search["phase"] == "running" &&
           search["evaluations"].get<int>() > left["evaluations"].get<int>();
  });
  EXPECT_EQ(room.explorer.end().code, 0) << "the end waits for no search";
}

}  // namespace
}  // namespace delos::test

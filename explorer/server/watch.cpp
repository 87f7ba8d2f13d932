#include "server/watch.h"

#include <boost/asio/buffer.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/websocket.hpp>
#include <chrono>
#include <utility>

namespace delos::server {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace websocket = beast::websocket;

constexpr std::chrono::milliseconds kBetweenNews{100};
/// A page that is loaded again is back sooner.
constexpr std::chrono::seconds kToComeBack{3};
constexpr std::size_t kMostHeard = 1024;

/// A socket, and whether the other side has ended it or said something.
struct Line {
  explicit Line(beast::tcp_stream stream) : socket(std::move(stream)) {}
  websocket::stream<beast::tcp_stream> socket;
  beast::flat_buffer heard{kMostHeard};
  bool over = false;
};

asio::awaitable<void> pause_for(std::chrono::milliseconds time) {
  asio::steady_timer timer(co_await asio::this_coro::executor, time);
  co_await timer.async_wait(asio::use_awaitable);
}

asio::awaitable<void> tell(Line& line, const Visitor& visitor) {
  Watched watched;
  while (!line.over) {
    if (const auto news = visitor.searches.news(watched)) {
      const std::string text = session::text_of(*news);
      beast::error_code error;
      co_await line.socket.async_write(
          asio::buffer(text), asio::redirect_error(asio::use_awaitable, error));
      if (error) co_return;
    }
    co_await pause_for(kBetweenNews);
  }
}

}  // namespace

asio::awaitable<void> watch(beast::tcp_stream stream,
                            beast::http::request<beast::http::string_body> request,
                            std::shared_ptr<Visitor> visitor, Api& api) {
  stream.expires_never();  // the WebSocket has a clock of its own
  const auto line = std::make_shared<Line>(std::move(stream));
  line->socket.set_option(
      websocket::stream_base::timeout::suggested(beast::role_type::server));
  line->socket.read_message_max(kMostHeard);
  beast::error_code error;
  co_await line->socket.async_accept(request,
                                     asio::redirect_error(asio::use_awaitable, error));
  if (error) co_return;
  line->socket.text(true);
  line->socket.auto_fragment(false);
  line->socket.async_read(
      line->heard, [line](beast::error_code, std::size_t) { line->over = true; });
  ++visitor->watchers;
  api.came_back(*visitor);
  co_await tell(*line, *visitor);
  --visitor->watchers;
  beast::error_code ignored;
  co_await line->socket.async_close(websocket::close_code::normal,
                                    asio::redirect_error(asio::use_awaitable, ignored));
  co_await pause_for(kToComeBack);
  if (visitor->watchers == 0) api.left(*visitor);
}

}  // namespace delos::server

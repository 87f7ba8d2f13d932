#include "server/connection.h"

#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket/rfc6455.hpp>
#include <chrono>
#include <optional>
#include <utility>

#include "bundle/page_file.h"
#include "server/guard.h"
#include "server/watch.h"

namespace delos::server {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;

using Request = http::request<http::string_body>;
using Response = http::response<http::string_body>;

constexpr std::chrono::seconds kPatience{30};  ///< for a request, or its answer's way
constexpr std::uint32_t kMostHeader = 16 * 1024;

std::string_view view(beast::string_view text) { return {text.data(), text.size()}; }

Asked asked_of(const Request& request) {
  return {view(request.method_string()), view(request.target()),
          view(request[http::field::host]), view(request[http::field::origin]),
          view(request[http::field::content_type])};
}

/// Nothing of other sites is loaded, nobody shows the page in a frame, no answer is
/// taken for something that it isn't.
Response response_of(Reply reply, unsigned version, bool keep_alive) {
  Response response(static_cast<http::status>(reply.status), version);
  response.set(http::field::content_type, reply.type);
  response.set(http::field::cache_control, "no-store");
  response.set("X-Content-Type-Options", "nosniff");
  response.set("Content-Security-Policy",
               "default-src 'self'; img-src 'self' blob: data:; object-src 'none'; "
               "base-uri 'none'; form-action 'none'; frame-ancestors 'none'");
  response.set("Cross-Origin-Resource-Policy", "same-origin");
  response.set("Referrer-Policy", "no-referrer");
  response.keep_alive(keep_alive);
  response.body() = std::move(reply.body);
  response.prepare_payload();
  return response;
}

asio::awaitable<Reply> answer(const Request& request, Api& api) {
  const std::string target(view(request.target()));
  constexpr std::string_view kApi = "/api/";
  if (request.method() == http::verb::get) {
    if (target == "/api/scenes") co_return api.scenes();
    if (const std::optional<bundle::PageFile> file = bundle::page_file(target))
      co_return Reply{Status::ok, std::string(file->type), std::string(file->bytes)};
    co_return refusal(Status::not_found, "there is nothing of this name");
  }
  if (target.rfind(kApi, 0) != 0)
    co_return refusal(Status::not_found, "there is nothing of this name");
  co_return co_await api.answer(target.substr(kApi.size()), request.body());
}

/// Whose searches a WebSocket is about; null where it is none, or nobody's.
std::shared_ptr<Visitor> watched_by(const Request& request, Api& api) {
  const std::string_view target = view(request.target());
  if (!beast::websocket::is_upgrade(request) || !target.starts_with(kWatch))
    return nullptr;
  return api.visitor(std::string(target.substr(kWatch.size())));
}

/// Why what couldn't be read wasn't; nullopt where there is nobody to tell.
std::optional<Reply> unreadable(const beast::error_code& error) {
  if (error == http::error::body_limit)
    return refusal(Status::too_large, "the request is larger than " +
                                          std::to_string(kMostBody / 1024) + " KiB");
  if (error == http::error::end_of_stream || error == http::error::partial_message ||
      error.category() != make_error_code(http::error::bad_target).category())
    return std::nullopt;
  return refusal(Status::bad_request, "the request isn't HTTP: " + error.message());
}

/// @returns false where the connection is at its end
asio::awaitable<bool> send(beast::tcp_stream& stream, Response response) {
  beast::error_code error;
  stream.expires_after(kPatience);
  co_await http::async_write(stream, response,
                             asio::redirect_error(asio::use_awaitable, error));
  co_return !error && response.keep_alive();
}

}  // namespace

asio::awaitable<void> serve(asio::ip::tcp::socket socket, Api& api,
                            unsigned short port) {
  beast::tcp_stream stream(std::move(socket));
  beast::flat_buffer buffer(kMostHeader + kMostBody);
  constexpr unsigned kHttp11 = 11;
  for (bool more = true; more;) {
    http::request_parser<http::string_body> parser;
    parser.header_limit(kMostHeader);
    parser.body_limit(kMostBody);
    beast::error_code error;
    stream.expires_after(kPatience);
    co_await http::async_read_header(stream, buffer, parser,
                                     asio::redirect_error(asio::use_awaitable, error));
    // Who may not ask is told so before his body is read.
    std::optional<Reply> no;
    if (!error) no = refused(asked_of(parser.get()), port);
    if (!error && !no)
      co_await http::async_read(stream, buffer, parser,
                                asio::redirect_error(asio::use_awaitable, error));
    if (error) no = unreadable(error);
    if (no) {
      co_await send(stream, response_of(std::move(*no), kHttp11, false));
      break;
    }
    if (error) break;
    const Request request = parser.release();
    if (const auto watched = watched_by(request, api))
      co_return co_await watch(std::move(stream), request, watched, api);
    stream.expires_never();  // working it out may take long
    Reply reply = co_await answer(request, api);
    more = co_await send(
        stream, response_of(std::move(reply), request.version(), request.keep_alive()));
  }
  beast::error_code ignored;
  stream.socket().shutdown(asio::ip::tcp::socket::shutdown_send, ignored);
}

asio::awaitable<void> turn_away(asio::ip::tcp::socket socket) {
  beast::tcp_stream stream(std::move(socket));
  constexpr unsigned kHttp11 = 11;
  co_await send(stream, response_of(refusal(Status::busy, "too many connections"),
                                    kHttp11, false));
}

}  // namespace delos::server

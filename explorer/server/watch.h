// A page that is told how its search goes on, as it does.
#pragma once

#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/http/message.hpp>
#include <boost/beast/http/string_body.hpp>

#include "server/api.h"
#include "server/awaitable.h"

namespace delos::server {

/// The target that asks for it: then the session's name.
inline constexpr std::string_view kWatch = "/api/watch?session=";

/// WebSocket (RFC 6455): each message is a text, searched_json() of what wasn't told
/// yet. The page says nothing; where it does, or is gone, that is the end. A search
/// that nobody has watched for a while stops, until somebody watches again.
/// @param request an upgrade, which may be answered
boost::asio::awaitable<void> watch(
    boost::beast::tcp_stream stream,
    boost::beast::http::request<boost::beast::http::string_body> request,
    std::shared_ptr<Visitor> visitor, Api& api);

}  // namespace delos::server

// One connection of a browser.
#pragma once

#include <boost/asio/ip/tcp.hpp>

#include "server/api.h"
#include "server/awaitable.h"

namespace delos::server {

/// Answer its requests one after the other, until it ends or says nothing for a while.
boost::asio::awaitable<void> serve(boost::asio::ip::tcp::socket socket, Api& api,
                                   unsigned short port);

/// Tell it that there are too many, and end it.
boost::asio::awaitable<void> turn_away(boost::asio::ip::tcp::socket socket);

}  // namespace delos::server

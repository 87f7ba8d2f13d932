// Coroutines of Boost.Asio, whose header (1.74) forgets one of the standard's.
#pragma once

#include <boost/asio/awaitable.hpp>
#include <boost/asio/redirect_error.hpp>
#include <boost/asio/use_awaitable.hpp>
#include <utility>

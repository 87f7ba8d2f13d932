#include "server/explore.h"

#include <boost/asio/co_spawn.hpp>
#include <boost/asio/detached.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/steady_timer.hpp>
#include <chrono>
#include <string>
#include <system_error>
#include <utility>

#include "server/connection.h"

namespace delos::server {
namespace {

namespace asio = boost::asio;
using asio::ip::tcp;

constexpr int kMostConnections = 128;
constexpr std::chrono::milliseconds kPause{100};

/// Counts connections while they live.
class Counted {
 public:
  explicit Counted(int& count) : count_(count) { ++count_; }
  ~Counted() { --count_; }
  Counted(const Counted&) = delete;
  Counted& operator=(const Counted&) = delete;

 private:
  int& count_;
};

asio::awaitable<void> serve_counted(tcp::socket socket, Api& api, unsigned short port,
                                    int& connections) {
  const Counted counted(connections);
  if (connections > kMostConnections)
    co_await turn_away(std::move(socket));
  else
    co_await serve(std::move(socket), api, port);
}

asio::awaitable<void> listen(tcp::acceptor& acceptor, Api& api, int& connections) {
  const unsigned short port = acceptor.local_endpoint().port();
  while (acceptor.is_open()) {
    boost::system::error_code error;
    tcp::socket socket = co_await acceptor.async_accept(
        asio::redirect_error(asio::use_awaitable, error));
    if (error) {  // of descriptors there may be more in a while
      asio::steady_timer pause(acceptor.get_executor(), kPause);
      co_await pause.async_wait(asio::use_awaitable);
      continue;
    }
    co_spawn(acceptor.get_executor(),
             serve_counted(std::move(socket), api, port, connections), asio::detached);
  }
}

/// End all when asked to.
asio::awaitable<void> watch(asio::io_context& io, const std::atomic<bool>& stop) {
  asio::steady_timer pause(io);
  while (!stop) {
    pause.expires_after(kPause);
    co_await pause.async_wait(asio::use_awaitable);
  }
  io.stop();
}

/// @throws std::system_error
void bind(tcp::acceptor& acceptor, unsigned short port) {
  try {
    const tcp::endpoint here(asio::ip::address_v4::loopback(), port);
    acceptor.open(here.protocol());
    acceptor.set_option(tcp::acceptor::reuse_address(true));
    acceptor.bind(here);
    acceptor.listen();
  } catch (const boost::system::system_error& error) {
    throw std::system_error(error.code(), "port " + std::to_string(port));
  }
}

}  // namespace

void explore(const ExploreOptions& options, PluginRegistry& plugins,
             const std::atomic<bool>& stop,
             const std::function<void(const std::string& address)>& listening) {
  Api api(options.scene, plugins, options.threads);
  int connections = 0;
  asio::io_context io(1);
  tcp::acceptor acceptor(io);
  bind(acceptor, options.port);
  co_spawn(io, watch(io, stop), asio::detached);
  co_spawn(io, listen(acceptor, api, connections), asio::detached);
  listening("http://127.0.0.1:" + std::to_string(acceptor.local_endpoint().port()) +
            "/");
  io.run();
  api.stop();
}

}  // namespace delos::server

#include "interrupt.h"

#include <csignal>

namespace delos::cli {
namespace {

std::atomic<bool> g_requested = false;
static_assert(std::atomic<bool>::is_always_lock_free, "set from a signal handler");

void request(int) { g_requested = true; }

void handle(void (*handler)(int)) {
  struct sigaction action {};
  action.sa_handler = handler;
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction before {};
    sigaction(signal, nullptr, &before);
    // nohup ignores the end of the terminal: that remains so.
    if (before.sa_handler != SIG_IGN) sigaction(signal, &action, nullptr);
  }
}

}  // namespace

Interrupt::Interrupt() { handle(request); }
Interrupt::~Interrupt() { handle(SIG_DFL); }
const std::atomic<bool>& Interrupt::requested() const { return g_requested; }

}  // namespace delos::cli

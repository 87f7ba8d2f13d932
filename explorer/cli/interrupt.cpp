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
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

}  // namespace

Interrupt::Interrupt() { handle(request); }
Interrupt::~Interrupt() { handle(SIG_DFL); }
const std::atomic<bool>& Interrupt::requested() const { return g_requested; }

}  // namespace delos::cli

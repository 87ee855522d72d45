// SPDX-License-Identifier: MIT
#include "program/interrupt.h"

#include <atomic>
#include <csignal>

namespace planula {

namespace {

constexpr int signals[] = {SIGINT, SIGTERM, SIGUSR1};

// A handler may only set a flag.
std::atomic<bool> asked_to_stop{false};
static_assert(std::atomic<bool>::is_always_lock_free);

void ask_to_stop(int) { asked_to_stop = true; }

void set_handler(void (*handler)(int), int flags) {
    struct sigaction action {};
    action.sa_handler = handler;
    action.sa_flags = flags;
    for (const int number : signals) sigaction(number, &action, nullptr);
}

} // namespace

Interrupt::Interrupt() {
    asked_to_stop = false;
    set_handler(ask_to_stop, SA_RESTART | static_cast<int>(SA_RESETHAND));
}

Interrupt::~Interrupt() { set_handler(SIG_DFL, 0); }

bool Interrupt::requested() const { return asked_to_stop; }

} // namespace planula

// SPDX-License-Identifier: MIT
// SIGINT, SIGTERM and SIGUSR1 as a request to stop, as long as an Interrupt exists. The second signal of a kind has its
// usual effect.
#pragma once

namespace planula {

class Interrupt {
  public:
    Interrupt();
    ~Interrupt();
    Interrupt(const Interrupt &) = delete;
    Interrupt &operator=(const Interrupt &) = delete;

    /// Whether a signal came since the object was made.
    bool requested() const;
};

} // namespace planula

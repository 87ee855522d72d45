// SPDX-License-Identifier: MIT
// SIGINT, SIGTERM and SIGUSR1 as a wish to stop, for as long as an Interrupt lives. The second signal of a
// kind acts as if there were none.
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

// SPDX-License-Identifier: MIT
// Muscles: how the cells change the rest lengths of their springs over time (§2.5, 2.6; decisions 0011
// and 0012). A gait gives each cell's actuation signal; oscillators and networks are its two kinds. It
// senses nothing of the moving body, unless networks read their present place.
#pragma once

#include "body/body.h"
#include "cell/channels.h"
#include "cell/tissue.h"
#include "locomotion/muscle.h"
#include "network/network.h"
#include "parameters/parameters.h"

#include <memory>
#include <span>

namespace planula {

class Gait {
  public:
    virtual ~Gait() = default;

    /// Whether sense() must be called before each call of signals().
    virtual bool senses() const { return false; }
    /// Where the cells are, world frame.
    virtual void sense(std::span<const Vec2d>) {}
    /// The signal of each cell in [-1, 1] at step t, written to `signal`. Called once for each knot t = 0,
    /// knot_interval, 2·knot_interval, …, in this order.
    virtual void signals(int t, std::span<double> signal) = 0;
    /// The body loses all cells but these, ascending; `links` are those among them, by their new numbers.
    virtual void keep(std::span<const int> cells, std::span<const Link> links) = 0;
    /// Those of the cells' networks after the newest update; null with oscillators.
    virtual const Activations *activations() const { return nullptr; }
    /// b_a of Eq. (5) over the updates so far; 0 with oscillators.
    virtual double activity() const { return 0; }
    /// False once an activation is not finite.
    virtual bool is_sound() const { return true; }
};

/// The gait of a body whose cells ended development in this state. Network, body and parameters must outlive
/// it.
std::unique_ptr<Gait> make_gait(Actuation actuation, const Network &network, const Body &body,
                                const Tissue &tissue, const Parameters &parameters);

/// The same gait, but its signals stay as they are at the first knot at or after step `from`.
std::unique_ptr<Gait> hold(std::unique_ptr<Gait> gait, int from);

} // namespace planula

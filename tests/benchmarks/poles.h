// SPDX-License-Identifier: MIT
// Balancing one or two poles on a cart by pushing it (Wieland 1991; the equations, numbers and rules of success of
// Stanley & Miikkulainen 2002, section 4 and appendix B). The track is 4.8 m long, the poles 1 m and 0.1 m; the
// push, from −10 to 10 N, changes every 0.02 s; motion is integrated by the classical Runge–Kutta method in steps
// of 0.01 s.
//
// With velocities a network sees the whole state and is solved once it balances for 100 000 pushes (over 30
// minutes). Without them it must remember. Then, for two poles, fitness is Gruau's (1996), which rewards calm, and
// a network solves the task if it balances for 100 000 pushes and, from at least 200 of 625 starts spread over the
// state space, for 1000.
#pragma once

#include "benchmarks/task.h"

#include <array>

namespace planula::benchmark {

/// Place and velocity of the cart, angle and angular velocity of the long and of the short pole; m, s and rad, the
/// angle from the upright to the right.
using Cart = std::array<double, 6>;

struct PoleSetup {
    int poles;             // 1 or 2
    bool shows_velocities; // to the policy
    double angle_limit;    // rad; a pole that leans further has fallen
};

PoleSetup one_pole(bool shows_velocities);  // falls beyond 12 degrees
PoleSetup two_poles(bool shows_velocities); // fall beyond 36 degrees

/// Change of the state per second under a push in N to the right. With one pole the short one stands still.
Cart change(const PoleSetup &setup, const Cart &cart, double push);
/// The state 0.02 s later.
Cart pushed(const PoleSetup &setup, const Cart &cart, double push);
/// Whether a pole has fallen or the cart has left the track.
bool has_failed(const PoleSetup &setup, const Cart &cart);

/// At rest in the middle of the track, the long pole leaning by 1 degree.
inline constexpr Cart standard_start{0, 0, 3.14159265358979323846 / 180, 0, 0, 0};

struct Balance {
    int pushes; // until failure, or the limit
    double
        unrest; // Σ |x| + |v| + |angle| + |angular velocity| of cart and long pole after the last 100 pushes
};

/// Inputs: the states that are shown, scaled to about [−1, 1], then the bias; one output, times 10 N.
Balance balance(const PoleSetup &setup, Cart cart, Policy policy, int limit);

/// 0.1 t/1000 + 0.9 f with f = 0 before 100 pushes, then 0.75/unrest.
double gruau_fitness(const Balance &balance);
/// From how many of the 625 starts the policies that `make` returns balance for 1000 pushes.
int generalisation(const PoleSetup &setup, const std::function<Policy()> &make);

Task pole_task(int poles, bool shows_velocities);

} // namespace planula::benchmark

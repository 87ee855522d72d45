// SPDX-License-Identifier: MIT
#include "benchmarks/poles.h"

#include "base/math.h"

#include <cmath>

namespace planula::benchmark {

namespace {

constexpr double gravity = 9.8, cart_mass = 1, track_half = 2.4, strength = 10, time_step = 0.01;
constexpr int steps_per_push = 2, long_run = 100'000, short_run = 1000, calm_window = 100;
constexpr double hinge_friction = 2e-6;
constexpr double degree = math::pi / 180;

struct Pole {
    double half_length, mass;
};
constexpr std::array<Pole, 2> poles{Pole{0.5, 0.1}, Pole{0.05, 0.01}};

/// What the state is divided by before a network sees it.
constexpr std::array<double, 6> scale{4.8, 2, 0.52, 2, 0.52, 2};
constexpr double bias = 0.5;

Cart moved(const Cart &cart, const Cart &rate, double time) {
    Cart result;
    for (std::size_t i = 0; i < cart.size(); ++i) result[i] = cart[i] + time * rate[i];
    return result;
}

/// The places and, if shown, the velocities in their order, then the bias.
std::size_t observe(const PoleSetup &setup, const Cart &cart, std::array<double, 7> &inputs) {
    std::size_t count = 0;
    for (int i = 0; i < 2 + 2 * setup.poles; ++i)
        if (i % 2 == 0 || setup.shows_velocities) inputs[count++] = cart[i] / scale[i];
    inputs[count++] = bias;
    return count;
}

} // namespace

PoleSetup one_pole(bool shows_velocities) { return {1, shows_velocities, 12 * degree}; }
PoleSetup two_poles(bool shows_velocities) { return {2, shows_velocities, 36 * degree}; }

Cart change(const PoleSetup &setup, const Cart &cart, double push) {
    // Each pole pushes the cart by its effective force and adds its effective mass.
    std::array<double, 2> cosine{}, pull{};
    double force = push, mass = cart_mass;
    for (int i = 0; i < setup.poles; ++i) {
        const auto &[half, m] = poles[i];
        const double angle = cart[2 + 2 * i], spin = cart[3 + 2 * i], sine = math::sin(angle);
        cosine[i] = math::cos(angle);
        pull[i] = hinge_friction * spin / (m * half) - gravity * sine;
        force += m * half * spin * spin * sine + 0.75 * m * cosine[i] * pull[i];
        mass += m * (1 - 0.75 * cosine[i] * cosine[i]);
    }

    Cart rate{};
    rate[0] = cart[1];
    rate[1] = force / mass;
    for (int i = 0; i < setup.poles; ++i) {
        rate[2 + 2 * i] = cart[3 + 2 * i];
        rate[3 + 2 * i] = -0.75 * (rate[1] * cosine[i] + pull[i]) / poles[i].half_length;
    }
    return rate;
}

Cart pushed(const PoleSetup &setup, const Cart &cart, double push) {
    Cart now = cart;
    for (int step = 0; step < steps_per_push; ++step) {
        const Cart first = change(setup, now, push);
        const Cart second = change(setup, moved(now, first, time_step / 2), push);
        const Cart third = change(setup, moved(now, second, time_step / 2), push);
        const Cart fourth = change(setup, moved(now, third, time_step), push);
        for (std::size_t i = 0; i < now.size(); ++i)
            now[i] += time_step / 6 * (first[i] + 2 * second[i] + 2 * third[i] + fourth[i]);
    }
    return now;
}

bool has_failed(const PoleSetup &setup, const Cart &cart) {
    for (int i = 0; i < setup.poles; ++i)
        if (!(std::abs(cart[2 + 2 * i]) <= setup.angle_limit)) return true;
    return !(std::abs(cart[0]) <= track_half);
}

Balance balance(const PoleSetup &setup, Cart cart, Policy policy, int limit) {
    std::array<double, 7> inputs{};
    std::array<double, calm_window> unrest{};
    int pushes = 0;
    for (; pushes < limit; ++pushes) {
        const std::size_t count = observe(setup, cart, inputs);
        double output = 0;
        policy({inputs.data(), count}, {&output, 1});
        cart = pushed(setup, cart, strength * output);
        if (has_failed(setup, cart)) break;
        double &now = unrest[static_cast<std::size_t>(pushes % calm_window)];
        now = std::abs(cart[0]) + std::abs(cart[1]) + std::abs(cart[2]) + std::abs(cart[3]);
    }
    double sum = 0;
    for (const double each : unrest) sum += each;
    return {pushes, sum};
}

double gruau_fitness(const Balance &balance) {
    const double calm = balance.pushes < calm_window ? 0 : 0.75 / balance.unrest;
    return 0.1 * balance.pushes / short_run + 0.9 * calm;
}

int generalisation(const PoleSetup &setup, const std::function<Policy()> &make) {
    // Place and velocity of the cart, angle and angular velocity of the long pole at five shares of their ranges.
    constexpr std::array<double, 5> shares{0.05, 0.25, 0.5, 0.75, 0.95};
    constexpr std::array<double, 4> range{2.16, 1.35, 3.6 * degree, 8.6 * degree};
    int balanced = 0;
    for (int number = 0; number < 625; ++number) {
        Cart start{};
        for (int i = 0, digits = number; i < 4; ++i, digits /= 5)
            start[i] = (2 * shares[digits % 5] - 1) * range[i];
        balanced += balance(setup, start, make(), short_run).pushes == short_run;
    }
    return balanced;
}

Task pole_task(int count, bool shows_velocities) {
    const PoleSetup setup = count == 1 ? one_pole(shows_velocities) : two_poles(shows_velocities);
    const bool recurrent = !shows_velocities, calm = count == 2 && !shows_velocities;
    const int inputs = (1 + count) * (shows_velocities ? 2 : 1) + 1;
    Task task{shows_velocities ? (count == 1 ? "one-pole" : "two-poles")
                               : (count == 1 ? "one-pole-no-velocities" : "two-poles-no-velocities"),
              {inputs, 1, recurrent},
              [=](const Genome &genome) {
                  const Balance done = balance(setup, standard_start, Controller(genome, recurrent),
                                               calm ? short_run : long_run);
                  const double fitness = calm ? gruau_fitness(done) : done.pushes;
                  return Attempt{fitness, {fitness}, !calm && done.pushes == long_run};
              }};
    if (calm)
        task.examine = [=](const Genome &genome) {
            const auto make = [&] { return Policy(Controller(genome, recurrent)); };
            return balance(setup, standard_start, make(), long_run).pushes == long_run &&
                   generalisation(setup, make) >= 200;
        };
    return task;
}

} // namespace planula::benchmark

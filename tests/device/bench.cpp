// SPDX-License-Identifier: MIT
// Trials per second on the graphics processor and on all cores of the same machine, by actuation, world and size, and
// embryos per second on all cores, which bound what a whole evaluation can take. Every case compares some trials to the
// bit. Prints a table.
//
//   device_bench [SECONDS]     how long each number is measured (default: 1)
//   device_bench --once N      N trials of 100 cells on land, once, for profilers
#include "base/error.h"
#include "base/parallel.h"
#include "bench/cases.h"
#include "development/grow.h"
#include "device/device.h"
#include "network/network.h"
#include "physics/embody.h"
#include "physics/native/native_engine.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <iostream>
#include <string>

using namespace planula;

namespace {

/// A body that is ready to move.
struct Animat {
    Conditions conditions;
    Genome genome;
    Network network = express(genome, conditions.parameters.network.propagation_limit);
    Growth growth = grow(network, conditions.actuation, conditions.parameters);
    SoftBodyModel model = embody(growth.body, conditions.environment, conditions.parameters.body,
                                 conditions.parameters.development.time_step);

    std::unique_ptr<Gait> gait() const {
        return make_gait(conditions.actuation, network, growth.body, growth.tissue, conditions.parameters);
    }
    Trial here() const {
        NativeEngine engine;
        return locomote(model, conditions.environment, conditions.actuation_range, conditions.parameters,
                        *gait(), engine);
    }
    Trial on(Device &device) const {
        auto trial = device.locomote(model, conditions.environment, conditions.actuation_range,
                                     conditions.parameters, *gait());
        if (!trial) throw InternalError("the device does not simulate this trial");
        return std::move(*trial);
    }
};

bool same(const Trial &a, const Trial &b) {
    return a.outcome == b.outcome && a.settle_steps == b.settle_steps && a.rest == b.rest &&
           a.finish == b.finish && a.path == b.path && a.activity == b.activity &&
           a.late_actuation == b.late_actuation;
}

/// How often a second some threads do a task, over this time or a little more.
double rate_of(int threads, double seconds, const std::function<void()> &task) {
    using Clock = std::chrono::steady_clock;
    const auto elapsed = [start = Clock::now()] {
        return std::chrono::duration<double>(Clock::now() - start).count();
    };
    std::atomic<long> done = 0;
    parallel_for(threads, threads, [&](int) {
        do task(), ++done;
        while (elapsed() < seconds);
    });
    return static_cast<double>(done) / elapsed();
}

void measure(const std::string &name, const Animat &animat, Device &device, double seconds) {
    const Trial expected = animat.here();
    std::atomic<long> different = 0;
    const double there =
        rate_of(device.trials_at_once(), seconds, [&] { different += !same(animat.on(device), expected); });
    const double here = rate_of(hardware_threads(), seconds, [&] { animat.here(); });
    const double embryos = rate_of(hardware_threads(), seconds, [&] {
        grow(animat.network, animat.conditions.actuation, animat.conditions.parameters);
    });
    std::cout << name << ',' << animat.growth.cells << ',' << there << ',' << here << ',' << there / here
              << ',' << embryos << ',' << different << std::endl;
}

std::vector<std::pair<std::string, Genome>> genomes(Actuation actuation) {
    return {{"small disc", specimens::disc_genome(actuation, 9)},
            {"disc", specimens::disc_genome(actuation)},
            {"hundred", cases::hundred_genome(actuation)},
            {"large disc", specimens::disc_genome(actuation, 18)}};
}

} // namespace

int main(int count, char **words) try {
    const auto device = open_gpu();
    if (count == 3 && std::string(words[1]) == "--once") {
        const Animat animat{cases::conditions(Actuation::oscillator, cases::worlds[1]),
                            cases::hundred_genome(Actuation::oscillator)};
        parallel_for(std::stoi(words[2]), std::stoi(words[2]), [&](int) { animat.on(*device); });
        return 0;
    }
    const double seconds = count > 1 ? std::stod(words[1]) : 1;
    std::cout << "case,cells,device_trials_per_second,cores_trials_per_second,ratio,cores_embryos_per_second,"
                 "different\n";
    for (const Actuation actuation : {Actuation::oscillator, Actuation::grn})
        for (const cases::World &world : cases::worlds)
            for (const auto &[name, genome] : genomes(actuation))
                measure(std::string(name_of(actuation)) + ' ' + world.name + ' ' + name,
                        {cases::conditions(actuation, world), genome}, *device, seconds);
    return 0;
} catch (const Error &error) {
    std::cerr << "device_bench: " << error.what() << '\n';
    return error.code;
}

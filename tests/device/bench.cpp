// SPDX-License-Identifier: MIT
// Trials and whole lives per second on the graphics processor and on all cores of the same machine, by actuation, world
// and size, and embryos per second on all cores, which bound what lives can take. All results are compared to the bit.
//
//   device_bench [SECONDS]            a table; how long each number is measured (default: 1)
//   device_bench --pipeline SECONDS   lives per second by the threads that grow bodies and by the size of batches
//   device_bench --launch N           N trials of 100 cells on land in one launch, for profilers
//
// Exits with 1 if something differs.
#include "base/error.h"
#include "base/parallel.h"
#include "bench/cases.h"
#include "development/grow.h"
#include "device/device.h"
#include "device/pack.h"
#include "evaluation/live.h"
#include "network/network.h"
#include "physics/embody.h"
#include "physics/native/native_engine.h"
#include "support/trials.h"

#include <atomic>
#include <chrono>
#include <iostream>
#include <string>

using namespace planula;

namespace {

/// A runner, or a part of it, for a Device that is not to own it.
class PartOf final : public device::Runner {
  public:
    PartOf(device::Runner &runner, int batches, int largest_batch)
        : runner_(runner), batches_(batches), largest_batch_(largest_batch) {}

    int batches() const override { return batches_; }
    int largest_batch() const override { return largest_batch_; }
    unsigned fast_bytes() const override { return runner_.fast_bytes(); }
    int threads() const override { return runner_.threads(); }
    void run(int batch, std::span<device::Job *const> jobs) override { runner_.run(batch, jobs); }

  private:
    device::Runner &runner_;
    int batches_, largest_batch_;
};

/// An individual whose body is ready to move.
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
    Trial trial() const {
        NativeEngine engine;
        return locomote(model, conditions.environment, conditions.actuation_range, conditions.parameters,
                        *gait(), engine);
    }
    device::Job job() const {
        auto input = device::pack(model, conditions.environment, conditions.actuation_range,
                                  conditions.parameters, *gait());
        if (!input) throw InternalError("devices do not simulate this trial");
        std::vector<std::byte> result(device::task_of(*input).result_bytes);
        return {std::move(*input), std::move(result)};
    }
    Life life() const { return live(genome, conditions); }
};

/// Runs as many trials in one launch. Returns how many differ from the processor's.
int launch(device::Runner &runner, const Animat &animat, int count) {
    std::vector<device::Job> jobs(count, animat.job());
    std::vector<device::Job *> pointers;
    for (device::Job &job : jobs) pointers.push_back(&job);
    runner.run(0, pointers);
    const Trial expected = animat.trial();
    int different = 0;
    for (const device::Job &job : jobs)
        different += !test::same(device::unpack(job.input, job.result), expected);
    return different;
}

using Clock = std::chrono::steady_clock;
double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

/// How often a second some threads do a task, over this time or a little more.
double rate_of(int threads, double seconds, const std::function<void()> &task) {
    const Clock::time_point start = Clock::now();
    std::atomic<long> done = 0;
    parallel_for(threads, threads, [&](int) {
        do task(), ++done;
        while (seconds_since(start) < seconds);
    });
    return static_cast<double>(done) / seconds_since(start);
}

/// Trials per second in launches of as many at a time, copies included.
double rate_of_launches(device::Runner &runner, const Animat &animat, double seconds) {
    constexpr int together = 2048;
    std::vector<device::Job> jobs(together, animat.job());
    std::vector<device::Job *> pointers;
    for (device::Job &job : jobs) pointers.push_back(&job);
    runner.run(0, pointers); // finds memory
    return together * rate_of(1, seconds, [&] { runner.run(0, pointers); });
}

/// Lives per second, by threads that wait for the device, or of all cores without it.
double rate_of_lives(Device *device, int threads, const Animat &animat, double seconds,
                     std::atomic<long> &different) {
    const Life expected = animat.life();
    choose_device(device);
    const double rate = rate_of(threads, seconds, [&] { different += animat.life() != expected; });
    choose_device(nullptr);
    return rate;
}

/// Prints a row of the table. Returns how many results differ.
long measure(const std::string &name, const Animat &animat, device::Runner &runner, double seconds) {
    const int cores = hardware_threads();
    Device device(std::make_unique<PartOf>(runner, runner.batches(), runner.largest_batch()));
    std::atomic<long> different = launch(runner, animat, 33);
    const double launched = rate_of_launches(runner, animat, seconds);
    const double trials = rate_of(cores, seconds, [&] { animat.trial(); });
    const double embryos = rate_of(cores, seconds, [&] {
        grow(animat.network, animat.conditions.actuation, animat.conditions.parameters);
    });
    const double on_device = rate_of_lives(&device, device.trials_at_once(), animat, seconds, different);
    const double on_cores = rate_of_lives(nullptr, cores, animat, seconds, different);
    std::cout << name << ',' << animat.growth.cells << ',' << launched << ',' << trials << ',' << embryos
              << ',' << on_device << ',' << on_cores << ',' << different << std::endl;
    return different;
}

std::vector<std::pair<std::string, Genome>> genomes(Actuation actuation) {
    return {{"small disc", specimens::disc_genome(actuation, 9)},
            {"disc", specimens::disc_genome(actuation)},
            {"hundred", cases::hundred_genome(actuation)},
            {"large disc", specimens::disc_genome(actuation, 18)}};
}

long print_table(device::Runner &runner, double seconds) {
    long different = 0;
    std::cout << "case,cells,launched_trials_per_second,cores_trials_per_second,cores_embryos_per_second,"
                 "device_lives_per_second,cores_lives_per_second,different"
              << std::endl;
    for (const Actuation actuation : {Actuation::oscillator, Actuation::grn})
        for (const cases::World &world : cases::worlds)
            for (const auto &[name, genome] : genomes(actuation))
                different += measure(std::string(name_of(actuation)) + ' ' + world.name + ' ' + name,
                                     {cases::conditions(actuation, world), genome}, runner, seconds);
    return different;
}

Animat hundred_cells() {
    return {cases::conditions(Actuation::oscillator, cases::worlds[1]),
            cases::hundred_genome(Actuation::oscillator)};
}

long print_pipeline(device::Runner &runner, double seconds) {
    const Animat animat = hundred_cells();
    long all_different = 0;
    std::cout << "threads,batches,largest_batch,lives_per_second,different" << std::endl;
    for (const int threads : {256, 512, 1024, 2048})
        for (const auto &[batches, largest] : {std::pair(8, 64), {8, 128}, {16, 32}, {16, 64}, {16, 128}}) {
            Device device(std::make_unique<PartOf>(runner, batches, largest));
            std::atomic<long> different = 0;
            const double rate = rate_of_lives(&device, threads, animat, seconds, different);
            std::cout << threads << ',' << batches << ',' << largest << ',' << rate << ',' << different
                      << std::endl;
            all_different += different;
        }
    return all_different;
}

} // namespace

int main(int count, char **words) try {
    const std::string mode = count == 3 ? words[1] : "";
    const double number = count > 1 ? std::stod(words[count - 1]) : 1;
    const auto runner = open_gpu();
    if (mode == "--launch") {
        const Clock::time_point start = Clock::now();
        const int different = launch(*runner, hundred_cells(), static_cast<int>(number));
        std::cout << number << " trials in " << seconds_since(start) << " s, " << different << " differ\n";
        return different > 0;
    }
    return (mode == "--pipeline" ? print_pipeline(*runner, number) : print_table(*runner, number)) > 0;
} catch (const Error &error) {
    std::cerr << "device_bench: " << error.what() << '\n';
    return error.code;
}

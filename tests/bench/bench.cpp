// SPDX-License-Identifier: MIT
// How long the parts of an evaluation take on this machine (`make bench`): a physics step by engine, world and size,
// the native step by width of lanes, a network update, an embryo, a whole life. Time per iteration is time per step,
// update, embryo or life; processor time, so that other programs disturb it less. The last lines say how many of
// Bullet's steps a native step is worth, from the same run.
//
//   bench [options of Google Benchmark]
#include "base/math.h"
#include "development/grow.h"
#include "evaluation/live.h"
#include "physics/embody.h"
#include "physics/native/native_engine.h"
#include "support/specimens.h"

#include <benchmark/benchmark.h>

#include <cstdio>
#include <map>
#include <string>

using namespace planula;
using namespace planula::specimens;

namespace {

struct World {
    const char *name;
    Environment environment;
};
const World worlds[] = {{"water", water()}, {"land", land()}};

struct Size {
    int columns, rows;
};
constexpr Size sizes[] = {{6, 5}, {10, 10}, {20, 10}};

Conditions conditions(Actuation actuation, const World &world) {
    Conditions result;
    const Parameters &p = result.parameters;
    result.actuation = actuation;
    result.environment = world.environment;
    result.actuation_range =
        world.environment.has_ground ? p.actuation_range_terrestrial : p.actuation_range_aquatic;
    return result;
}

/// Elongations of a wave along the body at the knots of ten of its periods.
std::vector<std::vector<double>> wave(const SoftBodyModel &model) {
    std::vector<std::vector<double>> knots(100);
    for (std::size_t knot = 0; knot < knots.size(); ++knot)
        for (const Vec2d p : model.positions)
            knots[knot].push_back(
                0.15 * math::sin(0.2 * math::pi * static_cast<double>(knot) + 0.4 * p.x + 0.1 * p.y));
    return knots;
}

/// One iteration is one step of a lattice on which a wave runs.
void physics_step(benchmark::State &state, Engine &engine, const World &world, Size size) {
    const Parameters parameters;
    const auto model = embody(lattice(size.columns, size.rows), world.environment, parameters);
    const auto knots = wave(model);
    engine.load(model, world.environment);
    int step = 0;
    for (auto _ : state) {
        const int knot = step / parameters.knot_interval;
        if (step++ % parameters.knot_interval == 0)
            engine.actuate(knots[knot % knots.size()], parameters.knot_interval);
        benchmark::DoNotOptimize(engine.step(0));
    }
}

/// One iteration is one update of 100 cells.
void network_update(benchmark::State &state, Actuation actuation) {
    const Network network = express(random_genome(actuation, 1), Parameters{}.propagation_limit);
    constexpr int cells = 100;
    Activations activations(network.nodes, cells);
    for (int cell = 0; cell < cells; ++cell)
        for (int node = 0; node < network.nodes; ++node) activations.at(cell, node) = 0.01 * cell;
    for (auto _ : state) {
        actuation == Actuation::grn ? step(network, activations) : evaluate(network, activations);
        benchmark::ClobberMemory();
    }
}

void embryo(benchmark::State &state, Actuation actuation, const Genome &genome) {
    const Parameters parameters;
    const Network network = express(genome, parameters.propagation_limit);
    int cells = 0;
    for (auto _ : state) cells = grow(network, actuation, parameters).cells;
    state.counters["cells"] = cells;
}

void whole_life(benchmark::State &state, const Conditions &given, const Genome &genome) {
    Life life;
    for (auto _ : state) life = live(genome, given);
    state.counters["cells"] = life.cells;
    state.counters["settling"] = life.settle_steps;
}

std::string step_name(std::string_view engine, const World &world, Size size) {
    return "step/" + std::string(engine) + "/" + world.name + "/" + std::to_string(size.columns * size.rows);
}

void list_benchmarks() {
    using benchmark::RegisterBenchmark;
    for (const World &world : worlds)
        for (const Size size : sizes)
            for (const std::string_view name : engine_names())
                RegisterBenchmark(step_name(name, world, size).c_str(), [=, &world](auto &state) {
                    physics_step(state, *make_engine(name), world, size);
                });
    for (const native::Kernel &kernel : native::kernels())
        RegisterBenchmark(("lanes/" + std::string(kernel.name)).c_str(), [&](auto &state) {
            NativeEngine engine(kernel);
            physics_step(state, engine, worlds[0], sizes[1]);
        });

    for (const auto &[name, actuation] :
         {std::pair("osc", Actuation::oscillator), std::pair("grn", Actuation::grn)}) {
        const std::string kind = name;
        RegisterBenchmark(("network/" + kind).c_str(), network_update, actuation);
        const std::pair<const char *, Genome> genomes[] = {{"disc", disc_genome(actuation)},
                                                           {"two_legged", two_legged_genome(actuation)}};
        for (const auto &[body, genome] : genomes) {
            const std::string suffix = "/" + kind + "/" + body;
            RegisterBenchmark(("embryo" + suffix).c_str(), embryo, actuation, genome);
            for (const World &world : worlds)
                RegisterBenchmark(("life" + suffix + "/" + world.name).c_str(), whole_life,
                                  conditions(actuation, world), genome);
        }
    }
}

/// The usual table, and the times kept by name.
class Reporter : public benchmark::ConsoleReporter {
  public:
    void ReportRuns(const std::vector<Run> &runs) override {
        for (const Run &run : runs) times[run.benchmark_name()] = run.GetAdjustedCPUTime();
        ConsoleReporter::ReportRuns(runs);
    }
    std::map<std::string, double> times;
};

} // namespace

int main(int argc, char **argv) {
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
    list_benchmarks();
    Reporter reporter;
    benchmark::RunSpecifiedBenchmarks(&reporter);
    for (const World &world : worlds)
        for (const Size size : sizes) {
            const auto native = reporter.times.find(step_name("native", world, size));
            const auto bullet = reporter.times.find(step_name("bullet", world, size));
            if (native == reporter.times.end() || bullet == reporter.times.end()) continue;
            std::printf("Bullet : native on %s at %d cells: %.1f\n", world.name, size.columns * size.rows,
                        bullet->second / native->second);
        }
}

// SPDX-License-Identifier: MIT
// How long the parts of an evaluation take on this machine (`make bench`): a physics step by engine, world and size,
// the native step by width of lanes, a network update, an embryo, a query of novelty, a whole life. Time per iteration
// is time per step, update, embryo, query or life; processor time, so that other programs disturb it less. The last
// lines say how many native steps take as long as one of the reference engine and one of Bullet, from the same run.
//
//   bench [FILE.csv] [options of Google Benchmark]   FILE.csv: measure, value, unit
//   bench --machine                                  what the CSV of this machine is called: processor and lanes
#include "bench/cases.h"
#include "development/grow.h"
#include "evaluation/live.h"
#include "physics/embody.h"
#include "physics/native/native_engine.h"

#include <benchmark/benchmark.h>

#include <cctype>
#include <cstdio>
#include <fstream>
#include <locale>
#include <string>
#include <utility>

using namespace planula;
using namespace planula::cases;
using namespace planula::specimens;

namespace {

/// One iteration is one step of a lattice on which a wave runs.
void physics_step(benchmark::State &state, Engine &engine, const World &world, Size size) {
    Swimmer swimmer(engine, soft_body(lattice(size.columns, size.rows), world.environment, {}),
                    world.environment);
    for (auto _ : state) benchmark::DoNotOptimize(swimmer.step());
}

/// One iteration is one update of 100 cells.
void network_update(benchmark::State &state, Actuation actuation) {
    const Network network = express(random_genome(actuation, 1), NetworkParameters{}.propagation_limit);
    Activations activations = hundred_cells(network);
    for (auto _ : state) {
        actuation == Actuation::grn ? step(network, activations) : evaluate(network, activations);
        benchmark::ClobberMemory();
    }
}

/// One iteration looks for the neighbours of one individual in an archive.
void novelty_query(benchmark::State &state, int archived) {
    const PointIndex archive = end_points(archived, 1);
    double x = -10;
    for (auto _ : state) {
        NearestNeighbours nearest(NoveltyParameters{}.novelty_neighbours);
        archive.offer(std::vector{x, 0.5 * x}, 0, nearest);
        benchmark::DoNotOptimize(nearest.list().back());
        x = x > 10 ? -10 : x + 0.37;
    }
}

void embryo(benchmark::State &state, Actuation actuation, const Genome &genome) {
    const Parameters parameters = specimens::turning();
    const Network network = express(genome, parameters.network.propagation_limit);
    int cells = 0;
    for (auto _ : state) cells = grow(network, actuation, parameters).cells;
    state.counters["cells"] = cells;
}

void whole_life(benchmark::State &state, const Conditions &given, const Genome &genome) {
    Life life;
    for (auto _ : state) life = live(genome, given);
    state.counters["cells"] = life.cells;
    state.counters["settling"] = life.settle_steps;
    state.counters["per_core_second"] = benchmark::Counter(1, benchmark::Counter::kIsIterationInvariantRate);
}

std::string step_name(std::string_view engine, const World &world, Size size) {
    return "step/" + std::string(engine) + "/" + world.name + "/" + std::to_string(size.cells());
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

    for (const int archived : {1000, 10000})
        RegisterBenchmark(("novelty/" + std::to_string(archived)).c_str(), novelty_query, archived);
    for (const auto &[name, actuation] :
         {std::pair("osc", Actuation::oscillator), std::pair("grn", Actuation::grn)}) {
        const std::string kind = name;
        RegisterBenchmark(("network/" + kind).c_str(), network_update, actuation);
        const std::pair<const char *, Genome> genomes[] = {{"small_disc", disc_genome(actuation, 8)},
                                                           {"disc", disc_genome(actuation)},
                                                           {"large_disc", disc_genome(actuation, 20)},
                                                           {"hundred", hundred_genome(actuation)},
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

/// The usual table, and the times by name, in nanoseconds.
class Reporter : public benchmark::ConsoleReporter {
  public:
    Reporter() : ConsoleReporter(OO_None) {}
    void ReportRuns(const std::vector<Run> &runs) override {
        for (const Run &run : runs) times.emplace_back(run.benchmark_name(), run.GetAdjustedCPUTime());
        ConsoleReporter::ReportRuns(runs);
    }
    /// 0 if it was not measured.
    double time_of(const std::string &name) const {
        for (const auto &[each, time] : times)
            if (each == name) return time;
        return 0;
    }
    std::vector<std::pair<std::string, double>> times;
};

/// How many native steps take as long as one of another engine, by world and size.
std::vector<std::pair<std::string, double>> ratios(const Reporter &reporter) {
    std::vector<std::pair<std::string, double>> result;
    for (const World &world : worlds)
        for (const Size size : sizes) {
            const double native = reporter.time_of(step_name("native", world, size));
            for (const std::string other : {"reference", "bullet"}) {
                const double time = reporter.time_of(step_name(other, world, size));
                if (native > 0 && time > 0)
                    result.emplace_back(step_name(other + ":native", world, size), time / native);
            }
        }
    return result;
}

void write_csv(const char *path, const Reporter &reporter) {
    std::ofstream file(path);
    file.imbue(std::locale::classic());
    file.precision(4);
    file << "measure,value,unit\n";
    for (const auto &[name, time] : reporter.times) file << name << ',' << time / 1000 << ",us\n";
    for (const auto &[name, ratio] : ratios(reporter)) file << name << ',' << ratio << ",1\n";
    for (const auto &[name, time] : reporter.times)
        if (name.starts_with("life/"))
            file << "evaluations" << name.substr(4) << ',' << 1e9 / time << ",evaluations/core-second\n";
}

/// Processor and lanes, in letters, digits and dashes; no name of a host.
std::string machine() {
    std::ifstream info("/proc/cpuinfo");
    std::string model = "unknown processor";
    for (std::string line; std::getline(info, line);)
        if (line.starts_with("model name")) {
            model = line.substr(line.find(':') + 1);
            break;
        }
    std::string name;
    for (const char c : model + ' ' + native::chosen_kernel().name)
        if (std::isalnum(static_cast<unsigned char>(c)))
            name += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        else if (!name.empty() && name.back() != '-')
            name += '-';
    return name;
}

} // namespace

int main(int argc, char **argv) {
    if (argc == 2 && argv[1] == std::string("--machine")) return std::puts(machine().c_str()), 0;
    benchmark::Initialize(&argc, argv);
    const char *path = argc > 1 && argv[1][0] != '-' ? argv[1] : nullptr;
    if (benchmark::ReportUnrecognizedArguments(path ? argc - 1 : argc, path ? argv + 1 : argv)) return 2;
    list_benchmarks();
    Reporter reporter;
    benchmark::RunSpecifiedBenchmarks(&reporter);
    for (const auto &[name, ratio] : ratios(reporter)) std::printf("%-30s %8.1f\n", name.c_str(), ratio);
    if (path) write_csv(path, reporter);
}

// SPDX-License-Identifier: MIT
// Fixed pieces of work whose instructions are counted (tests/bench/instructions.sh): a guard against regressions where
// a clock is too noisy.
//
//   work              lists the pieces
//   work PIECE        does one
//   work --compiler   who compiled it: another compiler needs other instructions
#include "base/lane_sets.h"
#include "bench/cases.h"
#include "development/grow.h"
#include "evaluation/live.h"
#include "physics/embody.h"
#include "physics/native/native_engine.h"

#include <cstdio>
#include <functional>
#include <string>
#include <utility>
#include <vector>

using namespace planula;
using namespace planula::cases;

namespace {

using Piece = std::pair<std::string, std::function<double()>>;

/// Steps of 100 cells; with contact, of a body whose arms touch.
double steps(const native::Kernel &kernel, const World &world, const Body &body) {
    NativeEngine engine(kernel);
    Swimmer swimmer(engine, specimens::soft_body(body, world.environment), world.environment);
    double sum = 0;
    for (int i = 0; i < 2000; ++i) sum += swimmer.step().fastest;
    return sum;
}

/// Updates of 100 cells.
double network_updates(Actuation actuation) {
    const Network network =
        express(specimens::random_genome(actuation, 1), NetworkParameters{}.propagation_limit);
    Activations activations = hundred_cells(network);
    for (int i = 0; i < 500; ++i)
        actuation == Actuation::grn ? step(network, activations) : evaluate(network, activations);
    return activations.at(0, network.nodes - 1);
}

double embryo(Actuation actuation) {
    const Parameters parameters = specimens::turning();
    const Network network = express(specimens::disc_genome(actuation), parameters.network.propagation_limit);
    return grow(network, actuation, parameters).cells;
}

double life(Actuation actuation, const World &world) {
    return live(specimens::disc_genome(actuation), conditions(actuation, world)).displacement();
}

double novelty_queries() {
    const PointIndex archive = end_points(2000, 1), asked = end_points(300, 2);
    NearestNeighbours all(300);
    asked.offer(std::vector{0.0, 0.0}, 0, all);
    double sum = 0;
    for (const Neighbour &each : all.list()) {
        NearestNeighbours nearest(NoveltyParameters{}.novelty_neighbours);
        archive.offer(std::vector{each.squared, 1.0}, 0, nearest);
        sum += nearest.list().back().squared;
    }
    return sum;
}

std::vector<Piece> pieces() {
    std::vector<Piece> list;
    for (const native::Kernel &kernel : native::kernels()) {
        const std::string lanes = kernel.name;
        if (lanes == "avx512") continue; // valgrind does not know it
        list.emplace_back("steps/" + lanes + "/water",
                          [&] { return steps(kernel, worlds[0], specimens::lattice(10, 10)); });
        list.emplace_back("steps/" + lanes + "/land",
                          [&] { return steps(kernel, worlds[1], specimens::lattice(10, 10)); });
        list.emplace_back("steps/" + lanes + "/contact",
                          [&] { return steps(kernel, worlds[0], specimens::u_body(3)); });
    }
    for (const Actuation actuation : {Actuation::oscillator, Actuation::grn}) {
        const std::string name = name_of(actuation);
        list.emplace_back("network/" + name, [=] { return network_updates(actuation); });
        list.emplace_back("embryo/" + name, [=] { return embryo(actuation); });
        for (const World &world : worlds)
            list.emplace_back("life/" + name + "/" + world.name,
                              [=, &world] { return life(actuation, world); });
    }
    list.emplace_back("novelty", novelty_queries);
    return list;
}

} // namespace

int main(int argc, char **argv) {
    const std::string asked = argc > 1 ? argv[1] : "";
#if defined(__clang__)
    const std::string compiler = "clang " + std::to_string(__clang_major__);
#else
    const std::string compiler = "gcc " + std::to_string(__GNUC__);
#endif
    choose_lanes("scalar"); // the lives' and networks', on every processor
    if (asked == "--compiler") return std::puts(compiler.c_str()), 0;
    for (const auto &[name, work] : pieces()) {
        if (asked.empty()) std::puts(name.c_str());
        if (asked == name) return std::printf("%s: %.17g\n", name.c_str(), work()), 0;
    }
    return asked.empty() ? 0 : 2;
}

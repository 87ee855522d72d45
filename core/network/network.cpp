// SPDX-License-Identifier: MIT
#include "network/network.h"

#include "base/check.h"
#include "network/kernel.h"

#include <algorithm>
#include <unordered_map>

namespace planula {

namespace {

/// The longest input-to-output path by relaxation over the links; loops are cut off at `limit`.
int longest_path(const Network &network, int limit) {
    std::vector<int> reach(static_cast<std::size_t>(network.nodes), -1);
    std::fill_n(reach.begin(), network.inputs, 0);
    const auto longer = [&](int target) {
        int best = reach[target];
        const int row = target - network.inputs;
        for (int s = network.first_source[row]; s < network.first_source[row + 1]; ++s)
            if (const int from = reach[network.sources[s].node]; from >= 0) best = std::max(best, from + 1);
        return std::min(best, limit);
    };
    for (bool changed = true; changed;) {
        changed = false;
        for (int target = network.inputs; target < network.nodes; ++target)
            if (const int found = longer(target); found > reach[target])
                reach[target] = found, changed = true;
    }
    const auto outputs = reach.begin() + network.inputs;
    return std::max(0, *std::max_element(outputs, outputs + network.outputs));
}

/// So many synchronous steps.
bool advance(const Network &network, int steps, Activations &activations) {
    CHECK(activations.nodes() == network.nodes, activations.nodes(), network.nodes);
    const int targets = network.nodes - network.inputs;
    thread_local std::vector<double> next;
    next.resize(static_cast<std::size_t>(targets) * Activations::group_size);
    const neural::Task task{
        network.inputs,      targets,    network.sources.data(), network.first_source.data(), steps,
        activations.cells(), next.data()};
    return neural::kernel_for(chosen_lanes())(task, activations.values());
}

} // namespace

Network express(const Genome &genome, int propagation_limit) {
    Network network{
        .inputs = genome.inputs, .outputs = genome.outputs, .nodes = static_cast<int>(genome.nodes.size())};
    std::unordered_map<int, int> position; // looked up by id, never walked
    for (int i = 0; i < network.nodes; ++i) position[genome.nodes[i].id] = i;

    // Links by target, each group in the genome's order.
    std::vector<std::vector<Network::Source>> by_target(static_cast<std::size_t>(network.nodes));
    for (const LinkGene &link : genome.links)
        by_target[position.at(link.to)].push_back({position.at(link.from), link.weight});
    for (int i = 0; i < network.inputs; ++i) CHECK(by_target[i].empty());
    for (int target = network.inputs; target < network.nodes; ++target) {
        network.first_source.push_back(static_cast<int>(network.sources.size()));
        network.sources.insert(network.sources.end(), by_target[target].begin(), by_target[target].end());
    }
    network.first_source.push_back(static_cast<int>(network.sources.size()));
    network.depth = longest_path(network, propagation_limit);
    return network;
}

bool step(const Network &network, Activations &activations) { return advance(network, 1, activations); }

bool evaluate(const Network &network, Activations &activations) {
    for (int node = network.inputs; node < network.nodes; ++node)
        for (int cell = 0; cell < activations.cells(); ++cell) activations.at(cell, node) = 0;
    return advance(network, network.depth, activations);
}

} // namespace planula

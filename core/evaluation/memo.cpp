// SPDX-License-Identifier: MIT
#include "evaluation/memo.h"

#include "base/check.h"

#include <utility>

namespace planula {

namespace {

template <class Number> void append(Number value, std::string &key) {
    key.append(reinterpret_cast<const char *>(&value), sizeof value);
}

/// All of a genome that a network is expressed from: nodes and links in their order, without their history.
std::string key_of(const Genome &genome) {
    std::string key;
    append(genome.inputs, key);
    append(genome.outputs, key);
    append(genome.nodes.size(), key);
    for (const NodeGene &node : genome.nodes) append(node.id, key);
    for (const LinkGene &link : genome.links) {
        append(link.from, key);
        append(link.to, key);
        append(link.weight, key);
    }
    return key;
}

/// All that the movement depends on beside the conditions: mesh and measures follow from the cell centres.
std::string key_of(std::span<const Vec2d> positions, std::span<const Oscillator> oscillators) {
    std::string key;
    for (const Vec2d position : positions) {
        append(position.x, key);
        append(position.y, key);
    }
    for (const Oscillator &oscillator : oscillators) {
        append(oscillator.period, key);
        append(oscillator.phase, key);
    }
    return key;
}

} // namespace

void Memo::begin_generation(int individuals) {
    last_ = std::exchange(present_, std::vector<Entry>(static_cast<std::size_t>(individuals)));
    genomes_.clear();
    starts_.clear();
    for (const Entry &entry : last_) {
        genomes_.emplace(entry.genome, &entry);
        if (!entry.start.empty()) starts_.emplace(entry.start, &entry);
    }
}

Life Memo::live(int slot, const Genome &genome) {
    Entry &entry = present_.at(static_cast<std::size_t>(slot));
    entry.genome = key_of(genome);
    if (const Entry *equal = find(genomes_, entry.genome)) {
        entry.start = equal->start;
        entry.life = equal->life;
        entry.knew_life = true;
        return entry.life;
    }
    const Recall recall = [&](std::span<const Vec2d> positions, std::span<const Oscillator> oscillators) {
        entry.start = key_of(positions, oscillators);
        const Entry *equal = find(starts_, entry.start);
        entry.knew_movement = equal != nullptr;
        return equal ? &equal->life : nullptr;
    };
    entry.life = planula::live(genome, conditions_, {}, recall);
    return entry.life;
}

Known Memo::known() const {
    Known known;
    for (const Entry &entry : present_) {
        known.lives += entry.knew_life;
        known.movements += entry.knew_movement;
    }
    return known;
}

const Memo::Entry *Memo::find(const Index &index, std::string_view key) {
    const auto found = index.find(key);
    return found == index.end() ? nullptr : found->second;
}

} // namespace planula

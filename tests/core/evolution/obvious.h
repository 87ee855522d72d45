// SPDX-License-Identifier: MIT
// The rules of NEAT and of novelty search (decisions 0013 and 0014) once more, slowly and without a
// clever line, so that the searches can be compared with them on random cases: distance, the genes of a
// child of two parents, who shares a species with whom, novelty and its archive. Each comparison draws
// case `number` and says in words where the two disagree, "" if nowhere. tests/torture/random_cases.cpp
// compares as many as one likes.
#pragma once

#include "core/genome/specimens.h"
#include "evolution/novelty_search.h"
#include "evolution/species.h"
#include "genome/cross.h"
#include "genome/distance.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace planula::obvious {

// ---- The rules
// -------------------------------------------------------------------------------------------------------

inline std::map<int, LinkGene> by_innovation(const Genome &genome) {
    std::map<int, LinkGene> links;
    for (const LinkGene &link : genome.links) links[link.innovation] = link;
    return links;
}

/// δ = E + D + 1.5 · mean |Δw| of the matching links, each part with its coefficient.
inline double distance_between(const Genome &a, const Genome &b, const Parameters &parameters) {
    const auto links_a = by_innovation(a), links_b = by_innovation(b);
    const int newest_a = links_a.empty() ? -1 : links_a.rbegin()->first;
    const int newest_b = links_b.empty() ? -1 : links_b.rbegin()->first;
    int excess = 0, disjoint = 0;
    std::vector<double> differences;
    for (const auto &[innovation, link] : links_a) {
        if (links_b.count(innovation))
            differences.push_back(std::abs(link.weight - links_b.at(innovation).weight));
        else
            ++(innovation > newest_b ? excess : disjoint);
    }
    for (const auto &[innovation, link] : links_b)
        if (!links_a.count(innovation)) ++(innovation > newest_a ? excess : disjoint);

    double sum = 0;
    for (const double difference : differences) sum += difference;
    const double mean = differences.empty() ? 0 : sum / static_cast<double>(differences.size());
    return parameters.neat.excess_coefficient * excess + parameters.neat.disjoint_coefficient * disjoint +
           parameters.neat.weight_coefficient * mean;
}

/// Eq. (7) and the archive, generation by generation.
struct Novelty {
    Parameters parameters;
    std::vector<ArchiveEntry> archive;
    double threshold = parameters.novelty.archive_threshold;
    int additions_in_a_row = 0, generations_without = 0;

    static double between(const std::vector<double> &a, const std::vector<double> &b) {
        double sum = 0;
        for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
        return std::sqrt(sum);
    }

    /// The mean distance to the k nearest of (population − self) ∪ archive, of all there are if these are fewer.
    double novelty_of(std::size_t self, const std::vector<Evaluation> &evaluations) const {
        std::vector<double> distances;
        for (std::size_t other = 0; other < evaluations.size(); ++other)
            if (other != self && evaluations[other].penalty > 0)
                distances.push_back(between(evaluations[self].behaviour, evaluations[other].behaviour));
        for (const ArchiveEntry &entry : archive)
            distances.push_back(between(evaluations[self].behaviour, entry.behaviour));
        std::sort(distances.begin(), distances.end());
        const std::size_t k = std::min<std::size_t>(distances.size(), parameters.novelty.novelty_neighbours);
        double sum = 0;
        for (std::size_t i = 0; i < k; ++i) sum += distances[i];
        return k == 0 ? 0 : sum / static_cast<double>(k);
    }

    std::vector<double> score(const Population &population, const std::vector<Evaluation> &evaluations) {
        // All against the archive as it is when the generation begins.
        std::vector<double> novelties;
        for (std::size_t slot = 0; slot < evaluations.size(); ++slot)
            novelties.push_back(evaluations[slot].penalty > 0 ? novelty_of(slot, evaluations) : 0);

        bool any = false;
        for (std::size_t slot = 0; slot < evaluations.size(); ++slot) {
            if (evaluations[slot].penalty == 0) continue; // passed over
            if (novelties[slot] <= threshold) {
                additions_in_a_row = 0;
                continue;
            }
            archive.push_back({population.generation, population.genomes[slot].id,
                               evaluations[slot].behaviour, novelties[slot]});
            any = true;
            additions_in_a_row += 1;
            if (additions_in_a_row >= parameters.novelty.archive_run + 1)
                threshold = threshold * parameters.novelty.archive_raise;
        }

        generations_without = any ? 0 : generations_without + 1;
        if (generations_without == parameters.novelty.archive_patience) {
            threshold = threshold * parameters.novelty.archive_lower;
            if (threshold < parameters.novelty.archive_floor) threshold = parameters.novelty.archive_floor;
            generations_without = 0;
        }
        for (std::size_t slot = 0; slot < evaluations.size(); ++slot)
            novelties[slot] = novelties[slot] * evaluations[slot].penalty;
        return novelties;
    }
};

// ---- Random cases ----------------------------------------------------------------------------------------------------

/// Genomes of one run, some of them twice, others grown far apart.
inline const std::vector<Genome> &pool(bool recurrent) {
    static const auto grow = [](bool is_recurrent) {
        Innovations innovations;
        const Genome ancestor = specimens::connected(4, 3, innovations);
        std::vector<Genome> genomes;
        Stream stream = specimens::stream(is_recurrent, 77);
        for (int n = 0; n < 150; ++n) {
            Genome genome = n % 5 == 4 ? genomes.back() : ancestor;
            for (int step = 0; step < n % 40; ++step)
                mutate(specimens::structural(), is_recurrent, innovations, stream, genome);
            genome.id = n;
            genomes.push_back(genome);
        }
        return genomes;
    };
    static const std::vector<Genome> feed_forward = grow(false), with_loops = grow(true);
    return recurrent ? with_loops : feed_forward;
}

/// One of the pool, or any selection of 12 links with few different weights; sometimes no link at all.
inline Genome draw_genome(bool evolved, bool recurrent, Stream &stream) {
    if (evolved) {
        const auto &genomes = pool(recurrent);
        return genomes[stream.below(static_cast<std::uint32_t>(genomes.size()))];
    }
    Genome genome = specimens::bare(12, 1);
    const double share = stream.uniform();
    for (int innovation = 0; innovation < 12; ++innovation)
        if (stream.chance(share))
            genome.links.push_back({innovation, innovation, 12, double(stream.below(5)) - 2, false});
    genome.id = stream.below(1000);
    return genome;
}

inline Parameters draw_coefficients(Stream &stream) {
    Parameters parameters;
    parameters.neat.disjoint_coefficient = stream.below(4);
    parameters.neat.excess_coefficient = stream.below(4);
    parameters.neat.weight_coefficient = 2 * stream.uniform();
    return parameters;
}

// ---- Comparisons -----------------------------------------------------------------------------------------------------

inline std::string compare_distance(std::uint32_t number) {
    Stream stream = specimens::stream(number, 101);
    const bool evolved = stream.chance(0.5), recurrent = stream.chance(0.5);
    const Genome a = draw_genome(evolved, recurrent, stream), b = draw_genome(evolved, recurrent, stream);
    const Parameters parameters = draw_coefficients(stream);
    const double expected = distance_between(a, b, parameters), found = distance(a, b, parameters.neat);
    if (std::abs(found - expected) > 1e-12 * (1 + expected)) return "distance";
    if (distance(b, a, parameters.neat) != found) return "symmetry of distance";
    const bool clone = a.links.size() == b.links.size() && expected < parameters.neat.clone_distance;
    return is_clone(a, std::vector<Genome>{b}, parameters.neat) == clone ? "" : "clone";
}

/// How often chance decided for the mother, and how often it decided at all.
struct Coins {
    int of_mother = 0, all = 0;        // which parent is the fitter of equals
    int gene_of_mother = 0, genes = 0; // from which parent a matching gene comes
};

inline std::string compare_crossing(std::uint32_t number, Coins &coins) {
    Stream stream = specimens::stream(number, 102);
    const bool evolved = stream.chance(0.5), recurrent = stream.chance(0.5);
    const Genome mother = draw_genome(evolved, recurrent, stream),
                 father = draw_genome(evolved, recurrent, stream);
    const double score_of_mother = stream.below(3), score_of_father = stream.below(3);
    Crossing crossing;
    crossing.averaging = stream.chance(0.3);
    crossing.interspecies = stream.chance(0.2);
    const Genome child = cross({mother, score_of_mother}, {father, score_of_father}, crossing, stream);

    const auto of_mother = by_innovation(mother), of_father = by_innovation(father),
               of_child = by_innovation(child);
    std::set<int> only_mother, only_father, both;
    for (const auto &[innovation, link] : of_mother)
        (of_father.count(innovation) ? both : only_mother).insert(innovation);
    for (const auto &[innovation, link] : of_father)
        if (!of_mother.count(innovation)) only_father.insert(innovation);

    // Disjoint and excess genes come from the fitter, of equals from the shorter, of equals from either.
    bool mother_gives = true, father_gives = true;
    if (!crossing.interspecies) {
        if (score_of_mother != score_of_father)
            mother_gives = score_of_mother > score_of_father;
        else if (mother.links.size() != father.links.size())
            mother_gives = mother.links.size() < father.links.size();
        else {
            const auto has = [&](int innovation) { return of_child.count(innovation) > 0; };
            mother_gives = only_mother.empty() ? only_father.empty() || !has(*only_father.begin())
                                               : has(*only_mother.begin());
            if (!only_mother.empty()) ++coins.all, coins.of_mother += mother_gives;
        }
        father_gives = !mother_gives;
    }
    std::set<int> expected = both, found;
    if (mother_gives) expected.insert(only_mother.begin(), only_mother.end());
    if (father_gives) expected.insert(only_father.begin(), only_father.end());
    for (const auto &[innovation, link] : of_child) found.insert(innovation);
    if (found != expected || found.size() != child.links.size()) return "the child's links";

    for (const auto &[innovation, link] : of_child) {
        if (!both.count(innovation)) {
            if (!(link == (of_mother.count(innovation) ? of_mother : of_father).at(innovation)))
                return "a lone gene";
            continue;
        }
        const LinkGene &a = of_mother.at(innovation), &b = of_father.at(innovation);
        if (link.from != a.from || link.to != a.to) return "the ends of a matching gene";
        if (crossing.averaging ? link.weight != (a.weight + b.weight) / 2 : !(link == a) && !(link == b))
            return "a matching gene";
        if (!crossing.averaging && a.weight != b.weight) ++coins.genes, coins.gene_of_mother += link == a;
    }

    // Inputs and outputs, and the hidden nodes that links end at.
    std::set<int> needed, nodes;
    for (int id = 0; id < mother.inputs + mother.outputs; ++id) needed.insert(id);
    for (const LinkGene &link : child.links) needed.insert(link.from), needed.insert(link.to);
    for (const NodeGene &node : child.nodes) {
        nodes.insert(node.id);
        const NodeGene *known =
            mother.find_node(node.id) ? mother.find_node(node.id) : father.find_node(node.id);
        if (!known || !(node == *known)) return "a node of the child";
    }
    return nodes == needed && nodes.size() == child.nodes.size() ? "" : "the child's nodes";
}

inline std::string compare_species(std::uint32_t number) {
    Stream stream = specimens::stream(number, 103);
    const Parameters parameters = draw_coefficients(stream);
    const bool recurrent = stream.chance(0.5);
    Population population;
    population.threshold = 12 * stream.uniform();
    population.next_genome = 1000;
    const int old_species = static_cast<int>(stream.below(5));
    for (int i = 0; i < old_species; ++i) {
        Species species;
        species.id = population.next_species++;
        species.representative = draw_genome(true, recurrent, stream);
        population.species.push_back(species);
    }

    // Each child goes to the first species whose representative is near enough, or founds one behind all others.
    struct Group {
        int id;
        Genome representative;
        std::vector<Genome> members;
    };
    std::vector<Group> groups;
    for (const Species &species : population.species)
        groups.push_back({species.id, species.representative, {}});
    int next_id = population.next_species;
    const int children = 1 + static_cast<int>(stream.below(9)),
              size = children + static_cast<int>(stream.below(3));
    std::int64_t next_genome = population.next_genome;
    for (int n = 0; n < children; ++n) {
        const Genome child = draw_genome(true, recurrent, stream);
        add_child(parameters.neat, population, child);
        Genome named = child;
        named.id = next_genome++;
        bool placed = false;
        for (Group &group : groups)
            if (!placed &&
                distance_between(named, group.representative, parameters) <= population.threshold) {
                group.members.push_back(named);
                placed = true;
            }
        if (!placed) groups.push_back({next_id++, named, {named}});
    }
    complete_generation(size, population);

    // The empty go, the first takes copies of its first member, and each is represented by its first.
    groups.erase(std::remove_if(groups.begin(), groups.end(),
                                [](const Group &group) { return group.members.empty(); }),
                 groups.end());
    for (int n = children; n < size; ++n) groups.front().members.push_back(groups.front().members.front());
    if (population.species.size() != groups.size()) return "the number of species";
    int slot = 0;
    for (std::size_t i = 0; i < groups.size(); ++i) {
        const Species &species = population.species[i];
        if (species.id != groups[i].id) return "the order of species";
        if (species.members.size() != groups[i].members.size()) return "the size of a species";
        if (!(species.representative.links == groups[i].members.front().links)) return "a representative";
        for (std::size_t member = 0; member < species.members.size(); ++member, ++slot) {
            if (species.members[member] != slot) return "the order of slots";
            const Genome &genome = population.genomes[slot], &expected = groups[i].members[member];
            if (!(genome.links == expected.links)) return "a member";
            if (genome.origin != Origin::filler && genome.id != expected.id) return "a member's id";
        }
    }
    return "";
}

inline std::string compare_novelty(std::uint32_t number) {
    Stream stream = specimens::stream(number, 104);
    Parameters parameters;
    parameters.novelty.novelty_neighbours = 1 + static_cast<int>(stream.below(6));
    parameters.novelty.archive_threshold = 3 * stream.uniform();
    parameters.novelty.archive_floor = stream.uniform();
    parameters.novelty.archive_run = static_cast<int>(stream.below(5));
    parameters.novelty.archive_patience = 1 + static_cast<int>(stream.below(3));
    NoveltySearch search(parameters);
    Novelty expected{parameters};

    const bool coarse = stream.chance(0.5); // many at equal distances
    const std::size_t length = 1 + stream.below(3);
    const int generations = 3 + static_cast<int>(stream.below(6));
    Population population;
    for (; population.generation < generations; ++population.generation) {
        std::vector<Evaluation> evaluations(1 + stream.below(12));
        population.genomes.assign(evaluations.size(), Genome());
        for (std::size_t slot = 0; slot < evaluations.size(); ++slot) {
            population.genomes[slot].id = population.next_genome++;
            const double kind = stream.uniform();
            evaluations[slot].penalty = kind < 0.2 ? 0 : kind < 0.4 ? 0.1 : 1;
            for (std::size_t i = 0; i < length; ++i)
                evaluations[slot].behaviour.push_back(coarse ? double(stream.below(6))
                                                             : 6 * stream.uniform());
        }
        if (search.score(population, evaluations) != expected.score(population, evaluations))
            return "novelty";
        if (search.archive_threshold() != expected.threshold) return "the archive's threshold";
        if (search.archive().size() != expected.archive.size()) return "the size of the archive";
    }
    for (std::size_t i = 0; i < expected.archive.size(); ++i) {
        const ArchiveEntry &a = search.archive()[i], &b = expected.archive[i];
        if (a.generation != b.generation || a.genome != b.genome || a.behaviour != b.behaviour ||
            a.novelty != b.novelty)
            return "an entry of the archive";
    }
    return "";
}

} // namespace planula::obvious

// SPDX-License-Identifier: MIT
#include "experiment/digest.h"

#include "evaluation/life_digest.h"

#include <algorithm>
#include <array>
#include <type_traits>

namespace planula {

namespace {

/// Feeds records field by field. Every record but a life (evaluation/life_digest.h) is taken apart by name, so that one
/// with a further field does not compile until that field is fed, too.
class Feeder {
  public:
    explicit Feeder(Hash &hash) : hash_(hash) {}

    template <class... Fields> void all(const Fields &...fields) { (add(fields), ...); }

  private:
    void add(int value) { hash_.number(value); }
    void add(std::int64_t value) { hash_.number(static_cast<std::uint64_t>(value)); }
    void add(double value) { hash_.number(value); }
    template <class Choice>
    requires std::is_enum_v<Choice>
    void add(Choice value) { hash_.number(static_cast<int>(value)); }
    template <class T> void add(const std::vector<T> &list) { add(std::span(list)); }
    template <class T> void add(std::span<T> list) {
        hash_.number(std::uint64_t{list.size()});
        for (const auto &each : list) add(each);
    }

    void add(const NodeGene &node) {
        const auto &[id, kind, depth] = node;
        all(id, kind, depth);
    }
    void add(const LinkGene &link) {
        const auto &[innovation, from, to, weight, recurrent] = link;
        all(innovation, from, to, weight, recurrent);
    }
    void add(const Genome &genome) {
        const auto &[id, mother, father, origin, inputs, outputs, nodes, links] = genome;
        all(id, mother, father, origin, inputs, outputs, nodes, links);
    }
    /// The representative is one of the genomes.
    void add(const Species &species) {
        const auto &[id, representative, age, stagnation, best_ever, best, members] = species;
        all(id, representative.id, age, stagnation, best_ever, best, members);
    }
    void add(const Innovations &innovations) { all(innovations.links(), innovations.next_node()); }
    void add(const Population &population) {
        const auto &[generation, genomes, species, threshold, best_ever, next_genome, next_species,
                     innovations] = population;
        all(generation, genomes, species, threshold, best_ever, next_genome, next_species, innovations);
    }
    void add(const Life &life) { feed(hash_, life); }
    void add(const Evaluation &evaluation) {
        const auto &[fitness, behaviour, penalty, objectives] = evaluation;
        all(fitness, behaviour, penalty);
        stated(objectives);
    }
    void add(const ArchiveEntry &entry) {
        const auto &[generation, genome, behaviour, novelty, fitness, objectives] = entry;
        all(generation, genome, behaviour, novelty, fitness);
        stated(objectives);
    }

    /// Objectives, which only some experiments state: without any, nothing is fed.
    void stated(const std::vector<double> &objectives) {
        if (!objectives.empty()) add(objectives);
    }

    Hash &hash_;
};

/// What entered the archive in this generation: its last entries.
std::span<const ArchiveEntry> added_in(int generation, std::span<const ArchiveEntry> archive) {
    const auto is_older = [&](const ArchiveEntry &entry) { return entry.generation != generation; };
    const auto last_older = std::find_if(archive.rbegin(), archive.rend(), is_older);
    return archive.last(static_cast<std::size_t>(last_older - archive.rbegin()));
}

} // namespace

void digest(Hash &hash, const Generation &generation) {
    const auto &[number, population, lives, evaluations, scores, search, mothers, best, known] = generation;
    static_cast<void>(mothers), static_cast<void>(known);
    const auto archive = search.archive();
    Feeder(hash).all(number, population, lives, evaluations, scores, best, search.archive_threshold(),
                     static_cast<std::int64_t>(archive.size()), added_in(number, archive));
}

} // namespace planula

// SPDX-License-Identifier: MIT
#include "genome/genome_state.h"

#include "base/check.h"
#include "base/error.h"

#include <limits>

namespace planula {

namespace {

constexpr std::size_t genome_bytes = 5 * 8, link_bytes = 2 * 8;

/// What follows for the genomes of a run from their innovations.
class Heritage {
  public:
    Heritage(int inputs, int outputs, const Innovations &innovations)
        : inputs_(inputs), outputs_(outputs), innovations_(innovations),
          terminals_(terminal_nodes(inputs, outputs)) {
        CHECK(innovations.first_node() == inputs + outputs, innovations.first_node(), inputs, outputs);
        for (const NodeGene &node : terminals_) depths_.push_back(node.depth);
        for (int node = innovations.first_node(); node < innovations.next_node(); ++node) {
            const auto [from, to] = innovations.split_ends(node);
            depths_.push_back((depths_[from] + depths_[to]) / 2);
        }
    }

    /// Sets all but the origin, and the innovations, weights and directions of the links.
    void complete(Genome &genome) const {
        genome.inputs = inputs_;
        genome.outputs = outputs_;
        for (LinkGene &link : genome.links) {
            const auto [from, to] = innovations_.link_ends(link.innovation);
            link.from = from, link.to = to;
        }
        genome.nodes = terminals_;
        for (const int id : linked_nodes(inputs_ + outputs_, genome.links))
            genome.nodes.push_back({id, NodeKind::hidden, depths_[id]});
    }

  private:
    const int inputs_, outputs_;
    const Innovations &innovations_;
    const std::vector<NodeGene> terminals_;
    std::vector<double> depths_; // of every node of the run
};

/// Loading must make the same of them.
void check_completion(std::span<const Genome> genomes, const Innovations &innovations) {
    if (genomes.empty()) return;
    const Heritage heritage(genomes.front().inputs, genomes.front().outputs, innovations);
    for (const Genome &genome : genomes) {
        for (const LinkGene &link : genome.links) CHECK(link.innovation < innovations.links(), genome.id);
        Genome completed = genome;
        heritage.complete(completed);
        CHECK(completed == genome, genome.id);
    }
}

/// Where the genomes come from.
void load_origins(std::vector<Genome> &genomes, StateReader &reader) {
    constexpr std::int64_t last_id = std::numeric_limits<std::int64_t>::max();
    for (Genome &genome : genomes) genome.id = reader.integer(0, last_id);
    for (Genome &genome : genomes) genome.mother = reader.integer(-1, last_id);
    for (Genome &genome : genomes) genome.father = reader.integer(-1, last_id);
    for (Genome &genome : genomes)
        genome.origin = static_cast<Origin>(reader.integer(0, static_cast<int>(Origin::crossover_mutation)));
}

/// The innovations, weights and directions of all links.
void load_links(int innovations, std::vector<Genome> &genomes, StateReader &reader) {
    std::size_t left = reader.count(link_bytes);
    for (Genome &genome : genomes) {
        genome.links.resize(static_cast<std::size_t>(reader.integer(0, static_cast<std::int64_t>(left))));
        left -= genome.links.size();
    }
    if (left > 0) reader.refuse("a link is of no genome");
    for (Genome &genome : genomes) {
        int next = 0;
        for (LinkGene &link : genome.links) {
            const std::int64_t step = reader.integer(0, 2 * std::int64_t{innovations - next} - 1);
            link.innovation = next + static_cast<int>(step / 2);
            link.recurrent = step % 2 == 1;
            next = link.innovation + 1;
        }
    }
    for (Genome &genome : genomes)
        for (LinkGene &link : genome.links) link.weight = reader.finite();
}

} // namespace

void save(std::span<const Genome> genomes, const Innovations &innovations, StateWriter &writer) {
    check_completion(genomes, innovations);
    writer.group("genomes").integer(static_cast<std::int64_t>(genomes.size()));
    for (const Genome &genome : genomes) writer.integer(genome.id);
    for (const Genome &genome : genomes) writer.integer(genome.mother);
    for (const Genome &genome : genomes) writer.integer(genome.father);
    for (const Genome &genome : genomes) writer.integer(static_cast<int>(genome.origin));

    std::size_t links = 0;
    for (const Genome &genome : genomes) links += genome.links.size();
    writer.integer(static_cast<std::int64_t>(links));
    for (const Genome &genome : genomes) writer.integer(static_cast<std::int64_t>(genome.links.size()));

    // Of each link, twice the innovations left out before it, and one more if it is recurrent.
    for (const Genome &genome : genomes) {
        int next = 0;
        for (const LinkGene &link : genome.links) {
            writer.integer(2 * std::int64_t{link.innovation - next} + link.recurrent);
            next = link.innovation + 1;
        }
    }
    for (const Genome &genome : genomes)
        for (const LinkGene &link : genome.links) writer.real(link.weight);
}

std::vector<Genome> load_genomes(int inputs, int outputs, const Innovations &innovations,
                                 StateReader &reader) {
    reader.group("genomes");
    std::vector<Genome> genomes(reader.count(genome_bytes));
    load_origins(genomes, reader);
    load_links(innovations.links(), genomes, reader);
    const Heritage heritage(inputs, outputs, innovations);
    for (Genome &genome : genomes) {
        heritage.complete(genome);
        try {
            check_genome(genome);
        } catch (const InputError &error) {
            reader.refuse(error.what());
        }
    }
    return genomes;
}

} // namespace planula

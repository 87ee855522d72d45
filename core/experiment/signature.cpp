// SPDX-License-Identifier: MIT
#include "experiment/signature.h"

namespace planula {

namespace {

void feed(Hash &hash, Vec2d v) { hash.number(v.x).number(v.y); }

void feed(Hash &hash, const Genome &genome) {
    hash.number(static_cast<std::uint64_t>(genome.id)).number(static_cast<int>(genome.nodes.size()));
    for (const NodeGene &node : genome.nodes) hash.number(node.id).number(node.depth);
    for (const LinkGene &link : genome.links)
        hash.number(link.innovation).number(link.from).number(link.to).number(link.weight);
}

void feed(Hash &hash, const Life &life) {
    hash.number(static_cast<int>(life.outcome)).number(life.cells).number(life.largest).number(life.births);
    hash.number(life.links).number(life.triangles).number(life.elongation);
    hash.number(life.settle_steps).number(life.activity);
    feed(hash, life.rest);
    feed(hash, life.end);
    for (const Vec2d point : life.path) feed(hash, point);
}

void feed(Hash &hash, const Evaluation &evaluation) {
    hash.number(evaluation.fitness).number(evaluation.penalty);
    for (const double value : evaluation.behaviour) hash.number(value);
}

} // namespace

void Signature::observe(const Generation &generation) {
    hash_.number(generation.number).number(generation.population.threshold);
    for (std::size_t slot = 0; slot < generation.lives.size(); ++slot) {
        feed(hash_, generation.population.genomes[slot]);
        feed(hash_, generation.lives[slot]);
        feed(hash_, generation.evaluations[slot]);
        hash_.number(generation.scores[slot]);
    }
    for (const Species &species : generation.population.species) hash_.number(species.id);
}

} // namespace planula

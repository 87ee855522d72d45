// SPDX-License-Identifier: MIT
#include "evolution/breed.h"

#include "genome/cross.h"
#include "genome/distance.h"
#include "genome/mutate.h"

#include <algorithm>
#include <cmath>

namespace planula {

namespace {

/// The slot of a parent, drawn uniformly from the best survival_rate of the species and the next one.
int draw_parent(const Species &species, const NeatParameters &parameters, Stream &stream) {
    const double size = static_cast<double>(species.members.size());
    const double last = std::min(size - 1, std::floor(parameters.survival_rate * size + 1));
    return species.members[stream.below(static_cast<std::uint32_t>(last) + 1)];
}

/// A child like its only parent.
Genome copy_of(const Genome &parent, Origin origin) {
    Genome child = parent;
    child.mother = parent.id;
    child.father = -1;
    child.origin = origin;
    return child;
}

/// The parents of one child.
struct Pairing {
    const Parents &parents;
    ParentDraw draw; // of a mother, and mostly of the father
    bool alone;      // there is only one to draw
};

Pairing within(const Parents &parents, const Species &species, const NeatParameters &parameters) {
    const auto draw = [&](Stream &stream) { return draw_parent(species, parameters, stream); };
    return {parents, draw, species.members.size() == 1};
}

/// The slot of a father who differs from the mother if mate_tries draws find one.
int draw_father(const Parents &parents, const ParentDraw &draw, const Genome &mother,
                const NeatParameters &parameters, Stream &stream) {
    const auto alike = [&](int slot) {
        return parents.genomes[slot].id == mother.id ||
               distance(mother, parents.genomes[slot], parameters) <= parameters.clone_distance;
    };
    int father = draw(stream);
    for (int tries = 0; tries < parameters.mate_tries && alike(father); ++tries) father = draw(stream);
    return father;
}

Genome mate(const Pairing &pairing, int mother, const NeatParameters &parameters, Stream &stream) {
    const Parents &parents = pairing.parents;
    // Rarely the father's species is drawn from all, and may be the own.
    Crossing crossing;
    crossing.interspecies = stream.chance(parameters.interspecies_rate) && parents.species.size() > 1;
    ParentDraw draw = pairing.draw;
    if (crossing.interspecies) {
        const auto any = stream.below(static_cast<std::uint32_t>(parents.species.size()));
        draw = within(parents, parents.species[any], parameters).draw;
    }
    const int father = draw_father(parents, draw, parents.genomes[mother], parameters, stream);

    crossing.averaging = !stream.chance(parameters.multipoint_rate);
    crossing.weight_step = parameters.weight_step;
    if (mother == father) return copy_of(parents.genomes[mother], Origin::clone);
    return cross({parents.genomes[mother], parents.scores[mother]},
                 {parents.genomes[father], parents.scores[father]}, crossing, stream);
}

/// One try at a child; a further try changes no structure.
Genome conceive(const Pairing &pairing, bool first_try, bool recurrent, const NeatParameters &parameters,
                Innovations &innovations, Stream &stream) {
    const int mother = pairing.draw(stream);
    const bool mated = !pairing.alone && stream.chance(parameters.crossover_rate);
    Genome child = mated ? mate(pairing, mother, parameters, stream)
                         : copy_of(pairing.parents.genomes[mother], Origin::clone);
    if (mated && !stream.chance(parameters.mutation_rate)) return child;

    const bool mutated = first_try ? mutate(parameters, recurrent, innovations, stream, child)
                                   : mutate_weights(parameters, stream, child);
    if (mutated) child.origin = child.origin == Origin::clone ? Origin::mutation : Origin::crossover_mutation;
    return child;
}

Genome breed(const Pairing &pairing, std::span<const Genome> siblings, bool recurrent,
             const NeatParameters &parameters, Innovations &innovations, Stream &stream) {
    Genome child = conceive(pairing, true, recurrent, parameters, innovations, stream);
    for (int tries = 1; tries < parameters.clone_tries && is_clone(child, siblings, parameters); ++tries)
        child = conceive(pairing, false, recurrent, parameters, innovations, stream);
    if (!has_dead_ends(child)) return child;
    return copy_of(pairing.parents.genomes[pairing.draw(stream)], Origin::clone);
}

} // namespace

Genome copy_champion(const Parents &parents, const Species &species) {
    return copy_of(parents.genomes[species.members.front()], Origin::champion);
}

Genome breed(const Parents &parents, const Species &species, std::span<const Genome> siblings, bool recurrent,
             const NeatParameters &parameters, Innovations &innovations, Stream &stream) {
    return breed(within(parents, species, parameters), siblings, recurrent, parameters, innovations, stream);
}

Genome breed(const Parents &parents, const ParentDraw &draw, std::span<const Genome> siblings, bool recurrent,
             const NeatParameters &parameters, Innovations &innovations, Stream &stream) {
    return breed(Pairing{parents, draw, parents.genomes.size() == 1}, siblings, recurrent, parameters,
                 innovations, stream);
}

} // namespace planula

// SPDX-License-Identifier: MIT
#include "experiment/run_state.h"

#include "evolution/population_state.h"

namespace planula {

void save(const RunState &state, StateWriter &writer) {
    save(state.population, writer);
    state.search->save(state.population, writer);
    state.mothers.save(writer);
}

RunState load_run_state(const Spec &spec, std::span<const ArchiveEntry> archive, StateReader &reader) {
    const NetworkShape shape = shape_of(spec.actuation);
    const Parameters &p = spec.parameters;
    RunState state{load_population(shape, p.neat.population, p.design.generations, reader),
                   make_search(spec.search, p, spec.aims),
                   {}};
    state.search->load(state.population, archive, reader);
    for (const Genome &genome : state.search->kept_genomes())
        check_member(genome, shape, state.population, reader);
    state.mothers = Mothers::load(state.population, state.search->kept_genomes(), reader);
    return state;
}

} // namespace planula

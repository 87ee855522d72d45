// SPDX-License-Identifier: MIT
#include "analysis/simulate_again.h"

#include "base/error.h"
#include "base/text.h"

namespace planula {

Life simulate_again(const RecordedIndividual &recorded, const Spec &spec, const Watch &watch) {
    const std::string file = recorded.file.string();
    const Genome &genome = recorded.genome;
    if (genome.inputs != input::count || genome.outputs != output::count(spec.actuation))
        throw InputError(file + ": setting '" + spec.name + "': a genome with " + to_text(genome.inputs) +
                         " inputs and " + to_text(genome.outputs) + " outputs does not fit the actuation '" +
                         name_of(spec.actuation) + "'");
    Life life = live(genome, spec, watch);
    if (life.displacement() != recorded.displacement || life.cells != recorded.cells)
        throw InputError(file + ": the best individual of '" + spec.name + "' moved " +
                         to_text(recorded.displacement) + " cells with " + to_text(recorded.cells) +
                         " cells, and simulated again it moves " + to_text(life.displacement()) + " with " +
                         to_text(life.cells) + ": the data are of another experiment or version");
    return life;
}

} // namespace planula

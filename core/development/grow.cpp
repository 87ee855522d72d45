// SPDX-License-Identifier: MIT
#include "development/grow.h"

#include "body/connect.h"
#include "cell/senses.h"
#include "development/division.h"
#include "development/tissue_forces.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace planula {

namespace {

bool all_finite(std::span<const double> values) {
    return std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
}

/// One update of every cell's network. All read one snapshot: the links of the last refresh and the
/// morphogens of the last decision. Returns whether all activations are finite.
bool update_networks(const Network &network, Actuation actuation, double time, const Parameters &parameters,
                     Embryo &embryo) {
    std::vector<double> morphogens;
    for (const Cell &cell : embryo.cells) morphogens.push_back(cell.morphogen);
    const int cells = static_cast<int>(embryo.cells.size());
    bool finite = true;
    for (int i = 0; i < cells; ++i) {
        const auto inputs = sense(embryo.cells[i].position, mean_morphogen(embryo.neighbours[i], morphogens),
                                  time, parameters.network);
        for (int node = 0; node < input::count; ++node) embryo.activations.at(i, node) = inputs[node];
        finite = finite && all_finite(inputs);
    }
    Activations &activations = embryo.activations;
    const bool sound = is_recurrent(actuation) ? step(network, activations) : evaluate(network, activations);
    for (int i = 0; i < cells; ++i)
        embryo.cells[i].morphogen = activations.at(i, network.inputs + output::morphogen);
    return finite && sound;
}

/// One decision: all networks → deaths → divisions in ascending id (§2.3). Returns how it ended.
Outcome decide(const Network &network, Actuation actuation, double time, const Parameters &parameters,
               Embryo &embryo) {
    if (!update_networks(network, actuation, time, parameters, embryo)) return Outcome::exploded;

    // Directions are found before any cell dies or divides: dying cells count as neighbours, but do not divide.
    struct Division {
        int id;
        Vec2d direction;
    };
    std::vector<Division> divisions;
    std::vector<char> dying;
    for (int i = 0; i < static_cast<int>(embryo.cells.size()); ++i) {
        const auto output_of = [&](output::Channel channel) {
            return embryo.activations.at(i, network.inputs + channel);
        };
        dying.push_back(output_of(output::apoptosis) > 0);
        if (!dying.back() && !(output_of(output::division_inhibitor) > 0))
            divisions.push_back(
                {embryo.cells[i].id,
                 division_direction(embryo, i, output_of(output::division_angle), parameters.development)});
    }
    remove_cells(dying, embryo);

    // Daughters are appended, so mothers keep their indices.
    std::size_t mother = 0;
    for (const auto &[id, direction] : divisions) {
        if (embryo.births >= parameters.development.birth_limit) break;
        while (embryo.cells[mother].id != id) ++mother;
        divide(static_cast<int>(mother), direction, parameters.development, embryo);
        if (embryo.largest >= parameters.development.cell_limit) return Outcome::overgrown;
    }
    return embryo.cells.empty() ? Outcome::died_out : Outcome::viable;
}

bool all_finite(std::span<const Vec2d> places) {
    return std::all_of(places.begin(), places.end(), [](Vec2d p) { return is_finite(p); });
}

/// Whether the cells can be triangulated.
bool is_sound(std::span<const Vec2d> places) { return all_finite(places) && !has_coincident_points(places); }

/// Updates the neighbourhood to the cells' present places. `all_live`: no cell has died since the last refresh. Returns
/// whether the cells can be triangulated.
bool refresh(bool all_live, Connection &connection, Embryo &embryo) {
    const std::vector<Vec2d> places = positions(embryo);
    if (!all_live || !all_finite(places) || !connection.follow(places)) {
        if (!is_sound(places)) return false;
        connection.start(places);
    }
    if (connection.has_changed()) {
        embryo.links = connection.links();
        embryo.neighbours = Neighbours(embryo.links, static_cast<int>(embryo.cells.size()));
    }
    return true;
}

/// All steps of development, and the neighbourhood at its end. Returns viable if cells are left that can be
/// triangulated.
Outcome develop(const Network &network, Actuation actuation, const Parameters &parameters,
                const GrowthWatch &watch, Connection &connection, Embryo &embryo) {
    bool all_live = false; // the cells of the last refresh
    const bool carries = parameters.development.orientation_frame == OrientationFrame::tissue;
    std::vector<Vec2d> refreshed; // where they were then, if orientations turn with the tissue
    for (int step = 0; step < parameters.development.development_steps; ++step) {
        const bool refreshes = step % parameters.development.neighbourhood_interval == 0;
        if (carries && refreshes && step > 0) carry_orientations(refreshed, embryo);
        if (step % parameters.development.decision_interval == 0) {
            const double time = static_cast<double>(step) / parameters.development.development_steps;
            const std::size_t dead = embryo.births - embryo.cells.size();
            const Outcome outcome = decide(network, actuation, time, parameters, embryo);
            if (outcome != Outcome::viable) return outcome;
            all_live = all_live && embryo.births - embryo.cells.size() == dead;
        }
        if (refreshes) {
            if (!refresh(all_live, connection, embryo)) return Outcome::exploded;
            all_live = true;
            if (carries) refreshed = positions(embryo);
        }
        if (watch) watch(step, embryo);
        relax(parameters.development, embryo);
    }
    return refresh(all_live, connection, embryo) ? Outcome::viable : Outcome::exploded;
}

Tissue read_tissue(const Embryo &embryo) {
    Tissue tissue{embryo.activations, {}};
    for (const Cell &cell : embryo.cells) tissue.morphogens.push_back(cell.morphogen);
    return tissue;
}

} // namespace

Growth grow(const Network &network, Actuation actuation, const Parameters &parameters,
            const GrowthWatch &watch) {
    Embryo embryo = zygote(network.nodes);
    Connection connection(parameters.development.link_limit * 2 * parameters.development.cell_radius);
    Growth growth;
    growth.outcome = develop(network, actuation, parameters, watch, connection, embryo);
    growth.cells = static_cast<int>(embryo.cells.size());
    growth.largest = embryo.largest;
    growth.births = embryo.births;
    if (growth.outcome != Outcome::viable) return growth;

    // The last triangulation is the template of the body; oscillators are read out over it, at time 1 (§2.6.1).
    growth.body = make_body(positions(embryo), connection.mesh());
    if (actuation == Actuation::oscillator && !update_networks(network, actuation, 1, parameters, embryo))
        growth.outcome = Outcome::exploded;
    else if (growth.cells < parameters.development.minimum_cells)
        growth.outcome = Outcome::too_small;
    growth.tissue = read_tissue(embryo);
    if (watch) watch(parameters.development.development_steps, embryo);
    return growth;
}

} // namespace planula

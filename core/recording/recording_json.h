// SPDX-License-Identifier: MIT
// A recording as text: one JSON object, which the viewer plays (scripting/page/viewer). The same life gives the same
// text wherever it is simulated.
//
// Lengths are in cells, times in steps unless said otherwise, angles in degrees. What is unknown or infinite is null.
// `packed` is a text of whole numbers, each after the other, as differences (recording/packed_numbers.h); of each the
// scale says how many units make 1.
//
//   format             "planula recording 1"
//   title, experiment, setting
//   seed, generation, slot, genome, fitness
//   outcome            as in individuals.csv: viable, died_out, …
//   displacement, cells, births
//   life               the SHA-256 of every field of the life (evaluation/life_digest.h)
//   path               [[x, y], …], as the life tells it: jumps, where cells are lost or the world changes, do not count
//   path_interval      steps between the points of the path
//   actuation          oscillator or grn
//   time_step          t.u. in a step
//   cell_radius        cells
//   growth_steps, settle_steps, gait_steps
//   pressure_stiffness of the body: what a compression of 1 is as a pressure, mass/t.u.²
//   scales             {position, signal, compression, activation}: units of the packed numbers in 1
//   worlds             the first, and each further one that the body comes into:
//     first_step, gravity, gravity_direction, ground (null: none; []: the line y = 0; or [[x, y], …], level beyond its
//     ends), friction, drag ([normal, tangential]), flow ([x, y]), current (null, or {samples, step, repeats}), ceiling,
//     obstacles ([{points, friction}, …]), patches ([[from, to, friction], …]), regions ([{left, right, bottom, top,
//     drag, flow, buoyancy}, …])
//   growth
//     steps            of the frames
//     cells            [id, first, end, …]: a cell, the frame that it is first in, and the one that it is no longer in
//     links            [a, b, first, end, …]: the same of links between cells by their ids
//     positions        packed, order 2: of each cell in turn x in its frames, then y
//   bodies             what moves, first and after each loss of cells; a body's frames go on to that of the next:
//     first_frame, ids (of the cells), links ([a, b, …], nodes), outline ([a, b, …])
//   object             null, or a loose object, whose nodes follow the cells: {nodes, links, outline}
//   gait
//     steps            of the frames
//     positions        packed, order 2: of each body in turn, and of each of its nodes, x in its frames, then y
//     muscle_frames    the frames that signals and compressions are of, at most one at each knot
//     signals          packed, order 2: of each body and cell in turn the muscles' signal in those of its frames
//     compressions     likewise: the mean compression of the cell's triangles; times pressure_stiffness its pressure
//   network
//     nodes            [{id, kind (input, bias, output, hidden), name, depth}, …]
//     links            [[from, to, weight, recurrent], …], nodes by their place in the list
//     growth, gait     updates of all cells' networks, in growth and in locomotion:
//       steps          of the updates
//       cells          as in growth, by updates
//       values         packed, order 1: of each cell and node in turn the activations in the cell's updates
//   source             {genome, conditions}: the texts of all that decides the life (genome/genome_text.h,
//                      evaluation/conditions_text.h)
#pragma once

#include "recording/recording.h"

#include <string>

namespace planula {

std::string recording_json(const LifeRecording &recording);

} // namespace planula

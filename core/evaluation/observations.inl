// SPDX-License-Identifier: MIT
// What else a life can tell, once (decision 0026). An observation costs time or memory, so it is computed only for
// settings whose functions name it (Conditions::observed). It is no part of the digest, of the memory of known
// movements, or of any table: runs that read none are as if there were none. Read with a macro defined:
//
//   OBSERVATION(type, name, initial, unit, known, exists, meaning)
//
// known:  the stage after which the value is known, growth or locomotion (KnownAfter)
// exists: the settings that have it, an Existence of evaluation/observations.h
// Types are double, Vec2d, and lists of numbers, of points and of lists of numbers. An energy is in masses of a cell
// times cell²/t.u.². The order is free.

OBSERVATION(double, work, 0, "energy", locomotion, everywhere, "work that muscles did in locomotion: the sum of what each spring got from changes of its rest length, gains alone")
OBSERVATION(double, net_work, 0, "energy", locomotion, everywhere, "the same, gains less losses: what the muscles added to the energy of the body")
OBSERVATION(double, elastic_energy, 0, "energy", locomotion, everywhere, "energy in springs and in the pressure of triangles, those of a loose object included, the mean over the steps of locomotion")
OBSERVATION(double, contact_time, 0, "1", locomotion, everywhere, "share of the steps of locomotion after which some cell touched the ground, an obstacle or the ceiling; 0 in water")
OBSERVATION(double, contact_share, 0, "1", locomotion, everywhere, "share of its cells that touched one of these, the mean over the steps of locomotion; 0 in water")
OBSERVATION(Samples, signals, {}, "1", locomotion, everywhere, "muscle signal of each cell, -1 to 1, every path_interval steps from rest to finish: signals[i][cell]")
OBSERVATION(double, period, 0, "step", locomotion, everywhere, "period of the muscle signals in the second half of locomotion, by their autocorrelation; 0 without a rhythm")
OBSERVATION(std::vector<double>, gait_phases, {}, "period", locomotion, everywhere, "phase of each cell's signal at that period, ahead of that of the first cell, -0.5 to 0.5; empty without a rhythm")
OBSERVATION(std::vector<Vec2d>, body, {}, "cell", growth, everywhere, "cell centres at the end of development")
OBSERVATION(std::vector<Vec2d>, final_shape, {}, "cell", locomotion, everywhere, "cell centres after the last step, in the order of body")
OBSERVATION(std::vector<Vec2d>, phase_start, {}, "cell", locomotion, with_phases, "centre of mass before the first step in each world, the first one included")
OBSERVATION(std::vector<Vec2d>, phase_finish, {}, "cell", locomotion, with_phases, "centre of mass after the last step in each world")
OBSERVATION(std::vector<double>, phase_steps, {}, "step", locomotion, with_phases, "steps of locomotion in each world")
OBSERVATION(std::vector<double>, phase_settle_steps, {}, "step", locomotion, with_phases, "steps until the body was at rest in each world; 0 where it did not settle")
OBSERVATION(Vec2d, object_rest, {}, "cell", locomotion, with_object, "centre of mass of the loose object when the body had come to rest")
OBSERVATION(Vec2d, object_finish, {}, "cell", locomotion, with_object, "the same at the end of locomotion")

#undef OBSERVATION

// SPDX-License-Identifier: MIT
// Every field of a life, once: the record of what one genome did. The struct, the digest that chains and signatures are
// made of, the fields that scripts read, the columns of the tables and the memory of known movements are made of this
// list. Read with a macro defined:
//
//   FIELD(type, name, initial, unit, known, meaning)
//   HIDDEN_FIELD(…)      the same, of a field that scripts do not see; FIELD unless it is defined
//
// known: the stage after which the value is known, growth or locomotion (KnownAfter).
// Units: cell = one cell diameter; step = one physics step; an empty unit means that the value is a name.
// The order is that of the digest. Changing it, or adding a field, changes the signature.
#ifndef HIDDEN_FIELD
#define HIDDEN_FIELD FIELD
#endif

FIELD(Outcome, outcome, Outcome::died_out, "", growth, "viable, or why development or locomotion ended early")
FIELD(int, cells, 0, "cells", growth, "cells at the end of development")
FIELD(int, largest, 0, "cells", growth, "most cells alive at once")
FIELD(int, births, 0, "cells", growth, "cells created, the zygote included")
FIELD(int, springs, 0, "springs", growth, "springs of the body")
FIELD(int, triangles, 0, "triangles", growth, "triangles of the body")
FIELD(double, elongation, 0, "1", growth, "length over width of the developed body by its principal axes; 0 without width")
HIDDEN_FIELD(ShapeDistribution, shape, {}, "1", growth, "shape distribution of the developed body; all 0 if growth did not end viable")
FIELD(int, settle_steps, 0, "step", locomotion, "steps until the body came to rest; 0 in water")
FIELD(Vec2d, rest, {}, "cell", locomotion, "centre of mass when the body had come to rest")
FIELD(Vec2d, finish, {}, "cell", locomotion, "centre of mass at the end of locomotion")
FIELD(double, activity, 0, "1", locomotion, "actuation bonus b_a of Eq. 5; 0 with oscillators")
FIELD(double, late_actuation, 0, "1", locomotion, "changes of muscle signals in the last quarter of locomotion over all; 0 without any")
FIELD(std::vector<Vec2d>, path, {}, "cell", locomotion, "centre of mass every path_interval steps, from rest to finish")

#undef FIELD
#undef HIDDEN_FIELD

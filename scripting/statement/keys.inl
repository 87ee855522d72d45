// SPDX-License-Identifier: MIT
// Every key that an experiment file may state, once: a line per key, table by table. What is allowed, the messages that
// say where a key belongs, and REFERENCE.md are made of this list. Read with macros defined:
//
//   TABLE(id, path, meaning)   begins the keys of one table; path: where it stands in a setting or in the experiment
//   KEY(name, kind, unit, standard, origin, meaning, example)
//   TABLE_END
//
// kind      what the value is; "quantity": a number, or the name of a parameter that stands for its value
// unit      of a number, as in parameters.inl; empty for everything else
// standard  what holds without the key; "needed": the key must be there (Reader checks that the code says the same)
// origin    a section or equation of the paper, the author and year of a publication, a page of paper/decisions/, or
//           "ours": how planula is used
// example   as a script states it; empty if the meaning says enough

TABLE(experiment, "experiment", "the table that a script returns; with one setting, the keys of a setting stand beside these")
KEY("name", "text", "", "needed", "ours", "names the experiment and the folder of its runs: 1 to 100 letters, digits, '-' and '_'", "name = \"honey\"")
KEY("title", "text", "", "the name", "ours", "for people; one line", "title = \"Thick water\"")
KEY("settings", "list of tables", "", "one setting", "§3", "the settings that are compared, each a table of the keys of a setting", "settings = { { name = \"thin\" }, { name = \"thick\" } }")
KEY("parameters", "table", "", "standard values", "ours", "departures from the standard values in all settings, by name", "parameters = { population = 40 }")
KEY("record", "text or whole number", "", "\"full\"", "0019", "which individuals the settings record: \"full\", all of them; or a random sample of 1 in 100, in a run with fewer individuals so many as the number says, \"sample\" for 1000", "record = 300")
KEY("statistics", "table or text", "", "needed", "0015", "what is computed from the runs, or the name of a module that returns it", "statistics = \"paper.summary\"")
KEY("sensitivity", "table", "", "the standard of each key", "0018", "what planula sensitivity varies", "sensitivity = { sample = 50 }")
TABLE_END

TABLE(setting, "setting", "one of the compared settings: a search in an environment, and how lives are judged")
KEY("name", "text", "", "needed", "ours", "names the setting and the folder of its runs: 1 to 100 letters, digits, '-' and '_'", "name = \"thick\"")
KEY("title", "text", "", "the name", "ours", "for people; one line", "title = \"Thick water\"")
KEY("actuation", "text", "", "needed", "§2.5", "what moves the springs: \"oscillator\" (Eq. 1) or \"grn\", the network itself (Eq. 2)", "actuation = \"grn\"")
KEY("search", "text", "", "needed", "§2.7", "the search that evolves the setting, one of the list below", "search = \"novelty\"")
KEY("engine", "text", "", "\"native\"", "0017", "the physics engine, one of the list below", "engine = \"reference\"")
KEY("environment", "table", "", "needed", "§2.5", "the world that bodies move in", "environment = paper.aquatic { flow = { x = 0.1 } }")
KEY("phases", "list of tables", "", "one world", "0025", "further worlds that bodies come into while they move", "phases = { { at = 2000, environment = paper.terrestrial() } }")
KEY("damage", "table", "", "none", "0025", "cells that bodies lose", "damage = { at = 2000, share = 0.3, side = \"left\" }")
KEY("parameters", "table", "", "standard values", "ours", "departures from the standard values in this setting, by name", "parameters = { population = 40 }")
KEY("fitness", "function", "", "needed", "Eq. 4", "fitness(life, parameters, penalty): a number, 0 or more; what searches maximise", "fitness = function(life) return life.displacement end")
KEY("penalty", "function", "", "needed", "Eq. 6", "penalty(life, parameters): 0 … 1; 0 means that the individual is invalid", "penalty = function(life) return life.outcome == \"viable\" and 1 or 0 end")
KEY("behaviour", "function", "", "needed", "§2.7.2", "behaviour(life, parameters): a list of 1 … 16 numbers, the descriptor that searches compare", "behaviour = function(life) return { life.finish.x, life.finish.y } end")
KEY("objectives", "list of tables and texts", "", "as the search", "0027", "what searches with several objectives aim at: \"nsga2\" at each, \"nslc\" at being better than similar individuals by each; functions of a life, \"fitness\" and \"novelty\"", "objectives = { { name = \"work\", value = function(life) return life.work end, goal = \"minimise\" }, \"fitness\" }")
KEY("descriptor", "list of tables", "", "numbers without names", "0027", "names the numbers that behaviour returns, in their order, and the range of each in the map of \"map-elites\"", "descriptor = { { name = \"cells\", from = 0, to = 256, cells = 16 } }")
KEY("start", "table", "", "generation 0 is random", "0016", "how generation 0 is evolved, by growth alone", "start = { generations = 30, behaviour = f }")
KEY("record", "text or whole number", "", "that of the experiment", "0019", "which individuals the setting records: \"full\", \"sample\" or a number", "record = \"sample\"")
TABLE_END

TABLE(environment, "environment", "the world that bodies move in")
KEY("gravity", "quantity", "cell/t.u.²", "0", "§2.5", "downward acceleration; needs a ground", "gravity = \"gravity\"")
KEY("gravity_direction", "quantity", "degree", "0", "0025", "direction of gravity, counter-clockwise from straight down: more than -90, less than 90", "gravity_direction = -20")
KEY("ground", "text or table", "", "\"none\"", "§2.5", "\"none\", \"flat\" (the line y = 0), a list of points {x, y} ascending in x, or a height function", "ground = { { -10, 0 }, { 10, 2 } }")
KEY("friction", "quantity", "1", "0", "§2.5", "Coulomb friction between nodes and ground", "friction = 0.8")
KEY("drag", "table", "", "no fluid", "§2.5", "the fluid's quadratic drag on the outline", "drag = { normal = 8, tangential = 4 }")
KEY("flow", "table", "", "a fluid at rest", "ours", "velocity of the fluid", "flow = { x = 0.1 }")
KEY("regions", "list of tables", "", "none", "0025", "rectangles with another fluid; a link of the outline is in the first one that holds its middle", "regions = { { top = 0, drag = { normal = 1, tangential = 0.1 }, buoyancy = 0.9 } }")
KEY("obstacles", "list of tables", "", "none", "0024", "closed polygons that do not cross themselves, a cell long or more: each a list of points {x, y}, or a table", "obstacles = { { { 5, 0 }, { 6, 0 }, { 6, 1 } } }")
KEY("ceiling", "table", "", "none", "0024", "a list of points {x, y} ascending in x, or a height function; a cell or more above the ground", "ceiling = { { -10, 4 }, { 10, 2 } }")
KEY("friction_patches", "list of tables", "", "none", "0024", "another friction of ground and ceiling between two places; from left to right, without overlap", "friction_patches = { { from = 2, to = 9, friction = 0.1 } }")
KEY("object", "table", "", "none", "0024", "a loose object to push, of cells without muscles", "object = { at = { 6, 2 }, radius = 1 }")
KEY("actuation_range", "quantity", "rest length", "needed", "§2.5", "largest change of a rest length when both cells agree, 0 … 0.9", "actuation_range = 0.4")
TABLE_END

TABLE(drag, "environment.drag", "quadratic drag of the fluid on the outline of the body")
KEY("normal", "quantity", "mass/cell²", "needed", "0009", "drag per length of outline across its motion", "normal = \"drag_normal\"")
KEY("tangential", "quantity", "mass/cell²", "needed", "0009", "drag per length of outline along its motion", "tangential = 0.1")
TABLE_END

TABLE(flow, "environment.flow", "velocity of the fluid")
KEY("x", "quantity or function", "cell/t.u.", "0", "0025", "to the right; x(t) at step t since locomotion or its phase began, which is sampled once, when the script is read", "x = 0.1")
KEY("y", "quantity or function", "cell/t.u.", "0", "0025", "upwards, or y(t)", "y = function(t) return math.sin(t / 100) end")
KEY("step", "number", "step", "needed by a function", "0025", "physics steps between two samples, which are joined by straight lines", "step = 10")
KEY("period", "number", "step", "see till", "0025", "begins again after so many steps, a multiple of step", "period = 400")
KEY("till", "number", "step", "see period", "0025", "stays as it is after so many steps, a multiple of step; at most 100000 samples", "till = 2000")
TABLE_END

TABLE(region, "environment.regions[]", "a rectangle with another fluid; gravity acts everywhere")
KEY("from", "number", "cell", "open to the left", "0025", "its left side, which belongs to it", "from = 20")
KEY("to", "number", "cell", "open to the right", "0025", "its right side, which does not", "to = 40")
KEY("bottom", "number", "cell", "open below", "0025", "its lower side, which belongs to it", "bottom = -10")
KEY("top", "number", "cell", "open above", "0025", "its upper side, which does not", "top = 0")
KEY("drag", "table", "", "that outside", "0025", "the drag of its fluid, as of an environment", "drag = { normal = 1, tangential = 0.1 }")
KEY("flow", "table", "", "that outside", "0025", "velocity of its fluid", "flow = { x = -0.2 }")
KEY("buoyancy", "number", "1", "0", "0025", "share of gravity that it takes away from the cells in it, 0 … 1; of regions without from and to", "buoyancy = 0.9")
TABLE_END

TABLE(region_flow, "environment.regions[].flow", "velocity of the fluid in a region")
KEY("x", "quantity", "cell/t.u.", "0", "0025", "to the right", "x = 0.1")
KEY("y", "quantity", "cell/t.u.", "0", "0025", "upwards", "y = -0.1")
TABLE_END

TABLE(ground, "environment.ground", "a ground by its height, which is sampled once, when the script is read; level beyond both ends")
KEY("height", "function", "cell", "needed", "0010", "height(x): the height of the ground at x", "height = function(x) return math.sin(x) end")
KEY("from", "number", "cell", "needed", "0010", "x of the first sample", "from = -50")
KEY("to", "number", "cell", "needed", "0010", "x of the last sample", "to = 50")
KEY("step", "number", "cell", "needed", "0010", "distance of two samples; at most 100000 samples", "step = 0.5")
TABLE_END

TABLE(phase, "phases[]", "another world that bodies come into, as they are and move")
KEY("at", "whole number", "step", "needed", "0025", "the step of locomotion that it begins with, a multiple of knot_interval", "at = 2000")
KEY("environment", "table", "", "needed", "0025", "the world, as that of a setting; on another ground the body is set down as at first", "environment = paper.terrestrial()")
KEY("settle", "true or false", "", "false", "0025", "the body comes to rest before it moves on, its muscles held as they are", "settle = true")
TABLE_END

TABLE(damage, "damage", "cells that bodies lose: share and side, or within; the largest part that holds together goes on")
KEY("at", "whole number", "step", "0", "0025", "before which step of locomotion, a multiple of knot_interval; 0: after growth", "at = 2000")
KEY("share", "number", "1", "see within", "0025", "share of the cells at the end of development, 0 … 1", "share = 0.3")
KEY("side", "text", "", "see within", "0025", "where they lay then: \"left\", \"right\", \"bottom\", \"top\", \"middle\", \"edge\" or, by a hash of their numbers, \"random\"", "side = \"left\"")
KEY("within", "table", "", "see share", "0025", "all cells in a rectangle, seen from their centre of mass", "within = { from = 0 }")
TABLE_END

TABLE(damage_within, "damage.within", "a rectangle, seen from the centre of mass of the developed body")
KEY("from", "number", "cell", "open to the left", "0025", "its left side, which belongs to it", "from = 0")
KEY("to", "number", "cell", "open to the right", "0025", "its right side, which does not", "to = 2")
KEY("bottom", "number", "cell", "open below", "0025", "its lower side, which belongs to it", "bottom = -1")
KEY("top", "number", "cell", "open above", "0025", "its upper side, which does not", "top = 1")
TABLE_END

TABLE(objective, "objectives[]", "an objective; \"fitness\" and \"novelty\" are stated by these texts alone")
KEY("name", "text", "", "needed", "0027", "of its columns in tables, which are called objective_<name>: a letter, then letters, digits, '-' and '_', at most 40", "name = \"work\"")
KEY("value", "function", "", "needed", "0027", "value(life, parameters, penalty): a number within ±1e100", "value = function(life) return life.work end")
KEY("goal", "text", "", "needed", "0027", "\"maximise\" or \"minimise\"", "goal = \"minimise\"")
TABLE_END

TABLE(descriptor, "descriptor[]", "one of the numbers that behaviour returns")
KEY("name", "text", "", "needed", "0027", "of its column in the table of the archive, behaviour_<name>: a letter, then letters, digits, '-' and '_', at most 40", "name = \"cells\"")
KEY("from", "number", "as the number", "no range", "0027", "where its range begins; what lies outside the range belongs to the niche at its edge", "from = 0")
KEY("to", "number", "as the number", "no range", "0027", "where its range ends", "to = 256")
KEY("cells", "whole number", "niches", "no range", "0027", "so many niches of equal width divide the range, 1 to 10000", "cells = 16")
TABLE_END

TABLE(obstacle, "environment.obstacles[]", "an obstacle with a friction of its own")
KEY("points", "list of points", "cell", "needed", "0024", "the corners of the polygon {x, y}, three or more, in either direction", "points = { { 5, 0 }, { 6, 0 }, { 6, 1 } }")
KEY("friction", "quantity", "1", "that of the environment", "0024", "Coulomb friction between nodes and obstacle", "friction = 0.1")
TABLE_END

TABLE(ceiling, "environment.ceiling", "a ceiling by its height, sampled as a ground")
KEY("height", "function", "cell", "needed", "0024", "height(x): the height of the ceiling at x", "height = function(x) return 4 + math.sin(x) end")
KEY("from", "number", "cell", "needed", "0024", "x of the first sample", "from = -50")
KEY("to", "number", "cell", "needed", "0024", "x of the last sample", "to = 50")
KEY("step", "number", "cell", "needed", "0024", "distance of two samples; at most 100000 samples", "step = 0.5")
TABLE_END

TABLE(patch, "environment.friction_patches[]", "a stretch of another friction")
KEY("from", "number", "cell", "needed", "0024", "x where it begins", "from = 2")
KEY("to", "number", "cell", "needed", "0024", "x where it ends", "to = 9")
KEY("friction", "quantity", "1", "needed", "0024", "Coulomb friction there", "friction = 0.1")
TABLE_END

TABLE(object, "environment.object", "a loose object: cells on a triangular lattice, a cell apart; a shape or a radius says which")
KEY("at", "point", "cell", "needed", "0024", "where one of its cells is at first, {x, y}", "at = { 6, 2 }")
KEY("shape", "list of points", "cell", "a disc", "0024", "a polygon around its cells, relative to `at`", "shape = { { 0, 0 }, { 3, 0 }, { 3, 1 }, { 0, 1 } }")
KEY("radius", "number", "cell", "a shape", "0024", "of a disc around `at`", "radius = 1")
TABLE_END

TABLE(start, "start", "how generation 0 is evolved before the run: by novelty search on growth alone")
KEY("generations", "whole number", "generations", "needed", "0016", "so many generations of novelty search, 1 or more", "generations = 30")
KEY("behaviour", "function", "", "needed", "0016", "behaviour(life, parameters) of a life that has grown and not moved", "behaviour = function(life) return { life.cells } end")
TABLE_END

TABLE(statistics, "statistics", "what is computed from the runs")
KEY("confidence", "quantity", "1", "needed", "Fig. 6", "coverage of bootstrap intervals", "confidence = \"confidence\"")
KEY("resamples", "quantity", "resamples", "needed", "0015", "of an interval, and draws of a permutation test", "resamples = \"bootstrap_resamples\"")
KEY("interval_runs", "whole number", "runs", "10", "0015", "of fewer runs there is no interval", "interval_runs = 10")
KEY("significance", "number", "1", "needed", "§3.2", "a p-value below this tells two groups apart", "significance = 0.05")
KEY("sample_share", "number", "1", "needed", "§3.4", "share of the individuals of a run in the table of end points", "sample_share = 0.01")
KEY("sample_least", "whole number", "individuals", "0", "ours", "of a smaller run so many individuals, on average", "sample_least = 1000")
KEY("fitness_classes", "whole number", "classes", "20", "Fig. 11", "classes of fitness between nothing and a generation's highest; divides 100", "fitness_classes = 20")
KEY("direction_distance", "number", "cell", "1", "§3.4", "who moved less has no direction", "direction_distance = 1")
KEY("endpoints", "list of texts", "", "all settings", "Fig. 8", "settings whose end points are tabled", "endpoints = { \"thick\" }")
KEY("claims", "list of tables", "", "no claims", "§3", "statements that the runs reproduce or contradict", "")
KEY("tables", "table of functions", "", "no tables", "0023", "tables of the experiment's own, name.csv each: name(runs, stats) returns a list of rows, {column = number or text}; `columns` in it names the columns in their order", "tables = { best = function(runs) return { { best = runs.thick[1].best_fitness[9] } } end }")
TABLE_END

TABLE(claim, "statistics.claims[]", "a statement about the runs, and the function that judges it")
KEY("id", "text", "", "needed", "0015", "a short name, unique among the claims; it names the random streams of the claim's bootstraps", "id = \"S1\"")
KEY("statement", "text", "", "needed", "0015", "what is claimed", "")
KEY("judge", "function", "", "needed", "0023", "judge(runs, stats, claim): {verdict = \"reproduced\", \"contradicted\" or \"inconclusive\"}, and, as far as there are such, effect_name, effect, low, high, p, method, p_equivalence, note; claim holds id, a, b, generation, and at_generation, which is as much of `generation` as the runs of a and b have", "judge = function(runs, stats, claim) return { verdict = \"inconclusive\" } end")
KEY("a", "text", "", "needed", "0015", "a setting", "a = \"thick\"")
KEY("b", "text", "", "no other setting", "0015", "the setting that it is compared with", "b = \"thin\"")
KEY("generation", "whole number", "generations", "the last", "0015", "counted from 1", "generation = 400")
KEY("section", "text", "", "nothing", "0015", "where it is claimed", "section = \"§3.2\"")
KEY("paper", "text", "", "nothing", "0015", "the evidence given there", "paper = \"p = 0.01\"")
KEY("test", "text", "", "nothing", "0015", "the test that judges it, in a word for the table", "test = \"best_at_generation\"")
KEY("calibrated", "true or false", "", "false", "0018", "the statement was used to choose the model, so that its verdict is no evidence", "")
TABLE_END

TABLE(sensitivity, "sensitivity", "what planula sensitivity varies: each parameter by each factor, in recorded individuals")
KEY("sample", "whole number", "individuals", "200", "0018", "individuals of each setting", "sample = 50")
KEY("factors", "list of numbers", "1", "{ 0.5, 2 }", "0018", "what a value is multiplied by", "factors = { 0.9, 1.1 }")
KEY("parameters", "list of texts", "", "all assumed values", "0018", "names of the parameters that are varied", "parameters = { \"gravity\" }")
TABLE_END

#undef TABLE
#undef KEY
#undef TABLE_END

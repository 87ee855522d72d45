// SPDX-License-Identifier: MIT
// Every column of every table that planula writes, once: rows, headers, readers and columns.csv are made of
// this list. Read with these macros defined:
//
//   TABLE(row type, file)      opens a table; the columns that follow are its own, in the order of the file
//   COLUMN(type, name, unit, meaning)
//   END_TABLE
//
// What a table holds of a life is described in evaluation/life.inl: LIFE_COLUMN(type, name) is the column of the field
// of that name, LIFE_POINT(name) are the columns name_x and name_y of a point.
//
// Types: int, std::int64_t, double, std::string; Maybe (a double) and MaybeId (an std::int64_t) may be empty.
// Units: cell = one cell diameter; step = one physics step; generation = a number from 0; an empty unit means
// that the value is a text.

#define LIFE_COLUMN(type, name) COLUMN(type, name, life_field(#name).unit, life_field(#name).meaning)
#define LIFE_POINT(name)                                                                                     \
    COLUMN(double, name##_x, life_field(#name).unit, std::string(life_field(#name).meaning) + ", horizontal") \
    COLUMN(double, name##_y, life_field(#name).unit, std::string(life_field(#name).meaning) + ", vertical")

// ---- A run's directory, <setting>/seed-NNN/ ----

TABLE(ManifestRow, "manifest.csv")
COLUMN(std::string, key, "", "what the row states")
COLUMN(std::string, value, "", "its value")
END_TABLE

TABLE(IdentityRow, "identity.csv")
COLUMN(std::string, key, "", "what decides the run's genomes and lives: model, seed, actuation, search, engine, start, environment …, function …, parameter …")
COLUMN(std::string, value, "", "its value; of the model the revision, a hash over what signed runs produce; of a function a hash of its meaning")
COLUMN(std::string, place, "", "of a function its file below script/ and its line; no part of the identity")
COLUMN(std::string, standard, "", "of a parameter its standard value when the run began")
END_TABLE

TABLE(OverrideRow, "overrides.csv")
COLUMN(std::string, parameter, "", "a parameter that the command line which began the run set beside the script")
COLUMN(std::string, value, "as the parameter", "its value")
END_TABLE

TABLE(ChainRow, "chain.csv")
COLUMN(int, generation, "generation", "number of the generation, from 0")
COLUMN(std::string, content, "", "SHA-256 over all genomes, lives, evaluations, scores, species and archive entries of the generation")
COLUMN(std::string, link, "", "SHA-256 over the link before (of generation 0: the identity), the content, and the generation's rows in every table of the run")
END_TABLE

TABLE(GenerationRow, "generations.csv")
COLUMN(int, generation, "generation", "number of the generation, from 0")
COLUMN(double, best_fitness, "cell", "highest fitness in this generation")
COLUMN(int, best_slot, "slot", "slot of the fittest, the lowest of equals")
COLUMN(double, best_x, "cell", "horizontal displacement of the fittest from rest to end")
COLUMN(double, best_y, "cell", "vertical displacement of the fittest from rest to end")
COLUMN(double, mean_fitness, "cell", "mean fitness of all individuals")
COLUMN(int, valid, "individuals", "individuals whose penalty factor is above 0")
COLUMN(double, fitness_low, "cell", "lower quartile of the fitness of the valid individuals; 0 without any")
COLUMN(double, fitness_median, "cell", "median of their fitness")
COLUMN(double, fitness_high, "cell", "upper quartile of their fitness")
COLUMN(int, moved, "individuals", "individuals whose centre of mass moved at all")
COLUMN(double, heading_x, "1", "sum over these of the horizontal part of the unit vector from rest to end")
COLUMN(double, heading_y, "1", "sum over these of its vertical part")
COLUMN(int, species, "species", "species in the population")
COLUMN(double, threshold, "1", "compatibility threshold that placed this generation; 0 without species")
COLUMN(double, mean_links, "links", "mean number of links of a genome")
COLUMN(double, mean_hidden, "nodes", "mean number of hidden nodes of a genome")
COLUMN(int, archive, "individuals", "entries in the archive after this generation; 0 without one")
COLUMN(double, archive_threshold, "cell", "novelty that the archive asks for after this generation; 0 without one")
COLUMN(int, viable, "individuals", "individuals that grew, settled and moved to the end")
COLUMN(int, died_out, "individuals", "individuals whose last cell died")
COLUMN(int, too_small, "individuals", "individuals with too few cells at the end of development")
COLUMN(int, overgrown, "individuals", "individuals that reached the cell limit")
COLUMN(int, never_settled, "individuals", "individuals that did not come to rest on the ground")
COLUMN(int, exploded, "individuals", "individuals with a speed beyond the guard or a number that is not finite")
COLUMN(int, overborn, "individuals", "individuals that reached the birth limit, whatever became of them")
COLUMN(double, shape_diversity, "1", "mean morphological distance over all pairs of viable individuals, in mean distances between two cells: D2 shape distributions of Osada et al. 2002, core/body/shape.h; 0 with fewer than two")
COLUMN(int, children, "individuals", "individuals that mutation or crossover made and whose mother has fitness above 0; unchanged copies do not count")
COLUMN(int, pairs, "pairs", "pairs of a mother and a child: those of the children whose own fitness is above 0")
COLUMN(Maybe, heredity_fitness, "1", "mother-offspring correlation of fitness, Eq. 4: Spearman's rank correlation over the pairs; empty with fewer than 3, or if all mothers or all children are equal")
COLUMN(Maybe, heredity_cells, "1", "mother-offspring correlation of the cells at the end of development, in the same way")
COLUMN(Maybe, kept_fitness, "1", "median over the children of the fitness over the mother's, which is 0 of a child without fitness; empty with fewer than 3 children")
COLUMN(Maybe, near_mother, "1", "share of the children whose fitness differs from the mother's by at most a tenth of hers; empty with fewer than 3 children")
COLUMN(Maybe, cells_change, "1", "median over the pairs of the difference of cells, without its sign, over the mother's; empty with fewer than 3 pairs")
COLUMN(double, near_best, "1", "share of all individuals whose fitness is above nine tenths of the generation's highest; 0 if that is 0")
COLUMN(Maybe, cyclic, "1", "share with a cyclic gait of the individuals with fitness above 0: in the last quarter of locomotion there are at least a tenth of the distance and a tenth of the changes of muscle signals; empty without any")
END_TABLE

TABLE(SizeRow, "sizes.csv.gz")
COLUMN(int, generation, "generation", "number of the generation, from 0")
COLUMN(int, cells, "cells", "cells at the end of development")
COLUMN(int, individuals, "individuals", "individuals of this size whose fitness is above 0; sizes without any have no row")
END_TABLE

TABLE(FitnessClassRow, "fitness_classes.csv.gz")
COLUMN(int, generation, "generation", "number of the generation, from 0")
COLUMN(int, percent, "%", "lower end of a class of fitness, in percent of the generation's highest; a class is 1 % wide and excludes its upper end, but for the last")
COLUMN(int, individuals, "individuals", "individuals in the class; classes without any have no row")
END_TABLE

TABLE(IndividualRow, "individuals.csv.gz")
COLUMN(int, generation, "generation", "generation of the individual")
COLUMN(int, slot, "slot", "its place in the population: species in list order, members as placed")
COLUMN(std::int64_t, genome, "id", "its genome, numbered in order of birth in the run")
COLUMN(std::int64_t, mother, "id", "the genome it was made from; -1: none")
COLUMN(std::int64_t, father, "id", "the second parent; -1: none")
COLUMN(std::string, origin, "", "the operator that made the genome")
COLUMN(int, species, "id", "its species, numbered in order of foundation in the run; searches without species have one")
COLUMN(double, fitness, "cell", "fitness, Eq. 4")
COLUMN(double, score, "as the search", "what the search rewards; " + search_scores())
COLUMN(double, penalty, "1", "penalty factor p of Eq. 6; 0: not valid")
LIFE_COLUMN(std::string, outcome)
LIFE_COLUMN(int, cells)
LIFE_COLUMN(int, births)
LIFE_POINT(finish)
LIFE_POINT(rest)
LIFE_COLUMN(double, activity)
LIFE_COLUMN(double, elongation)
COLUMN(int, links, "links", "links of the genome")
COLUMN(int, hidden, "nodes", "hidden nodes of the genome")
END_TABLE

TABLE(ObjectiveRow, "individuals.csv.gz")
COLUMN(Maybe, objective_1, "as the objective", "objective_<name>, for each objective that the experiment states as a function, by its name; empty for individuals that are not valid; without objectives there is no such column, with them also in archive.csv.gz")
END_TABLE

TABLE(SpeciesRow, "species.csv.gz")
COLUMN(int, generation, "generation", "generation of the population")
COLUMN(int, species, "id", "the species, numbered in order of foundation in the run; rows are in the order of slots")
COLUMN(int, size, "individuals", "its members in this generation")
COLUMN(int, age, "generations", "generations that it existed before this one, since its foundation or since it ceased to be the best species")
COLUMN(int, stagnation, "generations", "how many of them passed since its best score rose")
COLUMN(int, was_best, "0 or 1", "1 if it was the best species before this generation; the best one never counts as stagnating")
COLUMN(double, best_score, "cell", "highest score of its members: fitness or novelty, as the search rewards")
COLUMN(double, mean_score, "cell", "mean score of its members")
COLUMN(double, best_ever, "cell", "highest score of its members in all generations before this one; 0 for a new species")
COLUMN(std::int64_t, representative, "id", "genome that newborns are compared with: its first member")
END_TABLE

TABLE(ArchiveRow, "archive.csv.gz")
COLUMN(int, generation, "generation", "generation that added the individual to the archive")
COLUMN(std::int64_t, genome, "id", "its genome")
COLUMN(double, fitness, "cell", "its fitness, Eq. 4")
COLUMN(double, novelty_or_gain, "cell", "its novelty when it was added, Eq. 7; of map-elites the fitness that it added to the map")
COLUMN(double, x, "cell", "first number of its descriptor: in the paper the final centre of mass, horizontal")
COLUMN(double, y, "cell", "second number of its descriptor: in the paper the final centre of mass, vertical")
END_TABLE

TABLE(ArchiveDescriptorRow, "archive.csv.gz")
COLUMN(double, behaviour_1, "as the descriptor", "with behaviour_2 and so on in place of x and y where a descriptor has not two numbers; behaviour_<name> where the experiment names them")
END_TABLE

TABLE(ChampionRow, "champions.csv")
COLUMN(int, generation, "generation", "generation in which the run's best fitness rose; the first row is generation 0")
COLUMN(int, slot, "slot", "slot of the new champion")
COLUMN(std::int64_t, genome, "id", "its genome")
COLUMN(double, fitness, "cell", "its fitness, Eq. 4")
LIFE_COLUMN(int, cells)
COLUMN(double, displacement, "cell", "distance from rest to end, without bonus and penalty")
COLUMN(double, late_share, "1", "distance made in the last quarter of locomotion over the displacement; 0 without one")
LIFE_COLUMN(double, late_actuation)
LIFE_COLUMN(double, elongation)
COLUMN(double, x, "cell", "horizontal displacement from rest to end")
COLUMN(double, y, "cell", "vertical displacement from rest to end")
LIFE_COLUMN(int, springs)
LIFE_COLUMN(int, triangles)
COLUMN(int, links, "links", "links of the genome")
COLUMN(int, hidden, "nodes", "hidden nodes of the genome")
LIFE_COLUMN(int, settle_steps)
END_TABLE

TABLE(GenomeRow, "genome.csv")
COLUMN(std::string, kind, "", "first row: the operator that made the genome; then nodes: input, bias, output, hidden; then links: link")
COLUMN(std::int64_t, id, "id", "number of the genome, id of the node, innovation of the link")
COLUMN(MaybeId, from, "id", "first row: mother, -1 for none; link: the node it leaves")
COLUMN(MaybeId, to, "id", "first row: father, -1 for none; link: the node it enters")
COLUMN(Maybe, value, "1", "node: depth, 0 for inputs and 1 for outputs; link: weight")
COLUMN(int, recurrent, "0 or 1", "1 for a recurrent link")
END_TABLE

TABLE(ChampionGenomeRow, "champion_genomes.csv.gz")
COLUMN(int, generation, "generation", "generation of the champion: each row of champions.csv has its genome here")
COLUMN(std::string, kind, "", "first row of a genome: the operator that made it; then nodes: input, bias, output, hidden; then links: link")
COLUMN(std::int64_t, id, "id", "number of the genome, id of the node, innovation of the link")
COLUMN(MaybeId, from, "id", "first row: mother, -1 for none; link: the node it leaves")
COLUMN(MaybeId, to, "id", "first row: father, -1 for none; link: the node it enters")
COLUMN(Maybe, value, "1", "node: depth, 0 for inputs and 1 for outputs; link: weight")
COLUMN(int, recurrent, "0 or 1", "1 for a recurrent link")
END_TABLE

// ---- What planula lineage prints ----

TABLE(LineageRow, "lineage.csv")
COLUMN(int, generation, "generation", "generation of the ancestor, the oldest first")
COLUMN(int, slot, "slot", "its place in the population")
COLUMN(std::int64_t, genome, "id", "its genome, numbered in order of birth in the run")
COLUMN(std::string, origin, "", "the operator that made the genome")
COLUMN(std::int64_t, mother, "id", "the genome it was made from; -1: none")
COLUMN(std::int64_t, father, "id", "the second parent; -1: none")
COLUMN(int, species, "id", "its species")
COLUMN(double, fitness, "cell", "fitness, Eq. 4")
COLUMN(int, cells, "cells", "cells at the end of development")
COLUMN(int, links, "links", "links of the genome")
COLUMN(int, hidden, "nodes", "hidden nodes of the genome")
END_TABLE

// ---- Reduced tables ----

TABLE(SettingRow, "settings.csv")
COLUMN(std::string, setting, "", "name of the setting")
COLUMN(std::string, title, "", "the setting in words")
COLUMN(std::string, actuation, "", "oscillator or grn")
COLUMN(std::string, world, "", "terrestrial with ground, else aquatic")
COLUMN(std::string, search, "", "name of the search")
COLUMN(int, runs, "runs", "complete runs that the tables rest on")
COLUMN(int, generations, "generations", "generations that all these runs have")
COLUMN(int, population, "individuals", "individuals in a generation")
END_TABLE

TABLE(WorldRow, "worlds.csv")
COLUMN(std::string, setting, "", "name of the setting")
COLUMN(std::string, quantity, "", "a number of its environment, as in identity.csv; ground points: of its polyline, 0 if it is flat")
COLUMN(Maybe, value, "see unit", "what its simulations used; empty without ground")
COLUMN(std::string, unit, "", "unit of the value")
COLUMN(std::string, parameter, "", "the parameter that the number was taken from; empty if the experiment states it itself")
END_TABLE

TABLE(RunRow, "runs.csv")
COLUMN(std::string, setting, "", "name of the setting")
COLUMN(std::int64_t, seed, "", "seed of the run")
COLUMN(int, generations, "generations", "generations that the row rests on: those that all runs of the setting have")
COLUMN(double, best_fitness, "cell", "fitness of the run's champion, its best individual")
COLUMN(double, best_displacement, "cell", "distance that the champion moved")
COLUMN(int, best_generation, "generation", "generation of the champion")
COLUMN(int, best_cells, "cells", "cells of the champion")
COLUMN(double, late_share, "1", "champion's distance in the last quarter of locomotion over its displacement")
COLUMN(double, late_actuation, "1", "champion's changes of muscle signals in the last quarter of locomotion over all")
COLUMN(double, elongation, "1", "champion's length over width")
COLUMN(double, size_entropy, "nat", "Shannon entropy of the cell counts of all individuals with fitness above 0, Eq. 8")
COLUMN(std::int64_t, with_fitness, "individuals", "individuals with fitness above 0, those that the entropy counts")
COLUMN(double, valid_share_last, "1", "share of the last generation whose penalty factor is above 0")
COLUMN(Maybe, fitness_spread_last, "1", "interquartile range of fitness over the highest, valid individuals of the last generation; empty if the highest is 0")
COLUMN(double, shape_diversity_first, "1", "mean morphological distance of the viable individuals of generation 0, see generations.csv")
COLUMN(double, shape_diversity_last, "1", "the same of the last generation")
COLUMN(Maybe, direction_resultant, "1", "mean resultant length of the end directions of the sampled individuals (1 in 100, at least 1000) that moved by the direction_distance of the statistics, one cell unless stated; 1: all went one way; empty if none moved")
COLUMN(int, side_switches, "switches", "how often the best so far was replaced by one that ended on the other side; who ended nearer than that to where it rested is on neither")
END_TABLE

TABLE(CurveRow, "curves.csv")
COLUMN(std::string, setting, "", "name of the setting")
COLUMN(int, generation, "generation", "number of the generation, from 0")
COLUMN(int, runs, "runs", "runs averaged")
COLUMN(double, mean, "cell", "best fitness in the generation, mean over runs")
COLUMN(Maybe, low, "cell", "lower end of the bootstrap interval of the mean; empty with too few runs")
COLUMN(Maybe, high, "cell", "upper end of the bootstrap interval of the mean; empty with too few runs")
END_TABLE

TABLE(EndpointRow, "endpoints.csv")
COLUMN(std::string, setting, "", "name of the setting")
COLUMN(std::int64_t, seed, "", "seed of the run")
COLUMN(std::string, role, "", "best: the setting's best run; median: the best run below the median")
COLUMN(int, generation, "generation", "generation of a randomly sampled viable individual")
COLUMN(double, x, "cell", "its horizontal displacement from rest to end")
COLUMN(double, y, "cell", "its vertical displacement from rest to end")
END_TABLE

TABLE(EndpointDensityRow, "endpoint_density.csv")
COLUMN(std::string, setting, "", "name of the setting")
COLUMN(std::int64_t, seed, "", "seed of the run")
COLUMN(std::string, role, "", "best: the setting's best run; median: the best run below the median")
COLUMN(int, generation_low, "generation", "first generation of the bin")
COLUMN(int, generation_high, "generation", "last generation of the bin")
COLUMN(double, x_low, "cell", "lower end of the bin of horizontal displacements from rest to end")
COLUMN(double, x_high, "cell", "upper end of the bin, excluded")
COLUMN(int, recorded, "individuals", "viable individuals in the bin among those that a run recorded as a sample has; a bin without any has no row")
COLUMN(double, individuals, "individuals", "estimate of the viable individuals in the bin among all of the run: the recorded ones, each over the share of its generation that is recorded")
END_TABLE

TABLE(EndpointPathRow, "endpoint_paths.csv")
COLUMN(std::string, setting, "", "name of the setting")
COLUMN(std::int64_t, seed, "", "seed of the run")
COLUMN(std::string, role, "", "best: the setting's best run; median: the best run below the median")
COLUMN(int, generation, "generation", "number of the generation, from 0")
COLUMN(double, x, "cell", "horizontal displacement of the generation's best individual")
COLUMN(double, y, "cell", "vertical displacement of the generation's best individual")
COLUMN(double, fitness, "cell", "its fitness")
END_TABLE

TABLE(ArchivePointRow, "archives.csv")
COLUMN(std::string, setting, "", "name of the setting")
COLUMN(std::int64_t, seed, "", "seed of the setting's best run")
COLUMN(int, generation, "generation", "generation that added the individual to the novelty archive")
COLUMN(double, x, "cell", "first number of its descriptor")
COLUMN(Maybe, y, "cell", "second number of its descriptor; empty where there is none")
END_TABLE

TABLE(FitnessShareRow, "fitness_shares.csv")
COLUMN(std::string, setting, "", "name of the setting")
COLUMN(int, runs, "runs", "runs averaged")
COLUMN(double, low, "1", "lower end of a class of fitness over the highest in the last generation")
COLUMN(double, high, "1", "upper end of the class, excluded but for the last")
COLUMN(double, share, "1", "share of the last generation in the class, mean over runs")
END_TABLE

TABLE(FitnessHistoryRow, "fitness_history.csv")
COLUMN(std::string, setting, "", "name of the setting")
COLUMN(int, runs, "runs", "runs averaged")
COLUMN(int, generation_low, "generation", "first generation of the bin")
COLUMN(int, generation_high, "generation", "last generation of the bin")
COLUMN(double, low, "1", "lower end of a class of fitness over the highest of the generation")
COLUMN(double, high, "1", "upper end of the class, excluded but for the last")
COLUMN(double, share, "1", "share of the individuals in the class, mean over the generations of the bin and over runs")
END_TABLE

TABLE(EntropyRow, "entropy.csv")
COLUMN(std::string, setting, "", "name of the setting")
COLUMN(int, runs, "runs", "runs averaged")
COLUMN(double, mean, "nat", "size entropy of a run, Eq. 8, mean over runs")
COLUMN(Maybe, low, "nat", "lower end of the bootstrap interval of the mean; empty with too few runs")
COLUMN(Maybe, high, "nat", "upper end of the bootstrap interval of the mean; empty with too few runs")
COLUMN(double, median, "nat", "size entropy of a run, median over runs")
END_TABLE

TABLE(ShapeDiversityRow, "shape_diversity.csv")
COLUMN(std::string, setting, "", "name of the setting")
COLUMN(int, generation, "generation", "number of the generation, from 0")
COLUMN(int, runs, "runs", "runs averaged")
COLUMN(double, mean, "1", "mean morphological distance of the generation's viable individuals, see generations.csv; mean over runs")
COLUMN(Maybe, low, "1", "lower end of the bootstrap interval of the mean; empty with too few runs")
COLUMN(Maybe, high, "1", "upper end of the bootstrap interval of the mean; empty with too few runs")
END_TABLE

TABLE(HeredityRow, "heredity.csv")
COLUMN(std::string, setting, "", "name of the setting")
COLUMN(int, generation, "generation", "number of the generation, from 0")
COLUMN(int, runs, "runs", "runs of the setting; the following are medians over those that have a value, and empty without any")
COLUMN(Maybe, heredity_fitness, "1", "mother-offspring correlation of fitness, see generations.csv")
COLUMN(Maybe, heredity_cells, "1", "mother-offspring correlation of the cells, see generations.csv")
COLUMN(Maybe, kept_fitness, "1", "a child's fitness over its mother's, see generations.csv")
COLUMN(Maybe, near_mother, "1", "share of the children within a tenth of their mother's fitness, see generations.csv")
COLUMN(Maybe, cells_change, "1", "relative change of the cells from mother to child, see generations.csv")
COLUMN(Maybe, near_best, "1", "share of the individuals above nine tenths of the generation's highest fitness")
COLUMN(Maybe, cyclic, "1", "share of the individuals with fitness above 0 whose gait is cyclic, see generations.csv")
END_TABLE

TABLE(OutcomeRow, "outcomes.csv")
COLUMN(std::string, setting, "", "name of the setting")
COLUMN(int, generation, "generation", "the first or the last generation")
COLUMN(double, viable, "1", "share that grew, settled and moved to the end, mean over runs")
COLUMN(double, died_out, "1", "share whose last cell died, mean over runs")
COLUMN(double, too_small, "1", "share with too few cells at the end of development, mean over runs")
COLUMN(double, overgrown, "1", "share that reached the cell limit, mean over runs")
COLUMN(double, never_settled, "1", "share that did not come to rest on the ground, mean over runs")
COLUMN(double, exploded, "1", "share with a speed beyond the guard or a number that is not finite, mean over runs")
COLUMN(double, overborn, "1", "share that reached the birth limit, whatever became of them, mean over runs")
END_TABLE

TABLE(ClaimRow, "claims.csv")
COLUMN(std::string, id, "", "short name of the claim")
COLUMN(std::string, statement, "", "the claim in words")
COLUMN(std::string, section, "", "section of the paper that makes it")
COLUMN(std::string, paper, "", "what the paper gives as evidence")
COLUMN(std::string, test, "", "the test that judges it")
COLUMN(std::string, setting_a, "", "first setting")
COLUMN(std::string, setting_b, "", "second setting; empty where the test has none")
COLUMN(int, generation, "generations", "the claim is about this generation, counted from 1: 2000 is the last of 2000")
COLUMN(int, at_generation, "generations", "the values are of this generation, counted from 1; 0 without data")
COLUMN(int, runs_a, "runs", "runs of the first setting")
COLUMN(int, runs_b, "runs", "runs of the second setting")
COLUMN(std::string, effect_name, "", "what the effect is")
COLUMN(Maybe, effect, "1", "size of the effect")
COLUMN(Maybe, low, "1", "lower end of its bootstrap interval; empty with too few runs")
COLUMN(Maybe, high, "1", "upper end of its bootstrap interval")
COLUMN(Maybe, p, "1", "p-value of the test of a difference, two-sided, but of cyclic one-sided; empty where there is none")
COLUMN(std::string, method, "", "how p was computed: exact, by counting all ways; normal, by the normal approximation; drawn, from permutations drawn at random")
COLUMN(Maybe, p_holm, "1", "p corrected after Holm, over all p and p_equivalence of the table")
COLUMN(Maybe, p_equivalence, "1", "p-value of the test that there is no difference beyond the claim's bound; of cyclic, that the share is below it; empty for other claims")
COLUMN(Maybe, p_equivalence_holm, "1", "p_equivalence corrected after Holm, over all p and p_equivalence of the table")
COLUMN(std::string, verdict, "", "reproduced, contradicted, inconclusive, or open while data are missing")
COLUMN(std::string, verdict_reached, "", "the verdict of the runs and generations that there are, as if no more were planned: equal to verdict unless that is open; empty without data")
COLUMN(std::string, decided_by, "", "the column whose value below the significance decides verdict_reached: p_holm or p_equivalence_holm if that is, else p or p_equivalence alone; empty if none decides")
COLUMN(int, calibrated, "0 or 1", "1: what the claim says was used to choose the model, so that its verdict is no evidence")
COLUMN(std::string, note, "", "what limits the verdict; of an open one, which data are missing")
COLUMN(std::string, note_reached, "", "what limits verdict_reached")
END_TABLE

// ---- What planula compare writes ----

TABLE(ComparedRunRow, "compared_runs.csv")
COLUMN(std::string, measure, "", "what is compared: a column of runs.csv or generations.csv")
COLUMN(std::string, unit, "", "its unit")
COLUMN(int, generations, "generations", "generations after which the runs are compared")
COLUMN(std::string, setting, "", "name of the setting, with its experiment or script where two have the same")
COLUMN(std::int64_t, seed, "", "seed of the run")
COLUMN(Maybe, value, "see unit", "its value; empty if it has none")
END_TABLE

TABLE(ComparedSettingRow, "compared_settings.csv")
COLUMN(std::string, measure, "", "what is compared")
COLUMN(std::string, setting, "", "name of the setting")
COLUMN(int, runs, "runs", "runs that have a value")
COLUMN(Maybe, median, "as the measure", "median of their values; empty without any")
COLUMN(Maybe, low, "as the measure", "lower end of its bootstrap interval; empty with too few runs")
COLUMN(Maybe, high, "as the measure", "upper end")
END_TABLE

TABLE(ComparisonRow, "comparisons.csv")
COLUMN(std::string, measure, "", "what is compared")
COLUMN(std::string, a, "", "first setting")
COLUMN(std::string, b, "", "second setting, with which it is compared")
COLUMN(int, pairs, "pairs", "pairs of runs of the same seed; 0: the runs were compared as independent samples")
COLUMN(int, runs_a, "runs", "runs of the first setting that were compared")
COLUMN(int, runs_b, "runs", "runs of the second")
COLUMN(Maybe, median_a, "as the measure", "median of the first")
COLUMN(Maybe, median_b, "as the measure", "median of the second")
COLUMN(Maybe, difference, "as the measure", "by how much the first lies above the second: Hodges and Lehmann's estimate")
COLUMN(Maybe, difference_low, "as the measure", "lower end of its interval, of all shifts that the test does not reject; empty with too few runs")
COLUMN(Maybe, difference_high, "as the measure", "upper end")
COLUMN(Maybe, a12, "1", "probability that a run of the first has a larger value than one of the second, ties counting half: Vargha and Delaney's A12")
COLUMN(Maybe, a12_low, "1", "lower end of its BCa bootstrap interval, of pairs if there are; empty with too few runs, or if no value of one setting lies among those of the other")
COLUMN(Maybe, a12_high, "1", "upper end")
COLUMN(int, larger, "pairs", "pairs in which the first is larger")
COLUMN(int, smaller, "pairs", "pairs in which it is smaller")
COLUMN(std::string, test, "", "Wilcoxon's signed-rank test of pairs, else his rank-sum test")
COLUMN(std::string, method, "", "how p was computed: exact, or by the normal approximation")
COLUMN(Maybe, p, "1", "two-sided p; empty if so few runs cannot give one below the significance")
COLUMN(Maybe, p_holm, "1", "p corrected after Holm, over all p of the table")
COLUMN(std::string, note, "", "what limits the comparison")
END_TABLE

// ---- Reduced tables ----

TABLE(BestGenomeRow, "best_genomes.csv")
COLUMN(std::string, setting, "", "name of the setting")
COLUMN(int, rank, "", "1: the setting's best run; then the next best, up to the third")
COLUMN(std::int64_t, seed, "", "seed of that run")
COLUMN(double, fitness, "cell", "fitness of that run's best individual")
COLUMN(double, displacement, "cell", "distance that it moved")
COLUMN(int, cells, "cells", "its cells at the end of development")
COLUMN(std::string, kind, "", "first row of a genome: the operator that made it; then nodes: input, bias, output, hidden; then links: link")
COLUMN(std::int64_t, id, "id", "number of the genome, id of the node, innovation of the link")
COLUMN(MaybeId, from, "id", "first row: mother, -1 for none; link: the node it leaves")
COLUMN(MaybeId, to, "id", "first row: father, -1 for none; link: the node it enters")
COLUMN(Maybe, value, "1", "node: depth, 0 for inputs and 1 for outputs; link: weight")
COLUMN(int, recurrent, "0 or 1", "1 for a recurrent link")
END_TABLE

TABLE(WitnessRow, "witness.csv")
COLUMN(std::string, setting, "", "name of the setting")
COLUMN(std::int64_t, seed, "", "seed of the run whose champion, its best individual, is simulated again; a run without a viable one has no row")
COLUMN(double, fitness, "cell", "the champion's fitness, Eq. 4")
COLUMN(int, cells, "cells", "its cells at the end of development")
COLUMN(double, elongation, "1", "its length over width by its principal axes; 0 without width")
COLUMN(double, displacement, "cell", "distance from rest to end in the native engine")
COLUMN(int, settle_steps, "step", "steps until the body came to rest in the native engine; 0 in water")
COLUMN(Maybe, rest_height, "cell", "height of the centre of mass at rest in the native engine; empty if that life is not viable")
COLUMN(std::string, half_outcome, "", "its outcome in the native engine at half the time step")
COLUMN(double, half_displacement, "cell", "distance at half the time step; 0 unless viable")
COLUMN(double, half_change, "1", "difference of half_displacement from displacement, over the larger of displacement and one cell diameter")
COLUMN(std::string, eighth_outcome, "", "its outcome in the native engine at an eighth of the time step")
COLUMN(double, eighth_displacement, "cell", "distance at an eighth of the time step; 0 unless viable")
COLUMN(double, eighth_change, "1", "difference of eighth_displacement from displacement, over the larger of displacement and one cell diameter")
COLUMN(std::string, bullet_outcome, "", "its outcome in Bullet")
COLUMN(double, bullet_displacement, "cell", "distance in Bullet; 0 unless viable")
COLUMN(double, bullet_change, "1", "difference of bullet_displacement from displacement, over the larger of displacement and one cell diameter")
COLUMN(int, bullet_settle_steps, "step", "steps until the body came to rest in Bullet; 0 in water")
COLUMN(Maybe, bullet_rest_height, "cell", "height of the centre of mass at rest in Bullet; empty if that life is not viable")
COLUMN(double, nudged_change, "1", "the same difference from the displacement at an eighth of the time step when every cell is displaced there by up to witness_nudge before locomotion; the largest of witness_nudges simulations")
COLUMN(double, held_unrest, "cell/t.u.", "the fastest node relative to the motion of the body as a whole, when after locomotion the muscles have held still for as long again")
COLUMN(std::string, flag, "", "integration exploit: half_change above exploit_bound, or not viable at half the time step; else perpetual motion: held_unrest above unrest_bound; else empty")
COLUMN(std::string, cause, "", "why a finer step or Bullet gives another displacement, by more than exploit_bound, or another outcome; empty if none does. chaos: so does a nudge; else time step: half or an eighth of it does; else engine: only Bullet does")
END_TABLE

TABLE(EngineRow, "engines.csv")
COLUMN(std::string, setting, "", "name of the setting")
COLUMN(int, champions, "runs", "champions simulated again, one of each run that has a viable one")
COLUMN(Maybe, rank_correlation, "1", "Spearman's rank correlation of their displacements in the native engine and in Bullet; empty with fewer than 3")
COLUMN(Maybe, half_change_median, "1", "median of half_change in witness.csv")
COLUMN(Maybe, half_change_largest, "1", "largest half_change")
COLUMN(Maybe, bullet_change_median, "1", "median of bullet_change")
COLUMN(Maybe, bullet_change_largest, "1", "largest bullet_change")
COLUMN(Maybe, height_change_largest, "cell", "largest difference of bullet_rest_height from rest_height")
COLUMN(Maybe, held_unrest_largest, "cell/t.u.", "largest held_unrest")
COLUMN(int, flagged, "runs", "champions with a flag")
COLUMN(int, cause_chaos, "runs", "champions with the cause chaos")
COLUMN(int, cause_time_step, "runs", "champions with the cause time step")
COLUMN(int, cause_engine, "runs", "champions with the cause engine")
END_TABLE

TABLE(SensitivityRow, "sensitivity.csv")
COLUMN(std::string, setting, "", "name of the setting")
COLUMN(std::string, parameter, "", "the parameter that was changed, all others as they are")
COLUMN(double, standard, "see parameters.csv", "its value, or the number that the setting's environment states in its place")
COLUMN(double, value, "see parameters.csv", "the value in its place: standard times a factor, within the parameter's range and whole where it must be")
COLUMN(int, population, "individuals", "population of the runs that the sample is drawn from")
COLUMN(int, generations, "generations", "their generations; the last is drawn from")
COLUMN(int, sampled, "individuals", "individuals simulated with either value")
COLUMN(int, viable_before, "individuals", "those that are viable with the standard value")
COLUMN(int, viable_after, "individuals", "those that are viable with the other")
COLUMN(Maybe, ratio_low, "1", "displacement after over displacement before, lower quartile of those viable with both that moved before; empty without any")
COLUMN(Maybe, ratio_median, "1", "the same, median")
COLUMN(Maybe, ratio_high, "1", "the same, upper quartile")
COLUMN(Maybe, best_ratio, "1", "largest displacement in the sample after over the largest before; empty if no individual moved before")
COLUMN(Maybe, rank_correlation, "1", "Spearman's rank correlation of the displacements before and after over the whole sample, 0 where not viable; empty if all are equal")
END_TABLE

TABLE(ColumnRow, "columns.csv")
COLUMN(std::string, file, "", "name of a table")
COLUMN(std::string, column, "", "name of a column")
COLUMN(std::string, unit, "", "its unit; empty for texts")
COLUMN(std::string, meaning, "", "what it holds")
END_TABLE

TABLE(LedgerRow, "parameters.csv")
COLUMN(std::string, section, "", "part of the model")
COLUMN(std::string, name, "", "name of the parameter")
COLUMN(std::string, value, "as its unit", "value in this experiment, a choice by its name; empty where its settings differ, and where it is one of the worlds' but none of them takes it, as worlds.csv tells")
COLUMN(std::string, standard, "as its unit", "value in the replication of the paper")
COLUMN(std::string, unit, "", "unit of the values")
COLUMN(std::string, origin, "", "where the standard value comes from: the paper's section or equation, MN (MultiNEAT), ours")
COLUMN(std::string, meaning, "", "what the parameter does")
END_TABLE

// ---- Frames of individuals simulated again ----

TABLE(FrameRow, "frames.csv")
COLUMN(std::string, setting, "", "name of the setting")
COLUMN(int, rank, "", "rank of the run whose best individual is shown, see best_genomes.csv")
COLUMN(std::string, stage, "", "growth: development; gait: one longest oscillator period at the end of locomotion; path: all of locomotion")
COLUMN(int, frame, "frame", "number of the frame in its stage, from 0")
COLUMN(int, step, "step", "step of development or of locomotion")
COLUMN(int, cells, "cells", "cells alive")
COLUMN(double, centre_x, "cell", "centre of mass, horizontal")
COLUMN(double, centre_y, "cell", "centre of mass, vertical")
END_TABLE

TABLE(FrameCellRow, "frame_cells.csv")
COLUMN(std::string, setting, "", "name of the setting")
COLUMN(int, rank, "", "rank of the run whose best individual is shown, see best_genomes.csv")
COLUMN(std::string, stage, "", "growth, gait or path")
COLUMN(int, frame, "frame", "number of the frame in its stage, from 0")
COLUMN(int, cell, "cell number", "number of the cell, by age; after them those of a loose object")
COLUMN(double, x, "cell", "its centre, horizontal")
COLUMN(double, y, "cell", "its centre, vertical")
COLUMN(double, signal, "1", "its actuation, from -1 (contraction) to 1 (expansion); 0 in growth")
END_TABLE

TABLE(FrameLinkRow, "frame_links.csv")
COLUMN(std::string, setting, "", "name of the setting")
COLUMN(int, rank, "", "rank of the run whose best individual is shown, see best_genomes.csv")
COLUMN(std::string, stage, "", "growth, gait or path")
COLUMN(int, frame, "frame", "number of the frame in its stage, from 0")
COLUMN(double, x1, "cell", "first end of a link between two cells, horizontal")
COLUMN(double, y1, "cell", "first end, vertical")
COLUMN(double, x2, "cell", "second end, horizontal")
COLUMN(double, y2, "cell", "second end, vertical")
COLUMN(int, outline, "0 or 1", "1 for a link on the outline")
END_TABLE

TABLE(FramePathRow, "frame_paths.csv")
COLUMN(std::string, setting, "", "name of the setting")
COLUMN(int, rank, "", "rank of the run whose best individual is shown, see best_genomes.csv")
COLUMN(int, step, "step", "step of locomotion")
COLUMN(double, x, "cell", "centre of mass, horizontal")
COLUMN(double, y, "cell", "centre of mass, vertical")
END_TABLE

TABLE(FrameTerrainRow, "frame_terrain.csv")
COLUMN(std::string, setting, "", "name of the setting")
COLUMN(int, rank, "", "rank of the run whose best individual is shown, see best_genomes.csv")
COLUMN(std::string, kind, "", "ground: the line that bodies stand on, as far as the frames reach")
COLUMN(int, line, "", "number of the line among those of its kind, from 0")
COLUMN(int, point, "", "number of the point on its line, from 0")
COLUMN(double, x, "cell", "place of the point, horizontal")
COLUMN(double, y, "cell", "place of the point, vertical")
END_TABLE

TABLE(MorphologyRow, "morphologies.csv")
COLUMN(std::string, setting, "", "name of the setting")
COLUMN(int, rank, "", "rank of the run whose best individual is described, see best_genomes.csv")
COLUMN(std::int64_t, seed, "", "seed of that run")
COLUMN(double, fitness, "cell", "its fitness")
COLUMN(double, displacement, "cell", "distance that it moved")
COLUMN(int, cells, "cells", "its cells")
COLUMN(double, elongation, "1", "its length over width by its principal axes")
COLUMN(int, springs, "springs", "springs of its body")
COLUMN(int, triangles, "triangles", "triangles of its body")
END_TABLE

// ---- What planula prints ----

TABLE(ProgressRow, "progress.csv")
COLUMN(std::int64_t, written, "s", "seconds since 1970 when the row was written, by a process that runs below the folder")
COLUMN(int, level, "generations", "generations of the level that the process works at")
COLUMN(int, levels_left, "levels", "levels after it")
COLUMN(int, runs, "runs", "runs of the level")
COLUMN(int, runs_done, "runs", "those that have reached it")
COLUMN(std::int64_t, evaluations, "individuals", "evaluations by the process so far")
COLUMN(double, rate, "individuals/s", "evaluations per second")
COLUMN(double, seconds_left_level, "s", "time left for the level at this rate")
COLUMN(double, seconds_left, "s", "time left for all levels at this rate")
END_TABLE

TABLE(PaceRow, "pace.csv")
COLUMN(std::string, setting, "", "name of the setting that evolved")
COLUMN(int, first, "generation", "first of the generations that the row is about")
COLUMN(int, last, "generation", "last of them")
COLUMN(int, evaluations, "individuals", "individuals of these generations")
COLUMN(int, known, "individuals", "those of them whose life, or its locomotion, was known and not simulated")
COLUMN(double, cells, "cells", "mean cells of those that grew a viable body")
COLUMN(double, core_seconds, "s", "processor time of these generations, growth, settling, judgement and reproduction included")
COLUMN(double, rate, "individuals/s", "evaluations per core-second, those known not counted")
END_TABLE

#undef LIFE_POINT
#undef LIFE_COLUMN
#undef TABLE
#undef COLUMN
#undef END_TABLE

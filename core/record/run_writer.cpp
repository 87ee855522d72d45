// SPDX-License-Identifier: MIT
#include "record/run_writer.h"

#include "base/check.h"
#include "base/error.h"
#include "base/state.h"
#include "base/text.h"
#include "experiment/run_state.h"
#include "genome/genome_state.h"
#include "record/genome_table.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace planula {

namespace {

constexpr const char *script_file = "experiment.lua", *resolved_file = "resolved.lua";
constexpr std::array run_tables{GenerationRow::file_name, IndividualRow::file_name,     SpeciesRow::file_name,
                                ChampionRow::file_name,   ChampionGenomeRow::file_name, ArchiveRow::file_name,
                                GenomeRow::file_name,     PopulationRow::file_name};

std::string identity_of(const Spec &spec, std::uint64_t seed, const RunIdentity &identity) {
    return Hash().text(version()).text(spec.name).text(identity.resolved_text).number(seed).hex();
}

/// Takes the folder as a new run finds it: without a manifest first of all, and without anything older.
void clear(const std::filesystem::path &folder) {
    remove_file(folder / ManifestRow::file_name);
    for (const auto file : run_tables) remove_file(folder / file);
    remove_leftovers(folder);
}

const std::filesystem::path &made(const std::filesystem::path &folder) {
    make_folder(folder);
    return folder;
}

/// The species of every slot.
std::vector<int> species_of_slots(const Population &population) {
    std::vector<int> species(population.genomes.size(), -1);
    for (const Species &group : population.species)
        for (const int slot : group.members) species.at(slot) = group.id;
    return species;
}

/// The part of the displacement that the last quarter of locomotion made.
double late_share(const Life &life, const Parameters &parameters) {
    const double displacement = life.displacement();
    const std::size_t sample =
        static_cast<std::size_t>(parameters.locomotion_steps) * 3 / 4 / parameters.path_interval;
    if (displacement == 0 || sample >= life.path.size()) return 0;
    return length(life.end - life.path[sample]) / displacement;
}

ChampionRow champion_row(const Generation &g, const Parameters &parameters) {
    const Life &life = g.lives[g.best];
    const Genome &genome = g.population.genomes[g.best];
    const Vec2d moved = life.end - life.rest;
    return {.generation = g.number,
            .slot = g.best,
            .genome = genome.id,
            .fitness = g.evaluations[g.best].fitness,
            .cells = life.cells,
            .displacement = life.displacement(),
            .late_share = late_share(life, parameters),
            .late_actuation = life.late_actuation,
            .elongation = life.elongation,
            .x = moved.x,
            .y = moved.y,
            .springs = life.links,
            .triangles = life.triangles,
            .links = static_cast<int>(genome.links.size()),
            .hidden = genome.hidden(),
            .settle_steps = life.settle_steps};
}

IndividualRow individual_row(const Generation &g, int slot, int species) {
    const Life &life = g.lives[slot];
    const Genome &genome = g.population.genomes[slot];
    const Evaluation &evaluation = g.evaluations[slot];
    return {.generation = g.number,
            .slot = slot,
            .genome = genome.id,
            .mother = genome.mother,
            .father = genome.father,
            .origin = name_of(genome.origin),
            .species = species,
            .fitness = evaluation.fitness,
            .score = g.scores[slot],
            .penalty = evaluation.penalty,
            .outcome = name_of(life.outcome),
            .cells = life.cells,
            .births = life.births,
            .end_x = life.end.x,
            .end_y = life.end.y,
            .rest_x = life.rest.x,
            .rest_y = life.rest.y,
            .activity = life.activity,
            .elongation = life.elongation,
            .links = static_cast<int>(genome.links.size()),
            .hidden = genome.hidden()};
}

SpeciesRow species_row(const Generation &g, const Species &species) {
    SpeciesRow row{.generation = g.number,
                   .species = species.id,
                   .size = static_cast<int>(species.members.size()),
                   .age = species.age,
                   .stagnation = species.stagnation,
                   .mark = species.best ? 1 : 0,
                   .best_ever = species.best_ever,
                   .representative = species.representative.id};
    for (const int slot : species.members) {
        row.best_score = std::max(row.best_score, g.scores[slot]);
        row.mean_score += g.scores[slot];
    }
    row.mean_score /= static_cast<double>(row.size);
    return row;
}

/// Adds one life to the counts of its generation.
void count(const Life &life, int birth_limit, GenerationRow &row) {
    switch (life.outcome) {
    case Outcome::viable:
        ++row.viable;
        break;
    case Outcome::died_out:
        ++row.died_out;
        break;
    case Outcome::too_small:
        ++row.too_small;
        break;
    case Outcome::overgrown:
        ++row.overgrown;
        break;
    case Outcome::never_settled:
        ++row.never_settled;
        break;
    case Outcome::exploded:
        ++row.exploded;
        break;
    }
    row.overborn += life.births >= birth_limit;
}

GenerationRow generation_row(const Generation &g, int birth_limit) {
    GenerationRow row;
    row.generation = g.number;
    row.best_slot = g.best;
    row.best_fitness = g.evaluations[g.best].fitness;
    row.species = static_cast<int>(g.population.species.size());
    row.threshold = g.population.threshold;
    row.archive = static_cast<int>(g.search.archive().size());
    row.archive_threshold = g.search.archive_threshold();

    // Means are sums in slot order over the population's size.
    for (const Evaluation &evaluation : g.evaluations) {
        row.mean_fitness += evaluation.fitness;
        row.valid += evaluation.valid();
    }
    for (const Genome &genome : g.population.genomes) {
        row.mean_links += static_cast<double>(genome.links.size());
        row.mean_hidden += genome.hidden();
    }
    for (double *mean : {&row.mean_fitness, &row.mean_links, &row.mean_hidden})
        *mean /= static_cast<double>(g.lives.size());
    std::vector<ShapeDistribution> shapes;
    for (const Life &life : g.lives) {
        count(life, birth_limit, row);
        if (life.outcome == Outcome::viable) shapes.push_back(life.shape);
    }
    row.shape_diversity = shape_diversity(shapes);
    return row;
}

/// The mark that a checkpoint has for a table.
const JournalMark &mark_of(const FoundCheckpoint &found, std::string_view table) {
    try {
        return found.checkpoint->mark_of(table);
    } catch (const InputError &error) {
        throw InputError(found.path.string() + ": " + error.what());
    }
}

} // namespace

std::filesystem::path run_folder(const std::filesystem::path &runs, const std::string &setting,
                                 std::uint64_t seed) {
    CHECK(seed <= static_cast<std::uint64_t>(INT64_MAX), seed);
    constexpr std::size_t digits = 3;
    std::string number = to_text(static_cast<std::int64_t>(seed));
    if (number.size() < digits) number.insert(0, digits - number.size(), '0');
    return runs / setting / ("seed-" + number);
}

std::string results_sha256(const Manifest &manifest) {
    Hash results;
    for (const ManifestRow &row : manifest.rows())
        if (row.key.find(".csv") != std::string::npos) results.text(row.key).text(row.value);
    return results.hex();
}

/// The journals. A table stands here once; each() reaches them all, in the order of the manifest.
struct RunWriter::Tables {
    template <class MarkOf>
    Tables(const std::filesystem::path &folder, MarkOf &&mark)
        : generations(folder, mark(GenerationRow::file_name)),
          individuals(folder, mark(IndividualRow::file_name)), species(folder, mark(SpeciesRow::file_name)),
          champions(folder, mark(ChampionRow::file_name)),
          champion_genomes(folder, mark(ChampionGenomeRow::file_name)) {}

    template <class Visit> void each(Visit &&visit) {
        visit(GenerationRow::file_name, generations);
        visit(IndividualRow::file_name, individuals);
        visit(SpeciesRow::file_name, species);
        visit(ChampionRow::file_name, champions);
        visit(ChampionGenomeRow::file_name, champion_genomes);
    }

    TableJournal<GenerationRow> generations;
    TableJournal<IndividualRow> individuals;
    TableJournal<SpeciesRow> species;
    TableJournal<ChampionRow> champions;
    TableJournal<ChampionGenomeRow> champion_genomes;
};

RunWriter::RunWriter(const std::filesystem::path &folder, const Spec &spec, std::uint64_t seed,
                     const RunIdentity &identity, int interval)
    : folder_(made(folder)), lock_(folder_), parameters_(spec.parameters), setting_(spec.name),
      identity_(identity_of(spec, seed, identity)), script_sha256_(sha256(identity.script_text)), seed_(seed),
      interval_(interval) {
    CHECK(interval >= 1, interval);
    take_up(spec);
    files_.emplace_back(script_file, write_file(folder_ / script_file, identity.script_text));
    files_.emplace_back(resolved_file, write_file(folder_ / resolved_file, identity.resolved_text));
}

RunWriter::~RunWriter() = default;

void RunWriter::take_up(const Spec &spec) {
    const FoundCheckpoint found = find_checkpoint(folder_);
    damaged_ = found.damaged;
    const bool goes_on = found.checkpoint && found.checkpoint->identity == identity_;
    if (goes_on) {
        restore(spec, found);
        remove_file(folder_ / ManifestRow::file_name);
    } else
        clear(folder_);
    tables_ = std::make_unique<Tables>(
        folder_, [&](std::string_view table) { return goes_on ? &mark_of(found, table) : nullptr; });

    // A damaged checkpoint must not become the one that is kept beside a new one.
    for (const std::filesystem::path &path : damaged_) remove_file(path);
}

void RunWriter::restore(const Spec &spec, const FoundCheckpoint &found) {
    const Checkpoint &checkpoint = *found.checkpoint;
    try {
        StateReader state(checkpoint.state), champion(checkpoint.crown);
        state_ = load_run_state(spec, state);
        state.done();
        observed_ = checkpoint.generation;
        kept_ = observed_;
        if (state_->population.generation != observed_) state.refuse("it is of another generation");
        best_fitness_ = champion.finite();
        if (observed_ > 0) best_genome_ = load_genome(champion);
        champion.done();
        memory_ = checkpoint.memory;
    } catch (const InputError &error) {
        throw InputError(found.path.string() + ": " + error.what());
    }
}

void RunWriter::observe(const Generation &generation) {
    CHECK(generation.number == observed_, generation.number, observed_);
    const std::size_t size = generation.population.genomes.size();
    CHECK(generation.lives.size() == size && generation.evaluations.size() == size &&
          generation.scores.size() == size);
    tables_->generations.write(generation_row(generation, parameters_.birth_limit));
    write_individuals(generation);
    for (const Species &species : generation.population.species)
        tables_->species.write(species_row(generation, species));
    crown(generation);
    ++observed_;
    if (observed_ < parameters_.generations) return;
    write_archive(generation.search);
    last_genomes_ = generation.population.genomes;
}

void RunWriter::between(const RunState &state, const std::string &memory) {
    if (observed_ - kept_.value_or(0) >= interval_) keep(state, memory);
}

void RunWriter::keep(const RunState &state, const std::string &memory) {
    CHECK(state.population.generation == observed_, state.population.generation, observed_);
    if (kept_ == observed_) return;
    Checkpoint checkpoint{.identity = identity_,
                          .generation = observed_,
                          .generations = parameters_.generations,
                          .memory = memory};
    StateWriter saved, champion;
    save(state, saved);
    champion.real(best_fitness_);
    if (observed_ > 0) save(best_genome_, champion);
    checkpoint.state = saved.bytes();
    checkpoint.crown = champion.bytes();

    // The tables are on disk before the checkpoint that speaks of them.
    tables_->each([&](std::string_view table, auto &journal) {
        checkpoint.tables.emplace_back(table, journal.mark());
    });
    write_checkpoint(folder_, checkpoint);
    kept_ = observed_;
}

void RunWriter::write_individuals(const Generation &generation) {
    const std::vector<int> species = species_of_slots(generation.population);
    for (std::size_t slot = 0; slot < species.size(); ++slot)
        tables_->individuals.write(individual_row(generation, static_cast<int>(slot), species[slot]));
}

/// The archive after the last generation; a file for every search that has one.
void RunWriter::write_archive(const Search &search) {
    if (!search.keeps_archive()) return;
    archive_.emplace(folder_);
    for (const ArchiveEntry &entry : search.archive()) archive_->write(entry);
}

/// The best of the first generation, and everyone fitter than all before.
void RunWriter::crown(const Generation &generation) {
    const double fitness = generation.evaluations[generation.best].fitness;
    if (observed_ > 0 && fitness <= best_fitness_) return;
    best_fitness_ = fitness;
    best_genome_ = generation.population.genomes[generation.best];
    tables_->champions.write(champion_row(generation, parameters_));
    for (const auto &row : numbered_rows<ChampionGenomeRow>(generation.number, best_genome_))
        tables_->champion_genomes.write(row);
}

void RunWriter::finish() {
    CHECK(observed_ == parameters_.generations, observed_, parameters_.generations);
    tables_->each(
        [&](std::string_view table, auto &journal) { files_.emplace_back(table, journal.publish()); });
    if (archive_) files_.emplace_back(ArchiveRow::file_name, archive_->commit());
    files_.emplace_back(GenomeRow::file_name, write_table<GenomeRow>(folder_, genome_rows(best_genome_)));
    std::vector<PopulationRow> population;
    for (std::size_t slot = 0; slot < last_genomes_.size(); ++slot)
        for (auto &row : numbered_rows<PopulationRow>(static_cast<int>(slot), last_genomes_[slot]))
            population.push_back(std::move(row));
    files_.emplace_back(PopulationRow::file_name, write_table<PopulationRow>(folder_, population));

    // Only what is complete needs no journals any more.
    write_manifest();
    remove_leftovers(folder_);
}

void RunWriter::write_manifest() {
    Manifest manifest;
    manifest.add("version", std::string(version()));
    manifest.add("compiler", compiler());
    manifest.add("script_sha256", script_sha256_);
    manifest.add("identity", identity_);
    manifest.add("setting", setting_);
    manifest.add("seed", static_cast<std::int64_t>(seed_));
    manifest.add("generations", parameters_.generations);
    manifest.add("population", parameters_.population);
    manifest.add("evaluations", std::int64_t{parameters_.generations} * parameters_.population);
    for (const auto &[file, hash] : files_) manifest.add(file, hash);
    manifest.add("results_sha256", results_sha256(manifest));
    manifest.add("status", "complete");
    manifest.write(folder_);
}

void remove_leftovers(const std::filesystem::path &folder) {
    remove_checkpoints(folder);
    for (const auto file : run_tables) remove_file(journal_path(folder / file));
}

bool is_complete(const std::filesystem::path &folder, const Spec &spec, std::uint64_t seed,
                 const RunIdentity &identity) {
    try {
        const Manifest manifest(folder);
        return manifest.text("status") == "complete" &&
               manifest.text("identity") == identity_of(spec, seed, identity);
    } catch (const InputError &) {
        return false;
    }
}

} // namespace planula

// SPDX-License-Identifier: MIT
#include "record/run_tables.h"

#include "experiment/sample.h"
#include "tables/csv.h"
#include "tables/genome_table.h"
#include "tables/run_rows.h"

#include <algorithm>

namespace planula {

namespace {

template <class Row> std::string lines_of(const std::vector<Row> &rows) {
    std::string text;
    for (const Row &row : rows) text += line_of(row);
    return text;
}

/// A line of individuals.csv.gz, or its header, with further fields.
std::string with_fields(std::string line, const std::vector<std::string> &fields) {
    if (fields.empty()) return line;
    line.back() = ',';
    return line + to_line(fields);
}

/// The objectives of an individual; empty fields for one that is not valid.
std::vector<std::string> objective_fields(const Evaluation &evaluation, std::size_t stated) {
    std::vector<std::string> fields(stated);
    for (std::size_t i = 0; i < evaluation.objectives.size() && i < stated; ++i)
        fields[i] = to_field(evaluation.objectives[i]);
    return fields;
}

std::string individual_lines(const Generation &generation, const Spec &spec, std::uint64_t seed) {
    const std::vector<int> species = species_of_slots(generation.population);
    const int population = static_cast<int>(species.size());
    std::string text;
    for (int slot = 0; slot < population; ++slot)
        if (spec.record.full || is_in_sample(spec.record, seed, population, generation.number, slot))
            text += with_fields(
                line_of(individual_row(generation, slot, species[static_cast<std::size_t>(slot)])),
                objective_fields(generation.evaluations[static_cast<std::size_t>(slot)], spec.aims.stated()));
    return text;
}

std::string species_lines(const Generation &generation) {
    std::string text;
    for (const Species &species : generation.population.species)
        text += line_of(species_row(generation, species));
    return text;
}

/// The entries that the generation added, which are the archive's last.
std::string archive_lines(const Generation &generation) {
    const auto archive = generation.search.archive();
    auto first = archive.end();
    while (first != archive.begin() && (first - 1)->generation == generation.number) --first;
    std::string text;
    for (; first != archive.end(); ++first) text += archive_line(*first);
    return text;
}

/// The header of a table but the archive.
std::string header_of_file(std::string_view file, const Aims &aims) {
    std::string header;
    const auto offer = [&](std::string_view name, std::string &&line) {
        if (name == file) header = std::move(line);
    };
    offer(GenerationRow::file_name, header_line<GenerationRow>());
    offer(SizeRow::file_name, header_line<SizeRow>());
    offer(FitnessClassRow::file_name, header_line<FitnessClassRow>());
    offer(IndividualRow::file_name, with_fields(header_line<IndividualRow>(), aims.stated_titles()));
    offer(SpeciesRow::file_name, header_line<SpeciesRow>());
    offer(ChampionRow::file_name, header_line<ChampionRow>());
    offer(ChampionGenomeRow::file_name, header_line<ChampionGenomeRow>());
    offer(ChainRow::file_name, header_line<ChainRow>());
    return header;
}

/// The archive's header follows from its first entry.
std::string archive_header_for(const std::string &lines, const Aims &aims) {
    const std::string first = lines.substr(0, lines.find('\n'));
    constexpr std::size_t commas_before_behaviour = 3;
    return archive_header(static_cast<std::size_t>(std::count(first.begin(), first.end(), ',')) -
                              commas_before_behaviour - aims.stated(),
                          aims);
}

} // namespace

RowTexts row_texts(const Generation &generation, const Spec &spec, std::uint64_t seed,
                   bool has_new_champion) {
    RowTexts texts;
    const auto text = [&](std::string_view file) -> std::string & {
        const auto at = std::find(run_tables.begin(), run_tables.end(), file) - run_tables.begin();
        return texts.at(static_cast<std::size_t>(at));
    };
    text(GenerationRow::file_name) = line_of(generation_row(generation, spec.parameters));
    text(SizeRow::file_name) = lines_of(size_rows(generation));
    text(FitnessClassRow::file_name) = lines_of(fitness_class_rows(generation));
    text(IndividualRow::file_name) = individual_lines(generation, spec, seed);
    text(SpeciesRow::file_name) = species_lines(generation);
    if (has_new_champion) {
        text(ChampionRow::file_name) = line_of(champion_row(generation, spec.parameters));
        text(ChampionGenomeRow::file_name) = lines_of(numbered_rows<ChampionGenomeRow>(
            generation.number, generation.population.genomes[generation.best]));
    }
    text(ArchiveRow::file_name) = archive_lines(generation);
    return texts;
}

RunTables::RunTables(const std::filesystem::path &folder, bool with_archive, const StartOf &start_of,
                     const Aims &aims)
    : aims_(aims) {
    const auto open = [&](std::string_view file) {
        tables_.push_back({std::string(file), std::make_unique<Journal>(folder / file, start_of(file))});
        Journal &journal = *tables_.back().journal;
        if (journal.is_empty()) journal.write(header_of_file(file, aims_));
    };
    for (const std::string_view file : run_tables)
        if (file != ArchiveRow::file_name || with_archive) open(file);
    open(ChainRow::file_name);
}

void RunTables::write(const RowTexts &rows) {
    // All but the chain, which is the last.
    for (std::size_t i = 0; i + 1 < tables_.size(); ++i) {
        Journal &journal = *tables_[i].journal;
        if (journal.is_empty() && !rows[i].empty()) journal.write(archive_header_for(rows[i], aims_));
        journal.write(rows[i]);
    }
}

void RunTables::write_link(std::string_view line) { chain().journal->write(line); }

std::vector<std::pair<std::string, JournalMark>> RunTables::marks() {
    std::vector<std::pair<std::string, JournalMark>> marks;
    for (const Table &table : tables_) marks.emplace_back(table.file, table.journal->mark());
    return marks;
}

std::vector<std::pair<std::string, std::string>> RunTables::publish() {
    std::vector<std::pair<std::string, std::string>> hashes;
    for (const Table &table : tables_) {
        if (table.journal->is_empty()) table.journal->write(archive_header(2, aims_));
        hashes.emplace_back(table.file, table.journal->publish());
    }
    return hashes;
}

} // namespace planula

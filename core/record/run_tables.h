// SPDX-License-Identifier: MIT
// The tables of a run: what each generation adds to them, and the journals (storage/journal.h) in which they grow. They
// are listed here once, in the order in which the chain (record/chain.h) and the manifest have them. Every row has the
// number of its generation in its first column.
//
// Where an experiment states objectives, individuals.csv.gz ends with a column of each, and so does the archive.
//
// A run recorded as a sample (experiment/sample.h) has fewer rows in individuals.csv.gz and differs in nothing else.
#pragma once

#include "experiment/run.h"
#include "storage/journal.h"
#include "tables/archive_table.h"

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace planula {

/// Every table that a generation adds rows to; only searches with an archive have the last.
inline constexpr std::array run_tables{
    GenerationRow::file_name, SizeRow::file_name,     FitnessClassRow::file_name,   IndividualRow::file_name,
    SpeciesRow::file_name,    ChampionRow::file_name, ChampionGenomeRow::file_name, ArchiveRow::file_name};

/// What a generation adds to each table, as lines in the order of run_tables.
using RowTexts = std::array<std::string, run_tables.size()>;

/// `has_new_champion`: the generation's best is fitter than every individual before it in the run.
RowTexts row_texts(const Generation &generation, const Spec &spec, std::uint64_t seed, bool has_new_champion);

class RunTables {
  public:
    using StartOf = std::function<JournalStart(std::string_view file)>;
    /// Opens the journal of every table and of the chain; `start_of(file)` says where each begins. The aims are those of
    /// the run's search: they name columns.
    RunTables(const std::filesystem::path &folder, bool with_archive, const StartOf &start_of,
              const Aims &aims = {});

    void write(const RowTexts &rows);
    void write_link(std::string_view line);
    /// How far each journal is on disk now, by file.
    std::vector<std::pair<std::string, JournalMark>> marks();
    /// Puts every table under its name; the SHA-256 of each, by file.
    std::vector<std::pair<std::string, std::string>> publish();

  private:
    struct Table {
        std::string file;
        std::unique_ptr<Journal> journal;
    };
    Table &chain() { return tables_.back(); }

    Aims aims_;
    std::vector<Table> tables_; // as in run_tables, and the chain
};

} // namespace planula

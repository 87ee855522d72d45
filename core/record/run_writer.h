// SPDX-License-Identifier: MIT
// The directory of one run, <runs>/<setting>/seed-NNN/: the script, its resolved form, and the tables of
// record/columns.inl, written as the run goes on. The manifest comes last: only where it stands is the run
// complete, and it holds the hash of every file. Nothing in a run depends on the clock or the machine but the
// manifest's compiler row. Memory does not grow with the generations.
#pragma once

#include "experiment/run.h"
#include "record/archive_table.h"
#include "record/csv.h"
#include "record/manifest.h"
#include "record/output.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace planula {

/// What, beside the seed and the version of planula, decides the results of a run.
struct RunIdentity {
    std::string script_name, script_text;
    std::string resolved_text; // canonical text of the resolved setting, its judgement included
};

/// <runs>/<setting>/seed-NNN.
std::filesystem::path run_folder(const std::filesystem::path &runs, const std::string &setting,
                                 std::uint64_t seed);

/// The hash over the tables of a run, from the hash of each that its manifest states. What the script says
/// beside that does not enter.
std::string results_sha256(const Manifest &manifest);

class RunWriter {
  public:
    /// Makes the folder and takes it for this process; what an earlier run left there goes. Throws
    /// CreateError if that fails or another process writes there.
    RunWriter(const std::filesystem::path &folder, const Spec &spec, std::uint64_t seed,
              const RunIdentity &identity);

    /// Appends one generation; to be called once for each, in order. Throws IoError.
    void observe(const Generation &generation);
    /// After the last generation: puts every file under its name, the manifest last.
    void finish();

  private:
    void write_generation(const Generation &generation);
    void write_individuals(const Generation &generation);
    void write_archive(const Search &search);
    void crown(const Generation &generation);

    std::filesystem::path folder_;
    FolderLock lock_;
    Parameters parameters_;
    std::string setting_, identity_, script_sha256_;
    std::uint64_t seed_;
    std::vector<std::pair<std::string, std::string>> files_; // finished, with their hashes
    TableWriter<GenerationRow> generations_;
    TableWriter<IndividualRow> individuals_;
    TableWriter<ChampionRow> champions_;
    std::optional<ArchiveWriter> archive_;
    std::size_t archived_ = 0;
    int observed_ = 0;
    double best_fitness_ = 0;
    Genome best_genome_;
    std::vector<Genome> last_genomes_; // of the last generation
};

/// Whether the folder holds the finished run of this setting, seed, version and identity. A manifest that
/// cannot be read counts as none.
bool is_complete(const std::filesystem::path &folder, const Spec &spec, std::uint64_t seed,
                 const RunIdentity &identity);

} // namespace planula

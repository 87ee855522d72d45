// SPDX-License-Identifier: MIT
// The directory of one run, <runs>/<setting>/seed-NNN/: the script, its resolved form, and the tables of
// record/columns.inl, written as the run goes on. The manifest comes last: only where it stands is the run
// complete, and it holds the hash of every file. Nothing in a run depends on the clock or the machine but the
// manifest's compiler row. Memory does not grow with the generations.
//
// Until then the tables are journals (record/journal.h), and every few generations a checkpoint says where the
// run stands. A writer that finds one goes on there, and the finished files are the same to the byte.
#pragma once

#include "experiment/run.h"
#include "record/archive_table.h"
#include "record/checkpoint.h"
#include "record/journal.h"
#include "record/manifest.h"
#include "record/output.h"

#include <cstdint>
#include <filesystem>
#include <memory>
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
    static constexpr int usual_interval = 10;

    /// Makes the folder and takes it for this process. A checkpoint of this run is taken up; anything else that
    /// an earlier run left there goes. `interval`: generations between two checkpoints. Throws CreateError if
    /// another process writes there, and InputError, having changed nothing, for a checkpoint that makes no
    /// sense or a table that is not what the checkpoint says.
    RunWriter(const std::filesystem::path &folder, const Spec &spec, std::uint64_t seed,
              const RunIdentity &identity, int interval = usual_interval);
    ~RunWriter();

    /// The state to go on from; nothing if the run starts at its beginning. To be taken once.
    std::optional<RunState> take_state() { return std::move(state_); }
    /// What the judge gave to the checkpoint; empty at the beginning.
    const std::string &memory() const { return memory_; }
    /// The highest fitness of all generations so far; 0 before the first.
    double best_fitness() const { return best_fitness_; }
    /// Checkpoints that were damaged and passed over.
    const std::vector<std::filesystem::path> &damaged() const { return damaged_; }

    /// Appends one generation; to be called once for each, in order. Throws IoError.
    void observe(const Generation &generation);
    /// Between two generations: writes a checkpoint if it is time. `memory`: what the judge will want to know.
    void between(const RunState &state, const std::string &memory);
    /// Writes a checkpoint now, unless the last one says the same.
    void keep(const RunState &state, const std::string &memory);
    /// After the last generation: puts every file under its name, the manifest last.
    void finish();

  private:
    struct Tables;
    void take_up(const Spec &spec);
    void restore(const Spec &spec, const FoundCheckpoint &found);
    void write_individuals(const Generation &generation);
    void write_archive(const Search &search);
    void crown(const Generation &generation);
    void write_manifest();

    std::filesystem::path folder_;
    FolderLock lock_;
    Parameters parameters_;
    std::string setting_, identity_, script_sha256_;
    std::uint64_t seed_;
    int interval_;
    std::vector<std::filesystem::path> damaged_;
    std::optional<RunState> state_;
    std::string memory_;
    std::vector<std::pair<std::string, std::string>> files_; // finished, with their hashes
    std::unique_ptr<Tables> tables_;
    std::optional<ArchiveWriter> archive_;
    int observed_ = 0;        // generations
    std::optional<int> kept_; // those that the newest checkpoint knows of
    double best_fitness_ = 0;
    Genome best_genome_;
    std::vector<Genome> last_genomes_; // of the last generation
};

/// Removes what a process that was killed at the very end may have left in the folder of a complete run.
void remove_leftovers(const std::filesystem::path &folder);

/// Whether the folder holds the finished run of this setting, seed, version and identity. A manifest that
/// cannot be read counts as none.
bool is_complete(const std::filesystem::path &folder, const Spec &spec, std::uint64_t seed,
                 const RunIdentity &identity);

} // namespace planula

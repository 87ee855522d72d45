// SPDX-License-Identifier: MIT
// Writes a run to disk (record/run_folder.h). While it is unfinished its tables are journals (storage/journal.h),
// and every few generations a checkpoint says where it stands (record/kept_state.h). A writer that finds such a run
// resumes there (record/resume_point.h), one that finds a complete run which is too short makes it longer, and the
// results are the same to the byte as those of one process that was never stopped. Nothing in them depends on the clock
// or the machine but the manifest's row of the compiler. Memory does not grow with the generations.
#pragma once

#include "experiment/run.h"
#include "record/kept_state.h"
#include "record/run_folder.h"
#include "record/run_tables.h"
#include "storage/output.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace planula {

struct ResumePoint;

class RunWriter {
  public:
    static constexpr int usual_interval = 10;

    /// Makes the folder, holds it for this process, and finds out where the run stands. `interval`: generations between
    /// two checkpoints. Throws CreateError, having changed nothing, if the folder holds another run or is in use, and
    /// InputError, likewise, if the files there are not as the run left them.
    RunWriter(const std::filesystem::path &folder, const Spec &spec, std::uint64_t seed,
              const RunSources &sources, int interval = usual_interval);
    ~RunWriter();

    /// Whether the run has all generations that are asked for: there is nothing to do.
    bool is_complete() const { return generations_ == 0; }
    /// The generations that the run will have: those asked for, or one more than it has already if that is more.
    int generations() const { return generations_; }
    /// The state to resume from; nothing if the run starts at its beginning. To be taken once.
    std::optional<RunState> take_state() { return std::move(state_); }
    /// What the judge gave to the kept state; empty at the beginning.
    const std::string &memory() const { return memory_; }
    /// The highest fitness of all generations so far; 0 before the first.
    double best_fitness() const { return best_fitness_; }
    /// Kept states that were damaged and passed over.
    const std::vector<std::filesystem::path> &damaged() const { return damaged_; }

    /// Appends one generation; to be called once for each, in order. Throws IoError.
    void observe(const Generation &generation);
    /// To be called before each generation, the first one included: keeps the state if that is due. `memory`: what the
    /// judge must know to continue (see memory()).
    void before_generation(const RunState &state, const std::string &memory);
    /// Writes a checkpoint now, unless the last one says the same.
    void checkpoint(const RunState &state, const std::string &memory);
    /// After the last generation: puts every table under its name, the manifest last.
    void finish();

  private:
    void resume(const ResumePoint &point);
    void restore(const ResumePoint &point);
    KeptState kept_state(const RunState &state, const std::string &memory);

    std::filesystem::path folder_;
    Spec spec_;
    std::uint64_t seed_;
    int generations_ = 0, interval_;
    std::optional<FolderLock> lock_;
    std::string identity_, link_; // Identity::sha256(), and the chain's last link
    std::vector<std::filesystem::path> damaged_;
    std::optional<RunState> state_;
    std::string memory_;
    std::unique_ptr<RunTables> tables_;
    int observed_ = 0;        // generations
    std::optional<int> kept_; // those that the newest checkpoint knows of
    double best_fitness_ = 0;
};

} // namespace planula

// SPDX-License-Identifier: MIT
#include "record/resume_point.h"

#include "base/error.h"
#include "base/state.h"
#include "experiment/run_state.h"
#include "record/run_folder.h"
#include "tables/archive_table.h"

namespace planula {

namespace {

using From = JournalStart::From;

/// Calls action(); an InputError that it throws is thrown with the file's name before its message.
template <class Action> auto naming(const std::filesystem::path &file, Action &&action) {
    try {
        return action();
    } catch (const InputError &error) {
        throw InputError(file.string() + ": " + error.what());
    }
}

/// The newest kept state of one run, found file by file.
class Finder {
  public:
    Finder(const std::filesystem::path &folder, const std::string &identity)
        : folder_(folder), identity_(identity) {}

    ResumePoint find(int complete) {
        if (!find_in_states(find_checkpoint(), complete) && !point_.kept &&
            (complete > 0 || !point_.damaged.empty()))
            refuse(complete);
        if (point_.tables == From::journal && !has_journals(folder_))
            throw InputError(
                folder_.string() +
                " has states of a complete run and no manifest.csv: the folder is not whole. Nothing was "
                "changed. Bring the file back, or move the folder away to begin the run again.");
        return std::move(point_);
    }

  private:
    /// The generation of the newest checkpoint that can be read, which becomes the point; -1 without one.
    int find_checkpoint() {
        for (const std::filesystem::path &path : checkpoints(folder_))
            if (take(path, From::journal)) return point_.kept->generation;
        return -1;
    }

    /// Takes a state of states/ that is newer than the checkpoint.
    bool find_in_states(int checkpoint, int complete) {
        std::vector<int> generations = kept_generations(folder_);
        for (; !generations.empty() && generations.back() > checkpoint; generations.pop_back()) {
            const int generation = generations.back();
            // Beyond what is published there are the journals of a process that was making the run longer.
            if (take(state_path(folder_, generation), generation <= complete ? From::target : From::journal))
                return true;
        }
        return false;
    }

    /// Makes a kept state the point, unless it is damaged.
    bool take(const std::filesystem::path &path, From tables) {
        std::optional<KeptState> kept = read_state(path);
        if (!kept) {
            point_.damaged.push_back(path);
            return false;
        }
        if (kept->identity != identity_)
            throw InputError(path.string() + ": it is a state of another run. Nothing was changed.");
        point_.kept = std::move(kept);
        point_.file = path;
        point_.tables = tables;
        return true;
    }

    [[noreturn]] void refuse(int complete) const {
        const auto &damaged = point_.damaged;
        throw InputError(folder_.string() + ": no state of the run can be read" +
                         (damaged.empty() ? "" : ", " + damaged.front().string() + " is damaged") +
                         ": it cannot " + (complete > 0 ? "become longer" : "resume") +
                         ". Nothing was changed. Move the folder away to begin the run again.");
    }

    const std::filesystem::path &folder_;
    const std::string &identity_;
    ResumePoint point_;
};

} // namespace

JournalStart ResumePoint::start_of(std::string_view table) const {
    if (!kept) return {};
    return naming(file, [&] { return JournalStart{tables, kept->mark_of(table)}; });
}

RunState ResumePoint::load(const std::filesystem::path &folder, const Spec &spec) const {
    const auto entries = static_cast<std::size_t>(kept->archive);
    const auto archive =
        tables == From::target ? read_archive(folder, entries) : read_archive_journal(folder, entries);
    return naming(file, [&] {
        StateReader reader(kept->state);
        RunState state = load_run_state(spec, archive, reader);
        reader.done();
        if (state.population.generation != kept->generation) reader.refuse("it is of another generation");
        return state;
    });
}

ResumePoint find_resume_point(const std::filesystem::path &folder, const std::string &identity,
                              int complete) {
    return Finder(folder, identity).find(complete);
}

bool is_becoming_longer(const std::filesystem::path &folder, int complete) {
    const std::vector<int> generations = kept_generations(folder);
    if (!generations.empty() && generations.back() >= complete) return true;
    for (const std::filesystem::path &path : checkpoints(folder)) {
        const std::optional<KeptState> kept = read_state(path);
        if (!kept || kept->generation >= complete) return true;
    }
    return false;
}

} // namespace planula

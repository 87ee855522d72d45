// SPDX-License-Identifier: MIT
#include "analysis/audit.h"
#include "base/error.h"
#include "base/text.h"
#include "program/commands.h"
#include "program/device_choice.h"
#include "program/interrupt.h"
#include "program/progress.h"
#include "record/run_folder.h"

#include <algorithm>
#include <chrono>
#include <ctime>
#include <ostream>
#include <set>

#include <unistd.h>

namespace planula {

namespace {

constexpr Option options[] = {
    {"share", "PERCENT",
     "simulate at least this share of all generations again (default: 1; 0: only compare the files)"},
    {"minutes", "M", "begin no further stretch after M minutes (default: no limit)"},
    {"draw", "N", "seed that selects the stretches (default: a new one each time, which is printed)"},
    threads_option,
    lanes_option,
    device_option,
};

/// A stretch of one of the runs.
struct Task {
    const RecordedRun *run;
    Stretch stretch;
};

class VerifyCommand {
  public:
    VerifyCommand(const Arguments &arguments, Console &console)
        : console_(console), device_(arguments), folder_(arguments.operands.at(0)),
          share_(share_of(arguments)), minutes_(arguments.whole("minutes", 1, 0)),
          threads_(threads_of(arguments)), draw_(draw_of(arguments)) {
        use_lanes_of(arguments);
    }

    int run() {
        find_runs();
        compare_files();
        simulate();
        tell();
        if (failures_.empty()) return 0;
        throw InputError("verify: " + counted(failed_.size(), "run") +
                         (failed_.size() == 1 ? " differs from its record" : " differ from their record"));
    }

  private:
    static double share_of(const Arguments &arguments) {
        const std::string words = arguments.text("share", "1");
        const auto share = parse_double(words);
        if (!share || !(*share >= 0 && *share <= 100))
            throw UsageError("--share takes a percentage, a number from 0 to 100, not '" + words + "'");
        return *share / 100;
    }

    // The draw must not be predictable: a run must not be altered only where it will not be simulated.
    static std::uint64_t draw_of(const Arguments &arguments) {
        if (arguments.has("draw")) return static_cast<std::uint64_t>(arguments.whole("draw", 0, 0));
        const auto now = std::chrono::system_clock::now().time_since_epoch();
        const auto ticks = std::chrono::duration_cast<std::chrono::microseconds>(now).count();
        return static_cast<std::uint64_t>(ticks + ::getpid()) % 1'000'000'000;
    }

    // The run in the folder, or all runs below it.
    void find_runs() {
        for (const std::filesystem::path &folder : folders_with_runs(folder_)) {
            if (!std::filesystem::exists(folder / ManifestRow::file_name)) {
                console_.err << folder.string() << ": not complete, not checked\n";
                ++unchecked_;
                continue;
            }
            attempt(folder, [&] { runs_.push_back(open_run(folder)); });
        }
        if (runs_.empty() && failures_.empty())
            throw InputError(folder_.string() + ": there is no complete run");
    }

    void compare_files() {
        std::vector<RecordedRun> sound;
        for (RecordedRun &run : runs_) {
            const bool holds = attempt(run.folder, [&] { check_consistency(run); });
            ++checked_;
            generations_ += run.generations;
            absent_states_ += absent_states(run.folder, run.manifest);
            if (holds) sound.push_back(std::move(run));
        }
        runs_ = std::move(sound);
    }

    std::vector<Task> tasks() const {
        std::vector<Task> all;
        for (const RecordedRun &run : runs_)
            for (const Stretch &stretch : stretches(run)) all.push_back({&run, stretch});
        std::vector<Task> drawn;
        for (const int place : drawn_order(static_cast<int>(all.size()), draw_))
            drawn.push_back(all[static_cast<std::size_t>(place)]);
        return drawn;
    }

    void simulate() {
        const std::vector<Task> drawn = tasks();
        const double wanted = share_ * generations_;
        const Interrupt interrupt;
        const auto began = std::chrono::steady_clock::now();
        for (const Task &task : drawn) {
            const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - began;
            if (simulated_ >= wanted || (minutes_ > 0 && passed.count() >= 60.0 * minutes_)) break;
            console_.err << task.run->folder.string() << ": generations " << task.stretch.first << " to "
                         << task.stretch.last << " …" << std::endl;
            // A stretch that could not be simulated to its end, or differs, tells nothing of the others.
            attempt(task.run->folder, [&] {
                const SettingForRun own = recorded_setting(*task.run);
                recompute(*task.run, own.spec, task.stretch, threads_, [&] { return interrupt.requested(); });
                simulated_ += task.stretch.length();
            });
        }
    }

    void tell() const {
        std::ostream &out = console_.out;
        for (const std::string &line : failures_) out << line << '\n';
        const double share = generations_ > 0 ? static_cast<double>(simulated_) / generations_ : 0;
        out << "verify: " << counted(checked_, "run") << " of " << counted(generations_, "generation")
            << " in all: their files " << (failures_.empty() ? "agree" : "do not all agree") << "; "
            << simulated_ << " generations simulated again as recorded (" << to_fixed(100 * share, 1)
            << " %, --draw " << draw_ << ").\n";
        if (unchecked_ > 0) out << "Not complete and not checked: " << counted(unchecked_, "run") << ".\n";
        if (absent_states_ > 0)
            out << "Kept states that were removed: " << absent_states_
                << ". The stretches around them are longer; no result depends on them.\n";
        out << "The probability that one altered generation with consistent hashes was not found is "
            << to_fixed(1 - share, 3) << ".\n";
    }

    // Whether an action on a run ends without an error in the data, whose message is kept.
    template <class Action> bool attempt(const std::filesystem::path &run, Action &&action) {
        try {
            action();
            return true;
        } catch (const InputError &error) {
            failures_.push_back(error.what());
            failed_.insert(run);
            return false;
        }
    }

    Console &console_;
    const DeviceChoice device_;
    const std::filesystem::path folder_;
    const double share_;
    const int minutes_, threads_;
    const std::uint64_t draw_;
    std::vector<RecordedRun> runs_;
    std::vector<std::string> failures_;
    std::set<std::filesystem::path> failed_;
    int checked_ = 0, unchecked_ = 0, generations_ = 0, simulated_ = 0, absent_states_ = 0;
};

int verify(const Arguments &arguments, Console &console) { return VerifyCommand(arguments, console).run(); }

} // namespace

const Command &verify_command() {
    static const Command command{
        "verify",
        "DIR",
        "checks that recorded runs are unaltered and can be repeated",
        R"(DIR is the folder of a run, or one with several runs below it. Compares all files of each run with one another, by their
hashes and by the chain of hashes over all generations, and names the first generation that differs. Then simulates
stretches of generations again, drawn at random, from the kept states and the scripts in the folder, and compares every
hash. A stretch goes from one kept state to the next. Files in states/ before the last may be removed to save space: the
stretches become longer.

Reports with what probability one altered generation would not have been found. Exit code 65 if anything differs.)",
        options,
        verify};
    return command;
}

} // namespace planula

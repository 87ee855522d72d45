// SPDX-License-Identifier: MIT
#include "program/forecast.h"

#include "base/text.h"
#include "program/commands.h"
#include "program/cost.h"
#include "program/interrupt.h"
#include "program/progress.h"

#include <algorithm>
#include <iomanip>
#include <ostream>

namespace planula {

namespace {

constexpr int measured_generations = 11; // generation 0, which is unlike the others, and ten more
constexpr double megabyte = 1e6;

class Forecast {
  public:
    Forecast(const Arguments &arguments, Console &console)
        : console_(console), experiment_(experiment_to_run(arguments, console)),
          threads_(threads_of(arguments)), cores_(arguments.whole("cores", 1, 0)),
          runs_(runs_of(arguments, experiment_)) {
        use_lanes_of(arguments);
        for (const PlannedRun &run : runs_)
            if (std::find(settings_.begin(), settings_.end(), run.setting) == settings_.end())
                settings_.push_back(run.setting);
    }

    int run() {
        measure_all();
        console_.out << "forecast of " << experiment_.name << ": " << counted(runs_.size(), "run") << ", "
                     << evaluations_text(evaluations_) << '\n';
        tell_settings();
        tell_whole();
        return 0;
    }

  private:
    void measure_all() {
        const Interrupt interrupt;
        Workload evaluations;
        for (const std::size_t i : settings_) {
            const Parameters &p = experiment_.settings[i].parameters;
            evaluations[experiment_.settings[i].name] =
                std::int64_t{std::min(measured_generations, p.design.generations)} * p.neat.population;
        }
        Progress progress(console_.err, console_.terminal, evaluations);
        for (const std::size_t i : settings_) {
            const SettingForRun own = setting_for_run(experiment_, i);
            const Progress::Open open(progress);
            const auto show = [&](const Generation &generation) {
                GenerationReport report = report_of(own.spec, own.spec.name, generation,
                                                    generation.evaluations[generation.best].fitness);
                report.generations = std::min(measured_generations, report.generations);
                progress.generation(report);
            };
            measured_.push_back(measure(
                own.spec, runs_.front().seed, measured_generations, threads_,
                [&] { return interrupt.requested(); }, show));
            costs_.push_back(cost_of(own.spec, measured_.back()));
        }
        for (const PlannedRun &run : runs_) {
            const Parameters &p = experiment_.settings[run.setting].parameters;
            evaluations_ += static_cast<double>(p.neat.population) * p.design.generations;
        }
    }

    std::string measured_words() const {
        int last = 0;
        for (const std::size_t i : settings_)
            last = std::max(
                last,
                std::min(measured_generations, experiment_.settings[i].parameters.design.generations) - 1);
        return last == 0 ? "generation 0" : "generations 1 to " + to_text(last);
    }

    void tell_settings() const {
        std::ostream &out = console_.out;
        out << "measured here: " << measured_words() << " of each setting, seed " << runs_.front().seed
            << "\n\n"
            << std::left << std::setw(24) << "setting" << std::right << std::setw(18) << "evaluations/core-s"
            << std::setw(18) << "core-hours a run" << std::setw(16) << "tables, MB" << std::setw(16)
            << "states, MB" << '\n';
        for (std::size_t i = 0; i < settings_.size(); ++i)
            out << std::left << std::setw(24) << experiment_.settings[settings_[i]].name << std::right
                << std::setw(18)
                << to_fixed(static_cast<double>(measured_[i].evaluations) / measured_[i].seconds, 0)
                << std::setw(18) << to_fixed(costs_[i].core_seconds / 3600, 3) << std::setw(16)
                << to_fixed(costs_[i].table_bytes / megabyte, 2) << std::setw(16)
                << to_fixed(costs_[i].state_bytes / megabyte, 2) << '\n';
    }

    void tell_whole() const {
        double seconds = 0, bytes = 0, longest = 0, journals = 0, archive = 0;
        for (const PlannedRun &run : runs_) {
            const auto at = std::find(settings_.begin(), settings_.end(), run.setting) - settings_.begin();
            const Cost &cost = costs_[static_cast<std::size_t>(at)];
            seconds += cost.core_seconds;
            bytes += cost.table_bytes + cost.state_bytes;
            longest = std::max(longest, cost.core_seconds);
            journals = std::max(journals, cost.journal_bytes);
            archive = std::max(archive, cost.archive_bytes);
        }
        std::ostream &out = console_.out;
        const auto on = [&](int cores) { return long_time(seconds / cores); };
        out << "\ntime:   " << to_fixed(seconds / 3600, 2) << " core-hours; " << on(threads_) << " on the "
            << threads_ << " threads of this command";
        if (cores_ > 0)
            out << "; " << long_time(std::max(seconds / cores_, longest)) << " on " << cores_
                << " cores of a cluster, one run on each";
        const double at_once = std::min<double>(threads_, static_cast<double>(runs_.size()));
        out << "\ndisk:   " << size_text(bytes) << " when all is complete, and up to "
            << size_text(journals * at_once) << " more while runs are unfinished"
            << "\nmemory: " << to_fixed(peak_megabytes() + archive * at_once / megabyte, 0) << " MB\n"
            << "\nThis assumes that later generations cost as much as those measured. Bodies change as they "
               "evolve: "
               "in runs\nof 100 generations of the paper's settings some became 1.7 times slower after "
               "generation 10, "
               "others not at all.\n";
    }

    Console &console_;
    const Experiment experiment_;
    const int threads_, cores_;
    const std::vector<PlannedRun> runs_;
    std::vector<std::size_t> settings_; // those of the runs
    std::vector<Measured> measured_;
    std::vector<Cost> costs_;
    double evaluations_ = 0;
};

} // namespace

int forecast(const Arguments &arguments, Console &console) { return Forecast(arguments, console).run(); }

} // namespace planula

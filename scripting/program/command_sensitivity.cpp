// SPDX-License-Identifier: MIT
#include "analysis/sensitivity.h"
#include "base/error.h"
#include "base/text.h"
#include "experiment/world_numbers.h"
#include "program/commands.h"
#include "tables/csv.h"

#include <optional>
#include <ostream>

namespace planula {

namespace {

constexpr Option options[] = {
    {"runs", "DIR", "folder of the runs (default: build/runs/<experiment>)"},
    {"out", "DIR", "folder for sensitivity.csv (default: build/data)"},
    chosen_seeds_option,
    {"parameter", "NAME", "vary only this parameter; may be repeated", true},
    generations_option,
    population_option,
    set_option,
    threads_option,
};

class SensitivityCommand {
  public:
    SensitivityCommand(const Arguments &arguments, Console &console)
        : arguments_(arguments), console_(console), experiment_(experiment_of(arguments, console)),
          threads_(threads_of(arguments)) {}

    int run() {
        const SensitivityPlan &plan = experiment_.sensitivity;
        std::vector<std::string> names = arguments_.all("parameter");
        for (const std::string &name : names) parameter_row(name);
        if (names.empty()) names = plan.parameters;
        if (names.empty())
            for (const std::string_view name : assumed_parameters()) names.emplace_back(name);
        const std::string out = arguments_.text("out", "build/data");
        const FolderLock held = hold_for_tables(out);
        samples_ = draw_samples(experiment_.settings, choice_of(arguments_, experiment_, console_),
                                plan.sample, threads_);
        for (std::size_t i = 0; i < names.size(); ++i) {
            console_.err << "sensitivity: " << names[i] << ", " << i + 1 << " of " << names.size() << '\n';
            for (const double factor : plan.factors) vary_all(parameter_row(names[i]), factor);
        }
        write_table<SensitivityRow>(out, rows_);
        console_.out << out << '\n';
        return 0;
    }

  private:
    /// One row for each setting that the parameter concerns.
    void vary_all(const ParameterRow &row, double factor) {
        for (const Sample &sample : samples_) {
            if (!concerns(row, *sample.spec)) continue;
            const double standard = used(row, *sample.spec), value = varied(row, standard, factor);
            if (value == standard) continue;
            if (const auto changed = with(*sample.spec, row, value))
                rows_.push_back(vary(sample, *changed, row, threads_));
        }
    }

    /// The setting with this value; nothing if it breaks a rule.
    std::optional<Spec> with(const Spec &setting, const ParameterRow &row, double value) {
        if (const WorldNumber *number = stated_instead_of(row.name, setting)) {
            Spec changed = setting;
            number->in(changed) = value;
            return changed;
        }
        // The script is read again, as its environments may take numbers from the parameter.
        if (!is_possible(setting, row.name, value)) return std::nullopt;
        return *experiment_of(arguments_, console_, {{std::string(row.name), value}}).find(setting.name);
    }

    /// Whether the value is consistent with those of the other parameters; if not, reports once that it is skipped.
    bool is_possible(const Spec &setting, std::string_view name, double value) {
        Parameters parameters = setting.parameters;
        set_parameter(parameters, name, value);
        try {
            check_consistency(parameters);
            return true;
        } catch (const InputError &error) {
            const std::string report =
                std::string(name) + " = " + to_text(value) + " is skipped: " + error.what();
            if (report != reported_) console_.err << report << '\n';
            reported_ = report;
            return false;
        }
    }

    const Arguments &arguments_;
    Console &console_;
    const Experiment experiment_;
    const int threads_;
    std::vector<Sample> samples_;
    std::vector<SensitivityRow> rows_;
    std::string reported_; // the last value that was skipped, and why
};

int call_sensitivity(const Arguments &arguments, Console &console) {
    return SensitivityCommand(arguments, console).run();
}

} // namespace

const Command &sensitivity_command() {
    static const Command command{
        "sensitivity",
        "FILE.lua",
        "simulates evolved individuals with each assumed value halved and doubled",
        R"(Draws individuals from the last generations of all complete runs in the folder --runs, simulates them with one parameter
changed at a time, and writes sensitivity.csv: how their displacement and viability change.

The experiment may state how many individuals of each setting, which factors and which parameters:
sensitivity = { sample = 200, factors = { 0.5, 2 }, parameters = { "gravity" } }.
Otherwise they are 200 individuals, these factors, and every parameter whose value the paper does not give.)",
        options,
        call_sensitivity};
    return command;
}

} // namespace planula

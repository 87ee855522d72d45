// SPDX-License-Identifier: MIT
// What settings reached, beside each other: of one script or of several.
#include "analysis/comparison.h"
#include "analysis/comparison_picture.h"
#include "analysis/comparison_text.h"
#include "base/error.h"
#include "base/text.h"
#include "program/commands.h"
#include "record/run_folder.h"
#include "storage/output.h"
#include "tables/csv.h"

#include <algorithm>
#include <array>
#include <ostream>
#include <set>

namespace planula {

namespace {

constexpr Option options[] = {
    {"measure", "NAME",
     "compare by this number of runs.csv or generations.csv; may be repeated (default: best_fitness)", true},
    {"generations", "N",
     "compare the runs as they were after N generations (default: as many as all runs have)"},
    {"against", "SETTING", "compare all others with this setting (default: each with each)"},
    {"unpaired", "", "compare runs of the same seed as independent samples too"},
    {"runs", "DIR",
     "folder of the runs; given once for all scripts, or once for each (default: build/runs/<experiment>)",
     true},
    chosen_seeds_option,
    population_option,
    set_option,
    {"out", "DIR", "write tables and a picture of each measure to DIR"},
    {"log", "", "with --out: logarithmic pictures"},
};

/// What an operand names: a script, and settings of it, or all.
struct Named {
    std::string word, script;
    std::vector<std::string> settings;
};

Named named(const std::string &word) {
    Named result{word, word, {}};
    constexpr std::string_view ending = ".lua:";
    const std::size_t at = word.rfind(ending);
    if (at == word.npos) return result;
    result.script = word.substr(0, at + ending.size() - 1);
    for (std::size_t from = at + ending.size(); from <= word.size();) {
        const std::size_t end = std::min(word.find(',', from), word.size());
        result.settings.push_back(word.substr(from, end - from));
        from = end + 1;
    }
    return result;
}

/// The scripts of a command line, loaded; contenders point into the experiments.
struct Field {
    std::vector<Named> names;
    std::vector<Experiment> experiments;
    std::vector<Contender> contenders;
};

/// The settings of an experiment that an operand names.
std::vector<const Spec *> settings_of(const Named &named, const Experiment &experiment) {
    std::vector<const Spec *> chosen;
    std::vector<std::string> names;
    for (const Spec &setting : experiment.settings) names.push_back(setting.name);
    for (const std::string &name : named.settings.empty() ? names : named.settings) {
        const Spec *setting = experiment.find(name);
        if (!setting)
            throw UsageError(named.word + ": " + named.script + " has no setting '" + name + "'" +
                             suggestion(name, names) + "\nits settings are " + list_of(names));
        chosen.push_back(setting);
    }
    return chosen;
}

/// The shortest names by which no two settings are called the same.
void name_contenders(const std::vector<std::array<std::string, 3>> &choices,
                     std::vector<Contender> &contenders) {
    for (std::size_t way = 0; way < choices.front().size(); ++way) {
        std::set<std::string> different;
        for (std::size_t i = 0; i < contenders.size(); ++i) {
            contenders[i].name = choices[i][way];
            different.insert(contenders[i].name);
        }
        if (different.size() == contenders.size()) return;
    }
    std::set<std::string> seen;
    for (const Contender &contender : contenders)
        if (!seen.insert(contender.name).second) throw UsageError(contender.name + " is named twice");
}

Field field_of(const Arguments &arguments, Console &console) {
    Field field;
    for (const std::string &word : arguments.operands) field.names.push_back(named(word));
    const std::vector<std::string> folders = arguments.all("runs");
    if (folders.size() > 1 && folders.size() != field.names.size())
        throw UsageError("--runs is given once, or once for each of the " +
                         to_text(static_cast<std::int64_t>(field.names.size())) +
                         " scripts in their order, not " +
                         to_text(static_cast<std::int64_t>(folders.size())) + " times");

    field.experiments.reserve(field.names.size()); // contenders point into them
    std::vector<std::array<std::string, 3>> names;
    for (std::size_t i = 0; i < field.names.size(); ++i) {
        Arguments own = arguments;
        own.operands = {field.names[i].script};
        const Experiment &experiment = field.experiments.emplace_back(experiment_of(own, console));
        RunChoice choice = choice_of(own, experiment, console);
        if (folders.size() > 1) choice.folder = folders[i];
        for (const Spec *setting : settings_of(field.names[i], experiment)) {
            field.contenders.push_back({"", setting, choice});
            names.push_back({setting->name, experiment.name + ":" + setting->name,
                             field.names[i].script + ":" + setting->name});
        }
    }
    if (field.contenders.size() < 2)
        throw UsageError("planula compare needs two settings or more; " + field.names.front().word +
                         " has one, " + field.contenders.front().spec->name + ": name another script");
    name_contenders(names, field.contenders);
    return field;
}

ComparisonPlan plan_of(const Arguments &arguments, const Field &field) {
    ComparisonPlan plan;
    try {
        for (const std::string &name : arguments.all("measure"))
            plan.measures.push_back(measure_called(name));
        if (plan.measures.empty()) plan.measures.push_back(measure_called("best_fitness"));
    } catch (const InputError &error) {
        throw UsageError(std::string("--measure: ") + error.what());
    }
    for (std::size_t i = 0; i < plan.measures.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if (plan.measures[i].name == plan.measures[j].name)
                throw UsageError("--measure " + plan.measures[i].name + " is given twice");

    std::vector<std::string> names;
    for (const Contender &contender : field.contenders) names.push_back(contender.name);
    plan.against = arguments.text("against");
    if (arguments.has("against") && std::find(names.begin(), names.end(), plan.against) == names.end())
        throw UsageError("--against " + plan.against + ": no such setting is compared" +
                         suggestion(plan.against, names) + "\nthese are: " + list_of(names));

    const Experiment &first = field.experiments.front();
    const StatisticsParameters &statistics = first.settings.front().parameters.statistics;
    plan.generations = arguments.whole("generations", 1, 0);
    plan.by_seed = !arguments.has("unpaired");
    plan.confidence = statistics.confidence, plan.resamples = statistics.bootstrap_resamples;
    plan.interval_runs = first.analysis.interval_runs;
    plan.direction_distance = first.analysis.direction_distance;
    return plan;
}

void write(const std::filesystem::path &out, const Comparisons &comparisons, const ComparisonPlan &plan,
           bool logarithmic, Console &console) {
    std::vector<std::pair<std::filesystem::path, std::string>> pictures;
    for (const Measure &measure : plan.measures)
        pictures.emplace_back(out / (measure.name + ".svg"), svg_of(comparisons, measure, logarithmic));
    const FolderLock held = hold_for_tables(out);
    write_table<ComparedRunRow>(out, comparisons.runs);
    write_table<ComparedSettingRow>(out, comparisons.settings);
    write_table<ComparisonRow>(out, comparisons.rows);
    for (const auto &[path, text] : pictures) write_file(path, text);
    console.err << "tables and pictures: " << out.string() << '\n';
}

int compare_settings(const Arguments &arguments, Console &console) {
    if (arguments.has("log") && !arguments.has("out"))
        throw UsageError("--log is about the pictures that --out writes; give --out DIR too");
    const Field field = field_of(arguments, console);
    const ComparisonPlan plan = plan_of(arguments, field);
    const Comparisons comparisons = compare(field.contenders, plan);
    for (const ComparisonRow &row : comparisons.rows)
        console.out << lines_of(row, comparisons, plan) << '\n'
                    << sentence_of(row, comparisons, plan) << "\n\n";
    if (arguments.has("out")) write(arguments.text("out"), comparisons, plan, arguments.has("log"), console);
    return 0;
}

} // namespace

const Command &compare_command() {
    static const Command command{
        "compare",
        "SCRIPT.lua...",
        "compares what settings reached: medians, difference, effect size, p and a sentence",
        R"(Compares each setting of the scripts with each other; SCRIPT.lua:SETTING,SETTING... takes only these of a script. The
runs are those that the scripts state, as for planula reduce, all after the same number of generations.

If every seed of one setting is also one of the other, runs of the same seed are pairs: Wilcoxon's signed-rank test.
Otherwise, or with --unpaired, the runs are independent samples: Wilcoxon's rank-sum test. p is two-sided, exact below
50 runs, and corrected after Holm over all comparisons. The difference is Hodges and Lehmann's, with the interval that
belongs to the test. A12 is the probability that a run of the first setting has a larger value than one of the second;
its interval is a BCa bootstrap, of ten runs at least. Where too few runs cannot be significant, that is said instead of
p.

Each comparison ends with a sentence for a paper. planula columns explains the measures, and the tables that --out
writes, under runs.csv, generations.csv, comparisons.csv, compared_runs.csv and compared_settings.csv.)",
        options,
        compare_settings};
    return command;
}

} // namespace planula

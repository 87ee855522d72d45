// SPDX-License-Identifier: MIT
#include "base/text.h"
#include "program/commands.h"

#include <ostream>

namespace planula {

namespace {

constexpr Option check_options[] = {set_option, generations_option, population_option};

int check(const Arguments &arguments, Console &console) {
    const Experiment experiment = experiment_of(arguments, console);
    console.out << "ok: " << arguments.operands[0] << ": " << experiment.name << ", "
                << to_text(static_cast<std::int64_t>(experiment.settings.size()))
                << (experiment.settings.size() == 1 ? " setting:" : " settings:");
    for (const Spec &setting : experiment.settings) console.out << ' ' << setting.name;
    console.out << '\n';
    return 0;
}

std::string ground_words(const Environment &environment) {
    if (!environment.has_ground) return "none";
    if (environment.ground.empty()) return "flat";
    const Vec2d first = environment.ground.front(), last = environment.ground.back();
    return to_text(static_cast<std::int64_t>(environment.ground.size())) +
           " points from x = " + to_text(first.x) + " to " + to_text(last.x);
}

void describe_setting(const Spec &setting, std::ostream &out) {
    const Environment &world = setting.environment;
    out << "\nsetting " << setting.name << ": " << setting.title << "\n  actuation "
        << name_of(setting.actuation) << ", rest lengths change by up to " << to_text(setting.actuation_range)
        << "\n  search " << setting.search << ", engine " << setting.engine << "\n  gravity "
        << to_text(world.gravity) << ", ground " << ground_words(world) << ", friction "
        << to_text(world.friction) << "\n  drag normal " << to_text(world.drag_normal) << ", tangential "
        << to_text(world.drag_tangential) << ", flow " << to_text(world.flow.x) << ", "
        << to_text(world.flow.y) << '\n';
    for (const FunctionMeaning &function : setting.judgement)
        out << "  " << function.name << ": " << function.place << '\n';
    out << "  record " << name_of(setting.record) << '\n';
    bool as_in_the_paper = true;
    for (const ParameterRow &row : parameter_rows()) {
        const double value = parameter(setting.parameters, row.name);
        if (value == row.standard) continue;
        as_in_the_paper = false;
        out << "  " << row.name << " = " << value_text(row, value)
            << (row.is_choice() ? "" : " " + std::string(row.unit)) << " (standard "
            << value_text(row, row.standard) << ", " << row.origin << "): " << row.meaning << '\n';
    }
    if (as_in_the_paper) out << "  every parameter as in the paper's replication\n";
}

int describe(const Arguments &arguments, Console &console) {
    const Experiment experiment = experiment_of(arguments, console);
    console.out << "experiment " << experiment.name;
    if (!experiment.title.empty()) console.out << ": " << experiment.title;
    console.out << '\n';
    console.out << "claims to judge: "
                << to_text(static_cast<std::int64_t>(experiment.analysis.claims.size())) << '\n';
    for (const Spec &setting : experiment.settings) describe_setting(setting, console.out);
    return 0;
}

} // namespace

const Command &check_command() {
    static const Command command{
        "check",
        "FILE.lua",
        "checks an experiment file and reports every error in it",
        R"(Reads the script, checks every key and value, and calls its functions with an example of every outcome
that the simulation of an individual can have. Prints one line that starts with ok, or every error with its file and line, what
is allowed and the nearest name.)",
        check_options,
        check};
    return command;
}

const Command &describe_command() {
    static const Command command{
        "describe",
        "FILE.lua",
        "prints each setting of an experiment, and where it departs from the paper",
        R"(Prints for every setting its environment, actuation, search and functions, and each parameter whose value is not the
standard one, with the standard value and its origin.)",
        check_options,
        describe};
    return command;
}

} // namespace planula

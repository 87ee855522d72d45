// SPDX-License-Identifier: MIT
#include "program/commands.h"

#include "base/error.h"
#include "base/lane_sets.h"
#include "base/parallel.h"
#include "base/text.h"
#include "device/device.h"
#include "experiment/revision.h"
#include "tables/manifest.h"

#include <algorithm>
#include <ostream>

namespace planula {

namespace {

constexpr std::uint64_t most_seeds = 100000;

std::string help() {
    std::string text =
        wrapped(
            "planula evolves soft bodies that grow from one cell and move by themselves, after Joachimczak, "
            "Suzuki & Arita (2015). An experiment is a Lua file; to write one, copy a file of "
            "experiments/variants/.") +
        "\n\nusage: planula COMMAND [OPTION]...\n\ncommands:\n";
    constexpr std::size_t width = 15;
    for (const Command *command : all_commands())
        text += "  " + std::string(command->name) + std::string(width - 2 - command->name.size(), ' ') +
                wrapped(command->summary, width) + "\n";
    return text + "\n  planula COMMAND --help   explains a command\n"
                  "  planula --version        prints the version and the revision of the model\n\n"
                  "exit codes:\n"
                  "  0   done\n"
                  "  2   the command line is wrong\n"
                  "  65  a script or data file is wrong\n"
                  "  70  an error of planula itself\n"
                  "  73  an output cannot be created, or a folder is in use or holds another run\n"
                  "  74  reading or writing failed\n"
                  "  75  stopped; the same command resumes\n";
}

std::string version_line() {
    return "planula " + std::string(version()) + ", model " + std::string(model_revision().substr(0, 12)) +
           '\n';
}

/// What other programs call a command, and the words that do it here.
constexpr std::pair<std::string_view, std::string_view> other_names[] = {
    {"resume", "planula run resumes, with the same words as before"},
    {"continue", "planula run continues, with the same words as before"},
    {"evolve", "planula run evolves"},
    {"simulate", "planula replay simulates an individual again, planula run evolves"},
    {"film", "planula replay RUN --mp4 FILE makes a film"},
    {"plot", "make figures RUNS=DIR draws runs, planula compare two or more settings"},
    {"figures", "make figures RUNS=DIR draws runs, planula compare two or more settings"},
    {"new", "copy a file of experiments/variants/"},
    {"bench", "planula pace measures the speed, make bench everything"},
};

const Command &command_called(const std::string &name) {
    std::vector<std::string_view> names;
    for (const Command *command : all_commands()) {
        if (command->name == name) return *command;
        names.push_back(command->name);
    }
    if (name.ends_with(".lua"))
        throw UsageError("a command comes before the script, as in planula run " + name +
                         "\nsee planula --help");
    for (const auto &[other, words] : other_names)
        if (name == other)
            throw UsageError("planula has no command '" + name + "': " + std::string(words) +
                             "\nsee planula --help");
    throw UsageError("planula has no command '" + name + "'" + suggestion(name, names) +
                     "\nsee planula --help");
}

int run_words(const std::vector<std::string> &words, Console &console) {
    if (words.empty()) return console.err << help(), 2;
    if (words[0] == "--help" || words[0] == "-h" || words[0] == "help") {
        console.out << (words.size() > 1 ? help_of(command_called(words[1])) : help());
        return 0;
    }
    if (words[0] == "--version") return console.out << version_line(), 0;
    const Command &command = command_called(words[0]);
    const std::span rest(words.begin() + 1, words.end());
    for (const std::string &word : rest) {
        if (word == "--") break;
        if (word == "--help" || word == "-h") return console.out << help_of(command), 0;
    }
    return command.run(parse_arguments(command, rest), console);
}

double number_of(const std::string &option, const std::string &text) {
    if (const auto value = parse_double(text)) return *value;
    throw UsageError(option + " takes a number, not '" + text + "'");
}

double override_of(const std::string &name, const std::string &word) {
    const ParameterRow &row = parameter_row(name);
    return row.is_choice() ? value_of(row, word) : number_of("--set " + name, word);
}

std::uint64_t seed_of(const std::string &text) {
    const auto seed = parse_int(text);
    if (seed && *seed >= 0) return static_cast<std::uint64_t>(*seed);
    throw UsageError("--seeds takes A:B or N, whole numbers of 0 or more, not '" + text + "'");
}

} // namespace

std::vector<const Command *> all_commands() {
    return {&run_command(),         &status_command(),     &check_command(),   &describe_command(),
            &reduce_command(),      &compare_command(),    &report_command(),  &frames_command(),
            &witness_command(),     &lineage_command(),    &genome_command(),  &replay_command(),
            &sensitivity_command(), &verify_command(),     &merge_command(),   &signature_command(),
            &pace_command(),        &parameters_command(), &columns_command(), &reference_command(),
            &completion_command()};
}

int run_program(const std::vector<std::string> &words, Console &console) {
    int code = 70;
    try {
        code = run_words(words, console);
        if (!console.out.flush()) throw IoError("the standard output cannot be written");
    } catch (const InputError &error) {
        console.err << error.what() << '\n';
        code = error.code;
    } catch (const Error &error) {
        console.err << "planula: " << error.what() << '\n';
        code = error.code;
    } catch (const std::filesystem::filesystem_error &error) {
        console.err << "planula: " << error.what() << '\n';
        code = 74;
    } catch (const std::exception &error) {
        console.err << "planula: " << error.what() << '\n';
    }
    return code;
}

Overrides overrides_of(const Arguments &arguments) {
    Overrides overrides;
    Parameters trial;
    // What is wrong with them is the command line's fault, not the script's.
    const auto add = [&](const std::string &name, const auto &value) {
        for (const auto &[known, ignored] : overrides)
            if (known == name) throw UsageError("the parameter " + name + " is given twice");
        try {
            overrides.emplace_back(name, value());
            set_parameter(trial, name, overrides.back().second);
        } catch (const InputError &error) {
            throw UsageError(std::string(error.what()) + "\nsee planula parameters");
        }
    };
    for (const std::string &word : arguments.all("set")) {
        const std::size_t equals = word.find('=');
        if (equals == word.npos)
            throw UsageError("--set takes NAME=VALUE, not '" + word + "'\nsee planula parameters");
        const std::string name = word.substr(0, equals);
        add(name, [&] { return override_of(name, word.substr(equals + 1)); });
    }
    for (const char *name : {"generations", "population"})
        if (arguments.has(name))
            add(name, [&] { return number_of(std::string("--") + name, arguments.text(name)); });
    return overrides;
}

Experiment experiment_of(const Arguments &arguments, const Console &console, const Overrides &changes) {
    const Overrides asked = overrides_of(arguments);
    Overrides overrides = asked;
    overrides.insert(overrides.end(), changes.begin(), changes.end());
    Experiment experiment = load_experiment(arguments.operands.at(0), console.library, overrides);
    for (const auto &[name, value] : asked)
        if (const std::string why = why_without_effect(experiment, name); !why.empty())
            throw UsageError("--set " + name + "=" + value_text(parameter_row(name), value) +
                             " changes nothing, as no setting of " + experiment.name + " reads it:" + why);
    return experiment;
}

std::vector<std::uint64_t> seeds_of(const Arguments &arguments, const Experiment &experiment) {
    const std::string words =
        arguments.text("seeds", "1:" + to_text(experiment.settings.at(0).parameters.design.seeds));
    const std::size_t colon = words.find(':');
    const std::uint64_t first = seed_of(words.substr(0, colon));
    const std::uint64_t last = colon == words.npos ? first : seed_of(words.substr(colon + 1));
    if (last < first || last - first >= most_seeds)
        throw UsageError("--seeds " + words + ": A:B needs A <= B, and at most 100000 seeds");
    std::vector<std::uint64_t> seeds;
    for (std::uint64_t seed = first; seed <= last; ++seed) seeds.push_back(seed);
    return seeds;
}

RunChoice choice_of(const Arguments &arguments, const Experiment &experiment, Console &console) {
    RunChoice choice;
    choice.folder = runs_folder(arguments, "runs", experiment);
    if (arguments.has("seeds")) choice.seeds = seeds_of(arguments, experiment);
    choice.tell = [&console](const std::string &line) { console.err << line << '\n'; };
    return choice;
}

int threads_of(const Arguments &arguments) {
    const Device *device = chosen_device();
    // Of many threads most wait for the device.
    return arguments.whole("threads", 1, std::max(hardware_threads(), device ? device->trials_at_once() : 0));
}

void use_lanes_of(const Arguments &arguments) {
    const std::string lanes = arguments.text("lanes", "");
    if (lanes.empty()) return;
    try {
        choose_lanes(lanes);
    } catch (const InputError &error) {
        throw UsageError("--lanes " + lanes + ": " + error.what());
    }
}

std::string runs_folder(const Arguments &arguments, std::string_view option, const Experiment &experiment) {
    return arguments.text(option, "build/runs/" + experiment.name);
}

} // namespace planula

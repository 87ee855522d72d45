// SPDX-License-Identifier: MIT
// The completion script of a shell, made from the declarations of all commands: a new command or option needs no line
// here.
#include "base/error.h"
#include "parameters/parameters.h"
#include "program/commands.h"

#include <ostream>

namespace planula {

namespace {

std::string parameter_names(std::string_view ending) {
    std::string names;
    for (const ParameterRow &row : parameter_rows())
        names.append(names.empty() ? "" : " ").append(row.name).append(ending);
    return names;
}

/// The words of "a|B|c" that begin with a small letter: these are typed as they stand.
std::string literal_words(std::string_view value) {
    std::string words;
    for (std::size_t at = 0; at < value.size();) {
        const std::size_t end = std::min(value.find('|', at), value.size());
        const std::string_view word = value.substr(at, end - at);
        if (word.front() >= 'a' && word.front() <= 'z') words.append(words.empty() ? "" : " ").append(word);
        at = end + 1;
    }
    return words;
}

/// The function of the script that completes such a value.
std::string completer_of(std::string_view value) {
    if (value.ends_with(".lua") || value == "SCRIPT.lua...") return "_planula_files lua";
    if (value == "FILE") return "_planula_files";
    if (value == "DIR" || value == "RUN" || value == "FROM...") return "_planula_folders";
    if (value == "NAME") return "_planula_words '" + parameter_names("") + "'";
    if (value == "NAME=VALUE") return "_planula_words '" + parameter_names("=") + "'";
    return "_planula_words '" + literal_words(value) + "'";
}

constexpr std::string_view functions = R"(# Completion of planula in bash: source <(planula completion bash)
_planula_words() {
    COMPREPLY=($(compgen -W "$1" -- "$word"))
    [[ ${COMPREPLY[0]} != *= ]] || compopt -o nospace
}
_planula_folders() {
    compopt -o filenames
    mapfile -t COMPREPLY < <(compgen -d -- "$word")
}
_planula_files() {
    compopt -o filenames
    mapfile -t COMPREPLY < <(compgen -d -- "$word"; compgen -f ${1:+-X "!*.$1"} -- "$word")
}
_planula() {
    local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} command=${COMP_WORDS[1]}
    COMPREPLY=()
)";

std::string script() {
    std::string commands, values, options;
    for (const Command *command : all_commands()) {
        const std::string name(command->name);
        commands += name + " ";
        std::string names = "--help";
        for (const Option &option : command->options) {
            names.append(" --").append(option.name);
            if (option.value.empty()) continue;
            values.append("    '").append(name).append(" --").append(option.name).append("') ");
            values.append(completer_of(option.value)).append("; return ;;\n");
        }
        options += "    " + name + ") if [[ $word == -* ]]; then _planula_words '" + names + "'; else " +
                   completer_of(command->operand) + "; fi ;;\n";
    }
    return std::string(functions) + "    if ((COMP_CWORD == 1)); then _planula_words '" + commands +
           "--help --version'; return; fi\n    case \"$command $before\" in\n" + values +
           "    esac\n    case $command in\n" + options + "    esac\n}\ncomplete -F _planula planula\n";
}

int print_completion(const Arguments &arguments, Console &console) {
    if (arguments.operands.at(0) != "bash")
        throw UsageError("planula completes in bash only, not in '" + arguments.operands.at(0) + "'");
    console.out << script();
    return 0;
}

} // namespace

const Command &completion_command() {
    static const Command command{
        "completion",
        "bash",
        "prints a script that completes commands, options and values in bash",
        R"(For the present shell: source <(planula completion bash). For all: write the output to
~/.local/share/bash-completion/completions/planula.)",
        {},
        print_completion};
    return command;
}

} // namespace planula

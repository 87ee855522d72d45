// SPDX-License-Identifier: MIT
#include "program/arguments.h"

#include "base/error.h"
#include "base/text.h"

#include <algorithm>
#include <limits>

namespace planula {

namespace {

std::string see_help(const Command &command) {
    return "\nsee planula " + std::string(command.name) + " --help";
}

const Option &option_called(const Command &command, const std::string &name) {
    std::vector<std::string_view> names{"help"};
    for (const Option &option : command.options) {
        if (option.name == name) return option;
        names.push_back(option.name);
    }
    const std::string nearest = nearest_name(name, names);
    throw UsageError("planula " + std::string(command.name) + " has no option --" + name +
                     (nearest.empty() ? "" : "; did you mean --" + nearest + "?") + see_help(command));
}

std::string usage_of(const Option &option) {
    std::string usage = "--";
    usage += option.name;
    if (!option.value.empty()) usage.append(" ").append(option.value);
    return usage;
}

} // namespace

std::string Arguments::text(std::string_view option, std::string fallback) const {
    const auto found = values_.find(std::string(option));
    return found == values_.end() ? fallback : found->second.back();
}

std::vector<std::string> Arguments::all(std::string_view option) const {
    const auto found = values_.find(std::string(option));
    return found == values_.end() ? std::vector<std::string>{} : found->second;
}

int Arguments::whole(std::string_view option, int lowest, int fallback) const {
    if (!has(option)) return fallback;
    const auto value = parse_int(text(option));
    if (!value || *value < lowest || *value > std::numeric_limits<int>::max())
        throw UsageError("--" + std::string(option) + " takes a whole number of " + to_text(lowest) +
                         " or more, not '" + text(option) + "'");
    return static_cast<int>(*value);
}

Arguments parse_arguments(const Command &command, std::span<const std::string> words) {
    Arguments arguments;
    bool options_ended = false;
    for (std::size_t i = 0; i < words.size(); ++i) {
        const std::string &word = words[i];
        if (options_ended || word.size() < 2 || word[0] != '-') {
            arguments.operands.push_back(word);
            continue;
        }
        if (word == "--") {
            options_ended = true;
            continue;
        }

        // --name value, --name=value, or --name alone.
        const std::size_t equals = word.find('=');
        const std::string name = word.substr(0, equals).substr(word[1] == '-' ? 2 : 1);
        const Option &option = option_called(command, name);
        if (arguments.has(name) && !option.repeatable)
            throw UsageError("--" + name + " is given twice" + see_help(command));
        if (option.value.empty() && equals != word.npos)
            throw UsageError("--" + name + " takes no value" + see_help(command));
        if (option.value.empty())
            arguments.add(name, "");
        else if (equals != word.npos)
            arguments.add(name, word.substr(equals + 1));
        else if (++i < words.size())
            arguments.add(name, words[i]);
        else
            throw UsageError("--" + name + " needs a value: " + usage_of(option) + see_help(command));
    }

    const std::size_t wanted = command.operand.empty() ? 0 : 1;
    if (arguments.operands.size() < wanted)
        throw UsageError("planula " + std::string(command.name) + " needs " + std::string(command.operand) +
                         see_help(command));
    if (arguments.operands.size() > wanted && !command.operand.ends_with("..."))
        throw UsageError("planula " + std::string(command.name) + ": '" + arguments.operands[wanted] +
                         "' is one word too many" + see_help(command));
    return arguments;
}

std::string help_of(const Command &command) {
    std::string text = "usage: planula " + std::string(command.name);
    if (!command.operand.empty()) text += " " + std::string(command.operand);
    for (const Option &option : command.options)
        text += " [" + usage_of(option) + "]" + (option.repeatable ? "..." : "");
    text += "\n\n" + std::string(command.summary) + "\n\n" + std::string(command.details) + "\n";
    std::size_t width = 0;
    for (const Option &option : command.options) width = std::max(width, usage_of(option).size());
    if (!command.options.empty()) text += "\noptions:\n";
    for (const Option &option : command.options) {
        const std::string usage = usage_of(option);
        text += "  " + usage + std::string(width - usage.size() + 2, ' ') + std::string(option.help) + "\n";
    }
    return text;
}

} // namespace planula

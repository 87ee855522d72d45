// SPDX-License-Identifier: MIT
#include "program/arguments.h"

#include "base/error.h"
#include "base/text.h"

#include <algorithm>
#include <cstring>
#include <limits>

namespace planula {

namespace {

constexpr std::size_t columns = 80; // of a terminal

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
        throw UsageError(
            "planula " + std::string(command.name) +
            (wanted == 0 ? " takes options only" : " takes one " + std::string(command.operand)) +
            "; what is '" + arguments.operands[wanted] + "'?" + see_help(command));
    return arguments;
}

std::size_t columns_of(std::string_view text) {
    // Every byte of UTF-8 but those that continue a letter.
    return static_cast<std::size_t>(std::count_if(
        text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

std::string wrapped(std::string_view text, std::size_t indent) {
    std::string result;
    std::size_t column = indent;
    const char *gap = "";
    for (std::size_t at = 0; (at = text.find_first_not_of(" \n", at)) != text.npos;) {
        const std::size_t end = std::min(text.find_first_of(" \n", at), text.size());
        const std::size_t width = columns_of(text.substr(at, end - at));
        if (*gap == ' ' && column + 1 + width > columns) gap = "\n";
        result.append(gap);
        column = *gap == '\n' ? indent : column + std::strlen(gap);
        if (*gap == '\n') result.append(indent, ' ');
        result.append(text.substr(at, end - at));
        column += width;
        gap = text.substr(end, 2) == "\n\n" ? "\n\n" : " ";
        at = end;
    }
    return result;
}

std::string help_of(const Command &command) {
    std::string text = "usage: planula " + std::string(command.name);
    if (!command.operand.empty()) text += " " + std::string(command.operand);
    if (!command.options.empty()) text += " [OPTION]...";
    std::string summary(command.summary);
    summary.front() = static_cast<char>(summary.front() - 'a' + 'A');
    text += "\n\n" + wrapped(summary + ".") + "\n\n" + wrapped(command.details) + "\n";
    // The help of an option with a long value begins on the next line.
    constexpr std::size_t longest = 20;
    std::size_t width = 0;
    for (const Option &option : command.options)
        if (const std::size_t own = columns_of(usage_of(option)); own <= longest)
            width = std::max(width, own + 4);
    if (!command.options.empty()) text += "\noptions:\n";
    for (const Option &option : command.options) {
        const std::string usage = "  " + usage_of(option);
        const bool is_long = columns_of(usage) + 2 > width;
        text += usage +
                (is_long ? "\n" + std::string(width, ' ') : std::string(width - columns_of(usage), ' ')) +
                wrapped(option.help, width) + '\n';
    }
    return text;
}

} // namespace planula

// SPDX-License-Identifier: MIT
// The command line as a table: a command states its options, and parsing, --help, error messages and the completion of
// a shell follow from that. Options are written --name value or --name=value; "--" ends them.
//
// A library would not make this shorter: CLI11 2.1 (Debian 12) suggests no names and completes nothing, reports a
// misspelt command as a missing one, splits `--set [a,b]`, takes the script for a second value of a `--set` before it,
// and does not wrap its help.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace planula {

struct Option {
    std::string_view name; // without the dashes
    std::string_view
        value; // what --help calls its value; empty: the option has none; "a|b|c": one of these words
    std::string_view help;
    bool repeatable = false;
};

/// Where a command writes, and where it was started.
struct Console {
    std::ostream &out, &err;
    bool terminal = false;         // whether err is one
    std::filesystem::path library; // the folder of this program's experiments
    std::filesystem::path bundle;  // the folder of the scripts of reports, which `make report` bundles
};

class Arguments {
  public:
    std::vector<std::string> operands;

    void add(std::string_view option, std::string value) {
        values_[std::string(option)].push_back(std::move(value));
    }
    bool has(std::string_view option) const { return values_.contains(std::string(option)); }
    /// The value of an option, or the fallback.
    std::string text(std::string_view option, std::string fallback = "") const;
    /// All values of a repeatable option, in order.
    std::vector<std::string> all(std::string_view option) const;
    /// A whole number of at least `lowest`, or the fallback. Throws UsageError.
    int whole(std::string_view option, int lowest, int fallback) const;

  private:
    std::map<std::string, std::vector<std::string>> values_;
};

struct Command {
    std::string_view name;
    std::string_view operand; // its one operand, or empty; ending in "..." if there may be more
    std::string_view summary; // what it does; begins with a small letter
    std::string_view details; // paragraphs, with an empty line between two
    std::span<const Option> options;
    int (*run)(const Arguments &arguments, Console &console);
};

/// Throws UsageError with the word, the rule and the nearest option.
Arguments parse_arguments(const Command &command, std::span<const std::string> words);

/// The text of `planula COMMAND --help`.
std::string help_of(const Command &command);

/// The text in lines of at most 80 columns, to be printed after `indent` columns: all lines but the first begin with as
/// many blanks. Line breaks in the text count as blanks, empty lines stay.
std::string wrapped(std::string_view text, std::size_t indent = 0);

/// How many columns a text takes: letters, not bytes.
std::size_t columns_of(std::string_view text);

} // namespace planula

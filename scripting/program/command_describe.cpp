// SPDX-License-Identifier: MIT
#include "base/text.h"
#include "program/commands.h"
#include "statement/departures.h"
#include "tables/csv.h"

#include <algorithm>
#include <map>
#include <ostream>

namespace planula {

namespace {

constexpr Option describe_options[] = {
    {"csv", "", "prints the departures as a table: setting, part, name, value, paper, origin, note"},
    set_option,
    generations_option,
    population_option,
};

using Departures = std::vector<Departure>;

/// Lines of at most 80 columns: the first behind `indent` blanks, the others behind four more.
std::string paragraph(const std::string &text, std::size_t indent) {
    return std::string(indent, ' ') + wrapped(text, indent + 4) + '\n';
}

std::string text_of(const Departure &departure) {
    const bool is_function = departure.part == "function";
    std::string text = departure.part + " " + departure.name;
    if (departure.part == departure.name) text = departure.name;
    text += (is_function ? " of " : ": ") + departure.value + " (paper: " + departure.paper +
            (departure.origin.empty() ? ")" : ", " + departure.origin + ")");
    if (!departure.note.empty()) text += "; " + departure.note;
    std::string lines = paragraph(text, 2);
    for (const std::string &line : departure.lines) lines += "      " + line + '\n';
    return lines;
}

/// A line for each row, its columns two blanks apart.
std::string aligned(const std::vector<std::vector<std::string>> &rows) {
    std::vector<std::size_t> widths(rows.front().size(), 0);
    for (const auto &row : rows)
        for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], columns_of(row[i]));
    std::string text;
    for (const auto &row : rows) {
        for (std::size_t i = 0; i + 1 < row.size(); ++i)
            text += row[i] + std::string(widths[i] + 2 - columns_of(row[i]), ' ');
        text += row.back() + '\n';
    }
    return text;
}

class Describe {
  public:
    Describe(const Arguments &arguments, Console &console)
        : out_(console.out), experiment_(experiment_of(arguments, console)),
          comparison_(experiment_, console.library) {
        for (std::size_t i = 0; i < experiment_.settings.size(); ++i)
            own_.push_back(comparison_.of_setting(i));
    }

    int print() {
        out_ << "experiment " << experiment_.name
             << (experiment_.title.empty() ? "" : ": " + experiment_.title) << ", "
             << counted(experiment_.settings.size(), "setting") << '\n';
        print_settings();
        print_environments();
        print_departures();
        return 0;
    }

    int print_csv() const {
        out_ << to_line(
            std::vector<std::string>{"setting", "part", "name", "value", "paper", "origin", "note"});
        for (std::size_t i = 0; i < own_.size(); ++i)
            for (const Departure &d : own_[i]) {
                std::vector<std::string> fields;
                for (const std::string &text :
                     {experiment_.settings[i].name, d.part, d.name, d.value, d.paper, d.origin, d.note})
                    fields.push_back(to_field(text));
                out_ << to_line(fields);
            }
        return 0;
    }

  private:
    std::vector<std::string> names(const std::vector<std::size_t> &indices) const {
        std::vector<std::string> names;
        for (const std::size_t i : indices) names.push_back(experiment_.settings[i].name);
        return names;
    }

    void print_settings() const {
        std::vector<std::vector<std::string>> rows{
            {"setting", "actuation", "search", "engine", "record", "compared with", "title"}};
        for (std::size_t i = 0; i < experiment_.settings.size(); ++i) {
            const Spec &spec = experiment_.settings[i];
            rows.push_back({spec.name, name_of(spec.actuation), spec.search, spec.engine,
                            name_of(spec.record), comparison_.counterpart(i).name, spec.title});
        }
        out_ << '\n' << aligned(rows);
    }

    // Each environment once, with the settings that have it.
    void print_environments() const {
        std::vector<std::pair<std::string, std::vector<std::size_t>>> environments;
        for (std::size_t i = 0; i < experiment_.settings.size(); ++i) {
            const std::string text = environment_text(experiment_.settings[i]);
            const auto known = std::find_if(environments.begin(), environments.end(),
                                            [&](const auto &each) { return each.first == text; });
            if (known == environments.end())
                environments.push_back({text, {i}});
            else
                known->second.push_back(i);
        }
        out_ << '\n';
        for (const auto &[text, settings] : environments) {
            const bool is_only = environments.size() == 1;
            out_ << paragraph(
                "environment" + (is_only ? "" : " of " + list_of(names(settings))) + ": " + text, 0);
        }
    }

    void print_departures() {
        if (std::all_of(own_.begin(), own_.end(), [](const Departures &each) { return each.empty(); })) {
            out_ << "\nEvery setting is as in the paper: environment, functions, search, engine, start and "
                    "parameters.\n";
            return;
        }
        const bool are_several = own_.size() > 1;
        const std::string rest = are_several ? "" : rest_of(own_.front());
        const Departures shared = take_shared();
        if (are_several && !shared.empty()) print_group("all settings depart from the paper", shared);
        // Settings with equal departures are one group.
        std::vector<std::pair<Departures, std::vector<std::size_t>>> groups;
        for (std::size_t i = 0; i < own_.size(); ++i) {
            const auto known = std::find_if(groups.begin(), groups.end(),
                                            [&](const auto &each) { return each.first == own_[i]; });
            if (known == groups.end())
                groups.push_back({own_[i], {i}});
            else
                known->second.push_back(i);
        }
        for (const auto &[departures, settings] : groups) {
            const std::string who = list_of(names(settings));
            if (!departures.empty())
                print_group(who + (settings.size() == 1 ? " departs" : " depart") + " from the paper" +
                                (shared.empty() || !are_several ? "" : " also"),
                            departures);
            else if (shared.empty())
                out_ << '\n' << paragraph(who + ": as in the paper", 0);
        }
        if (!rest.empty()) out_ << paragraph("as in the paper: " + rest, 2);
    }

    /// Of several settings the departures that all have, which are removed from them.
    Departures take_shared() {
        Departures shared;
        if (own_.size() < 2) return shared;
        for (const Departure &departure : own_.front())
            if (std::all_of(own_.begin(), own_.end(), [&](const Departures &each) {
                    return std::find(each.begin(), each.end(), departure) != each.end();
                }))
                shared.push_back(departure);
        for (const Departure &departure : shared)
            for (Departures &each : own_) each.erase(std::find(each.begin(), each.end(), departure));
        return shared;
    }

    void print_group(const std::string &title, const Departures &departures) const {
        out_ << '\n' << paragraph(title + ":", 0);
        for (const Departure &departure : departures) out_ << text_of(departure);
    }

    /// What is left as it is in the paper.
    static std::string rest_of(const Departures &departures) {
        std::string rest;
        for (const auto &[part, words] :
             {std::pair{"environment", "environment"}, std::pair{"search", "search"},
              std::pair{"engine", "engine"}, std::pair{"start", "start"}, std::pair{"function", "functions"},
              std::pair{"parameter", "parameters"}})
            if (std::none_of(departures.begin(), departures.end(),
                             [&, &name = part](const Departure &each) { return each.part == name; }))
                rest += (rest.empty() ? "" : ", ") + std::string(words);
        return rest;
    }

    std::ostream &out_;
    const Experiment experiment_;
    Comparison comparison_;
    std::vector<Departures> own_; // of each setting
};

int describe(const Arguments &arguments, Console &console) {
    Describe description(arguments, console);
    return arguments.has("csv") ? description.print_csv() : description.print();
}

} // namespace

const Command &describe_command() {
    static const Command command{
        "describe",
        "FILE.lua",
        "prints each setting of an experiment, and every departure from the paper",
        R"(Compares every setting with the one of experiments/paper/replication.lua that has the same actuation, has ground or none as it
has, and if possible the same search. Prints what differs, with the paper's value behind it: the environment, search, engine, start,
functions and parameters. Of a function whose meaning differs it prints the source, with "-" before the lines that only the paper's has
and "+" before those that the paper's lacks. What all settings share comes first.

`record` and titles are no departures: no result depends on them.)",
        describe_options,
        describe};
    return command;
}

} // namespace planula

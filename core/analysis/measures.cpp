// SPDX-License-Identifier: MIT
#include "analysis/measures.h"

#include "base/error.h"
#include "base/text.h"

#include <algorithm>
#include <array>
#include <type_traits>

namespace planula {

namespace {

/// Columns that say which row it is.
constexpr std::array<std::string_view, 3> places{"seed", "generations", "generation"};

/// Calls visit(name, number) for each column that measures.
template <class Row, class Visit> void each_measure(const Row &row, Visit &&visit) {
    each_column(row, [&](std::string_view name, const auto &value) {
        using Value = std::decay_t<decltype(value)>;
        if (std::find(places.begin(), places.end(), name) != places.end()) return;
        if constexpr (std::is_same_v<Value, Maybe>)
            visit(name, value);
        else if constexpr (std::is_arithmetic_v<Value>)
            visit(name, Maybe(static_cast<double>(value)));
    });
}

template <class Row> void add_measures(std::vector<Measure> &all) {
    each_measure(Row(), [&](std::string_view name, const Maybe &) {
        const auto is_known = [&](const Measure &measure) { return measure.name == name; };
        if (std::any_of(all.begin(), all.end(), is_known)) return;
        for (const ColumnRow &column : columns())
            if (column.file == Row::file_name && column.column == name)
                all.push_back({column.column, column.unit, column.meaning});
    });
}

} // namespace

std::string Measure::words() const {
    if (name == "best_cells") return "number of cells of the best individual";
    std::string text = name;
    std::replace(text.begin(), text.end(), '_', ' ');
    return text;
}

std::string Measure::unit_words() const {
    // Fitness is what the function of the experiment returns, which need not be a distance.
    if (name.find("fitness") != name.npos || unit == "1" || unit == "generation" || unit == "slot") return "";
    return " " + unit + (unit.ends_with('s') ? "" : "s");
}

std::vector<Measure> measures() {
    std::vector<Measure> all;
    add_measures<RunRow>(all);
    add_measures<GenerationRow>(all);
    return all;
}

Measure measure_called(std::string_view name) {
    std::vector<std::string> names;
    for (Measure &measure : measures()) {
        if (measure.name == name) return std::move(measure);
        names.push_back(measure.name);
    }
    throw InputError("there is no measure '" + std::string(name) + "'" + suggestion(name, names) +
                     "\nmeasures are the numbers of runs.csv and generations.csv: " + list_of(names));
}

Maybe measured(const Measure &measure, const RunRow &run, const GenerationRow &last) {
    Maybe value;
    const auto take = [&](std::string_view name, const Maybe &number) {
        if (name == measure.name) value = number;
    };
    each_measure(last, take);
    each_measure(run, take); // which has precedence
    return value;
}

} // namespace planula

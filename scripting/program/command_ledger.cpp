// SPDX-License-Identifier: MIT
#include "base/text.h"
#include "parameters/parameters.h"
#include "program/commands.h"
#include "tables/csv.h"
#include "tables/ledger.h"

#include <ostream>

namespace planula {

namespace {

constexpr Option parameters_options[] = {{"csv", "", "print the table parameters.csv"}};

/// The unit and the range of a number, the alternatives of a choice.
std::string range_text(const ParameterRow &row) {
    if (!row.is_choice())
        return std::string(row.unit) + " [" + to_text(row.lowest) + " … " + to_text(row.highest) + "]";
    std::string names;
    for (const std::string_view name : row.names) names.append(names.empty() ? "[" : " | ").append(name);
    return names + "]";
}

int print_parameters(const Arguments &arguments, Console &console) {
    if (arguments.has("csv")) {
        console.out << header_line<LedgerRow>();
        const Parameters standard;
        for (const LedgerRow &row : ledger(std::span(&standard, 1))) console.out << line_of(row);
        return 0;
    }
    std::string_view section;
    for (const ParameterRow &row : parameter_rows()) {
        if (row.section != section) console.out << (section.empty() ? "" : "\n") << row.section << '\n';
        section = row.section;
        console.out << "  " << row.name << " = " << value_text(row, row.standard) << ' ' << range_text(row)
                    << " (" << row.origin << "): " << row.meaning << '\n';
    }
    return 0;
}

int print_columns(const Arguments &, Console &console) {
    console.out << header_line<ColumnRow>();
    for (const ColumnRow &row : columns()) console.out << line_of(row);
    return 0;
}

} // namespace

const Command &parameters_command() {
    static const Command command{
        "parameters",
        "",
        "lists the parameters of the model: value, range, unit, origin, meaning",
        R"(A script sets a parameter by parameters = { name = value }, the command line by --set NAME=VALUE. The origin of a value is a section
or equation of the paper, MN for a default of MultiNEAT, or ours if nothing published gives it.)",
        parameters_options,
        print_parameters};
    return command;
}

const Command &columns_command() {
    static const Command command{"columns",
                                 "",
                                 "lists the columns of all tables that planula writes, with unit and meaning",
                                 R"(Prints a CSV table: file, column, unit, meaning.)",
                                 {},
                                 print_columns};
    return command;
}

} // namespace planula

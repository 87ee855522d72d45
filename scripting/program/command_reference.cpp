// SPDX-License-Identifier: MIT
#include "program/commands.h"
#include "statement/reference.h"

#include <ostream>

namespace planula {

namespace {

int print_reference(const Arguments &, Console &console) {
    console.out << reference();
    return 0;
}

} // namespace

const Command &reference_command() {
    static const Command command{
        "reference",
        "",
        "lists everything that an experiment file may state and read",
        R"(Prints REFERENCE.md: every key, search, engine, field of a life, function and parameter, with unit, default and origin.)",
        {},
        print_reference};
    return command;
}

} // namespace planula

// SPDX-License-Identifier: MIT
#include "statement/reference.h"

#include "base/check.h"
#include "base/text.h"
#include "evaluation/life.h"
#include "evaluation/observations.h"
#include "evolution/search.h"
#include "language/functions.h"
#include "language/sources.h"
#include "parameters/parameters.h"
#include "physics/engine.h"
#include "statement/keys.h"
#include "statement/wrap_runs.h"

#include <initializer_list>
#include <iterator>
#include <utility>

namespace planula {

namespace {

using View = std::string_view;

constexpr View beginning = R"(# Reference

Everything that an experiment file may state and read. This page is made by `make reference` from the lists that the
program itself uses. [`TUTORIAL.md`](TUTORIAL.md) shows how to begin.

- [The experiment file](#the-experiment-file)
- [Searches and engines](#searches-and-engines)
- [What a life tells](#what-a-life-tells)
- [What scripts may call](#what-scripts-may-call)
- [What statistics see and call](#what-statistics-see-and-call)
- [Parameters](#parameters)

**Kinds.** A *quantity* is a number, or the name of a parameter as a text: `gravity = "gravity"` takes the value of the
parameter, and follows it when that is changed.

**Units.** cell: one cell diameter; t.u.: time unit, of many physics steps; mass: that of one cell; 1: no unit.

**Origins.** A section, equation or figure is one of the paper (Joachimczak, Suzuki & Arita 2015). Four digits are a page
of [`paper/decisions/`](paper/decisions) that gives the reasons. MN is a default of MultiNEAT. Ours: given by no
publication.

## The experiment file

A script returns one table, made by `planula.experiment { … }`, or by `paper.experiment { … }` and `paper.design { … }`
of [`experiments/paper/init.lua`](experiments/paper/init.lua), which fill in the paper's values for all that is not
stated. An unknown key, a wrong kind or a broken rule is an error with file and line. Defaults are those without `paper`.
)";

constexpr View about_lives = R"(
Functions that judge are given a finished `life`, read-only. The fields marked *growth* are known when a body has grown;
the others only after it has moved, so that the `behaviour` of a `start` cannot read them. A point has `x` and `y`. A path
is a list of points: `life.path[1]`, `#life.path`, `ipairs(life.path)`.

What a function closes over must not change: how a life is judged must not depend on other lives
([0028](paper/decisions/0028-guests.md)).
)";

constexpr View about_functions = R"(
Scripts run in a sandbox without files, clock, random numbers and addresses: what a script computes is the same on every
machine. One call may execute 5 million instructions and hold 64 MB of memory. Reading the script may take 20 million,
and its whole check )";

/// A cell of a table.
std::string cell(View text) {
    std::string escaped;
    for (const char c : text) escaped += c == '|' ? "\\|" : std::string(1, c);
    return escaped;
}

std::string code(View text) { return text.empty() ? "" : "`" + cell(text) + "`"; }

std::string row(std::initializer_list<std::string> cells) {
    std::string line = "|";
    for (const std::string &each : cells) line += " " + each + (each.empty() ? "|" : " |");
    return line + "\n";
}

std::string head(std::initializer_list<std::string> names) {
    std::string rule = "|";
    for (std::size_t i = 0; i < names.size(); ++i) rule += "---|";
    return "\n" + row(names) + rule + "\n";
}

std::string title_of(const KeyTable &table) {
    if (table.path == "experiment") return "The experiment";
    if (table.path == "setting") return "A setting";
    return "`" + std::string(table.path) + "`";
}

std::string sentence(View text) {
    return "\n" + std::string(1, static_cast<char>(text[0] - 'a' + 'A')) + std::string(text.substr(1)) +
           ".\n";
}

std::string keys() {
    std::string text;
    for (const KeyTable &table : key_tables()) {
        text += "\n### " + title_of(table) + "\n" + sentence(table.meaning);
        text += head({"key", "kind", "unit", "default", "origin", "meaning", "example"});
        for (const Key &key : table.keys)
            text += row({code(key.name), cell(key.kind), cell(key.unit), cell(key.standard), cell(key.origin),
                         cell(key.meaning), code(key.example)});
    }
    return text;
}

std::string searches_and_engines() {
    std::string text = "\n## Searches and engines\n" + head({"`search`", "what it rewards"});
    for (const SearchRow &search : search_rows()) text += row({code(search.name), cell(search.score)});
    constexpr std::pair<View, View> engines[] = {
        {"native", "planula's own, fast"},
        {"reference", "the same laws in a plain form, which the native engine is tested against"},
        {"bullet",
         "the Bullet physics engine, for comparison; its results are not the same on every processor"}};
    CHECK(std::size(engines) == engine_names().size());
    text += head({"`engine`", "what it is"});
    for (const auto &[name, meaning] : engines) text += row({code(name), cell(meaning)});
    return text +
           "\n[`paper/decisions/0016-searches.md`](paper/decisions/0016-searches.md) describes the searches, "
           "[`paper/decisions/0021-reference-engine.md`](paper/decisions/0021-reference-engine.md) the "
           "engines.\n";
}

std::string stage_of(KnownAfter known) { return known == KnownAfter::growth ? "growth" : "movement"; }

std::string lives() {
    std::string text = "\n## What a life tells\n" + std::string(about_lives) +
                       head({"field", "unit", "known after", "meaning"});
    text += row(
        {"`life.displacement`", "cell", "movement", "distance from rest to finish; 0 unless viable (Eq. 4)"});
    for (const LifeField &field : life_fields())
        if (field.is_shown)
            text += row({code("life." + std::string(field.name)), cell(field.unit), stage_of(field.known),
                         cell(field.meaning)});
    text += "\nThese are computed only for settings whose functions name them (decision 0026).\n" +
            head({"observation", "unit", "known after", "meaning"});
    for (const ObservationRow &each : observation_rows())
        text += row({code("life." + std::string(each.name)), cell(each.unit), stage_of(each.known),
                     cell(each.meaning)});
    return text;
}

std::string functions() {
    std::string text = "\n## What scripts may call\n" + std::string(about_functions) +
                       to_text(instructions_of_a_check / 1'000'000) + " million.\n";
    text += head({"name", "use", "meaning"});
    for (const SandboxFunction &function : sandbox_functions())
        text += row({code(function.name), code(function.use), cell(function.meaning)});
    return text;
}

constexpr std::string_view about_statistics = R"(
The function of a table is called as `f(runs, stats)`, that of a claim as `f(runs, stats, claim)`. `runs` shows the recorded
runs, read-only: `runs.NAME` or `runs["NAME"]` is a setting, `#runs` and `runs[i]` are all that have runs. A setting has
`name`, `title`, `generations`, `population`, and its runs, `setting[1]` … `setting[#setting]`, by ascending seed. A field
after g generations is `run.best_fitness[g]`, or false where the run has no such value; `setting.best_fitness[g]` is the
list of all runs. `run.champion.elongation[g]` is of the best individual up to then. A run also has `seed`;
`run.endpoints`, a list of `{generation, x, y}`, how far randomly sampled viable individuals came; and `run.archive`, the
list of its entries at the end, `{generation, fitness, behaviour}`, while `setting.archive[g]` is their number after g
generations. These generations count from 1, too.
([0023](paper/decisions/0023-functions-of-the-runs.md))
)";

std::string statistics() {
    std::string text =
        "\n## What statistics see and call\n" + std::string(about_statistics) + head({"call", "meaning"});
#define STATISTIC(name, signature, least, most, function, meaning)                                           \
    text += row({code("stats." #name signature), cell(meaning)});
#define STATISTIC_NUMBER(name, meaning) text += row({code("stats." #name), cell(meaning)});
#include "statement/wrap_stats.inl"
    text += head({"field of a run or setting", "unit", "meaning"});
    for (const RunField &field : run_fields())
        text += row({code(field.name), cell(field.unit), cell(field.meaning)});
    text += head({"field of `champion`", "unit", "meaning"});
    for (const RunField &field : champion_fields())
        text += row({code(field.name), cell(field.unit), cell(field.meaning)});
    return text;
}

std::string range_of(const ParameterRow &parameter) {
    std::string text;
    for (const View name : parameter.names)
        text.append(text.empty() ? "" : ", ").append("`\"").append(name).append("\"`");
    return parameter.is_choice() ? text : to_text(parameter.lowest) + " … " + to_text(parameter.highest);
}

std::string parameters() {
    std::string text =
        "\n## Parameters\n\nA script states `parameters = { population = 40 }`, the command line `--set "
        "population=40`.\n";
    View section;
    for (const ParameterRow &each : parameter_rows()) {
        if (each.section != section)
            text += "\n### " + std::string(each.section) + "\n" +
                    head({"parameter", "default", "range", "unit", "origin", "meaning"});
        section = each.section;
        text += row({code(each.name), value_text(each, each.standard), range_of(each), cell(each.unit),
                     cell(each.origin), cell(each.meaning)});
    }
    return text;
}

} // namespace

std::string reference() {
    return std::string(beginning) + keys() + searches_and_engines() + lives() + functions() + statistics() +
           parameters();
}

} // namespace planula

// SPDX-License-Identifier: MIT
#include "experiment/spec.h"

#include "base/error.h"
#include "base/text.h"
#include "evolution/search.h"
#include "physics/engine.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace planula {

namespace {

bool is_file_name(const std::string &name) {
    const auto allowed = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
               c == '_';
    };
    return !name.empty() && name.size() <= 100 && std::all_of(name.begin(), name.end(), allowed);
}

/// Of columns.
void check_names(const std::string &what, const std::vector<std::string> &names) {
    for (auto name = names.begin(); name != names.end(); ++name) {
        check_name(what, *name);
        const char first = name->front();
        if (!((first >= 'a' && first <= 'z') || (first >= 'A' && first <= 'Z')) || name->size() > 40)
            throw InputError("the name of " + what + " begins with a letter and has at most 40: '" + *name +
                             "'");
        if (std::find(names.begin(), name, *name) != name)
            throw InputError("two of the names are '" + *name + "': each names " + what);
    }
}

void check_aims(const Aims &aims) {
    std::vector<std::string> objectives, numbers;
    for (const Objective &objective : aims.objectives) objectives.push_back(objective.name);
    for (const DescriptorNumber &number : aims.descriptor) {
        numbers.push_back(number.name);
        if (number.cells == 0) continue;
        if (!(number.from < number.to) || !std::isfinite(number.to - number.from))
            throw InputError("descriptor " + number.name + ": from must be below to, not " +
                             to_text(number.from) + " and " + to_text(number.to));
        if (number.cells < 1 || number.cells > 10000)
            throw InputError("descriptor " + number.name + ": cells is 1 to 10000, not " +
                             to_text(number.cells));
    }
    check_names("an objective", objectives);
    check_names("a number of the descriptor", numbers);
}

} // namespace

NetworkShape shape_of(Actuation actuation) {
    return {input::count, output::count(actuation), is_recurrent(actuation)};
}

void check_name(const std::string &what, const std::string &name) {
    if (!is_file_name(name))
        throw InputError("the name of " + what + " is 1 to 100 letters, digits, '-' and '_', not '" + name +
                         "'");
}

namespace {

/// A loose object follows the nodes of one body in one world (decision 0024).
void check_object(const Spec &spec) {
    const auto has_object = [](const Environment &environment) { return environment.object.cells() > 0; };
    for (const Phase &phase : spec.phases)
        if (has_object(phase.environment))
            throw InputError(
                "a phase cannot have an object: only the first world of a setting without phases");
    if (has_object(spec.environment) && (!spec.phases.empty() || spec.damage))
        throw InputError("a setting with an object has neither phases nor damage");
}

} // namespace

void check_spec(const Spec &spec) {
    check_name("a setting", spec.name);
    if (!(spec.actuation_range >= 0 && spec.actuation_range <= 0.9))
        throw InputError("actuation_range is between 0 and 0.9 rest lengths, not " +
                         to_text(spec.actuation_range));
    if (!spec.judge) throw InputError("setting " + spec.name + " has no fitness, penalty and behaviour");
    if (spec.start && spec.start->generations < 1)
        throw InputError("start takes at least 1 generation, not " + to_text(spec.start->generations));
    if (spec.start && !spec.start->judge)
        throw InputError("the start of setting " + spec.name + " has no behaviour");
    make_search(spec.search, spec.parameters, spec.aims);
    check_aims(spec.aims);
    make_engine(spec.engine);
    check_environment(spec.environment);
    check_course(spec);
    check_object(spec);
    check_consistency(spec.parameters);
}

} // namespace planula

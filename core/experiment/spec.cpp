// SPDX-License-Identifier: MIT
#include "experiment/spec.h"

#include "base/error.h"
#include "base/text.h"
#include "evolution/search.h"
#include "physics/engine.h"

#include <algorithm>

namespace planula {

namespace {

bool is_file_name(const std::string &name) {
    const auto allowed = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
               c == '_';
    };
    return !name.empty() && name.size() <= 100 && std::all_of(name.begin(), name.end(), allowed);
}

} // namespace

const char *name_of(Recording recording) { return recording == Recording::full ? "full" : "sample"; }

NetworkShape shape_of(Actuation actuation) {
    return {input::count, output::count(actuation), is_recurrent(actuation)};
}

void check_name(const std::string &what, const std::string &name) {
    if (!is_file_name(name))
        throw InputError("the name of " + what + " is 1 to 100 letters, digits, '-' and '_', not '" + name +
                         "'");
}

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
    make_search(spec.search, spec.parameters);
    make_engine(spec.engine);
    check_environment(spec.environment);
    check_course(spec);
    check_consistency(spec.parameters);
}

} // namespace planula

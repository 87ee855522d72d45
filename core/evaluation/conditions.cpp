// SPDX-License-Identifier: MIT
#include "evaluation/conditions.h"

#include "base/error.h"
#include "base/text.h"

namespace planula {

namespace {

void check_step(const std::string &what, int at, int earliest, const GaitParameters &p) {
    if (at >= earliest && at < p.locomotion_steps && at % p.knot_interval == 0) return;
    throw InputError(what + " is a multiple of knot_interval (" + to_text(p.knot_interval) + "), at least " +
                     to_text(earliest) + " and less than locomotion_steps (" + to_text(p.locomotion_steps) +
                     "), not " + to_text(at));
}

} // namespace

void check_course(const Conditions &conditions) {
    const GaitParameters &p = conditions.parameters.gait;
    int earliest = p.knot_interval;
    for (std::size_t i = 0; i < conditions.phases.size(); ++i) {
        const Phase &phase = conditions.phases[i];
        const std::string name = "phases[" + to_text(static_cast<int>(i + 1)) + "]";
        check_step(name + ".at, the step that a phase begins with,", phase.at, earliest, p);
        check_environment(phase.environment);
        if (!(phase.actuation_range >= 0 && phase.actuation_range <= 0.9))
            throw InputError(name + ": actuation_range is between 0 and 0.9 rest lengths, not " +
                             to_text(phase.actuation_range));
        if (phase.settles && !(phase.environment.gravity > 0))
            throw InputError(name + ": settle = true needs gravity, without which no body settles");
        earliest = phase.at + p.knot_interval;
    }
    if (!conditions.damage) return;
    check_damage(*conditions.damage);
    check_step("damage.at, the step before which cells are lost,", conditions.damage->at, 0, p);
}

Parameters refined(Parameters p, int refinement) {
    p.development.time_step /= refinement;
    p.body.node_speed_limit /= refinement;
    for (int *steps :
         {&p.settling.settle_window, &p.settling.settle_limit, &p.gait.locomotion_steps, &p.gait.ramp_steps,
          &p.gait.knot_interval, &p.gait.update_interval, &p.gait.path_interval})
        *steps *= refinement;
    p.gait.period_shortest *= refinement;
    p.gait.period_longest *= refinement;
    return p;
}

} // namespace planula

// SPDX-License-Identifier: MIT
// The locomotion stage: settle → ramp → move (§2.5, 2.6; decisions 0008 to 0012).
#pragma once

#include "body/outcome.h"
#include "locomotion/course.h"
#include "locomotion/gait.h"
#include "physics/engine.h"

#include <functional>
#include <optional>
#include <vector>

namespace planula {

struct Trial {
    Outcome outcome = Outcome::viable;               // viable, never_settled or exploded
    int settle_steps = 0;                            // until the body was at rest; 0 without gravity
    Vec2d rest, finish;                              // centre of mass at rest and after the last step
    std::optional<Vec2d> object_rest, object_finish; // the same of a loose object, if there is one
    double activity = 0;                             // b_a of Eq. (5)
    // How much of all change of the signals was in the last quarter of locomotion; 0 if they never changed. With an
    // even rhythm 0.25, after a single contraction 0.
    double late_actuation = 0;
    // Centre of mass every path_interval steps from rest on. Where it jumps, because the body loses cells or is set on
    // another ground, path and finish go on from where it was.
    std::vector<Vec2d> path;
    std::vector<PhaseResult> phases; // of the first world and each further one; empty if there is but one
};

/// Called at rest (step 0) and after every step, with node positions, those of a loose object last, and each cell's
/// signal.
using MoveWatch =
    std::function<void(int step, std::span<const Vec2d> positions, std::span<const double> signal)>;

/// Is told what happens in a trial, and changes nothing of it. What it is handed outlives the trial.
class TrialObserver {
  public:
    virtual ~TrialObserver() = default;
    /// The body is at rest: locomotion begins. With each cell's signal.
    virtual void begin(const SoftBodyModel &model, const Environment &environment, const Engine &engine,
                       std::span<const double> signal) = 0;
    /// Another body or world from here on, muscles off: what is left of the body, or a further phase.
    virtual void change(const SoftBodyModel &model, const Environment &environment, const Engine &engine) = 0;
    /// As of Engine::actuate(): what the muscles do in the steps that follow.
    virtual void actuate(std::span<const double> extensions, int steps) = 0;
    /// After step t of locomotion, from 1 on.
    virtual void step(int t, const Engine &engine, std::span<const double> signal) = 0;
};

/// Loads the body into the engine, lets it settle if there is gravity, and moves it for locomotion_steps. Of the
/// parameters it reads those of settling and gait. A body that comes into a world with another ground is set on it,
/// straight up or down, as at first. A body that has no room where it is to start, or where it comes
/// into a world, has never settled (physics/room.h).
Trial locomote(const SoftBodyModel &model, const Environment &environment, double actuation_range,
               const Parameters &parameters, Gait &gait, Engine &engine, const MoveWatch &watch = {},
               TrialObserver *observer = nullptr, const Course &course = {});

} // namespace planula

// SPDX-License-Identifier: MIT
// Genome in, life out: development, embodiment and locomotion in one pure function. It draws no random
// number, reads no clock and keeps nothing between calls.
#pragma once

#include "body/body.h"
#include "development/embryo.h"
#include "evaluation/conditions.h"
#include "evaluation/life.h"
#include "genome/genome.h"
#include "locomotion/oscillator.h"

#include <functional>
#include <span>

namespace planula {

/// Functions that are called while an individual is simulated. Every member may be empty.
struct Watch {
    /// Development: the step, and the embryo (development frame). Called after decisions, and after the neighbourhood
    /// is computed, before the step's physics, and once at the end.
    std::function<void(int step, const Embryo &embryo)> grow;
    /// The finished body, before locomotion; and what is left of it, when it has lost cells.
    std::function<void(const Body &body)> born;
    /// Locomotion, after each `step` of 0 … locomotion_steps (0: at rest): node positions (world frame) and
    /// the actuation signal of each cell in [-1, 1] (oscillator: the sine).
    std::function<void(int step, std::span<const Vec2d> nodes, std::span<const double> signal)> move;
    /// After each call of `move`, where networks go on being updated in locomotion: the activations of the cells, as
    /// the newest update left them. An update for step t is there at step t, and for some steps before it.
    std::function<void(int step, const Activations &activations)> update;
};

/// A life under the same conditions whose body, driven by oscillators, began to move from these cell centres (of
/// development) with these oscillators; null if none is known. Its locomotion is the same.
using Recall =
    std::function<const Life *(std::span<const Vec2d> positions, std::span<const Oscillator> oscillators)>;

/// Locomotion that `recall` knows is not simulated, so that `watch` is not called for it.
Life live(const Genome &genome, const Conditions &conditions, const Watch &watch = {},
          const Recall &recall = {});

/// Development alone: the fields of a life that are known after growth, as live() gives them. The outcome is viable if
/// there is a body.
Life develop(const Genome &genome, const Conditions &conditions);

} // namespace planula

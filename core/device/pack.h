// SPDX-License-Identifier: MIT
// Trials packed for a device (device/task.h), and what it made of them unpacked.
#pragma once

#include "device/task.h"
#include "locomotion/trial.h"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace planula::device {

/// The input of the trial that locomote() would simulate with the native engine, one environment throughout; it begins
/// with its Task. Nothing where a device has no text for it: walls, a loose object, regions, a current that changes,
/// tilted gravity, networks whose inputs change, or a gait that is held still. The gait must not have begun.
std::optional<std::vector<std::byte>> pack(const SoftBodyModel &model, const Environment &environment,
                                           double actuation_range, const Parameters &parameters,
                                           const Gait &gait);

/// What a packed trial begins with.
Task task_of(std::span<const std::byte> input);

/// The trial of which a device made this result.
Trial unpack(std::span<const std::byte> input, std::span<const std::byte> result);

} // namespace planula::device

// SPDX-License-Identifier: MIT
// The rhythm of muscles: one period for all cells, and the phase of each (decision 0026). Signals are lists of one
// number for each cell, at times that are evenly apart.
#pragma once

#include "evaluation/observations.h"

#include <span>
#include <vector>

namespace planula {

/// The least correlation of signals with themselves, one period later, that counts as a rhythm.
inline constexpr double rhythm_level = 0.5;

/// The period of signals, in intervals: the lag at which they correlate with themselves, summed over cells, at a peak
/// of at least rhythm_level; of several peaks nearly as high as the highest, the first. A parabola through the peak and
/// its neighbours gives fractions. 0 without such a peak at up to half the time, and for signals that do not change.
double period_of(std::span<const std::vector<double>> signals);

/// The phase of each cell by its Fourier component at this period, 2 or more, over the last whole periods, less that of
/// the first cell: how far it is ahead, -0.5 to 0.5 of a period. 0 for a cell whose signal does not change.
std::vector<double> phases_of(std::span<const std::vector<double>> signals, double period);

} // namespace planula

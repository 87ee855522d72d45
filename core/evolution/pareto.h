// SPDX-License-Identifier: MIT
// Ranks of solutions with several objectives, as in NSGA-II (Deb, Pratap, Agarwal & Meyarivan 2002, "A fast and elitist
// multiobjective genetic algorithm: NSGA-II", IEEE Trans. Evol. Comput. 6(2):182–197): fronts of solutions that do not
// dominate each other (§III.A) and the crowding distance within a front (§III.B). Objectives are maximised. Nothing is
// known of what they mean.
#pragma once

#include <span>
#include <vector>

namespace planula {

/// The objectives of one solution; empty if it is not feasible. All feasible solutions have the same number.
using Objectives = std::vector<double>;

/// Constrained domination (§VI.A): a feasible solution dominates one that is not; of two feasible ones, one that is
/// nowhere lower and somewhere higher; of two that are not feasible, neither dominates.
bool dominates(const Objectives &a, const Objectives &b);

/// All solutions, front by front, each in ascending order of index.
std::vector<std::vector<int>> non_dominated_fronts(std::span<const Objectives> solutions);

/// The crowding distance of each solution of a front: over the objectives, the sum of the gaps between its neighbours
/// in that objective, each divided by the range that the front covers; infinite at either end. Equals are neighbours in
/// order of the front; an objective in which all are equal adds nothing between.
std::vector<double> crowding_distances(std::span<const Objectives> solutions, std::span<const int> front);

} // namespace planula

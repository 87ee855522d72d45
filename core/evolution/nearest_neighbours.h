// SPDX-License-Identifier: MIT
// The nearest points of a growing set: a k-d tree (Bentley 1975, Friedman, Bentley & Finkel 1977) and a list of points
// that were added later; the tree is built again when they have become many. No point is ever removed.
//
// The answer is that of a search through all points, to the bit: order is by squared distance, summed over the
// coordinates from first to last, and among equals by index. A branch of the tree is passed over only if its box is
// farther than the last neighbour; the distance to the box is summed in the same order, and rounding is monotonic, so
// that it never exceeds the computed distance of a point inside.
#pragma once

#include <compare>
#include <cstddef>
#include <span>
#include <vector>

namespace planula {

struct Neighbour {
    double squared = 0; // distance
    std::size_t index = 0;
    auto operator<=>(const Neighbour &) const = default;
};

/// Σ (a_i − b_i)², from first to last.
inline double squared_distance(std::span<const double> a, std::span<const double> b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
    return sum;
}

/// The k first of the neighbours offered, in ascending order.
class NearestNeighbours {
  public:
    explicit NearestNeighbours(int k) : k_(static_cast<std::size_t>(k)) {}

    void offer(Neighbour neighbour) {
        if (open_to(neighbour.squared)) insert(neighbour);
    }
    /// Whether one at this distance could still be among them.
    bool open_to(double squared) const {
        return neighbours_.size() < k_ || !(squared > neighbours_.back().squared);
    }
    const std::vector<Neighbour> &list() const { return neighbours_; }

  private:
    void insert(Neighbour neighbour);

    std::size_t k_;
    std::vector<Neighbour> neighbours_;
};

class PointIndex {
  public:
    std::size_t size() const { return dimensions_ == 0 ? 0 : points_.size() / dimensions_; }
    /// Adds a finite point; all have one length, at least 1. Its index is the number of those before it.
    void add(std::span<const double> point);
    /// Offers the nearest points to a place, their indices counted from `first_index`.
    void offer(std::span<const double> place, std::size_t first_index, NearestNeighbours &nearest) const;

  private:
    /// Points begin … end - 1 of the tree, in a box; a leaf has no branches.
    struct Branch {
        std::size_t begin, end;
        int lower = -1, upper = -1;
    };
    std::span<const double> point(std::size_t index) const;
    void build();
    int build(std::size_t begin, std::size_t end);
    std::size_t enclose(std::size_t begin, std::size_t end);
    double squared_distance_to(const Branch &branch, std::span<const double> place) const;
    void offer(int branch, std::span<const double> place, std::size_t first_index,
               NearestNeighbours &nearest) const;

    std::size_t dimensions_ = 0;
    std::vector<double> points_;      // in order of index
    std::vector<std::size_t> sorted_; // the indices of those in the tree, branch by branch
    std::vector<double> placed_;      // their coordinates, in that order
    std::vector<Branch> branches_;    // the first is the root
    std::vector<double> boxes_;       // of each branch: lowest and highest of every coordinate
};

} // namespace planula

// SPDX-License-Identifier: MIT
#include "evolution/nearest_neighbours.h"

#include "base/check.h"

#include <algorithm>
#include <utility>

namespace planula {

namespace {

constexpr std::size_t leaf_size = 16;
// The number of points outside the tree after which it is built again.
std::size_t patience(std::size_t in_tree) { return 64 + in_tree / 32; }

} // namespace

void NearestNeighbours::insert(Neighbour neighbour) {
    if (neighbours_.size() == k_) {
        if (!(neighbour < neighbours_.back())) return;
        neighbours_.pop_back();
    }
    neighbours_.insert(std::upper_bound(neighbours_.begin(), neighbours_.end(), neighbour), neighbour);
}

std::span<const double> PointIndex::point(std::size_t index) const {
    return std::span(points_).subspan(index * dimensions_, dimensions_);
}

void PointIndex::add(std::span<const double> point) {
    if (dimensions_ == 0) dimensions_ = point.size();
    CHECK(!point.empty() && point.size() == dimensions_, point.size(), dimensions_);
    points_.insert(points_.end(), point.begin(), point.end());
    if (size() - sorted_.size() > patience(sorted_.size())) build();
}

void PointIndex::build() {
    sorted_.resize(size());
    for (std::size_t i = 0; i < sorted_.size(); ++i) sorted_[i] = i;
    branches_.clear();
    boxes_.clear();
    build(0, sorted_.size());
    placed_.clear();
    for (const std::size_t index : sorted_)
        placed_.insert(placed_.end(), point(index).begin(), point(index).end());
}

/// Halves the points along the longest side of their box until a leaf can hold them.
int PointIndex::build(std::size_t begin, std::size_t end) {
    const int branch = static_cast<int>(branches_.size());
    branches_.push_back({begin, end});
    const std::size_t side = enclose(begin, end);
    if (end - begin <= leaf_size) return branch;

    const std::size_t middle = begin + (end - begin) / 2;
    const auto at = [&](std::size_t place) { return sorted_.begin() + static_cast<std::ptrdiff_t>(place); };
    std::nth_element(at(begin), at(middle), at(end), [&](std::size_t a, std::size_t b) {
        return std::pair(point(a)[side], a) < std::pair(point(b)[side], b);
    });
    const int lower = build(begin, middle), upper = build(middle, end);
    branches_[branch].lower = lower;
    branches_[branch].upper = upper;
    return branch;
}

/// Records the box of these points; returns the coordinate of its longest side.
std::size_t PointIndex::enclose(std::size_t begin, std::size_t end) {
    std::size_t longest = 0;
    double length = -1;
    for (std::size_t i = 0; i < dimensions_; ++i) {
        double low = point(sorted_[begin])[i], high = low;
        for (std::size_t place = begin; place < end; ++place) {
            low = std::min(low, point(sorted_[place])[i]);
            high = std::max(high, point(sorted_[place])[i]);
        }
        boxes_.insert(boxes_.end(), {low, high});
        if (high - low > length) length = high - low, longest = i;
    }
    return longest;
}

double PointIndex::squared_distance_to(const Branch &branch, std::span<const double> place) const {
    const double *box = &boxes_[static_cast<std::size_t>(&branch - branches_.data()) * 2 * dimensions_];
    double sum = 0;
    for (std::size_t i = 0; i < dimensions_; ++i, box += 2) {
        const double gap = place[i] < box[0] ? box[0] - place[i] : place[i] > box[1] ? place[i] - box[1] : 0;
        sum += gap * gap;
    }
    return sum;
}

void PointIndex::offer(int branch, std::span<const double> place, std::size_t first_index,
                       NearestNeighbours &nearest) const {
    const Branch &here = branches_[branch];
    if (here.lower < 0) {
        for (std::size_t at = here.begin; at < here.end; ++at)
            nearest.offer({squared_distance(place, std::span(placed_).subspan(at * dimensions_, dimensions_)),
                           first_index + sorted_[at]});
        return;
    }
    // The nearer half first: then the other is often passed over.
    std::pair near(squared_distance_to(branches_[here.lower], place), here.lower);
    std::pair far(squared_distance_to(branches_[here.upper], place), here.upper);
    if (far < near) std::swap(near, far);
    for (const auto &[squared, half] : {near, far})
        if (nearest.open_to(squared)) offer(half, place, first_index, nearest);
}

void PointIndex::offer(std::span<const double> place, std::size_t first_index,
                       NearestNeighbours &nearest) const {
    if (size() == 0) return;
    CHECK(place.size() == dimensions_, place.size(), dimensions_);
    if (!branches_.empty()) offer(0, place, first_index, nearest);
    for (std::size_t index = sorted_.size(); index < size(); ++index)
        nearest.offer({squared_distance(place, point(index)), first_index + index});
}

} // namespace planula

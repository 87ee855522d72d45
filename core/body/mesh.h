// SPDX-License-Identifier: MIT
// Which cells are neighbours: links and triangles over cell centres, and the outline they bound. Cells are
// indices into the positions, in ascending order of cell id.
#pragma once

#include "base/vec2.h"

#include <span>
#include <vector>

namespace planula {

/// An undirected link, a < b.
struct Link {
    int a = 0, b = 0;
    friend auto operator<=>(const Link &, const Link &) = default;
};

/// A triangle, counter-clockwise, the lowest index first.
struct Triangle {
    int a = 0, b = 0, c = 0;
    friend auto operator<=>(const Triangle &, const Triangle &) = default;
};

struct Mesh {
    std::vector<Link> links;         // ascending
    std::vector<Triangle> triangles; // ascending; their sides are links
};

/// A link on the outline: in exactly one triangle, and then directed from a to b with the body on the left,
/// or in none, and then directed from the lower to the higher index.
struct OutlineLink {
    int a = 0, b = 0;
    bool solid = false; // in a triangle
};

/// The outline, ordered by the lower, then the higher index of each link's ends.
std::vector<OutlineLink> outline(const Mesh &mesh);

/// For each cell its neighbours by links, ascending.
class Neighbours {
  public:
    Neighbours() = default;
    /// Of `count` cells with these links, ascending.
    Neighbours(std::span<const Link> links, int count);

    std::span<const int> operator[](int cell) const {
        return {lists_.data() + first_[cell], static_cast<std::size_t>(first_[cell + 1] - first_[cell])};
    }

  private:
    std::vector<int> first_; // place of each cell's list in lists_, and the end
    std::vector<int> lists_;
};

} // namespace planula

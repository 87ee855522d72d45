// SPDX-License-Identifier: MIT
// The Delaunay triangulation of points that move: kept as long as it is valid, and repaired by exchanging edges where
// it is not (Lawson 1977). New points are inserted by removing the faces in whose circles they lie (Bowyer 1981, Watson
// 1981). The result is delaunay() of the same points, whatever was done before.
#pragma once

#include "geometry/delaunay.h"

#include <span>
#include <vector>

namespace planula {

class MovingDelaunay {
  public:
    /// Of new points; as delaunay().
    void start(std::span<const Vec2d> points);
    /// The same points at new, finite places, and any number of points more: as delaunay() of them, in less time.
    /// False if points have moved so far past each other that a few exchanged edges do not repair it, there are no
    /// faces or points coincide. Then start() must be called again, and points may coincide; else they do not.
    bool follow(std::span<const Vec2d> points);

    const Edges &edges() const { return edges_; }
    Triangles triangles() const { return triangles_of(faces_, points_.size()); }
    /// False only if edges and triangles are those before the last start() or follow().
    bool has_changed() const { return changed_; }

  private:
    /// Whether a triangulation whose points have moved needed a repair, and whether it could be made.
    enum class Repair { unneeded, done, failed };
    struct Edge {
        int face, corner; // the edge of a face that is opposite to one of its corners
    };
    struct Rim {
        int face, corner; // of a face outside the cavity, whose edge opposite to that corner is on its rim
        int from, to;     // the ends of that edge, with the cavity on its left
    };

    /// A face as its points lie now: at each corner the scalar product of the edges that leave it; their vector
    /// product, which is the same at all corners; and the sum of all squared edges, against which errors of rounding
    /// are small.
    struct Shape {
        std::array<double, 3> dot;
        double cross, size;
    };

    Vec2d at(int face, int corner) const { return points_[faces_[face].corner[corner]]; }
    void measure(int face);
    bool turns_left(int face) const;
    void flip(const Edge &edge);
    bool exchange(const Edge &edge);
    Repair repair_faces();
    Repair repair_hull();
    Repair repair();
    bool must_flip(const Edge &edge) const;
    bool make_delaunay();

    bool insert(Vec2d point);
    int locate(Vec2d point) const;
    bool encircles(int face, Vec2d point) const;
    void find_cavity(int face, Vec2d point);
    void fill_cavity(int vertex);

    std::vector<Vec2d> points_;
    std::vector<Face> faces_;
    std::vector<Shape> shapes_; // of finite faces, while points are followed
    Edges edges_;
    bool changed_ = false;
    int latest_ = 0; // a face

    // Working space.
    std::vector<Edge> to_check_;
    std::vector<int> cavity_;     // faces
    std::vector<char> in_cavity_; // per face
    std::vector<Rim> rim_;
    // Per vertex, infinity first: the new face whose rim goes from it, and to it.
    std::vector<int> face_from_, face_to_;
};

} // namespace planula

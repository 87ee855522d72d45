// SPDX-License-Identifier: MIT
#include "geometry/moving_delaunay.h"

#include "base/check.h"
#include "geometry/predicates.h"

#include <algorithm>

namespace planula {

namespace {

/// Errors of rounding are below this share of squared lengths, or of their products: a few times 2^-53.
constexpr double rounding = 1e-13;

/// The corners after and before one, counter-clockwise.
int next(int corner) { return corner == 2 ? 0 : corner + 1; }
int previous(int corner) { return corner == 0 ? 2 : corner - 1; }

int index_of(int what, const std::array<int, 3> &among) {
    return among[0] == what ? 0 : among[1] == what ? 1 : 2;
}
bool holds(const std::array<int, 3> &among, int what) { return among[index_of(what, among)] == what; }

bool is_finite(const Face &face) { return !holds(face.corner, Face::infinity); }

/// The corner of the face beyond that is opposite to their common edge.
int mirrored(const Face &face, int corner, const Face &beyond) {
    return next(index_of(face.corner[next(corner)], beyond.corner));
}

} // namespace

void MovingDelaunay::start(std::span<const Vec2d> points) {
    points_.assign(points.begin(), points.end());
    faces_ = delaunay_faces(points);
    edges_ = faces_.empty() ? delaunay(points).edges : edges_of(faces_, points.size());
    changed_ = true;
    latest_ = 0;
}

bool MovingDelaunay::follow(std::span<const Vec2d> points) {
    if (faces_.empty()) return false;
    CHECK(points.size() >= points_.size(), points.size(), points_.size());
    std::copy_n(points.begin(), points_.size(), points_.begin());
    shapes_.resize(faces_.size());
    for (int face = 0; face < static_cast<int>(faces_.size()); ++face) measure(face);
    const Repair result = repair();
    if (result == Repair::failed) return false;
    changed_ = make_delaunay() || result == Repair::done || points.size() > points_.size();
    while (points_.size() < points.size())
        if (!insert(points[points_.size()])) return false;
    if (changed_) edges_ = edges_of(faces_, points_.size());
    return true;
}

void MovingDelaunay::measure(int face) {
    if (!is_finite(faces_[face])) return;
    const Vec2d a = at(face, 0), b = at(face, 1), c = at(face, 2);
    const Vec2d ab = b - a, bc = c - b, ca = a - c;
    shapes_[face] = {{-dot(ab, ca), -dot(bc, ab), -dot(ca, bc)},
                     cross(bc, ca),
                     squared_length(ab) + squared_length(bc) + squared_length(ca)};
}

/// Whether a finite face is counter-clockwise.
bool MovingDelaunay::turns_left(int face) const {
    return shapes_[face].cross > rounding * shapes_[face].size ||
           exact::turn(at(face, 0), at(face, 1), at(face, 2)) > 0;
}

/// Exchanges an edge for the other diagonal of its two faces.
void MovingDelaunay::flip(const Edge &edge) {
    const int one = edge.face, other = faces_[one].beyond[edge.corner];
    Face &f = faces_[one], &g = faces_[other];
    // The edge goes from a to b in f, whose third corner is p, and from b to a in g, whose third corner is q.
    const int p = edge.corner, a = next(p), b = next(a);
    const int q = mirrored(f, p, g), gb = next(q), ga = next(gb);
    const int beyond_bp = f.beyond[a], beyond_aq = g.beyond[gb];

    // f becomes p, a, q and g becomes q, b, p.
    f.corner[b] = g.corner[q], g.corner[ga] = f.corner[p];
    f.beyond[p] = beyond_aq, f.beyond[a] = other;
    g.beyond[q] = beyond_bp, g.beyond[gb] = one;
    auto &behind_aq = faces_[beyond_aq].beyond, &behind_bp = faces_[beyond_bp].beyond;
    behind_aq[index_of(other, behind_aq)] = one;
    behind_bp[index_of(one, behind_bp)] = other;
    measure(one), measure(other);
}

/// Flips an edge; the new one may lead to infinity. False if its ends are linked already.
bool MovingDelaunay::exchange(const Edge &edge) {
    const Face &face = faces_[edge.face], &other = faces_[face.beyond[edge.corner]];
    const int p = face.corner[edge.corner], q = other.corner[mirrored(face, edge.corner, other)];
    const auto links_them = [&](const Face &any) { return holds(any.corner, p) && holds(any.corner, q); };
    if (std::any_of(faces_.begin(), faces_.end(), links_them)) return false;
    flip(edge);
    return true;
}

/// Exchanges edges that a corner has crossed: of a face that has turned over, the longest.
MovingDelaunay::Repair MovingDelaunay::repair_faces() {
    Repair result = Repair::unneeded;
    for (int face = 0; face < static_cast<int>(faces_.size()); ++face) {
        if (!is_finite(faces_[face]) || turns_left(face)) continue;
        std::array<double, 3> squared;
        for (int i = 0; i < 3; ++i) squared[i] = squared_length(at(face, next(i)) - at(face, previous(i)));
        const auto longest = std::max_element(squared.begin(), squared.end()) - squared.begin();
        if (!exchange({face, static_cast<int>(longest)})) return Repair::failed;
        result = Repair::done;
    }
    return result;
}

/// Fills the corners at which the hull turns inwards. Fails if the hull does not go round once.
MovingDelaunay::Repair MovingDelaunay::repair_hull() {
    Repair result = Repair::unneeded;
    int eastmost = 0, face = 0;
    const auto left =
        std::count_if(faces_.begin(), faces_.end(), [](const Face &f) { return !is_finite(f); });
    while (is_finite(faces_[face])) ++face;
    for (auto i = left; i > 0; --i) {
        // Three points in turn, clockwise.
        const int outside = index_of(Face::infinity, faces_[face].corner);
        const int following = faces_[face].beyond[next(outside)];
        const Vec2d first = at(face, next(outside)), second = at(face, previous(outside)),
                    third = at(following, previous(index_of(Face::infinity, faces_[following].corner)));
        if (exact::turn(first, second, third) > 0) {
            if (!exchange({face, next(outside)})) return Repair::failed;
            result = Repair::done;
        }
        const auto is_west = [](Vec2d a, Vec2d b) { return a.x < b.x || (a.x == b.x && a.y < b.y); };
        eastmost += is_west(first, second) && is_west(third, second);
        face = following;
    }
    return result == Repair::unneeded && eastmost != 1 ? Repair::failed : result;
}

/// Exchanges edges until all faces are counter-clockwise inside a hull that turns nowhere inwards and goes round once:
/// then it is a triangulation.
MovingDelaunay::Repair MovingDelaunay::repair() {
    constexpr int attempts = 8;
    for (int i = 0; i < attempts; ++i) {
        const Repair faces = repair_faces();
        const Repair hull = faces == Repair::failed ? faces : repair_hull();
        if (hull == Repair::failed) return hull;
        if (faces == Repair::unneeded && hull == Repair::unneeded) return i == 0 ? hull : Repair::done;
    }
    return Repair::failed;
}

/// Whether a corner of one face beside this edge lies in the circle of the other.
bool MovingDelaunay::must_flip(const Edge &edge) const {
    const Face &face = faces_[edge.face], &other = faces_[face.beyond[edge.corner]];
    if (!is_finite(face) || !is_finite(other)) return false;
    // Not if the angles opposite to the edge are less than half a turn together: if the sum of their cotangents is
    // positive.
    const int opposite = mirrored(face, edge.corner, other);
    const Shape &one = shapes_[edge.face], &two = shapes_[face.beyond[edge.corner]];
    const double sum = one.dot[edge.corner] * two.cross + two.dot[opposite] * one.cross;
    if (sum > rounding * one.size * two.size) return false;
    return exact::in_circle(at(edge.face, 0), at(edge.face, 1), at(edge.face, 2),
                            points_[other.corner[opposite]]);
}

/// Flips edges until none must be. Returns whether any was.
bool MovingDelaunay::make_delaunay() {
    bool flipped = false;
    const auto check = [&](const Edge &edge) {
        if (!must_flip(edge)) return;
        const int other = faces_[edge.face].beyond[edge.corner];
        flip(edge);
        flipped = true;
        // The four edges around are checked again. Entries for edges of these two faces are still edges of them.
        for (int i = 0; i < 3; ++i) {
            if (faces_[edge.face].beyond[i] != other) to_check_.push_back({edge.face, i});
            if (faces_[other].beyond[i] != edge.face) to_check_.push_back({other, i});
        }
    };
    for (int face = 0; face < static_cast<int>(faces_.size()); ++face)
        for (int i = 0; i < 3; ++i)
            if (faces_[face].beyond[i] > face) check({face, i});
    while (!to_check_.empty()) {
        const Edge edge = to_check_.back();
        to_check_.pop_back();
        check(edge);
    }
    return flipped;
}

/// False if there is a point at this place already.
bool MovingDelaunay::insert(Vec2d point) {
    const int face = locate(point);
    if (is_finite(faces_[face]))
        for (int i = 0; i < 3; ++i)
            if (at(face, i) == point) return false;
    find_cavity(face, point);
    points_.push_back(point);
    fill_cavity(static_cast<int>(points_.size()) - 1);
    return true;
}

/// The face that holds a point, or one to infinity whose edge of the hull it lies outside of: from the latest one
/// always across an edge that the point is beyond.
int MovingDelaunay::locate(Vec2d point) const {
    int face = latest_, corner = 0;
    if (!is_finite(faces_[face])) face = faces_[face].beyond[index_of(Face::infinity, faces_[face].corner)];
    while (is_finite(faces_[face]) && corner < 3) {
        if (exact::turn(at(face, next(corner)), at(face, previous(corner)), point) < 0)
            face = faces_[face].beyond[corner], corner = 0;
        else
            ++corner;
    }
    return face;
}

/// Whether a point lies in the circle of a face; of one to infinity, outside of its edge or on it.
bool MovingDelaunay::encircles(int face, Vec2d point) const {
    if (is_finite(faces_[face])) return exact::in_circle(at(face, 0), at(face, 1), at(face, 2), point);
    const int outside = index_of(Face::infinity, faces_[face].corner);
    const Vec2d from = at(face, next(outside)), to = at(face, previous(outside));
    const int side = exact::turn(from, to, point);
    const auto between = [](double a, double b, double c) { return (a < b && b < c) || (c < b && b < a); };
    return side > 0 || (side == 0 && (between(from.x, point.x, to.x) || between(from.y, point.y, to.y)));
}

/// The cavity: all faces, this one among them, whose circles hold a point; and its rim.
void MovingDelaunay::find_cavity(int face, Vec2d point) {
    in_cavity_.assign(faces_.size(), 0);
    cavity_.assign(1, face), rim_.clear();
    in_cavity_[face] = 1;
    for (std::size_t i = 0; i < cavity_.size(); ++i)
        for (int corner = 0; corner < 3; ++corner) {
            const Face &inside = faces_[cavity_[i]];
            const int outside = inside.beyond[corner];
            if (in_cavity_[outside]) continue;
            if (encircles(outside, point))
                cavity_.push_back(outside), in_cavity_[outside] = 1;
            else
                rim_.push_back({outside, mirrored(inside, corner, faces_[outside]),
                                inside.corner[next(corner)], inside.corner[previous(corner)]});
        }
}

/// Joins a new vertex with the rim of the cavity.
void MovingDelaunay::fill_cavity(int vertex) {
    face_from_.resize(points_.size() + 1), face_to_.resize(points_.size() + 1);
    cavity_.push_back(static_cast<int>(faces_.size())),
        cavity_.push_back(static_cast<int>(faces_.size()) + 1);
    faces_.resize(faces_.size() + 2);
    CHECK(cavity_.size() == rim_.size(), cavity_.size(), rim_.size());
    for (std::size_t i = 0; i < rim_.size(); ++i)
        face_from_[rim_[i].from + 1] = face_to_[rim_[i].to + 1] = cavity_[i];
    for (std::size_t i = 0; i < rim_.size(); ++i) {
        const auto &[outside, corner, from, to] = rim_[i];
        faces_[cavity_[i]] = {{vertex, from, to}, {outside, face_from_[to + 1], face_to_[from + 1]}};
        faces_[outside].beyond[corner] = cavity_[i];
    }
    latest_ = cavity_[0];
}

} // namespace planula

// SPDX-License-Identifier: MIT
#include "analysis/life_scene.h"

#include "analysis/svg.h"
#include "base/check.h"
#include "base/text.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace planula {

namespace {

using svg::number, svg::point;

constexpr const char *air = "#f7f6f2", *water = "#dcebf3", *region_fill = "#b9d9ea", *region_edge = "#6f9db6",
                     *solid = "#d9d3c7", *solid_edge = "#857c6c", *rim = "#2b3036", *body_fill = "#c9cdd1",
                     *object_fill = "#8d8577", *plain = "#a9b7c4", *way = "#3c434a";

struct Colour {
    double red, green, blue;
};

/// The colour at a share of the way along these, as #rrggbb.
template <std::size_t count> std::string along(const std::array<Colour, count> &stops, double share) {
    const double place = std::clamp(share, 0.0, 1.0) * (count - 1);
    const auto low = std::min(static_cast<std::size_t>(place), count - 2);
    const Colour &a = stops[low], &b = stops[low + 1];
    const double part = place - static_cast<double>(low);
    std::string text = "#";
    for (const double level : {a.red + part * (b.red - a.red), a.green + part * (b.green - a.green),
                               a.blue + part * (b.blue - a.blue)}) {
        const int value = static_cast<int>(level + 0.5);
        constexpr std::string_view digits = "0123456789abcdef";
        text.append(1, digits[static_cast<std::size_t>(value / 16)]);
        text.append(1, digits[static_cast<std::size_t>(value % 16)]);
    }
    return text;
}

/// From -1, red, over grey to 1, blue (after RdBu, Harrower & Brewer 2003).
std::string signed_colour(double value) {
    constexpr std::array<Colour, 5> stops{
        {{179, 36, 47}, {231, 155, 132}, {235, 233, 228}, {127, 176, 214}, {31, 95, 168}}};
    return along(stops, (value + 1) / 2);
}
/// viridis (Smith & van der Walt 2015), from 0 to 1.
std::string ordered_colour(double share) {
    constexpr std::array<Colour, 6> stops{
        {{68, 1, 84}, {65, 68, 135}, {42, 120, 142}, {34, 168, 132}, {122, 209, 81}, {253, 231, 37}}};
    return along(stops, share);
}

std::string rectangle(Vec2d low, Vec2d high, const std::string &style) {
    return "<rect x=\"" + number(low.x) + "\" y=\"" + number(low.y) + "\" width=\"" + number(high.x - low.x) +
           "\" height=\"" + number(high.y - low.y) + "\" " + style + "/>\n";
}
std::string fill(const std::string &colour) { return "fill=\"" + colour + "\""; }

std::string polygon(const std::vector<Vec2d> &points, const View &view) {
    std::string way_of;
    for (const Vec2d place : points) way_of += (way_of.empty() ? "M " : " L ") + point(view.pixel(place));
    return "<path d=\"" + way_of + " Z\" " + fill(solid) + " stroke=\"" + solid_edge +
           "\" stroke-width=\"1.5\"/>\n";
}

/// A line of ground or ceiling from left of the picture to right of it, closed at a height.
std::string surface(const std::vector<Vec2d> &line, double height, const View &view) {
    const double reach = view.width / 2 / view.scale + 1, left = view.centre.x - reach,
                 right = view.centre.x + reach;
    std::vector<Vec2d> points{{left, height}, {left, height_of(line, left)}};
    for (const Vec2d corner : line)
        if (corner.x > left && corner.x < right) points.push_back(corner);
    points.push_back({right, height_of(line, right)});
    points.push_back({right, height});
    return polygon(points, view);
}

std::string draw_region(const Region &region, const View &view) {
    const double far = 1e6; // pixels
    const Vec2d low = view.pixel({region.box.left, region.box.top}),
                high = view.pixel({region.box.right, region.box.bottom});
    const bool is_wet = region.drag_normal > 0 || region.drag_tangential > 0;
    return rectangle({std::clamp(low.x, -far, far), std::clamp(low.y, -far, far)},
                     {std::clamp(high.x, -far, far), std::clamp(high.y, -far, far)},
                     fill(is_wet ? region_fill : air) + " fill-opacity=\"0.6\" stroke=\"" + region_edge +
                         "\" stroke-dasharray=\"5 4\"");
}

/// Links and nodes of a body as round strokes of one colour, `more` pixels wider than these.
std::string mass(const Moment &moment, double radius, double more, const std::string &colour,
                 const View &view) {
    std::string links, nodes;
    for (const auto &[a, b] : moment.links)
        links += "M " + point(view.pixel(moment.nodes[static_cast<std::size_t>(a)])) + " L " +
                 point(view.pixel(moment.nodes[static_cast<std::size_t>(b)])) + " ";
    for (const Vec2d node : moment.nodes) nodes += "M " + point(view.pixel(node)) + " h 0.01 ";
    const auto stroke = [&](const std::string &d, double width) {
        return "<path d=\"" + d + "\" fill=\"none\" stroke=\"" + colour + "\" stroke-width=\"" +
               number(width) + "\" stroke-linecap=\"round\"/>\n";
    };
    const double r = radius * view.scale;
    return (links.empty() ? "" : stroke(links, 2 * (0.8 * r + more))) + stroke(nodes, 2 * (r + more));
}

} // namespace

Moment moment_of(const GrowthFrame &frame, const LifeRecording &recording) {
    Moment moment{frame.cells, {}, {}};
    const auto place = [&](int id) {
        return static_cast<int>(std::lower_bound(frame.ids.begin(), frame.ids.end(), id) - frame.ids.begin());
    };
    for (const auto &[a, b] : frame.links) moment.links.push_back({place(a), place(b)});
    for (const int id : frame.ids)
        moment.colours.push_back(ordered_colour(id / std::max(1.0, recording.life.births - 1.0)));
    return moment;
}

Moment moment_of(const GaitFrame &frame, const LifeRecording &recording) {
    const auto at = static_cast<std::size_t>(&frame - recording.gait.data());
    const auto next = std::find_if(recording.bodies.begin(), recording.bodies.end(),
                                   [&](const RecordedBody &each) { return each.first_frame > at; });
    CHECK(next != recording.bodies.begin());
    const RecordedBody &body = *(next - 1);
    Moment moment{frame.nodes, body.links, {}};
    const int first = static_cast<int>(body.ids.size());
    for (const auto &[a, b] : recording.worlds.front().environment.object.mesh.links)
        moment.links.push_back({a + first, b + first});
    for (std::size_t cell = 0; cell < body.ids.size(); ++cell)
        moment.colours.push_back(frame.signals.empty() ? plain : signed_colour(frame.signals[cell]));
    return moment;
}

const Environment &world_at(int step, const LifeRecording &recording) {
    const Environment *world = &recording.worlds.front().environment;
    for (const RecordedWorld &each : recording.worlds)
        if (each.first_step <= step) world = &each.environment;
    return *world;
}

std::string draw_world(const Environment *world, const View &view) {
    const bool is_wet = world && (world->drag_normal > 0 || world->drag_tangential > 0);
    std::string text = rectangle({0, 0}, {view.width, view.height}, fill(is_wet ? water : air));
    if (!world) return text;
    for (const Region &region : world->regions) text += draw_region(region, view);
    const double reach = view.height / 2 / view.scale + 1;
    for (const Obstacle &obstacle : world->obstacles) text += polygon(obstacle.points, view);
    if (world->has_ground) text += surface(world->ground, view.centre.y - reach, view);
    if (!world->ceiling.empty()) text += surface(world->ceiling, view.centre.y + reach, view);
    return text;
}

std::string draw_path(const std::vector<Vec2d> &path, const View &view) {
    if (path.empty()) return "";
    std::string line;
    for (const Vec2d place : path) line += (line.empty() ? "M " : " L ") + point(view.pixel(place));
    const std::string stroke = " stroke=\"" + std::string(way) + "\" stroke-width=\"1.5\"";
    const Vec2d start = view.pixel(path.front());
    return "<path d=\"" + line + "\" fill=\"none\" stroke-linejoin=\"round\"" + stroke + "/>\n<circle cx=\"" +
           number(start.x) + "\" cy=\"" + number(start.y) + "\" r=\"3.5\" " + fill(air) + stroke + "/>\n";
}

std::string draw_body(const Moment &moment, double cell_radius, const View &view) {
    const double wide = std::max(1.0, 0.07 * view.scale);
    std::string text =
        mass(moment, cell_radius, wide, rim, view) + mass(moment, cell_radius, 0, body_fill, view);
    for (std::size_t node = 0; node < moment.nodes.size(); ++node) {
        const Vec2d at = view.pixel(moment.nodes[node]);
        text += "<circle cx=\"" + number(at.x) + "\" cy=\"" + number(at.y) + "\" r=\"" +
                to_fixed(0.86 * cell_radius * view.scale, 2) + "\" " +
                fill(node < moment.colours.size() ? moment.colours[node] : object_fill) + "/>\n";
    }
    return text;
}

std::string draw_scale(const View &view) {
    double cells = 1;
    for (const double longer : {2.0, 5.0, 10.0, 20.0, 50.0, 100.0, 200.0, 500.0, 1000.0})
        if (longer * view.scale <= std::min(120.0, 0.4 * view.width)) cells = longer;
    const double width = cells * view.scale, y = view.height - 10;
    return "<path d=\"M 10 " + number(y - 4) + " V " + number(y) + " H " + number(10 + width) + " V " +
           number(y - 4) + "\" fill=\"none\" stroke=\"" + std::string(svg::ink) +
           "\" stroke-width=\"1.5\"/>\n" +
           svg::text({10 + width / 2, y - 7}, "middle", 11, counted(cells, "cell"));
}

} // namespace planula

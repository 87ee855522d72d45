// SPDX-License-Identifier: MIT
#include "analysis/life_picture.h"

#include "analysis/life_scene.h"
#include "analysis/svg.h"
#include "base/text.h"
#include "body/body.h"

#include <algorithm>
#include <cmath>

namespace planula {

namespace {

using svg::number;

// Lengths are pixels.
constexpr double width = 1200, margin = 24, gap = 10, small_height = 170;
constexpr int columns = 6;
constexpr double small_width = (width - 2 * margin - (columns - 1) * gap) / columns;
constexpr double film_width = 800, film_height = 450;

/// A part of a picture with its own coordinates, cut at its edges.
std::string panel(Vec2d at, const View &view, const std::string &content) {
    const std::string size = "width=\"" + number(view.width) + "\" height=\"" + number(view.height) + "\"";
    return "<svg x=\"" + number(at.x) + "\" y=\"" + number(at.y) + "\" " + size + ">\n" + content +
           "</svg>\n";
}

double reach_of(const std::vector<Vec2d> &nodes, std::size_t cells) {
    const Vec2d centre = centre_of_mass(std::span(nodes).first(cells));
    double reach = 0;
    for (std::size_t i = 0; i < cells; ++i) reach = std::max(reach, length(nodes[i] - centre));
    return reach;
}

std::size_t cells_of(const GaitFrame &frame, const LifeRecording &recording) {
    return frame.nodes.size() - recording.worlds.front().environment.object.positions.size();
}

Vec2d centre_of(const GaitFrame &frame, const LifeRecording &recording) {
    return centre_of_mass(std::span(frame.nodes).first(cells_of(frame, recording)));
}

/// How far the body reaches from its centre at most, cells.
double reach_of(const LifeRecording &recording) {
    double reach = 0;
    for (const GrowthFrame &frame : recording.growth)
        reach = std::max(reach, reach_of(frame.cells, frame.cells.size()));
    for (const GaitFrame &frame : recording.gait)
        reach = std::max(reach, reach_of(frame.nodes, cells_of(frame, recording)));
    return reach + recording.parameters.development.cell_radius;
}

/// Looks at a body: it is in the middle, on land lower, as there is more to see above it.
void look_at(Vec2d centre, const Environment &world, View &view) {
    view.centre = centre + Vec2d{0, world.has_ground ? 0.16 * view.height / view.scale : 0};
}

constexpr double farthest = 4; // how much smaller a film may show a body, so that a loose object is seen

/// Looks at a body and at the loose object: from farther away, and between the two. Where the object is too far for that,
/// as far towards it as shows the body.
void look_at_both(const GaitFrame &frame, const LifeRecording &recording, double reach, View &view) {
    const Vec2d body = view.centre;
    double left = body.x - reach, right = body.x + reach;
    for (std::size_t i = cells_of(frame, recording); i < frame.nodes.size(); ++i) {
        left = std::min(left, frame.nodes[i].x - 1);
        right = std::max(right, frame.nodes[i].x + 1);
    }
    view.scale = std::clamp(view.width / (right - left), view.scale / farthest, view.scale);
    const double room = std::max(0.0, view.width / 2 / view.scale - reach);
    view.centre.x = std::clamp((left + right) / 2, body.x - room, body.x + room);
}

std::vector<Vec2d> path_of(const LifeRecording &recording, std::size_t frames) {
    std::vector<Vec2d> path;
    for (std::size_t i = 0; i < frames; ++i) path.push_back(centre_of(recording.gait[i], recording));
    return path;
}

/// `count` numbers evenly from first to last.
std::vector<std::size_t> evenly(std::size_t first, std::size_t last, std::size_t count) {
    std::vector<std::size_t> all;
    for (std::size_t i = 0; i < count; ++i) all.push_back(first + (last - first) * i / (count - 1));
    return all;
}

std::string step_text(int step) { return "step " + to_text(step); }

/// A row of frames at one scale, each with its step below it; `draw(i, view)` and `step(i)` are told the frame.
template <class Draw, class Step>
std::string row(double top, const char *name, double reach, const std::vector<std::size_t> &frames,
                const Draw &draw, const Step &step) {
    std::string text = svg::text({margin, top + 14}, "start", 14, name, "font-weight=\"bold\"");
    double x = margin;
    for (const std::size_t frame : frames) {
        View view{{}, std::min(small_width, small_height) / 2 / (reach * 1.12), small_width, small_height};
        const std::string content = draw(frame, view);
        text += panel({x, top + 22}, view, content + (x == margin ? draw_scale(view) : ""));
        text += svg::text({x + small_width / 2, top + 22 + small_height + 16}, "middle", 12,
                          step_text(step(frame)));
        x += small_width + gap;
    }
    return text;
}

constexpr double row_height = 22 + small_height + 34;

std::string growth_row(double top, const LifeRecording &recording, double reach) {
    const std::vector<GrowthFrame> &frames = recording.growth;
    return row(
        top, "Growth", reach, evenly(0, frames.size() - 1, columns),
        [&](std::size_t frame, View &view) {
            view.centre = centre_of_mass(frames[frame].cells);
            return draw_world(nullptr, view) + draw_body(moment_of(frames[frame], recording),
                                                         recording.parameters.development.cell_radius, view);
        },
        [&](std::size_t frame) { return frames[frame].step; });
}

/// The last frames, over the longest period.
std::string gait_row(double top, const LifeRecording &recording, double reach) {
    const std::vector<GaitFrame> &frames = recording.gait;
    const double begin = frames.back().step - recording.parameters.gait.period_longest;
    std::size_t first = frames.size() - 1;
    while (first > 0 && frames[first - 1].step >= begin) --first;
    return row(
        top, "Gait", reach, evenly(first, frames.size() - 1, columns),
        [&](std::size_t frame, View &view) {
            const Environment &world = world_at(frames[frame].step, recording);
            look_at(centre_of(frames[frame], recording), world, view);
            return draw_world(&world, view) + draw_body(moment_of(frames[frame], recording),
                                                        recording.parameters.development.cell_radius, view);
        },
        [&](std::size_t frame) { return frames[frame].step; });
}

/// The whole way in a view as high as it needs.
View view_of_way(const std::vector<Vec2d> &path, double reach) {
    Vec2d low = path.front(), high = path.front();
    for (const Vec2d place : path) {
        low = {std::min(low.x, place.x), std::min(low.y, place.y)};
        high = {std::max(high.x, place.x), std::max(high.y, place.y)};
    }
    const double around = 1.15 * reach, wide = high.x - low.x + 2 * around,
                 tall = high.y - low.y + 2 * around;
    View view{(low + high) * 0.5, 1, width - 2 * margin, 0};
    view.height = std::clamp(view.width * tall / wide, 170.0, 520.0);
    view.scale = std::min({view.width / wide, view.height / tall, small_height / reach});
    return view;
}

std::string way_row(double top, const LifeRecording &recording, double reach, double &height) {
    const std::vector<GaitFrame> &frames = recording.gait;
    const std::vector<Vec2d> path = path_of(recording, frames.size());
    const View view = view_of_way(path, reach);
    std::string content = draw_world(&world_at(frames.back().step, recording), view) + draw_path(path, view);
    for (const std::size_t frame : evenly(0, frames.size() - 1, 5))
        content += draw_body(moment_of(frames[frame], recording),
                             recording.parameters.development.cell_radius, view);
    height = 22 + view.height + margin;
    return svg::text({margin, top + 14}, "start", 14, "The whole path", "font-weight=\"bold\"") +
           panel({margin, top + 22}, view, content + draw_scale(view));
}

std::string heading(const LifeRecording &recording, std::string_view title) {
    const Life &life = recording.life;
    const std::string words =
        std::string(name_of(life.outcome)) + ", " + to_text(life.cells) + " cells, moved " +
        to_fixed(life.displacement(), 2) + " cells in " +
        to_text(recording.parameters.gait.locomotion_steps) +
        " steps. Colours: order of birth in growth; then red springs are shortened, blue lengthened.";
    return svg::text({margin, 34}, "start", 19, title, "font-weight=\"bold\"") +
           svg::text({margin, 56}, "start", 13, words);
}

std::string in_font(const std::string &content) {
    return "<g " + std::string(svg::font) + " fill=\"" + std::string(svg::ink) + "\">\n" + content + "</g>\n";
}

} // namespace

std::string life_strip(const LifeRecording &recording, std::string_view title) {
    const double reach = reach_of(recording);
    double top = 76;
    std::string content = heading(recording, title) + growth_row(top, recording, reach);
    top += row_height;
    if (!recording.gait.empty()) {
        content += gait_row(top, recording, reach);
        top += row_height;
        double height = 0;
        content += way_row(top, recording, reach, height);
        top += height;
    }
    return svg::picture(width, top, in_font(content));
}

std::vector<FilmFrame> film_frames(const LifeRecording &recording) {
    std::vector<FilmFrame> frames;
    for (std::size_t i = 0; i < recording.growth.size(); ++i) frames.push_back({true, i});
    for (std::size_t i = 0; i < recording.gait.size(); ++i)
        if (recording.gait[i].step % film_interval == 0) frames.push_back({false, i});
    return frames;
}

std::string film_picture(const LifeRecording &recording, const FilmFrame &frame, std::string_view title) {
    const double reach = reach_of(recording), radius = recording.parameters.development.cell_radius;
    View view{{}, film_height / 2 / (reach * 1.25), film_width, film_height};
    std::string content, words;
    if (frame.grows) {
        const GrowthFrame &shown = recording.growth[frame.frame];
        view.centre = centre_of_mass(shown.cells);
        content = draw_world(nullptr, view) + draw_body(moment_of(shown, recording), radius, view);
        words = "growth, " + step_text(shown.step) + ", " + counted(shown.cells.size(), "cell");
    } else {
        const GaitFrame &shown = recording.gait[frame.frame];
        const Environment &world = world_at(shown.step, recording);
        const Vec2d centre = centre_of(shown, recording);
        view.centre = centre;
        look_at_both(shown, recording, reach, view);
        look_at(view.centre, world, view);
        content = draw_world(&world, view) + draw_path(path_of(recording, frame.frame + 1), view) +
                  draw_body(moment_of(shown, recording), radius, view);
        words = "gait, " + step_text(shown.step) + ", " +
                to_fixed(length(centre - centre_of(recording.gait.front(), recording)), 2) +
                " cells from rest";
    }
    content +=
        draw_scale(view) + svg::text({14, 26}, "start", 15, title) + svg::text({14, 46}, "start", 13, words);
    return svg::picture(film_width, film_height, in_font(content));
}

} // namespace planula

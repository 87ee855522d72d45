// SPDX-License-Identifier: MIT
#include "analysis/network_picture.h"

#include "analysis/network_text.h"
#include "analysis/svg.h"
#include "base/text.h"
#include "base/vec2.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace planula {

namespace {

// Lengths are pixels.
constexpr double width = 960, left = 190, right = 770, top = 90, row = 52, foot = 70;
constexpr double inset = 95;  // from the inputs to the shallowest hidden node, and to the outputs
constexpr double radius = 12; // of a node
constexpr double clear_x = 44, clear_y = 32; // nodes nearer than this in both directions are moved apart
constexpr double thinnest = 0.6, thickest = 6;
constexpr double faintest = 0.3, fullest = 0.9;
constexpr const char *exciting = "#2166ac", *inhibiting = "#b2182b";

using svg::ink, svg::number, svg::point;

using Places = std::map<int, Vec2d>; // by node id

std::string colour_of(double weight) { return weight < 0 ? inhibiting : exciting; }

int rows_of(const Genome &genome) { return std::max({genome.inputs, genome.outputs, 4}); }
double bottom_of(const Genome &genome) { return top + row * (rows_of(genome) - 1); }

/// `count` nodes from `first` on, evenly down a column.
void place_column(int first, int count, double x, double bottom, Places &places) {
    for (int i = 0; i < count; ++i) places[first + i] = {x, top + (bottom - top) * (i + 0.5) / count};
}

/// Each hidden node at the mean height of its neighbours, by the strength of their links.
void settle_heights(const Genome &genome, Places &places) {
    for (const NodeGene &node : genome.nodes) {
        if (node.kind != NodeKind::hidden) continue;
        double sum = 0, weights = 0;
        for (const LinkGene &link : genome.links) {
            if (link.from == link.to || (link.from != node.id && link.to != node.id)) continue;
            const double strength = std::abs(link.weight) + 0.1;
            sum += strength * places[link.from == node.id ? link.to : link.from].y;
            weights += strength;
        }
        if (weights > 0) places[node.id].y = sum / weights;
    }
}

/// Hidden nodes that lie on each other move apart, up and down.
void move_apart(const Genome &genome, double bottom, Places &places) {
    const auto hidden = places.lower_bound(genome.inputs + genome.outputs);
    for (auto a = hidden; a != places.end(); ++a)
        for (auto b = std::next(a); b != places.end(); ++b) {
            const Vec2d gap = b->second - a->second;
            if (std::abs(gap.x) >= clear_x || std::abs(gap.y) >= clear_y) continue;
            const double shift = (clear_y - std::abs(gap.y)) / 2 * (gap.y < 0 ? -1 : 1);
            a->second.y = std::clamp(a->second.y - shift, top, bottom);
            b->second.y = std::clamp(b->second.y + shift, top, bottom);
        }
}

Places layout(const Genome &genome) {
    const double bottom = bottom_of(genome);
    Places places;
    place_column(0, genome.inputs, left, bottom, places);
    place_column(genome.inputs, genome.outputs, right, bottom, places);
    for (const NodeGene &node : genome.nodes)
        if (node.kind == NodeKind::hidden)
            places[node.id] = {left + inset + node.depth * (right - left - 2 * inset), (top + bottom) / 2};
    constexpr int sweeps = 8, pushes = 200;
    for (int i = 0; i < sweeps; ++i) settle_heights(genome, places);
    for (int i = 0; i < pushes; ++i) move_apart(genome, bottom, places);
    return places;
}

/// The way of a link: straight on to the right; within a column in a bow on its left; back to the left in a
/// bow below; of a node to itself in a loop above.
std::string way(Vec2d from, Vec2d to) {
    const auto curve = [](Vec2d start, Vec2d bend, Vec2d unbend, Vec2d end) {
        return "M " + point(start) + " C " + point(bend) + ", " + point(unbend) + ", " + point(end);
    };
    const Vec2d right_side{radius, 0}, below{0, radius};
    const double across = to.x - from.x;
    if (from.x == to.x && from.y == to.y)
        return curve(from + Vec2d{6, -10}, from + Vec2d{30, -44}, from + Vec2d{-30, -44},
                     from + Vec2d{-6, -10});
    if (std::abs(across) < 4 * radius)
        return curve(from - right_side, from - Vec2d{70, 0}, to - Vec2d{70, 0}, to - right_side);
    if (across < 0) return curve(from + below, from + Vec2d{-30, 75}, to + Vec2d{30, 75}, to + below);
    const Vec2d reach{0.45 * (across - 2 * radius), 0};
    return curve(from + right_side, from + right_side + reach, to - right_side - reach, to - right_side);
}

/// The weakest first, so that the strong lie on top.
std::string draw_links(const Genome &genome, const Places &places) {
    std::vector<LinkGene> links = genome.links;
    std::stable_sort(links.begin(), links.end(), [](const LinkGene &a, const LinkGene &b) {
        return std::abs(a.weight) < std::abs(b.weight);
    });
    const double strongest = links.empty() ? 1 : std::max(std::abs(links.back().weight), 1e-300);
    std::string text;
    for (const LinkGene &link : links) {
        const double share = std::abs(link.weight) / strongest;
        text += "<path d=\"" + way(places.at(link.from), places.at(link.to)) + "\" stroke=\"" +
                colour_of(link.weight) + "\" stroke-width=\"" +
                to_fixed(thinnest + (thickest - thinnest) * share, 2) + "\" stroke-opacity=\"" +
                to_fixed(faintest + (fullest - faintest) * share, 2) + "\"" +
                (link.recurrent ? " stroke-dasharray=\"7 4\"" : "") + "><title>" + to_text(link.weight) +
                "</title></path>\n";
    }
    return text;
}

std::string draw_nodes(const Genome &genome, const Places &places) {
    std::string text;
    for (const NodeGene &node : genome.nodes) {
        const Vec2d at = places.at(node.id);
        const bool is_output = node.kind == NodeKind::output, is_hidden = node.kind == NodeKind::hidden;
        text += "<circle cx=\"" + number(at.x) + "\" cy=\"" + number(at.y) + "\" r=\"" + number(radius) +
                "\" stroke=\"" + std::string(ink) + "\" fill=\"" +
                (is_hidden   ? "#ffffff"
                 : is_output ? "#fde8c4"
                             : "#dfe9f3") +
                "\"/>\n";
        if (is_hidden)
            text += svg::text(at + Vec2d{0, 3.5}, "middle", 10, to_text(node.id));
        else
            text += svg::text(at + Vec2d{is_output ? 20.0 : -20.0, 5}, is_output ? "start" : "end", 15,
                              name_of(genome, node));
    }
    return text;
}

/// What colours, widths and dashes mean.
std::string draw_legend(const Genome &genome) {
    double strongest = 0;
    bool recurrent = false;
    for (const LinkGene &link : genome.links) {
        strongest = std::max(strongest, std::abs(link.weight));
        recurrent = recurrent || link.recurrent;
    }
    const double y = bottom_of(genome) + foot - 18;
    std::string text;
    const auto sample = [&](double x, const std::string &style, const std::string &words) {
        text += svg::line({x, y}, {x + 42, y}, style) + svg::text({x + 50, y + 5}, "start", 13, words);
    };
    const auto style = [](std::string_view colour, double wide) {
        return "stroke=\"" + std::string(colour) + "\" stroke-width=\"" + number(wide) + "\"";
    };
    sample(left - 20, style(exciting, 4), "positive weight");
    sample(left + 145, style(inhibiting, 4), "negative weight");
    sample(left + 320, style(ink, thickest), "|weight| " + to_fixed(strongest, 2));
    if (recurrent) sample(left + 480, style(ink, 2) + " stroke-dasharray=\"7 4\"", "recurrent");
    return text;
}

} // namespace

std::string svg_of(const Genome &genome, const std::string &title) {
    const Places places = layout(genome);
    const double height = bottom_of(genome) + foot;
    return svg::picture(width, height,
                        "<g " + std::string(svg::font) + " fill=\"" + std::string(ink) + "\">\n" +
                            svg::text({width / 2, 38}, "middle", 19, title) +
                            "</g>\n<g fill=\"none\" stroke-linecap=\"round\">\n" +
                            draw_links(genome, places) + "</g>\n<g " + std::string(svg::font) +
                            " stroke-width=\"1.4\">\n" + draw_nodes(genome, places) + draw_legend(genome) +
                            "</g>\n");
}

} // namespace planula

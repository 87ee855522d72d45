// SPDX-License-Identifier: MIT
#include "recording/recording_json.h"

#include "base/json.h"
#include "base/text.h"
#include "evaluation/life_digest.h"
#include "genome/genome_text.h"
#include "recording/packed_numbers.h"

#include <algorithm>
#include <array>
#include <map>

namespace planula {

namespace {

constexpr double position_scale = 256, signal_scale = 100, compression_scale = 1000, activation_scale = 100;

template <class Value> std::string or_null(const std::optional<Value> &value) {
    return value ? to_text(*value) : "null";
}
std::string pair(double a, double b) { return json_list(std::array{a, b}, json_number); }
std::string points(const std::vector<Vec2d> &list) {
    return json_list(list, [](Vec2d p) { return pair(p.x, p.y); });
}
std::string whole(const std::vector<int> &list) {
    return json_list(list, [](int each) { return to_text(each); });
}
template <class Links> std::string links(const Links &list) {
    return json_list(list, [](const auto &link) { return to_text(link.a) + "," + to_text(link.b); });
}
template <class Frames> std::string steps_of(const Frames &frames) {
    return json_list(frames, [](const auto &frame) { return to_text(frame.step); });
}

// ---- Worlds -----------------------------------------------------------------------------------------------

std::string text_of(const Obstacle &obstacle) {
    return JsonObject()
        .add("points", points(obstacle.points))
        .add("friction", or_null(obstacle.friction))
        .text();
}

std::string text_of(const Region &region) {
    return JsonObject()
        .add("left", json_number(region.box.left))
        .add("right", json_number(region.box.right))
        .add("bottom", json_number(region.box.bottom))
        .add("top", json_number(region.box.top))
        .add("drag", pair(region.drag_normal, region.drag_tangential))
        .add("flow", region.flow ? pair(region.flow->x, region.flow->y) : "null")
        .add("buoyancy", or_null(region.buoyancy))
        .text();
}

std::string text_of(const Current &current) {
    if (!current.changes()) return "null";
    return JsonObject()
        .add("samples", points(current.samples))
        .add("step", to_text(current.step))
        .add("repeats", current.repeats ? "true" : "false")
        .text();
}

std::string text_of(const RecordedWorld &world) {
    const Environment &e = world.environment;
    const auto patch = [](const FrictionPatch &each) {
        return json_list(std::array{each.from, each.to, each.friction}, json_number);
    };
    return JsonObject()
        .add("first_step", to_text(world.first_step))
        .add("gravity", json_number(e.gravity))
        .add("gravity_direction", json_number(e.gravity_direction))
        .add("ground", e.has_ground ? points(e.ground) : "null")
        .add("friction", json_number(e.friction))
        .add("drag", pair(e.drag_normal, e.drag_tangential))
        .add("flow", pair(e.flow.x, e.flow.y))
        .add("current", text_of(e.current))
        .add("ceiling", e.ceiling.empty() ? "null" : points(e.ceiling))
        .add("obstacles", json_list(e.obstacles, [](const Obstacle &each) { return text_of(each); }))
        .add("patches", json_list(e.friction_patches, patch))
        .add("regions", json_list(e.regions, [](const Region &each) { return text_of(each); }))
        .text();
}

// ---- What comes and goes ----------------------------------------------------------------------------------

/// Frames in which something was there without a break: from the first on and before `end`.
struct Stretch {
    std::size_t first = 0, end = 0;
};

/// Those of all that the frames list, by what it is, then by time. `list_of(frame)` is sorted and names nothing twice.
template <class Thing, class Frames, class ListOf>
std::vector<std::pair<Thing, Stretch>> stretches(const Frames &frames, ListOf &&list_of) {
    std::vector<std::pair<Thing, Stretch>> all;
    std::map<Thing, std::size_t> places; // in `all`, of the latest of each
    for (std::size_t frame = 0; frame < frames.size(); ++frame)
        for (const Thing &thing : list_of(frames[frame])) {
            const auto known = places.find(thing);
            if (known != places.end() && all[known->second].second.end == frame) {
                ++all[known->second].second.end;
                continue;
            }
            places[thing] = all.size();
            all.push_back({thing, {frame, frame + 1}});
        }
    std::stable_sort(all.begin(), all.end(), [](const auto &a, const auto &b) { return a.first < b.first; });
    return all;
}

std::string ends(const Stretch &stretch) {
    return to_text(static_cast<std::int64_t>(stretch.first)) + "," +
           to_text(static_cast<std::int64_t>(stretch.end));
}

template <class Frames> std::string cells_of(const Frames &frames) {
    return json_list(stretches<int>(frames, [](const auto &frame) { return frame.ids; }),
                     [](const auto &cell) { return to_text(cell.first) + "," + ends(cell.second); });
}

std::string links_of(const std::vector<GrowthFrame> &frames) {
    return json_list(stretches<Link>(frames, [](const GrowthFrame &frame) { return frame.links; }),
                     [](const auto &link) {
                         return to_text(link.first.a) + "," + to_text(link.first.b) + "," + ends(link.second);
                     });
}

/// The place of an id, which the list has.
std::size_t place_of(int id, const std::vector<int> &ids) {
    return static_cast<std::size_t>(std::lower_bound(ids.begin(), ids.end(), id) - ids.begin());
}

// ---- Packed numbers ---------------------------------------------------------------------------------------

/// The quantised value_of(frame) for frames first … end - 1.
template <class ValueOf>
void pack(std::size_t first, std::size_t end, double scale, int order, ValueOf &&value_of,
          std::string &text) {
    std::vector<std::int64_t> series;
    for (std::size_t frame = first; frame < end; ++frame) series.push_back(quantised(value_of(frame), scale));
    pack_series(series, order, text);
}

std::string growth_positions(const std::vector<GrowthFrame> &frames) {
    std::string text;
    for (const auto &[id, stretch] :
         stretches<int>(frames, [](const GrowthFrame &frame) { return frame.ids; }))
        for (double Vec2d::*axis : {&Vec2d::x, &Vec2d::y})
            pack(
                stretch.first, stretch.end, position_scale, 2,
                [&, cell = id](std::size_t frame) {
                    return frames[frame].cells[place_of(cell, frames[frame].ids)].*axis;
                },
                text);
    return text;
}

/// The frames of each body: from its first to that of the next.
std::vector<Stretch> frames_of_bodies(const LifeRecording &recording) {
    std::vector<Stretch> all;
    for (std::size_t i = 0; i < recording.bodies.size(); ++i)
        all.push_back({recording.bodies[i].first_frame, i + 1 < recording.bodies.size()
                                                            ? recording.bodies[i + 1].first_frame
                                                            : recording.gait.size()});
    return all;
}

std::string gait_positions(const LifeRecording &recording) {
    const std::vector<GaitFrame> &frames = recording.gait;
    std::string text;
    for (const auto &[first, end] : frames_of_bodies(recording))
        for (std::size_t node = 0; first < end && node < frames[first].nodes.size(); ++node)
            for (double Vec2d::*axis : {&Vec2d::x, &Vec2d::y})
                pack(
                    first, end, position_scale, 2,
                    [&, at = node](std::size_t frame) { return frames[frame].nodes[at].*axis; }, text);
    return text;
}

/// The frames whose muscles are written: signals are straight lines between knots.
std::vector<int> muscle_frames(const LifeRecording &recording) {
    std::vector<int> chosen;
    const int knot = recording.parameters.gait.knot_interval;
    int last = -knot;
    for (std::size_t frame = 0; frame < recording.gait.size(); ++frame) {
        const int step = recording.gait[frame].step;
        if (recording.gait[frame].signals.empty() || step / knot == last / knot) continue;
        if (step % knot != 0 && recording.detail.gait_interval < knot) continue;
        chosen.push_back(static_cast<int>(frame));
        last = step;
    }
    return chosen;
}

std::string muscles(const LifeRecording &recording, std::vector<double> GaitFrame::*numbers, double scale) {
    const std::vector<GaitFrame> &frames = recording.gait;
    const std::vector<int> chosen = muscle_frames(recording);
    const auto place = [&](std::size_t frame) {
        return static_cast<std::size_t>(
            std::lower_bound(chosen.begin(), chosen.end(), static_cast<int>(frame)) - chosen.begin());
    };
    std::string text;
    for (const auto &[first, end] : frames_of_bodies(recording)) {
        const std::size_t from = place(first), to = place(end);
        for (std::size_t cell = 0; from < to && cell < (frames[first].*numbers).size(); ++cell)
            pack(
                from, to, scale, 2,
                [&, at = cell](std::size_t i) {
                    return (frames[static_cast<std::size_t>(chosen[i])].*numbers)[at];
                },
                text);
    }
    return text;
}

// ---- Network ----------------------------------------------------------------------------------------------

std::string name_of(const NodeGene &node, const LifeRecording &recording) {
    const auto number = static_cast<std::size_t>(node.id);
    if (node.id < recording.genome.inputs) return input::names.at(number);
    if (node.kind == NodeKind::output)
        return output::name_of(recording.actuation, node.id - recording.genome.inputs);
    return "hidden " + to_text(node.id);
}

std::string updates(const std::vector<NetworkFrame> &frames, std::size_t nodes) {
    std::string values;
    for (const auto &[id, stretch] :
         stretches<int>(frames, [](const NetworkFrame &frame) { return frame.ids; }))
        for (std::size_t node = 0; node < nodes; ++node)
            pack(
                stretch.first, stretch.end, activation_scale, 1,
                [&, cell = id](std::size_t at) {
                    const NetworkFrame &frame = frames[at];
                    return frame.activations[place_of(cell, frame.ids) * nodes + node];
                },
                values);
    return JsonObject()
        .add("steps", steps_of(frames))
        .add("cells", cells_of(frames))
        .add("values", json_text(values))
        .text();
}

std::string network_of(const LifeRecording &recording) {
    const std::vector<NodeGene> &nodes = recording.genome.nodes;
    const auto node_text = [&](const NodeGene &node) {
        return JsonObject()
            .add("id", to_text(node.id))
            .add("kind", json_text(planula::name_of(node.kind)))
            .add("name", json_text(name_of(node, recording)))
            .add("depth", json_number(node.depth))
            .text();
    };
    const auto place = [&](int id) {
        const auto found =
            std::lower_bound(nodes.begin(), nodes.end(), id,
                             [](const NodeGene &node, int wanted) { return node.id < wanted; });
        return static_cast<double>(found - nodes.begin());
    };
    const auto link_text = [&](const LinkGene &link) {
        return json_list(std::array{place(link.from), place(link.to), link.weight, link.recurrent ? 1.0 : 0},
                         json_number);
    };
    return JsonObject()
        .add("nodes", json_list(nodes, node_text))
        .add("links", json_list(recording.genome.links, link_text))
        .add("growth", updates(recording.growth_networks, nodes.size()))
        .add("gait", updates(recording.gait_networks, nodes.size()))
        .text();
}

// ---- The whole --------------------------------------------------------------------------------------------

std::string text_of(const RecordedBody &body) {
    return JsonObject()
        .add("first_frame", to_text(static_cast<std::int64_t>(body.first_frame)))
        .add("ids", whole(body.ids))
        .add("links", links(body.links))
        .add("outline", links(body.outline))
        .text();
}

std::string object_of(const LifeRecording &recording) {
    const Body &object = recording.worlds.front().environment.object;
    if (object.positions.empty()) return "null";
    return JsonObject()
        .add("nodes", to_text(object.cells()))
        .add("links", links(object.mesh.links))
        .add("outline", links(object.outline))
        .text();
}

std::string growth_of(const LifeRecording &recording) {
    return JsonObject()
        .add("steps", steps_of(recording.growth))
        .add("cells", cells_of(recording.growth))
        .add("links", links_of(recording.growth))
        .add("positions", json_text(growth_positions(recording.growth)))
        .text();
}

std::string gait_of(const LifeRecording &recording) {
    return JsonObject()
        .add("steps", steps_of(recording.gait))
        .add("positions", json_text(gait_positions(recording)))
        .add("muscle_frames", whole(muscle_frames(recording)))
        .add("signals", json_text(muscles(recording, &GaitFrame::signals, signal_scale)))
        .add("compressions", json_text(muscles(recording, &GaitFrame::compressions, compression_scale)))
        .text();
}

std::string source_of(const LifeRecording &recording) {
    return JsonObject()
        .add("genome", json_text(write_genome(recording.genome)))
        .add("conditions", json_text(recording.conditions))
        .text();
}

void add_caption(const LifeRecording &recording, JsonObject &all) {
    const Caption &caption = recording.caption;
    all.add("format", json_text("planula recording 1"))
        .add("title", json_text(caption.title))
        .add("experiment", json_text(caption.experiment))
        .add("setting", json_text(caption.setting))
        .add("seed", or_null(caption.seed))
        .add("generation", or_null(caption.generation))
        .add("slot", or_null(caption.slot))
        .add("genome", to_text(recording.genome.id))
        .add("fitness", or_null(caption.fitness));
}

void add_life(const LifeRecording &recording, JsonObject &all) {
    const Life &life = recording.life;
    const Parameters &p = recording.parameters;
    all.add("outcome", json_text(planula::name_of(life.outcome)))
        .add("displacement", json_number(life.displacement()))
        .add("cells", to_text(life.cells))
        .add("births", to_text(life.births))
        .add("life", json_text(life_sha256(life)))
        .add("path", points(life.path))
        .add("path_interval", to_text(p.gait.path_interval))
        .add("actuation", json_text(planula::name_of(recording.actuation)))
        .add("time_step", json_number(p.development.time_step))
        .add("cell_radius", json_number(p.development.cell_radius))
        .add("growth_steps", to_text(p.development.development_steps))
        .add("settle_steps", to_text(life.settle_steps))
        .add("gait_steps", to_text(p.gait.locomotion_steps))
        .add("pressure_stiffness", json_number(p.body.pressure_stiffness))
        .add("scales", JsonObject()
                           .add("position", json_number(position_scale))
                           .add("signal", json_number(signal_scale))
                           .add("compression", json_number(compression_scale))
                           .add("activation", json_number(activation_scale))
                           .text());
}

} // namespace

std::string recording_json(const LifeRecording &recording) {
    JsonObject all;
    add_caption(recording, all);
    add_life(recording, all);
    all.add("worlds", json_list(recording.worlds, [](const RecordedWorld &each) { return text_of(each); }))
        .add("growth", growth_of(recording))
        .add("bodies", json_list(recording.bodies, [](const RecordedBody &each) { return text_of(each); }))
        .add("object", object_of(recording))
        .add("gait", gait_of(recording))
        .add("network", network_of(recording))
        .add("source", source_of(recording));
    return all.text();
}

} // namespace planula

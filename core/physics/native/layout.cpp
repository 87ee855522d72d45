// SPDX-License-Identifier: MIT
#include "physics/native/layout.h"

#include "physics/laws/pressure.h"

#include <algorithm>
#include <numeric>

namespace planula::native {

namespace {

/// A neighbour of a node.
struct Spoke {
    int neighbour, link;
    int before = -1,
        triangle = -1; // with which neighbour it makes a triangle, clockwise of it; -1: with none
};
using Fan = std::vector<Spoke>;

/// Counter-clockwise runs of triangles, in ascending order of the neighbours that start them; a closed fan starts at
/// its lowest neighbour.
Fan in_order(Fan spokes) {
    Fan fan;
    while (!spokes.empty()) {
        auto next = std::find_if(spokes.begin(), spokes.end(), [](const Spoke &s) { return s.triangle < 0; });
        if (next == spokes.end()) next = spokes.begin();
        while (next != spokes.end()) {
            const int neighbour = next->neighbour;
            fan.push_back(*next);
            spokes.erase(next);
            next = std::find_if(spokes.begin(), spokes.end(),
                                [&](const Spoke &s) { return s.before == neighbour; });
        }
    }
    return fan;
}

/// The fan of every cell.
std::vector<Fan> fans(const SoftBodyModel &model) {
    std::vector<Fan> result(model.positions.size());
    for (std::size_t i = 0; i < model.links.size(); ++i) {
        const auto [a, b] = model.links[i];
        result[a].push_back({b, static_cast<int>(i)});
        result[b].push_back({a, static_cast<int>(i)});
    }
    for (std::size_t i = 0; i < model.triangles.size(); ++i) {
        const auto [a, b, c] = model.triangles[i];
        const auto set = [&](int corner, int first, int second) {
            for (Spoke &spoke : result[corner])
                if (spoke.neighbour == second) spoke.before = first, spoke.triangle = static_cast<int>(i);
        };
        set(a, b, c), set(b, c, a), set(c, a, b);
    }
    for (Fan &fan : result) fan = in_order(std::move(fan));
    return result;
}

/// What one lane of a slot holds of this spoke.
void fill(const SoftBodyModel &model, const Spoke &spoke, int neighbour, int lane, Slot &slot) {
    const BodyParameters &p = model.body;
    slot.neighbour[lane] = place_of(neighbour);
    const auto pull = static_cast<float>(p.spring_stiffness * model.rest_lengths[spoke.link]);
    slot.pull[lane] = slot.natural_pull[lane] = slot.next_pull[lane] = pull;
    if (spoke.triangle < 0) return;
    const auto pressure = pressure_of<float>(model.areas[spoke.triangle], p.pressure_stiffness, p.area_floor);
    slot.twice_area[lane] = pressure.twice_area, slot.pressure_slope[lane] = pressure.slope;
}

/// Outline and contact cells by the nodes' numbers.
SoftBodyModel renumbered(const SoftBodyModel &model, const std::vector<int> &node_of) {
    SoftBodyModel result{.outline = model.outline,
                         .contact_cells = model.contact_cells,
                         .masked = model.masked,
                         .body = model.body};
    for (OutlineLink &link : result.outline) link.a = node_of[link.a], link.b = node_of[link.b];
    for (int &cell : result.contact_cells) cell = node_of[cell];
    return result;
}

/// The order of nodes, copies included.
void order_nodes(const SoftBodyModel &model, const std::vector<Fan> &fan, Layout &layout) {
    std::vector<char> on_outline(fan.size());
    for (const OutlineLink &link : model.outline) on_outline[link.a] = on_outline[link.b] = 1;
    layout.nodes = model.nodes();
    layout.first_outline_node =
        layout.nodes - static_cast<int>(std::count(on_outline.begin(), on_outline.end(), 1));
    layout.cell_of.resize(fan.size());
    std::iota(layout.cell_of.begin(), layout.cell_of.end(), 0);
    std::stable_sort(layout.cell_of.begin(), layout.cell_of.end(), [&](int a, int b) {
        if (on_outline[a] != on_outline[b]) return on_outline[a] < on_outline[b];
        return on_outline[a] ? fan[a].size() > fan[b].size() : fan[a].size() < fan[b].size();
    });
    layout.groups = (layout.nodes + group_size - 1) / group_size;
    while (layout.cell_of.size() % pair_size != 0) layout.cell_of.push_back(layout.cell_of.back());
}

/// The links that meet in each node of the outline; copies have those of their node.
void add_links(const std::vector<int> &node_of, Layout &layout) {
    std::vector<std::vector<Place>> links(static_cast<std::size_t>(layout.nodes));
    for (std::size_t i = 0; i < layout.model.outline.size(); ++i)
        for (const int node : {layout.model.outline[i].a, layout.model.outline[i].b})
            links[node].push_back(place_of(static_cast<int>(i)));
    for (const auto &own : links)
        layout.links_per_node = std::max(layout.links_per_node, static_cast<int>(own.size()));

    const Place none = place_of(static_cast<int>(layout.outline.size()) * group_size);
    for (int first = layout.outline_group() * group_size; first < static_cast<int>(layout.cell_of.size());
         first += group_size)
        for (int i = 0; i < layout.links_per_node; ++i) {
            LinkGroup &group = layout.links_at.emplace_back();
            for (int lane = 0; lane < group_size; ++lane) {
                const auto &own = links[node_of[layout.cell_of[first + lane]]];
                group.link[lane] = i < static_cast<int>(own.size()) ? own[i] : none;
            }
        }
}

/// The next two groups: as many slots as the largest of their fans needs.
void add_pair(const SoftBodyModel &model, const std::vector<Fan> &fan, const std::vector<int> &node_of,
              Layout &layout) {
    const int start = static_cast<int>(layout.pairs.size()) * pair_size;
    GroupPair pair{.first_slot = static_cast<int>(layout.slots.size())};
    for (int lane = 0; lane < pair_size; ++lane) {
        int &slots = pair.slots[lane / group_size];
        slots = std::max(slots, static_cast<int>(fan[layout.cell_of[start + lane]].size()));
    }
    const int slots = std::max(pair.slots[0], pair.slots[1]);
    layout.slots.resize(layout.slots.size() + static_cast<std::size_t>(slots));

    for (int lane = 0; lane < pair_size; ++lane) {
        const Place own = place_of(start + lane);
        const Fan &spokes = fan[layout.cell_of[start + lane]];
        for (int i = 0; i < slots; ++i) {
            Slot &slot = layout.slots[pair.first_slot + i];
            slot.neighbour[lane] = own;
            if (i < static_cast<int>(spokes.size()))
                fill(model, spokes[i], node_of[spokes[i].neighbour], lane, slot);
        }
        pair.last[lane] = spokes.empty() ? own : place_of(node_of[spokes.back().neighbour]);
    }
    layout.pairs.push_back(pair);
}

} // namespace

Layout lay_out(const SoftBodyModel &model) {
    Layout layout;
    const std::vector<Fan> fan = fans(model);
    order_nodes(model, fan, layout);
    std::vector<int> node_of(fan.size());
    for (int node = 0; node < layout.nodes; ++node) node_of[layout.cell_of[node]] = node;
    while (layout.pairs.size() * pair_size < layout.cell_of.size()) add_pair(model, fan, node_of, layout);

    layout.model = renumbered(model, node_of);
    layout.outline.resize((model.outline.size() + group_size - 1) / group_size);
    for (std::size_t i = 0; i < model.outline.size(); ++i) {
        OutlineGroup &group = layout.outline[i / group_size];
        group.a[i % group_size] = place_of(layout.model.outline[i].a);
        group.b[i % group_size] = place_of(layout.model.outline[i].b);
    }
    add_links(node_of, layout);
    return layout;
}

} // namespace planula::native

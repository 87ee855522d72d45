// SPDX-License-Identifier: MIT
#include "device/pack.h"

#include "locomotion/grn.h"
#include "locomotion/last_quarter.h"
#include "locomotion/oscillator.h"
#include "physics/ground.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace planula::device {

namespace {

unsigned aligned(std::size_t bytes) {
    return static_cast<unsigned>((bytes + alignment - 1) / alignment * alignment);
}

/// Bytes to be copied, array after array.
class Bytes {
  public:
    explicit Bytes(std::size_t reserved) : bytes_(aligned(reserved)) {}

    template <class T> Array<T> add(const std::vector<T> &list) {
        const Array<T> array{static_cast<unsigned>(bytes_.size())};
        bytes_.resize(aligned(bytes_.size() + list.size() * sizeof(T)));
        if (!list.empty()) std::memcpy(bytes_.data() + array.begin, list.data(), list.size() * sizeof(T));
        return array;
    }
    unsigned size() const { return static_cast<unsigned>(bytes_.size()); }
    std::vector<std::byte> take(const Task &task) {
        std::memcpy(bytes_.data(), &task, sizeof task);
        return std::move(bytes_);
    }

  private:
    std::vector<std::byte> bytes_;
};

/// Memory that is set apart, array after array.
class Room {
  public:
    explicit Room(unsigned begin = 0) : size_(begin) {}

    template <class T> void add(Array<T> &array, std::size_t count) {
        array.begin = size_;
        size_ = aligned(size_ + count * sizeof(T));
    }
    unsigned size() const { return size_; }

  private:
    unsigned size_;
};

/// Whether a device has the text for this world.
bool is_plain(const SoftBodyModel &model, const Environment &environment) {
    return model.object_nodes == 0 && !environment.has_walls() && environment.regions.empty() &&
           !environment.current.changes() && environment.gravity_direction == 0;
}

/// The largest number whose root in double precision is below `speed`; -1 if there is none.
float largest_square_below(double speed) {
    constexpr float up = std::numeric_limits<float>::infinity();
    const auto is_below = [&](float square) { return std::sqrt(static_cast<double>(square)) < speed; };
    if (!is_below(0)) return -1;
    auto square = static_cast<float>(speed * speed);
    while (!is_below(square)) square = std::nextafter(square, -up);
    while (std::isfinite(square) && is_below(std::nextafter(square, up))) square = std::nextafter(square, up);
    return square;
}

/// A trial that is being packed.
struct Packing {
    const SoftBodyModel &model;
    const Environment &environment;
    const native::Layout layout = native::lay_out(model);
    std::vector<int> node_of = std::vector<int>(layout.cell_of.size());
    Task task{};
    Bytes bytes{sizeof(Task)};
    Room scratch{};

    /// What threads have at hand: the body at rest, and what the laws read.
    void add_body() {
        task.nodes = layout.nodes;
        for (int node = 0; node < layout.nodes; ++node) node_of[layout.cell_of[node]] = node;
        task.settles = environment.gravity > 0;
        task.step = native::step_task(model, environment), task.drag = native::drag_task(environment);
        task.drag.flow_x = static_cast<float>(environment.flow.x);
        task.drag.flow_y = static_cast<float>(environment.flow.y);
        task.drag.links_per_node = layout.links_per_node;
        task.outline_links = static_cast<int>(layout.outline.size()) * native::group_size;
        task.has_fluid = environment.has_fluid() && task.outline_links > 0;
        task.first_linked = layout.outline_group() * native::group_size;
        task.origin = origin_for(model.positions, environment);
        std::vector<native::Record> records;
        for (const int cell : layout.cell_of) {
            const auto place = rounded_to<float>(model.positions[cell] - task.origin);
            records.push_back({place.x, place.y, 0, 0});
        }
        task.now = bytes.add(records), task.pairs = bytes.add(layout.pairs);
        task.slots = bytes.add(layout.slots), task.outline = bytes.add(layout.outline);
        task.links_at = bytes.add(layout.links_at);
        task.resident_bytes = bytes.size();

        Room fast(bytes.size());
        fast.add(task.next, records.size());
        fast.add(task.half_drag, static_cast<std::size_t>(task.outline_links) + 1);
        fast.add(task.extension, records.size());
        task.fast_bytes = fast.size();
    }

    void add_ground() {
        const std::vector<Piece<float>> ground = lay_ground<float>(environment, task.origin);
        task.pieces = static_cast<int>(ground.size());
        task.ground = bytes.add(ground);
        task.node_of = bytes.add(node_of);
        scratch.add(task.below, static_cast<std::size_t>(task.nodes));
    }

    void add_contact() {
        task.contact_stiffness = static_cast<float>(model.body.contact_stiffness);
        task.contact_reach = static_cast<float>(model.body.contact_radius);
        task.contact_cells = static_cast<int>(model.contact_cells.size());
        task.words = (task.outline_links + word_size - 1) / word_size;
        std::vector<native::Place> cells;
        for (const int cell : layout.model.contact_cells) cells.push_back(native::place_of(cell));
        std::vector<Word> unmasked(cells.size() * static_cast<std::size_t>(task.words));
        std::size_t pairs = 0;
        for (std::size_t cell = 0; cell < cells.size(); ++cell)
            for (std::size_t link = 0; link < model.outline.size(); ++link)
                if (!model.is_masked(cell, link))
                    unmasked[cell * task.words + link / word_size] |= Word(1) << link % word_size, ++pairs;
        task.touching_cells = bytes.add(cells), task.unmasked = bytes.add(unmasked);

        const auto links = static_cast<std::size_t>(task.outline_links);
        scratch.add(task.listed_at, static_cast<std::size_t>(task.nodes));
        scratch.add(task.circle_x, links), scratch.add(task.circle_y, links);
        scratch.add(task.squared_radius, links);
        scratch.add(task.inside, unmasked.size());
        scratch.add(task.near, (pairs + word_size - 1) / word_size);
        scratch.add(task.listed, (pairs + native::group_size - 1) / native::group_size);
        scratch.add(task.squared_distances, pairs), scratch.add(task.touches, pairs);
    }

    void add_course(double range, const Parameters &p) {
        task.settle_slowing = 1 - static_cast<float>(p.settling.settle_damping) * task.step.time_step;
        task.squared_calm = largest_square_below(p.settling.settle_speed);
        task.settle_window = p.settling.settle_window, task.settle_limit = p.settling.settle_limit;
        const GaitParameters &gait = p.gait;
        task.range = range;
        task.locomotion_steps = gait.locomotion_steps, task.knot_interval = gait.knot_interval;
        task.ramp_steps = gait.ramp_steps, task.update_interval = gait.update_interval;
        task.path_interval = gait.path_interval;
        task.late = last_quarter(gait.locomotion_steps, gait.knot_interval);
        for (Array<double> *list : {&task.from, &task.to, &task.changes})
            scratch.add(*list, static_cast<std::size_t>(task.nodes));
        // Rest, the points on the way, and the end; the last interval of knots is walked to its end.
        const int points = (gait.locomotion_steps + gait.knot_interval) / gait.path_interval + 2;
        task.result_bytes =
            aligned(path_after_result().begin + static_cast<std::size_t>(points) * sizeof(Vec2d));
    }

    void add(const Oscillators &oscillators) {
        task.actuation = Actuation::oscillator;
        std::vector<Phasor> phasors;
        for (int node = 0; node < task.nodes; ++node)
            phasors.push_back(oscillators.phasors()[layout.cell_of[node]]);
        task.start_phasors = bytes.add(phasors);
        scratch.add(task.phasors, phasors.size());
    }

    void add(const GrnMuscles &muscles) {
        task.actuation = Actuation::grn;
        const Network &network = muscles.network();
        task.network.inputs = network.inputs, task.network.targets = network.nodes - network.inputs;
        task.morphogen_row = network.inputs + output::morphogen;
        task.spring_row = network.inputs + output::spring;
        task.sources = bytes.add(network.sources), task.first_source = bytes.add(network.first_source);

        const Tissue &tissue = muscles.tissue();
        Activations activations(network.nodes, task.nodes); // in the order of nodes
        std::vector<int> first{0}, neighbours;
        std::vector<double> morphogens;
        for (int node = 0; node < task.nodes; ++node) {
            const int cell = layout.cell_of[node];
            for (int row = 0; row < network.nodes; ++row)
                activations.at(node, row) = tissue.activations.at(cell, row);
            morphogens.push_back(tissue.morphogens[cell]);
            for (const int neighbour : muscles.neighbours()[cell]) neighbours.push_back(node_of[neighbour]);
            first.push_back(static_cast<int>(neighbours.size()));
        }
        const std::size_t groups = activations.groups(), lanes = groups * Activations::group_size;
        const std::vector<double> values(activations.values(), activations.values() + lanes * network.nodes);
        task.first_neighbour = bytes.add(first), task.neighbours = bytes.add(neighbours);
        task.start_activations = bytes.add(values), task.start_morphogens = bytes.add(morphogens);
        scratch.add(task.activations, values.size()), scratch.add(task.morphogens, morphogens.size());
        scratch.add(task.network_next, lanes * task.network.targets);
        scratch.add(task.previous, morphogens.size()), scratch.add(task.newest, morphogens.size());
    }

    std::vector<std::byte> take() {
        task.input_bytes = bytes.size(), task.scratch_bytes = scratch.size();
        return bytes.take(task);
    }
};

} // namespace

std::optional<std::vector<std::byte>> pack(const SoftBodyModel &model, const Environment &environment,
                                           double actuation_range, const Parameters &parameters,
                                           const Gait &gait) {
    const auto *oscillators = dynamic_cast<const Oscillators *>(&gait);
    const auto *muscles = dynamic_cast<const GrnMuscles *>(&gait);
    if (!is_plain(model, environment) || (!oscillators && (!muscles || muscles->inputs_change()))) return {};
    Packing packing{model, environment};
    packing.add_body(), packing.add_ground(), packing.add_contact();
    packing.add_course(actuation_range, parameters);
    if (oscillators)
        packing.add(*oscillators);
    else
        packing.add(*muscles);
    return packing.take();
}

Task task_of(std::span<const std::byte> input) {
    Task task;
    std::memcpy(&task, input.data(), sizeof task);
    return task;
}

Trial unpack(std::span<const std::byte> input, std::span<const std::byte> bytes) {
    const Task task = task_of(input);
    Result result;
    std::memcpy(&result, bytes.data(), sizeof result);
    Trial trial{.outcome = result.outcome, .settle_steps = result.settle_steps};
    std::vector<Vec2d> points((task.result_bytes - path_after_result().begin) / sizeof(Vec2d));
    std::memcpy(points.data(), bytes.data() + path_after_result().begin, points.size() * sizeof(Vec2d));
    trial.path.assign(points.begin(), points.begin() + result.path_points);
    if (!trial.path.empty()) trial.rest = trial.path.front();
    if (trial.outcome != Outcome::viable) return trial;
    trial.finish = points[result.path_points];
    const double changes = static_cast<double>(std::max(result.updates - 1, 0)) * task.nodes;
    trial.activity = activity_of(result.network_change, changes);
    if (result.change > 0) trial.late_actuation = (result.change - result.early_change) / result.change;
    return trial;
}

} // namespace planula::device

// SPDX-License-Identifier: MIT
#include "recording/recording.h"

#include "base/check.h"
#include "body/body.h"
#include "development/embryo.h"
#include "evaluation/conditions_text.h"
#include "evaluation/live.h"
#include "locomotion/course.h"
#include "network/activations.h"

#include <algorithm>
#include <utility>

namespace planula {

namespace {

std::vector<int> ids_of(const Embryo &embryo) {
    std::vector<int> ids;
    for (const Cell &cell : embryo.cells) ids.push_back(cell.id);
    return ids;
}

GrowthFrame frame_of(int step, const Embryo &embryo) {
    GrowthFrame frame{step, ids_of(embryo), positions(embryo), {}};
    for (const auto &[a, b] : embryo.links) frame.links.push_back({frame.ids[a], frame.ids[b]});
    return frame;
}

NetworkFrame frame_of(int step, std::vector<int> ids, const Activations &activations) {
    NetworkFrame frame{step, std::move(ids), {}};
    for (int cell = 0; cell < activations.cells(); ++cell)
        for (int node = 0; node < activations.nodes(); ++node)
            frame.activations.push_back(activations.at(cell, node));
    return frame;
}

/// By how much of its area each triangle of a body is compressed, as a mean of those at each cell (laws/pressure.h).
std::vector<double> compressions_of(const Body &body, double area_floor, std::span<const Vec2d> nodes) {
    std::vector<double> sums(body.positions.size()), counts(body.positions.size());
    for (std::size_t i = 0; i < body.mesh.triangles.size(); ++i) {
        const auto &[a, b, c] = body.mesh.triangles[i];
        const double area = cross(nodes[b] - nodes[a], nodes[c] - nodes[a]) / 2;
        const double share = (body.areas[i] - area) / std::max(body.areas[i], area_floor);
        for (const int corner : {a, b, c}) sums[corner] += share, counts[corner] += 1;
    }
    for (std::size_t i = 0; i < sums.size(); ++i)
        if (counts[i] > 0) sums[i] /= counts[i];
    return sums;
}

/// Fills a recording while a life is simulated.
class Recorder {
  public:
    Recorder(const Conditions &conditions, LifeRecording &recording)
        : conditions_(conditions), recording_(recording), detail_(recording.detail) {
        const Embryo first = zygote(static_cast<int>(recording.genome.nodes.size()));
        recording_.growth.push_back(frame_of(0, first));
    }

    Watch watch() {
        Watch watch;
        watch.grow = [this](int step, const Embryo &embryo) { grow(step, embryo); };
        watch.born = [this](const Body &body) { bear(body); };
        watch.move = [this](int step, std::span<const Vec2d> nodes, std::span<const double> signal) {
            if (step % conditions_.refinement == 0) move(step / conditions_.refinement, nodes, signal);
        };
        if (detail_.has_networks)
            watch.update = [this](int step, const Activations &activations) {
                if (step % conditions_.refinement == 0) update(step / conditions_.refinement, activations);
            };
        return watch;
    }

  private:
    void grow(int step, const Embryo &embryo) {
        const DevelopmentParameters &p = conditions_.parameters.development;
        const bool is_last = step == p.development_steps;
        if (is_last || (step > 0 && step % detail_.growth_interval == 0))
            recording_.growth.push_back(frame_of(step, embryo));
        const bool decides =
            is_last ? conditions_.actuation == Actuation::oscillator : step % p.decision_interval == 0;
        if (detail_.has_networks && decides)
            recording_.growth_networks.push_back(frame_of(step, ids_of(embryo), embryo.activations));
    }

    /// Called again with what is left of a body that has lost cells: those whose places it still has.
    void bear(const Body &body) {
        std::vector<int> ids;
        std::size_t cell = 0;
        const GrowthFrame &grown = recording_.growth.back();
        for (const Vec2d place : body.positions) {
            while (grown.cells.at(cell) != place) ++cell;
            ids.push_back(grown.ids[cell++]);
        }
        if (recording_.gait.empty()) recording_.bodies.clear(); // it lost cells before it moved
        recording_.bodies.push_back({recording_.gait.size(), std::move(ids), body.mesh.links, body.outline});
        body_ = body;
    }

    void move(int step, std::span<const Vec2d> nodes, std::span<const double> signal) {
        const int last = conditions_.parameters.gait.locomotion_steps;
        if (step % detail_.gait_interval != 0 && step != last) return;
        GaitFrame frame{step, {nodes.begin(), nodes.end()}, {}, {}};
        if (detail_.has_muscles) {
            frame.signals.assign(signal.begin(), signal.end());
            frame.compressions = compressions_of(body_, conditions_.parameters.body.area_floor, nodes);
        }
        recording_.gait.push_back(std::move(frame));
    }

    void update(int step, const Activations &activations) {
        const GaitParameters &p = conditions_.parameters.gait;
        if (step % p.update_interval == 0 && step < p.locomotion_steps)
            recording_.gait_networks.push_back(frame_of(step, recording_.bodies.back().ids, activations));
    }

    const Conditions &conditions_;
    LifeRecording &recording_;
    const Detail &detail_;
    Body body_;
};

} // namespace

LifeRecording record_life(const Genome &genome, const Conditions &conditions, const Caption &caption,
                          const Detail &detail) {
    CHECK(detail.growth_interval >= 1 && detail.gait_interval >= 1);
    LifeRecording recording{.caption = caption,
                            .detail = detail,
                            .genome = genome,
                            .actuation = conditions.actuation,
                            .parameters = conditions.parameters,
                            .conditions = write_conditions(conditions)};
    recording.worlds.push_back({0, conditions.environment});
    for (const Phase &phase : conditions.phases) recording.worlds.push_back({phase.at, phase.environment});
    Recorder recorder(conditions, recording);
    recording.life = live(genome, conditions, recorder.watch());
    return recording;
}

} // namespace planula

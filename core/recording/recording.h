// SPDX-License-Identifier: MIT
// A life observed frame by frame, for pictures: growth from the zygote to the body, then locomotion through all that it
// moves along and against. What is recorded is what live() shows (evaluation/live.h); nothing is computed again but the
// pressure of cells. recording/recording_json.h writes it as text.
//
// Steps are those of the parameters: where conditions refine them, recordings count and keep the whole ones.
#pragma once

#include "body/mesh.h"
#include "cell/channels.h"
#include "evaluation/conditions.h"
#include "evaluation/life.h"
#include "genome/genome.h"
#include "parameters/parameters.h"
#include "physics/environment.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace planula {

/// How much is recorded. Frames are also taken at the first and the last step of a stage.
struct Detail {
    int growth_interval = 10; // steps between two frames of development
    int gait_interval = 5;    // of locomotion
    bool has_networks = true; // the activations of every cell's network
    bool has_muscles = true;  // signals and pressures
};
/// For a page about one individual.
inline constexpr Detail full_detail{};
/// For a page about many: what moves, without what makes it move.
inline constexpr Detail gallery_detail{20, 20, false, false};

/// Which individual it is, as far as it is known; for people, and no part of its life.
struct Caption {
    std::string title; // of the setting
    std::string experiment, setting;
    std::optional<std::int64_t> seed;
    std::optional<int> generation, slot;
    std::optional<double> fitness;
};

/// The cells at one step of development, ascending by id. Ids are numbers of birth; the zygote has 0.
struct GrowthFrame {
    int step = 0;
    std::vector<int> ids;
    std::vector<Vec2d> cells; // development frame
    std::vector<Link> links;  // pairs of ids
};

/// What a body consists of from one frame of locomotion on: at first, and again when it has lost cells.
struct RecordedBody {
    std::size_t first_frame = 0;
    std::vector<int> ids;    // of the cells; nodes 0, 1, … are these
    std::vector<Link> links; // pairs of nodes
    std::vector<OutlineLink> outline;
};

/// The body at one step of locomotion, 0: at rest.
struct GaitFrame {
    int step = 0;
    std::vector<Vec2d> nodes; // world frame; the cells, then the nodes of a loose object
    /// Of each cell: its muscles' signal in [-1, 1], and by how much of their area its triangles are compressed, as a
    /// mean; its pressure is this times pressure_stiffness. Empty where not recorded.
    std::vector<double> signals, compressions;
};

/// Every cell's activations after an update of the networks.
struct NetworkFrame {
    int step = 0;
    std::vector<int> ids;            // of the cells
    std::vector<double> activations; // a row per cell, a column per node of the genome
};

/// A world that the body is in from a step of locomotion on.
struct RecordedWorld {
    int first_step = 0;
    Environment environment;
};

struct LifeRecording {
    Caption caption;
    Detail detail;
    Genome genome;
    Actuation actuation = Actuation::oscillator;
    Parameters parameters;
    std::string conditions;            // as write_conditions() writes them
    std::vector<RecordedWorld> worlds; // ascending
    Life life;
    std::vector<GrowthFrame> growth;           // the first one is the zygote, before its first decision
    std::vector<RecordedBody> bodies;          // none of a life that ended in growth
    std::vector<GaitFrame> gait;               // none of a life that ended before locomotion
    std::vector<NetworkFrame> growth_networks; // at each decision, and where oscillators were read
    std::vector<NetworkFrame> gait_networks;   // at each update_interval, where networks go on being updated
};

/// Simulates the life and records it. The detail's intervals must be at least 1.
LifeRecording record_life(const Genome &genome, const Conditions &conditions, const Caption &caption,
                          const Detail &detail = full_detail);

} // namespace planula

// SPDX-License-Identifier: MIT
#include "analysis/analysis.h"
#include "analysis/simulate_again.h"
#include "base/error.h"
#include "base/text.h"
#include "body/body.h"
#include "development/embryo.h"
#include "physics/environment.h"
#include "record/run_folder.h"
#include "tables/csv.h"
#include "tables/genome_table.h"

#include <algorithm>
#include <array>
#include <limits>
#include <set>

namespace planula {

namespace {

constexpr int frames_per_stage = 6;
using Steps = std::array<int, frames_per_stage>;
constexpr int path_interval = 20; // steps between the points of a path
constexpr double margin = 10;     // cells of ground beyond where the others of the run may have ended

/// The best individual of one of a setting's shown runs, as best_genomes.csv has it.
struct Shown {
    int rank = 0;
    std::int64_t seed = 0;
    RecordedIndividual recorded;
};

/// Those of a setting, by ascending rank.
std::vector<Shown> read_shown(const std::filesystem::path &data, const Spec &spec) {
    std::vector<Shown> all;
    std::vector<std::vector<GenomeRow>> genes; // of each
    const std::filesystem::path file = data / BestGenomeRow::file_name;
    for (const BestGenomeRow &row : read_table<BestGenomeRow>(data)) {
        if (row.setting != spec.name) continue;
        if (all.empty() || all.back().rank != row.rank) {
            all.push_back({row.rank, row.seed, {file, {}, row.fitness, row.displacement, row.cells}});
            genes.emplace_back();
        }
        genes.back().push_back({row.kind, row.id, row.from, row.to, row.value, row.recurrent});
    }
    for (std::size_t i = 0; i < all.size(); ++i) try {
            all[i].recorded.genome = genome_of(genes[i]);
        } catch (const InputError &error) {
            throw InputError(file.string() + ": setting '" + spec.name + "', rank " + to_text(all[i].rank) +
                             ": " + error.what());
        }
    return all;
}

/// Evenly from the start of development to its end, at steps whose neighbourhood is fresh.
Steps growth_steps(const Parameters &p) {
    Steps steps{};
    for (int i = 0; i < frames_per_stage; ++i) {
        steps[i] =
            static_cast<int>(std::int64_t{p.development.development_steps} * i / (frames_per_stage - 1));
        if (i + 1 < frames_per_stage) steps[i] -= steps[i] % p.development.neighbourhood_interval;
    }
    return steps;
}

/// Evenly over the longest period, at the end of locomotion.
Steps gait_steps(const Parameters &p) {
    const int span = std::min(p.gait.locomotion_steps, static_cast<int>(p.gait.period_longest));
    Steps steps{};
    for (int i = 0; i < frames_per_stage; ++i)
        steps[i] = p.gait.locomotion_steps - span +
                   static_cast<int>(std::int64_t{span} * i / (frames_per_stage - 1));
    return steps;
}

/// Evenly over all of locomotion.
Steps path_steps(const Parameters &p) {
    Steps steps{};
    for (int i = 0; i < frames_per_stage; ++i)
        steps[i] = static_cast<int>(std::int64_t{p.gait.locomotion_steps} * i / (frames_per_stage - 1));
    return steps;
}

/// The tables of all settings, while they are written.
class FrameTables {
  public:
    explicit FrameTables(const std::filesystem::path &out)
        : frames_(out), cells_(out), links_(out), paths_(out), terrain_(out), morphologies_(out) {}

    /// Writes one picture; `signal` may be empty for all cells at rest. The first `own` cells are the animat's.
    void draw(const FrameRow &frame, std::span<const Vec2d> cells, std::span<const double> signal,
              std::span<const Link> links, std::span<const OutlineLink> rim, std::size_t own) {
        FrameRow row = frame;
        const Vec2d centre = centre_of_mass(cells.first(own));
        row.cells = static_cast<int>(own);
        row.centre_x = centre.x, row.centre_y = centre.y;
        frames_.write(row);
        for (std::size_t i = 0; i < cells.size(); ++i)
            cells_.write({row.setting, row.rank, row.stage, row.frame, static_cast<int>(i), cells[i].x,
                          cells[i].y, i < signal.size() ? signal[i] : 0});
        std::set<Link> outer;
        for (const OutlineLink &link : rim)
            outer.insert({std::min(link.a, link.b), std::max(link.a, link.b)});
        for (const Link &link : links)
            links_.write({row.setting, row.rank, row.stage, row.frame, cells[link.a].x, cells[link.a].y,
                          cells[link.b].x, cells[link.b].y, outer.contains(link) ? 1 : 0});
    }

    void trace(const FramePathRow &row) { paths_.write(row); }
    void draw_terrain(const FrameTerrainRow &row) { terrain_.write(row); }
    void describe(const MorphologyRow &row) { morphologies_.write(row); }

    void commit() {
        frames_.commit();
        cells_.commit();
        links_.commit();
        paths_.commit();
        terrain_.commit();
        morphologies_.commit();
    }

  private:
    TableWriter<FrameRow> frames_;
    TableWriter<FrameCellRow> cells_;
    TableWriter<FrameLinkRow> links_;
    TableWriter<FramePathRow> paths_;
    TableWriter<FrameTerrainRow> terrain_;
    TableWriter<MorphologyRow> morphologies_;
};

/// Watches a simulation and draws it at the chosen steps.
class FrameWatcher {
  public:
    FrameWatcher(const Spec &spec, int rank, FrameTables &tables)
        : spec_(spec), rank_(rank), tables_(tables), growth_(growth_steps(spec.parameters)),
          gait_(gait_steps(spec.parameters)), path_(path_steps(spec.parameters)) {
        // The first picture is the zygote, before its first decision (decision 0003).
        tables_.draw(frame("growth", 0, 0), positions(zygote(0)), {}, {}, {}, 1);
    }

    Watch watch() {
        Watch watch;
        watch.grow = [this](int step, const Embryo &embryo) {
            for (int i = 1; i < frames_per_stage; ++i)
                if (growth_[i] == step) draw_embryo(i, step, positions(embryo));
        };
        watch.born = [this](const Body &body) { set_body(body, spec_.environment.object); };
        watch.move = [this](int step, std::span<const Vec2d> nodes, std::span<const double> signal) {
            draw_at(gait_, "gait", step, nodes, signal);
            draw_at(path_, "path", step, nodes, signal);
            follow(step, nodes, nodes.first(signal.size()));
        };
        return watch;
    }

    /// Ground and ceiling along all that moved, and all obstacles.
    void draw_terrain() {
        if (left_ > right_) return;
        const Environment &world = spec_.environment;
        if (world.has_ground) draw_line("ground", world.ground);
        if (!world.ceiling.empty()) draw_line("ceiling", world.ceiling);
        int number = 0;
        for (const Obstacle &obstacle : world.obstacles) {
            std::vector<Vec2d> points = obstacle.points;
            points.push_back(points.front());
            draw_points("obstacle", number++, points);
        }
    }

  private:
    /// As far again as the best came, on both sides.
    void draw_line(const char *kind, const std::vector<Vec2d> &line) {
        const double left = 2 * left_ - right_ - margin, right = 2 * right_ - left_ + margin;
        std::vector<Vec2d> points{{left, height_of(line, left)}};
        for (const Vec2d corner : line)
            if (corner.x > left && corner.x < right) points.push_back(corner);
        points.push_back({right, height_of(line, right)});
        draw_points(kind, 0, points);
    }

    void draw_points(const char *kind, int number, std::span<const Vec2d> points) {
        for (std::size_t i = 0; i < points.size(); ++i)
            tables_.draw_terrain(
                {spec_.name, rank_, kind, number, static_cast<int>(i), points[i].x, points[i].y});
    }

    FrameRow frame(const char *stage, int number, int step) const {
        return {.setting = spec_.name, .rank = rank_, .stage = stage, .frame = number, .step = step};
    }

    void set_body(const Body &body, const Body &object) {
        const int first = body.cells();
        links_ = body.mesh.links, outline_ = body.outline;
        for (const auto &[a, b] : object.mesh.links) links_.push_back({a + first, b + first});
        for (const auto &[a, b, solid] : object.outline) outline_.push_back({a + first, b + first, solid});
    }

    void draw_embryo(int number, int step, std::span<const Vec2d> cells) {
        const Parameters &p = spec_.parameters;
        const Body body =
            make_body({cells.begin(), cells.end()}, p.development.link_limit * 2 * p.development.cell_radius);
        tables_.draw(frame("growth", number, step), cells, {}, body.mesh.links, body.outline, cells.size());
    }

    void draw_at(const Steps &steps, const char *stage, int step, std::span<const Vec2d> nodes,
                 std::span<const double> signal) {
        for (int i = 0; i < frames_per_stage; ++i)
            if (steps[i] == step)
                tables_.draw(frame(stage, i, step), nodes, signal, links_, outline_, signal.size());
    }

    void follow(int step, std::span<const Vec2d> nodes, std::span<const Vec2d> cells) {
        for (const Vec2d &node : nodes) left_ = std::min(left_, node.x), right_ = std::max(right_, node.x);
        if (step % path_interval) return;
        const Vec2d centre = centre_of_mass(cells);
        tables_.trace({spec_.name, rank_, step, centre.x, centre.y});
    }

    const Spec &spec_;
    int rank_;
    FrameTables &tables_;
    Steps growth_, gait_, path_;
    std::vector<Link> links_; // of body and object
    std::vector<OutlineLink> outline_;
    double left_ = std::numeric_limits<double>::infinity(), right_ = -left_; // of all nodes that moved
};

void write_individual(const Spec &spec, const Shown &shown, FrameTables &tables) {
    const RecordedIndividual &recorded = shown.recorded;
    FrameWatcher frames(spec, shown.rank, tables);
    const Life life = simulate_again(recorded, spec, frames.watch());
    if (const double fitness = spec.judge(life).fitness; fitness != recorded.fitness)
        throw InputError(recorded.file.string() + ": the best individual of '" + spec.name +
                         "' has fitness " + to_text(recorded.fitness) + " there, and is judged to have " +
                         to_text(fitness));
    frames.draw_terrain();
    tables.describe({.setting = spec.name,
                     .rank = shown.rank,
                     .seed = shown.seed,
                     .fitness = recorded.fitness,
                     .displacement = life.displacement(),
                     .cells = life.cells,
                     .elongation = life.elongation,
                     .springs = life.springs,
                     .triangles = life.triangles});
}

} // namespace

void write_frames(std::span<const Spec> settings, const std::filesystem::path &data,
                  const std::filesystem::path &out) {
    const FolderLock held = hold_for_tables(out);
    FrameTables tables(out);
    for (const Spec &spec : settings)
        for (const Shown &shown : read_shown(data, spec)) write_individual(spec, shown, tables);
    tables.commit();
}

} // namespace planula

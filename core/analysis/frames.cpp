// SPDX-License-Identifier: MIT
#include "analysis/analysis.h"
#include "analysis/simulate_again.h"
#include "base/error.h"
#include "base/text.h"
#include "body/body.h"
#include "development/embryo.h"
#include "record/run_folder.h"
#include "tables/csv.h"
#include "tables/genome_table.h"

#include <algorithm>
#include <array>
#include <optional>
#include <set>

namespace planula {

namespace {

constexpr int frames_per_stage = 6;
using Steps = std::array<int, frames_per_stage>;

/// A setting's individual in best_genomes.csv, if there is one.
std::optional<RecordedIndividual> read_recorded(const std::filesystem::path &data, const Spec &spec) {
    std::optional<RecordedIndividual> found;
    std::vector<GenomeRow> genes;
    for (const BestGenomeRow &row : read_table<BestGenomeRow>(data)) {
        if (row.setting != spec.name) continue;
        if (!found)
            found = RecordedIndividual{
                data / BestGenomeRow::file_name, {}, row.fitness, row.displacement, row.cells};
        genes.push_back({row.kind, row.id, row.from, row.to, row.value, row.recurrent});
    }
    if (!found) return found;

    try {
        found->genome = genome_of(genes);
    } catch (const InputError &error) {
        throw InputError(found->file.string() + ": setting '" + spec.name + "': " + error.what());
    }
    return found;
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

/// The tables of all settings, while they are written.
class FrameTables {
  public:
    explicit FrameTables(const std::filesystem::path &out)
        : frames_(out), cells_(out), links_(out), morphologies_(out) {}

    /// Writes one picture; `signal` may be empty for all cells at rest.
    void draw(const FrameRow &frame, std::span<const Vec2d> cells, std::span<const double> signal,
              std::span<const Link> links, std::span<const OutlineLink> rim) {
        FrameRow row = frame;
        const Vec2d centre = centre_of_mass(cells);
        row.cells = static_cast<int>(cells.size());
        row.centre_x = centre.x, row.centre_y = centre.y;
        frames_.write(row);
        for (std::size_t i = 0; i < cells.size(); ++i)
            cells_.write({row.setting, row.stage, row.frame, static_cast<int>(i), cells[i].x, cells[i].y,
                          signal.empty() ? 0 : signal[i]});
        std::set<Link> outer;
        for (const OutlineLink &link : rim)
            outer.insert({std::min(link.a, link.b), std::max(link.a, link.b)});
        for (const Link &link : links)
            links_.write({row.setting, row.stage, row.frame, cells[link.a].x, cells[link.a].y,
                          cells[link.b].x, cells[link.b].y, outer.contains(link) ? 1 : 0});
    }

    void describe(const MorphologyRow &row) { morphologies_.write(row); }

    void commit() {
        frames_.commit();
        cells_.commit();
        links_.commit();
        morphologies_.commit();
    }

  private:
    TableWriter<FrameRow> frames_;
    TableWriter<FrameCellRow> cells_;
    TableWriter<FrameLinkRow> links_;
    TableWriter<MorphologyRow> morphologies_;
};

/// Watches a simulation and draws it at the chosen steps.
class FrameWatcher {
  public:
    FrameWatcher(const Spec &spec, FrameTables &tables)
        : spec_(spec), tables_(tables), growth_(growth_steps(spec.parameters)),
          gait_(gait_steps(spec.parameters)) {
        // The first picture is the zygote, before its first decision (decision 0003).
        tables_.draw(frame("growth", 0, 0), positions(zygote(0)), {}, {}, {});
    }

    Watch watch() {
        Watch watch;
        watch.grow = [this](int step, std::span<const Vec2d> cells, std::span<const Link>) {
            for (int i = 1; i < frames_per_stage; ++i)
                if (growth_[i] == step) draw_embryo(i, step, cells);
        };
        watch.born = [this](const Body &body) { body_ = body; };
        watch.move = [this](int step, std::span<const Vec2d> nodes, std::span<const double> signal) {
            for (int i = 0; i < frames_per_stage; ++i)
                if (gait_[i] == step)
                    tables_.draw(frame("gait", i, step), nodes, signal, body_.mesh.links, body_.outline);
        };
        return watch;
    }

  private:
    FrameRow frame(const char *stage, int number, int step) const {
        return {.setting = spec_.name, .stage = stage, .frame = number, .step = step};
    }

    void draw_embryo(int number, int step, std::span<const Vec2d> cells) {
        const Parameters &p = spec_.parameters;
        const Body body =
            make_body({cells.begin(), cells.end()}, p.development.link_limit * 2 * p.development.cell_radius);
        tables_.draw(frame("growth", number, step), cells, {}, body.mesh.links, body.outline);
    }

    const Spec &spec_;
    FrameTables &tables_;
    Steps growth_, gait_;
    Body body_;
};

void write_setting(const Spec &spec, const RecordedIndividual &recorded, FrameTables &tables) {
    FrameWatcher frames(spec, tables);
    const Life life = simulate_again(recorded, spec, frames.watch());
    if (const double fitness = spec.judge(life).fitness; fitness != recorded.fitness)
        throw InputError(recorded.file.string() + ": the best individual of '" + spec.name +
                         "' has fitness " + to_text(recorded.fitness) + " there, and is judged to have " +
                         to_text(fitness));
    tables.describe({.setting = spec.name,
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
        if (const auto recorded = read_recorded(data, spec)) write_setting(spec, *recorded, tables);
    tables.commit();
}

} // namespace planula

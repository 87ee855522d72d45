// SPDX-License-Identifier: MIT
#include "analysis/analysis.h"
#include "base/error.h"
#include "core/record/fake_run.h"
#include "evaluation/live.h"
#include "tables/csv.h"
#include "tables/genome_table.h"

#include <boost/test/unit_test.hpp>
#include <map>

using namespace planula;

namespace {

Spec swimmers() {
    Spec spec = fake_spec("water", 1, 60);
    spec.actuation_range = 0.2;
    spec.environment.drag_normal = 1;
    spec.environment.drag_tangential = 0.1;
    spec.judge = [](const Life &) { return Evaluation{1.5, {0, 0}, 1}; };
    return spec;
}

struct Swimmer {
    Genome genome;
    Life life;
};

/// The first viable individual of a random population.
const Swimmer &swimmer() {
    static const Swimmer found = [] {
        const Spec spec = swimmers();
        const Population population =
            initial_population({input::count, output::count(spec.actuation), false}, spec.parameters.neat, 1);
        for (const Genome &genome : population.genomes) {
            const Life life = live(genome, spec);
            if (life.outcome == Outcome::viable) return Swimmer{genome, life};
        }
        throw std::runtime_error("nobody swims");
    }();
    return found;
}

std::vector<BestGenomeRow> recorded() {
    std::vector<BestGenomeRow> rows;
    for (const GenomeRow &gene : genome_rows(swimmer().genome))
        rows.push_back({"water", 1, 7, 1.5, swimmer().life.displacement(), swimmer().life.cells, gene.kind,
                        gene.id, gene.from, gene.to, gene.value, gene.recurrent});
    return rows;
}

void film(const TemporaryFolder &folder, const std::vector<BestGenomeRow> &rows) {
    write_table<BestGenomeRow>(folder.path(), rows);
    const std::vector<Spec> settings{swimmers(), fake_spec("land", 1, 2)};
    write_frames(settings, folder.path(), folder / "frames");
}

} // namespace

BOOST_AUTO_TEST_CASE(growth_is_shown_from_one_cell_to_the_body) {
    const TemporaryFolder folder;
    film(folder, recorded());
    std::vector<FrameRow> growth;
    for (const FrameRow &row : read_table<FrameRow>(folder / "frames"))
        if (row.stage == "growth") growth.push_back(row);
    BOOST_REQUIRE(growth.size() == 6u);
    BOOST_TEST(growth.front().cells == 1);
    BOOST_TEST(growth.front().step == 0);
    BOOST_TEST(growth.back().cells == swimmer().life.cells);
    BOOST_TEST(growth.back().step == 600);
}

BOOST_AUTO_TEST_CASE(gait_is_shown_over_the_longest_period_up_to_the_end) {
    const TemporaryFolder folder;
    film(folder, recorded());
    std::vector<int> steps;
    FrameRow last;
    for (const FrameRow &row : read_table<FrameRow>(folder / "frames"))
        if (row.stage == "gait") steps.push_back(row.step), last = row;
    BOOST_TEST((steps == std::vector<int>{3600, 3680, 3760, 3840, 3920, 4000}));
    BOOST_TEST(last.centre_x == swimmer().life.finish.x);
    BOOST_TEST(last.centre_y == swimmer().life.finish.y);
}

BOOST_AUTO_TEST_CASE(the_path_is_shown_from_rest_to_the_end_where_it_was) {
    const TemporaryFolder folder;
    film(folder, recorded());
    std::vector<FrameRow> shown;
    for (const FrameRow &row : read_table<FrameRow>(folder / "frames"))
        if (row.stage == "path") shown.push_back(row);
    BOOST_REQUIRE(shown.size() == 6u);
    BOOST_TEST(shown[1].step == 800);
    const auto path = read_table<FramePathRow>(folder / "frames");
    BOOST_REQUIRE(path.size() == 201u);
    for (const FrameRow &row : shown) {
        const FramePathRow &place = path.at(static_cast<std::size_t>(row.step) / 20);
        BOOST_TEST(place.step == row.step);
        BOOST_TEST(place.x == row.centre_x);
        BOOST_TEST(place.y == row.centre_y);
    }
    BOOST_TEST(path.front().x == swimmer().life.rest.x);
    BOOST_TEST(path.back().x == swimmer().life.finish.x);
    BOOST_TEST(read_table<FrameTerrainRow>(folder / "frames").empty()); // water
}

BOOST_AUTO_TEST_CASE(the_ground_is_shown_with_its_corners_beyond_every_cell) {
    const TemporaryFolder folder;
    Spec spec = swimmers();
    spec.environment.has_ground = true;
    spec.environment.ground = {{-1000, -50}, {0, -50}, {2, -49}, {1000, -49}};
    const Life life = live(swimmer().genome, spec);
    std::vector<BestGenomeRow> rows = recorded();
    for (BestGenomeRow &row : rows) row.displacement = life.displacement();
    write_table<BestGenomeRow>(folder.path(), rows);
    write_frames(std::span(&spec, 1), folder.path(), folder / "frames");
    double left = 0, right = 0;
    for (const FrameCellRow &cell : read_table<FrameCellRow>(folder / "frames"))
        if (cell.stage != "growth") left = std::min(left, cell.x), right = std::max(right, cell.x);
    const auto ground = read_table<FrameTerrainRow>(folder / "frames");
    BOOST_REQUIRE(ground.size() == 4u);
    BOOST_TEST(ground[0].x <= left - 10);
    BOOST_TEST(ground[0].y == -50);
    BOOST_TEST(ground[1].x == 0);
    BOOST_TEST(ground[2].y == -49);
    BOOST_TEST(ground[3].x >= right + 10);
    BOOST_TEST(ground[3].point == 3);
}

BOOST_AUTO_TEST_CASE(the_best_of_several_runs_are_told_apart) {
    const TemporaryFolder folder;
    std::vector<BestGenomeRow> rows = recorded(), second = recorded();
    for (BestGenomeRow &row : second) row.rank = 2, row.seed = 5;
    rows.insert(rows.end(), second.begin(), second.end());
    film(folder, rows);
    std::map<int, int> frames;
    for (const FrameRow &row : read_table<FrameRow>(folder / "frames")) ++frames[row.rank];
    BOOST_TEST((frames == std::map<int, int>{{1, 18}, {2, 18}}));
    const auto described = read_table<MorphologyRow>(folder / "frames");
    BOOST_REQUIRE(described.size() == 2u);
    BOOST_TEST(described[0].seed == 7);
    BOOST_TEST(described[1].rank == 2);
    BOOST_TEST(described[1].seed == 5);
}

BOOST_AUTO_TEST_CASE(every_frame_has_its_cells_and_links) {
    const TemporaryFolder folder;
    film(folder, recorded());
    std::map<std::pair<std::string, int>, int> cells, links, rim;
    for (const FrameCellRow &row : read_table<FrameCellRow>(folder / "frames")) {
        ++cells[{row.stage, row.frame}];
        BOOST_TEST((row.signal >= -1 && row.signal <= 1));
        if (row.stage == "growth") BOOST_TEST(row.signal == 0);
    }
    for (const FrameLinkRow &row : read_table<FrameLinkRow>(folder / "frames")) {
        ++links[{row.stage, row.frame}];
        rim[{row.stage, row.frame}] += row.outline;
    }
    for (const FrameRow &row : read_table<FrameRow>(folder / "frames"))
        BOOST_TEST((cells[{row.stage, row.frame}]) == row.cells);
    const Life &life = swimmer().life;
    for (int frame = 0; frame < 6; ++frame) BOOST_TEST((links[{"gait", frame}]) == life.springs);
    BOOST_TEST((links[{"growth", 5}]) == life.springs);
    BOOST_TEST((links[{"growth", 0}]) == 0);
    BOOST_TEST((rim[{"growth", 5}]) == (rim[{"gait", 5}]));
    BOOST_TEST((rim[{"gait", 5}]) > 0);
    BOOST_TEST((rim[{"gait", 5}]) <= life.springs);
}

BOOST_AUTO_TEST_CASE(the_body_is_described) {
    const TemporaryFolder folder;
    film(folder, recorded());
    const auto rows = read_table<MorphologyRow>(folder / "frames");
    BOOST_REQUIRE(rows.size() == 1u);
    BOOST_TEST(rows[0].setting == "water");
    BOOST_TEST(rows[0].fitness == 1.5);
    BOOST_TEST(rows[0].displacement == swimmer().life.displacement());
    BOOST_TEST(rows[0].springs == swimmer().life.springs);
    BOOST_TEST(rows[0].triangles == swimmer().life.triangles);
}

BOOST_AUTO_TEST_CASE(a_life_that_is_not_the_recorded_one_is_refused) {
    const TemporaryFolder folder;
    std::vector<BestGenomeRow> rows = recorded();
    for (BestGenomeRow &row : rows) row.displacement = std::nextafter(row.displacement, 1000);
    const std::string said = message_of<InputError>([&] { film(folder, rows); });
    BOOST_TEST(contains(said, "best_genomes.csv: the best individual of 'water' moved"));
    BOOST_TEST(contains(said, "the data are of another experiment or version"));
    BOOST_TEST(!std::filesystem::exists(folder / "frames/frames.csv"));
}

BOOST_AUTO_TEST_CASE(a_life_with_another_judgement_is_refused) {
    const TemporaryFolder folder;
    std::vector<BestGenomeRow> rows = recorded();
    for (BestGenomeRow &row : rows) row.fitness = 1.25;
    BOOST_TEST(contains(message_of<InputError>([&] { film(folder, rows); }),
                        "the best individual of 'water' has fitness 1.25 there, and is judged to have 1.5"));
    BOOST_TEST(!std::filesystem::exists(folder / "frames/frames.csv"));
}

BOOST_AUTO_TEST_CASE(a_genome_that_does_not_fit_is_refused) {
    const TemporaryFolder folder;
    std::vector<BestGenomeRow> rows = recorded();
    rows[2].kind = "bias";
    BOOST_TEST(
        contains(message_of<InputError>([&] { film(folder, rows); }), "setting 'water', rank 1: genome "));
    rows = recorded();
    for (BestGenomeRow &row : rows) row.setting = "land";
    std::vector<Spec> settings{fake_spec("land", 1, 2)};
    settings[0].actuation = Actuation::grn;
    write_table<BestGenomeRow>(folder.path(), rows);
    BOOST_TEST(
        contains(message_of<InputError>([&] { write_frames(settings, folder.path(), folder / "frames"); }),
                 "a genome with 9 inputs and 6 outputs does not fit the actuation 'grn'"));
}

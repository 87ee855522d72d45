// SPDX-License-Identifier: MIT
// Runs made by hand: whatever lives a test wants, recorded as a real run would be. And a folder to put them.
#pragma once

#include "base/text.h"
#include "record/run_writer.h"

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <sstream>
#include <string>
#include <unistd.h>
#include <vector>

namespace planula {

/// An empty folder that goes with the test.
class TemporaryFolder {
  public:
    TemporaryFolder() {
        std::string name = (std::filesystem::temp_directory_path() / "planula-XXXXXX").string();
        if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
        path_ = name;
    }
    ~TemporaryFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    TemporaryFolder(const TemporaryFolder &) = delete;
    TemporaryFolder &operator=(const TemporaryFolder &) = delete;

    const std::filesystem::path &path() const { return path_; }
    std::filesystem::path operator/(const std::string &name) const { return path_ / name; }

  private:
    std::filesystem::path path_;
};

inline std::string read_bytes(const std::filesystem::path &path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

inline void write_bytes(const std::filesystem::path &path, const std::string &bytes) {
    std::ofstream(path, std::ios::binary) << bytes;
}

/// The message of the Kind of error that an action throws; "" if it throws none.
template <class Kind, class Action> std::string message_of(Action &&action) {
    try {
        action();
    } catch (const Kind &error) {
        return error.what();
    }
    return "";
}

inline bool contains(const std::string &text, const std::string &part) {
    return text.find(part) != std::string::npos;
}

/// What an invented individual did.
struct FakeLife {
    double fitness = 1;
    Vec2d moved{1, 0};
    int cells = 10;
    Outcome outcome = Outcome::viable;
    double elongation = 2;
};

using Invent = std::function<FakeLife(int generation, int slot)>;

/// A search that keeps the archive it is given.
struct FakeSearch : Search {
    std::vector<ArchiveEntry> entries;
    double threshold = 0;

    std::vector<double> score(const Population &, std::span<const Evaluation>) override { return {}; }
    Population next(const Population &population, std::span<const double>, const NetworkShape &,
                    std::uint64_t) const override {
        return population;
    }
    bool keeps_archive() const override { return threshold > 0; }
    std::span<const ArchiveEntry> archive() const override { return entries; }
    double archive_threshold() const override { return threshold; }
    void save(StateWriter &) const override {}
    void load(StateReader &) override {}
};

inline Spec fake_spec(const std::string &name, int generations, int population) {
    Spec spec;
    spec.name = name;
    spec.title = "A setting called \"" + name + "\", invented";
    spec.parameters.generations = generations;
    spec.parameters.population = population;
    spec.judge = [](const Life &) { return Evaluation{}; };
    return spec;
}

inline RunIdentity fake_identity(const std::string &resolved = "resolved") {
    return {"fake.lua", "return {} -- a script\n", resolved};
}

inline Life life_of(const FakeLife &fake, const Parameters &parameters) {
    Life life;
    life.outcome = fake.outcome;
    life.cells = life.largest = life.births = fake.cells;
    life.elongation = fake.elongation;
    if (fake.outcome != Outcome::viable) return life;
    life.rest = {0.25, 0.5};
    life.end = life.rest + fake.moved;
    life.late_actuation = 0.375;
    const int samples = parameters.locomotion_steps / parameters.path_interval;
    for (int i = 0; i <= samples; ++i)
        life.path.push_back(life.rest + fake.moved * (static_cast<double>(i) / samples));
    return life;
}

/// Hands the writer one generation. With a `threshold` the search has an archive, which takes the best of
/// every generation.
inline void observe_fake(RunWriter &writer, const Spec &spec, Population &population, FakeSearch &search,
                         int generation, const Invent &invent) {
    std::vector<Life> lives;
    std::vector<Evaluation> evaluations;
    std::vector<double> scores;
    int best = 0;
    for (int slot = 0; slot < spec.parameters.population; ++slot) {
        const FakeLife fake = invent(generation, slot);
        lives.push_back(life_of(fake, spec.parameters));
        const bool viable = fake.outcome == Outcome::viable;
        evaluations.push_back({viable ? fake.fitness : 0, {fake.moved.x, fake.moved.y}, viable ? 1.0 : 0.0});
        scores.push_back(evaluations.back().fitness);
        if (evaluations[slot].fitness > evaluations[best].fitness) best = slot;
        population.genomes[slot].id = std::int64_t{generation} * spec.parameters.population + slot;
    }
    population.generation = generation;
    if (search.threshold > 0)
        search.entries.push_back(
            {generation, population.genomes[best].id, evaluations[best].behaviour, 1.5 + generation});
    writer.observe({generation, population, lives, evaluations, scores, search, best});
}

/// A population of minimal genomes, all of one species.
inline Population fake_population(const Spec &spec, std::uint64_t seed) {
    Population population =
        initial_population({input::count, output::count(spec.actuation), false}, spec.parameters, seed);
    Species all{.id = 7};
    for (int slot = 0; slot < spec.parameters.population; ++slot) all.members.push_back(slot);
    all.representative = population.genomes.front();
    population.species = {all};
    return population;
}

/// Writes a whole run below `runs` and returns its folder.
inline std::filesystem::path write_fake_run(const std::filesystem::path &runs, const Spec &spec,
                                            std::uint64_t seed, const Invent &invent, double threshold = 0) {
    const std::filesystem::path folder = run_folder(runs, spec.name, seed);
    RunWriter writer(folder, spec, seed, fake_identity());
    Population population = fake_population(spec, seed);
    FakeSearch search;
    search.threshold = threshold;
    for (int generation = 0; generation < spec.parameters.generations; ++generation)
        observe_fake(writer, spec, population, search, generation, invent);
    writer.finish();
    return folder;
}

} // namespace planula

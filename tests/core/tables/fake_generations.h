// SPDX-License-Identifier: MIT
// Generations made by hand, with the lives that a test states.
#pragma once

#include "base/state.h"
#include "cell/channels.h"
#include "core/storage/temporary_folder.h"
#include "evolution/search.h"
#include "experiment/run.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace planula {

/// What an invented individual did.
struct FakeLife {
    double fitness = 1;
    Vec2d moved{1, 0};
    int cells = 10;
    Outcome outcome = Outcome::viable;
    double elongation = 2;
    double late_actuation = 0.375;
};

using Invent = std::function<FakeLife(int generation, int slot)>;

/// A search in which all scores are 0. That of a setting with an archive adds the best of every generation to it.
struct FakeSearch : Search {
    bool has_archive = false;
    std::vector<ArchiveEntry> entries;

    std::vector<double> score(const Population &, std::span<const Evaluation>) override { return {}; }
    Population next(const Population &population, std::span<const double>, const NetworkShape &,
                    std::uint64_t) const override {
        return population;
    }
    bool keeps_archive() const override { return has_archive; }
    std::span<const ArchiveEntry> archive() const override { return entries; }
    double archive_threshold() const override { return has_archive ? 0.5 : 0; }
    /// As the setting's own search has it, which reads it back.
    void save(const Population &, StateWriter &writer) const override {
        if (!has_archive) {
            writer.group("fitness search");
            return;
        }
        writer.group("novelty search").group("archive").real(archive_threshold()).integer(0).integer(0);
        writer.integer(entries.empty() ? 0 : 2).integer(static_cast<std::int64_t>(entries.size()));
    }
    void load(const Population &, std::span<const ArchiveEntry>, StateReader &) override {}
};

/// `search`: "neat", or "novelty" for a run with an archive.
inline Spec fake_spec(const std::string &name, int generations, int population,
                      const std::string &search = "neat") {
    Spec spec;
    spec.name = name;
    spec.title = "A setting called \"" + name + "\", invented";
    spec.search = search;
    spec.parameters.design.generations = generations;
    spec.parameters.neat.population = population;
    spec.judge = [](const Life &) { return Evaluation{}; };
    spec.judgement = {{"fitness", std::string(64, 'a'), "fake.lua:1"}};
    return spec;
}

inline Life life_of(const FakeLife &fake, const Parameters &parameters) {
    Life life;
    life.outcome = fake.outcome;
    life.cells = life.largest = life.births = fake.cells;
    life.elongation = fake.elongation;
    if (fake.outcome != Outcome::viable) return life;
    life.rest = {0.25, 0.5};
    life.finish = life.rest + fake.moved;
    life.late_actuation = fake.late_actuation;
    const int samples = parameters.gait.locomotion_steps / parameters.gait.path_interval;
    for (int i = 0; i <= samples; ++i)
        life.path.push_back(life.rest + fake.moved * (static_cast<double>(i) / samples));
    return life;
}

/// A population of minimal genomes, all of one species.
inline Population fake_population(const Spec &spec, std::uint64_t seed) {
    Population population =
        initial_population({input::count, output::count(spec.actuation), false}, spec.parameters.neat, seed);
    Species all{.id = 7};
    for (int slot = 0; slot < spec.parameters.neat.population; ++slot) all.members.push_back(slot);
    all.representative = population.genomes.front();
    population.species = {all};
    population.next_species = 10;
    return population;
}

/// A run whose lives are invented: in every generation the same genomes under new numbers.
class FakeRun {
  public:
    FakeRun(const Spec &spec, std::uint64_t seed) : spec_(spec) {
        auto search = std::make_unique<FakeSearch>();
        search->has_archive = spec.search != "neat";
        search_ = search.get();
        state_ = {fake_population(spec, seed), std::move(search), {}};
    }

    /// That of the next generation; its genomes are numbered when that comes.
    Population &population() { return state_.population; }

    /// Calls visit(generation) for the next generation.
    template <class Visit> void observe(const Invent &invent, Visit &&visit) {
        Population &population = state_.population;
        const int generation = population.generation, size = spec_.parameters.neat.population;
        std::vector<Life> lives;
        std::vector<Evaluation> evaluations;
        std::vector<double> scores;
        int best = 0;
        for (int slot = 0; slot < size; ++slot) {
            const FakeLife fake = invent(generation, slot);
            lives.push_back(life_of(fake, spec_.parameters));
            const bool viable = fake.outcome == Outcome::viable;
            evaluations.push_back(
                {viable ? fake.fitness : 0, {fake.moved.x, fake.moved.y}, viable ? 1.0 : 0.0});
            scores.push_back(evaluations.back().fitness);
            if (evaluations[slot].fitness > evaluations[best].fitness) best = slot;
        }
        if (search_->has_archive)
            search_->entries.push_back({generation, population.genomes[best].id, evaluations[best].behaviour,
                                        1.5 + generation, evaluations[best].fitness});
        visit(Generation{
            generation, population, lives, evaluations, scores, *search_, state_.mothers, best, {}});
        state_.mothers.add(population, lives, evaluations);
        ++population.generation;
    }

    /// Hands the writer what a real run does for one generation.
    template <class Writer> void step(Writer &writer, const Invent &invent) {
        number_genomes();
        writer.before_generation(state_, "");
        observe(invent, [&](const Generation &generation) { writer.observe(generation); });
    }

  private:
    void number_genomes() {
        Population &population = state_.population;
        const int size = spec_.parameters.neat.population;
        population.next_genome = std::int64_t{population.generation + 1} * size;
        for (int slot = 0; slot < size; ++slot)
            population.genomes[slot].id = std::int64_t{population.generation} * size + slot;
        for (Species &species : population.species)
            species.representative = population.genomes[species.members.front()];
        state_.mothers.keep(population, {});
    }

    Spec spec_;
    RunState state_;
    FakeSearch *search_;
};

} // namespace planula

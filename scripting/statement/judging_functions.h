// SPDX-License-Identifier: MIT
// The judgement of a setting, by three Lua functions of its script:
//
//   penalty(life, parameters)           p of Eq. (6), 0 … 1; 0: not a valid individual, nothing else is asked
//   fitness(life, parameters, penalty)  f of Eq. (4), 0 … 1e100
//   behaviour(life, parameters)         the descriptor that searches read, a list of 1 … 16 numbers up to ±1e100
//
// The behaviour of a setting's `start` is asked beside its penalty for lives that end with development. Reading what is
// known only of a body that has moved (statement/wrap_life.h) is an error then.
//
// `parameters` are those that decide lives (experiment/deciding.h): neither the length of a run nor a number of
// statistics changes how a life is judged.
//
// A function that raises an error, or returns something else, makes that individual invalid; it is counted
// and the run goes on. Functions must not remember anything. What they close over must stay as it was, which is looked
// at after every call, or so often that it costs little where they close over much; and a sample of lives is judged a
// second time in a fresh Lua state, and must be judged alike there.
#pragma once

#include "evaluation/life.h"
#include "evolution/evaluation.h"
#include "language/sources.h"
#include "parameters/parameters.h"

#include <cstdint>
#include <memory>
#include <string>

namespace planula {

/// Which lives are judged: whole ones, or those before the run, by growth alone and without fitness.
enum class Stage { life, growth };

class Hooks {
  public:
    /// The functions of setting `index` (from 0) of the script, and the parameters that they are shown.
    Hooks(std::shared_ptr<Sources> sources, int index, const Parameters &parameters,
          Stage stage = Stage::life);
    ~Hooks();

    /// Judges a few made-up lives, one of each outcome. Throws InputError if a function raises an error,
    /// returns a value of another kind, or judges the same life differently the second time.
    void try_out();

    /// Begins a run: fresh functions, nothing counted.
    void begin_run();
    /// Goes on in a run that was stopped. Throws InputError for a text that is not what memory() gave.
    void continue_run(const std::string &memory);
    /// What continue_run() must know of the lives judged so far. Throws as check_unchanged() does.
    std::string memory() const;
    /// Throws InputError if the functions have changed what they close over since the run began: to be called after
    /// the last life of a run, at the latest.
    void check_unchanged() const;
    /// Throws InputError if the functions change what they close over, remember earlier calls, or exceed the limits on memory or time,
    /// which depend on the machine.
    Evaluation judge(const Life &life);

    std::int64_t invalid() const { return invalid_; }
    /// What was wrong with the first invalid individual of the run.
    const std::string &first_problem() const { return first_problem_; }

  private:
    class Functions;
    struct Verdict;
    Verdict judge_twice(const Life &life);

    std::shared_ptr<Sources> sources_;
    int index_;
    Parameters parameters_;
    Stage stage_;
    std::unique_ptr<Functions> functions_;
    std::int64_t calls_ = 0, invalid_ = 0;
    std::string first_problem_;
};

} // namespace planula

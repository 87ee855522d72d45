// SPDX-License-Identifier: MIT
// The functions of a script that judge the individuals of a setting, in Lua:
//
//   penalty(life, parameters)           p of Eq. (6), 0 … 1; 0: the individual is invalid, no other function is called
//   fitness(life, parameters, penalty)  f of Eq. (4), 0 … 1e100
//   behaviour(life, parameters)         the descriptor that searches read, a list of 1 … 16 numbers up to ±1e100, as
//                                       many as the setting's `descriptor` names, if it does
//   value(life, parameters, penalty)    of each of the setting's `objectives`, a number up to ±1e100
//
// The behaviour function of a setting's `start` is called, with the setting's penalty, for individuals that have grown
// but not moved. Reading what is known only after movement (statement/wrap_life.h) is an error then.
//
// `parameters` are those that decide lives (experiment/deciding.h): neither the length of a run nor a parameter of
// statistics changes how a life is judged.
//
// If a function raises an error or returns something else, the individual is invalid; it is counted, and the run goes
// on. Functions must not keep anything from one life to the next. What they close over must not change: this is checked
// after every life. A sample of lives is judged a second time in a fresh Lua state, with the same result
// (decision 0028).
#pragma once

#include "evaluation/life.h"
#include "evolution/evaluation.h"
#include "language/sources.h"
#include "parameters/parameters.h"

#include <cstdint>
#include <memory>
#include <string>

namespace planula {

/// Which lives are judged: complete ones, or those of a start, which have only grown and have no fitness.
enum class Stage { life, growth };

class JudgingFunctions {
  public:
    /// The functions of setting `index` (from 0) of the script, and the parameters that they are given.
    JudgingFunctions(std::shared_ptr<Sources> sources, int index, const Parameters &parameters,
                     Stage stage = Stage::life);
    ~JudgingFunctions();

    /// The number of their setting in the script, from 0.
    int setting() const { return index_; }

    /// Judges one example of each outcome, with these observations. Throws InputError if a function raises an error,
    /// returns a value of another kind, or judges the same life differently the second time.
    void try_out(const ObservationSet &observed = {});

    /// Begins a run: fresh functions, nothing counted.
    void begin_run();
    /// Resumes a run that was stopped. Throws InputError for a text that is not one of memory().
    void continue_run(const std::string &memory);
    /// What continue_run() needs of the lives judged so far. Throws as check_unchanged() does.
    std::string memory() const;
    /// Throws InputError if the functions have changed what they close over since the run began; to be called after the
    /// last life of a run at the latest.
    void check_unchanged() const;
    /// Throws InputError if the functions change what they close over, depend on earlier calls, or exceed the limits on
    /// memory or time, which depend on the machine.
    Evaluation judge(const Life &life);
    /// What judge() gives, and why the life is invalid if the functions are the reason.
    struct Tried {
        Evaluation evaluation;
        std::string problem;     // "file:line: …"; empty without a problem
        bool wrong_kind = false; // an error, or a value of another kind, and not a number out of range
    };
    /// The same without counting it as one of the run. Throws as judge() does.
    Tried try_on(const Life &life);

    std::int64_t invalid() const { return invalid_; }
    /// What was wrong with the first invalid individual of the run.
    const std::string &first_problem() const { return first_problem_; }

  private:
    class Functions;
    struct Verdict;
    /// Those of the run, made when they are first needed: an experiment of many settings holds few Lua states.
    Functions &functions() const;
    std::unique_ptr<Functions> fresh_functions() const;
    Verdict judge_twice(const Life &life);
    void check_equal(const Verdict &verdict, const Verdict &fresh) const;

    std::shared_ptr<Sources> sources_;
    int index_;
    Parameters parameters_;
    Stage stage_;
    mutable std::unique_ptr<Functions> functions_;
    std::int64_t calls_ = 0, invalid_ = 0;
    std::string first_problem_;
};

} // namespace planula

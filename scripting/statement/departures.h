// SPDX-License-Identifier: MIT
// Where the settings of an experiment depart from the paper. The paper's side is the script of its replication,
// paper/replication.lua of the library: each setting is compared with the one there that has the same actuation, has
// ground or none as it has, and, if there is one, the same search. Of the environment, and of what
// happens to a body in it, everything is compared that is part of a run's identity.
#pragma once

#include "statement/meaning.h"
#include "statement/schema.h"

#include <filesystem>
#include <string>
#include <vector>

namespace planula {

struct Departure {
    std::string part;               // environment, search, engine, start, function or parameter
    std::string name;               // "drag normal"
    std::string value, paper;       // with units; of a function its place
    std::string origin;             // of the paper's value, if it is that of a parameter
    std::string note;               // where the value comes from, what a function uses or a parameter means
    std::vector<std::string> lines; // of a function: its text against the paper's (statement/line_diff.h)

    bool operator==(const Departure &) const = default;
};

class Comparison {
  public:
    /// Reads the paper's script. `experiment` must outlive the comparison.
    Comparison(const Experiment &experiment, const std::filesystem::path &library);

    const Experiment &paper() const { return paper_; }
    /// The setting of the paper that setting `index` is compared with.
    const Spec &counterpart(std::size_t index) const { return paper_.settings[counterpart_index(index)]; }
    /// What differs, in the order of the parts above.
    std::vector<Departure> of_setting(std::size_t index);

  private:
    std::size_t counterpart_index(std::size_t index) const;
    /// Where a part of the environment comes from: a parameter or a line.
    std::string source_note(std::size_t index, const std::string &name) const;
    void add_environment(std::size_t index, std::vector<Departure> &found) const;
    void add_evolution(std::size_t index, std::vector<Departure> &found) const;
    void add_functions(std::size_t index, std::vector<Departure> &found);
    void add_parameters(std::size_t index, std::vector<Departure> &found);

    const Experiment &experiment_;
    const Experiment paper_;
    Meanings meanings_, paper_meanings_;
};

/// The environment of a setting without the numbers that are 0: "gravity 5 cell/t.u.², ground flat, …".
std::string environment_text(const Spec &spec);

} // namespace planula

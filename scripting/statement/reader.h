// SPDX-License-Identifier: MIT
// Reads one table of a script's result: the keys that it may have, and the kinds of their values. Errors go to
// Problems; a reader never throws.
#pragma once

#include "parameters/parameters.h"
#include "statement/keys.h"
#include "statement/problems.h"

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace planula {

class Reader {
  public:
    /// Reports keys that are not among `keys`, and list entries unless `list` is true.
    Reader(const Value &table, Place place, Keys keys, Problems &problems, bool list = false);

    /// The field, if it is there and of that kind; its absence is reported if it is needed, as its row must say.
    const Value *field(const std::string &key, Value::Kind kind, bool needed);
    /// A text of one line, as tables hold them.
    std::string text(const std::string &key, bool needed = false);
    std::optional<double> number(const std::string &key, bool needed = false);
    /// A whole number of 0 … 2^31 - 1; 0 if absent.
    int whole(const std::string &key, bool needed = false);
    /// A number, or the name of a parameter that stands for its value.
    std::optional<double> quantity(const std::string &key, const Parameters &parameters, bool needed = false);

    Place at(const std::string &key) const { return place_.at(key, table_.find(key)); }
    const Place &place() const { return place_; }
    const Value &table() const { return table_; }
    void report(const std::string &key, const std::string &message) { problems_.add(at(key), message); }

  private:
    const Value &table_;
    Place place_;
    Keys keys_;
    Problems &problems_;
};

/// Runs a check of the core and reports the InputError that it throws at a place.
void check_at(const Place &place, Problems &problems, const std::function<void()> &check);

/// "'word' is not one of a, b, c; did you mean 'b'?"
std::string not_one_of(std::string_view word, std::span<const std::string_view> names);

} // namespace planula

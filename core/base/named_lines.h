// SPDX-License-Identifier: MIT
// Values as lines of text: a name, then its values as words between single blanks. One function template that names
// things in their order serves both ways: with a LineWriter it writes them, with a LineReader it reads them back to the
// same bits. People and scripts may change a value; the names and their order are fixed.
#pragma once

#include "base/vec2.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace planula {

/// One of several values of an enum that count from 0, by its name.
template <class Value> struct Named {
    Value &value;
    std::span<const std::string_view> names;
};
template <class Value, class Names> Named<Value> named(Value &value, const Names &names) {
    return {value, names};
}

class LineWriter {
  public:
    static constexpr bool reads = false;

    template <class... Values> void line(std::string_view name, const Values &...values) {
        text_.append(name);
        (add(values), ...);
        text_ += '\n';
    }
    /// How many items there are, then those that each(item) writes.
    template <class Item, class Each>
    void list(std::string_view name, std::vector<Item> &items, const Each &each) {
        line(name, static_cast<int>(items.size()));
        for (Item &item : items) each(item);
    }
    /// Whether there is an item, then that.
    template <class Item, class Each>
    void maybe(std::string_view name, std::optional<Item> &item, const Each &each) {
        line(name, item.has_value());
        if (item) each(*item);
    }

    const std::string &text() const { return text_; }

  private:
    void add(double value);
    void add(int value);
    void add(bool value) { add(static_cast<int>(value)); }
    void add(const std::string &word);
    template <class Value> void add(const Named<Value> &one) {
        add(std::string(one.names[static_cast<std::size_t>(one.value)]));
    }
    void add(Vec2d point) { add(point.x), add(point.y); }
    template <class Value> void add(const std::optional<Value> &value) {
        value ? add(*value) : add(std::string("none"));
    }

    std::string text_;
};

/// Throws InputError with the number of the line, what stands there and what should.
class LineReader {
  public:
    static constexpr bool reads = true;

    /// `text` must outlive the reader.
    explicit LineReader(std::string_view text) : text_(text) {}

    template <class... Values> void line(std::string_view name, Values &&...values) {
        next(name);
        (take(values), ...);
        end();
    }
    template <class Item, class Each>
    void list(std::string_view name, std::vector<Item> &items, const Each &each) {
        items.assign(count(name), Item());
        for (Item &item : items) each(item);
    }
    template <class Item, class Each>
    void maybe(std::string_view name, std::optional<Item> &item, const Each &each) {
        bool is_there = false;
        line(name, is_there);
        item.reset();
        if (is_there) each(item.emplace());
    }

    /// Nothing may be left.
    void done() const;
    [[noreturn]] void refuse(const std::string &what) const;

  private:
    void next(std::string_view name);
    void end() const;
    std::size_t count(std::string_view name);
    std::string_view word();
    int place_in(std::span<const std::string_view> names);

    void take(double &value);
    void take(int &value);
    void take(bool &value);
    void take(std::string &value) { value = word(); }
    template <class Value> void take(const Named<Value> &one) {
        one.value = static_cast<Value>(place_in(one.names));
    }
    void take(Vec2d &point) { take(point.x), take(point.y); }
    template <class Value> void take(std::optional<Value> &value) {
        value.reset();
        if (rest_ == " none")
            rest_ = {};
        else
            take(value.emplace());
    }

    std::string_view text_; // what comes after this line
    std::string_view rest_; // of this line
    int number_ = 0;
};

} // namespace planula

// SPDX-License-Identifier: MIT
#include "analysis/comparison_picture.h"

#include "analysis/comparison_text.h"
#include "analysis/svg.h"
#include "base/error.h"
#include "base/math.h"
#include "base/text.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace planula {

namespace {

// Lengths are pixels.
constexpr double left = 92, right = 26, top = 66, bottom = 376, foot = 92; // of the axes, and below them
constexpr double least_column = 150;                                       // from a setting to the next
constexpr double beside = 24;                                              // from the circles to the median
constexpr double radius = 4;

using Values = std::map<std::int64_t, double>; // by seed

// ---- The axis ----

double log10_of(double value) { return math::log(value) / math::log(10); }

/// From values to heights.
class Axis {
  public:
    Axis(double low, double high, bool logarithmic) : logarithmic_(logarithmic) {
        low_ = at(low), high_ = at(high);
        const double room = high_ > low_ ? 0.06 * (high_ - low_) : std::max(0.5, 0.1 * std::abs(high_));
        low_ -= room, high_ += room;
    }
    double height(double value) const {
        return bottom - (at(value) - low_) / (high_ - low_) * (bottom - top);
    }

    /// Round numbers within the axis: 1, 2 or 5 times a power of ten apart, or on a logarithmic axis themselves so.
    std::vector<double> ticks() const {
        if (logarithmic_)
            if (std::vector<double> marks = decades(); marks.size() >= 2) return marks;
        return steps();
    }

  private:
    double at(double value) const { return logarithmic_ ? log10_of(value) : value; }
    double value_at(double place) const { return logarithmic_ ? math::pow(10, place) : place; }

    std::vector<double> decades() const {
        std::vector<double> marks;
        for (double power = std::floor(low_); power <= std::ceil(high_); power += 1)
            for (const double digit : {1.0, 2.0, 5.0}) {
                const double value = digit * math::pow(10, power), place = at(value);
                if (place >= low_ && place <= high_) marks.push_back(value);
            }
        return marks;
    }

    std::vector<double> steps() const {
        const double low = value_at(low_), high = value_at(high_), width = high - low;
        double step = math::pow(10, std::floor(log10_of(width / 4)));
        for (const double factor : {2.0, 2.5, 2.0})
            if (width / step > 6) step *= factor;
        std::vector<double> marks;
        for (double i = std::ceil(low / step); i * step <= high; i += 1) marks.push_back(i * step);
        return marks;
    }

    bool logarithmic_;
    double low_ = 0, high_ = 0;
};

/// A tick's number without what rounding has left.
std::string tick_text(double value) {
    std::string text = to_fixed(std::abs(value) < 1e-12 ? 0 : value, 6);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.ends_with('.')) text.pop_back();
    return text;
}

std::string draw_axis(const Axis &axis, double width) {
    std::string drawn = svg::line({left, top}, {left, bottom}, "stroke=\"#222222\"");
    for (const double tick : axis.ticks()) {
        const double y = axis.height(tick);
        drawn += svg::line({left, y}, {width - right, y}, "stroke=\"#e4e4e4\"") +
                 svg::line({left - 5, y}, {left, y}, "stroke=\"#222222\"") +
                 svg::text({left - 9, y + 4}, "end", 12, tick_text(tick));
    }
    return drawn;
}

// ---- Settings ----

/// What is drawn of one setting.
struct Column {
    const ComparedSettingRow *row;
    Values values;
    double x;
};

/// How far the next setting is, so that no name runs into another.
double column_width(const Comparisons &comparisons) {
    constexpr double letter = 7.3, gap = 16;
    double width = least_column;
    for (const ComparedSettingRow &row : comparisons.settings)
        width = std::max(width, letter * static_cast<double>(row.setting.size()) + gap);
    return width;
}

std::vector<Column> columns_of(const Comparisons &comparisons, const Measure &measure) {
    std::vector<Column> columns;
    const double column = column_width(comparisons);
    for (const ComparedSettingRow &row : comparisons.settings) {
        if (row.measure != measure.name) continue;
        Column &next = columns.emplace_back(
            Column{&row, {}, left + column * (static_cast<double>(columns.size()) + 0.5)});
        for (const ComparedRunRow &run : comparisons.runs)
            if (run.measure == measure.name && run.setting == row.setting && run.value)
                next.values[run.seed] = *run.value;
    }
    return columns;
}

Axis axis_of(const std::vector<Column> &columns, bool logarithmic) {
    double low = 0, high = 0;
    bool is_first = true;
    for (const Column &one : columns)
        for (const auto &[seed, value] : one.values) {
            if (logarithmic && value <= 0)
                throw InputError("a logarithmic axis needs values above 0: " + one.row->setting + ", seed " +
                                 to_text(seed) + ", has " + to_text(value));
            low = is_first ? value : std::min(low, value);
            high = is_first ? value : std::max(high, value);
            is_first = false;
        }
    if (is_first) low = high = 1; // nothing to draw
    return {low, high, logarithmic};
}

bool are_pairs(const Comparisons &comparisons, const Measure &measure, const Column &a, const Column &b) {
    return std::any_of(comparisons.rows.begin(), comparisons.rows.end(), [&](const ComparisonRow &row) {
        const bool is_theirs = (row.a == a.row->setting && row.b == b.row->setting) ||
                               (row.a == b.row->setting && row.b == a.row->setting);
        return row.measure == measure.name && is_theirs && row.pairs > 0;
    });
}

/// Whether each setting was compared in pairs with the next one.
bool all_are_pairs(const Comparisons &comparisons, const Measure &measure,
                   const std::vector<Column> &columns) {
    for (std::size_t i = 0; i + 1 < columns.size(); ++i)
        if (!are_pairs(comparisons, measure, columns[i], columns[i + 1])) return false;
    return true;
}

std::string draw_pairs(const Column &a, const Column &b, const Axis &axis) {
    std::string drawn;
    for (const auto &[seed, value] : a.values) {
        const auto other = b.values.find(seed);
        if (other == b.values.end()) continue;
        const bool falls = other->second < value;
        drawn += svg::line({a.x, axis.height(value)}, {b.x, axis.height(other->second)},
                           falls ? "stroke=\"#8c8c8c\" stroke-dasharray=\"4 4\"" : "stroke=\"#8c8c8c\"");
    }
    return drawn;
}

/// A circle for each run, whose seed shows where one points at it.
std::string draw_runs(const Column &one, const Axis &axis) {
    std::string drawn;
    for (const auto &[seed, value] : one.values)
        drawn +=
            "<circle cx=\"" + svg::number(one.x) + "\" cy=\"" + svg::number(axis.height(value)) + "\" r=\"" +
            svg::number(radius) +
            "\" fill=\"#ffffff\" fill-opacity=\"0.7\" stroke=\"#222222\" stroke-width=\"1.2\"><title>seed " +
            to_text(seed) + ": " + to_text(value) + "</title></circle>\n";
    return drawn;
}

/// A diamond, with its interval as a bar.
std::string draw_median(const Column &one, double x, const Axis &axis) {
    if (!one.row->median) return "";
    constexpr double half = 6;
    const double y = axis.height(*one.row->median);
    std::string drawn;
    if (one.row->low)
        drawn += svg::line({x, axis.height(*one.row->low)}, {x, axis.height(*one.row->high)},
                           "stroke=\"#000000\" stroke-width=\"2.5\"");
    return drawn + "<path d=\"M " + svg::point({x, y - half}) + " L " + svg::point({x + half, y}) + " L " +
           svg::point({x, y + half}) + " L " + svg::point({x - half, y}) + " Z\" fill=\"#000000\"/>\n";
}

/// Of two settings, what the comparison says.
std::string result_words(const Comparisons &comparisons, const Measure &measure) {
    const ComparisonRow *only = nullptr;
    for (const ComparisonRow &row : comparisons.rows) {
        if (row.measure != measure.name) continue;
        if (only) return "";
        only = &row;
    }
    if (!only || !only->p) return "";
    return "Wilcoxon " + only->test + " test, " + only->method + ": " + p_text(*only->p);
}

} // namespace

std::string svg_of(const Comparisons &comparisons, const Measure &measure, bool logarithmic) {
    const std::vector<Column> columns = columns_of(comparisons, measure);
    const Axis axis = axis_of(columns, logarithmic);
    const double width =
        std::max(440.0, left + column_width(comparisons) * static_cast<double>(columns.size()) + right);
    std::string drawn = draw_axis(axis, width), medians;
    bool any_interval = false;
    const bool pairs = all_are_pairs(comparisons, measure, columns);
    for (std::size_t i = 0; pairs && i + 1 < columns.size(); ++i)
        drawn += draw_pairs(columns[i], columns[i + 1], axis);
    for (std::size_t i = 0; i < columns.size(); ++i) {
        const Column &one = columns[i];
        drawn += draw_runs(one, axis) + svg::text({one.x, bottom + 20}, "middle", 13, one.row->setting) +
                 svg::text({one.x, bottom + 36}, "middle", 11, "n = " + to_text(one.row->runs));
        medians +=
            draw_median(one, one.x + (i == 0 ? -beside : beside), axis); // lines leave the first to the right
        any_interval = any_interval || one.row->low.has_value();
    }
    const std::string title = measure.words() + " after " + to_text(comparisons.generations) + " generations";
    const std::string unit = measure.unit_words().empty() ? "" : "," + measure.unit_words();
    const std::string median_key =
        "circle: a run; diamond: median" +
        (any_interval ? " with " + percent_text(comparisons.confidence) + " interval" : std::string());
    drawn += medians + svg::text({width / 2, 26}, "middle", 16, title) +
             svg::text({width / 2, 46}, "middle", 12, result_words(comparisons, measure)) +
             svg::text({24, (top + bottom) / 2}, "middle", 13,
                       measure.words() + unit + (logarithmic ? ", logarithmic" : ""),
                       "transform=\"rotate(-90 24 " + svg::number((top + bottom) / 2) + ")\"") +
             svg::text({width / 2, bottom + 62}, "middle", 11, median_key) +
             svg::text({width / 2, bottom + 77}, "middle", 11,
                       pairs ? "lines: the same seed, dashed where it falls" : "");
    return svg::picture(width, bottom + foot,
                        "<g " + std::string(svg::font) + " stroke-linecap=\"round\">\n" + drawn + "</g>\n");
}

} // namespace planula

// SPDX-License-Identifier: MIT
#include "base/named_lines.h"

#include "base/error.h"
#include "base/text.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace planula {

void LineWriter::add(double value) { add(to_text(value)); }
void LineWriter::add(int value) { add(to_text(value)); }
void LineWriter::add(const std::string &word) { text_.append(" ").append(word); }

void LineReader::refuse(const std::string &what) const {
    throw InputError("line " + to_text(number_) + ": " + what);
}

void LineReader::next(std::string_view name) {
    ++number_;
    if (text_.empty()) refuse("the text ends before '" + std::string(name) + "'");
    const std::size_t length = std::min(text_.find('\n'), text_.size());
    rest_ = text_.substr(0, length);
    text_.remove_prefix(std::min(length + 1, text_.size()));
    if (!rest_.starts_with(name) || (rest_.size() > name.size() && rest_[name.size()] != ' '))
        refuse("expected '" + std::string(name) + "', not '" + std::string(rest_) + "'");
    rest_.remove_prefix(name.size());
}

void LineReader::end() const {
    if (!rest_.empty()) refuse("'" + std::string(rest_.substr(1)) + "' is left over");
}

std::string_view LineReader::word() {
    if (rest_.size() < 2) refuse("a value is missing");
    rest_.remove_prefix(1);
    const std::string_view found = rest_.substr(0, rest_.find(' '));
    rest_.remove_prefix(found.size());
    return found;
}

void LineReader::take(double &value) {
    const std::string_view said = word();
    const std::optional<double> number = parse_double(said);
    if (!number || std::isnan(*number)) refuse("'" + std::string(said) + "' is not a number");
    value = *number;
}

void LineReader::take(int &value) {
    const std::string_view said = word();
    const std::optional<std::int64_t> number = parse_int(said);
    if (!number || *number < std::numeric_limits<int>::min() || *number > std::numeric_limits<int>::max())
        refuse("'" + std::string(said) + "' is not a whole number");
    value = static_cast<int>(*number);
}

void LineReader::take(bool &value) {
    const std::string_view said = word();
    if (said != "0" && said != "1") refuse("'" + std::string(said) + "' is neither 0 nor 1");
    value = said == "1";
}

int LineReader::place_in(std::span<const std::string_view> names) {
    const std::string_view said = word();
    const auto found = std::find(names.begin(), names.end(), said);
    if (found == names.end())
        refuse("'" + std::string(said) + "' is none of " + list_of(names) + suggestion(said, names));
    return static_cast<int>(found - names.begin());
}

/// Each item takes a line at least.
std::size_t LineReader::count(std::string_view name) {
    int items = 0;
    line(name, items);
    if (items < 0 || items > std::count(text_.begin(), text_.end(), '\n'))
        refuse(to_text(items) + " items cannot follow");
    return static_cast<std::size_t>(items);
}

void LineReader::done() const {
    if (!text_.empty())
        throw InputError("line " + to_text(number_ + 1) + ": '" +
                         std::string(text_.substr(0, text_.find('\n'))) + "' is left over");
}

} // namespace planula

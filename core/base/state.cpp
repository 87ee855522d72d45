// SPDX-License-Identifier: MIT
#include "base/state.h"

#include "base/error.h"
#include "base/text.h"

#include <bit>
#include <cmath>
#include <limits>

namespace planula {

StateWriter &StateWriter::integer(std::int64_t value) {
    auto bits = static_cast<std::uint64_t>(value);
    for (int byte = 0; byte < 8; ++byte, bits >>= 8) bytes_.push_back(static_cast<char>(bits & 0xff));
    return *this;
}

StateWriter &StateWriter::real(double value) { return integer(std::bit_cast<std::int64_t>(value)); }

StateWriter &StateWriter::text(std::string_view value) {
    integer(static_cast<std::int64_t>(value.size()));
    bytes_.append(value);
    return *this;
}

void StateReader::group(std::string_view name) {
    const std::string found = text();
    if (found != name) refuse("expected the group '" + std::string(name) + "'");
    group_ = name;
}

std::int64_t StateReader::integer() { return static_cast<std::int64_t>(word()); }

std::int64_t StateReader::integer(std::int64_t lowest, std::int64_t highest) {
    const std::int64_t value = integer();
    if (value < lowest || value > highest)
        refuse(to_text(value) + " is not between " + to_text(lowest) + " and " + to_text(highest));
    return value;
}

int StateReader::small_integer() {
    return static_cast<int>(integer(std::numeric_limits<int>::min(), std::numeric_limits<int>::max()));
}

double StateReader::real() { return std::bit_cast<double>(word()); }

double StateReader::finite() {
    const double value = real();
    if (!std::isfinite(value)) refuse(to_text(value) + " is not finite");
    return value;
}

std::string StateReader::text() { return std::string(take(count(1))); }

std::size_t StateReader::count(std::size_t least_bytes) {
    const std::uint64_t value = word();
    if (value > (bytes_.size() - at_) / least_bytes) refuse("a list is longer than what is left");
    return value;
}

void StateReader::done() const {
    if (at_ != bytes_.size()) refuse("bytes are left over");
}

void StateReader::refuse(std::string_view rule) const {
    throw InputError("saved state, byte " + to_text(static_cast<std::int64_t>(at_)) +
                     (group_.empty() ? "" : ", in '" + group_ + "'") + ": " + std::string(rule));
}

std::uint64_t StateReader::word() {
    std::uint64_t value = 0;
    const std::string_view bytes = take(8);
    for (int byte = 7; byte >= 0; --byte) value = value << 8 | static_cast<unsigned char>(bytes[byte]);
    return value;
}

std::string_view StateReader::take(std::size_t size) {
    if (size > bytes_.size() - at_) refuse("it ends too early");
    const std::string_view taken = bytes_.substr(at_, size);
    at_ += size;
    return taken;
}

} // namespace planula

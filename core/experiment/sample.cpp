// SPDX-License-Identifier: MIT
#include "experiment/sample.h"

#include "base/text.h"

namespace planula {

namespace {

constexpr std::string_view full_name = "full", sample_name = "sample", number_follows = "sample of ";

} // namespace

std::string name_of(const Recording &record) {
    if (record.full) return std::string(full_name);
    if (record.least == recorded_least) return std::string(sample_name);
    return std::string(number_follows) + to_text(record.least);
}

std::optional<Recording> record_of(std::string_view name) {
    if (name == full_name) return full_record;
    if (name == sample_name) return sample_record;
    if (!name.starts_with(number_follows)) return std::nullopt;
    const auto least = parse_int(name.substr(number_follows.size()));
    if (!least || *least < 1 || *least > recorded_most) return std::nullopt;
    const Recording record{.full = false, .least = static_cast<int>(*least)};
    return name_of(record) == name ? std::optional(record) : std::nullopt; // one name per record
}

} // namespace planula

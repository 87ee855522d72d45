// SPDX-License-Identifier: MIT
// JSON (RFC 8259), written; there is no reader.
#pragma once

#include <string>
#include <string_view>

namespace planula {

/// The text as a string of JSON, in quotes. Control characters are escaped; all other bytes stay, so that valid UTF-8
/// gives valid JSON.
std::string json_text(std::string_view text);
/// The shortest decimal that reads back to the same bits; null unless finite.
std::string json_number(double value);

/// "[…]" of what text_of returns for each value.
template <class Values, class TextOf> std::string json_list(const Values &values, TextOf &&text_of) {
    std::string all;
    for (const auto &value : values) all.append(all.empty() ? "" : ",").append(text_of(value));
    return "[" + all + "]";
}

/// An object, member by member.
class JsonObject {
  public:
    /// `value` is JSON.
    JsonObject &add(std::string_view name, std::string_view value) {
        members_.append(members_.empty() ? "" : ",").append(json_text(name)).append(":").append(value);
        return *this;
    }
    std::string text() const { return "{" + members_ + "}"; }

  private:
    std::string members_;
};

} // namespace planula

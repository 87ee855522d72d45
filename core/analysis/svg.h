// SPDX-License-Identifier: MIT
// The parts of pictures as SVG text; lengths are pixels.
#pragma once

#include "base/vec2.h"

#include <string>
#include <string_view>

namespace planula::svg {

inline constexpr std::string_view ink = "#222222";
inline constexpr std::string_view font = "font-family=\"Helvetica, Arial, sans-serif\"";

/// With one digit after the point.
std::string number(double value);
std::string point(Vec2d v);

/// A text, whatever characters it holds; `anchor`: start, middle or end. `more`: other attributes.
std::string text(Vec2d at, std::string_view anchor, int size, std::string_view words,
                 std::string_view more = "");

std::string line(Vec2d from, Vec2d to, std::string_view style);

/// A whole picture on white.
std::string picture(double width, double height, const std::string &content);

} // namespace planula::svg

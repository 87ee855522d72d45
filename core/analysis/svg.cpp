// SPDX-License-Identifier: MIT
#include "analysis/svg.h"

#include "base/markup.h"
#include "base/text.h"

namespace planula::svg {

std::string number(double value) { return to_fixed(value, 1); }
std::string point(Vec2d v) { return number(v.x) + " " + number(v.y); }

std::string text(Vec2d at, std::string_view anchor, int size, std::string_view words, std::string_view more) {
    std::string element = "<text x=\"" + number(at.x) + "\" y=\"" + number(at.y) + "\" text-anchor=\"";
    element.append(anchor).append("\" font-size=\"").append(to_text(size)).append("\"");
    if (!more.empty()) element.append(" ").append(more);
    return element + ">" + markup_text(words) + "</text>\n";
}

std::string line(Vec2d from, Vec2d to, std::string_view style) {
    return "<path d=\"M " + point(from) + " L " + point(to) + "\" " + std::string(style) + "/>\n";
}

std::string picture(double width, double height, const std::string &content) {
    const std::string size = "width=\"" + number(width) + "\" height=\"" + number(height) + "\"";
    return "<svg xmlns=\"http://www.w3.org/2000/svg\" " + size + " viewBox=\"0 0 " + number(width) + " " +
           number(height) + "\">\n<rect " + size + " fill=\"#ffffff\"/>\n" + content + "</svg>\n";
}

} // namespace planula::svg

// SPDX-License-Identifier: MIT
// Pages for a browser that need nothing beside themselves: the viewer of recordings (viewer.js), its styles, and the
// data, compressed, in one file. The sources of the viewer travel inside the program.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace planula {

/// What a page needs to show recordings: the content of a <script> element, which defines planula.mountReplay() and
/// planula.unpack() (scripting/page/viewer.js), and of a <style> element.
std::string_view viewer_script();
std::string_view viewer_style();

/// A text for a page, compressed: gzip (RFC 1952) in Base64 (RFC 4648). planula.unpack() reads it.
std::string packed_for_page(std::string_view text);

/// The template with every {{name}} replaced by the text of that name.
std::string filled_page(std::string_view page,
                        const std::vector<std::pair<std::string_view, std::string_view>> &texts);

/// A page that plays one recording (core/recording/recording_json.h). `title` is plain text.
std::string replay_page(std::string_view title, std::string_view recording_json);

} // namespace planula

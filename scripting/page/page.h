// SPDX-License-Identifier: MIT
// Pages for a browser that need nothing beside themselves: the viewer of recordings (viewer.js), its styles, and the
// data, compressed, in one file. The sources of the viewer travel inside the program.
#pragma once

#include <filesystem>
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

/// The module that `make wasm` builds, from its file, for a page: planula.unpack() gives the text that
/// planula.mountLaboratory() takes (scripting/page/laboratory.js). Throws InputError if the file holds something else.
std::string packed_module(const std::filesystem::path &file);

/// A page that plays one recording (core/recording/recording_json.h). `title` is plain text. With a packed module, which
/// may be empty, the page simulates the life again.
std::string replay_page(std::string_view title, std::string_view recording_json,
                        std::string_view module = "");

} // namespace planula

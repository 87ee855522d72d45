// SPDX-License-Identifier: MIT
#include "page/page.h"

#include "base/check.h"
#include "base/error.h"
#include "base/json.h"
#include "base/markup.h"
#include "page/sources.h"
#include "storage/gzip.h"
#include "storage/input.h"

namespace planula {

namespace {

std::string base64(std::string_view bytes) {
    constexpr std::string_view alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t at = 0; at < bytes.size(); at += 3) {
        const std::string_view group = bytes.substr(at, 3);
        unsigned bits = 0;
        for (std::size_t i = 0; i < 3; ++i)
            bits = bits << 8 | (i < group.size() ? static_cast<unsigned char>(group[i]) : 0u);
        for (std::size_t i = 0; i < 4; ++i)
            text += i <= group.size() ? alphabet[bits >> (18 - 6 * i) & 63] : '=';
    }
    return text;
}

} // namespace

std::string packed_for_page(std::string_view text) { return base64(gzipped(text)); }

std::string filled_page(std::string_view page,
                        const std::vector<std::pair<std::string_view, std::string_view>> &texts) {
    std::string filled;
    for (;;) {
        const std::size_t open = page.find("{{"), close = page.find("}}", open);
        if (open == page.npos) return filled.append(page);
        const std::string_view name = page.substr(open + 2, close - open - 2);
        filled.append(page.substr(0, open));
        bool known = false;
        for (const auto &[key, text] : texts)
            if (key == name) filled.append(text), known = true;
        CHECK(known, name);
        page.remove_prefix(close + 2);
    }
}

std::string packed_module(const std::filesystem::path &file) {
    const std::string module = read_file(file);
    if (module.find("planulaModule") == module.npos)
        throw InputError(file.string() + " is not the module that `make wasm` builds");
    return packed_for_page(json_text(module));
}

std::string replay_page(std::string_view title, std::string_view recording_json, std::string_view module) {
    const std::string name = markup_text(title), recording = packed_for_page(recording_json);
    return filled_page(replay_template(), {{"title", name},
                                           {"style", viewer_style()},
                                           {"recording", recording},
                                           {"module", module},
                                           {"script", viewer_script()}});
}

} // namespace planula

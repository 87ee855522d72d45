// SPDX-License-Identifier: MIT
#include "language/sources.h"

#include "base/error.h"
#include "base/hash.h"
#include "base/text.h"

#include <fstream>
#include <iterator>
#include <optional>

namespace planula {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t largest_source = 1 << 20; // bytes
constexpr std::size_t most_modules = 64;
constexpr std::size_t longest_module = 200; // a name in bytes
constexpr std::size_t longest_name = 56;    // Lua shortens longer ones in its own messages

std::string read_text(const fs::path &path) {
    std::ifstream file(path, std::ios::binary);
    std::string text(largest_source + 1, '\0');
    if (fs::is_directory(path)) throw InputError(path.string() + ": is a folder, not a script");
    if (!file || !(file.read(text.data(), static_cast<std::streamsize>(text.size())), file.eof() || file))
        throw InputError(path.string() + ": cannot be read");
    text.resize(static_cast<std::size_t>(file.gcount()));
    if (text.size() > largest_source) throw InputError(path.string() + ": is larger than 1 MiB");
    return text;
}

// A name short enough to stay whole in Lua's messages: the path, or its end.
std::string short_name(const fs::path &path) {
    std::string name = path.generic_string();
    if (name.size() > longest_name) name = "..." + name.substr(name.size() - longest_name + 3);
    return name;
}

bool is_safe(std::string_view module) {
    const auto is_separator = [](char c) { return c == '.' || c == '/'; };
    bool after_separator = true;
    for (const char c : module) {
        const bool is_word = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_';
        if (!is_word && (!is_separator(c) || after_separator)) return false;
        after_separator = is_separator(c);
    }
    return !after_separator;
}

} // namespace

Sources::Sources(const fs::path &script, fs::path library) {
    std::error_code ignored;
    const fs::path whole = fs::absolute(script, ignored).lexically_normal();
    for (fs::path folder = whole.parent_path();; folder = folder.parent_path()) {
        folders_.push_back(folder);
        if (folder == folder.parent_path()) break;
    }
    folders_.push_back(std::move(library));
    add("", short_name(script), read_text(script));
}

Sources::Sources(std::string name, std::string text, fs::path library) : folders_{std::move(library)} {
    add("", std::move(name), std::move(text));
}

const Source &Sources::script() const {
    const std::lock_guard lock(mutex_);
    return sources_.front();
}

const Source &Sources::module(std::string_view name) {
    if (name.size() > longest_module || !is_safe(name))
        throw InputError(
            "require '" + std::string(name.substr(0, longest_module)) +
            "': a module's name consists of a-z, 0-9, _ and single dots or slashes, at most 200");
    // The same module under either separator is one module.
    std::string dotted(name), slashed(name);
    for (char &c : dotted) c = c == '/' ? '.' : c;
    for (char &c : slashed) c = c == '.' ? '/' : c;
    const std::lock_guard lock(mutex_);
    for (const Source &source : sources_)
        if (source.module == dotted) return source;
    if (sources_.size() > most_modules) throw InputError("more than 64 modules are required");

    std::string tried;
    for (const fs::path &folder : folders_) {
        for (const char *ending : {".lua", "/init.lua"}) {
            const fs::path path = folder / (slashed + ending);
            std::error_code ignored;
            if (fs::is_regular_file(path, ignored))
                return add(dotted, short_name(path.lexically_proximate(fs::current_path())), read_text(path));
        }
        tried += "\n    " + folder.string();
    }
    throw InputError(
        "no module '" + dotted + "'; looked for " + slashed + ".lua and " + slashed +
        "/init.lua in:" + tried +
        "\n  The last folder is looked for beside the one that holds the program: leave it in build/, and "
        "link to it from elsewhere.");
}

void Sources::limit_instructions(bool limited) {
    limited_ = limited;
    spent_ = 0;
}

bool Sources::spend(std::int64_t instructions) {
    return !limited_.load(std::memory_order_relaxed) || (spent_ += instructions) <= instructions_of_a_check;
}

const Source *Sources::named(std::string_view name) const {
    const std::lock_guard lock(mutex_);
    for (const Source &source : sources_)
        if (source.name == name) return &source;
    return nullptr;
}

std::shared_ptr<Sources> Sources::with_functions_on_lines() const {
    const std::shared_ptr<Sources> copy(new Sources);
    const std::lock_guard lock(mutex_);
    for (const Source &source : sources_)
        copy->add(source.module, to_text(static_cast<std::int64_t>(copy->sources_.size())),
                  functions_on_lines(source.text, source.tokens));
    return copy;
}

const Source &Sources::add(std::string module, std::string name, std::string text) {
    if (!text.empty() && text.front() == '\x1b') throw InputError(name + ": is bytecode, not a text");
    Source &source = sources_.emplace_back();
    source.module = std::move(module);
    source.name = std::move(name);
    source.text = std::move(text);
    source.sha256 = sha256(source.text);
    source.tokens = scan(source.text);
    source.requirements = requirements_of(source.tokens);
    refuse_machine_dependent(source.tokens, source.name);
    return source;
}

} // namespace planula

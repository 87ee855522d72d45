// SPDX-License-Identifier: MIT
#include "storage/sealed.h"

#include "base/hash.h"
#include "base/state.h"

namespace planula {

namespace {

constexpr std::int64_t form = 2; // raised when what is sealed changes its form
constexpr std::size_t hash_size = 64;

/// What stands before content of this length.
std::string head(std::size_t length) {
    StateWriter writer;
    writer.group("planula checkpoint").integer(form).integer(static_cast<std::int64_t>(length));
    return writer.bytes();
}

} // namespace

std::string seal(std::string_view content) {
    std::string bytes = head(content.size());
    bytes += content;
    return bytes + sha256(bytes);
}

std::optional<std::string_view> unseal(std::string_view bytes) {
    const std::size_t around = head(0).size() + hash_size;
    if (bytes.size() < around) return std::nullopt;
    const std::string_view content = bytes.substr(head(0).size(), bytes.size() - around);
    const std::string_view hash = bytes.substr(bytes.size() - hash_size);
    bytes.remove_suffix(hash_size);
    if (!bytes.starts_with(head(content.size())) || sha256(bytes) != hash) return std::nullopt;
    return content;
}

} // namespace planula

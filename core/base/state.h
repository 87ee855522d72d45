// SPDX-License-Identifier: MIT
// State as bytes, for what a stopped run must find again: integers and doubles as eight little-endian bytes, texts and
// lists behind their length, every group behind its name. What was written reads back to the bit; anything else — cut
// short, of another kind, of impossible length — is refused by an InputError that names the group and the byte. The
// bytes hold no types: reader and writer name the same things in the same order.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace planula {

class StateWriter {
  public:
    /// Opens a group; StateReader::group() expects the same name here.
    StateWriter &group(std::string_view name) { return text(name); }
    StateWriter &integer(std::int64_t value);
    StateWriter &real(double value);
    StateWriter &text(std::string_view value);

    const std::string &bytes() const { return bytes_; }

  private:
    std::string bytes_;
};

class StateReader {
  public:
    /// `bytes` must outlive the reader.
    explicit StateReader(std::string_view bytes) : bytes_(bytes) {}

    void group(std::string_view name);
    std::int64_t integer();
    /// An integer within these bounds, both included.
    std::int64_t integer(std::int64_t lowest, std::int64_t highest);
    /// An integer that fits the type.
    int small_integer();
    double real();
    /// A real that is not NaN or infinite.
    double finite();
    std::string text();
    /// The length of a list whose items take at least `least_bytes` each: never more than what is left.
    std::size_t count(std::size_t least_bytes = 8);
    /// Nothing may be left.
    void done() const;

    /// Throws the InputError of this place: for readers that find a rule of their own broken.
    [[noreturn]] void refuse(std::string_view rule) const;

  private:
    std::uint64_t word();
    std::string_view take(std::size_t size);

    std::string_view bytes_;
    std::size_t at_ = 0;
    std::string group_;
};

} // namespace planula

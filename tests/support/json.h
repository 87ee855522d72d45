// SPDX-License-Identifier: MIT
// Whether a text is one value of JSON (RFC 8259).
#pragma once

#include <cctype>
#include <string_view>

namespace planula::test {

class JsonText {
  public:
    explicit JsonText(std::string_view text) : text_(text) {}
    bool is_whole() { return value() && (blanks(), at_ == text_.size()); }

  private:
    char next() const { return at_ < text_.size() ? text_[at_] : '\0'; }
    bool takes(char letter) { return next() == letter && ++at_; }
    void blanks() {
        while (next() == ' ' || next() == '\n') ++at_;
    }
    bool word(std::string_view word) {
        return text_.substr(at_, word.size()) == word && (at_ += word.size(), true);
    }
    bool number() {
        const std::size_t from = at_;
        while (std::isdigit(static_cast<unsigned char>(next())) || std::string_view("+-.eE").find(next()) < 5)
            ++at_;
        return at_ > from;
    }
    bool string() {
        if (!takes('"')) return false;
        while (next() != '"') {
            if (static_cast<unsigned char>(next()) < 0x20) return false;
            if (takes('\\') && std::string_view("\"\\/bfnrtu").find(next()) == std::string_view::npos)
                return false;
            ++at_;
        }
        return takes('"');
    }
    /// A list, or an object if its values are `named`.
    bool list(char end, bool named) {
        if (blanks(), takes(end)) return true;
        do {
            if (named && !(blanks(), string() && (blanks(), takes(':')))) return false;
            if (!value()) return false;
            blanks();
        } while (takes(','));
        return takes(end);
    }
    bool value() {
        blanks();
        if (takes('{')) return list('}', true);
        if (takes('[')) return list(']', false);
        return string() || word("null") || word("true") || word("false") || number();
    }

    std::string_view text_;
    std::size_t at_ = 0;
};

inline bool is_json(std::string_view text) { return JsonText(text).is_whole(); }

} // namespace planula::test

// SPDX-License-Identifier: MIT
#include "language/tokens.h"

#include "base/error.h"
#include "base/text.h"

#include <algorithm>
#include <optional>

namespace planula {

namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || (c & 0x80); }

class Scanner {
  public:
    explicit Scanner(std::string_view source) : source_(source) {}

    std::vector<Token> all() {
        std::vector<Token> tokens;
        while (skip_blanks_and_comments()) tokens.push_back(next());
        return tokens;
    }

  private:
    char at(std::size_t offset = 0) const {
        return place_ + offset < source_.size() ? source_[place_ + offset] : '\0';
    }
    bool done() const { return place_ >= source_.size(); }

    void advance(std::size_t count = 1) {
        for (; count > 0 && !done(); --count)
            if (source_[place_++] == '\n') ++line_;
    }

    // The level of a long bracket "[==[" that starts here; nothing if none does.
    std::optional<std::size_t> long_bracket() const {
        if (at() != '[') return std::nullopt;
        std::size_t level = 0;
        while (at(1 + level) == '=') ++level;
        if (at(1 + level) != '[') return std::nullopt;
        return level;
    }

    void skip_long(std::size_t level) {
        const std::string close = ']' + std::string(level, '=') + ']';
        const std::size_t end = source_.find(close, place_);
        advance((end == std::string_view::npos ? source_.size() : end + close.size()) - place_);
    }

    // True if a token starts here.
    bool skip_blanks_and_comments() {
        if (place_ == 0 && at() == '#') skip_line();
        while (!done()) {
            if (at() == '-' && at(1) == '-') {
                advance(2);
                if (const auto level = long_bracket())
                    skip_long(*level);
                else
                    skip_line();
            } else if (at() == ' ' || (at() >= '\t' && at() <= '\r')) {
                advance();
            } else {
                return true;
            }
        }
        return false;
    }

    void skip_line() {
        while (!done() && at() != '\n') advance();
    }

    Token next() {
        const std::size_t start = place_;
        const int line = line_;
        const auto token = [&](Token::Kind kind) {
            return Token{kind, source_.substr(start, place_ - start), line};
        };
        if (is_letter(at())) {
            while (is_letter(at()) || is_digit(at())) advance();
            return token(Token::Kind::name);
        }
        if (is_digit(at()) || (at() == '.' && is_digit(at(1))))
            return skip_number(), token(Token::Kind::number);
        if (at() == '"' || at() == '\'') return quoted();
        if (const auto level = long_bracket()) return skip_long(*level), token(Token::Kind::text);
        advance(two_characters() ? 2 : 1);
        return token(Token::Kind::symbol);
    }

    void skip_number() {
        while (is_letter(at()) || is_digit(at()) || at() == '.' || after_exponent()) advance();
    }

    // A sign that belongs to the number: after e or E, or after p or P of a hexadecimal one.
    bool after_exponent() const {
        if (at() != '+' && at() != '-') return false;
        const char before = source_[place_ - 1];
        return before == 'e' || before == 'E' || before == 'p' || before == 'P';
    }

    Token quoted() {
        const char quote = at();
        const int line = line_;
        advance();
        const std::size_t start = place_;
        while (!done() && at() != quote && at() != '\n') advance(at() == '\\' ? 2 : 1);
        const Token token{Token::Kind::text, source_.substr(start, place_ - start), line};
        advance();
        return token;
    }

    bool two_characters() const {
        return at(1) == '=' && (at() == '=' || at() == '~' || at() == '<' || at() == '>');
    }

    std::string_view source_;
    std::size_t place_ = 0;
    int line_ = 1;
};

bool is_symbol(const Token &token, std::string_view word) {
    return token.kind == Token::Kind::symbol && token.word == word;
}

bool is_name(const Token &token, std::string_view word) {
    return token.kind == Token::Kind::name && token.word == word;
}

// +1 where a bracket or a block opens, -1 where one closes, else 0.
int nesting(const Token &token) {
    const auto one_of = [&](std::initializer_list<std::string_view> words) {
        for (const auto word : words)
            if (token.word == word) return true;
        return false;
    };
    if (token.kind == Token::Kind::symbol) return one_of({"{", "(", "["}) - one_of({"}", ")", "]"});
    if (token.kind == Token::Kind::name)
        return one_of({"function", "if", "do", "repeat"}) - one_of({"end", "until"});
    return 0;
}

// Where the bracket opened at `open` closes; the end of the tokens if it does not.
std::size_t closing(std::span<const Token> tokens, std::size_t open) {
    int depth = 0;
    for (std::size_t i = open; i < tokens.size(); ++i)
        if ((depth += nesting(tokens[i])) == 0) return i;
    return tokens.size();
}

// The key of the entry that starts at `place`; empty for a positional one.
std::string_view key_at(std::span<const Token> tokens, std::size_t place) {
    const auto token = [&](std::size_t offset) {
        return place + offset < tokens.size() ? tokens[place + offset] : Token{};
    };
    if (token(0).kind == Token::Kind::name && is_symbol(token(1), "=")) return token(0).word;
    if (is_symbol(token(0), "[") && token(1).kind == Token::Kind::text && is_symbol(token(2), "]"))
        return token(1).word;
    return {};
}

struct Entry {
    std::size_t begin, end; // tokens of the entry, without the separator
};

// Where the entry that starts at `begin` ends: at the next separator outside all brackets and blocks, or where the
// constructor closes.
std::size_t end_of_entry(std::span<const Token> tokens, std::size_t begin, std::size_t close) {
    int depth = 0;
    for (std::size_t end = begin; end < close; ++end) {
        if (depth == 0 && (is_symbol(tokens[end], ",") || is_symbol(tokens[end], ";"))) return end;
        depth += nesting(tokens[end]);
        if (depth < 0) return end;
    }
    return close;
}

// The entry of a constructor that a step leads to.
std::optional<Entry> find_entry(std::span<const Token> tokens, std::size_t open, const Step &step) {
    const std::size_t close = closing(tokens, open);
    int position = 0;
    for (std::size_t begin = open + 1; begin < close;) {
        const std::size_t end = end_of_entry(tokens, begin, close);
        const std::string_view key = key_at(tokens, begin);
        if (key.empty()) ++position;
        if (step.key.empty() ? key.empty() && position == step.index : key == step.key)
            return Entry{begin, end};
        begin = end + 1;
    }
    return std::nullopt;
}

std::size_t find_brace(std::span<const Token> tokens, std::size_t begin, std::size_t end) {
    while (begin < end && !is_symbol(tokens[begin], "{")) ++begin;
    return begin;
}

// The first entry with this key anywhere inside the constructor opened at `open`.
std::optional<Entry> find_mention(std::span<const Token> tokens, std::size_t open, const std::string &key) {
    const std::size_t close = closing(tokens, open);
    for (std::size_t i = open; i < close && !key.empty(); ++i)
        if (key_at(tokens, i) == key) return Entry{i, end_of_entry(tokens, i, close)};
    return std::nullopt;
}

// A text that may name a module, and needs no reading of escapes.
bool is_plain_name(const Token &token) {
    const auto plain = [](char c) { return is_letter(c) || is_digit(c) || c == '.' || c == '/'; };
    return token.kind == Token::Kind::text && std::all_of(token.word.begin(), token.word.end(), plain);
}

// The module that the `require` at `place` names; empty if it is computed.
std::string_view module_at(std::span<const Token> tokens, std::size_t place) {
    const auto token = [&](std::size_t offset) {
        return place + offset < tokens.size() ? tokens[place + offset] : Token{};
    };
    if (is_plain_name(token(1))) return token(1).word;
    const bool in_brackets = is_symbol(token(1), "(") && is_plain_name(token(2)) && is_symbol(token(3), ")");
    return in_brackets ? token(2).word : "";
}

bool is_foreign_number(std::string_view word) {
    const bool hexadecimal = word.size() > 1 && (word[1] == 'x' || word[1] == 'X');
    const char last = word.back();
    return last == 'L' || last == 'l' || last == 'i' || last == 'I' ||
           (!hexadecimal && (last == 'u' || last == 'U'));
}

} // namespace

std::vector<Token> scan(std::string_view source) { return Scanner(source).all(); }

void refuse_machine_dependent(std::span<const Token> tokens, std::string_view name) {
    const auto refuse = [&](const Token &token, const std::string &why) {
        throw InputError(std::string(name) + ":" + to_text(token.line) + ": '" + std::string(token.word) +
                         "' " + why);
    };
    for (const Token &token : tokens) {
        if (is_symbol(token, "^"))
            refuse(token, "gives different results on different machines; write x*x or math.pow(x, y)");
        if (token.kind == Token::Kind::number && is_foreign_number(token.word))
            refuse(token, "is a number of the FFI, which scripts cannot use; write it without the suffix");
    }
}

std::vector<Requirement> requirements_of(std::span<const Token> tokens) {
    std::vector<Requirement> found;
    std::vector<bool> open; // brackets and blocks: is it a function's?
    for (std::size_t i = 0; i < tokens.size(); ++i) {
        const int change = nesting(tokens[i]);
        if (change > 0) open.push_back(is_name(tokens[i], "function"));
        if (change < 0 && !open.empty()) open.pop_back();
        const bool is_field = i > 0 && (is_symbol(tokens[i - 1], ".") || is_symbol(tokens[i - 1], ":"));
        if (!is_name(tokens[i], "require") || is_field) continue;
        const bool in_function = std::find(open.begin(), open.end(), true) != open.end();
        found.push_back({std::string(module_at(tokens, i)), tokens[i].line, in_function});
    }
    return found;
}

std::string functions_on_lines(std::string_view source, std::span<const Token> tokens) {
    std::string text;
    std::size_t done = 0;
    for (const Token &token : tokens) {
        if (!is_name(token, "function")) continue;
        const auto place = static_cast<std::size_t>(token.word.data() - source.data());
        text.append(source.substr(done, place - done)).append("\n");
        done = place;
    }
    return text.append(source.substr(done));
}

std::size_t function_before(std::span<const Token> tokens, int line) {
    std::size_t found = tokens.size();
    for (std::size_t i = 0; i < tokens.size() && tokens[i].line <= line; ++i)
        if (is_name(tokens[i], "function")) found = i;
    return found;
}

std::vector<Token> body_of_function(std::span<const Token> tokens, std::size_t place) {
    const std::size_t end = closing(tokens, place);
    std::vector<Token> body;
    // A colon in the name is the parameter `self`.
    for (++place; place < end && !is_symbol(tokens[place], "("); ++place)
        if (is_symbol(tokens[place], ":")) body.push_back(tokens[place]);
    for (; place < end; ++place) {
        const bool is_separator = is_symbol(tokens[place], ",") || is_symbol(tokens[place], ";");
        if (!is_separator || !is_symbol(tokens[place + 1], "}")) body.push_back(tokens[place]);
    }
    return body;
}

std::string_view text_of_function(std::span<const Token> tokens, std::size_t place) {
    const std::size_t end = std::min(closing(tokens, place), tokens.size() - 1);
    while (place < end && !is_symbol(tokens[place], "(")) ++place;
    const std::string_view last = tokens[end].word;
    const char *const begin = tokens[place].word.data();
    return {begin, static_cast<std::size_t>(last.data() + last.size() - begin)};
}

int line_of_entry(std::span<const Token> tokens, int line, std::span<const Step> path) {
    std::size_t open = 0;
    while (open < tokens.size() && tokens[open].line < line) ++open;
    open = find_brace(tokens, open, tokens.size());
    for (const Step &step : path) {
        auto entry = find_entry(tokens, open, step);
        if (!entry) entry = find_mention(tokens, open, step.key);
        if (!entry) return line;
        line = tokens[entry->begin].line;
        open = find_brace(tokens, entry->begin, entry->end);
        if (open == entry->end) break;
    }
    return line;
}

int line_of_return(std::span<const Token> tokens) {
    int line = 1, depth = 0;
    for (const Token &token : tokens) {
        if (depth == 0 && is_name(token, "return")) line = token.line;
        depth += nesting(token);
    }
    return line;
}

} // namespace planula

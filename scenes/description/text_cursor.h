#pragma once

#include <charconv>
#include <cmath>
#include <string>
#include <string_view>

#include "core/error.h"

namespace plumb {

/// A walk through a text of lines and words without copying, for formats of 10^7 numbers.
class TextCursor {
public:
    TextCursor(std::string_view text, std::string file) : text_(text), file_(std::move(file)) {}

    [[nodiscard]] bool at_end() const { return at_ >= text_.size(); }
    [[nodiscard]] std::size_t offset() const { return at_; }

    /// Skips blanks in the line; true where nothing but a comment is left of it.
    bool line_done() {
        while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t' || text_[at_] == '\r')) ++at_;
        return at_ >= text_.size() || text_[at_] == '\n' || text_[at_] == '#';
    }
    void next_line() {
        while (at_ < text_.size() && text_[at_] != '\n') ++at_;
        if (at_ < text_.size()) ++at_;
        ++line_;
    }
    /// The next word of the line; empty at the line's end.
    std::string_view word() {
        if (line_done()) return {};
        const std::size_t first = at_;
        while (at_ < text_.size() && static_cast<unsigned char>(text_[at_]) > ' ') ++at_;
        return text_.substr(first, at_ - first);
    }
    /// The next word as a finite number; `what` names it in errors.
    template <class Number>
    Number number(std::string_view what) {
        return parsed<Number>(word(), what);
    }
    template <class Number>
    Number parsed(std::string_view word, std::string_view what) const {
        if (word.starts_with('+')) word.remove_prefix(1);
        Number value{};
        const auto [end, code] = std::from_chars(word.data(), word.data() + word.size(), value);
        if (word.empty()) throw error(std::string(what) + " is missing");
        bool good = code == std::errc{} && end == word.data() + word.size();
        if constexpr (std::is_floating_point_v<Number>) {
            // from_chars calls a subnormal float out of range: zero is as near as geometry needs.
            if (code == std::errc::result_out_of_range && std::abs(as_double(word)) < 1) return Number{0};
            good = good && std::isfinite(value);
        }
        if (!good) throw error(std::string(what) + " is '" + std::string(word) + "'; a finite number is accepted");
        return value;
    }

    [[nodiscard]] Error error(const std::string& message) const {
        return Error(file_ + ":" + std::to_string(line_) + ": " + message);
    }

private:
    static double as_double(std::string_view word) {
        double value = 0;
        const auto [end, code] = std::from_chars(word.data(), word.data() + word.size(), value);
        return code == std::errc{} ? value : word.find("e-") != std::string_view::npos ? 0 : HUGE_VAL;
    }

    std::string_view text_;
    std::string file_;
    std::size_t at_ = 0;
    int line_ = 1;
};

}  // namespace plumb

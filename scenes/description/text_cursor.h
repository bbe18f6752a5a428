#pragma once

#include <charconv>
#include <cmath>
#include <string>
#include <string_view>

#include "core/error.h"

namespace plumb {

/// Whether a backslash at a line's end joins it to the next; not within a comment, which may end with a path.
enum class Continuation { none, backslash };

/// A walk through a text of lines and words without copying, for formats of 10^7 numbers. Lines end with LF, CR LF or
/// CR; a mark of the text's encoding (UTF-8) at its start is skipped.
class TextCursor {
public:
    TextCursor(std::string_view text, std::string file, Continuation continuation = Continuation::none)
        : text_(text), file_(std::move(file)), joins_(continuation == Continuation::backslash) {
        if (text_.starts_with("\xEF\xBB\xBF")) at_ = 3;
    }

    [[nodiscard]] bool at_end() const { return at_ >= text_.size(); }
    [[nodiscard]] std::size_t offset() const { return at_; }

    /// Skips blanks in the line; true where nothing but a comment is left of it.
    bool line_done() {
        for (;; ++at_) {
            while (at_ < text_.size() && is_blank(at_)) ++at_;
            if (!(joins_ && joined(at_))) break;
            skip_joint();
        }
        return at_ >= text_.size() || ends_line(at_) || text_[at_] == '#';
    }
    void next_line() {
        bool comment = false;
        for (; at_ < text_.size() && !ends_line(at_); ++at_) {
            comment = comment || text_[at_] == '#';
            if (joins_ && !comment && joined(at_)) skip_joint();
        }
        if (at_ < text_.size()) ++at_;
        ++line_;
    }
    /// The next word of the line; empty at the line's end.
    std::string_view word() {
        if (line_done()) return {};
        const std::size_t first = at_;
        while (at_ < text_.size() && static_cast<unsigned char>(text_[at_]) > ' ' && !(joins_ && joined(at_))) ++at_;
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
    [[nodiscard]] bool ends_line(std::size_t at) const {
        return text_[at] == '\n' || (text_[at] == '\r' && (at + 1 == text_.size() || text_[at + 1] != '\n'));
    }
    [[nodiscard]] bool is_blank(std::size_t at) const {
        return text_[at] == ' ' || text_[at] == '\t' || (text_[at] == '\r' && !ends_line(at));
    }
    /// Whether a backslash that joins two lines stands there.
    [[nodiscard]] bool joined(std::size_t at) const {
        if (at + 1 >= text_.size() || text_[at] != '\\') return false;
        return ends_line(at + 1) || text_[at + 1] == '\r';
    }
    /// Goes from the backslash to the last character of its line's end.
    void skip_joint() {
        ++at_;
        if (!ends_line(at_)) ++at_;
        ++line_;
    }

    static double as_double(std::string_view word) {
        double value = 0;
        const auto [end, code] = std::from_chars(word.data(), word.data() + word.size(), value);
        return code == std::errc{} ? value : word.find("e-") != std::string_view::npos ? 0 : HUGE_VAL;
    }

    std::string_view text_;
    std::string file_;
    bool joins_;
    std::size_t at_ = 0;
    int line_ = 1;
};

}  // namespace plumb

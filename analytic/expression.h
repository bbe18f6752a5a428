#pragma once

#include <memory>
#include <string>

#include "core/point.h"

namespace plumb {

/// A function of x (and y) that a person wrote: + - * / ^, comparisons, ?:, sin, exp, sqrt, min, … and the constants pi
/// and e. A copy is independent of the original: use one a thread. Copying parses again (some 10 µs); a call takes
/// some 50 ns.
class Expression {
public:
    /// Line breaks count as blanks. Throws Error naming the formula, the column and what stands there.
    explicit Expression(std::string text);
    Expression(const Expression& other) : Expression(other.text()) {}
    Expression& operator=(const Expression&) = delete;
    ~Expression();

    [[nodiscard]] const std::string& text() const { return text_; }
    [[nodiscard]] bool uses_y() const;

    double operator()(const Point<1>& p) const { return at(p[0], 0); }
    double operator()(const Point<2>& p) const { return at(p[0], p[1]); }

private:
    struct Parser;

    [[nodiscard]] double at(double x, double y) const;

    std::string text_;
    std::unique_ptr<Parser> parser_;
};

}  // namespace plumb

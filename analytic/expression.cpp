#include "analytic/expression.h"

#include <fmt/format.h>
#include <muParser.h>

#include <cmath>
#include <numbers>

#include "core/error.h"

namespace plumb {

struct Expression::Parser {
    double x = 0.5, y = 0.5;
    mu::Parser parser;
};

namespace {

Error at_column(const std::string& text, std::size_t column, const std::string& what) {
    return Error(fmt::format("formula '{}', column {}: {}", text, std::min(column, text.size() + 1), what));
}

Error explained(const std::string& text, const mu::ParserError& error) {
    std::string what = error.GetMsg();
    // muParser counts from 0, and its sentences repeat the place
    for (const char* place : {" found at position", " at position", " at expression position"})
        what = what.substr(0, what.find(place));
    while (!what.empty() && (what.back() == '.' || what.back() == '!')) what.pop_back();
    const auto column = static_cast<std::size_t>(std::max(error.GetPos(), 0)) + 1;
    return at_column(text, column, what + "; accepted is a formula of x and y such as exp(x)*sin(3*y)");
}

// muParser would take x=3 as an assignment.
void refuse_assignments(const std::string& text) {
    for (std::size_t at = text.find('='); at != std::string::npos; at = text.find('=', at + 1)) {
        if (at + 1 < text.size() && text[at + 1] == '=')
            ++at;
        else if (at == 0 || std::string_view("<>!").find(text[at - 1]) == std::string_view::npos)
            throw at_column(text, at + 1, "'=' found; accepted is a formula, with == to compare");
    }
}

void define_names(mu::Parser& parser, double& x, double& y) {
    parser.DefineConst("pi", std::numbers::pi);
    parser.DefineConst("e", std::numbers::e);
    parser.DefineFun("pow", static_cast<double (*)(double, double)>(std::pow));
    parser.DefineFun("mod", static_cast<double (*)(double, double)>(std::fmod));
    parser.DefineFun("floor", static_cast<double (*)(double)>(std::floor));
    parser.DefineFun("ceil", static_cast<double (*)(double)>(std::ceil));
    parser.DefineFun("erf", static_cast<double (*)(double)>(std::erf));
    parser.DefineVar("x", &x);
    parser.DefineVar("y", &y);
}

}  // namespace

Expression::Expression(std::string text) : text_(std::move(text)), parser_(std::make_unique<Parser>()) {
    std::ranges::replace_if(
        text_, [](unsigned char c) { return std::iscntrl(c) != 0; }, ' ');
    refuse_assignments(text_);
    try {
        define_names(parser_->parser, parser_->x, parser_->y);
        parser_->parser.SetExpr(text_);
        int values = 0;
        parser_->parser.Eval(values);
        if (values != 1) throw at_column(text_, text_.find(',') + 1, "',' found; accepted is one formula");
    } catch (const mu::ParserError& error) {
        throw explained(text_, error);
    }
}

Expression::~Expression() = default;

bool Expression::uses_y() const {
    return parser_->parser.GetUsedVar().contains("y");
}

double Expression::at(double x, double y) const {
    parser_->x = x;
    parser_->y = y;
    return parser_->parser.Eval();
}

}  // namespace plumb

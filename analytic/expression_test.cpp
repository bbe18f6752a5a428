#include "analytic/expression.h"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "core/error.h"

namespace plumb {
namespace {

using testing::AllOf;
using testing::HasSubstr;

std::string complaint(const std::string& text) {
    try {
        const Expression expression(text);
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

TEST(Expression, IsTheFunctionThatWasWritten) {
    EXPECT_EQ(Expression("exp(x)*sin(3*y)")(Point<2>{0.25, 0.5}), std::exp(0.25) * std::sin(1.5));
    EXPECT_EQ(Expression("x^2")(Point<1>{3}), 9);
    EXPECT_EQ(Expression("x <= 0.5 ? 1 : -1")(Point<1>{0.5}), 1);
    EXPECT_EQ(Expression("e*0 + pi*0 + 2")(Point<1>{0.5}), 2);
    EXPECT_NEAR(Expression("cos(pi*x)")(Point<1>{1}), -1, 1e-15);
    EXPECT_NEAR(Expression("log(e) + floor(2.5) + mod(5, 3) + pow(2, 3) + ceil(0.5) + erf(0)")(Point<1>{0}), 14, 1e-14);
    EXPECT_EQ(Expression("-x^2")(Point<1>{3}), -9);
    EXPECT_EQ(Expression("1")(Point<1>{0.1}), 1);
}

TEST(Expression, KnowsWhetherItUsesY) {
    EXPECT_FALSE(Expression("exp(x)").uses_y());
    EXPECT_TRUE(Expression("exp(x)*y").uses_y());
    const Expression f("x + y");
    EXPECT_TRUE(f.uses_y());
    EXPECT_EQ(f(Point<2>{1, 2}), 3);
}

TEST(Expression, CopiesAreIndependent) {
    const Expression f("10*x + y");
    const Expression g = f;
    EXPECT_EQ(f(Point<2>{1, 2}) + g(Point<2>{3, 4}), 46);
    EXPECT_EQ(f(Point<2>{1, 2}), 12);
}

TEST(Expression, NamesThePlaceOfAnError) {
    EXPECT_THAT(complaint("exp(x"), AllOf(HasSubstr("formula 'exp(x', column 6"), HasSubstr("arenthesis")));
    EXPECT_THAT(complaint("x*z"), AllOf(HasSubstr("column 3"), HasSubstr("\"z\"")));
    EXPECT_THAT(complaint("x+"), HasSubstr("column 3"));
    EXPECT_THAT(complaint("2x"), HasSubstr("column 2"));
    EXPECT_THAT(complaint("foo(x)"), HasSubstr("column"));
    EXPECT_THAT(complaint("1e999"), HasSubstr("column"));
    EXPECT_THAT(complaint(""), HasSubstr("column 1"));
    EXPECT_THAT(complaint("x, y"), HasSubstr("column 2: ',' found"));
    EXPECT_THAT(complaint("x=3"), HasSubstr("column 2: '=' found"));
    EXPECT_THAT(complaint("x==3 ? x = 1 : 2"), HasSubstr("column 10"));
    EXPECT_THAT(complaint("x +\ny z"), AllOf(HasSubstr("'x + y z', column 7")));
    EXPECT_EQ(complaint("x<=3 && y!=2 && x==y"), "");
}

}  // namespace
}  // namespace plumb

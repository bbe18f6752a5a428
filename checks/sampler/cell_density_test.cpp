#include "checks/sampler/cell_density.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/error.h"

namespace plumb::checks {
namespace {

using testing::DoubleNear;
using testing::HasSubstr;

template <class Read>
std::string complaint(const Read& read) {
    try {
        read();
    } catch (const Error& error) {
        return error.what();
    }
    return "no complaint";
}

std::string table_complaint(const std::string& text) {
    return complaint([&] { parse_density_table(text, "pdf.csv"); });
}

double total(const CellDensity& density) {
    double sum = 0;
    for (const CellDensity::Cell& cell : density.cells) sum += cell.probability;
    return sum;
}

TEST(ReadDensity, KnowsItsNames) {
    for (const char* name :
         {"uniform", "linear:0,1", "linear:3,1", "exponential:5", "exponential:-2", "uniform-2d", "bilinear:1,2,3,4"}) {
        const CellDensity density = read_density(name);
        EXPECT_EQ(density.name, name);
        EXPECT_THAT(total(density), DoubleNear(1, 1e-12)) << name;
    }
    EXPECT_EQ(read_density("uniform").dimension, 1);
    EXPECT_EQ(read_density("uniform-2d").dimension, 2);
}

TEST(ReadDensity, PutsTheRightMassIntoTheCells) {
    const CellDensity linear = read_density("linear:0,2");  // pdf 2x, CDF x²
    for (const CellDensity::Cell& cell : linear.cells)
        EXPECT_THAT(cell.probability, DoubleNear(cell.x.high * cell.x.high - cell.x.low * cell.x.low, 1e-14));
    const CellDensity bilinear = read_density("bilinear:0,0,0,1");  // pdf 4 x y
    for (const auto& [x, y, probability] : bilinear.cells)
        EXPECT_THAT(probability,
                    DoubleNear((x.high * x.high - x.low * x.low) * (y.high * y.high - y.low * y.low), 1e-14));
}

TEST(ReadDensity, SaysWhatItKnows) {
    EXPECT_THAT(complaint([] { read_density("gaussian"); }), HasSubstr("known: uniform, linear"));
    EXPECT_THAT(complaint([] { read_density("linear:1"); }), HasSubstr("of the form linear:A,B"));
    EXPECT_THAT(complaint([] { read_density("linear:1,x"); }), HasSubstr("of the form linear:A,B"));
    EXPECT_THAT(complaint([] { read_density("linear:nan,1"); }), HasSubstr("of the form linear:A,B"));
    EXPECT_THAT(complaint([] { read_density("uniform:3"); }), HasSubstr("of the form uniform"));
    EXPECT_THAT(complaint([] { read_density("linear:0,0"); }), HasSubstr("one > 0"));
}

TEST(DensityTable, HasProbabilitiesOrDensities) {
    const CellDensity halves = parse_density_table("from,to,probability\n-inf,3,0.5\n3,inf,0.5\n", "halves");
    EXPECT_EQ(halves.cell_of({-1e300, 0}), 0u);
    EXPECT_EQ(halves.cell_of({3, 0}), 1u);
    const CellDensity steps = parse_density_table("# a comment\nfrom, to, density\r\n0,1,0.25\r\n1,4,0.25", "steps");
    EXPECT_EQ(steps.cells[1].probability, 0.75);
    const CellDensity squares =
        parse_density_table("x_from,x_to,y_from,y_to,density\n0,1,0,2,0.25\n1,2,0,2,0.25\n", "squares");
    EXPECT_EQ(squares.dimension, 2);
    EXPECT_EQ(squares.cell_of({1.5, 1.5}), 1u);
    EXPECT_EQ(squares.cell_of({1.5, 2.5}), 2u);
}

TEST(DensityTable, GoesByTheNamesOfItsColumns) {
    const CellDensity turned = parse_density_table("probability;to;from\n0.5;3;-inf\n0.5;inf;3\n", "turned");
    EXPECT_EQ(turned.cells[0].x.high, 3);
    EXPECT_EQ(turned.cells[0].probability, 0.5);
    EXPECT_FALSE(turned.cumulative) << "nothing is known within cells";
}

TEST(DensityTable, OfConstantDensitiesIsKnownEverywhere) {
    const CellDensity steps = parse_density_table("from,to,density\n0,1,0.25\n1,4,0.25\n", "steps");
    EXPECT_EQ(steps.pdf({2, 0}), 0.25);
    EXPECT_EQ(steps.cumulative(2), 0.5);
    EXPECT_EQ(steps.cumulative(5), 1);
}

TEST(DensityTable, IsRefusedWithLineAndColumn) {
    EXPECT_THAT(table_complaint(""), HasSubstr("no row of numbers"));
    EXPECT_THAT(table_complaint("a,b,c\n1,2,3\n"), HasSubstr("pdf.csv: the heading is 'a,b,c'"));
    EXPECT_THAT(table_complaint("from,to,density\n0,1,1,1\n"), HasSubstr("pdf.csv:2: 4 columns found; line 1 has 3"));
    EXPECT_THAT(table_complaint("from,to,density\n0,zwei,1\n"), HasSubstr("pdf.csv:2: column 2 (to): 'zwei' found"));
    EXPECT_THAT(table_complaint("from,to,density\n0,1,nan\n"), HasSubstr("'nan' found"));
    EXPECT_THAT(table_complaint("from,to,density\nnan,1,1\n"), HasSubstr("pdf.csv:2: column 1 (from): 'nan' found"));
    EXPECT_THAT(table_complaint("from,to,density\n1,0,1\n"), HasSubstr("ends at 0 before it begins at 1"));
    EXPECT_THAT(table_complaint("from,to,density\n0,1,-1\n"), HasSubstr("column 3 (density): -1"));
    EXPECT_THAT(table_complaint("from,to,density\n0,inf,1\n"), HasSubstr("no finite probability"));
    EXPECT_THAT(table_complaint("from,to,probability\n0,1,0.5\n0.5,2,0.5\n"),
                HasSubstr("pdf.csv:3: the cell overlaps cell 0"));
    EXPECT_THAT(table_complaint("from,to,probability\n0,1,1\n"), HasSubstr("fewer than two cells"));
    EXPECT_THAT(table_complaint("from,to,probability\n0,1,0.5\n1,2,0.4\n"), HasSubstr("sum to 0.9"));
}

TEST(CellOf, HasUpperEndsOnlyWhereNothingElseBegins) {
    const CellDensity density = parse_density_table("from,to,probability\n0,1,0.5\n2,3,0\n1,2,0.5\n", "gap");
    EXPECT_EQ(density.cell_of({0, 0}), 0u);
    EXPECT_EQ(density.cell_of({1, 0}), 2u);
    EXPECT_EQ(density.cell_of({2, 0}), 1u);
    EXPECT_EQ(density.cell_of({3, 0}), 1u);
    EXPECT_EQ(density.cell_of({-0.001, 0}), 3u);
    EXPECT_EQ(density.cell_of({std::nan(""), 0}), 3u);
    EXPECT_EQ(density.cell_of({std::numeric_limits<double>::infinity(), 0}), 3u);
}

}  // namespace
}  // namespace plumb::checks

#include <gmock/gmock.h>

#include <numeric>

#include "cli/command_test.h"
#include "core/csv.h"

namespace plumb::cli {
namespace {

using testing::AllOf;
using testing::DoubleNear;
using testing::ElementsAre;
using testing::HasSubstr;

class WeightsCommand : public CommandTest {};

TEST_F(WeightsCommand, WeighsPointsOfTheInterval) {
    write("p.csv", "0.25\n0.75\n0.25\n");
    const Said said = plumb("weights p.csv");
    EXPECT_EQ(said.exit_code, 0);
    EXPECT_EQ(said.out, "x,weight\n0.25,0.25\n0.75,0.5\n0.25,0.25\n");
    EXPECT_THAT(said.error, AllOf(HasSubstr("3 points"), HasSubstr("sum to 1"), HasSubstr("smallest 0.25 (line 1)"),
                                  HasSubstr("largest 0.5 (line 2)"), HasSubstr("1 points repeat")));
}

TEST_F(WeightsCommand, WeighsPointsOfTheSquareAndTheTorus) {
    write("p.csv", "a,b\n0.125,0.5\n0.625,0.5\n");
    EXPECT_EQ(plumb("weights p.csv -o w.csv").exit_code, 0);
    const NumberTable clipped = parse_csv(read("w.csv"), "w.csv");
    EXPECT_THAT(clipped.header, ElementsAre("a", "b", "weight"));
    EXPECT_NEAR(clipped.at(0, 2), 0.375, 1e-12);  // the border lies half way, at 0.375
    EXPECT_EQ(plumb("weights p.csv --periodic -o w.csv").exit_code, 0);
    EXPECT_NEAR(parse_csv(read("w.csv"), "w.csv").at(0, 2), 0.5, 1e-12);
}

TEST_F(WeightsCommand, ScalesToADomain) {
    write("p.csv", "-1,10\n0,10\n");
    EXPECT_EQ(plumb("weights p.csv --domain=-2,2,10,13 -o w.csv").exit_code, 0);
    const NumberTable weights = parse_csv(read("w.csv"), "w.csv");
    EXPECT_NEAR(weights.at(0, 2), 1.5 * 3, 1e-12);
    EXPECT_NEAR(weights.at(1, 2), 2.5 * 3, 1e-12);
}

TEST_F(WeightsCommand, ReadsColumnsByTheirNames) {
    write("p.csv", "y;x\n0.5;0.125\n0.5;0.625\n");
    EXPECT_EQ(plumb("weights p.csv").out, "x,y,weight\n0.125,0.5,0.375\n0.625,0.5,0.625\n");
}

TEST_F(WeightsCommand, SaysWhatIsWrong) {
    write("bad.csv", "x,y\n0.5,0.5\n0.5,half\n");
    EXPECT_THAT(complaint("weights bad.csv -o w.csv"), HasSubstr("bad.csv:3: column 2 (y): 'half' found"));
    write("far.csv", "0.5\n1.5\n");
    EXPECT_THAT(complaint("weights far.csv"), AllOf(HasSubstr("far.csv:2: column 1: 1.5"), HasSubstr("0 to 1")));
    write("nan.csv", "0.5\nnan\n");
    EXPECT_THAT(complaint("weights nan.csv"), HasSubstr("nan.csv:2: column 1: 'nan' found"));
    write("three.csv", "0.5,0.5,0.5\n");
    EXPECT_THAT(complaint("weights three.csv"), HasSubstr("3 columns found; accepted are 1 (x) and 2 (x,y)"));
    write("empty.csv", "");
    EXPECT_THAT(complaint("weights empty.csv"), HasSubstr("empty.csv: no row"));
    EXPECT_THAT(complaint("weights missing.csv"), HasSubstr("missing.csv: cannot be read"));
    write("p.csv", "0.5\n");
    EXPECT_THAT(complaint("weights p.csv --domain 1,0"), HasSubstr("'1,0' is not a domain"));
    EXPECT_THAT(complaint("weights p.csv --domain 0,1,0,1"), HasSubstr("--domain has 4 numbers"));
    EXPECT_THAT(complaint("weights p.csv -o /dev/full/x"), HasSubstr("/dev/full"));
    EXPECT_THAT(complaint("weights p.csv --periodc"), HasSubstr("did you mean '--periodic'"));
}

TEST_F(WeightsCommand, FailsOnAFullDisk) {
    write("p.csv", "0.5\n");
    const int status = std::system(
        ("'" PLUMB_PROGRAM "' weights '" + (folder / "p.csv").string() + "' >/dev/full 2>/dev/null").c_str());
    EXPECT_EQ(WEXITSTATUS(status), 2);
}

TEST_F(WeightsCommand, TakesAMillionPoints) {
    std::string one, two;
    double x = 0, y = 0;
    for (int i = 0; i < 1'000'000; ++i) {  // a Kronecker sequence
        x = std::fmod(x + 0.7548776662466927, 1);
        y = std::fmod(y + 0.5698402909980532, 1);
        one += fmt::format("{}\n", x);
        two += fmt::format("{},{}\n", x, y);
    }
    for (const auto& [name, text] : {std::pair{"one.csv", one}, {"two.csv", two}}) {
        write(name, text);
        EXPECT_EQ(plumb(fmt::format("weights {} -o w.csv", name)).exit_code, 0);
        const NumberTable weights = parse_csv(read("w.csv"), "w.csv");
        ASSERT_EQ(weights.rows(), 1'000'000u);
        double sum = 0;
        for (std::size_t row = 0; row < weights.rows(); ++row) sum += weights.at(row, weights.columns - 1);
        EXPECT_NEAR(sum, 1, 1e-11);
    }
}

}  // namespace
}  // namespace plumb::cli

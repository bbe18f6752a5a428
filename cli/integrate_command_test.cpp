#include <gmock/gmock.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "cli/command_test.h"
#include "core/random.h"

namespace plumb::cli {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using Json = nlohmann::json;

class IntegrateCommand : public CommandTest {
protected:
    // The JSON of a call that must end with this exit code.
    Json answers(const std::string& arguments, int exit_code = 0) const {
        const Said said = plumb("integrate --json a.json " + arguments);
        EXPECT_EQ(said.exit_code, exit_code) << said.error;
        return Json::parse(read("a.json"));
    }
    Json answer(const std::string& arguments, int exit_code = 0) const {
        return answers(arguments, exit_code)["answers"][0];
    }
    static void expect_near(const Json& answer, double truth) {
        EXPECT_GT(answer["standard_error"].get<double>(), 0) << answer;
        EXPECT_LT(std::abs(answer["value"].get<double>() - truth), 6 * answer["standard_error"].get<double>())
            << answer;
    }

    // Samples of f(x) = x² or f(x, y) = x² + y, independent and uniform.
    void write_samples(const std::string& name, int columns, int n, std::uint64_t seed) const {
        RandomStream random(seed);
        std::string text = columns == 2 ? "x,f\n" : "x,y,f\n";
        for (int i = 0; i < n; ++i) {
            const double x = random.uniform(), y = random.uniform();
            text += columns == 2 ? fmt::format("{},{}\n", x, x * x) : fmt::format("{},{},{}\n", x, y, x * x + y);
        }
        write(name, text);
    }
};

TEST_F(IntegrateCommand, IntegratesAFormula) {
    expect_near(answer("'exp(x)' --seed 1"), std::exp(1) - 1);
    expect_near(answer("'exp(x)*sin(3*y)' --method torus-tent --n 256 --seed 2"),
                (std::exp(1) - 1) * (1 - std::cos(3)) / 3);
    expect_near(answer("--seed 6 -- -x"), -0.5);
    expect_near(answer("'x^2' --domain=-1,2 --method stratified --seed 3"), 3);
    expect_near(answer("'x*y' --domain 0,2,0,4 --method stratified --seed 4"), 16);
    expect_near(answer("'x' --domain 0,2,0,4 --method stratified --seed 5"), 8);  // a function of x in two dimensions
}

TEST_F(IntegrateCommand, TellsValueErrorAndMethod) {
    const Said said = plumb("integrate 'exp(x)' --method stratified --n 64 --seed 1");
    EXPECT_THAT(said.out, AllOf(HasSubstr("exp(x)\n  1.71"), HasSubstr(" ± "),
                                HasSubstr("stratified: 32 runs of 64 samples, 2048 evaluations"),
                                HasSubstr("report: out/integrate.html")));
    EXPECT_THAT(read("out/integrate.html"), HasSubstr("the integral is not known"));
}

TEST_F(IntegrateCommand, IsTheSameForTheSameSeed) {
    const std::string call = "integrate 'exp(x*y)' --error 1e-4 --seed 5 --threads ";
    EXPECT_EQ(plumb(call + "1").out, plumb(call + "2").out);
}

TEST_F(IntegrateCommand, ComparesAShippedIntegrandWithItsIntegral) {
    const Json all = answers("@exp --method torus-tent --seed 1");
    EXPECT_DOUBLE_EQ(all["answers"][0]["exact"].get<double>(), std::exp(1) - 1);
    expect_near(all["answers"][0], std::exp(1) - 1);
    EXPECT_FALSE(all["series"][0]["expected_slope"].is_null());
    EXPECT_GE(all["series"][0]["points"].size(), 5u);
    EXPECT_THAT(complaint("integrate @expp"), HasSubstr("did you mean 'exp'"));
}

TEST_F(IntegrateCommand, MeetsATarget) {
    const Json absolute = answer("'exp(x)' --method independent --error 1e-3 --seed 1");
    EXPECT_LE(absolute["standard_error"].get<double>(), 1e-3);
    EXPECT_EQ(absolute["target_met"], "yes");
    expect_near(absolute, std::exp(1) - 1);
    const Json relative = answer("'100*exp(x)' --method stratified --error 0.01% --seed 1");
    EXPECT_LE(relative["standard_error"].get<double>(), 0.0175);
    EXPECT_GT(relative["all_evaluations"].get<double>(), relative["evaluations"].get<double>());
}

TEST_F(IntegrateCommand, SaysWhenTheTargetIsOutOfReach) {
    const Json missed = answer("'exp(x)' --method independent --error 1e-9 --max-evaluations 100000 --seed 1", 3);
    EXPECT_EQ(missed["target_met"], "no");
    EXPECT_LE(missed["all_evaluations"].get<double>(), 100000);
    const Json constant = answer("'2' --method independent --error 1% --max-evaluations 100000 --seed 1", 3);
    EXPECT_EQ(constant["standard_error"], "inf");
    EXPECT_EQ(constant["value"], 2);
}

TEST_F(IntegrateCommand, DoesNotTrustAnErrorWhereTheVarianceIsInfinite) {
    int met = 0;
    for (int seed = 0; seed < 10; ++seed)
        met +=
            plumb(fmt::format("integrate '1/x^0.9' --method independent --error 5% --max-evaluations 1000000 --seed {}",
                              seed))
                .exit_code == 0;
    EXPECT_LE(met, 3);
}

TEST_F(IntegrateCommand, DeterministicMethodsHaveNoError) {
    const Json halton = answer("'exp(x)' --method halton --n 1000");
    EXPECT_EQ(halton["standard_error"], "inf");
    EXPECT_EQ(halton["runs"], 1);
    EXPECT_THAT(halton["known"], HasSubstr("deterministic"));
    EXPECT_EQ(answer("@exp --method halton --n 1000")["evaluations"], 1000);
    EXPECT_THAT(complaint("integrate 'exp(x)' --method halton --error 1%"), HasSubstr("'halton' is deterministic"));
}

TEST_F(IntegrateCommand, IntegratesAnImage) {
    std::string pixels;
    for (int i = 0; i < 16 * 8 * 3; ++i) pixels += static_cast<char>(i % 7 * 20);
    write("p.ppm", "P6\n16 8\n255\n" + pixels);
    for (const char* lookup : {"", " --lookup bilinear"}) {
        const Json all = answers(std::string("p.ppm --method stratified --n 100 --seed 1") + lookup)["answers"];
        ASSERT_EQ(all.size(), 4u);  // R, G, B and luminance
        for (const Json& one : all) expect_near(one, one["exact"].get<double>());
        double red = 0;
        for (std::size_t i = 0; i < pixels.size(); i += 3) red += pixels[i] / 255.0 / 128;
        EXPECT_NEAR(all[0]["exact"].get<double>(), red, 1e-6);
    }
    EXPECT_EQ(answers("p.ppm --channel luminance --n 64")["answers"].size(), 1u);
    EXPECT_THAT(complaint("integrate p.ppm --channel Z"), HasSubstr("unknown channel 'Z'"));
    std::filesystem::resize_file(folder / "p.ppm", 200);
    EXPECT_THAT(complaint("integrate p.ppm"), HasSubstr("p.ppm: not a readable image"));
    EXPECT_THAT(complaint("integrate q.png"), HasSubstr("q.png: there is no such file"));
}

TEST_F(IntegrateCommand, ReweightsSamples) {
    write_samples("one.csv", 2, 1000, 1);
    for (const char* method : {"voronoi", "torus", "reweighted", "independent"}) {
        const Json one = answer(fmt::format("one.csv --method {}", method));
        EXPECT_NEAR(one["value"].get<double>(), 1. / 3, method == std::string("independent") ? 0.06 : 0.01) << method;
        EXPECT_EQ(one["standard_error"] == "inf", method != std::string("independent")) << method;
    }
    write_samples("two.csv", 3, 1000, 1);
    for (const char* method : {"voronoi", "torus", "voronoi-reweighted"})
        EXPECT_NEAR(answer(fmt::format("two.csv --method {}", method))["value"].get<double>(), 5. / 6, 0.03) << method;
}

TEST_F(IntegrateCommand, KnowsTheErrorOfBatchesAndFiles) {
    write_samples("s.csv", 2, 4000, 1);
    const Json batches = answers("s.csv --method torus --batches 20");
    EXPECT_EQ(batches["answers"][0]["runs"], 20);
    expect_near(batches["answers"][0], 1. / 3);
    EXPECT_GE(batches["series"][0]["points"].size(), 3u);
    std::string files;
    for (int i = 0; i < 8; ++i) {
        files += fmt::format("f{}.csv ", i);
        write_samples(fmt::format("f{}.csv", i), 3, 200, 10 + i);
    }
    const Json sets = answer(files + "--method torus");
    EXPECT_EQ(sets["runs"], 8);
    expect_near(sets, 5. / 6);
}

TEST_F(IntegrateCommand, ScalesSamplesToADomain) {
    write("s.csv", "-1,2\n0,2\n1,2\n");
    EXPECT_NEAR(answer("s.csv --domain=-2,2")["value"].get<double>(), 8, 1e-12);
    EXPECT_THAT(complaint("integrate s.csv"), AllOf(HasSubstr("s.csv:1: column 1: -1"), HasSubstr("--domain")));
}

TEST_F(IntegrateCommand, ReadsStandardInputAndWritesStandardOutput) {
    write("s.csv", "x,f\n0.25,3\n0.5,4\n0.75,8\n");
    const Said said = plumb("integrate - --json - <s.csv");
    ASSERT_EQ(said.exit_code, 0) << said.error;
    EXPECT_EQ(Json::parse(said.out)["answers"][0]["value"], answer("s.csv")["value"]);
    EXPECT_THAT(said.error, HasSubstr("voronoi")) << "what is said besides";
    EXPECT_EQ(plumb("integrate s.csv --quiet").out, "");
    EXPECT_THAT(complaint("integrate x --json - --report -"), HasSubstr("two outputs are named '-'"));
}

TEST_F(IntegrateCommand, TakesNumbersAsTheyAreWritten) {
    EXPECT_EQ(answer("'exp(x)' --n 1e2 --seed 1 --report ''")["n"], 100);
    EXPECT_EQ(answer("'exp(x)' --method stratified --error '1 %' --seed 1 --report ''")["target_met"], "yes");
    EXPECT_FALSE(std::filesystem::exists(folder / "out"));
}

TEST_F(IntegrateCommand, ReadsColumnsByTheirNames) {
    write("s.csv", "x,f\n0.25,3\n0.5,4\n0.75,8\n");
    const Json value = answer("s.csv")["value"];
    write("turned.csv", "f,x\n3,0.25\n4,0.5\n8,0.75\n");
    write("named.tsv", "# f\tx\n3\t0.25\n4\t0.5\n8\t0.75\n");
    write("numpy.txt", "# x f\n2.5e-01 3.0e+00\n5.0e-01 4.0e+00\n7.5e-01 8.0e+00\n");
    write("excel.csv", "x;f\r\n0.25;3\r\n0.5;4\r\n0.75;8\r\n");
    for (const char* file : {"turned.csv", "named.tsv", "numpy.txt", "excel.csv"})
        EXPECT_EQ(answer(file)["value"], value) << file;
    write("wrong.csv", "value,x\n3,0.25\n4,0.5\n");
    EXPECT_THAT(complaint("integrate wrong.csv"), HasSubstr("wrong.csv: columns value,x found; accepted are 2 (x,f)"));
}

TEST_F(IntegrateCommand, SaysWhatIsWrong) {
    EXPECT_THAT(complaint("integrate 'exp(x'"), HasSubstr("formula 'exp(x', column 6"));
    EXPECT_THAT(complaint("integrate ''"), HasSubstr("column 1"));
    EXPECT_THAT(complaint("integrate -x"), HasSubstr("'-x'; what begins with - but is no option goes last, after --"));
    EXPECT_THAT(complaint("integrate 'sqrt(x-2)' --seed 1"), HasSubstr("sqrt(x-2) is -nan at x = "));
    EXPECT_THAT(complaint("integrate '1/(x-x)' --seed 1"), HasSubstr("is inf at x = "));
    EXPECT_THAT(complaint("integrate x --method torrus"), HasSubstr("did you mean 'torus'"));
    EXPECT_THAT(complaint("integrate x --method cmj"), HasSubstr("method 'cmj' is for 2D integrands, x is 1D"));
    EXPECT_THAT(complaint("integrate x y"), HasSubstr("more than one integrand"));
    EXPECT_THAT(complaint("integrate x --batches 4"), HasSubstr("--batches goes with a file of samples"));
    EXPECT_THAT(complaint("integrate x --channel R"), HasSubstr("--channel goes with an image"));
    EXPECT_THAT(complaint("integrate x --error 0"), HasSubstr("'0' is not an error"));
    EXPECT_THAT(complaint("integrate x --error 1e-3 --n 5"), HasSubstr("--n"));
    EXPECT_THAT(complaint("integrate x --replicates 8"), HasSubstr("--replicates"));
    EXPECT_THAT(complaint("integrate x --n 0"), HasSubstr("--n"));
    EXPECT_THAT(complaint("integrate x --report /dev/null/x.html"), HasSubstr("/dev/null/x.html"));
    EXPECT_THAT(complaint("integrate missing.csv"), HasSubstr("missing.csv: cannot be read"));
    write("s.csv", "x,f\n0.5,1\n0.7,oops\n");
    EXPECT_THAT(complaint("integrate s.csv"), HasSubstr("s.csv:3: column 2 (f): 'oops' found"));
    write("one.csv", "0.5\n");
    EXPECT_THAT(complaint("integrate one.csv"), HasSubstr("1 columns found; accepted are 2 (x,f) and 3 (x,y,f)"));
    write("s.csv", "0.5,1\n0.7,1\n");
    EXPECT_THAT(complaint("integrate s.csv --n 5"), HasSubstr("--n does not go with a file of samples"));
    EXPECT_THAT(complaint("integrate s.csv --batches 5"), HasSubstr("the file has 2 samples"));
    EXPECT_THAT(complaint("integrate s.csv --method sobol"), HasSubstr("unknown method for 1D samples 'sobol'"));
    write("picture.png", "not a picture");
    EXPECT_THAT(complaint("integrate picture.png"), HasSubstr("picture.png: not a readable image"));
}

}  // namespace
}  // namespace plumb::cli

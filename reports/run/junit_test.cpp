#include "reports/run/junit.h"

#include <gmock/gmock.h>

#include "reports/run/sample_results.h"

namespace plumb::reports {
namespace {

using testing::AllOf, testing::HasSubstr;

Results two_claims() {
    Results results = sample_results();
    results.run.started = "2025-01-31T23:59:59Z";
    results.claims = {results.claims[0], results.claims[4]};
    results.mutants.clear();
    return results;
}

TEST(Junit, WritesASuiteAGroupAndACaseAClaim) {
    Results results = two_claims();
    results.claims[0].id = "a/b/c";
    results.claims[1] = results.claims[0];
    results.claims[1].id = "d";
    results.claims[1].verdict.outcome = Outcome::undecided;
    results.claims[1].verdict.reason = "neither \"a\" < b\nnor c & d";
    results.claims[1].statement = "It is\x01 so.";
    results.claims[1].source = "\xC3\xA9 \xE2\x80\xA6 \xFF \xC0\xAF \xED\xA0\x80";
    results.claims[1].verdict.deviation = {};
    results.claims[1].position = 7;
    EXPECT_EQ(junit_xml(results), R"(<?xml version="1.0" encoding="UTF-8"?>
<testsuites name="plumb" tests="2" failures="0" errors="1" time="0.008">
  <testsuite name="a" tests="1" failures="0" errors="0" time="0.004" skipped="0" timestamp="2025-01-31T23:59:59">
    <properties>
      <property name="seed" value="17592186044416123457"/>
      <property name="alpha" value="0.0001"/>
      <property name="size" value="quick"/>
      <property name="version" value="0.1.0"/>
      <property name="shard" value="1/1"/>
    </properties>
    <testcase classname="a.b" name="c" time="0.004"/>
  </testsuite>
  <testsuite name="d" tests="1" failures="0" errors="1" time="0.004" skipped="0" timestamp="2025-01-31T23:59:59">
    <properties>
      <property name="seed" value="17592186044416123457"/>
      <property name="alpha" value="0.0001"/>
      <property name="size" value="quick"/>
      <property name="version" value="0.1.0"/>
      <property name="shard" value="1/1"/>
    </properties>
    <testcase classname="d" name="d" time="0.004">
      <error type="undecided" message="neither &quot;a&quot; &lt; b&#10;nor c &amp; d">It is� so.&#10;é … � �� ���&#10;8 samples, p-value –, deviation –, resolution 0</error>
    </testcase>
  </testsuite>
</testsuites>
)");
}

TEST(Junit, FailsWhatIsRefutedAndMutantsThatLive) {
    const std::string xml = junit_xml(sample_results());
    EXPECT_THAT(xml, AllOf(HasSubstr(R"(<testsuites name="plumb" tests="16" failures="2" errors="2")"),
                           HasSubstr(R"(<failure type="refuted")"), HasSubstr(R"(<error type="mutant undecided")"),
                           HasSubstr(R"(classname="reweighting.torus" name="unbiased/clipped")")));
}

}  // namespace
}  // namespace plumb::reports

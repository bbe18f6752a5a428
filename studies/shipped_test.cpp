#include "studies/shipped.h"

#include <gmock/gmock.h>

#include "studies/study_file.h"

namespace plumb {
namespace {

TEST(ShippedStudies, AreRightAndSayWhatTheyShow) {
    ASSERT_FALSE(shipped_studies().empty());
    for (const auto& [name, text] : shipped_studies()) {
        const Study study = parse_study(text, std::string(name) + ".toml");
        EXPECT_FALSE(study.about.text.empty()) << name;
        EXPECT_FALSE(study.about.source.empty()) << name;
    }
}

}  // namespace
}  // namespace plumb

#include "integrators/references/provenance.h"

#include <gmock/gmock.h>

#include "core/error.h"

namespace plumb {
namespace {

Image image_with(const std::map<std::string, std::string>& metadata) {
    return {1, 1, {"R", "G", "B"}, {0, 0, 0}, metadata};
}

TEST(Provenance, SurvivesItsMetadata) {
    const Provenance said{.scene = "box",
                          .scene_hash = "0123456789abcdef",
                          .integrator = "bdpt",
                          .sampler = "sobol",
                          .version = "1.2",
                          .driver = "frameless",
                          .parameters = {{"pixel-share", "0.5"}, {"roulette-start", "3"}},
                          .limits = {7, 3, 6, Strategy{2, 5}},
                          .seed = 1u << 31,
                          .samples_per_pixel = 64,
                          .replicates = 16,
                          .film = {20, 10},
                          .crop = {1, 2, 3, 4},
                          .error = {2.5, 0.1 + 0.2}};
    std::map<std::string, std::string> metadata = metadata_of(said);
    metadata.merge(metadata_of(said.error));
    const auto read = provenance_of(image_with(metadata), "a.exr");
    ASSERT_TRUE(read);
    EXPECT_EQ(metadata_of(*read), metadata_of(said));
    EXPECT_EQ(read->driver, "frameless");
    EXPECT_EQ(read->parameters, said.parameters);
    EXPECT_EQ(read->error.relative, said.error.relative);
    EXPECT_EQ(read->limits.strategy->t, 5);
    EXPECT_FALSE(read->is_radiance());
}

TEST(Provenance, SaysHowLongPathsMayBe) {
    EXPECT_EQ((Provenance{.integrator = "direct-bsdf"}.longest_path()), 2);
    EXPECT_EQ((Provenance{.integrator = "path"}.longest_path()), std::nullopt);
    EXPECT_EQ((Provenance{.integrator = "path", .limits = {.max_edges = 3}}.longest_path()), 3);
    EXPECT_FALSE(Provenance{.integrator = "aov"}.is_radiance());
}

TEST(Provenance, OfForeignImagesIsNotKnown) {
    EXPECT_FALSE(provenance_of(image_with({{"Software", "another"}}), "a.exr"));
    auto metadata = metadata_of({.scene_hash = "0"});
    metadata["plumb:seed"] = "seven";
    try {
        (void)provenance_of(image_with(metadata), "a.exr");
        FAIL();
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(), "a.exr: attribute plumb:seed is 'seven' where 1 number is expected");
    }
}

}  // namespace
}  // namespace plumb

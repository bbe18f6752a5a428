#include "scenes/bsdfs/twosided.h"

#include <gtest/gtest.h>

#include "scenes/bsdfs/diffuse.h"

namespace plumb {
namespace {

static_assert(BsdfModel<TwoSided<Diffuse>>);

TEST(TwoSided, DoesBelowWhatItDoesAbove) {
    const TwoSided<Diffuse> bsdf{{Spectrum::grey(0.4)}};
    EXPECT_EQ(bsdf.pdf({0, 0, -1}, {0.6, 0, -0.8}), bsdf.pdf({0, 0, 1}, {0.6, 0, 0.8}));
    EXPECT_EQ(bsdf.pdf({0, 0, -1}, {0.6, 0, 0.8}), 0);
    EXPECT_LT(bsdf.sample({0, 0, -1}, {0, 0.5, 0.5}, Transport::radiance)->wi.z, 0);
}

}  // namespace
}  // namespace plumb

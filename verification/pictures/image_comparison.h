#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/interval.h"
#include "verification/pictures/image_correlation.h"
#include "verification/pictures/image_errors.h"
#include "verification/pictures/mean_difference.h"
#include "verification/pictures/picture.h"
#include "verification/pictures/pixel_squares.h"
#include "verification/verdict.h"

namespace plumb {

/// The risks and tolerances with which two pictures are compared. Derivations: docs/compare.md.
struct ComparisonSettings {
    double alpha = 1e-4;      ///< of refuting two true estimates: ½ tiles, ⅛ each chi-square, means, too (un)alike
    double beta = 0.01;       ///< of `holds` when the mean or a tile is off by its delta or more
    double delta = 0.01;      ///< of the picture's mean, relative to b's
    double tile_delta = 0.1;  ///< of a tile's mean, relative to b's there or tile_floor times the picture's, if larger
    double tile_floor = 0.25;
    double epsilon = 0;  ///< a deviation that is allowed and refutes nothing, relative as the deltas are
    int tile = 0;        ///< edge in pixels; 0: about 256 tiles, and at least four times the reach of correlations
};

/// The state of a tile: whether both pictures agree there, or why that is not known.
enum class TileState { same, differs, too_noisy, heavy_tails, no_variance, no_pixels, poorly_known, error_unknown };
std::string to_string(TileState state);

/// The test of one tile in one channel.
struct TileTest {
    PixelBox box;
    std::size_t channel = 0;
    std::uint64_t pixels = 0;  ///< that count: finite in both
    TileState state = TileState::no_pixels;
    MeanDifference found = {};
};

/// The tests of one channel over the whole picture.
struct ChannelTest {
    std::string channel;
    MeanDifference mean = {};  ///< over the picture
    TileState state = TileState::no_pixels;
    double chi_square = 0;  ///< of the tiles' normal scores
    std::uint64_t degrees = 0;
    double upper_p = 1, lower_p = 1;  ///< the lower one for reading: it refutes nothing
};

/// The comparison of two pictures: its verdict, and everything that led to it.
struct ImageComparison {
    Verdict verdict = {};
    int tile = 0, columns = 0, rows = 0;
    std::vector<TileTest> tiles = {};         ///< row by row, channel by channel
    std::vector<std::size_t> differing = {};  ///< indices of tiles that are refuted, worst first
    std::vector<std::size_t> undecided = {};  ///< of tiles that are not decided, worst first
    std::vector<ChannelTest> channels = {};
    SquaresTest alike = {}, unlike = {};
    Correlation correlation = {};
    std::string copies = {};  ///< how one is a copy of the other, in words; empty: it is none
    std::vector<ErrorMeasure> errors = {};
    std::uint64_t bad_a = 0, bad_b = 0;  ///< pixels that are not finite: they count nowhere
    bool error_known = true;             ///< of both pictures; else there are means and errors, but no tests
};

/// Compares two estimates of a picture: whether it is the same. Where the error of one is unknown there is no verdict,
/// and the outcome is undecided. Throws Error where sizes or channels differ.
ImageComparison compare(const Picture& a, const Picture& b, const ComparisonSettings& settings = {});

}  // namespace plumb

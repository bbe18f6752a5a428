#pragma once

#include <string>

namespace plumb::cli {

/// Images that somebody has, and where what is found about them goes.
struct ImageSeriesTask {
    std::string images;     ///< a pattern, see image_pattern.h
    std::string reference;  ///< an image
    int threads = 0;
    std::string json, report;  ///< empty: none
};

/// The error of the images against samples a pixel; the program's exit code. Throws Error.
int converge_images(const ImageSeriesTask& options);

}  // namespace plumb::cli

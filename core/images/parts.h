#pragma once

#include <string>
#include <vector>

#include "core/images/image.h"

namespace plumb {

/// A rectangle of pixels, y downwards.
struct PixelWindow {
    int x = 0, y = 0, width = 0, height = 0;
    friend bool operator==(const PixelWindow&, const PixelWindow&) = default;
};

/// One picture of a file, as it is stored.
struct ImagePart {
    Image image;                ///< of the pixels of `data`
    PixelWindow data, display;  ///< where there are numbers, and what is to be seen
    int orientation = 1;        ///< of Exif and TIFF, 1 to 8: how what is stored lies in what is seen
    std::string name = {};      ///< of the part, where it has one
};

/// What a file holds, as it is stored.
struct ImageParts {
    std::string format;            ///< OpenImageIO's name of it
    std::vector<ImagePart> parts;  ///< all of an EXR file, else the first
};

/// What the file means, by the conventions of read_image() in core/images/image.h. Throws std::invalid_argument saying
/// what cannot be.
Image picture_of(ImageParts parts);

}  // namespace plumb

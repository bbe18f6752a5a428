#pragma once

#include <string>

#include "analytic/image.h"

/// The one function of the module plumb_image_reader, the only code that links OpenImageIO: its 250 shared libraries
/// take 0.14 s and 130 MB to load, so the program loads the module when it meets an image. Leaves `why` empty, or says
/// why there is no image.
extern "C" void plumb_decode_image(const char* file, plumb::Image* image, std::string* why);

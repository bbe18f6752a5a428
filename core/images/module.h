#pragma once

#include <string>

#include "core/images/image.h"
#include "core/images/parts.h"

/// The functions of the module plumb_image_module, the only code that links OpenImageIO: its 250 shared libraries take
/// 0.14 s and 130 MB to load, so the program loads the module when it meets an image. All leave `why` empty, or say
/// what is wrong.
extern "C" void plumb_decode_image(const char* file, plumb::ImageParts* parts, std::string* why);
extern "C" void plumb_find_encoder(const char* file, std::string* why);
extern "C" void plumb_encode_image(const char* file, const plumb::Image* image, std::string* why);

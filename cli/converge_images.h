#pragma once

#include "cli/options.h"

namespace plumb::cli {

/// The error of images that somebody has, against samples a pixel; the program's exit code. Throws Error.
int converge_images(const ConvergeOptions& options);

}  // namespace plumb::cli

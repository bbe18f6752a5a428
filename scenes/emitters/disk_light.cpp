#include "scenes/emitters/disk_light.h"

namespace plumb {

DiskLight DiskLight::of(const description::Disk& disk, const Spectrum& radiance) {
    const double a = length(disk.axis_x), b = length(disk.axis_y);
    if (std::abs(a - b) > 1e-9 * a || std::abs(dot(disk.axis_x, disk.axis_y)) > 1e-9 * a * b)
        throw Error(fmt::format("an emitting disk with axes of {} and {}: accepted are circles", a, b));
    return {disk.center, disk.normal, a, radiance};
}

}  // namespace plumb

#include "verification/pictures/pixel_grid.h"

#include <algorithm>
#include <cstdint>

namespace plumb {

PixelGrid grid_of(int width, int height, int tile) {
    PixelGrid grid{tile, std::max(1, width / tile), std::max(1, height / tile)};
    const auto edge = [](int i, int parts, int length) {
        return static_cast<int>(static_cast<std::int64_t>(i) * length / parts);
    };
    for (int row = 0; row < grid.rows; ++row)
        for (int column = 0; column < grid.columns; ++column) {
            const int x = edge(column, grid.columns, width), y = edge(row, grid.rows, height);
            grid.boxes.push_back(
                {x, y, edge(column + 1, grid.columns, width) - x, edge(row + 1, grid.rows, height) - y});
        }
    return grid;
}

}  // namespace plumb

#pragma once

#include <vector>

namespace plumb {

/// A rectangle of pixels.
struct PixelBox {
    int x = 0, y = 0, width = 0, height = 0;
};

/// Calls visit(x, y) row by row.
template <class Visit>
void for_pixels(const PixelBox& box, Visit visit) {
    for (int y = box.y; y < box.y + box.height; ++y)
        for (int x = box.x; x < box.x + box.width; ++x) visit(x, y);
}

/// A picture cut into tiles of about equal size, row by row.
struct PixelGrid {
    int tile = 0, columns = 0, rows = 0;
    std::vector<PixelBox> boxes = {};

    [[nodiscard]] std::size_t index(int column, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(column);
    }
};

/// Tiles of this edge, in pixels, or somewhat more: none is a rest.
PixelGrid grid_of(int width, int height, int tile);

/// Calls visit(index) for the tiles at most `reach` columns and rows away, the tile itself among them.
template <class Visit>
void for_tiles_about(const PixelGrid& grid, int column, int row, int reach, Visit visit) {
    for (int v = row - reach; v <= row + reach; ++v)
        for (int u = column - reach; u <= column + reach; ++u)
            if (u >= 0 && v >= 0 && u < grid.columns && v < grid.rows) visit(grid.index(u, v));
}

}  // namespace plumb

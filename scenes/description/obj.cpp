#include "scenes/description/obj.h"

#include <unordered_map>

#include <fmt/format.h>

#include "core/file.h"
#include "scenes/description/text_cursor.h"

namespace plumb {

namespace {

/// Indices from 0 into v, vt and vn; -1 where there is none.
using Corner = std::array<std::int64_t, 3>;

struct CornerHash {
    std::size_t operator()(const Corner& c) const {
        return static_cast<std::size_t>(c[0] * 0x9E3779B97F4A7C15 + c[1] * 0xC2B2AE3D27D4EB4F + c[2]);
    }
};

class ObjReader {
public:
    ObjReader(std::string_view text, const std::string& file) : cursor_(text, file) {}

    Mesh read() {
        for (; !cursor_.at_end(); cursor_.next_line()) {
            const std::string_view keyword = cursor_.word();
            if (keyword == "v") positions_.push_back(numbers<3>("a coordinate of v"));
            if (keyword == "vt") uvs_.push_back(numbers<2>("a coordinate of vt"));
            if (keyword == "vn") normals_.push_back(numbers<3>("a coordinate of vn"));
            if (keyword == "f") read_face();
        }
        if (mesh_.triangles.empty()) throw cursor_.error("no faces");
        if (!all_uvs_) mesh_.uvs.clear();
        if (!all_normals_) mesh_.normals.clear();
        return std::move(mesh_);
    }

private:
    template <std::size_t n>
    std::array<float, n> numbers(std::string_view what) {
        std::array<float, n> result;
        for (float& value : result) value = cursor_.number<float>(what);
        return result;
    }

    void read_face() {
        std::vector<std::uint32_t> corners;
        while (!cursor_.line_done()) corners.push_back(vertex(corner(cursor_.word())));
        if (corners.size() < 3)
            throw cursor_.error(fmt::format("a face of {} corners; 3 or more are accepted", corners.size()));
        for (std::size_t i = 2; i < corners.size(); ++i) {
            mesh_.triangles.push_back({corners[0], corners[i - 1], corners[i]});
        }
    }

    Corner corner(std::string_view word) const {
        static constexpr std::array<std::string_view, 3> names{"v", "vt", "vn"};
        const std::array<std::size_t, 3> sizes{positions_.size(), uvs_.size(), normals_.size()};
        Corner result{-1, -1, -1};
        for (std::size_t i = 0; i < 3 && !word.empty(); ++i) {
            const std::string_view part = word.substr(0, word.find('/'));
            word.remove_prefix(std::min(word.size(), part.size() + 1));
            if (part.empty() && i > 0) continue;
            const auto written = cursor_.parsed<std::int64_t>(part, "a face's index");
            const auto size = static_cast<std::int64_t>(sizes[i]);
            result[i] = written < 0 ? size + written : written - 1;
            if (result[i] < 0 || result[i] >= size) {
                throw cursor_.error(
                    fmt::format("a face's {} index is {}; there are {} before it", names[i], written, size));
            }
        }
        return result;
    }

    std::uint32_t vertex(const Corner& corner) {
        const auto next = static_cast<std::uint32_t>(mesh_.positions.size());
        const auto [found, is_new] = vertices_.try_emplace(corner, next);
        if (!is_new) return found->second;
        mesh_.positions.push_back(positions_[static_cast<std::size_t>(corner[0])]);
        all_uvs_ &= corner[1] >= 0;
        all_normals_ &= corner[2] >= 0;
        if (all_uvs_) {
            const auto& uv = uvs_[static_cast<std::size_t>(corner[1])];
            mesh_.uvs.push_back({uv[0], 1 - uv[1]});
        }
        if (all_normals_) mesh_.normals.push_back(normals_[static_cast<std::size_t>(corner[2])]);
        return next;
    }

    TextCursor cursor_;
    std::vector<std::array<float, 3>> positions_, normals_;
    std::vector<std::array<float, 2>> uvs_;
    std::unordered_map<Corner, std::uint32_t, CornerHash> vertices_;
    bool all_uvs_ = true, all_normals_ = true;
    Mesh mesh_;
};

}  // namespace

Mesh read_obj(const std::filesystem::path& file) {
    const std::string text = read_file(file);
    return ObjReader(text, file.string()).read();
}

}  // namespace plumb

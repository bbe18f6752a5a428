#include "scenes/description/obj.h"

#include <unordered_map>

#include <fmt/format.h>

#include "core/file.h"
#include "scenes/description/polygon.h"
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
    ObjReader(std::string_view text, const std::string& file) : start_(text, file, Continuation::backslash) {}

    /// Twice through the text: a face may come before the vertices that it names.
    Mesh read() {
        for (cursor_ = start_; !cursor_.at_end(); cursor_.next_line()) read_vector(cursor_.word());
        for (cursor_ = start_; !cursor_.at_end(); cursor_.next_line()) read_element(cursor_.word());
        if (mesh_.triangles.empty()) throw cursor_.error("no faces");
        if (has_normals_ && lacks_normals_) add_lacking_normals();
        if (!has_uvs_) mesh_.uvs.clear();
        if (!has_normals_) mesh_.normals.clear();
        return std::move(mesh_);
    }

private:
    template <std::size_t n>
    std::array<float, n> numbers(std::string_view what) {
        std::array<float, n> result;
        for (float& value : result) value = cursor_.number<float>(what);
        return result;
    }

    void read_vector(std::string_view keyword) {
        if (keyword == "v") positions_.push_back(numbers<3>("a coordinate of v"));
        if (keyword == "vn") normals_.push_back(numbers<3>("a coordinate of vn"));
        if (keyword != "vt") return;
        const auto u = cursor_.number<float>("a coordinate of vt");
        uvs_.push_back({u, cursor_.line_done() ? 0 : cursor_.number<float>("a coordinate of vt")});
    }

    void read_element(std::string_view keyword) {
        if (keyword == "v") ++before_[0];
        if (keyword == "vt") ++before_[1];
        if (keyword == "vn") ++before_[2];
        if (keyword == "f" || keyword == "fo") read_face();
        if (keyword == "surf" || keyword == "curv")
            throw cursor_.error(fmt::format("the free-form element '{}'; faces (f) are accepted", keyword));
    }

    void read_face() {
        std::vector<std::uint32_t> corners;
        while (!cursor_.line_done()) corners.push_back(vertex(corner(cursor_.word())));
        if (corners.size() < 3)
            throw cursor_.error(fmt::format("a face of {} corners; 3 or more are accepted", corners.size()));
        if (const std::string wrong = add_polygon(mesh_, corners); !wrong.empty()) throw cursor_.error(wrong);
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
            result[i] = written < 0 ? before_[i] + written : written - 1;
            if (written < 0 && result[i] < 0)
                throw cursor_.error(
                    fmt::format("a face's {} index is {}; there are {} before it", names[i], written, before_[i]));
            if (written == 0 || result[i] >= size)
                throw cursor_.error(fmt::format("a face's {} index is {}; there are {}", names[i], written, size));
        }
        return result;
    }

    std::uint32_t vertex(const Corner& corner) {
        const auto next = static_cast<std::uint32_t>(mesh_.positions.size());
        const auto [found, is_new] = vertices_.try_emplace(corner, next);
        if (!is_new) return found->second;
        mesh_.positions.push_back(positions_[static_cast<std::size_t>(corner[0])]);
        std::array<float, 2> uv{0, 1};  // of (0, 0), as v is turned
        if (corner[1] >= 0) uv = uvs_[static_cast<std::size_t>(corner[1])], uv[1] = 1 - uv[1];
        mesh_.uvs.push_back(uv);
        std::array<float, 3> normal{};
        if (corner[2] >= 0) normal = normals_[static_cast<std::size_t>(corner[2])];
        mesh_.normals.push_back(normal);
        (corner[2] >= 0 ? has_normals_ : lacks_normals_) = true;
        has_uvs_ = has_uvs_ || corner[1] >= 0;
        return next;
    }

    /// Corners without a normal get what they would have in a mesh of such corners alone.
    void add_lacking_normals() {
        Mesh smooth = mesh_;
        add_smooth_normals(smooth);
        for (const auto& [corner, index] : vertices_)
            if (corner[2] < 0) mesh_.normals[index] = smooth.normals[index];
    }

    TextCursor start_, cursor_ = start_;
    std::array<std::int64_t, 3> before_{};  ///< how many v, vt and vn stand before the line
    std::vector<std::array<float, 3>> positions_, normals_;
    std::vector<std::array<float, 2>> uvs_;
    std::unordered_map<Corner, std::uint32_t, CornerHash> vertices_;
    bool has_uvs_ = false, has_normals_ = false, lacks_normals_ = false;
    Mesh mesh_;
};

}  // namespace

Mesh read_obj(const std::filesystem::path& file) {
    const std::string text = read_file(file);
    return ObjReader(text, file.string()).read();
}

}  // namespace plumb

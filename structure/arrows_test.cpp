// The arrows between folders, two levels deep, as docs/architecture.md draws them: who may include whom.
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "structure/source_tree.h"

namespace plumb::structure {
namespace {

/// A room is a folder of the second level, or the files that lie directly in one of the first; all suites are one. A
/// family's list lies above its rooms, its front header below them, so that list and rooms may name each other there.
/// An entry without a slash stands for its rooms too. Every room may include core and itself.
const std::map<std::string, std::set<std::string>> allowed = {
    {"core", {}},
    {"core/images", {}},
    {"analytic", {"analytic/formulas"}},
    {"analytic/formulas", {"analytic"}},
    {"estimators", {"analytic", "estimators/mis", "estimators/points", "estimators/reweighting"}},
    {"estimators/debiasing", {"estimators/", "estimators/densities"}},
    {"estimators/densities", {}},
    {"estimators/mis", {"estimators/", "estimators/debiasing", "estimators/densities", "estimators/replicates"}},
    {"estimators/points", {"analytic", "estimators/", "estimators/replicates"}},
    {"estimators/replicates", {"analytic", "estimators/"}},
    {"estimators/reweighting",
     {"analytic", "estimators/", "estimators/densities", "estimators/points", "estimators/replicates",
      "estimators/voronoi"}},
    {"estimators/voronoi", {}},
    {"scenes", {"scenes/bsdfs", "scenes/emitters", "scenes/geometry", "scenes/sensors", "scenes/textures"}},
    {"scenes/bsdfs", {"estimators/densities", "scenes/description", "scenes/spectra", "scenes/textures"}},
    {"scenes/description", {}},
    {"scenes/emitters",
     {"estimators/densities", "scenes/bsdfs", "scenes/description", "scenes/geometry", "scenes/textures"}},
    {"scenes/film", {"scenes/description"}},
    {"scenes/geometry", {"scenes/description"}},
    {"scenes/mitsuba", {"scenes/", "scenes/description", "scenes/spectra"}},
    {"scenes/sensors",
     {"estimators/densities", "scenes/bsdfs", "scenes/description", "scenes/film", "scenes/geometry"}},
    {"scenes/shipped", {"scenes/", "scenes/film", "scenes/mitsuba"}},
    {"scenes/spectra", {}},
    {"scenes/textures", {"scenes/description"}},
    {"integrators", {"integrators/drivers", "integrators/estimators", "integrators/paths", "integrators/references"}},
    {"integrators/drivers", {"estimators/points", "estimators/replicates", "integrators/paths", "scenes/film"}},
    {"integrators/estimators", {"integrators/paths"}},
    {"integrators/paths", {"estimators/mis", "scenes/"}},
    {"integrators/references", {"integrators/", "integrators/paths", "scenes/", "scenes/film", "scenes/shipped"}},
    {"verification", {}},
    {"verification/evidence", {"verification/"}},
    {"verification/pictures", {"verification/", "verification/evidence"}},
    {"verification/suites", {"analytic", "checks", "estimators", "integrators", "scenes", "verification"}},
    {"checks/bsdf", {"estimators/densities", "scenes/bsdfs", "verification/", "verification/evidence"}},
    {"checks/sampler", {"estimators/densities", "verification/", "verification/evidence"}},
    {"reports/images", {"reports/page", "reports/run", "reports/text", "verification/pictures"}},
    {"reports/page", {"reports/text"}},
    {"reports/run", {"reports/page", "reports/text", "verification/"}},
    {"reports/study", {"reports/page", "reports/run", "reports/text"}},
    {"reports/text", {}},
    {"studies", {"analytic", "estimators", "integrators", "reports", "scenes", "verification"}},
    {"studies/own", {"analytic", "estimators", "reports", "verification"}},
    {"cli", {"reports", "verification"}},
    {"cli/verbs",
     {"analytic", "checks", "cli/", "estimators", "integrators", "reports", "scenes", "studies", "verification"}},
};

std::string first_of(const std::string& room) {
    return room.substr(0, room.find('/'));
}

std::string room_of(const std::string& path) {
    const std::size_t first = path.find('/'), second = path.find('/', first + 1);
    return second == std::string::npos ? path.substr(0, first) : path.substr(0, second);
}

bool may_include(const std::string& room, const std::string& other) {
    if (other == room || other == "core" || (first_of(other) == "core" && room != "core")) return true;
    const std::set<std::string>& rooms = allowed.at(room);
    const bool front = other.find('/') == std::string::npos;
    return rooms.contains(other) || rooms.contains(front ? other + "/" : first_of(other));
}

TEST(Arrows, PointOnlyWhereTheyMay) {
    std::set<std::string> seen;
    for (const SourceFile& file : source_files()) {
        const std::string& path = file.path;
        if (path.starts_with("examples/") || path.starts_with("structure/") ||
            path.starts_with("scenes/shipped/million"))
            continue;
        if (!path.ends_with(".h") && !path.ends_with(".cpp")) continue;
        if (path.ends_with("_test.cpp") || path.ends_with("_bench.cpp")) continue;
        const std::string room = room_of(path);
        ASSERT_TRUE(allowed.contains(room)) << path << ": docs/architecture.md and this test know no room " << room;
        seen.insert(room);
        for (const std::string& line : lines_of(path)) {
            if (!line.starts_with("#include \"")) continue;
            const std::string target = line.substr(10, line.rfind('"') - 10);
            if (target.find('/') == std::string::npos) continue;
            EXPECT_TRUE(may_include(room, room_of(target))) << path << ": " << line;
        }
    }
    EXPECT_EQ(seen.size(), allowed.size());
}

}  // namespace
}  // namespace plumb::structure

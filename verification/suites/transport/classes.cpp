// Which classes of paths `path`, `light` and `bdpt` make, against the predicate that says so: by what they find in
// scenes of pure materials.

#include <map>
#include <set>

#include "integrators/integrators.h"
#include "integrators/references/path_classes.h"
#include "verification/claim.h"
#include "verification/evidence/deterministic.h"
#include "verification/suites/transport/transport_subjects.h"

namespace plumb::suites {
namespace {

using Source = PathClass::Source;
using Classes = std::map<PathClass, std::uint64_t>;  // how often each was found
/// Who is predicted, and who searches.
enum class Transporter { path, light, bdpt };
using Predicate = bool (*)(Transporter, const PathClass&);

constexpr int most_edges = 4;

PathClass class_of(std::span<const PathVertex> vertices, Source source) {
    PathClass path{{}, source};
    for (const PathVertex& vertex : vertices) path.mirrors.push_back(!vertex.bsdf.smooth());
    return path;
}

// Finds classes of paths in a scene of pure materials: of the splats of `path` and `light`, and of the strategies of
// `bdpt`.
class Search {
public:
    Search(Transporter transporter, Source source, std::uint64_t seed)
        : transporter_(transporter), source_(source), seed_(seed) {
        bdpt_.weight = [this](const PathChain& chain, int) {
            PathClass path{{}, source_};
            for (int i = 1; i < chain.edges(); ++i)
                path.mirrors.push_back(!chain.vertices[static_cast<std::size_t>(i)]->surface->bsdf.smooth());
            ++found_[path];
            return 1.0;
        };
    }
    Search(const Search&) = delete;
    Search& operator=(const Search&) = delete;

    void go_on(std::uint32_t paths) {
        const Scene& scene = glass_scene(source_);
        for (const std::uint32_t end = next_ + paths; next_ < end; ++next_) {
            numbers_.start({seed_, 0, next_});
            estimator().trace(scene, whole_film(scene), numbers_, record_);
            if (transporter_ == Transporter::bdpt) continue;
            for (const Splat& splat : record_.splats) {
                const auto between = static_cast<std::size_t>(splat.edges - 1);
                const auto& vertices = splat.anywhere ? record_.light_vertices : record_.vertices;
                PathClass one = class_of({vertices.data(), between}, source_);
                if (splat.anywhere) std::reverse(one.mirrors.begin(), one.mirrors.end());
                ++found_[one];
            }
        }
    }
    [[nodiscard]] Transporter transporter() const { return transporter_; }
    [[nodiscard]] const Classes& found() const { return found_; }
    [[nodiscard]] std::uint32_t paths() const { return next_; }

private:
    [[nodiscard]] const PathEstimator& estimator() const {
        if (transporter_ == Transporter::path) return path_;
        if (transporter_ == Transporter::light) return light_;
        return bdpt_;
    }

    static constexpr PathLimits limits{.max_edges = most_edges, .roulette_edges = most_edges};
    Transporter transporter_;
    Source source_;
    std::uint64_t seed_;
    std::uint32_t next_ = 0;
    const PathTracer path_{limits};
    const LightTracer light_{limits};
    Bdpt bdpt_{limits};
    IndependentSamples numbers_;
    PathRecord record_;
    Classes found_;
};

const char* name_of(Transporter transporter) {
    return transporter == Transporter::path ? "path" : transporter == Transporter::light ? "light" : "bdpt";
}

// What an integrator makes in one of 1,000 paths, each must make that the predicate says, and none may make another.
// Who has not found a class yet looks on: of those that the scenes have so often, any other integrator makes the rarest
// in 3 of 10,000 paths, so that `most_paths` miss it with a probability of e^-60.
Verdict classes_are(Predicate predicate, const Run& run) {
    constexpr std::uint32_t most_paths = 200'000;
    const auto at_once = run.pick(10'000u, 100'000u);
    std::uint64_t cases = 0;
    for (const Source source : {Source::surface, Source::point, Source::environment}) {
        const std::uint64_t seed = run.random(static_cast<std::uint64_t>(source)).bits();
        Search path(Transporter::path, source, seed), light(Transporter::light, source, seed),
            bdpt(Transporter::bdpt, source, seed);
        const std::array searches{&path, &light, &bdpt};
        std::set<PathClass> exist, frequent;
        const auto missed_by = [&](const Search& search) {
            return std::ranges::find_if(frequent, [&](const PathClass& one) {
                return predicate(search.transporter(), one) && !search.found().contains(one);
            });
        };
        for (std::uint32_t paths = 0; paths < most_paths; paths += at_once) {
            run.end_if_stopped();
            for (Search* search : searches) {
                if (paths > 0 && missed_by(*search) == frequent.end()) continue;
                search->go_on(at_once);
                for (const auto& [one, times] : search->found()) {
                    exist.insert(one);
                    if (times * 1000 >= search->paths()) frequent.insert(one);
                }
            }
        }
        std::size_t listed = 0;
        for (int edges = 1; edges <= most_edges; ++edges)
            for (const PathClass& one : path_classes(glass_scene(source), edges)) listed += exist.contains(one);
        if (listed != exist.size())
            return exactly(false, cases, fmt::format("{} classes found, {} of them listed", exist.size(), listed));
        for (const Search* search : searches) {
            const char* const name = name_of(search->transporter());
            if (const auto missed = missed_by(*search); missed != frequent.end())
                return exactly(false, cases, fmt::format("{} by {}: predicted, not made", to_string(*missed), name));
            for (const auto& [one, times] : search->found())
                if (!predicate(search->transporter(), one))
                    return exactly(false, cases, fmt::format("{} by {}: made, not predicted", to_string(one), name));
            cases += exist.size();
        }
    }
    return exactly(true, cases, fmt::format("{} pairs of integrator and class", cases));
}

bool predicted(Transporter transporter, const PathClass& path) {
    return find_integrator(name_of(transporter)).makes.path(path);
}
bool lens_sees_mirrors(Transporter transporter, const PathClass& path) {
    return transporter == Transporter::light ? path.source != Source::point || !path.mirrors.empty()
                                             : predicted(transporter, path);
}
bool no_caustics_of_points(Transporter transporter, const PathClass& path) {
    return predicted(transporter == Transporter::bdpt ? Transporter::path : transporter, path);
}

}  // namespace

void add_transport_classes(Catalogue& catalogue) {
    catalogue.add({.id = "render/path-classes/predicate",
                   .statement =
                       "`path`, `light` and `bdpt` make the classes of paths that the predicate says, of those "
                       "in 0.1 % of paths; the search misses one that is made with a risk of about e^-60.",
                   .source = "ours, integrators/references/path_classes.h",
                   .kind = Kind::exact,
                   .trial = {classes_are,
                             predicted,
                             {{"lens-sees-mirrors", "`light` connects mirrors to the lens.", lens_sees_mirrors},
                              {"no-caustics-of-points", "`bdpt` makes no more than `path`.", no_caustics_of_points}}}});
}

}  // namespace plumb::suites

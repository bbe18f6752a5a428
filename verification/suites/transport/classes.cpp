// Which classes of paths every integrator makes, against the predicate that says so: by what they find in scenes of
// pure materials.

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
/// Of an integrator, by name.
using Predicate = bool (*)(const std::string& integrator, const PathClass&);

constexpr int most_edges = 4;

PathClass class_of(std::span<const PathVertex> vertices, Source source) {
    PathClass path{{}, source};
    for (const PathVertex& vertex : vertices) path.mirrors.push_back(!vertex.bsdf.smooth());
    return path;
}

// Finds classes of paths in a scene of pure materials: of the splats that an integrator makes, and of the strategies of
// `bdpt`.
class Search {
public:
    Search(const NamedIntegrator& named, Source source, std::uint64_t seed)
        : named_(named), source_(source), seed_(seed), estimator_(make_integrator(named.id, limits_of(named))) {
        if (named.id != "bdpt") return;
        auto bdpt = std::make_unique<Bdpt>(limits_of(named));
        bdpt->weight = [this](const PathChain& chain, int) {
            PathClass path{{}, source_};
            for (int i = 1; i < chain.edges(); ++i)
                path.mirrors.push_back(!chain.vertices[static_cast<std::size_t>(i)]->surface->bsdf.smooth());
            ++found_[path];
            return 1.0;
        };
        estimator_ = std::move(bdpt);
    }
    Search(const Search&) = delete;
    Search& operator=(const Search&) = delete;

    void go_on(std::uint32_t paths) {
        const Scene& scene = glass_scene(source_);
        for (const std::uint32_t end = next_ + paths; next_ < end; ++next_) {
            numbers_.start({seed_, 0, next_});
            estimator_->trace(scene, whole_film(scene), numbers_, record_);
            if (named_.id == "bdpt") continue;
            for (const Splat& splat : record_.splats) {
                if (is_black(splat.value)) continue;
                const auto between = static_cast<std::size_t>(splat.edges - 1);
                const auto& vertices = splat.anywhere ? record_.light_vertices : record_.vertices;
                PathClass one = class_of({vertices.data(), between}, source_);
                if (splat.anywhere) std::reverse(one.mirrors.begin(), one.mirrors.end());
                ++found_[one];
            }
        }
    }
    [[nodiscard]] const std::string& name() const { return named_.id; }
    [[nodiscard]] const Classes& found() const { return found_; }
    [[nodiscard]] std::uint32_t paths() const { return next_; }

private:
    static PathLimits limits_of(const NamedIntegrator& named) {
        return {.max_edges = named.makes.longest.value_or(most_edges), .roulette_edges = most_edges};
    }

    const NamedIntegrator& named_;
    Source source_;
    std::uint64_t seed_;
    std::uint32_t next_ = 0;
    std::unique_ptr<PathEstimator> estimator_;
    IndependentSamples numbers_;
    PathRecord record_;
    Classes found_;
};

// A class that one integrator makes in one of 1,000 paths must be made by each integrator of which the predicate says
// so, and by no other. An integrator that has not found a class yet looks on: of the classes that are so frequent, any
// other integrator makes the rarest in 3 of 10,000 paths, so that `most_paths` miss it with a probability of e^-60.
Verdict classes_are(Predicate predicate, const Run& run) {
    constexpr std::uint32_t most_paths = 200'000;
    const auto at_once = run.pick(10'000u, 100'000u);
    std::uint64_t cases = 0;
    for (const Source source : {Source::surface, Source::point, Source::environment}) {
        const std::uint64_t seed = run.random(static_cast<std::uint64_t>(source)).bits();
        std::vector<std::unique_ptr<Search>> searches;
        for (const NamedIntegrator& named : integrators())
            if (named.makes.path) searches.push_back(std::make_unique<Search>(named, source, seed));
        std::set<PathClass> exist, frequent;
        const auto missed_by = [&](const Search& search) {
            return std::ranges::find_if(frequent, [&](const PathClass& one) {
                return predicate(search.name(), one) && !search.found().contains(one);
            });
        };
        for (std::uint32_t paths = 0; paths < most_paths; paths += at_once) {
            run.end_if_stopped();
            for (const auto& search : searches) {
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
        for (const auto& search : searches) {
            const std::string& name = search->name();
            if (const auto missed = missed_by(*search); missed != frequent.end())
                return exactly(false, cases, fmt::format("{} by {}: predicted, not made", to_string(*missed), name));
            for (const auto& [one, times] : search->found())
                if (!predicate(name, one))
                    return exactly(false, cases, fmt::format("{} by {}: made, not predicted", to_string(one), name));
            cases += exist.size();
        }
    }
    return exactly(true, cases, fmt::format("{} pairs of integrator and class", cases));
}

bool predicted(const std::string& integrator, const PathClass& path) {
    return find_integrator(integrator).makes.path(path);
}
bool lens_sees_mirrors(const std::string& integrator, const PathClass& path) {
    return integrator == "light" ? path.source != Source::point || !path.mirrors.empty() : predicted(integrator, path);
}
bool no_caustics_of_points(const std::string& integrator, const PathClass& path) {
    return predicted(integrator == "bdpt" ? "path" : integrator, path);
}
bool directions_meet_points(const std::string& integrator, const PathClass& path) {
    return predicted(integrator == "direct-bsdf" ? "direct" : integrator, path);
}
bool mirrors_lit_by_samples(const std::string& integrator, const PathClass& path) {
    return predicted(integrator == "direct-emitters" ? "direct" : integrator, path);
}
bool direct_goes_on(const std::string& integrator, const PathClass& path) {
    return predicted(integrator == "direct" ? "path" : integrator, path);
}
bool direct_sees_no_lights(const std::string& integrator, const PathClass& path) {
    return predicted(integrator, path) && (integrator != "direct-emitters" || path.edges() > 1);
}

}  // namespace

void add_transport_classes(Catalogue& catalogue) {
    catalogue.add(
        {.id = "render/path-classes/predicate",
         .statement = "Each integrator makes the classes of paths that it says it makes, and no other, of those "
                      "in 0.1 % of paths; the search misses one that is made with a risk of about e^-60.",
         .source = "ours, integrators/references/path_classes.h",
         .kind = Kind::exact,
         .trial = {classes_are,
                   predicted,
                   {{"lens-sees-mirrors", "`light` connects mirrors to the lens.", lens_sees_mirrors},
                    {"no-caustics-of-points", "`bdpt` makes no more than `path`.", no_caustics_of_points},
                    {"directions-meet-points", "`direct-bsdf` makes what `direct` makes.", directions_meet_points},
                    {"mirrors-lit", "`direct-emitters` makes what `direct` makes.", mirrors_lit_by_samples},
                    {"direct-goes-on", "`direct` makes what `path` makes.", direct_goes_on},
                    {"lights-unseen", "`direct-emitters` sees no light directly.", direct_sees_no_lights}}}});
}

}  // namespace plumb::suites

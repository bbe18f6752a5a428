// What the loader knows, a shipped scene uses and a claim checks. Whoever adds a feature adds both.

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "scenes/mitsuba/plugins.h"
#include "scenes/mitsuba/xml_tree.h"
#include "scenes/shipped/shipped.h"
#include "verification/suites/suites.h"

namespace plumb::suites {
namespace {

using KindAndName = std::pair<std::string, std::string>;

/// For each feature a claim that fails without it.
const std::map<KindAndName, std::string>& claims_of_features() {
    static const std::map<KindAndName, std::string> table{
        {{"bsdf", "conductor"}, "bsdf/conductor/energy"},
        {{"bsdf", "dielectric"}, "bsdf/dielectric/eta-squared"},
        {{"bsdf", "diffuse"}, "bsdf/diffuse/sample"},
        {{"bsdf", "mask"}, "bsdf/mask/transmittance"},
        {{"bsdf", "plastic"}, "bsdf/plastic/sample"},
        {{"bsdf", "roughconductor"}, "bsdf/roughconductor-ggx/sample"},
        {{"bsdf", "roughdielectric"}, "bsdf/roughdielectric-ggx/sample"},
        {{"bsdf", "roughplastic"}, "bsdf/roughplastic-ggx/sample"},
        {{"bsdf", "twosided"}, "bsdf/twosided/sample"},
        {{"emitter", "area"}, "light/rectangle/irradiance"},
        {{"emitter", "constant"}, "light/constant/flux"},
        {{"emitter", "envmap"}, "light/environment-map/distribution"},
        {{"emitter", "point"}, "light/point/flux"},
        {{"film", "hdrfilm"}, "film/variance/replicates"},
        {{"rfilter", "box"}, "film/filter-box/density"},
        {{"rfilter", "gaussian"}, "film/filter-gaussian/density"},
        {{"rfilter", "tent"}, "film/filter-tent/density"},
        {{"sensor", "perspective"}, "camera/perspective/jacobian"},
        {{"sensor", "thinlens"}, "camera/thin-lens/circle-of-confusion"},
        {{"shape", "cube"}, "mesh/box/closed"},
        {{"shape", "disk"}, "light/disk/irradiance"},
        {{"shape", "obj"}, "mesh/tetrahedron/closed"},
        {{"shape", "ply"}, "mesh/tessellated-sphere/closed"},
        {{"shape", "rectangle"}, "mesh/plates/gap"},
        {{"shape", "sphere"}, "mesh/sphere/closed"},
        {{"texture", "bitmap"}, "texture/bitmap/lookup"},
        {{"texture", "checkerboard"}, "texture/checkerboard/lookup"},
    };
    return table;
}

// What the scene's elements ask for, and the words that choose within a plugin.
void add_features(const XmlElement& element, std::set<KindAndName>& used) {
    if (element.has("type")) used.insert({element.tag, element.attribute("type")});
    if (element.tag == "string") used.insert({element.attribute("name"), element.attribute("value")});
    for (const XmlElement& child : element.children) add_features(child, used);
}

std::set<KindAndName> features_of_shipped_scenes() {
    std::set<KindAndName> used;
    for (const ShippedScene& scene : shipped_scenes()) add_features(read_xml_tree(scene.file, {}), used);
    return used;
}

TEST(Features, EachIsCheckedByAClaim) {
    const Catalogue catalogue = shipped_catalogue();
    std::set<std::string> ids;
    for (const Claim& claim : catalogue.claims()) ids.insert(claim.id);
    for (const Plugin& plugin : known_plugins()) {
        const auto found = claims_of_features().find({plugin.kind, plugin.name});
        if (found == claims_of_features().end())
            ADD_FAILURE() << plugin.kind << " '" << plugin.name << "' has no row in this file's table";
        else
            EXPECT_TRUE(ids.contains(found->second))
                << plugin.kind << " '" << plugin.name << "': there is no claim " << found->second;
    }
}

TEST(Features, EachIsUsedByAShippedScene) {
    const std::set<KindAndName> used = features_of_shipped_scenes();
    for (const Plugin& plugin : known_plugins())
        EXPECT_TRUE(used.contains({plugin.kind, plugin.name})) << plugin.kind << " '" << plugin.name << "'";
    for (const char* distribution : {"beckmann", "ggx"})
        EXPECT_TRUE(used.contains({"distribution", distribution})) << distribution;
}

TEST(Features, TheTableKnowsNoOthers) {
    std::set<KindAndName> known;
    for (const Plugin& plugin : known_plugins()) known.insert({plugin.kind, plugin.name});
    for (const auto& [feature, claim] : claims_of_features())
        EXPECT_TRUE(known.contains(feature)) << feature.first << " '" << feature.second << "'";
}

}  // namespace
}  // namespace plumb::suites

// What the loader knows, a shipped scene uses and a claim checks. Whoever adds a feature adds both.

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "scenes/mitsuba/plugins.h"
#include "scenes/mitsuba/xml_tree.h"
#include "scenes/shipped/shipped.h"
#include "verification/suites/suites.h"

namespace plumb::suites {
namespace {

using KindAndName = std::pair<std::string, std::string>;

/// What the ids of the claims of a kind begin with: "bsdf/" + "diffuse" + "/sample".
const std::map<std::string, std::string>& claims_of_kinds() {
    static const std::map<std::string, std::string> table{
        {"bsdf", "bsdf/"},     {"emitter", "light/"}, {"film", "film/"},      {"rfilter", "film/filter-"},
        {"sensor", "camera/"}, {"shape", "mesh/"},    {"texture", "texture/"}};
    return table;
}

/// The claims of features that claims know by another name.
const std::map<KindAndName, std::string>& claims_by_other_names() {
    static const std::map<KindAndName, std::string> table{
        {{"emitter", "area"}, "light/rectangle/"}, {{"emitter", "envmap"}, "light/environment-map/"},
        {{"film", "hdrfilm"}, "film/variance/"},   {{"sensor", "thinlens"}, "camera/thin-lens/"},
        {{"shape", "cube"}, "mesh/box/"},          {{"shape", "disk"}, "light/disk/"},
        {{"shape", "obj"}, "mesh/tetrahedron/"},   {{"shape", "ply"}, "mesh/tessellated-sphere/"},
        {{"shape", "rectangle"}, "mesh/plates/"},
    };
    return table;
}

/// Whether the claim fails without the feature: it is called after it, or after a variety of it ("roughplastic-ggx").
bool checks(const Claim& claim, const Plugin& plugin) {
    const auto found = claims_by_other_names().find({plugin.kind, plugin.name});
    if (found != claims_by_other_names().end()) return claim.id.starts_with(found->second);
    const std::string name = claims_of_kinds().at(plugin.kind) + plugin.name;
    return claim.id.starts_with(name + "/") || claim.id.starts_with(name + "-");
}

// What the scene's elements ask for, and the words that choose within a plugin.
void add_features(const XmlElement& element, std::set<KindAndName>& used) {
    if (element.has("type")) used.insert({element.tag, element.attribute("type")});
    if (element.tag == "string") used.insert({element.attribute("name"), element.attribute("value")});
    for (const XmlElement& child : element.children) add_features(child, used);
}

std::set<KindAndName> features_of_shipped_scenes() {
    std::set<KindAndName> used;
    for (const ShippedScene& scene : shipped_scenes()) add_features(read_xml_tree(scene.file, {}).root, used);
    return used;
}

TEST(Features, EachIsCheckedByAClaim) {
    const Catalogue catalogue = shipped_catalogue();
    for (const Plugin& plugin : known_plugins())
        EXPECT_TRUE(std::ranges::any_of(catalogue.claims(), [&](const Claim& claim) { return checks(claim, plugin); }))
            << plugin.kind << " '" << plugin.name << "': no claim is called " << claims_of_kinds().at(plugin.kind)
            << plugin.name;
}

TEST(Features, EachIsUsedByAShippedScene) {
    const std::set<KindAndName> used = features_of_shipped_scenes();
    for (const Plugin& plugin : known_plugins())
        EXPECT_TRUE(used.contains({plugin.kind, plugin.name})) << plugin.kind << " '" << plugin.name << "'";
    for (const char* distribution : {"beckmann", "ggx"})
        EXPECT_TRUE(used.contains({"distribution", distribution})) << distribution;
}

TEST(Features, OtherNamesAreOfNoOthers) {
    std::set<KindAndName> known;
    for (const Plugin& plugin : known_plugins()) known.insert({plugin.kind, plugin.name});
    for (const auto& [feature, claim] : claims_by_other_names())
        EXPECT_TRUE(known.contains(feature)) << feature.first << " '" << feature.second << "'";
}

}  // namespace
}  // namespace plumb::suites

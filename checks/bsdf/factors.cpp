#include "checks/bsdf/factors.h"

#include <cmath>

namespace plumb::checks {
namespace {

double cos_i(Vec3, Vec3 wi) {
    return std::abs(wi.z);
}
double cos_o(Vec3 wo, Vec3) {
    return std::abs(wo.z);
}
double jacobian_of_half(Vec3 wo, Vec3 wi) {
    return 4 * dot(wo, normalize(wo + wi));
}
double cos_h(Vec3 wo, Vec3 wi) {
    return std::abs(normalize(wo + wi).z);
}

using Function = double (*)(Vec3, Vec3);

// The factor and its inverse.
void add_both(std::vector<Factor>& all, const std::string& name, Function of) {
    all.push_back({name, of});
    all.push_back(
        {name.starts_with('|') ? "1/" + name : "1/(" + name + ")", [of](Vec3 wo, Vec3 wi) { return 1 / of(wo, wi); }});
}

}  // namespace

std::vector<Factor> factors_of_densities() {
    std::vector<Factor> all;
    add_both(all, "4 (wo·h)", jacobian_of_half);
    add_both(all, "|wi.z|", cos_i);
    add_both(all, "|h.z|", cos_h);
    add_both(all, "|wo.z|", cos_o);
    add_both(all, "4 (wo·h)/|h.z|", [](Vec3 wo, Vec3 wi) { return jacobian_of_half(wo, wi) / cos_h(wo, wi); });
    add_both(all, "(wo·h)", [](Vec3 wo, Vec3 wi) { return jacobian_of_half(wo, wi) / 4; });
    add_both(all, "sin θi", [](Vec3, Vec3 wi) { return std::hypot(wi.x, wi.y); });
    return all;
}

std::vector<Factor> factors_of_values() {
    std::vector<Factor> all;
    add_both(all, "|wi.z|", cos_i);
    add_both(all, "|wo.z|", cos_o);
    add_both(all, "|wi.z| |wo.z|", [](Vec3 wo, Vec3 wi) { return cos_i(wo, wi) * cos_o(wo, wi); });
    add_both(all, "4 (wo·h)", jacobian_of_half);
    return all;
}

std::vector<Factor> factors_of_reciprocity() {
    const auto ratio = [](double power) {
        return [power](Vec3 wo, Vec3 wi) { return std::pow(cos_o(wo, wi) / cos_i(wo, wi), power); };
    };
    return {{"|wi.z|", ratio(1)}, {"1/|wi.z|", ratio(-1)}, {"|wi.z|²", ratio(2)}};
}

}  // namespace plumb::checks

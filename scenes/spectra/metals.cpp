#include "scenes/spectra/metals.h"

#include <map>

#include "core/named.h"

namespace plumb {

namespace {

/// A value by its name.
template <class Value>
using Table = std::map<std::string, Value>;

const Table<ComplexIndex>& metals() {
    const auto rgb = Spectrum::rgb;
    static const Table<ComplexIndex> table{
        {"Ag", {rgb(0.1552646489, 0.1167232965, 0.1383806959), rgb(4.8283433224, 3.1222459278, 2.1469504455)}},
        {"Al", {rgb(1.6574599595, 0.8803689579, 0.5212287346), rgb(9.2238691996, 6.2695232477, 4.8370012281)}},
        {"Au", {rgb(0.1431189557, 0.3749570432, 1.4424785571), rgb(3.9831604247, 2.3857207478, 1.6032152899)}},
        {"Be", {rgb(4.1850592788, 3.1850604423, 2.7840913457), rgb(3.8354398268, 3.0101260162, 2.8690088743)}},
        {"Cr", {rgb(4.3696828663, 2.9167024892, 1.6547005413), rgb(5.2064337956, 4.2313645277, 3.7549467933)}},
        {"Cu", {rgb(0.2004376970, 0.9240334304, 1.1022119527), rgb(3.9129485033, 2.4528477015, 2.1421879552)}},
        {"Hg", {rgb(2.3989314904, 1.4400254917, 0.9095512090), rgb(6.3276269444, 4.3719414152, 3.4217899270)}},
        {"Ir", {rgb(3.0864098394, 2.0821938440, 1.6178866805), rgb(5.5921510077, 4.0671757150, 3.2672611269)}},
    };
    return table;
}

template <class Value>
const Value& lookup(const Table<Value>& table, std::string_view what, const std::string& name) {
    return find_named(table, name, what, &Table<Value>::value_type::first).second;
}

}  // namespace

ComplexIndex metal(const std::string& name) {
    return lookup(metals(), "metal", name);
}

std::vector<std::string> metal_names() {
    std::vector<std::string> names;
    for (const auto& [name, index] : metals()) names.push_back(name);
    return names;
}

double named_index(const std::string& name) {
    static const Table<double> table{{"acetone", 1.36},
                                     {"acrylic glass", 1.49},
                                     {"air", 1.000277},
                                     {"amber", 1.55},
                                     {"benzene", 1.501},
                                     {"bk7", 1.5046},
                                     {"bromine", 1.661},
                                     {"carbon dioxide", 1.00045},
                                     {"carbon tetrachloride", 1.461},
                                     {"diamond", 2.419},
                                     {"ethanol", 1.361},
                                     {"fused quartz", 1.458},
                                     {"glycerol", 1.4729},
                                     {"helium", 1.000036},
                                     {"hydrogen", 1.000132},
                                     {"pet", 1.575},
                                     {"polypropylene", 1.49},
                                     {"pyrex", 1.47},
                                     {"silicone oil", 1.52045},
                                     {"sodium chloride", 1.544},
                                     {"vacuum", 1.0},
                                     {"water", 1.333},
                                     {"water ice", 1.31}};
    return lookup(table, "medium", name);
}

}  // namespace plumb

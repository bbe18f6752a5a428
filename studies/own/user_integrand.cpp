#include "studies/own/user_integrand.h"

#include <filesystem>

#include "analytic/any_integrand.h"
#include "analytic/expression.h"
#include "analytic/image_function.h"
#include "core/box.h"
#include "core/error.h"

namespace plumb::own {
namespace {

template <int D>
Box<D> box_of(const std::vector<double>& domain) {
    Box<D> box;
    if (domain.empty()) return box;
    if (domain.size() != 2 * D)
        throw Error(fmt::format("--domain has {} numbers; accepted in {}D are {}", domain.size(), D,
                                D == 1 ? "x0,x1" : "x0,x1,y0,y1"));
    for (int axis = 0; axis < D; ++axis) {
        box.low[axis] = domain[2 * axis];
        box.high[axis] = domain[2 * axis + 1];
    }
    return box;
}

template <int D>
std::string readable_place(const Point<D>& p) {
    if constexpr (D == 1)
        return fmt::format("x = {}", p[0]);
    else
        return fmt::format("x = {}, y = {}", p[0], p[1]);
}

template <int D, class F>
Function<D> finite_on(const Box<D>& box, const F& f, const std::string& name) {
    return [box, volume = box.volume(), f, name](const Point<D>& u) {
        const Point<D> x = box.from_unit(u);
        const double value = f(x);
        if (!std::isfinite(value))
            throw Error(fmt::format("{} is {} at {}; finite values are accepted", name, value, readable_place<D>(x)));
        return volume * value;
    };
}

// ".exr", ".png": no formula ends like that, since a letter follows the last dot.
bool ends_like_a_file(std::string_view what) {
    const std::string_view extension = what.substr(std::min(what.rfind('.'), what.size() - 1) + 1);
    const auto letter = [](unsigned char c) { return std::isalpha(c) != 0; };
    return !extension.empty() && letter(extension.front()) &&
           std::ranges::all_of(extension, [](unsigned char c) { return std::isalnum(c) != 0; });
}

void refuse(bool given, const char* option, const std::string& why) {
    if (given) throw Error(fmt::format("{} {}", option, why));
}

template <int D>
UserIntegrands formula(const Expression& expression, const std::vector<double>& domain) {
    return std::vector<UserIntegrand<D>>{
        {expression.text(), finite_on<D>(box_of<D>(domain), expression, expression.text()), {}}};
}

UserIntegrands read_formula(const IntegralTask& task) {
    const Expression expression(task.what.front());
    const bool two = expression.uses_y() || task.domain.size() == 4;
    return two ? formula<2>(expression, task.domain) : formula<1>(expression, task.domain);
}

template <int D>
UserIntegrands shipped(const Integrand<D>& f) {
    return std::vector<UserIntegrand<D>>{{f.id, finite_on<D>({}, f.value, f.id), f.integral_value(), &f}};
}

UserIntegrands read_shipped(const IntegralTask& task) {
    refuse(!task.domain.empty(), "--domain", "does not go with a shipped integrand: its domain is [0,1]");
    const std::string_view id = std::string_view(task.what.front()).substr(1);
    return std::visit([](const auto* f) { return shipped(*f); }, find_any_integrand(id));
}

UserIntegrands read_image_channels(const IntegralTask& task) {
    refuse(!task.domain.empty(), "--domain", "does not go with an image: it is a function on [0,1]²");
    const std::string& file = task.what.front();
    const auto image = std::make_shared<const Image>(read_image(file));
    require_finite(*image, file);
    const ImageLookup lookup = task.lookup == "bilinear" ? ImageLookup::bilinear : ImageLookup::nearest;
    std::vector<UserIntegrand<2>> channels;
    for (const std::string& channel : task.channel ? std::vector<std::string>{*task.channel} : channel_names(*image)) {
        const ImageFunction f(image, channel_weights(*image, channel), lookup);
        channels.push_back({fmt::format("{} {}", file, channel), f, f.integral()});
    }
    return channels;
}

}  // namespace

InputKind kind_of(const std::string& what) {
    if (what == "-") return InputKind::samples;
    if (what.starts_with('@')) return InputKind::shipped;
    for (const char* ending : {".csv", ".CSV", ".tsv", ".txt", ".dat"})
        if (what.ends_with(ending)) return InputKind::samples;
    std::error_code ignored;  // a formula may be too long for a name
    return ends_like_a_file(what) || std::filesystem::exists(what, ignored) ? InputKind::image : InputKind::formula;
}

UserIntegrands read_integrands(const IntegralTask& task) {
    refuse(task.what.size() > 1, "more than one integrand found:", "only files of samples come in several");
    refuse(task.batches.has_value(), "--batches", "goes with a file of samples only");
    const InputKind kind = kind_of(task.what.front());
    if (kind == InputKind::image) return read_image_channels(task);
    refuse(task.channel.has_value(), "--channel", "goes with an image only");
    refuse(task.lookup.has_value(), "--lookup", "goes with an image only");
    return kind == InputKind::shipped ? read_shipped(task) : read_formula(task);
}

template <int D>
std::vector<Point<D>> places_of(const NumberTable& table, const std::vector<double>& domain) {
    const Box<D> box = box_of<D>(domain);
    std::vector<Point<D>> places(table.rows());
    for (std::size_t row = 0; row < table.rows(); ++row)
        for (int axis = 0; axis < D; ++axis) {
            const double x = table.at(row, axis);
            if (!box.contains(x, axis))
                throw Error(fmt::format("{}: {} is outside the domain; accepted are {} to {} (see --domain)",
                                        table.where(row, axis), x, box.low[axis], box.high[axis]));
            places[row][axis] = box.to_unit(x, axis);
        }
    return places;
}
template std::vector<Point<1>> places_of<1>(const NumberTable&, const std::vector<double>&);
template std::vector<Point<2>> places_of<2>(const NumberTable&, const std::vector<double>&);

template <int D>
SampleSet<D> samples_of(const NumberTable& table, const std::vector<double>& domain) {
    SampleSet<D> set{places_of<D>(table, domain), std::vector<double>(table.rows())};
    const double volume = box_of<D>(domain).volume();
    for (std::size_t row = 0; row < table.rows(); ++row) set.values[row] = volume * table.at(row, D);
    return set;
}
template SampleSet<1> samples_of<1>(const NumberTable&, const std::vector<double>&);
template SampleSet<2> samples_of<2>(const NumberTable&, const std::vector<double>&);

}  // namespace plumb::own

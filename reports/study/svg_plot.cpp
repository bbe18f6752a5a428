#include "reports/study/svg_plot.h"

#include <iterator>

#include "reports/page/series_styles.h"
#include "reports/study/log_axis.h"
#include "reports/text/text.h"
#include "reports/text/xml.h"

namespace plumb::reports {
namespace {

const std::string& colour_of(const SvgLine& line) {
    const auto& colours = series_styles().light;
    return colours[line.style % colours.size()];
}

const std::string& symbol_of(const SvgLine& line) {
    const auto& symbols = series_styles().symbols;
    return symbols[line.style % symbols.size()].path;
}

constexpr double left = 66, top = 58, width = 470, height = 340, right = left + width, bottom = top + height;

bool drawable(const SvgPoint& p) {
    return p.x > 0 && p.y > 0 && std::isfinite(p.x) && std::isfinite(p.y);
}

/// The points that logarithmic axes can show, their bands brought into reach.
std::vector<SvgPoint> shown(const SvgLine& line) {
    std::vector<SvgPoint> points;
    for (SvgPoint p : line.points) {
        if (!drawable(p)) continue;
        if (!(p.low > 0)) p.low = p.y / 10;
        if (!std::isfinite(p.high)) p.high = p.y * 10;
        points.push_back(p);
    }
    return points;
}

class Drawing {
public:
    template <class... Values>
    void put(fmt::format_string<Values...> format, Values&&... values) {
        fmt::format_to(std::back_inserter(text_), format, std::forward<Values>(values)...);
        text_ += '\n';
    }
    [[nodiscard]] const std::string& text() const { return text_; }

private:
    std::string text_;
};

void draw_frame(Drawing& svg, const SvgPlot& plot, const LogAxis& x, const LogAxis& y) {
    svg.put("<g stroke='#e3e3de' fill='#5a626b' font-size='11'>");
    for (const Tick& tick : ticks(x, plot.powers_of_two, 8)) {
        svg.put("<path d='M{0:.1f},{1}V{2}'/><text x='{0:.1f}' y='{3}' text-anchor='middle' stroke='none'>{4}</text>",
                x(tick.at), top, bottom, bottom + 17, tick.text);
    }
    for (const Tick& tick : ticks(y, false, 8)) {
        svg.put("<path d='M{0},{1:.1f}H{2}'/><text x='{3}' y='{4:.1f}' text-anchor='end' stroke='none'>{5}</text>",
                left, y(tick.at), right, left - 8, y(tick.at) + 4, tick.text);
    }
    svg.put("</g>");
    svg.put("<text x='{}' y='24' font-size='15' font-weight='600'>{}</text>", left, escaped(plot.title));
    svg.put("<text x='{}' y='43' fill='#5a626b'>{}</text>", left, escaped(plot.subtitle));
    svg.put("<text x='{}' y='{}' text-anchor='middle'>{}</text>", left + width / 2, bottom + 38, escaped(plot.x_label));
    svg.put("<text transform='translate(18,{}) rotate(-90)' text-anchor='middle'>{}</text>", top + height / 2,
            escaped(plot.y_label));
}

std::string signed_number(double x) {
    return (x < 0 ? "−" : "") + fmt::format("{:.3g}", std::abs(x));
}

/// Each guide runs from the highest of the first points to the frame's right or lower edge.
void draw_guides(Drawing& svg, const SvgPlot& plot, const LogAxis& x, const LogAxis& y) {
    double first = std::numeric_limits<double>::infinity(), start = 0;
    for (const SvgLine& line : plot.lines)
        if (const auto points = shown(line); !points.empty()) {
            first = std::min(first, points.front().x);
            start = std::max(start, points.front().y);
        }
    if (start == 0) return;
    svg.put("<g stroke='#8a8f94' stroke-dasharray='5 4' fill='#5a626b' font-size='11'>");
    for (const double slope : plot.slopes) {
        const double width_left = x.high - std::log(first), depth = y.low - std::log(start);
        const double run = slope < 0 ? std::min(width_left, depth / slope) : width_left;
        const double x_end = x(first * std::exp(run)), y_end = y(start * std::exp(slope * run));
        svg.put("<path d='M{:.1f},{:.1f}L{:.1f},{:.1f}'/>", x(first), y(start), x_end, y_end);
        svg.put("<text x='{:.1f}' y='{:.1f}' stroke='none'>{}</text>", x_end + 4, std::min(y_end, bottom - 6) + 4,
                signed_number(slope));
    }
    svg.put("</g>");
}

void draw_line(Drawing& svg, const SvgLine& line, const LogAxis& x, const LogAxis& y) {
    const std::vector<SvgPoint> points = shown(line);
    const std::string& colour = colour_of(line);
    std::string upper, lower, path;
    for (const SvgPoint& p : points) {
        fmt::format_to(std::back_inserter(upper), "{:.1f},{:.1f} ", x(p.x), y(p.high));
        lower = fmt::format("{:.1f},{:.1f} ", x(p.x), y(p.low)) + lower;
        fmt::format_to(std::back_inserter(path), "{:.1f},{:.1f} ", x(p.x), y(p.y));
    }
    svg.put("<polygon points='{}{}' fill='{}' fill-opacity='0.16'/>", upper, lower, colour);
    svg.put("<polyline points='{}' fill='none' stroke='{}' stroke-width='1.75'/>", path, colour);
    for (const SvgPoint& p : line.points)
        if (drawable(p) && !(p.low > 0))
            svg.put("<text x='{:.1f}' y='{:.1f}' fill='{}' text-anchor='middle'>▽</text>", x(p.x), y(p.y / 10) + 4,
                    colour);
    for (const SvgPoint& p : points)
        svg.put("<path transform='translate({:.1f},{:.1f})' d='{}' fill='#fff' stroke='{}' stroke-width='1.5'/>",
                x(p.x), y(p.y), symbol_of(line), colour);
}

void draw_legend(Drawing& svg, const SvgPlot& plot) {
    double at = top + 8;
    for (const SvgLine& line : plot.lines) {
        const std::string& colour = colour_of(line);
        svg.put("<g transform='translate({},{})'><path d='M0,0H30' stroke='{}' stroke-width='1.75'/>", right + 34, at,
                colour);
        svg.put("<path transform='translate(15,0)' d='{}' fill='#fff' stroke='{}' stroke-width='1.5'/>",
                symbol_of(line), colour);
        svg.put("<text x='38' y='4'>{}</text></g>", escaped(line.name));
        at += 21;
    }
}

double legend_width(const SvgPlot& plot) {
    std::size_t longest = 0;
    for (const SvgLine& line : plot.lines) longest = std::max(longest, columns_of(line.name));
    return 84 + 6.6 * static_cast<double>(longest);
}

}  // namespace

std::string to_svg(const SvgPlot& plot) {
    std::vector<double> xs, ys;
    for (const SvgLine& line : plot.lines)
        for (const SvgPoint& p : shown(line)) {
            xs.push_back(p.x);
            ys.insert(ys.end(), {p.low, p.y, p.high});
        }
    const LogAxis x = axis_over(xs, left, right), y = axis_over(ys, bottom, top);
    const double full_width = right + legend_width(plot);
    const double full_height = std::max(bottom + 54, top + 21 * static_cast<double>(plot.lines.size()) + 20);

    Drawing svg;
    svg.put(
        "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 {0:.0f} {1:.0f}' width='{0:.0f}' height='{1:.0f}'"
        " font-family='Source Sans 3,Segoe UI,Roboto,Helvetica Neue,DejaVu Sans,sans-serif'"
        " font-size='12.5' fill='#1c2024' role='img'>",
        full_width, full_height);
    svg.put("<title>{}</title>", escaped(plot.title + (plot.subtitle.empty() ? "" : ": " + plot.subtitle)));
    svg.put("<rect width='100%' height='100%' fill='#fff'/>");
    draw_frame(svg, plot, x, y);
    draw_guides(svg, plot, x, y);
    for (const SvgLine& line : plot.lines) draw_line(svg, line, x, y);
    draw_legend(svg, plot);
    svg.put("</svg>");
    return svg.text();
}

}  // namespace plumb::reports

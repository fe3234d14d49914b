// Colours are written twice: as attributes for a light page, which every viewer supports, and in a style
// sheet that replaces them on a dark screen. The series have the colours of Okabe and Ito, which colour-blind
// readers can tell apart; the marks differ in shape as well.
#include "tools/plot/svg.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/text.h"
#include "tools/plot/markup.h"

namespace thaum::plot {
namespace {

constexpr double letter_px = 6.6;  ///< estimated width of a letter in the labels, rather too large (px)
constexpr double line_px = 15;
constexpr double legend_line_px = 20;
constexpr double mark_px = 5;

constexpr std::string_view ink = "#1b1b1f", faint = "#d8d8de", paper = "#ffffff", muted = "#5c5c66";

struct SeriesColour {
    std::string_view light, dark;
};
constexpr std::array<SeriesColour, max_series> series_colours{{{"#0072b2", "#56b4e9"},
                                                               {"#b34a00", "#ff9a4d"},
                                                               {"#00795a", "#2ed0a2"},
                                                               {"#a8467f", "#f09fce"},
                                                               {"#7a5d00", "#e6c229"},
                                                               {"#4b4ba8", "#a9a9ff"}}};

struct Rect {
    double x, y, width, height;
};

bool overlap(const Rect& a, const Rect& b) {
    return a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;
}

bool inside(const Rect& a, const Rect& frame) {
    return a.x >= frame.x && a.y >= frame.y && a.x + a.width <= frame.x + frame.width &&
           a.y + a.height <= frame.y + frame.height;
}

std::string dark_style() {
    std::string out =
        "<style>@media (prefers-color-scheme: dark){"
        ".t-paper{fill:#17171b}.t-ink{fill:#ececf1}.t-muted{fill:#a9a9b4}.t-grid{stroke:#3a3a42}"
        ".t-line{stroke:#ececf1}";
    for (std::size_t i = 0; i < max_series; ++i) {
        append_text(out, text(".t-fill-", i, "{fill:", series_colours[i].dark, "}.t-line-", i,
                              "{stroke:", series_colours[i].dark, "}"));
    }
    return text(out, "}</style>\n");
}

std::string opened(double width, double height, std::string_view title) {
    return text("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 ", px(width), " ", px(height),
                "\" width=\"", px(width), "\" height=\"", px(height),
                "\" role=\"img\" font-family=\"DejaVu Sans, Verdana, sans-serif\" font-size=\"12\">\n<title>",
                escaped(title), "</title>\n", dark_style(),
                "<rect class=\"t-paper\" width=\"100%\" height=\"100%\" fill=\"", paper, "\"/>\n");
}

struct TextStyle {
    std::string_view anchor = "start";
    bool strong = false;
    bool is_muted = false;
};

std::string text_at(double x, double y, std::string_view words, const TextStyle& style = {}) {
    return text("<text class=\"", style.is_muted ? "t-muted" : "t-ink", "\" x=\"", px(x), "\" y=\"", px(y),
                "\" fill=\"", style.is_muted ? muted : ink, "\" text-anchor=\"", style.anchor, "\"",
                style.strong ? " font-weight=\"bold\"" : "", ">", escaped(words), "</text>\n");
}

std::string grid_line(double x1, double y1, double x2, double y2) {
    return text("<line class=\"t-grid\" x1=\"", px(x1), "\" y1=\"", px(y1), "\" x2=\"", px(x2), "\" y2=\"",
                px(y2), "\" stroke=\"", faint, "\"/>\n");
}

std::string outline(const Rect& r) {
    return text("<rect class=\"t-line\" x=\"", px(r.x), "\" y=\"", px(r.y), "\" width=\"", px(r.width),
                "\" height=\"", px(r.height), "\" fill=\"none\" stroke=\"", ink, "\"/>\n");
}

// ---- time against error -----------------------------------------------------------------------------------

constexpr double front_width = 760;
constexpr double plot_height = 330;
constexpr double left = 78, right = 24, title_band = 34, axis_band = 48;

std::size_t legend_letters(const std::string& name) { return std::min<std::size_t>(letters_of(name), 60); }

/// Place of a series' entry in the legend; a line holds as many entries as fit its width.
struct LegendPlace {
    double x;
    std::size_t line;
};

std::vector<LegendPlace> legend_places(const FrontFigure& figure) {
    std::vector<LegendPlace> places;
    double x = left;
    std::size_t line = 0;
    for (const auto& name : figure.series) {
        const double width = 34 + letter_px * static_cast<double>(legend_letters(name));
        if (x > left && x + width > front_width - right) {
            x = left;
            ++line;
        }
        places.push_back({x, line});
        x += width;
    }
    return places;
}

Rect frame_of(const FrontFigure& figure) {
    const double legend = figure.series.size() > 1
                              ? legend_line_px * static_cast<double>(legend_places(figure).back().line + 1)
                              : 0;
    return {left, title_band + legend, front_width - left - right, plot_height};
}

/// The shape of a series' mark, centred on the origin.
std::string form_of(std::size_t series) {
    const std::string d = px(mark_px);
    switch (series % 3) {
        case 0: return text("<circle r=\"", d, "\"");
        case 1:
            return text("<rect x=\"-", d, "\" y=\"-", d, "\" width=\"", px(2 * mark_px), "\" height=\"",
                        px(2 * mark_px), "\"");
        default:
            return text("<path d=\"M0,-", px(1.3 * mark_px), " L", px(1.3 * mark_px), ",", d, " L-",
                        px(1.3 * mark_px), ",", d, " Z\"");
    }
}

/// Mark of a point: filled if it is on the Pareto front, otherwise an outline.
std::string mark(std::size_t series, bool full, double x, double y, std::string_view tooltip) {
    const auto& colour = series_colours.at(series).light;
    const auto filled = text(" class=\"t-fill-", series, " t-line-", series, "\" fill=\"", colour, "\"");
    const auto hollow = text(" class=\"t-line-", series, "\" fill=\"none\"");
    return text("<g transform=\"translate(", px(x), ",", px(y), ")\">", form_of(series),
                full ? filled : hollow, " stroke=\"", colour, "\" stroke-width=\"1.5\">",
                tooltip.empty() ? "" : text("<title>", escaped(tooltip), "</title>"),
                series % 3 == 0   ? "</circle>"
                : series % 3 == 1 ? "</rect>"
                                  : "</path>",
                "</g>\n");
}

std::string legend(const FrontFigure& figure) {
    if (figure.series.size() < 2) return {};
    std::string out;
    const auto places = legend_places(figure);
    for (std::size_t i = 0; i < figure.series.size(); ++i) {
        const double y = title_band + legend_line_px * (static_cast<double>(places[i].line) + 0.4);
        append_text(out, mark(i, true, places[i].x + mark_px, y, ""));
        append_text(out, text_at(places[i].x + 4 * mark_px - 4, y + 4, cut(figure.series[i], 60)));
    }
    return out;
}

std::string front_grid(const FrontAxes& axes, const Rect& frame) {
    const double bottom = frame.y + frame.height;
    std::string out;
    for (const auto& tick : ticks(axes.time)) {
        append_text(out, grid_line(tick.at_px, frame.y, tick.at_px, bottom));
        append_text(out, text_at(tick.at_px, bottom + 17, tick.label, {.anchor = "middle"}));
    }
    for (const auto& tick : ticks(axes.error)) {
        append_text(out, grid_line(frame.x, tick.at_px, frame.x + frame.width, tick.at_px));
        append_text(out, text_at(frame.x - 8, tick.at_px + 4, tick.label, {.anchor = "end"}));
    }
    return out;
}

std::string joined_front(const FrontFigure& figure, const FrontAxes& axes) {
    std::string places;
    for (const auto& p : figure.points) {
        if (!p.front) continue;
        append_text(places, text(places.empty() ? "" : " ", px(axes.time.at(p.time_us)), ",",
                                 px(axes.error.at(p.error))));
    }
    if (places.empty()) return {};
    return text("<polyline class=\"t-line\" points=\"", places, "\" fill=\"none\" stroke=\"", ink,
                "\" stroke-width=\"1.2\" stroke-dasharray=\"5 3\"/>\n");
}

std::string ring(double x, double y) {
    return text("<circle class=\"t-line\" cx=\"", px(x), "\" cy=\"", px(y), "\" r=\"", px(2 * mark_px),
                "\" fill=\"none\" stroke=\"", ink, "\" stroke-width=\"2\"/>\n");
}

std::string label_of(const Point& p) {
    if (!p.is_default) return cut(p.label, 40);
    return p.label.empty() ? "default" : text(cut(p.label, 40), " (default)");
}

/// Places for a label beside a mark at (x, y), best first.
std::array<Rect, 6> places_beside(double x, double y, double width) {
    const double gap = 2 * mark_px + 2;
    return {{{x + gap, y - line_px, width, line_px},
             {x + gap, y + 2, width, line_px},
             {x - gap - width, y - line_px, width, line_px},
             {x - gap - width, y + 2, width, line_px},
             {x - width / 2, y - gap - line_px, width, line_px},
             {x - width / 2, y + gap, width, line_px}}};
}

/// Labels of the points: those of shipped settings first, then those on the Pareto front. Each takes the
/// first place that overlaps neither a label nor a mark on the front.
class Labels {
public:
    Labels(const FrontFigure& figure, const FrontAxes& axes, const Rect& frame) : frame_(frame) {
        for (const auto& p : figure.points) {
            if (worth(p)) taken_.push_back(around(axes.time.at(p.time_us), axes.error.at(p.error)));
        }
        for (const bool defaults : {true, false}) {
            for (const auto& p : figure.points) {
                if (p.is_default == defaults && worth(p)) put(p, axes);
            }
        }
    }
    std::string take() { return std::move(out_); }

private:
    /// Largest number of labels; with more, the figure would be unreadable.
    static constexpr std::size_t most = 24;
    static bool worth(const Point& p) { return p.is_default || p.front; }
    static Rect around(double x, double y) { return {x - mark_px, y - mark_px, 2 * mark_px, 2 * mark_px}; }

    void put(const Point& p, const FrontAxes& axes) {
        const auto words = label_of(p);
        if (words.empty() || put_ == most) return;
        const double width = letter_px * static_cast<double>(letters_of(words));
        for (const auto& place : places_beside(axes.time.at(p.time_us), axes.error.at(p.error), width)) {
            if (!inside(place, frame_)) continue;
            if (std::ranges::any_of(taken_, [&](const Rect& r) { return overlap(r, place); })) continue;
            taken_.push_back(place);
            ++put_;
            append_text(out_, text_at(place.x, place.y + 12, words, {.strong = p.is_default}));
            return;
        }
    }

    Rect frame_;
    std::vector<Rect> taken_;
    std::size_t put_ = 0;
    std::string out_;
};

std::string marks(const FrontFigure& figure, const FrontAxes& axes) {
    std::string out;
    for (const bool front : {false, true}) {  // points on the Pareto front are drawn last, on top
        for (const auto& p : figure.points) {
            if (p.front != front) continue;
            const double x = axes.time.at(p.time_us), y = axes.error.at(p.error);
            append_text(out, mark(p.series, p.front, x, y, p.tooltip));
            if (p.is_default) append_text(out, ring(x, y));
        }
    }
    return out;
}

std::string front_names(const FrontFigure& figure, const Rect& frame) {
    const double middle = frame.y + frame.height / 2;
    return text(text_at(left, 22, cut(figure.title, 70), {.strong = true}),
                text_at(frame.x + frame.width / 2, frame.y + frame.height + 38, "median time, us",
                        {.anchor = "middle"}),
                "<g transform=\"translate(16,", px(middle), ") rotate(-90)\">",
                text_at(0, 0, cut(figure.error_name, 40), {.anchor = "middle"}), "</g>\n",
                text_at(front_width - right, 22, "full: on the front; ring: default", {"end", false, true}));
}

// ---- ratios -----------------------------------------------------------------------------------------------

constexpr double bar_step = 22, bar_height = 14;
constexpr double name_width = 330, number_width = 64, bars_width = 420;
constexpr std::size_t name_letters = 46;

std::string bar(const Bar& b, const LogAxis& axis, double y) {
    const double from = axis.at(1), to = axis.at(b.ratio);
    const double low = std::min(from, to), width = std::max(1.0, std::abs(to - from));
    return text(text_at(name_width - 10, y + 11, cut(b.label, name_letters), {.anchor = "end"}),
                "<rect class=\"t-fill-0\" x=\"", px(low), "\" y=\"", px(y), "\" width=\"", px(width),
                "\" height=\"", px(bar_height), "\" fill=\"", series_colours[0].light, "\"><title>",
                escaped(b.label), "</title></rect>\n",
                text_at(std::max(from, to) + 6, y + 11, bench::shown(b.ratio)));
}

LogAxis ratio_axis(const RatioFigure& figure) {
    std::vector<double> values{1};
    for (const auto& b : figure.bars) values.push_back(b.ratio);
    return log_axis(values, name_width, name_width + bars_width);
}

}  // namespace

FrontAxes axes_of(const FrontFigure& figure) {
    std::vector<double> times, errors;
    for (const auto& p : figure.points) {
        times.push_back(p.time_us);
        errors.push_back(p.error);
    }
    const Rect frame = frame_of(figure);
    return {log_axis(times, frame.x, frame.x + frame.width),
            log_axis(errors, frame.y + frame.height, frame.y)};
}

std::string to_svg(const FrontFigure& figure) {
    const Rect frame = frame_of(figure);
    const FrontAxes axes = axes_of(figure);
    return text(
        opened(front_width, frame.y + frame.height + axis_band, text(figure.title, ", ", figure.error_name)),
        front_names(figure, frame), legend(figure), front_grid(axes, frame), outline(frame),
        joined_front(figure, axes), marks(figure, axes), Labels(figure, axes, frame).take(), "</svg>\n");
}

std::string to_svg(const RatioFigure& figure) {
    const LogAxis axis = ratio_axis(figure);
    const double bottom = title_band + bar_step * static_cast<double>(figure.bars.size());
    std::string out = opened(name_width + bars_width + number_width, bottom + 44, figure.title);
    append_text(out, text_at(10, 22, cut(figure.title, 70), {.strong = true}));
    for (const auto& tick : ticks(axis)) {
        append_text(out, grid_line(tick.at_px, title_band, tick.at_px, bottom));
        append_text(out, text_at(tick.at_px, bottom + 16, tick.label, {.anchor = "middle"}));
    }
    double y = title_band + (bar_step - bar_height) / 2;
    for (const auto& b : figure.bars) {
        append_text(out, bar(b, axis, y));
        y += bar_step;
    }
    append_text(out, text("<line class=\"t-line\" x1=\"", px(axis.at(1)), "\" y1=\"", px(title_band),
                          "\" x2=\"", px(axis.at(1)), "\" y2=\"", px(bottom), "\" stroke=\"", ink, "\"/>\n"));
    if (figure.left_out > 0) {
        append_text(out, text_at(10, bottom + 36, text("and ", figure.left_out, " more in the table"),
                                 {.is_muted = true}));
    }
    return out + "</svg>\n";
}

}  // namespace thaum::plot

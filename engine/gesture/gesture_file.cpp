#include "gesture/gesture_file.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/file.h"
#include "core/text.h"

namespace thaum::gesture {
namespace {

constexpr double max_number = 1e9;
constexpr double degrees = 180 / pi;

GestureOptions read_options(const ConfigTable& table) {
    const GestureOptions usual;
    GestureOptions o;
    o.direction_sensitive = table.boolean("direction_sensitive", usual.direction_sensitive);
    o.rotation = table.number("rotation_degrees", {0, 180}, 0) / degrees;
    o.min_scale = table.number("smallest_scale", {0, 1}, usual.min_scale);
    o.max_scale = table.number("largest_scale", {1, max_number}, usual.max_scale);
    o.closed = table.boolean("closed", usual.closed);
    o.planar = table.boolean("planar", usual.planar);
    o.gentle_below = table.number("gentle_below", {0, max_number}, 0);
    o.harsh_above = table.number("harsh_above", {0, max_number}, 0);
    if (o.harsh_above > 0 && o.harsh_above < o.gentle_below)
        table.report("harsh_above", "must not be below gentle_below");
    return o;
}

std::vector<StrokePoint> read_stroke(const ConfigTable& table) {
    const Range range{-max_number, max_number};
    const auto t = table.numbers("t", range, max_template_points, {});
    std::vector<StrokePoint> points(t.size());
    const auto column = [&](std::string_view key, bool required, auto set) {
        const auto values = table.numbers(key, range, max_template_points, {});
        if (values.empty() && !required && !table.has(key)) return;
        if (values.size() != t.size())
            return table.report(key, text(values.size(), " numbers instead of ", t.size(), " as in t"));
        for (std::size_t i = 0; i < values.size(); ++i) set(points[i], values[i]);
    };
    for (std::size_t i = 0; i < t.size(); ++i) {
        points[i].t = t[i];
        if (i > 0 && t[i] < t[i - 1]) table.report("t", "time runs backwards");
    }
    column("x", true, [](StrokePoint& p, double v) { p.at.x = v; });
    column("y", true, [](StrokePoint& p, double v) { p.at.y = v; });
    column("z", false, [](StrokePoint& p, double v) { p.at.z = v; });
    column("force", false, [](StrokePoint& p, double v) { p.force = v; });
    if (const auto fault = fault_of_stroke(points); !fault.empty()) table.report("t", fault);
    return points;
}

template <class Value>
std::string column_text(std::string_view key, const std::vector<StrokePoint>& points, Value value) {
    std::string out = text(key, " = [");
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double v = value(points[i]);
        out += i == 0 ? "" : i % 12 == 0 ? ",\n    " : ", ";
        out += v == 0 && std::signbit(v) ? "-0.0" : text(v);
    }
    return out + "]\n";
}

}  // namespace

std::string toml_string(std::string_view words) {
    std::string out = "\"";
    for (const char c : words) {
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) {
            out.append("\\u00").append(hex(static_cast<unsigned char>(c)), 14);
            continue;
        }
        if (c == '"' || c == '\\') out += '\\';
        out += c;
    }
    return out + "\"";
}

std::string fault_of_stroke(Points stroke) {
    const auto large = [](const StrokePoint& p) {
        return std::max({std::abs(p.at.x), std::abs(p.at.y), std::abs(p.at.z), std::abs(p.force)}) >
               max_number;
    };
    if (stroke.size() < 2) return "a stroke needs two points or more";
    if (std::any_of(stroke.begin(), stroke.end(), large)) return "the stroke has a number beyond 1e9";
    const auto same = [&](const StrokePoint& p) { return p.at == stroke[0].at; };
    if (std::all_of(stroke.begin(), stroke.end(), same)) return "all points of the stroke are at one place";
    return {};
}

Expected<Gesture> read_gesture(const Config& config) {
    const auto root = config.root();
    Gesture gesture{
        .name = root.string("name"), .options = read_options(root.table("options")), .strokes = {}};
    for (const auto& table : root.tables("stroke")) gesture.strokes.push_back(read_stroke(table));
    if (gesture.name.empty() || gesture.name.size() > 200)
        root.report("name", "must have 1 to 200 characters");
    if (gesture.strokes.empty()) root.report("name", "the gesture has no [[stroke]]; record one");
    if (auto good = config.check(); !good) return good.error();
    return gesture;
}

Expected<Gesture> load_gesture(const std::filesystem::path& path) {
    const auto file = read_text_file(path, max_gesture_bytes);
    if (!file) return file.error();
    const auto config = Config::parse(*file, path.string(), gesture_file_version);
    if (!config) return config.error();
    return read_gesture(*config);
}

std::string to_file(const Gesture& gesture) {
    const auto& o = gesture.options;
    std::string out =
        text("version = ", gesture_file_version, "\nname = ", toml_string(gesture.name), "\n\n[options]\n");
    out += text("direction_sensitive = ", o.direction_sensitive,
                "\nrotation_degrees = ", o.rotation * degrees, "\nsmallest_scale = ", o.min_scale,
                "\nlargest_scale = ", o.max_scale, "\nclosed = ", o.closed, "\nplanar = ", o.planar,
                "\ngentle_below = ", o.gentle_below, "\nharsh_above = ", o.harsh_above, "\n");
    for (const auto& stroke : gesture.strokes) {
        out += "\n[[stroke]]\n";
        out += column_text("t", stroke, [](const StrokePoint& p) { return p.t; });
        out += column_text("x", stroke, [](const StrokePoint& p) { return p.at.x; });
        out += column_text("y", stroke, [](const StrokePoint& p) { return p.at.y; });
        out += column_text("z", stroke, [](const StrokePoint& p) { return p.at.z; });
        out += column_text("force", stroke, [](const StrokePoint& p) { return p.force; });
    }
    return out;
}

}  // namespace thaum::gesture

#include "tactile/detail/tact.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "core/json.h"
#include "core/text.h"

namespace thaum::tactile {
namespace {

constexpr int deepest = 32;
constexpr std::size_t longest_name = 200;
/// Largest number of cells that are drawn, over all frames. A real file draws some ten thousand.
constexpr std::size_t max_drawn = 4'000'000;
constexpr double clip_ms = static_cast<double>(clip_frame_ticks);
constexpr double longest_ms = clip_ms * static_cast<double>(max_clip_frames);

/// Nesting depth of the brackets of a JSON text, outside of strings.
int depth_of(std::string_view json) {
    int depth = 0, greatest = 0;
    bool in_text = false;
    for (std::size_t i = 0; i < json.size(); ++i) {
        const char c = json[i];
        if (in_text) {
            if (c == '\\') ++i;
            in_text = c != '"';
        } else if (c == '"') {
            in_text = true;
        } else if (c == '[' || c == '{') {
            greatest = std::max(greatest, ++depth);
        } else if (c == ']' || c == '}') {
            --depth;
        }
    }
    return greatest;
}

/// Elements of a member that is an array; empty otherwise.
std::span<const Json> elements(const Json& json, std::string_view key) {
    const auto* found = json.find(key);
    return found != nullptr ? found->elements() : std::span<const Json>();
}

std::string text_of(const Json& json, std::string_view key) {
    const auto* found = json.find(key);
    return found != nullptr ? found->string() : std::string();
}

/// Reads numbers from a .tact file, and counts those that were wrong.
class Reader {
public:
    std::size_t clipped{}, skipped{};

    /// A number in an object; the fallback value if it is missing.
    double number(const Json& json, std::string_view key, double low, double high, double fallback) {
        return number(json.find(key), low, high, fallback);
    }
    /// A number, which may also be written as a string, clipped to a range. `found` may be null.
    double number(const Json* found, double low, double high, double fallback) {
        double value = fallback;
        if (found != nullptr && found->is_number()) {
            value = found->number();
        } else if (found != nullptr && found->is_string()) {
            const auto& s = found->string();
            const auto end = std::from_chars(s.data(), s.data() + s.size(), value);
            if (end.ec != std::errc() || end.ptr != s.data() + s.size()) ++skipped, value = fallback;
        }
        if (value >= low && value <= high) return value;
        ++clipped;
        return value > high ? high : low;  // NaN becomes the low end
    }
    bool flag(const Json& json, std::string_view key) {
        const auto* found = json.find(key);
        return found != nullptr && found->boolean();
    }
};

/// Draws the tracks of a .tact project (sequences of effects) into the frames of a clip.
class Canvas {
public:
    std::vector<ClipFrame> frames;
    bool full{};      ///< true: the file draws more cells than any real file
    bool too_long{};  ///< true: the file draws something after the end of the longest clip that is allowed

    /// Raises the strength of a cell in one frame to this value (0 to 1), unless it is higher already.
    void raise(std::size_t frame, std::size_t cell, double strength) {
        if (++drawn_ > max_drawn) full = true;
        if (full) return;
        if (frame >= max_clip_frames) {
            too_long = true;
            return;
        }
        if (frames.size() <= frame) frames.resize(frame + 1);
        auto& kept = frames[frame].strength[cell];
        kept = std::max(kept, static_cast<std::uint8_t>(std::lround(100 * std::clamp(strength, 0.0, 1.0))));
    }
    /// Frames that begin within a span of time (ms); at least the frame in which the span begins.
    std::pair<std::size_t, std::size_t> span(double from, double to) const {
        const auto first = static_cast<std::size_t>(from / clip_ms);
        const auto last = static_cast<std::size_t>(std::ceil(to / clip_ms));
        return {first, std::max(last, first + 1)};
    }

private:
    std::size_t drawn_{};
};

/// Strength of a step (a part of an effect with its own times) by its playback type, such as FADE_IN, at a
/// share `part` (0 to 1) of its time.
double fade(const std::string& type, double part) {
    if (type == "FADE_IN") return part;
    if (type == "FADE_OUT") return 1 - part;
    if (type == "FADE_IN_OUT") return part < 0.5 ? 2 * part : 2 - 2 * part;
    return 1;
}

/// One side of the vest in one effect of a track.
struct Side {
    std::size_t first_cell{};
    double start{}, length{};  ///< start of the effect and its length (ms)
};

void draw_points(Reader& reader, Canvas& canvas, const Side& side, std::size_t frame, const Json& step,
                 double weight) {
    for (const auto& point : elements(step, "pointList")) {
        if (canvas.full) return;
        const auto index = static_cast<std::size_t>(reader.number(point, "index", 0, clip_side - 1, 0));
        canvas.raise(frame, side.first_cell + index, weight * reader.number(point, "intensity", 0, 1, 1));
    }
}

void draw_dots(Reader& reader, Canvas& canvas, const Side& side, const Json& mode) {
    const bool connected = reader.flag(mode, "dotConnected");
    const auto steps = elements(mode, "feedback");
    for (std::size_t i = 0; i < steps.size() && !canvas.full; ++i) {
        const double from = reader.number(steps[i], "startTime", 0, longest_ms, 0);
        const double to = reader.number(steps[i], "endTime", from, std::max(from, longest_ms), from);
        const auto type = text_of(steps[i], "playbackType");
        const auto [first, end] = canvas.span(side.start + from, side.start + to);
        for (auto frame = first; frame < end && !canvas.full; ++frame) {
            const double at = clip_ms * static_cast<double>(frame) - side.start - from;
            const double part = to > from ? std::clamp(at / (to - from), 0.0, 1.0) : 0;
            if (connected && i + 1 < steps.size()) {
                draw_points(reader, canvas, side, frame, steps[i], 1 - part);
                draw_points(reader, canvas, side, frame, steps[i + 1], part);
            } else {
                draw_points(reader, canvas, side, frame, steps[i], fade(type, part));
            }
        }
    }
}

struct PathPoint {
    double x{}, y{}, strength{}, time{};
};

/// Point on a path at a share (0 to 1) of its time.
PathPoint on_path(const std::vector<PathPoint>& path, const std::vector<double>& reached, double part) {
    const auto next = std::upper_bound(reached.begin(), reached.end(), part) - reached.begin();
    if (next == 0) return path.front();
    const auto b = static_cast<std::size_t>(next);
    if (b >= path.size()) return path.back();
    const auto &from = path[b - 1], &to = path[b];
    const double way = (part - reached[b - 1]) / (reached[b] - reached[b - 1]);
    const auto mix = [way](double p, double q) { return p + way * (q - p); };
    return {mix(from.x, to.x), mix(from.y, to.y), mix(from.strength, to.strength), 0};
}

/// Shares of the time at which the points of a path are reached.
std::vector<double> times_of(const std::vector<PathPoint>& path, bool by_time) {
    std::vector<double> reached(path.size());
    for (std::size_t i = 1; i < path.size(); ++i) {
        const double across = path[i].x - path[i - 1].x, down = path[i].y - path[i - 1].y;
        const double way = std::sqrt(across * across + down * down);
        reached[i] = reached[i - 1] + (by_time ? std::max(0.0, path[i].time - path[i - 1].time) : way);
    }
    const double whole = reached.empty() ? 0 : reached.back();
    for (auto& at : reached) at = whole > 0 ? at / whole : 0;
    return reached;
}

/// Draws a point between four cells: shares of the energy are bilinear, so the point itself is the felt
/// place.
void draw_point(Canvas& canvas, const Side& side, std::size_t frame, const PathPoint& point) {
    const double column = 3 * point.x, row = 4 * point.y;
    const auto c = std::min(static_cast<std::size_t>(column), std::size_t{2});
    const auto r = std::min(static_cast<std::size_t>(row), std::size_t{3});
    const double right = column - static_cast<double>(c), down = row - static_cast<double>(r);
    for (std::size_t k = 0; k < 4; ++k) {
        const double share = (k % 2 == 0 ? 1 - right : right) * (k < 2 ? 1 - down : down);
        canvas.raise(frame, side.first_cell + 4 * (r + k / 2) + c + k % 2, point.strength * std::sqrt(share));
    }
}

void draw_paths(Reader& reader, Canvas& canvas, const Side& side, const Json& mode) {
    for (const auto& stroke : elements(mode, "feedback")) {
        std::vector<PathPoint> path;
        for (const auto& point : elements(stroke, "pointList"))
            path.push_back({reader.number(point, "x", 0, 1, 0.5), reader.number(point, "y", 0, 1, 0.5),
                            reader.number(point, "intensity", 0, 1, 1),
                            reader.number(point, "time", 0, longest_ms, 0)});
        if (path.empty()) continue;
        const auto type = text_of(stroke, "playbackType");
        const auto reached = times_of(path, text_of(stroke, "movingPattern") == "CONST_TDM");
        const auto [first, end] = canvas.span(side.start, side.start + side.length);
        for (auto frame = first; frame < end && !canvas.full; ++frame) {
            const double at = clip_ms * static_cast<double>(frame) - side.start;
            const double part = side.length > 0 ? std::clamp(at / side.length, 0.0, 1.0) : 0;
            auto point = on_path(path, reached, part);
            point.strength *= fade(type, part);
            draw_point(canvas, side, frame, point);
        }
    }
}

void draw_effect(Reader& reader, Canvas& canvas, const Json& effect) {
    const auto* modes = effect.find("modes");
    if (modes == nullptr || !modes->is_object()) {
        ++reader.skipped;
        return;
    }
    for (const auto& [position, mode] : modes->members()) {
        if (position != "VestFront" && position != "VestBack") {
            ++reader.skipped;
            continue;
        }
        Side side;
        side.first_cell = position == "VestFront" ? 0 : clip_side;
        side.start = reader.number(effect, "startTime", 0, longest_ms, 0);
        side.length = reader.number(effect, "offsetTime", 0, longest_ms, 0);
        const auto* dots = mode.find("dotMode");
        const auto* paths = mode.find("pathMode");
        if (text_of(mode, "mode") == "PATH_MODE") {
            if (paths != nullptr) draw_paths(reader, canvas, side, *paths);
        } else if (dots != nullptr) {
            draw_dots(reader, canvas, side, *dots);
        }
    }
}

void draw_project(Reader& reader, Canvas& canvas, const Json& project) {
    for (const auto& track : elements(project, "tracks")) {
        const auto* enabled = track.find("enable");
        if (enabled != nullptr && enabled->is_boolean() && !enabled->boolean()) continue;
        for (const auto& effect : elements(track, "effects")) {
            if (!canvas.full) draw_effect(reader, canvas, effect);
        }
    }
    const double media_ms = 1000 * reader.number(project, "mediaFileDuration", 0, longest_ms / 1000, 0);
    const auto count = static_cast<std::size_t>(std::ceil(media_ms / clip_ms - 1e-6));
    if (!canvas.frames.empty() && canvas.frames.size() < count) canvas.frames.resize(count);
}

void draw_baked(Reader& reader, Canvas& canvas, const Json& feedback) {
    for (const auto& [key, sides] : feedback.members()) {
        double ms = -1;
        const auto end = std::from_chars(key.data(), key.data() + key.size(), ms);
        if (end.ec != std::errc() || !(ms >= 0) || !sides.is_array()) {
            ++reader.skipped;
            continue;
        }
        if (ms >= longest_ms) {
            canvas.too_long = true;
            continue;
        }
        for (const auto& side : sides.elements()) {
            const auto position = text_of(side, "position");
            const auto values = elements(side, "values");
            if (position != "VestFront" && position != "VestBack") ++reader.skipped;
            for (std::size_t i = 0; i < values.size() && i < clip_side && position.starts_with("Vest"); ++i) {
                canvas.raise(static_cast<std::size_t>(ms / clip_ms),
                             (position == "VestBack" ? clip_side : 0) + i,
                             reader.number(&values[i], 0, 100, 0) / 100);
            }
        }
    }
}

bool has_strength(const Canvas& canvas) {
    return std::any_of(canvas.frames.begin(), canvas.frames.end(),
                       [](const ClipFrame& frame) { return frame != ClipFrame{}; });
}

}  // namespace

Expected<TactImport> import_tact(std::string_view json) {
    if (json.size() > max_tact_bytes)
        return fail(text("the file has more than ", max_tact_bytes >> 20U, " MiB"));
    if (depth_of(json) > deepest) return fail(text("the file is nested deeper than ", deepest, " levels"));
    const auto root = parse_json(json);
    if (!root) return fail(text("the file ", root.error().message));
    if (!root->is_object()) return fail("the file is not a JSON object");
    Reader reader;
    Canvas canvas;
    const auto* project = root->find("project");
    const auto* feedback = root->find("feedback");
    if (project != nullptr) draw_project(reader, canvas, *project);
    if (!has_strength(canvas) && !canvas.full && feedback != nullptr && feedback->is_object())
        draw_baked(reader, canvas, *feedback);
    if (canvas.full) return fail("the file has more to draw than an effect can need");
    if (canvas.too_long) return fail("the effect is longer than a minute");
    if (!has_strength(canvas)) return fail("the file has nothing for the vest (VestFront or VestBack)");
    auto name = project != nullptr ? text_of(*project, "name") : std::string();
    if (name.empty()) name = text_of(*root, "name");
    if (name.size() > longest_name) name.clear();
    return TactImport{{std::move(name), std::move(canvas.frames)}, reader.clipped, reader.skipped};
}

}  // namespace thaum::tactile

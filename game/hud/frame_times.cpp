#include "game/hud/frame_times.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/text.h"

namespace thaum::game::inline hud {
namespace {

struct Part {
    std::string_view name;
    double ms;
};

std::vector<Part> parts_of(const FrameTimes& times) {
    std::vector<Part> parts{{"building", times.building_ms}, {"showing", times.showing_ms}};
    for (std::size_t i = 0; i < render::passes; ++i)
        parts.push_back({render::pass_names[i], times.passes.ms[i]});
    std::stable_sort(parts.begin(), parts.end(), [](const Part& a, const Part& b) { return a.ms > b.ms; });
    return parts;
}

}  // namespace

void approach(FrameTimes& shown, const FrameTimes& newest, double weight) {
    const auto move = [&](double& from, double to) { from += weight * (to - from); };
    move(shown.building_ms, newest.building_ms);
    move(shown.showing_ms, newest.showing_ms);
    for (std::size_t i = 0; i < render::passes; ++i) move(shown.passes.ms[i], newest.passes.ms[i]);
    shown.quality = newest.quality;
    shown.resolution = newest.resolution;
}

std::string words_of(const FrameTimes& times) {
    auto words = text("picture ", fixed(times.total_ms(), 1), " ms, ",
                      render::quality_names[static_cast<std::size_t>(times.quality)], ", ",
                      std::lround(100 * times.resolution), " %");
    // Three spaces separate groups of words. A line is broken only between groups (FittedWords).
    for (const auto& part : parts_of(times))
        if (part.ms >= 0.05) words += text("   ", part.name, " ", fixed(part.ms, 1));
    return words;
}

}  // namespace thaum::game::inline hud

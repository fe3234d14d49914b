#include "unit/tact_writer.h"

#include <algorithm>
#include <span>

#include "core/json.h"
#include "core/text.h"

namespace thaum::tactile {
namespace {

Json dot_points(const ClipFrame& frame, std::size_t first_cell) {
    auto points = Json::array();
    for (std::size_t i = 0; i < clip_side; ++i) {
        const unsigned percent = frame.strength[first_cell + i];
        if (percent > 0) points.push_back({{"index", i}, {"intensity", fixed(percent / 100.0, 3)}});
    }
    return points;
}

std::span<const std::uint8_t> cells_of(const ClipFrame& frame, std::size_t first_cell) {
    return std::span(frame.strength).subspan(first_cell, clip_side);
}

/// Tracks for one side of the vest, with a step for each run of equal frames.
Json dot_mode(const Clip& clip, std::size_t first_cell) {
    auto steps = Json::array();
    for (std::size_t from = 0; from < clip.frames.size();) {
        const auto cells = cells_of(clip.frames[from], first_cell);
        auto to = from + 1;
        while (to < clip.frames.size() && std::ranges::equal(cells_of(clip.frames[to], first_cell), cells))
            ++to;
        if (const auto points = dot_points(clip.frames[from], first_cell); !points.elements().empty())
            steps.push_back({{"startTime", clip_frame_ticks * from},
                             {"endTime", clip_frame_ticks * to},
                             {"playbackType", "NONE"},
                             {"pointList", points}});
        from = to;
    }
    return {{"texture", 0},
            {"mode", "DOT_MODE"},
            {"dotMode", {{"dotConnected", false}, {"feedback", steps}}},
            {"pathMode", {{"feedback", Json::array()}}}};
}

Json baked(const Clip& clip) {
    auto feedback = Json::object();
    for (std::size_t f = 0; f < clip.frames.size(); ++f) {
        auto sides = Json::array();
        for (const std::size_t first_cell : {std::size_t{0}, clip_side}) {
            const auto cells = cells_of(clip.frames[f], first_cell);
            sides.push_back({{"position", first_cell == 0 ? "VestFront" : "VestBack"},
                             {"mode", "DOT_MODE"},
                             {"values", std::vector<std::uint64_t>(cells.begin(), cells.end())},
                             {"texture", 0}});
        }
        feedback.set(text(clip_frame_ticks * f), std::move(sides));
    }
    return feedback;
}

Json cells_of_layout() {
    auto cells = Json::array();
    for (std::size_t i = 0; i < clip_side; ++i) {
        const std::size_t column = i % 4, row = i / 4;
        cells.push_back({{"index", i},
                         {"x", fixed(static_cast<double>(column) / 3, 3)},
                         {"y", fixed(static_cast<double>(row) / 4, 3)}});
    }
    return cells;
}

}  // namespace

std::string tact_of(const Clip& clip) {
    const auto length = clip_frame_ticks * clip.frames.size();
    const Json effect{{"name", "dot"},
                      {"startTime", 0},
                      {"offsetTime", length},
                      {"modes", {{"VestFront", dot_mode(clip, 0)}, {"VestBack", dot_mode(clip, clip_side)}}}};
    const Json project{{"name", clip.name},
                       {"mediaFileDuration", static_cast<double>(length) / 1000},
                       {"tracks", Json::array({{{"enable", true}, {"effects", Json::array({effect})}}})},
                       {"layout",
                        {{"name", "Tactot"},
                         {"type", "Vest"},
                         {"layouts", {{"VestFront", cells_of_layout()}, {"VestBack", cells_of_layout()}}}}}};
    const Json root{
        {"intervalMillis", clip_frame_ticks},          {"size", clip_side},       {"name", clip.name},
        {"durationMillis", length + clip_frame_ticks}, {"feedback", baked(clip)}, {"project", project}};
    return dump(root);
}

}  // namespace thaum::tactile

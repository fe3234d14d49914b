#include "game/hud/station_strip.h"

#include <algorithm>
#include <cmath>

#include "core/text.h"
#include "game/hud/overlay.h"
#include "game/hud/wand_icon.h"

namespace thaum::game::inline hud {
namespace {

using render::Align;
using render::Overlay;
using render::RectItem;

constexpr float min_high = 17;  // minimum height of a line of text (HUD units)

/// A haptic mode or a carving tool that a key chooses.
struct Choice {
    std::string_view name;
    bool chosen{};
};

/// Haptic modes at the orb or tools at a crystal, in the order of the wand keys.
std::vector<Choice> choices_of(const PlayerPicture& p) {
    std::vector<Choice> result;
    const auto& modes = p.stations.scrying.modes;
    for (std::size_t i = 0; p.stations.scrying.scries && i < modes.size() && !modes.at(i).empty(); ++i)
        result.push_back({modes.at(i), p.stations.scrying.worn.at(i)});
    const auto& tools = p.stations.carving.tools;
    for (std::size_t i = 0; p.stations.carving.carves && i < tools.size() && !tools.at(i).empty(); ++i)
        result.push_back({tools.at(i), i == p.stations.carving.tool});
    return result;
}

/// Divides a box into `count` cells from left to right and then downwards, in as few columns as leave each
/// cell high enough for a line of text.
std::vector<Panel> cells_of(const Panel& box, float u, std::size_t count) {
    const fvec2 room = box.high - box.low;
    const auto max_rows = static_cast<std::size_t>(std::max(1.0F, std::floor(room.y / (u * min_high))));
    const std::size_t columns = (count + max_rows - 1) / max_rows, rows = (count + columns - 1) / columns;
    const fvec2 size = room / fvec2(static_cast<float>(columns), static_cast<float>(rows));
    std::vector<Panel> cells;
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t column = i % columns, row = i / columns;
        const fvec2 at = box.low + size * fvec2(static_cast<float>(column), static_cast<float>(row));
        cells.push_back({at, at + size});
    }
    return cells;
}

}  // namespace

bool add_station_strip(Overlay& out, const Picture& picture, const ControlNames& controls,
                       std::uint32_t player, const ViewLayout& l) {
    const auto choices = choices_of(picture.wizards[player]);
    if (choices.empty()) return false;
    const auto& strip = l.strip;
    const float u = strip_unit(l), em = 13 * u;
    out.items.emplace_back(RectItem{strip.low, strip.high, paints.panel, 8 * u});
    const auto cells =
        cells_of({strip.low + strip_margin * u, strip.high - strip_margin * u}, u, choices.size());
    for (std::size_t i = 0; i < cells.size(); ++i)
        if (choices[i].chosen)
            out.items.emplace_back(RectItem{cells[i].low, cells[i].high, paints.chosen_plate, 6 * u});
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const auto& [name, chosen] = choices[i];
        const auto key = i < controls.wands.size() ? brief_label(controls.wands[i]) : std::string();
        const auto paint = chosen ? paints.chosen : paints.soft;
        const float left = cells[i].low.x + 4 * u,
                    name_left = left + (key.empty() ? 0 : width_of(key, em) + 4 * u);
        const float top =
            std::max((cells[i].low.y + cells[i].high.y - FittedWords::line_spacing * em) / 2, cells[i].low.y);
        add_text_in(out, {{left, top}, {name_left, cells[i].high.y}}, key, em, paint, Align::left);
        add_text_in(out, {{name_left, top}, cells[i].high}, name, em, paint, Align::left);
    }
    return true;
}

}  // namespace thaum::game::inline hud

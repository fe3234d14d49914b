// Panels beside the brew in the lab: the keys with their actions, and numbers about the flow.
#include <algorithm>
#include <cstdio>

#include "core/text.h"
#include "game/hud/overlay.h"
#include "game/lab/window/lab_picture.h"
#include "render/colour.h"

namespace thaum::game::inline lab {
namespace {

using render::Align;
using render::Overlay;

const fvec4 lab_panel = render::colour(0x140E22, 0.68F);
const fvec4 lab_bright = render::colour(0xF6F0FF, 1.0F);
const fvec4 lab_soft = render::colour(0xD8CCE8, 0.9F);
const fvec4 lab_gold = render::colour(0xE8C070, 1.0F);

constexpr float row = 19;  // height of a line (1/720 of the picture's height)
constexpr float key_width = 108, left_width = 350, right_width = 280, edge = 10;

/// The character on the user's keyboard for the key of this name.
std::string sign_of(std::string_view key) { return render::key_sign(render::key_code(key).value_or(-1)); }

struct Line {
    std::string key, label, value;
};

std::vector<Line> keys_of(const LabState& lab, const LabHands& hands) {
    if (!hands.list) return {{sign_of("H"), "list of keys", ""}};
    std::vector<Line> lines;
    for (const auto& control : lab_controls()) {
        const auto key = control.less.empty() ? sign_of(control.more)
                                              : sign_of(control.less) + " " + sign_of(control.more);
        lines.push_back({key, std::string(control.label), control.shown(hands, lab.rules)});
    }
    for (const auto& [key, label] :
         std::initializer_list<std::pair<const char*, const char*>>{{"left drag", "stirs"},
                                                                    {"PgUp PgDn", "ladle higher, deeper"},
                                                                    {"right drag", "turns the view"},
                                                                    {"wheel", "nearer, farther"},
                                                                    {"Space", "pours the substance"},
                                                                    {"Backspace", "at rest and pure again"},
                                                                    {"F5  F9", "save, load"},
                                                                    {"Esc", "leave"}})
        lines.push_back({key, label, ""});
    return lines;
}

/// Text of a number of any magnitude with two digits: 2.3e-05.
std::string short_number(double value) {
    char digits[32];
    std::snprintf(digits, sizeof digits, "%.1e", value);
    return digits;
}

std::vector<Line> figures_of(const LabState& lab, const LabFigures& f, double steps_per_s) {
    const auto& p = f.momentum;
    std::vector<Line> lines{
        {"", "time", fixed(lab.seconds(), 2) + " s"},
        {"", "energy", fixed(f.fluid.energy, 4) + " m5/s2"},
        {"", "momentum", text(fixed(p.x, 2), " ", fixed(p.y, 2), " ", fixed(p.z, 2))},
        {"", "fastest", fixed(f.fluid.speed, 2) + " m/s"},
        {"", "CFL", fixed(f.cfl, 2)},
        {"", "divergence", short_number(f.fluid.divergence)},
        {"", "sub-steps", text(f.fluid.substeps, f.fluid.fell_back ? " + fallen back" : "")},
        {"", "pressure iterations", text(f.fluid.pressure_iterations)},
        {"", "fluid", fixed(f.fluid_us, 0) + " us"},
        {"", "surface", fixed(f.surface_us, 0) + " us"},
        {"", "mixing", fixed(f.mixing, 3)},
        {"", "ladle", fixed(f.ladle_n, 0) + " N"},
    };
    if (steps_per_s > 0) lines.push_back({"", "speed", fixed(100 * steps_per_s * lab_dt, 0) + " %"});
    for (std::size_t s = 0; s < lab.settings.substances.size(); ++s)
        lines.push_back({"", lab.settings.substances[s].name, fixed(1e3 * f.amounts[s], 1) + " l"});
    return lines;
}

/// Adds a panel of lines with its upper left corner at `low` (px). `keys`: width of the column of keys; 0:
/// there is no such column.
void add_lines(Overlay& out, const std::vector<Line>& lines, fvec2 low, float width, float keys, float u) {
    const float high = static_cast<float>(lines.size()) * row * u;
    out.items.emplace_back(render::RectItem{low, low + fvec2(width * u, high + 12 * u), lab_panel, 8 * u});
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const float y = low.y + 6 * u + static_cast<float>(i) * row * u;
        const float size = 14 * u;
        if (keys > 0 && !lines[i].key.empty())
            add_text(out, lines[i].key, {low.x + 10 * u, y}, size, lab_gold, Align::left);
        add_text(out, lines[i].label, {low.x + (10 + keys) * u, y}, size, lab_soft, Align::left);
        if (!lines[i].value.empty())
            add_text(out, lines[i].value, {low.x + (width - 10) * u, y}, size, lab_bright, Align::right);
    }
}

}  // namespace

void add_lab_words(Overlay& out, const LabState& lab, const LabFigures& figures, const LabPage& page,
                   render::Size size) {
    const auto keys = keys_of(lab, page.hands);
    const auto tall = static_cast<float>(size.height), wide = static_cast<float>(size.width);
    // Length of a unit of text (px): as large as the settings ask for, but no larger than fits.
    const float fits =
        std::min(tall / (static_cast<float>(keys.size()) * row + 60), wide / (left_width + right_width + 60));
    const float u = std::min(static_cast<float>(page.text_scale) * tall / 720, fits);
    if (page.panels) {
        add_lines(out, keys, {edge * u, edge * u}, left_width, key_width, u);
        add_lines(out, figures_of(lab, figures, page.steps_per_s),
                  {wide - (right_width + edge) * u, edge * u}, right_width, 0, u);
    }
    if (!page.note.empty())
        add_text(out, page.note, {wide / 2, tall - 34 * u}, 18 * u, lab_gold, Align::centre);
}

}  // namespace thaum::game::inline lab

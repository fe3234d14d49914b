// unit/hud_busy.h: the HUD with as much content as possible, in every kind of view, and a search for its
// texts.
#pragma once
#include <string_view>

#include "core/text.h"
#include "unit/hud_rig.h"

namespace thaum::game::hud_tests {

inline constexpr float readable = 12;  ///< least font size (em) of readable text at 1280 x 720 (px)

inline HudSettings busy_settings(render::Split split, Watch watch, double scale) {
    HudSettings settings{.split = split, .watch = watch, .text_scale = scale};
    settings.heard = {HeardWish::all, HeardWish::all};
    settings.prompts.fill(PromptWish::always);
    for (auto& one : settings.controls)
        one = {.fire = "Left mouse", .stir = "E", .throw_ = "F", .trace = "Right mouse"};
    return settings;
}

/// Calls f(settings, name) for a view that fills the window and for both ways to split it, at all text sizes.
template <class F>
void each_view(F f) {
    for (double scale = 1; scale <= 2.5; scale += 0.5) {
        f(busy_settings(render::Split::top_bottom, Watch::both, scale), text("stacked at ", scale));
        f(busy_settings(render::Split::side_by_side, Watch::both, scale), text("beside at ", scale));
        f(busy_settings(render::Split::top_bottom, Watch::first, scale), text("alone at ", scale));
    }
}

/// Smallest font size (em, in px) of the texts that contain `part`, and the number of these texts.
struct Found {
    float least{1e6F};
    std::size_t number{};
};
inline Found find_words(const render::Overlay& overlay, std::string_view part) {
    Found found;
    for (const auto* words : texts_with(overlay, part)) {
        found.least = std::min(found.least, words->size);
        ++found.number;
    }
    return found;
}

}  // namespace thaum::game::hud_tests

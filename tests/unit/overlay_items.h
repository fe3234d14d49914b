// unit/overlay_items.h: makes an overlay of the HUD for tests, and finds items in it.
#pragma once
#include <algorithm>
#include <string_view>
#include <vector>

#include "game/hud/hud.h"
#include "render/scene.h"

namespace thaum::game::hud_tests {

inline render::Overlay overlay_of(const Picture& picture, const HudSettings& settings = {},
                                  render::Size window = {1280, 720}) {
    render::Overlay overlay;
    make_overlay(picture, settings, window, overlay);
    return overlay;
}

/// Items of one kind, in the order of drawing. The pointers point into the overlay.
template <class Item>
std::vector<const Item*> items_of(const render::Overlay& overlay) {
    std::vector<const Item*> found;
    for (const auto& item : overlay.items) {
        if (const auto* one = std::get_if<Item>(&item)) found.push_back(one);
    }
    return found;
}

/// Texts that contain `part`. Most have a dark copy, which is drawn first.
inline std::vector<const render::TextItem*> texts_with(const render::Overlay& overlay,
                                                       std::string_view part) {
    auto found = items_of<render::TextItem>(overlay);
    std::erase_if(found, [&](const auto* words) { return words->text.find(part) == std::string::npos; });
    return found;
}

inline bool has_text(const render::Overlay& overlay, std::string_view part) {
    return !texts_with(overlay, part).empty();
}

/// Texts that are exactly these words.
inline std::vector<const render::TextItem*> texts_of(const render::Overlay& overlay, std::string_view words) {
    auto found = texts_with(overlay, words);
    std::erase_if(found, [&](const auto* one) { return one->text != words; });
    return found;
}

/// The text that is exactly these words; nullptr: there is none. Texts are drawn over a dark copy, which
/// makes them readable on any background; the copy is not returned.
inline const render::TextItem* text_item(const render::Overlay& overlay, std::string_view words) {
    const auto found = texts_of(overlay, words);
    return found.empty() ? nullptr : found.back();
}

}  // namespace thaum::game::hud_tests

// unit/hud_rig.h: a new match of two bots, its picture, and a search for text in an overlay.
#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <memory>

#include "game/bots/bot.h"
#include "game/hud/hud.h"

namespace thaum::game::hud_tests {

inline const std::filesystem::path assets = THAUM_SOURCE_DIR "/assets";
inline constexpr render::Size size{480, 320};

inline std::shared_ptr<const MatchData> match_data() {
    static const auto data = [] {
        auto loaded = load_match_data(assets, {});
        EXPECT_TRUE(loaded) << loaded.error().message;
        return std::make_shared<const MatchData>(std::move(*loaded));
    }();
    return data;
}

inline std::unique_ptr<Simulation> new_match() {
    return std::make_unique<Simulation>(match_data(), MatchSetup{1, {bot_device(0, 1), bot_device(1, 1)}});
}

inline Picture picture_of(const Simulation& match) {
    auto picture = make_picture();
    take_picture(match, picture);
    return picture;
}

inline bool has_text(const render::Overlay& overlay, std::string_view part) {
    return std::any_of(overlay.items.begin(), overlay.items.end(), [&](const render::OverlayItem& item) {
        const auto* words = std::get_if<render::TextItem>(&item);
        return words != nullptr && words->text.find(part) != std::string::npos;
    });
}

}  // namespace thaum::game::hud_tests

// unit/hud_rig.h: a new match of two bots, and its picture.
#pragma once
#include <gtest/gtest.h>

#include <filesystem>
#include <memory>
#include <optional>

#include "game/bots/bot.h"
#include "render/context.h"
#include "unit/overlay_items.h"

namespace thaum::game::hud_tests {

inline const std::filesystem::path assets = THAUM_SOURCE_DIR "/assets";
inline constexpr render::Size size{480, 320};

inline std::shared_ptr<const MatchData> match_data() {
    static const auto data = [] {
        return std::make_shared<const MatchData>(load_match_data(assets, {}).value());
    }();
    return data;
}

inline std::unique_ptr<Simulation> new_match() {
    return std::make_unique<Simulation>(match_data(),
                                        MatchSetup{1, {bot_device(0, "level_1"), bot_device(1, "level_1")}});
}

inline Picture picture_of(const Simulation& match) {
    auto picture = make_picture();
    take_picture(match, picture);
    return picture;
}

/// Draws in memory with the shipped shaders. Skips the test where there is no OpenGL.
class DrawingTest : public testing::Test {
protected:
    explicit DrawingTest(render::Size window) : window_(window) {}
    void SetUp() override {
        auto made = render::Offscreen::create(window_.width, window_.height);
        if (!made) GTEST_SKIP() << made.error().message;
        context.emplace(std::move(*made));
        context->make_current();
        renderer.emplace(render::Renderer::create(assets).value());
    }

    const render::Size window_;
    std::optional<render::Offscreen> context;
    std::optional<render::Renderer> renderer;
};

/// A DrawingTest with the meshes of an arena, the court.
class ArenaDrawingTest : public DrawingTest {
protected:
    using DrawingTest::DrawingTest;
    void SetUp() override {
        DrawingTest::SetUp();
        if (IsSkipped() || HasFatalFailure()) return;
        arena_scene = make_arena_scene(*renderer, *match_data());
    }

    ArenaScene arena_scene;
};

/// Places a wizard's feet at a position, looking at a point.
inline void stand(Picture& p, const WizardRules& rules, std::uint32_t player, vec3 feet, vec3 at) {
    auto& w = p.wizards[player];
    w.vitals.centre = feet + vec3(0, rules.height / 2, 0);
    w.vitals.eye = eye_of(rules, w.vitals.centre);
    const vec3 d = at - w.vitals.eye;
    w.vitals.yaw = std::atan2(-d.x, -d.z);
    w.vitals.pitch = std::atan2(d.y, std::hypot(d.x, d.z));
}

}  // namespace thaum::game::hud_tests

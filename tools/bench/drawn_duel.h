// bench/drawn_duel.h: a duel of two bots and what draws it off the screen, both views in one picture.
#pragma once
#include <memory>
#include <optional>

#include "game/bots/duel.h"
#include "game/hud/hud.h"
#include "render/context.h"
#include "render/renderer.h"

namespace thaum::bench {

inline constexpr render::Size window{1280, 720};

struct DrawnDuel {
    render::Offscreen context;
    std::optional<render::Renderer> renderer;  // goes before its context
    game::BotDuel duel;
    game::ArenaScene arena_scene{};
    game::FrameMemory memory{};

    /// Of bots of level 1, with its context made current. Fails where nothing can draw.
    static Expected<std::unique_ptr<DrawnDuel>> create();

    /// Nothing is left to be done behind our back: the last pixel is there.
    void draw(const render::Frame& frame);
};

}  // namespace thaum::bench

// tools/bench/drawn_duel.h: a duel of two bots with an off-screen renderer that draws both views in one
// picture.
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
    std::optional<render::Renderer> renderer;  // declared after `context`, so that it is destroyed first
    game::BotDuel duel;
    game::ArenaScene arena_scene{};
    game::FrameMemory memory{};

    /// Makes a duel of two bots of level 1 and makes the OpenGL context current. Fails without OpenGL.
    static Expected<std::unique_ptr<DrawnDuel>> create();

    /// Draws a frame and waits until the last pixel is read back.
    void draw(const render::Frame& frame);
};

}  // namespace thaum::bench

// game/hud/still.h: single pictures of a match, drawn in memory, with or without a display.
#pragma once
#include <filesystem>
#include <memory>

#include "game/hud/hud.h"
#include "game/match/simulation.h"
#include "game/senses/senses.h"
#include "render/image.h"

namespace thaum::game::inline hud {

class Still {
public:
    /// Prepares to draw matches with this data. The error is one line: no OpenGL, no font, or a broken
    /// shader.
    static Expected<Still> create(const MatchData& data, const std::filesystem::path& assets,
                                  render::Size size);
    Still(Still&&) noexcept;
    Still& operator=(Still&&) noexcept;
    ~Still();

    /// Draws a match. `senses`: what players have heard and felt so far; null: none of it is shown.
    render::Image draw(const Simulation& match, const HudSettings& settings, const Senses* senses = nullptr);
    /// Draws the match and saves the picture as a PNG file.
    Expected<void> save(const Simulation& match, const HudSettings& settings,
                        const std::filesystem::path& file, const Senses* senses = nullptr);

private:
    struct State;
    explicit Still(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

}  // namespace thaum::game::inline hud

// game/hud/replay_bar.h: the bar of a replay, in a band below the views, which covers nothing of them:
//
//     0:41.3 / 4:02                                           2 x, paused, both views
//     ======|-----^--------------^--o----.........................  played, indexed, not yet indexed; kills
//     Space: pause   Left, Right: 5 s   Up, Down: speed   ...
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "game/hud/panel.h"
#include "game/match/replay_index.h"
#include "render/context.h"
#include "render/scene.h"

namespace thaum::game::inline hud {

/// Contents of a replay's bar, except the time of the picture.
struct ReplayBar {
    Tick length{};   ///< length of the log (ticks)
    Tick indexed{};  ///< tick up to which every jump is quick, because states are stored (ReplayIndex)
    std::optional<Tick> target{};  ///< tick to which a running jump leads
    double speed = 1;
    bool paused = false;
    std::string eyes;  ///< text that says whose views are shown
    std::string keys;  ///< text that says what the keys do
    std::vector<Kill> kills;
    bool operator==(const ReplayBar&) const = default;
};

/// Positions of the parts of a replay's bar, none of which overlap.
struct ReplayBarLayout {
    float unit{};  ///< length of a HUD unit (px)
    Panel band;    ///< the whole bar, at the lower edge of the window
    Panel clock, state;
    Panel track;  ///< the time line with its marks, which the mouse can click
    Panel keys;
};
/// Largest width of the key help if it is written in one line (em).
inline constexpr float replay_keys_wide = 80;
/// Computes the layout for a window. If the key help in one line would be smaller than the other text of the
/// bar, it gets up to three lines.
ReplayBarLayout lay_out_replay_bar(double text_scale, render::Size window);

/// The tick at a horizontal position on the time line, from 0 to `length`.
Tick tick_at(const ReplayBarLayout& layout, float x, Tick length);

/// Adds the bar to the overlay. `now`: tick of the picture.
void add_replay_bar(render::Overlay& out, const ReplayBar& bar, Tick now, const ReplayBarLayout& layout);

}  // namespace thaum::game::inline hud

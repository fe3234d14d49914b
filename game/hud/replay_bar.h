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

namespace thaum::game {

/// Contents of the bar, apart from the time of the picture.
struct ReplayBar {
    Tick length{};                 ///< ticks of the log
    Tick indexed{};                ///< up to here every place is quick to reach
    std::optional<Tick> target{};  ///< place that the replay is on its way to
    double speed = 1;
    bool paused = false;
    std::string eyes;  ///< words on whose views are shown
    std::string keys;  ///< words on what the keys do
    std::vector<Kill> kills;
    bool operator==(const ReplayBar&) const = default;
};

/// Places of the bar's parts. None overlaps another.
struct ReplayBarLayout {
    float unit{};  ///< length of a unit (px)
    Panel band;    ///< all of it, the lower edge of the window
    Panel clock, state;
    Panel track;  ///< the line of time with its marks; also where the mouse acts
    Panel keys;
};
/// Greatest width of the words on the keys in one line (em).
inline constexpr float replay_keys_wide = 80;
/// If one line of keys would be smaller than the rest of the bar, the keys have up to three lines.
ReplayBarLayout lay_out_replay_bar(double text_scale, render::Size window);

/// The tick at a place on the track, from 0 to `length`.
Tick tick_at(const ReplayBarLayout& layout, float x, Tick length);

/// `now`: tick of the picture.
void add_replay_bar(render::Overlay& out, const ReplayBar& bar, Tick now, const ReplayBarLayout& layout);

}  // namespace thaum::game

// game/hud/hud.h: a Picture becomes a render::Frame: the view of each player and, over it, what a player must know.
// Nothing shakes, bobs or flashes.
#pragma once
#include "game/hud/court.h"
#include "render/context.h"

namespace thaum::game {

/// Whose eyes the window shows.
enum class Watch : std::uint8_t { both, first, second };

struct HudSettings {
    render::Split split = render::Split::top_bottom;  ///< for two views
    Watch watch = Watch::both;
    double fov = 90;        ///< degrees from left to right of a 16:9 view; other shapes show as much
    double text_scale = 1;  ///< 1 to 2.5
    render::Quality quality = render::Quality::medium;
    bool bloom = true;           ///< at high quality
    bool can_play_again = true;  ///< the result screen offers it
    bool forces = false;         ///< what hands feel, as a curve in each view, and the brew's flow
    bool menu = false;           ///< a menu will stand over the views: nothing else does
    /// What is wrong with each player's device, in its driver's words; filled by the session.
    std::array<std::string, players> device_says{};
};

/// Memory that frames are built in; a Frame's spans point into it.
struct FrameMemory {
    std::array<std::vector<render::Instance>, players> instances;
    std::vector<render::Instance> shades, mists, fixed_casters, moving_casters;
    std::array<std::vector<render::PointLight>, players> lights;
    render::Frame frame;
};

/// What every picture of the court has, whoever looks: size, presets, shadows; no views and nothing over them yet.
void begin_frame(const Court& court, const Picture& picture, const HudSettings& settings, render::Size size,
                 FrameMemory& memory);

/// The returned frame lives in `memory` until the next call.
const render::Frame& make_frame(const Court& court, const Picture& picture, const HudSettings& settings,
                                render::Size size, FrameMemory& memory);

/// Only the flat part: what stands over the views.
void make_overlay(const Picture& picture, const HudSettings& settings, render::Size size,
                  render::Overlay& out);

/// All words that stand over both players' views.
std::vector<std::string> words_over_views(const Simulation& match);

/// Where each player's view is; of no size where it is not shown.
std::array<render::Rect, players> views_of(const HudSettings& settings, render::Size size);

/// Vertical field of view for a view of this shape, rad.
double field_of_view(double fov_degrees, double aspect);

}  // namespace thaum::game

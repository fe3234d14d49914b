// game/hud/hud.h: turns a Picture into a render::Frame: each player's view with the HUD over it. Nothing in a
// view shakes, bobs or flashes.
#pragma once
#include <limits>

#include "game/data/control_names.h"
#include "game/data/teams.h"
#include "game/hud/prompts.h"
#include "game/hud/replay_bar.h"
#include "game/scene/arena_scene.h"
#include "game/senses/sound/heard.h"
#include "render/context.h"

namespace thaum::game {

/// The players whose views the window shows.
enum class Watch : std::uint8_t { both, first, second };

struct HudSettings {
    render::Split split = render::Split::top_bottom;  ///< arrangement of two views
    Watch watch = Watch::both;
    /// Horizontal field of view of a 16:9 view (degrees); other shapes show the same area.
    double fov = 90;
    double text_scale = 1;  ///< text size, 1 to 2.5
    render::Quality quality = render::Quality::medium;
    bool bloom = true;           ///< used at high quality only
    bool can_play_again = true;  ///< shows on the result screen that another match can be played
    bool has_menu = true;        ///< leaving a match leads to the start screen; false: it ends the program
    bool forces = false;         ///< shows the force on the hand as a curve, and the brew's flow
    bool menu = false;           ///< a menu will cover the views; the HUD is left out
    /// Fault of each player's device in its driver's words. The session fills this in.
    std::array<std::string, players> device_messages{};
    PlayerNames names{};
    /// true: the player's view has words about what happens to the player
    std::array<bool, players> captions{true, true};
    std::array<HeardWish, players> heard{};        ///< what each player sees in words of all heard and felt
    std::array<bool, players> figure{true, true};  ///< which players see what their bodies feel
    std::array<ControlNames, players> controls{};  ///< controls of each person
    std::array<PromptWish, players> prompts{};     ///< when each player's prompts are shown
    PromptUses prompt_uses{};                      ///< how often each player has done what a prompt says
    std::optional<ReplayBar> replay{};             ///< the bar of a replay; std::nullopt: a match
    bool operator==(const HudSettings&) const = default;
};

/// Memory for building frames. The spans of a Frame point into it.
/// How far a view has come nearer to the body that its player carves.
struct NearView {
    Tick tick = std::numeric_limits<Tick>::max();  ///< tick of the picture before; at first after all ticks
    double share{};                                ///< 0: the usual view, 1: the nearest one
    double nearest{};                              ///< field of view of the nearest one (rad)
};

struct FrameMemory {
    std::array<std::vector<render::Instance>, players> instances;
    std::array<std::vector<render::Instance>, players> spell_mists;  ///< with `mists`; empty without spells
    std::vector<render::Instance> shades, mists, fixed_casters, moving_casters;
    std::array<std::vector<render::PointLight>, players> lights;
    std::array<std::vector<render::Scan>, players> scans;
    std::array<NearView, players> near_views{};
    std::vector<render::MeshChange> changes;
    render::Frame frame;
};

/// Fills in the parts that are the same for all views: size, presets and shadows. Views and overlay stay
/// empty.
void begin_frame(const ArenaScene& arena_scene, const Picture& picture, const HudSettings& settings,
                 render::Size size, FrameMemory& memory);

/// Makes a whole frame. It stays valid in `memory` until the next call.
const render::Frame& make_frame(const ArenaScene& arena_scene, const Picture& picture,
                                const HudSettings& settings, render::Size size, FrameMemory& memory);

/// Makes only the flat part: the HUD over the views.
void make_overlay(const Picture& picture, const HudSettings& settings, render::Size size,
                  render::Overlay& out);

/// All words of the HUD over both players' views.
std::vector<std::string> words_over_views(const Simulation& match);

/// Size of the area for all views: the window above the bar of a replay.
render::Size area_of_views(const HudSettings& settings, render::Size size);

/// Rectangle of each player's view; of zero size if the view is not shown.
std::array<render::Rect, players> views_of(const HudSettings& settings, render::Size size);

/// Vertical field of view for a view of this aspect ratio (rad).
double field_of_view(double fov_degrees, double aspect);

/// Vertical field of view of a player (rad): `usual`, or narrower while the player carves, so that the crystal fills
/// most of the shorter edge of a view of this aspect ratio. `near_view` is moved on to the picture's tick.
double field_of_player(const Picture& picture, std::uint32_t player, double usual, double aspect,
                       NearView& near_view);

}  // namespace thaum::game

// game/hud/hud.h: turns a Picture into a render::Frame: each player's view with the HUD on top. Views never
// shake, bob or flash, for comfort.
#pragma once
#include <limits>

#include "game/data/control_names.h"
#include "game/data/teams.h"
#include "game/hud/frame_times.h"
#include "game/hud/prompts.h"
#include "game/hud/replay_bar.h"
#include "game/scene/arena_scene.h"
#include "game/senses/sound/heard.h"
#include "render/context.h"

namespace thaum::game::inline hud {

/// Which players' views the window shows.
enum class Watch : std::uint8_t { both, first, second };

struct HudSettings {
    render::Split split = render::Split::top_bottom;  ///< how two views share the window
    Watch watch = Watch::both;
    /// Horizontal field of view of a view of 16:9 (degrees); views of other aspect ratios show an equally
    /// large area.
    double fov = 90;
    double text_scale = 1;  ///< text size, 1 to 2.5
    render::Quality quality = render::Quality::medium;
    float resolution = 1;        ///< factor of the quality's resolution, by which views are drawn smaller
    bool bloom = true;           ///< true: bright parts have a glow, at high quality only
    bool can_play_again = true;  ///< true: the result screen offers another match
    bool has_menu = true;  ///< true: leaving a match leads to the start screen; false: it ends the program
    bool forces = false;   ///< true: shows the force on the hand as a curve, and the brew's flow
    /// times of a picture's parts, shown as a line; std::nullopt: not shown
    std::optional<FrameTimes> frame_times{};
    bool menu = false;  ///< true: a menu will cover the views, so the HUD is left out
    /// Message about a fault of each player's device, in the words of its driver. The session sets it.
    std::array<std::string, players> device_messages{};
    PlayerNames names{};
    /// for each player, true: the view has captions of what happens to the player
    std::array<bool, players> captions{true, true};
    /// For each player, which sounds and effects on the body are also shown in words.
    std::array<HeardWish, players> heard{};
    /// For each player, true: the view shows the figure of what the player feels on the body.
    std::array<bool, players> figure{true, true};
    std::array<ControlNames, players> controls{};  ///< names of each player's controls
    std::array<PromptWish, players> prompts{};     ///< when each player's prompts are shown
    PromptUses prompt_uses{};           ///< how often each player has done what each prompt asks for
    std::optional<ReplayBar> replay{};  ///< the time bar of a replay; std::nullopt: not a replay
    bool operator==(const HudSettings&) const = default;
};

/// How far a player's view has zoomed in on the crystal that the player carves.
struct NearView {
    /// Tick of the last picture. At first it is later than any tick, so that the first picture completes the
    /// zoom at once.
    Tick tick = std::numeric_limits<Tick>::max();
    double share{};    ///< progress of the zoom: 0 is the usual view, 1 the nearest one
    double nearest{};  ///< vertical field of view of the nearest view (rad)
};

/// Memory for building frames. The spans of a Frame point into this memory.
struct FrameMemory {
    std::array<std::vector<render::Instance>, players> instances;
    /// For each player, the `mists` (steam, the same in all views) together with those of spells; empty if
    /// the match has no spells.
    std::array<std::vector<render::Instance>, players> spell_mists;
    std::vector<render::Instance> shades, mists, fixed_casters, moving_casters;
    std::array<std::vector<render::PointLight>, players> lights;
    std::array<std::vector<render::Scan>, players> scans;
    std::array<NearView, players> near_views{};
    std::vector<render::MeshChange> changes;
    render::Frame frame;
};

/// Fills in the parts that are the same for all views, such as size, quality, shadows, and the state of brew
/// and stations. Leaves views and overlay empty.
void begin_frame(const ArenaScene& arena_scene, const Picture& picture, const HudSettings& settings,
                 render::Size size, FrameMemory& memory);

/// Makes a whole frame. The frame is valid until the next call, because it points into `memory`.
const render::Frame& make_frame(const ArenaScene& arena_scene, const Picture& picture,
                                const HudSettings& settings, render::Size size, FrameMemory& memory);

/// Makes only the flat part of a frame: the HUD over the views.
void make_overlay(const Picture& picture, const HudSettings& settings, render::Size size,
                  render::Overlay& out);

/// All texts that the HUD shows at present, in both players' views and over them.
std::vector<std::string> words_over_views(const Simulation& match);

/// Size of the area for all views: the window without the bar of a replay.
render::Size area_of_views(const HudSettings& settings, render::Size size);

/// Rectangle of each player's view, of size zero if the view is not shown.
std::array<render::Rect, players> views_of(const HudSettings& settings, render::Size size);

/// Vertical field of view for a view of this aspect ratio (rad).
double field_of_view(double fov_degrees, double aspect);

/// Vertical field of view of a player (rad): `usual`, or narrower while the player carves, so that the
/// crystal fills most of the shorter edge of a view of this aspect ratio. `near_view` is advanced to the
/// picture's tick.
double field_of_player(const Picture& picture, std::uint32_t player, double usual, double aspect,
                       NearView& near_view);

}  // namespace thaum::game::inline hud

// game/picture/picture.h: everything visible at one moment of a match, copied from the Simulation as plain
// data. The match can then continue while another thread draws. Copying into the same Picture again allocates
// nothing.
#pragma once
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "game/data/presentation.h"
#include "game/match/result.h"
#include "game/picture/brew_picture.h"
#include "game/picture/casting_picture.h"
#include "game/picture/gesture_wall_picture.h"
#include "game/picture/senses_picture.h"
#include "game/picture/stations_picture.h"
#include "game/picture/vitals_picture.h"
#include "game/picture/wand_picture.h"

namespace thaum::game::inline picture {

/// Key of a shape: things with equal keys look the same.
struct ShapeKey {
    Surface surface{};
    physics::Shape shape{};
    std::uint32_t mesh{};  ///< for Shape::mesh, index of the mesh in Arena::meshes
    vec3 size{};           ///< size of the body, with the meaning that its shape gives it
                           ///< (physics::BodyDesc::size)
    bool operator==(const ShapeKey&) const = default;
};

struct ThingPicture {
    std::uint32_t entity{};
    ShapeKey key{};
    bool fixed{};  ///< true for a thing that never moves
    vec3 position{};
    quat orientation{1, 0, 0, 0};
    std::uint32_t team{no_player};  ///< for a start pad: the team that starts there
};

struct MissilePicture {
    ecs::Entity entity;
    std::uint32_t player{};
    vec3 position{};
    vec3 velocity{};
    std::uint32_t wand{};  ///< index of the missile's wand in Presentation::wands
    double size{};         ///< factor on the drawn size of the missile; 0: drawn at the size of its mesh
};

/// Time for which a burst, the explosion of a missile, is shown (s).
inline constexpr double burst_seconds = 0.4;

struct BurstPicture {
    double age_s{};
    std::uint32_t player{};  ///< player who fired the shot
    vec3 place{};
    double radius{};  ///< final radius of the explosion (m)
};

/// Time for which the dust of a push spell is shown (s).
inline constexpr double push_seconds = 0.5;
/// Time for which a cast spell stays in the picture (s).
inline constexpr double cast_seconds = 1;

/// A spell that was cast a moment ago, for its effects on the screen.
struct CastShown {
    double age_s{};
    std::uint32_t player{};
    SpellSign sign{};
    double strength{};  ///< strength of the spell: 1 for a gentle stroke, more for a harsh one
    vec3 place{};       ///< middle of the caster's body (m, world)
};

/// A cloud of fog.
struct FogPicture {
    vec3 place{};
    double radius{};    ///< radius of the cloud (m)
    double sight{};     ///< length of a line of sight through the cloud beyond which nothing is seen (m)
    double strength{};  ///< opacity: 1, or less while the cloud appears and vanishes
};

/// A niche, the place of an ingredient. It holds the ingredient or is empty until the ingredient returns.
struct NichePicture {
    vec3 position{};  ///< position of the niche on the ground (m, world)
    fvec3 colour{};   ///< colour of the ingredient, linear light
    IngredientShape shape{};
    bool there{};
};

struct PowerUpPicture {
    PowerUpKind kind{};
    vec3 position{};    ///< position of the power-up on the ground (m, world)
    double returned{};  ///< 1: the power-up is present; below 1: elapsed share of its absence
};

/// What is visible of one wizard, and what only this wizard's player is shown.
struct PlayerPicture {
    VitalsPicture vitals{};
    WandPicture wand{};
    StationsPicture stations{};
    CastingPicture casting{};
    SensesPicture senses{};
};

/// An event for the list of recent events on the screen (the feed), such as a death.
struct FeedLine {
    double age_s{};
    Event event{};
    std::string_view thing{};  ///< the thing that caused the event, such as "barrel"; empty: none
};

/// The display of the practice range, instead of score and clock. The session that plays the match fills it
/// in.
struct PracticePicture {
    bool on = false;
    std::string score;  ///< text of the score, ready for display
    // Texts that may name controls (game/data/control_words.h).
    std::string below;         ///< line below the score: the dummy's behaviour, or how to leave a lesson
    std::string lesson, hint;  ///< text of the current step of the lessons, and its hint; empty: no lesson
    GestureWallPicture wall{};
};

/// One line of text for the players. The session that plays the match fills it in.
struct Caption {
    std::string words;
    bool fault = false;
};

struct Picture {
    Tick tick{};            ///< time of the picture: ticks since the start of the match, pauses included
                            ///< (Simulation::now)
    std::int64_t due_ns{};  ///< wall-clock time of `tick` (ns); filled in by the session that plays the match
    std::vector<ThingPicture> things;
    std::vector<MissilePicture> missiles;
    std::vector<PowerUpPicture> power_ups;
    std::vector<NichePicture> niches;
    CauldronPicture cauldron;
    OrbPicture orb;
    std::vector<CrystalPicture> crystals;
    std::array<PlayerPicture, players> wizards{};
    /// Keeps data alive to which the picture refers, even if the match ends.
    std::shared_ptr<const MatchData> data;
    std::shared_ptr<const Presentation>
        shown;  ///< how events and wands are shown; not null once the picture is filled in

    double played_s{}, left_s{};
    bool boils_over{};  ///< true: the time was up with equal kills, so the next death decides the round
    double surge{1};    ///< factor on the harm that the players do to each other (the mana surge)
    Phase phase{};
    Ending ending{};
    std::uint32_t winner{no_player};  ///< player who has won the round that has ended
    /// player who has won the match by more rounds; no_player: nobody
    std::uint32_t match_winner{no_player};
    std::uint32_t round{}, rounds{};  ///< index of the round, from 0, and maximum number of rounds of a match
    std::array<std::uint32_t, players> rounds_won{};
    double next_round_in_s{};
    AllMatchStats match_stats{};
    bool paused{};
    std::uint32_t paused_by{no_player};
    std::int32_t kills_to_win{};
    std::uint32_t feed_lines{};  ///< number of entries in `feed`, the oldest first
    std::array<FeedLine, 4> feed{};
    std::uint32_t burst_count{};  ///< number of entries in `bursts`, the newest first
    std::array<BurstPicture, 8> bursts{};
    std::uint32_t cast_count{};  ///< number of entries in `casts`, the newest first
    std::array<CastShown, 4> casts{};
    std::vector<FogPicture> fogs;
    std::uint32_t skipped{};  ///< number of device samples skipped so far, because the simulation was late
    int countdown{};       ///< seconds to the start of the match; 0: it has begun; the session that plays the
                           ///< match fills it in
    std::uint32_t mark{};  ///< number of a mark (bookmark in the log) that was set just now; 0: none; filled
                           ///< in by the session
    /// true: device samples were skipped just now, because the simulation was late; filled in by the session
    bool overloaded{};
    PracticePicture practice{};
    Caption caption{};
};

/// Creates a Picture with memory for a busy match, so that filling it in needs no more.
Picture make_picture();

void take_picture(const Simulation& match, Picture& out);

/// Seconds to the start of the match or of the next round, shown as a countdown in every view; 0: nothing
/// starts soon.
int seconds_to_start(const Picture& picture);

/// Interpolates between two pictures, `alpha` in [0, 1]. Things that are not in both pictures, or that moved
/// farther than possible (a respawn), have their position from `to`. So have all values that are not
/// interpolated.
void interpolate(const Picture& from, const Picture& to, double alpha, Picture& out);

}  // namespace thaum::game::inline picture

// game/picture/picture.h: everything visible at one moment of a match, copied from the Simulation as plain data.
// The match can then go on while another thread draws. Taking a picture into the same Picture again allocates
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

namespace thaum::game {

/// Things with equal keys look the same.
struct ShapeKey {
    Surface surface{};
    physics::Shape shape{};
    std::uint32_t mesh{};  ///< index in Arena::meshes, for Shape::mesh
    vec3 size{};           ///< size, defined like physics::BodyDesc::size
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
    std::uint32_t wand{};  ///< index of its wand in Presentation::wands
    double size{};         ///< scale of the look; 0: the look has its own size
};

/// Time for which a burst is shown.
inline constexpr double burst_seconds = 0.4;

struct BurstPicture {
    double age_s{};
    std::uint32_t player{};  ///< player who fired the shot
    vec3 place{};
    double radius{};  ///< final radius of the burst (m)
};

/// Time for which the dust of a push is shown.
inline constexpr double push_seconds = 0.5;
/// Time for which a cast is in the picture.
inline constexpr double cast_seconds = 1;

/// A spell that was cast just now.
struct CastShown {
    double age_s{};
    std::uint32_t player{};
    SpellSign sign{};
    double strength{};  ///< 1 for a gentle stroke
    vec3 place{};       ///< middle of the caster's body
};

/// A cloud of fog.
struct FogPicture {
    vec3 place{};
    double radius{};    ///< (m)
    double sight{};     ///< length of a way through the cloud from which on nothing is seen (m)
    double strength{};  ///< 1, less while it appears and while it vanishes
};

/// A place with an ingredient, or one that waits for its ingredient to return.
struct NichePicture {
    vec3 position{};  ///< position on the ground
    fvec3 colour{};   ///< colour of the ingredient, linear light
    IngredientShape shape{};
    bool there{};
};

struct PowerUpPicture {
    PowerUpKind kind{};
    vec3 position{};    ///< position on the ground
    double returned{};  ///< 1: present; below 1: elapsed share of the absence
};

/// What is seen of one wizard, and what the player knows.
struct PlayerPicture {
    VitalsPicture vitals{};
    WandPicture wand{};
    StationsPicture stations{};
    CastingPicture casting{};
    SensesPicture senses{};
};

/// An event whose row has words for the feed, such as a death.
struct FeedLine {
    double age_s{};
    Event event{};
    std::string_view thing{};  ///< the thing that caused it, such as "barrel"; empty: no thing
};

/// The display of the practice range, in place of score and clock. The session fills it in.
struct PracticePicture {
    bool on = false;
    std::string score;  ///< text ready to be shown
    // Words that may name controls (game/data/control_words.h).
    std::string below;         ///< line below the score: the dummy, or the ways out of a lesson
    std::string lesson, hint;  ///< the Apprentice's present step; empty: no lesson
    GestureWallPicture wall{};
};

/// One line of text for the players. The session fills it in.
struct Caption {
    std::string words;
    bool fault = false;
};

struct Picture {
    Tick tick{};            ///< Simulation::now
    std::int64_t due_ns{};  ///< wall-clock time of that tick; filled in by the session
    std::vector<ThingPicture> things;
    std::vector<MissilePicture> missiles;
    std::vector<PowerUpPicture> power_ups;
    std::vector<NichePicture> niches;
    CauldronPicture cauldron;
    OrbPicture orb;
    std::vector<CrystalPicture> crystals;
    std::array<PlayerPicture, players> wizards{};
    std::shared_ptr<const MatchData> data;  ///< keeps what the picture refers to, although the match may end
    std::shared_ptr<const Presentation>
        shown;  ///< rows of events and looks of wands; never null after taking

    double played_s{}, left_s{};
    Phase phase{};
    Ending ending{};
    std::uint32_t winner{no_player};        ///< winner of the round that has ended
    std::uint32_t match_winner{no_player};  ///< player with more rounds won
    std::uint32_t round{}, rounds{};        ///< index of the round, from 0, and the most rounds of a match
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
    std::uint32_t skipped{};  ///< number of samples left out so far
    int countdown{};       ///< seconds to the start of the match; 0: it has begun; filled in by the session
    std::uint32_t mark{};  ///< number of a mark set just now; 0: none; filled in by the session
    bool overloaded{};     ///< samples were left out just now; filled in by the session
    PracticePicture practice{};
    Caption caption{};
};

/// Makes a Picture with memory for a busy match, so that later pictures need no more.
Picture make_picture();

void take_picture(const Simulation& match, Picture& out);

/// Seconds to the start of the match or of the next round, to be counted in every view; 0: nothing starts soon.
int seconds_to_start(const Picture& picture);

/// Interpolates between two pictures, `alpha` in [0, 1]. Anything that is not in both, or that moved farther
/// than anything can (a respawn), has its place from `to`. All values that are not interpolated come from
/// `to`.
void interpolate(const Picture& from, const Picture& to, double alpha, Picture& out);

}  // namespace thaum::game

// game/hud/picture.h: all that one moment of a match looks like, copied out of the Simulation as plain data, so that the
// match goes on while another thread draws. Taking a picture into the same Picture again allocates nothing.
#pragma once
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "game/hud/brew_picture.h"
#include "game/match/arm.h"
#include "game/match/result.h"
#include "haptics/safety.h"

namespace thaum::game {

/// Things of equal shape and surface look the same.
struct ShapeKey {
    Surface surface{};
    physics::Shape shape{};
    std::uint32_t mesh{};  ///< index in Arena::meshes, of Shape::mesh
    vec3 size{};           ///< as physics::BodyDesc::size
    bool operator==(const ShapeKey&) const = default;
};

struct ThingPicture {
    std::uint32_t entity{};
    ShapeKey key{};
    bool fixed{};  ///< never moves
    vec3 position{};
    quat orientation{1, 0, 0, 0};
    std::uint32_t team{no_player};  ///< of a pad: who starts there
};

struct MissilePicture {
    ecs::Entity entity;
    std::uint32_t player{};
    vec3 position{};
    vec3 velocity{};
    MissileLook look{};
    double size{};  ///< m, radius of what is round
};

/// How long a burst is seen.
inline constexpr double burst_seconds = 0.4;

struct BurstPicture {
    double age_s{};
    std::uint32_t player{};  ///< whose shot it was
    vec3 place{};
    double radius{};  ///< m, how far it reaches
};

/// Something to be picked up, or the place where it will be.
struct NichePicture {
    vec3 position{};  ///< on the ground
    fvec3 colour{};   ///< linear, of what is found there
    bool there{};
};

struct PowerUpPicture {
    PowerUpKind kind{};
    vec3 position{};    ///< on the ground
    double returned{};  ///< 1: there; less: the share of its absence that is over
};

/// How long a mark shows where a hurt came from.
inline constexpr double mark_seconds = 1.2;

/// Something that hurt a player a short time ago.
struct HurtMark {
    double age_s{};
    EventKind how{};
    vec3 towards{};  ///< unit, world: from the victim to where it came from; zero where that is unknown
};

/// Ticks whose strongest force is one column of the plot.
inline constexpr std::size_t force_column = 16;

/// What a player's hand has felt.
struct ForcePicture {
    ArmCondition arm{};            ///< of a real one
    haptics::SafetyCause cause{};  ///< why it feels less than it should
    double cap{};                  ///< N, the most it can feel
    vec3 now{};                    ///< N, in the frame of the eye
    double created{};              ///< J, the most that passive sources ever gave more than they got
    /// N, the strongest of each column, the oldest first; without the one that still fills.
    std::array<float, std::tuple_size_v<ForceTrace> / force_column - 1> strongest{};
};

struct PlayerPicture {
    vec3 centre{};  ///< of the body, m
    vec3 eye{};     ///< m
    double yaw{}, pitch{};
    bool dead{}, shielded{};
    std::uint32_t lives{};  ///< counts deaths; one more or less is a teleport

    double health{}, health_full{}, health_cap{};  ///< HP
    std::string_view wand;                         ///< kind in hand; empty: none
    Silhouette silhouette{};                       ///< of it
    double energy{}, energy_cap{};
    double readiness{};  ///< 0 to 1, how far the wand is charged or drawn
    std::int32_t kills{}, deaths{};
    double returns_in_s{};  ///< while dead
    double since_hit_s{};   ///< since this player last hurt the other
    double since_dry_s{};   ///< since the wand last had too little energy
    double since_gift_s{};  ///< since this player last picked something up
    PowerUpKind gift{};
    double gift_amount{};        ///< HP or energy
    std::string_view carries{};  ///< the ingredient; empty: none
    bool stirs{};                ///< the ladle in hand
    bool at_rim{};               ///< could stir
    vec3 wand_turn{};            ///< rad, axis times angle, likewise: how the stylus turns it about its tip
    vec3 wand_reach{};           ///< m, in the frame of the eye: how far the hand has moved the wand's tip
    std::optional<vec3> held{};  ///< m: what the wand holds or hangs on
    ForcePicture force{};
    std::uint32_t hurts{};  ///< of `marks`
    std::array<HurtMark, 6> marks{};
};

/// A death, for the kill feed.
struct FeedLine {
    double age_s{};
    std::uint32_t victim{}, by{no_player};
    EventKind how{};
};

/// Of the range, instead of score and clock; filled by the session.
struct PracticePicture {
    bool on = false;
    std::string score, dummy;  ///< ready to be shown
};

/// One line for whoever plays; filled by the session.
struct Caption {
    std::string words;
    bool fault = false;
};

struct Picture {
    Tick tick{};            ///< Simulation::now
    std::int64_t due_ns{};  ///< the wall clock's time of that tick; filled by the session
    std::vector<ThingPicture> things;
    std::vector<MissilePicture> missiles;
    std::vector<PowerUpPicture> power_ups;
    std::vector<NichePicture> niches;
    CauldronPicture cauldron;
    std::array<PlayerPicture, players> wizards{};

    double played_s{}, left_s{};
    Phase phase{};
    Ending ending{};
    std::uint32_t winner{no_player};        ///< of the round that has ended
    std::uint32_t match_winner{no_player};  ///< who has won more rounds
    std::uint32_t round{}, rounds{};        ///< the first is 0; at most so many
    std::array<std::uint32_t, players> rounds_won{};
    double next_round_in_s{};
    DeedsOfAll deeds{};
    bool paused{};
    std::uint32_t paused_by{no_player};
    std::int32_t kills_to_win{};
    std::uint32_t feed_lines{};  ///< of `feed`, the oldest first
    std::array<FeedLine, 4> feed{};
    std::uint32_t burst_count{};  ///< of `bursts`, the newest first
    std::array<BurstPicture, 8> bursts{};
    std::uint32_t skipped{};  ///< samples left out so far
    std::uint32_t mark{};     ///< number of a mark made just now; 0: none; filled by the session
    bool overloaded{};        ///< samples were left out just now; filled by the session
    PracticePicture practice{};
    Caption caption{};
};

/// Memory for a busy match, so that no later picture needs more.
Picture make_picture();

void take_picture(const Simulation& match, Picture& out);

/// What lies between two pictures, `alpha` in [0, 1] from the first to the second. What was not in both, or moved
/// farther than anything can (a resurrection), stands where the second one has it. Everything else is the second's.
void interpolate(const Picture& from, const Picture& to, double alpha, Picture& out);

}  // namespace thaum::game

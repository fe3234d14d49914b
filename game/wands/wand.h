// game/wands/wand.h: a wand is one data file (assets/wands/NAME.toml) and one .cpp here that registers a WandKind. The
// rest of the game knows wands only by this list, so a new one touches no other file.
#pragma once
#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/config.h"
#include "ecs/schedule.h"
#include "game/components/wizard.h"

namespace thaum::game {

struct Stage;

/// How a wand looks from afar, so that one sees what the other has in hand.
enum class Silhouette : std::uint8_t { needle, forked, hooked, stubby, sling };
inline constexpr std::array<std::string_view, 5> silhouette_names{"needle", "forked", "hooked", "stubby",
                                                                  "sling"};

/// What every wand has.
struct WandStats {
    std::uint32_t slot{};         ///< 0..4, the key it is on
    std::uint32_t energy_slot{};  ///< whose energy it uses: its own, or that of the wand it shares it with
    Silhouette silhouette{};
    double energy_cap{};
    double energy_cost{};    ///< of one use, at least
    double energy_regain{};  ///< per second
};

struct WandUse {
    Stage& stage;
    ecs::Entity wizard;
    Tick tick;  ///< of play
    const WandStats& stats;
    const void* data;  ///< what `read` made
};

struct WandSystems {
    Stage& stage;
    ecs::Schedule& schedule;
};

/// What a missile looks like.
enum class MissileLook : std::uint32_t { needle, fireball, stone };

/// Something that a wand has sent off, for the picture and for bots to see.
struct Missile {
    ecs::Entity entity;
    vec3 position{};  ///< m
    vec3 velocity{};  ///< m/s
    std::uint32_t player{};
    MissileLook look{};
    double size{};  ///< m, radius of what is round
};

/// How a wand's shots go, for who aims.
struct ShotKind {
    double speed{};   ///< m/s
    double fall{};    ///< m/s^2, downwards
    double radius{};  ///< m, in which it hurts where it strikes
    double energy{};  ///< that it takes
    bool held{};      ///< it is readied while fire is held, and goes when it is let go
};

/// How a wand takes up loose things and throws them, for who means to.
struct GraspKind {
    double reach{};               ///< m from the eye
    double mass_max{};            ///< kg
    double speed{};               ///< m/s, of a throw, at most
    double energy_per_impulse{};  ///< for 1 N s of a throw
    double crossing{};            ///< m from the eye: where a throw meets the crosshair
};

/// What a wand's rope latches on.
struct RopeKind {
    double reach{};    ///< m from the eye
    double aim_cos{};  ///< of the angle between crosshair and anchor, at least
};

/// Where a wand's tip is, in the frame of the eye, m.
inline constexpr vec3 wand_tip{0.22, -0.2, -0.75};

struct WandKind {
    std::string_view name;
    /// The wand's own numbers, shared by all matches of this data.
    std::shared_ptr<const void> (*read)(const ConfigTable& root);
    /// Declares its components.
    void (*declare)(ecs::World&);
    /// Gives a new wizard the components it needs to use this wand.
    void (*outfit)(ecs::World&, ecs::Entity wizard);
    /// Every gameplay tick, for every living wizard who has this wand in hand.
    void (*use)(const WandUse&);
    /// Once when another wand is taken in hand, and while who holds it is dead: ends what was begun.
    void (*put_away)(const WandUse&);
    /// What `use` and `put_away` write beyond WandBelt.
    ecs::Mask (*writes)(const ecs::World&);
    /// The systems that push bodies by it: every tick, after the hand was felt and before the bodies move.
    void (*add_forces)(const WandSystems& to, const void* data);
    /// The systems that move what it has shot.
    void (*add_systems)(const WandSystems& to, const void* data);
    /// Calls back for every missile in flight.
    void (*show)(const ecs::World&, const std::function<void(const Missile&)>&);
    /// The point, m, that this wizard holds or hangs on by it; nothing where there is none.
    std::optional<vec3> (*held_at)(const ecs::World&, ecs::Entity wizard);
    /// While it holds something the wheel moves that, and does not change wands.
    bool moves_by_wheel = false;
    /// A shot that was readied to that share, 0 to 1. Null: the wand does not shoot.
    ShotKind (*shot)(const void* data, double readiness) = nullptr;
    /// How far it is charged or drawn, 0 to 1. Null: nothing of it grows.
    double (*readiness)(const ecs::World&, ecs::Entity wizard) = nullptr;
    /// Null: it takes nothing up.
    GraspKind (*grasp)(const void* data) = nullptr;
    /// Null: it has no rope.
    RopeKind (*rope)(const void* data) = nullptr;
};

/// Registers a kind for the life of the program.
struct WandRegistration {
    explicit WandRegistration(const WandKind& kind);
};

/// All kinds, by name.
const std::vector<WandKind>& wand_kinds();

struct LoadedWand {
    const WandKind* kind{};
    WandStats stats;
    std::shared_ptr<const void> data;
};

LoadedWand read_wand(const WandKind& kind, const Config& file);

/// m/s, at which `energy` throws a thing of `mass` kg that rests.
double throw_speed(const GraspKind& grasp, double mass, double energy);

/// True, and the energy is taken, where the wand in hand has enough; of the amount, or of one use.
bool spend(WandBelt& belt, const WandStats& stats, double amount);
bool spend(WandBelt& belt, const WandStats& stats);

}  // namespace thaum::game

// game/data/wand.h: the interface of wands. A kind of wand is one .cpp in game/wands that registers a
// WandKind, with the data file assets/wands/KIND.toml. The rest of the game uses wands only through this
// interface, so a new kind changes no other file. Further wands of a kind are data files alone: they say
// `kind = "bolt"`. Their hits are those of the kind, whose own file says how these are shown.
#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/config.h"
#include "core/registry.h"
#include "ecs/schedule.h"
#include "game/components/wizard.h"
#include "game/data/event_kinds.h"
#include "game/data/registration.h"
#include "game/data/wand_look.h"

namespace thaum::game::inline context {
struct MatchContext;
}

namespace thaum::game::inline data {

/// Numbers that every wand has in its data file.
struct WandStats {
    std::uint32_t slot{};         ///< slot and key, 0 to wand_slots - 1
    std::uint32_t energy_slot{};  ///< slot whose energy the wand uses: its own, or that of another wand
    double energy_cap{};
    double energy_cost{};    ///< minimum energy of one use
    double energy_regain{};  ///< energy regained per second
};

/// Arguments of WandRules::use and WandRules::put_away.
struct WandUse {
    MatchContext& context;
    ecs::Entity wizard;
    Tick tick;  ///< current tick of play
    const WandStats& stats;
};

/// Arguments with which a wand adds its systems.
struct WandSystems {
    MatchContext& context;
    ecs::Schedule& schedule;
};

/// A missile in flight, as the renderer and bots see it.
struct Missile {
    ecs::Entity entity;
    vec3 position{};  ///< position (m, world)
    vec3 velocity{};  ///< velocity (m/s, world)
    std::uint32_t player{};
    double size{};  ///< scale of the missile's look; 0: unscaled
};

/// Flight of a wand's shots, for bots that aim.
struct ShotKind {
    double speed{};   ///< speed at the muzzle (m/s)
    double fall{};    ///< downward acceleration of the shot (m/s^2)
    double radius{};  ///< radius within which the impact does harm (m)
    double energy{};  ///< energy of the shot
    bool held{};  ///< true: the wand charges or is drawn while fire is held, and shoots when fire is released
    double liking{1};  ///< how often bots choose this wand, relative to a similar wand with the value 1
};

/// How a wand takes up and throws loose things, for bots.
struct GraspKind {
    double reach{};               ///< reach of the wand from the eye (m)
    double max_mass{};            ///< largest mass that the wand can take up (kg)
    double speed{};               ///< largest speed of a throw (m/s)
    double energy_per_impulse{};  ///< energy per impulse of a throw (1/(N s))
    double crossing{};  ///< distance from the eye at which a throw's path crosses the line of sight (m)
};

/// How a wand's rope is attached, for bots.
struct RopeKind {
    double reach{};    ///< reach of the rope from the eye (m)
    double aim_cos{};  ///< cosine of the largest angle between crosshair and anchor (the point to attach to)
};

/// Kind of the thing under the crosshair, by what the wand would do with it.
enum class TargetKind : std::uint8_t {
    nothing,
    foe,        ///< the other wizard, for a wand that shoots
    take,       ///< a thing that can be taken up
    too_far,    ///< a thing that is out of reach
    too_heavy,  ///< a thing that is too heavy
    hook,       ///< a point that a rope can hold on to
};

/// The thing under the crosshair, as a wand sees it.
struct Target {
    TargetKind kind{};
    /// The loose thing under the crosshair, for take, too_far and too_heavy. For hook, the anchor (a point
    /// made for ropes), if the rope would hold on to one.
    ecs::Entity thing{};
    double mass{};  ///< mass of the loose thing under the crosshair (kg)
    /// Mass of the loose thing under the crosshair as a share of the largest mass that the wand takes.
    double mass_share{};
};

/// Position of the wand's tip for a hand at rest (m, in the frame of the wizard's eye).
inline constexpr vec3 wand_tip{0.22, -0.2, -0.75};

/// Rules of one wand with the numbers of its data file: what the wand does, and what bots and pictures may
/// know of it. The wand's state is in the World, so all matches with the same data share this object. A wand
/// overrides only the functions that it needs.
class WandRules {
public:
    WandRules() = default;
    WandRules(const WandRules&) = delete;
    WandRules& operator=(const WandRules&) = delete;
    virtual ~WandRules() = default;

    /// Adds to a new wizard the components that this kind of wand needs. Called for one wand of each kind.
    virtual void outfit(ecs::World& world, ecs::Entity wizard) const = 0;
    /// Uses the wand. Called every gameplay tick for each living wizard who has it in hand and does not work
    /// at a station (cauldron, orb or crystal).
    virtual void use(const WandUse& use) const = 0;
    /// Ends the use of the wand, such as charging or holding. Called once when another wand is selected, and
    /// every gameplay tick while the wizard is dead or works at a station (cauldron, orb or crystal).
    virtual void put_away(const WandUse&) const {}
    /// Components and resources that `use` and `put_away` write, besides WandBelt (the wizard's wands with
    /// their energy).
    virtual ecs::Mask writes(const ecs::World& world) const = 0;
    /// Adds systems that push bodies. They run every tick, after the servo step (the forces on the hands) and
    /// before bodies move.
    virtual void add_forces(const WandSystems&) const {}
    /// Adds systems that move the wand's missiles.
    virtual void add_missiles(const WandSystems&) const {}

    /// Calls the function once for every missile in flight. Used by pictures and bots.
    virtual void show(const ecs::World&, const std::function<void(const Missile&)>&) const {}
    /// The point at which the wizard holds a thing with the wand, or from which the wizard hangs by a rope
    /// (m, world); std::nullopt if there is none.
    virtual std::optional<vec3> held_at(const ecs::World&, ecs::Entity) const { return std::nullopt; }
    /// The loose thing that the wizard holds with the wand; an invalid entity if there is none.
    virtual ecs::Entity held_thing(const ecs::World&, ecs::Entity) const { return {}; }
    /// Takes hold of a loose thing that has reached the wizard's hand, as `use` would. Returns false if the
    /// wand cannot. Writes the same components as `use`.
    virtual bool catch_thing(const WandUse&, ecs::Entity) const { return false; }
    /// Whether the mouse wheel moves the held thing at present instead of selecting wands.
    virtual bool moves_by_wheel() const { return false; }
    /// Returns the thing under the crosshair that the wand would take hold of, or the reason why it would
    /// not.
    virtual Target target(const MatchContext&, ecs::Entity) const { return {}; }
    /// Force of the wand (N): the weight of the thing that it holds, or the tension of its rope; 0: nothing
    /// is held. `gravity`: downward acceleration in the match (m/s^2).
    virtual double holding_force(const ecs::World&, ecs::Entity, double /*gravity*/) const { return 0; }
    /// Current charge or draw of the wand, 0 to 1; std::nullopt while it is neither charged nor drawn.
    virtual std::optional<double> readiness(const ecs::World&, ecs::Entity) const { return std::nullopt; }
    /// The shot of the wand when it is charged or drawn to `readiness`, 0 to 1; std::nullopt if the wand does
    /// not shoot. `gravity`: downward acceleration in the match (m/s^2).
    virtual std::optional<ShotKind> shot(double /*readiness*/, double /*gravity*/) const {
        return std::nullopt;
    }
    /// How the wand takes things up; std::nullopt if it does not.
    virtual std::optional<GraspKind> grasp() const { return std::nullopt; }
    /// The wand's rope; std::nullopt if it has none.
    virtual std::optional<RopeKind> rope() const { return std::nullopt; }
};

/// One kind of wand, as its .cpp registers it.
struct WandKind {
    std::string_view name;        ///< name of the kind and of its own file assets/wands/NAME.toml
    std::vector<HitKind> hits{};  ///< kinds of hit by which the wand takes health
    /// Declares the wand's components.
    void (*declare)(ecs::World&);
    /// Reads the numbers that only this kind of wand has. `slot`: slot of the wand, by which its missiles and
    /// the states of hands name it, since several wands may be of one kind.
    std::shared_ptr<const WandRules> (*read)(const ConfigTable& root, std::uint32_t slot);
};

/// Registers a kind of wand when the program starts.
using WandRegistration = Registration<WandKind>;

/// All kinds, sorted by name.
inline const std::vector<WandKind>& wand_kinds() { return registry_of<WandKind>().all(); }

/// A kind of wand with the numbers from its data file.
struct LoadedWand {
    std::string name;  ///< name of the wand and of its file
    const WandKind* kind{};
    WandStats stats{};
    std::shared_ptr<const WandRules> rules{};
    WandLook look{};
};

/// Reads the wand of this name. If its kind is unknown, reports that and returns a wand without rules.
LoadedWand read_wand(std::string name, const Config& file);

/// Speed to which `energy` accelerates a thing of `mass` kg from rest when it is thrown (m/s).
double throw_speed(const GraspKind& grasp, double mass, double energy);

/// Takes the given amount of energy, or the wand's cost of one use. Returns false and takes nothing if there
/// is too little energy.
bool spend(WandBelt& belt, const WandStats& stats, double amount);
bool spend(WandBelt& belt, const WandStats& stats);

}  // namespace thaum::game::inline data

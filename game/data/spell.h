// game/data/spell.h: the interface of spells. A kind of spell is one .cpp in game/spells that registers a
// SpellKind, with the data file assets/spells/KIND.toml. The rest of the game uses spells only through this
// interface, so a new kind changes no other file. Further spells of a kind are data files alone. Keys that
// every spell's file has:
//
//     kind = "shield"       # the kind; may be left out if it is the file's name
//     slot = 1              # wand key that casts it without a stroke, while Trace is held
//     gesture = "circle"    # name of a file of assets/gestures
//     focus = 25            # focus of a gentle cast
//     [[effect]]            # what it does to its caster, if anything (data/effect.h)
//     [event]               # changes no match
//     sound = ""            # name of a sound of assets/sounds, heard when the spell is cast
//     tactile = ""          # name of an effect on the caster's body (assets/tactile/effects)
//     [look]                # changes no match
//     shown = "Shield"
//     sign = "shell"        # what is seen in the world: none, shell, beads or dust (data/presentation.h)
#pragma once
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/config.h"
#include "core/registry.h"
#include "ecs/schedule.h"
#include "game/components/wizard.h"
#include "game/data/effect.h"
#include "game/data/registration.h"

namespace thaum::game::inline context {
struct MatchContext;
}

namespace thaum::game::inline data {

/// Numbers that every spell has in its data file.
struct SpellStats {
    /// Wand key that casts the spell without a stroke while the button Trace is held, 0 to wand_slots - 1.
    std::uint32_t slot{};
    std::string gesture;  ///< name of the gesture that casts it
    double focus{};       ///< focus (what spells cost) that a gentle cast takes
    std::string shown;    ///< name on the screen
};

/// Arguments of SpellRules::cast.
struct SpellCast {
    MatchContext& context;
    ecs::Entity wizard;
    Tick tick;          ///< current tick of play
    double strength{};  ///< 1 for a gentle stroke, more for a harsh (forceful) one
};

/// Arguments with which a spell adds its systems.
struct SpellSystems {
    MatchContext& context;
    ecs::Schedule& schedule;
};

/// Situation of a bot that considers a spell, as far as the bot knows it.
struct SpellOccasion {
    double focus{};           ///< remaining focus (what spells cost), as a share of the maximum
    double health{};          ///< remaining health, as a share of a new wizard's
    bool under_fire{};        ///< true: the foe has hurt the bot a moment ago
    bool warded{};            ///< true: the bot has a shield
    bool sees_foe{};          ///< true: the bot sees the foe
    double foe_distance{};    ///< distance of the foe (m)
    double foe_aside{};       ///< angle between the view direction and the foe (rad)
    bool foe_at_edge{};       ///< true: a push would throw the foe over an edge
    double thing_distance{};  ///< distance of the thing that the bot took up last (m); 0: none
};

/// Rules of one spell with the numbers of its data file. Its state in a match is in the World.
class SpellRules {
public:
    SpellRules() = default;
    SpellRules(const SpellRules&) = delete;
    SpellRules& operator=(const SpellRules&) = delete;
    virtual ~SpellRules() = default;

    /// Returns why the spell would do nothing now, in words for the wizard ("the thing is too far away"); an
    /// empty text if the spell can be cast. The text must stay valid as long as the rules.
    virtual std::string_view refusal(const MatchContext&, ecs::Entity) const { return {}; }
    /// Does what the spell does besides its effects on the caster. The caller has already taken the focus
    /// that the spell costs, and begins the effects afterwards.
    virtual void cast(const SpellCast&) const {}
    /// Components and resources that `cast` writes, and that `refusal` and `cast` read.
    virtual ecs::Mask writes(const ecs::World&) const { return {}; }
    virtual ecs::Mask reads(const ecs::World&) const { return {}; }
    /// Value of the spell to a bot now, 0 to 1; 0: useless.
    virtual double worth(const SpellOccasion&) const { return 0; }
    /// Whether the spell brings a thing to its wizard's hand, so that a bot prepares to catch it.
    virtual bool brings_thing() const { return false; }
    /// Adds systems for lasting effects of the spell in the world.
    virtual void add_systems(const SpellSystems&) const {}
};

/// One kind of spell, as its .cpp registers it.
struct SpellKind {
    std::string_view name;  ///< name of the kind and of its own file assets/spells/NAME.toml
    /// Declares the spell's components.
    void (*declare)(ecs::World&);
    /// Reads the numbers that only this kind of spell has. `number`: number of the spell, by which states in
    /// the World name it, since several spells may be of one kind.
    std::shared_ptr<const SpellRules> (*read)(const ConfigTable& root, std::uint32_t number);
};

/// Registers a kind of spell when the program starts.
using SpellRegistration = Registration<SpellKind>;

/// All kinds, sorted by name.
inline const std::vector<SpellKind>& spell_kinds() { return registry_of<SpellKind>().all(); }

/// A kind of spell with the numbers from its data file.
struct LoadedSpell {
    std::string name;  ///< name of the spell and of its file
    const SpellKind* kind{};
    SpellStats stats{};
    std::shared_ptr<const SpellRules> rules{};
    EffectList effects{};  ///< what the spell does to its caster, besides SpellRules::cast
};

/// Reads the spell of this name and number. If its kind is unknown, reports that and returns a spell without
/// rules.
LoadedSpell read_spell(std::string name, std::uint32_t number, const Config& file);

/// Name of a spell by its number; empty for a number without a spell.
std::string_view name_of_spell(std::span<const LoadedSpell> spells, std::uint32_t number);

}  // namespace thaum::game::inline data

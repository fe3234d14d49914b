// game/data/effect.h: effects, which are all that potions, spells, power-ups, the orb and crystals do to the
// wizard who gets them. The data file of each of these lists its effects:
//
//     [[effect]]
//     kind = "pace"      # a source file of game/effects, which registers an EffectKind
//     factor = 1.3       # a key that only this kind has
//     lasts_s = 15       # of each kind that acts for a time (EffectKind::lasts)
//
// A new kind is one source file, and then each list may have it. context/effects.h begins and ends effects.
// Several effects on one wizard:
//
// - Different entries of lists act side by side, those of one kind, too. Their factors (Factors) multiply.
// - An entry that is given again while it acts begins anew: it acts to its new end, once.
// - Poison, a shield and a poisoned lob are single states of a wizard: the one that came last counts.
#pragma once
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/config.h"
#include "core/registry.h"
#include "ecs/world.h"
#include "game/components/effects.h"
#include "game/components/potions.h"

namespace thaum::game::inline context {
struct MatchContext;
}

namespace thaum::game::inline data {

struct MatchData;

/// Arguments of an effect's functions.
struct EffectUse {
    MatchContext& context;
    ecs::Entity wizard;
    /// 1; more for a spell by a harsh (forceful) stroke. The effect is stronger by this factor.
    double strength{1};
    Tick lasts{};  ///< time for which the effect acts from its beginning (ticks); 0: it acts at once only
    Tick tick{};   ///< number of the present tick of play
    vec3 place{};  ///< where the wizard got the effect (m, world); for events
};

/// Numbers of a wizard that an effect multiplies while it acts.
struct Factors {
    double pace{1};     ///< factor on the walking speed
    double gravity{1};  ///< share of the wizard's weight that is left
    double harm{1};     ///< share of each harm that the wizard takes

    Factors& operator*=(const Factors& other) {
        pace *= other.pace, gravity *= other.gravity, harm *= other.harm;
        return *this;
    }
};

/// A factor as it is at some strength (EffectUse::strength): its distance from 1 grows by the strength. Never
/// below 0.
double strengthened(double factor, double strength);

/// How much a bot wants something: 0: not at all, 1: nothing is left of it.
struct BotNeeds {
    double health{}, energy{};
};

/// One effect with the numbers of its entry in a data file. Its state in a match is in the World.
///
/// All functions that take an EffectUse may read Wizard, Motion and Dead, and may record events.
class Effect {
public:
    Effect() = default;
    Effect(const Effect&) = delete;
    Effect& operator=(const Effect&) = delete;
    virtual ~Effect() = default;

    /// Called when a wizard gets the effect, also if it acts already.
    virtual void begin(const EffectUse&) const {}
    /// Called every gameplay tick while the effect acts on a living wizard.
    virtual void step(const EffectUse&) const {}
    /// Called when the last effect of this kind stops acting on a living wizard.
    virtual void over(const EffectUse&) const {}
    /// Called for one effect of each kind when the wizard has died, whether or not the wizard had any.
    virtual void lost(const EffectUse&) const {}
    /// Numbers of the wizard that the effect multiplies while it acts.
    virtual Factors factors(double /*strength*/) const { return {}; }
    /// What the wizard would gain by begin() now (HP, energy or focus); 0 for effects without such an amount.
    /// Reads what begin() writes.
    virtual double gain(const EffectUse&) const { return 0; }
    /// Value to a bot of a power-up with the effect; 0: the bot does not fetch it.
    virtual double worth(const BotNeeds&) const { return 0; }
    /// Components and resources of the World that the functions write, besides Effects, EventLog and
    /// resource::Journal.
    virtual ecs::Mask writes(const ecs::World&) const { return {}; }
};

/// A kind of effect, as its source registers it.
struct EffectKind {
    std::string_view name;
    /// True: its entries have the key `lasts_s`, and it acts for that time. False: begin() does all, and may
    /// set a state that ends by itself, such as a shield, or by lost().
    bool lasts = false;
    /// True: a wizard takes a power-up for it although it does not last and gives no amount (gain()).
    bool worth_taking = false;
    /// Declares components that only this kind has; null: it has none.
    void (*declare)(ecs::World&) = nullptr;
    /// Reads the keys that only this kind has from an entry of a list.
    std::shared_ptr<const Effect> (*read)(const ConfigTable& entry);
};

/// Registers a kind of effect when the program starts.
using EffectRegistration = Registration<EffectKind>;

/// EffectKind::read for an effect that is made of its entry's table.
template <class OfKind>
std::shared_ptr<const Effect> read_effect(const ConfigTable& entry) {
    return std::make_shared<OfKind>(entry);
}

/// All kinds of effect, sorted by name.
inline const std::vector<EffectKind>& effect_kinds() { return registry_of<EffectKind>().all(); }

/// One entry of a list of effects.
struct ListedEffect {
    const EffectKind* kind{};
    std::shared_ptr<const Effect> rules{};
    Tick lasts{};                     ///< time for which it acts (ticks); 0: it acts at once only
    std::uint32_t number{};           ///< its index in MatchData::effects and in the arrays of Effects
    std::uint32_t potion{no_potion};  ///< number of the potion that has it; no_potion: it is no potion's
    std::string giver{};              ///< name of what has it, such as "haste"
};

/// What a potion, a spell, a power-up, the orb or a crystal does to its wizard.
using EffectList = std::vector<ListedEffect>;

/// Reads the list `effect` of a table; empty if there is none.
EffectList read_effects(const ConfigTable& holder);

/// Numbers the effects of all lists of a match and fills MatchData::effects with them: those of potions,
/// spells and power-ups, then those of the orb and of crystals. Fails if there are more than max_effects.
Expected<void> number_effects(MatchData& data);

/// Whether a wizard takes a power-up for one of the effects, whatever amount they give.
bool is_worth_taking(const EffectList& list);
/// Whether a list has an effect of this kind.
bool has_kind(const EffectList& list, std::string_view kind);
/// Time for which the longest of the effects acts (ticks).
Tick longest_of(const EffectList& list);
/// Tick of play at which the last of the effects stops acting on a wizard; 0: none acts.
Tick end_of(const EffectList& list, const Effects& effects);
/// Product of the factors of all effects that act on a wizard. `all`: MatchData::effects. `effects` may be
/// null.
Factors factors_of(std::span<const ListedEffect> all, const Effects* effects, Tick tick);

}  // namespace thaum::game::inline data

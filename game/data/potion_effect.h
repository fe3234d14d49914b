// game/data/potion_effect.h: what potions do to their wizards beyond the numbers that each potion has
// (PotionGift). Each effect has a source file of its own, such as game/stations/potions/venom.cpp for the
// potion of assets/potions/venom.toml. The file registers a PotionEffectKind. It reads keys of its own from
// the table `wizard` of a potion's data file. Other potions may have the same keys, and so the same effect.
#pragma once
#include <memory>
#include <string_view>
#include <vector>

#include "core/config.h"
#include "core/registry.h"
#include "ecs/schedule.h"

namespace thaum::game::inline context {
struct MatchContext;
}

namespace thaum::game::inline data {

/// Arguments of an effect's functions.
struct PotionUse {
    MatchContext& context;
    ecs::Entity wizard;
    std::uint32_t potion{};  ///< number of the potion, its index in MatchData::recipes
    Tick lasts{};            ///< time for which the potion acts (ticks); 0: it has no duration
    Tick tick{};             ///< number of the present tick of play
};

/// Arguments with which an effect adds its systems.
struct PotionSystems {
    MatchContext& context;
    ecs::Schedule& schedule;
};

/// One effect of a potion, with the numbers of the potion's data file. Its state in a match is in the World.
class PotionEffect {
public:
    PotionEffect() = default;
    PotionEffect(const PotionEffect&) = delete;
    PotionEffect& operator=(const PotionEffect&) = delete;
    virtual ~PotionEffect() = default;

    /// Called when the wizard has drunk the potion.
    virtual void drunk(const PotionUse& use) const = 0;
    /// Called when the potion stops acting on the wizard.
    virtual void over(const PotionUse&) const {}
    /// Called when the wizard has died, whether or not the wizard has drunk the potion.
    virtual void lost(const PotionUse&) const {}
    /// Components and resources of the World that drunk(), over() and lost() write, besides Potions, EventLog
    /// and resource::Journal.
    virtual ecs::Mask writes(const ecs::World& world) const = 0;
    /// Adds systems that act while the potion acts on a wizard.
    virtual void add_systems(const PotionSystems&) const {}
};

/// A kind of potion effect, as its source registers it.
struct PotionEffectKind {
    std::string_view name;
    /// Declares components that only this effect has; null: it has none.
    void (*declare)(ecs::World&) = nullptr;
    /// Reads the effect from the table `wizard` of a potion's data file; a null result: the potion does not
    /// have the effect.
    std::shared_ptr<const PotionEffect> (*read)(const ConfigTable& wizard);
};

/// Registers a kind of effect when the program starts.
using PotionEffectRegistration = Registration<PotionEffectKind>;

/// All kinds of effect, sorted by name.
inline const std::vector<PotionEffectKind>& potion_effect_kinds() {
    return registry_of<PotionEffectKind>().all();
}

/// The effects that a potion has, in the order of their names. `wizard`: the table `wizard` of the potion's
/// data file.
std::vector<std::shared_ptr<const PotionEffect>> read_potion_effects(const ConfigTable& wizard);

}  // namespace thaum::game::inline data

// The shield absorbs harm to its wizard for a while: the effect `shield` in its data file. Here is only when
// bots cast it.
#include "game/data/spell.h"

namespace thaum::game::inline spells {
namespace {

/// Share of health below which a bot that is being shot at casts a shield.
constexpr double hurt_below = 0.6;

class ShieldSpell final : public SpellRules {
public:
    explicit ShieldSpell(const ConfigTable&) {}

    double worth(const SpellOccasion& occasion) const override {
        const bool wanted = occasion.under_fire && !occasion.warded && occasion.health < hurt_below;
        return wanted ? 1 - 0.5 * occasion.health : 0;
    }
};

const SpellRegistration registration({
    .name = "shield",
    .declare = declare_all<>,
    .read = read_rules<SpellRules, ShieldSpell>,
});

}  // namespace
}  // namespace thaum::game::inline spells

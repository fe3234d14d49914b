// Armour: the wizard takes only a share of every harm.
#include "game/data/effect.h"

namespace thaum::game::inline effects {
namespace {

class Armour final : public Effect {
public:
    explicit Armour(const ConfigTable& entry) : factor_(entry.number("factor", {0, 10})) {}

    Factors factors(double strength) const override { return {.harm = strengthened(factor_, strength)}; }

private:
    double factor_;  ///< share of every harm that the wizard still takes
};

const EffectRegistration registration({.name = "armour", .lasts = true, .read = read_effect<Armour>});

}  // namespace
}  // namespace thaum::game::inline effects

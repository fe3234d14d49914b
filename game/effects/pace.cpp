// Pace: the wizard walks faster or slower.
#include "game/data/effect.h"

namespace thaum::game::inline effects {
namespace {

class Pace final : public Effect {
public:
    explicit Pace(const ConfigTable& entry) : factor_(entry.number("factor", {0.1, 10})) {}

    Factors factors(double strength) const override { return {.pace = strengthened(factor_, strength)}; }

private:
    double factor_;  ///< factor on the walking speed
};

const EffectRegistration registration({.name = "pace", .lasts = true, .read = read_effect<Pace>});

}  // namespace
}  // namespace thaum::game::inline effects

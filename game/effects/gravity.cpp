// Gravity: the wizard weighs less or more, so falls slower and jumps higher, or the reverse.
#include "game/data/effect.h"

namespace thaum::game::inline effects {
namespace {

class Gravity final : public Effect {
public:
    explicit Gravity(const ConfigTable& entry) : factor_(entry.number("factor", {0, 2})) {}

    Factors factors(double strength) const override { return {.gravity = strengthened(factor_, strength)}; }

private:
    double factor_;  ///< share of the wizard's weight that is left
};

const EffectRegistration registration({.name = "gravity", .lasts = true, .read = read_effect<Gravity>});

}  // namespace
}  // namespace thaum::game::inline effects

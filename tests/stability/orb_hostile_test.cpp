// Tests the haptic modes at the orb with hostile curves (strength over a field's value): strengths jump, up
// to 10^6 N of either sign. All pairs of modes are tested, by both players at once.
#include <cmath>

#include "core/random.h"
#include "unit/orb_rig.h"

namespace thaum::game::test {
namespace {

/// A random curve of a mode's strength over the value of its field, with jumps at four places.
field::TransferFunction hostile_curve(Random& random, double max_property) {
    constexpr std::array<double, 6> strengths{1e6, -1e6, 0, 1, 5, 0.3};
    std::array<vec2, 8> points{};
    for (std::size_t i = 0; i < points.size(); ++i)
        points[i] = {max_property * std::floor(static_cast<double>(i) / 2) / 3,
                     strengths[random.below(strengths.size())]};
    return field::transfer_function(points).value_or(field::constant(1e6));
}

/// Energy that the forces have given to one hand, computed from the device's own motion.
class GivenEnergy {
public:
    void add(const HandState& before, const HandState& current, const haptics::HapticModel& model,
             double cap) {
        created_ += glm::dot(current.device.force, current.device.position - before.device.position);
        // Energy that was dissipated earlier must not hide energy that the forces create later.
        if (stored(current, model, cap) < 1e-3) created_ = std::max(created_, 0.0);
        max_ = std::max(max_, created_);
    }
    double most() const { return max_; }

private:
    /// Energy stored in the spring between tip and proxy and in the primitives, as far as the force limit
    /// lets it act (J).
    static double stored(const HandState& hand, const haptics::HapticModel& model, double cap) {
        const double stretch = glm::distance(hand.servo.proxy, hand.device.position);
        const double stiffness = model.coupling.stiffness, most = cap / stiffness;
        double energy = stretch < most ? stiffness * stretch * stretch / 2 : cap * (stretch - most / 2);
        for (const auto& p : model.primitives.items()) {
            const vec3 off = hand.servo.proxy - p.position;
            const double along = glm::dot(off, p.direction);
            const bool line = p.kind == haptics::PrimitiveKind::line,
                       plane = p.kind == haptics::PrimitiveKind::plane;
            const double way = plane  ? std::max(0.0, -along)
                               : line ? glm::length(off - along * p.direction)
                                      : glm::length(off);
            energy += std::min(p.strength, cap) * way;
        }
        return energy;
    }

    double created_{}, max_{};
};

struct Outcome {
    double largest{}, cap{}, created{}, felt{};
    bool finite{true};
};

/// A player whose hand makes sudden motions while the curves of the modes change.
struct Darting {
    std::uint32_t player{};
    Random& random;
    vec3 aim{};

    void act(Seance& seance, std::array<std::uint32_t, 2> worn, Tick t) {
        auto& modes = seance.change().get<WornModes>(seance.wizard(player));
        seance.change().get<Focus>(seance.wizard(player)).points = 100;
        if (t % 500 == 0) {
            modes.worn = worn;
            for (std::size_t i = 0; i < seance.rules().modes.size(); ++i)
                modes.strength[i] = hostile_curve(random, seance.rules().modes[i].max_property);
            ++modes.version;
        }
        if (t % 300 == 0)
            aim = {random.uniform(-0.07, 0.07), random.uniform(-0.05, 0.05), random.uniform(-0.03, 0.03)};
        // Excessive forces shut a device off; a press of the emergency key switches forces on again.
        auto& hand = seance.change().get<HandState>(seance.wizard(player));
        hand.home += (t % 300 < 10 ? 0.1 : 0.01) * (aim - hand.home);
        if (hand.servo.safety.latched != 0 && t % 40 < 20)
            seance.hold(input::Button::panic, player);
        else
            seance.release(input::Button::panic, player);
    }
};

/// Both players switch the haptic modes `worn` on, make sudden motions, and change the curves of the modes.
Outcome dart_about(std::array<std::uint32_t, 2> worn, Tick length, std::uint64_t seed) {
    Seance seance(seed);
    seance.begin(0);
    seance.begin(1);
    Random random = random_stream(seed, 4);
    Outcome outcome;
    std::array<GivenEnergy, players> energies;
    std::array<Darting, players> hands{Darting{0, random}, Darting{1, random}};
    for (Tick t = 0; t < length; ++t) {
        std::array<HandState, players> before;
        for (auto& hand : hands) {
            before[hand.player] = seance.part<HandState>(hand.player);
            hand.act(seance, worn, t);
        }
        seance.run(1);
        for (std::uint32_t player = 0; player < players; ++player) {
            const auto& current = seance.part<HandState>(player);
            const vec3 output = current.servo.safety.output;
            outcome.cap = seance.match->haptic_setup().servos[player].limits.cap;
            outcome.finite = outcome.finite && is_finite(output) && is_finite(current.device.position);
            outcome.largest = std::max(outcome.largest, glm::length(output));
            outcome.felt += output != vec3(0) ? 0.5 / static_cast<double>(length) : 0;
            energies[player].add(before[player], current, seance.model(player), outcome.cap);
            outcome.created = std::max(outcome.created, energies[player].most());
        }
    }
    EXPECT_TRUE(seance.scries(0) && seance.scries(1));
    return outcome;
}

constexpr Tick whole = 100'000;

TEST(OrbHostile, AllPairsOfModesStayWithinTheCap) {
    for (std::uint32_t one = 0; one < 6; ++one) {
        for (std::uint32_t other = one + 1; other < 6; ++other) {
            const auto outcome = dart_about({one, other}, whole / 15, 6 * one + other);
            EXPECT_TRUE(outcome.finite) << one << ", " << other;
            EXPECT_LE(outcome.largest, outcome.cap * (1 + 1e-12)) << one << ", " << other;
            EXPECT_GT(outcome.felt, 0.3) << one << ", " << other << ": something was felt";
        }
    }
}

TEST(OrbHostile, PairsOfPassiveModesCreateNoEnergy) {
    constexpr std::array<std::uint32_t, 4> passive{0, 3, 4, 5};
    for (std::size_t i = 0; i < passive.size(); ++i) {
        for (std::size_t j = i + 1; j < passive.size(); ++j) {
            const auto outcome = dart_about({passive[i], passive[j]}, whole / 6, 40 + 6 * i + j);
            EXPECT_LE(outcome.created, 0.02) << passive[i] << ", " << passive[j];
            EXPECT_GT(outcome.felt, 0.3) << passive[i] << ", " << passive[j];
            RecordProperty(std::to_string(10 * passive[i] + passive[j]),
                           std::to_string(1000 * outcome.created) + " mJ");
        }
    }
}

}  // namespace
}  // namespace thaum::game::test

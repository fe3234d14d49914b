// tests/unit/orb_rig.h: a match whose wizards stand at the orb (a station where hands feel a flow), for
// tests.
#pragma once
#include <array>
#include <cmath>
#include <memory>

#include "game/components/orb.h"
#include "game/components/station.h"
#include "game/stations/orb/orb.h"
#include "game/stations/orb/worn_modes.h"
#include "unit/game_duel.h"

namespace thaum::game::test {

/// A match with both wizards beside the orb, the first to the east and the second to the south. Tests set
/// inputs in `frame`.
class Seance {
public:
    explicit Seance(std::uint64_t seed = 1, std::vector<std::string> overrides = {}) {
        auto setup = two_hands();
        setup.seed = seed;
        for (auto& device : setup.devices) device.set_force_percent(100);
        match = std::make_unique<Simulation>(duel_data(std::move(overrides)), setup);
        place(0, {-16.5, 0, 0});
        place(1, {-18, 0, 1.4});
        run(ticks(0.2));
    }

    const ecs::World& world() const { return match->world(); }
    ecs::World& change() { return match->world_to_change(); }
    ecs::Entity wizard(std::uint32_t player) const { return wizard_of(world(), player); }
    template <class Part>
    const Part& part(std::uint32_t player = 0) const {
        return world().get<Part>(wizard(player));
    }
    const OrbRules& rules() const { return *match->data().orb; }
    const Orb& orb() const { return world().single<Orb>(); }
    bool scries(std::uint32_t player = 0) const { return world().has<Scrying>(wizard(player)); }
    double focus(std::uint32_t player = 0) const { return part<Focus>(player).points; }
    const haptics::HapticModel& model(std::uint32_t player = 0) const {
        return match->context().output.models.read()[player];
    }

    void place(std::uint32_t player, vec3 feet) {
        auto& motion = change().get<Motion>(wizard(player));
        motion = {};
        motion.position = feet + vec3(0, match->data().wizard.height / 2, 0);
        match->physics().set_state(wizard(player).index, motion);
    }

    input::DeviceSample& hand(std::uint32_t player = 0) { return frame.devices[player]; }
    void hold(input::Button button, std::uint32_t player = 0) { hand(player).press(button); }
    void release(input::Button button, std::uint32_t player = 0) { hand(player).buttons &= ~bit(button); }
    void begin(std::uint32_t player = 0) {
        hold(input::Button::stir, player);
        run(2 * gameplay_period);
    }

    void run(Tick length) {
        for (Tick t = 0; t < length; ++t) match->tick(frame);
    }
    void press_key(std::uint8_t key, std::uint32_t player = 0) {
        hand(player).wand = key;
        run(2 * gameplay_period);
        hand(player).wand = 0;
        run(gameplay_period);
    }
    void press(input::Button button, std::uint32_t player = 0) {
        hold(button, player);
        run(2 * gameplay_period);
        release(button, player);
        run(gameplay_period);
    }

    /// Moves the hand along `way` (m), by 0.1 mm in each tick.
    void move_hand(vec3 way, std::uint32_t player = 0) {
        const auto steps = [](double metres) { return static_cast<int>(std::lround(metres * 1e4)); };
        const std::array<int, 3> left{steps(way.x), steps(way.y), steps(way.z)};
        const int most = std::max({std::abs(left[0]), std::abs(left[1]), std::abs(left[2])});
        const auto sign = [](int v) { return v > 0 ? 1 : v < 0 ? -1 : 0; };
        auto& counts = hand(player).counts;
        for (int i = 0; i < most; ++i) {
            counts[input::hand::look_right] = i < std::abs(left[0]) ? sign(left[0]) : 0;
            counts[input::hand::look_up] = i < std::abs(left[1]) ? sign(left[1]) : 0;
            counts[input::hand::forward] = i < std::abs(left[2]) ? -127 * sign(left[2]) : 0;
            run(1);
        }
        counts = {};
    }

    /// Puts the hand at a position of its device (m), at rest.
    void put_hand(vec3 place, std::uint32_t player = 0) {
        auto& hand_state = change().get<HandState>(wizard(player));
        hand_state.home = place;
        hand_state.device = haptics::resting_at(place);
        hand_state.servo.samples = 0;
        hand_state.servo.primitives = 0;
    }
    vec3 core_at_hand(std::uint32_t player = 0) const {
        const auto frame_of_hand = probe_frame(rules(), orb(), part<AtStation>(player).yaw);
        return frame_of_hand.to_device(core_of(orb()).middle);
    }

    std::size_t count(EventKind kind, std::uint32_t player = 0) const {
        std::size_t sum = 0;
        const auto& events = match->events();
        for (auto i = events.first(); i < events.count(); ++i)
            sum += events[i].kind == kind && events[i].subject == player ? 1 : 0;
        return sum;
    }
    Event newest(EventKind kind) const {
        const auto& events = match->events();
        for (auto i = events.count(); i > events.first(); --i)
            if (events[i - 1].kind == kind) return events[i - 1];
        return {};
    }

    std::unique_ptr<Simulation> match;
    input::InputFrame frame;
};

}  // namespace thaum::game::test

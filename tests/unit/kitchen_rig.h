// A match in which a test brews at the cauldron.
#pragma once
#include <algorithm>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "game/stations/cauldron/potions.h"
#include "unit/game_duel.h"

namespace thaum::game::test {

inline StrokeReading drawn(std::uint32_t gesture, double force, double turns = 0) {
    return {.gesture = gesture, .probability = 1, .force = force, .turns = turns};
}

/// A match whose first wizard stands at the cauldron's rim and stirs. To be fast, its fluid has few cells.
/// The test sets how evenly the newest ingredient is mixed in (0 to 1).
class Kitchen {
public:
    explicit Kitchen(std::vector<std::string> overrides = {}, std::uint64_t seed = 1,
                     const std::filesystem::path& folder = assets()) {
        DataChoice choice{.overrides = std::move(overrides)};
        choice.overrides.emplace_back("cauldron.brew.cells_across=8");
        auto data = load_match_data(folder, choice);
        EXPECT_TRUE(data) << (data ? "" : data.error().message);
        auto setup = two_hands();
        setup.seed = seed;
        match_ = std::make_unique<Simulation>(std::make_shared<const MatchData>(std::move(*data)), setup);
        place(0, {-2.2, 0, 0});
        place(1, {15, 0, 15});
        run(ticks(0.2));
    }

    Simulation& match() { return *match_; }
    ecs::World& world() { return match_->world_to_change(); }
    Cauldron& cauldron() { return world().single<Cauldron>(); }
    ecs::Entity wizard(std::uint32_t player) { return wizard_of(world(), player); }
    const Effects& effects(std::uint32_t player) { return world().get<Effects>(wizard(player)); }
    /// Whether a wizard holds Azoth, the half of the Great Work that is brewed.
    bool holds_half(std::uint32_t player) { return world().get<WorkHalf>(wizard(player)).held != 0; }
    Tick now() { return match_->match().played; }

    void place(std::uint32_t player, vec3 feet) {
        auto& motion = world().get<Motion>(wizard(player));
        motion = standing_on(feet);
        match_->physics().set_state(wizard(player).index, motion);
    }

    void run(Tick length, bool fire = false) {
        for (Tick t = 0; t < length; ++t) {
            input::InputFrame frame;
            if (stirs_) frame.devices[0].press(input::Button::stir);
            if (fire) frame.devices[0].press(input::Button::fire);
            match_->tick(frame);
        }
    }

    /// Drops an ingredient into a brew whose newest ingredient is mixed in to the share `reached`.
    void drop(std::string_view name, double reached = 0.7) {
        const auto& all = match_->data().cauldron->ingredients;
        const auto found =
            std::find_if(all.begin(), all.end(), [&](const auto& i) { return i.name == name; });
        ASSERT_NE(found, all.end());
        world().add(wizard(0), Pouch{static_cast<std::uint32_t>(found - all.begin())});
        for (Tick t = 0; t < 2 * gameplay_period && world().has<Pouch>(wizard(0)); ++t) {
            cauldron().reached = reached;
            run(1, true);
        }
        run(2 * fluid_period + gameplay_period);
    }

    void draw(const StrokeReading& reading, double reached = 0.7, std::uint32_t player = 0) {
        draw_from(reading, reached, reached, player);
    }
    /// Draws a stroke that begins when the brew is mixed to the share `begun_at`, and ends when it is mixed
    /// to `reached`.
    void draw_from(const StrokeReading& reading, double begun_at, double reached, std::uint32_t player = 0) {
        cauldron().reached = reached;
        brew_by_stroke(match_->context_to_change(), wizard(player), {reading, begun_at}, now());
    }

    /// Number of events of a kind so far.
    std::size_t count(EventKind kind) const { return count_of(*match_, kind); }
    BrewFault fault() const {
        return count(EventKind::brew_fault) == 0
                   ? BrewFault::none
                   : static_cast<BrewFault>(last_of(*match_, EventKind::brew_fault).detail);
    }
    /// Name of the potion that was brewed last; empty: none.
    std::string brewed() const {
        if (count(EventKind::potion) == 0) return {};
        return match_->data().recipes.at(last_of(*match_, EventKind::potion).detail).name;
    }
    std::uint32_t number_of(std::string_view name) const {
        const auto& all = match_->data().recipes;
        const auto found =
            std::find_if(all.begin(), all.end(), [&](const auto& r) { return r.name == name; });
        return static_cast<std::uint32_t>(found - all.begin());
    }
    void stop_stirring() { stirs_ = false; }

private:
    Motion standing_on(vec3 feet) const {
        Motion motion;
        motion.position = feet + vec3(0, match_->data().wizard.height / 2, 0);
        return motion;
    }

    std::unique_ptr<Simulation> match_;
    bool stirs_ = true;
};

}  // namespace thaum::game::test

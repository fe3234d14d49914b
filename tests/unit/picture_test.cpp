// Tests of the picture data of a match: their contents, and interpolation between two of them.
#include <gtest/gtest.h>

#include <cmath>

#include "game/range/range.h"
#include "unit/hud_rig.h"

namespace thaum::game::hud_tests {
namespace {

// ---- contents of a picture --------------------------------------------------------------------------------

TEST(TakePicture, HoldsTheStrongestForcesOfTheLastTwoSecondsInWholeColumns) {
    const auto match = new_match();
    std::vector<float> felt;
    for (const int last : {100, 2047, 2048, 2051, 3000, 5005}) {
        while (felt.size() < static_cast<std::size_t>(last)) {
            input::InputFrame frame;
            frame.devices[0].press(input::Button::fire);
            match->tick(frame);
            const auto& trace = match->felt(0);
            felt.push_back(trace[(match->match().played - 1) % trace.size()]);
        }
        const auto picture = picture_of(*match);
        const auto& columns = picture.wizards[0].senses.force.strongest;
        const auto whole = felt.size() / force_column;
        for (std::size_t back = 1; back <= columns.size(); ++back) {
            float strongest = 0;
            for (std::size_t t = 0; back <= whole && t < force_column; ++t)
                strongest = std::max(strongest, felt[(whole - back) * force_column + t]);
            EXPECT_EQ(columns[columns.size() - back], strongest) << last << " " << back;
        }
        EXPECT_GT(*std::max_element(columns.begin(), columns.end()), last > 300 ? 0.5F : -1.0F);
        EXPECT_EQ(picture.wizards[1].senses.force.strongest, ForcePicture{}.strongest);
    }
}

TEST(TakePicture, HoldsTheLookOfAMoment) {
    const auto match = new_match();
    const auto p = picture_of(*match);
    EXPECT_EQ(p.tick, 0U);
    EXPECT_EQ(p.left_s, seconds(match_data()->round.length));
    EXPECT_EQ(p.kills_to_win, match_data()->round.kills);
    EXPECT_EQ(p.things.size(), match_data()->arena.things.size() + match_data()->arena.anchors.size() +
                                   match_data()->arena.pads.size());
    for (const auto& w : p.wizards) {
        EXPECT_EQ(w.vitals.health, match_data()->wizard.health);
        EXPECT_EQ(w.wand.name, "bolt");
        EXPECT_EQ(w.wand.energy, w.wand.energy_cap);
        EXPECT_FALSE(w.vitals.dead);
        EXPECT_NEAR(w.vitals.eye.y, match_data()->wizard.eye, 1e-9);
    }
}

TEST(TakePicture, APressOfStirAFewStepsFromTheRimIsSeenInThePictureOnly) {
    const auto reach = match_data()->arena.bowl->size.radius + match_data()->cauldron->ladle.reach;
    // Returns the picture of a wizard who stands `beyond` metres outside the place where stirring begins.
    const auto seen = [&](double beyond, bool presses) {
        const auto match = new_match();
        const auto middle = match->world().single<Cauldron>().middle;
        place_wizard(*match, 0, {.feet = {middle.x + reach + beyond, 0, middle.z}});
        input::InputFrame frame;
        if (presses) frame.devices[0].press(input::Button::stir);
        for (int t = 0; t < 8; ++t) match->tick(frame);
        return picture_of(*match).wizards[0];
    };
    EXPECT_TRUE(seen(0.5, true).stations.misses_rim);
    EXPECT_TRUE(seen(3, true).stations.misses_rim);
    EXPECT_FALSE(seen(3, false).stations.misses_rim);
    EXPECT_FALSE(seen(5, true).stations.misses_rim) << "the press is not meant for the cauldron";
    const auto near = seen(-0.5, true);
    EXPECT_TRUE(near.stations.stirs);
    EXPECT_FALSE(near.stations.misses_rim);
}

TEST(TakePicture, AShotIsSeenAsAMissile) {
    const auto match = new_match();
    input::InputFrame frame;
    frame.devices[0].press(input::Button::fire);
    for (int i = 0; i < 30; ++i) match->tick(frame);
    const auto p = picture_of(*match);
    ASSERT_FALSE(p.missiles.empty());
    EXPECT_EQ(p.missiles[0].player, 0U);
    EXPECT_LT(p.wizards[0].wand.energy, p.wizards[0].wand.energy_cap);
    EXPECT_EQ(p.wizards[1].wand.energy, p.wizards[1].wand.energy_cap);
}

TEST(TakePicture, HurtsAndDeathsShowForAWhile) {
    const auto match = new_match();
    for (int i = 0; i < 8000; ++i) match->tick({});  // skips the start, when the kill feed shows recipes
    auto& world = match->world_to_change();
    const auto victim = wizard_of(world, 1);
    hurt(match->context_to_change(), victim, match->match().played,
         {.points = 1000, .by = 0, .how = hit_kind("bolt_hit")});
    for (int i = 0; i < 16; ++i) match->tick({});
    auto p = picture_of(*match);
    EXPECT_TRUE(p.wizards[1].vitals.dead);
    EXPECT_NEAR(p.wizards[1].vitals.returns_in_s, seconds(match_data()->round.respawn), 0.03);
    EXPECT_EQ(p.wizards[0].vitals.kills, 1);
    ASSERT_EQ(p.feed_lines, 1U);
    EXPECT_EQ(p.feed[0].event.subject, 1U);
    EXPECT_EQ(p.feed[0].event.by, 0U);
    ASSERT_EQ(p.wizards[1].senses.hurts, 1U);
    const vec3 to_foe = glm::normalize(p.wizards[0].vitals.eye - p.wizards[1].vitals.eye);
    EXPECT_GT(glm::dot(p.wizards[1].senses.marks[0].towards, to_foe), 0.99);
    for (int i = 0; i < 5100; ++i) match->tick({});
    take_picture(*match, p);
    EXPECT_EQ(p.feed_lines, 0U);
    EXPECT_EQ(p.wizards[1].senses.hurts, 0U);
}

/// A match in which player 1 looks up with a wand in hand, above all other objects.
struct Looking {
    std::unique_ptr<Simulation> match;
    ecs::Entity me;

    Looking(std::shared_ptr<const MatchData> data, std::string_view wand)
        : match(std::make_unique<Simulation>(
              std::move(data), MatchSetup{1, {bot_device(0, "level_1"), bot_device(1, "level_1")}})) {
        auto& world = match->world_to_change();
        me = wizard_of(world, 0);
        for (const auto& one : match->data().wands)
            if (one.name == wand) world.get<WandBelt>(me).selected = one.stats.slot;
        world.get<Gaze>(me).pitch = 0.7;
    }
    /// Moves a body to a distance from the eye, under the crosshair.
    void bring(ecs::Entity thing, double distance) const {
        const auto& gaze = match->world().get<Gaze>(me);
        const vec3 ahead = look_rotation(gaze.yaw, gaze.pitch) * vec3(0, 0, -1);
        const vec3 eye = eye_of(match->data().wizard, match->physics().state(me.index).position);
        auto state = match->physics().state(thing.index);
        state.position = eye + distance * ahead;
        match->physics().set_state(thing.index, state);
    }
    Target target() const { return picture_of(*match).wizards[0].wand.target; }
    /// The first loose thing of the arena (a box or stone that wands can move).
    ecs::Entity loose() const {
        ecs::Entity found;
        match->world().view<const Prop>().each([&](ecs::Entity e, const Prop&) {
            if (!found) found = e;
        });
        return found;
    }
};

TEST(TakePicture, SaysWhatTheWandWouldDoWithWhatIsUnderTheCrosshair) {
    const Looking lift(match_data(), "lift");
    EXPECT_EQ(lift.target().kind, TargetKind::nothing);
    const auto thing = lift.loose();
    ASSERT_TRUE(thing);
    lift.bring(thing, 3);
    const auto near = lift.target();
    EXPECT_EQ(near.kind, TargetKind::take);
    EXPECT_EQ(near.thing, thing);
    EXPECT_EQ(near.mass, lift.match->physics().desc(thing.index).mass);
    lift.bring(thing, 12);
    EXPECT_EQ(lift.target().kind, TargetKind::too_far);
    lift.bring(thing, 100);
    EXPECT_EQ(lift.target().kind, TargetKind::nothing);

    const Looking heavy(std::make_shared<const MatchData>(
                            load_match_data(assets, {.overrides = {"lift.hold.mass_max_kg=1"}}).value()),
                        "lift");
    heavy.bring(heavy.loose(), 3);
    EXPECT_EQ(heavy.target().kind, TargetKind::too_heavy);

    const Looking bolt(match_data(), "bolt");
    bolt.bring(bolt.loose(), 3);
    EXPECT_EQ(bolt.target().kind, TargetKind::nothing) << "a bolt takes nothing up";
    bolt.bring(bolt.loose(), 100);
    bolt.bring(wizard_of(bolt.match->world(), 1), 8);
    EXPECT_EQ(bolt.target().kind, TargetKind::foe);
}

TEST(TakePicture, SaysWhichAnchorARopeWouldTake) {
    const Looking swing(match_data(), "swing");
    auto& world = swing.match->world_to_change();
    ecs::Entity anchor;
    vec3 place{};
    world.view<const Anchor, const Motion>().each([&](ecs::Entity e, const Motion& motion) {
        if (!anchor) std::tie(anchor, place) = std::pair(e, motion.position);
    });
    ASSERT_TRUE(anchor);
    auto state = swing.match->physics().state(swing.me.index);
    state.position = place + vec3(0, -5, 3);
    swing.match->physics().set_state(swing.me.index, state);
    world.get<Motion>(swing.me).position = state.position;
    const vec3 to = place - eye_of(swing.match->data().wizard, state.position);
    auto& gaze = world.get<Gaze>(swing.me);
    gaze.yaw = std::atan2(-to.x, -to.z);
    gaze.pitch = std::atan2(to.y, std::hypot(to.x, to.z));
    EXPECT_EQ(swing.target().kind, TargetKind::hook);
    EXPECT_EQ(swing.target().thing, anchor);
    gaze.pitch = -1.2;
    EXPECT_EQ(swing.target().kind, TargetKind::hook) << "the ground";
    EXPECT_FALSE(swing.target().thing);
}

TEST(TakePicture, HoldsTheEnergyOfEveryWand) {
    const auto match = new_match();
    auto& belt = match->world_to_change().get<WandBelt>(wizard_of(match->world(), 0));
    const auto& wands = match_data()->wands;
    for (std::size_t i = 0; i < wands.size(); ++i)
        belt.energy[wands[i].stats.energy_slot] = 1.0 + static_cast<double>(wands[i].stats.energy_slot);
    const auto picture = picture_of(*match);
    for (std::size_t i = 0; i < wands.size(); ++i) {
        EXPECT_EQ(picture.wizards[0].wand.charges[i], 1.0 + static_cast<double>(wands[i].stats.energy_slot))
            << wands[i].name;
        EXPECT_EQ(picture.shown->wands[i].energy_cap, wands[i].stats.energy_cap);
        EXPECT_EQ(picture.shown->wands[i].energy_cost, wands[i].stats.energy_cost);
    }
}

TEST(TakePicture, AllocatesNothingOnceWarm) {
    const auto match = new_match();
    auto p = picture_of(*match);
    const auto* things = p.things.data();
    for (int i = 0; i < 100; ++i) {
        match->tick({});
        take_picture(*match, p);
    }
    EXPECT_EQ(p.things.data(), things);
    EXPECT_GE(p.missiles.capacity(), 100U);
}

TEST(TakePicture, PowerUpsAreThereOrOnTheirWayBack) {
    const auto match = new_match();
    auto p = picture_of(*match);
    ASSERT_EQ(p.power_ups.size(), match_data()->arena.power_ups.size());
    for (const auto& power_up : p.power_ups) EXPECT_EQ(power_up.returned, 1);
    auto& world = match->world_to_change();
    world.view<PowerUp>().each([](PowerUp& power_up) {
        if (power_up.kind == PowerUpKind::vial) power_up.back_at = ticks(5.0);
    });
    take_picture(*match, p);
    for (const auto& power_up : p.power_ups)
        EXPECT_NEAR(power_up.returned, power_up.kind == PowerUpKind::vial ? 0.75 : 1, 1e-9);
}

TEST(TakePicture, ShowsAPickUpForAWhile) {
    const auto match = new_match();
    auto& world = match->world_to_change();
    const vec3 feet = std::as_const(world).get<Motion>(wizard_of(world, 0)).position -
                      vec3(0, match_data()->wizard.height / 2, 0);
    world.view<const PowerUp, Motion>().each([&](const PowerUp& power_up, Motion& motion) {
        if (power_up.kind == PowerUpKind::heart) motion.position = feet;
    });
    for (int i = 0; i < 16; ++i) match->tick({});
    const auto p = picture_of(*match);
    EXPECT_LT(p.wizards[0].senses.since_gift_s, 0.02);
    EXPECT_EQ(p.wizards[0].senses.gift.detail, static_cast<std::uint32_t>(PowerUpKind::heart));
    EXPECT_EQ(p.wizards[0].senses.gift.amount, 50);
    EXPECT_GT(p.wizards[1].senses.since_gift_s, 1000);
    EXPECT_NEAR(p.wizards[0].vitals.health, 150, 0.1);
    render::Overlay overlay;
    make_overlay(p, {}, size, overlay);
    EXPECT_TRUE(has_text(overlay, "Heart  +50 health"));
}

// ---- interpolation between two pictures -------------------------------------------------------------------

struct Two {
    Picture from = make_picture(), to = make_picture(), out = make_picture();
    Two() {
        from.tick = 100;
        to.tick = 108;
        from.things.push_back({.entity = 4, .position = {0, 0, 0}});
        to.things.push_back({.entity = 4, .position = {0.1, 0, 0}, .orientation = rotation({0, 1, 0}, 0.4)});
        from.wizards[0].vitals.centre = from.wizards[0].vitals.eye = {1, 1, 1};
        to.wizards[0].vitals.centre = to.wizards[0].vitals.eye = {1.2, 1, 1};
    }
    const Picture& at(double alpha) {
        interpolate(from, to, alpha, out);
        return out;
    }
};

TEST(Interpolate, MovesInBetween) {
    Two two;
    const auto& p = two.at(0.5);
    EXPECT_NEAR(p.things[0].position.x, 0.05, 1e-12);
    EXPECT_NEAR(2 * std::asin(p.things[0].orientation.y), 0.2, 1e-12);
    EXPECT_NEAR(p.wizards[0].vitals.eye.x, 1.1, 1e-12);
    EXPECT_NEAR(two.at(0).things[0].position.x, 0, 1e-12);
    EXPECT_NEAR(two.at(1).things[0].position.x, 0.1, 1e-12);
}

TEST(Interpolate, ThingsAreFoundByTheirEntity) {
    Two two;
    two.from.things.insert(two.from.things.begin(), {.entity = 2, .position = {9, 9, 9}});
    EXPECT_NEAR(two.at(0.5).things[0].position.x, 0.05, 1e-12);
    two.to.things[0].entity = 77;  // an object that the earlier picture does not have
    EXPECT_NEAR(two.at(0.5).things[0].position.x, 0.1, 1e-12);
}

TEST(Interpolate, AReturnToLifeIsNotInterpolated) {
    Two two;
    two.to.wizards[0].vitals.centre = two.to.wizards[0].vitals.eye = {-15, 1, 15};
    EXPECT_EQ(two.at(0.25).wizards[0].vitals.eye, vec3(-15, 1, 15));
    // Nothing is interpolated even if the new life begins beside the place of death.
    Two near;
    near.from.wizards[0].vitals.lives = 1;
    near.to.wizards[0].vitals.lives = 2;
    EXPECT_EQ(near.at(0.25).wizards[0].vitals.eye, vec3(1.2, 1, 1));
}

TEST(Interpolate, TurnsTheShortWayAcrossTheSeam) {
    Two two;
    two.from.wizards[0].vitals.yaw = 3.1;
    two.to.wizards[0].vitals.yaw = -3.1;
    EXPECT_NEAR(std::remainder(two.at(0.5).wizards[0].vitals.yaw - pi, 2 * pi), 0, 1e-9);
}

}  // namespace
}  // namespace thaum::game::hud_tests

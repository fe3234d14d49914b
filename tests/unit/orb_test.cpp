// Tests of the orb, a station with a flow and a hidden core: where the core is, which wizards scry (feel its
// flow), what that costs, which haptic modes a wizard has switched on, and what the orb shows.
#include <set>
#include "game/stations/orb/scrying.h"

#include "core/file.h"
#include "unit/message_of.h"
#include "unit/orb_rig.h"

namespace thaum::game::test {
namespace {

using input::Button;

/// First fault that the reader finds in orb.toml after the words `from` were replaced by `to`; empty: none.
std::string fault_after(std::string_view from, std::string_view to) {
    auto words = read_text_file(assets() / "orb.toml", 1U << 20U).value();
    const auto at = words.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    words.replace(at, from.size(), to);
    const auto config = Config::parse(words, "orb.toml", 1);
    if (!config) return config.error().message;
    (void)read_orb_rules(*config);
    return message_of(config->check());
}

TEST(OrbRules, TheFileHasTheSixModesOfTheDesign) {
    const Seance seance;
    std::vector<std::string> names;
    for (const auto& mode : seance.rules().modes) names.push_back(mode.name);
    EXPECT_EQ(names, (std::vector<std::string>{"viscosity", "gradient", "force", "follow", "vortex_tube",
                                               "surface"}));
    EXPECT_EQ(seance.rules().core_share, 0.06);
    EXPECT_EQ(seance.rules().hold, ticks(1.5));
    ASSERT_EQ(seance.rules().effects.size(), 1U);
    EXPECT_EQ(seance.rules().effects[0].kind->name, "health");
    EXPECT_EQ(seance.rules().focus, 2);
}

TEST(OrbRules, AFaultNamesItsLine) {
    EXPECT_EQ(fault_after("x", "x"), "");
    const auto unknown = fault_after("name = \"force\"", "name = \"farce\"");
    EXPECT_NE(unknown.find("orb.toml:"), std::string::npos) << unknown;
    EXPECT_NE(unknown.find("there is no mode 'farce'"), std::string::npos) << unknown;
    EXPECT_NE(fault_after("name = \"force\"", "name = \"viscosity\"").find("two modes 'viscosity'"),
              std::string::npos);
    EXPECT_NE(fault_after("name = \"force\"", "name = \"snap_grid\"").find("reads scalars"),
              std::string::npos);
    EXPECT_NE(fault_after("kind = \"curl\"", "kind = \"gradient\"").find("filter"), std::string::npos);
    EXPECT_NE(fault_after("kind = \"curl\"", "kind = \"smooth\"").find("no samples"), std::string::npos);
    EXPECT_NE(fault_after("[6, 0, 24, 0.9]", "[6, 0, 24]").find("pairs"), std::string::npos);
    EXPECT_NE(fault_after("[6, 0, 24, 0.9]", "[24, 0, 6, 1]").find("left of"), std::string::npos);
    EXPECT_NE(fault_after("hold_s = 1.5", "hold_s = -1").find("hold_s"), std::string::npos);
    EXPECT_NE(fault_after("points = 25", "piints = 25").find("orb.toml:"), std::string::npos);
}

TEST(OrbRules, OnlyAnArenaWithAnOrbHasThem) {
    const auto well = load_match_data(assets(), {.arena = "the_well"}).value();
    EXPECT_FALSE(well.orb.has_value());
    const auto classic = load_match_data(assets(), {.rules = "classic"}).value();
    EXPECT_FALSE(classic.orb.has_value());
    const Simulation match(std::make_shared<const MatchData>(classic), two_hands());
    EXPECT_EQ(match.world().count<Orb>(), 0U);
    EXPECT_EQ(match.world().count<WornModes>(), 0U);
}

TEST(OrbCore, TheDistanceIsThatOfTheNearestPlaceOfTheCore) {
    Random random = random_stream(5, 1);
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        const Orb orb{.middle = {1, 2, 3}, .radius = 0.5, .seed = seed};
        const auto core = core_of(orb);
        const auto vortex = field::make_vortex_flow(1, seed).vortices[0];
        for (int i = 0; i < 10; ++i) {
            const vec3 place =
                orb.middle + vec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
            double nearest = 1e9;
            for (double along = -3; along <= 3; along += 1e-4) {
                const vec3 on_axis = vortex.middle + along * vortex.axis;
                if (glm::length(on_axis) <= orb.radius)
                    nearest = std::min(nearest, glm::distance(place, orb.middle + on_axis));
            }
            ASSERT_LT(nearest, 1e8) << "the axis passes the orb";
            EXPECT_NEAR(distance_from(core, place), nearest, 2e-4) << seed;
        }
    }
}

TEST(OrbCore, EveryMatchHasACoreThatCanBeFound) {
    std::set<std::uint64_t> seeds;
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        Seance seance(seed), again(seed);
        const auto& orb = seance.orb();
        EXPECT_EQ(orb.seed, again.orb().seed);
        EXPECT_TRUE(can_be_found(flow_of(orb), 2 * orb.radius)) << seed;
        EXPECT_GT(distance_from(core_of(orb), orb.middle), 0.06) << "a probe at rest is not near it";
        EXPECT_EQ(orb.radius, 0.5);
        seeds.insert(orb.seed);
    }
    EXPECT_EQ(seeds.size(), 5U);
}

TEST(OrbCore, TheNextRoundHasAnotherFlowAndTheSameCurves) {
    Seance seance;
    const auto before = seance.orb().seed;
    auto& modes = seance.change().get<WornModes>(seance.wizard(0));
    modes.strength[2] = field::constant(0.5);
    modes.worn = {2, no_mode};
    modes.told = modes.order_told = 1;
    spawn_next_orb(seance.match->context_to_change(), [&] {
        const auto memory = orb_memory(seance.world());
        ecs::Entity old;
        seance.change().view<const Orb>().each([&](ecs::Entity e, const Orb&) { old = e; });
        seance.change().destroy(old);
        for (std::uint32_t player = 0; player < players; ++player)
            seance.change().remove<WornModes>(seance.wizard(player));
        return *memory;
    }());
    EXPECT_NE(seance.orb().seed, before);
    const auto& current = seance.part<WornModes>();
    EXPECT_EQ(current.strength[2], field::constant(0.5));
    EXPECT_EQ(current.worn[0], 2U);
    EXPECT_EQ(current.told, 0U);
    EXPECT_EQ(current.order_told, 1U);
}

TEST(Scrying, CostsFocusAndEndsWithoutIt) {
    Seance seance;
    const double before = seance.focus();
    seance.begin();
    ASSERT_TRUE(seance.scries());
    EXPECT_EQ(seance.part<AtStation>().kind, StationKind::orb);
    seance.run(ticks(1));
    EXPECT_NEAR(before - seance.focus(), 2, 0.1);
    seance.change().get<Focus>(seance.wizard(0)).points = 0.5;
    seance.run(ticks(1));
    EXPECT_FALSE(seance.scries());
    EXPECT_FALSE(seance.world().has<AtStation>(seance.wizard(0)));
    EXPECT_EQ(seance.count(EventKind::unscried), 1U);
    EXPECT_GT(seance.focus(), 1) << "focus comes back";
    seance.run(ticks(1));
    EXPECT_FALSE(seance.scries()) << "Stir is still held";
    seance.release(Button::stir);
    seance.run(gameplay_period);
    seance.begin();
    EXPECT_TRUE(seance.scries());
    seance.release(Button::stir);
    seance.run(2 * gameplay_period);
    EXPECT_FALSE(seance.scries());
    EXPECT_EQ(seance.count(EventKind::unscried), 1U);
}

TEST(Scrying, NeedsTheOrbWithinReach) {
    Seance seance;
    seance.place(0, {-15, 0, 0});
    seance.begin();
    EXPECT_FALSE(seance.scries());
    seance.place(0, {-16.5, 3.5, 0});
    seance.run(gameplay_period);
    EXPECT_FALSE(seance.scries()) << "above the orb";
}

TEST(Scrying, APauseCostsNothing) {
    Seance seance;
    seance.begin();
    seance.press(Button::pause);
    const double focus = seance.focus();
    const auto hash = seance.match->state_hash();
    seance.run(ticks(1));
    EXPECT_EQ(seance.focus(), focus);
    seance.press(Button::pause);
    seance.run(ticks(0.1));
    EXPECT_TRUE(seance.scries());
    EXPECT_NE(seance.match->state_hash(), hash);
}

TEST(OrbModes, AThirdTakesOffTheOldest) {
    Seance seance;
    seance.begin();
    seance.press_key(1);
    seance.press_key(4);
    EXPECT_EQ(seance.part<WornModes>().worn, (std::array<std::uint32_t, 2>{0, 3}));
    EXPECT_EQ(seance.count(EventKind::mode_worn), 2U);
    seance.press_key(6);
    EXPECT_EQ(seance.part<WornModes>().worn, (std::array<std::uint32_t, 2>{3, 5}));
    EXPECT_EQ(seance.count(EventKind::mode_worn), 4U) << "viscosity off, surface on";
    EXPECT_EQ(seance.newest(EventKind::mode_worn).detail, 5U);
    seance.press_key(4);
    EXPECT_EQ(seance.part<WornModes>().worn, (std::array<std::uint32_t, 2>{5, no_mode}));
    EXPECT_EQ(seance.newest(EventKind::mode_worn).amount, 0);
    seance.press_key(7);
    EXPECT_EQ(seance.part<WornModes>().worn, (std::array<std::uint32_t, 2>{5, no_mode}))
        << "no mode has this key";
    EXPECT_EQ(seance.model().primitives.items().size(), 2U) << "plane and friction";
}

TEST(OrbModes, NextAndPreviousWandChangeTheLast) {
    Seance seance;
    seance.begin();
    seance.press(Button::next_wand);
    EXPECT_EQ(last_worn(seance.part<WornModes>()), 0U);
    seance.press(Button::next_wand);
    EXPECT_EQ(last_worn(seance.part<WornModes>()), 1U);
    seance.press(Button::previous_wand);
    seance.press(Button::previous_wand);
    EXPECT_EQ(seance.part<WornModes>().worn, (std::array<std::uint32_t, 2>{5, no_mode}));
    seance.press_key(1);
    seance.press(Button::previous_wand);
    EXPECT_EQ(seance.part<WornModes>().worn, (std::array<std::uint32_t, 2>{5, 4}))
        << "surface is already worn";
}

TEST(OrbModes, WandKeysChangeNoWandMeanwhile) {
    Seance seance;
    const auto selected = seance.part<WandBelt>().selected;
    seance.begin();
    seance.press_key(3);
    EXPECT_EQ(seance.part<WandBelt>().selected, selected);
}

TEST(OrbModes, TraceDrawsTheCurveOfTheLast) {
    Seance seance;
    seance.begin();
    seance.press_key(3);
    const auto before = seance.part<WornModes>();
    seance.put_hand({-0.06, 0.03, 0});
    seance.hold(Button::trace);
    seance.run(2 * gameplay_period);
    EXPECT_EQ(seance.part<WornModes>().strength, before.strength) << "a hand at rest draws nothing";
    EXPECT_FALSE(seance.model().primitives.items().empty());
    seance.move_hand({0.1, 0, 0});
    seance.run(100);
    EXPECT_TRUE(seance.model().primitives.items().empty()) << "a hand that draws feels no mode";
    EXPECT_EQ(seance.part<Scrying>().drawing, 1U);
    seance.release(Button::trace);
    seance.run(100);
    // The page on which the curve is drawn is the device's workspace: 1.5 m/s from left to right, -1.2 to 1.2
    // N from bottom to top.
    const auto& curve = seance.part<WornModes>().strength[2];
    for (const double x : {0.3, 0.6, 0.9, 1.05}) EXPECT_NEAR(curve(x), 0.6, 0.03) << x;
    EXPECT_NEAR(curve(0.05), before.strength[2](0.05), 1e-12) << "left of the stroke nothing has changed";
    EXPECT_EQ(seance.part<WornModes>().strength[0], before.strength[0]);
    EXPECT_EQ(seance.count(EventKind::unread) + seance.count(EventKind::cast), 0U) << "it was no spell";
    EXPECT_FALSE(seance.model().primitives.items().empty());
    EXPECT_LT(glm::distance(seance.part<HandState>().home, vec3(-0.06, 0.03, 0)), 1e-9) << "the hand returns";
    EXPECT_NE(seance.model().set_number, before.version + 1) << "other curves are a switch";
}

TEST(OrbModes, AKeyChordStillCasts) {
    Seance seance;
    seance.begin();
    seance.press_key(3);
    const auto before = seance.part<WornModes>();
    seance.hold(Button::trace);
    seance.run(2 * gameplay_period);
    seance.press_key(1);
    seance.release(Button::trace);
    seance.run(2 * gameplay_period);
    EXPECT_EQ(seance.count(EventKind::cast), 1U);
    EXPECT_EQ(seance.part<WornModes>().strength, before.strength);
    EXPECT_EQ(seance.part<WornModes>().worn, before.worn);
    EXPECT_TRUE(seance.scries());
}

TEST(OrbModes, ALeftOrbEndsTheCurveAndCastsNothing) {
    Seance seance;
    seance.begin();
    seance.press_key(3);
    seance.hold(Button::trace);
    seance.run(2 * gameplay_period);
    seance.move_hand({0.03, 0.03, 0});
    seance.release(Button::stir);
    seance.run(2 * gameplay_period);
    const auto curve = seance.part<WornModes>().strength[2];
    seance.move_hand({0.03, -0.03, 0});
    seance.release(Button::trace);
    seance.run(2 * gameplay_period);
    EXPECT_EQ(seance.part<WornModes>().strength[2], curve);
    EXPECT_EQ(seance.count(EventKind::unread) + seance.count(EventKind::cast), 0U);
}

TEST(OrbTells, TheOwnOrderAndHealthOnceInALife) {
    Seance seance;
    EXPECT_EQ(seance.count(EventKind::recipe_told), 0U);
    seance.begin();
    seance.put_hand(seance.core_at_hand());
    seance.run(ticks(1.4));
    EXPECT_EQ(seance.count(EventKind::core_near), 1U);
    EXPECT_EQ(seance.count(EventKind::scried), 0U);
    seance.run(ticks(0.2));
    EXPECT_EQ(seance.count(EventKind::scried), 1U);
    EXPECT_NEAR(seance.newest(EventKind::scried).amount, 25, 1e-12);
    EXPECT_GT(seance.part<Health>().points, 124);
    EXPECT_EQ(seance.count(EventKind::recipe_told), 1U);
    EXPECT_EQ(seance.count(EventKind::recipe_told, 1), 0U) << "only the own order";
    EXPECT_EQ(seance.part<WornModes>().order_told, 1U);
    seance.run(ticks(3));
    EXPECT_EQ(seance.count(EventKind::scried), 1U);
    seance.put_hand({0, 0, 0});
    seance.run(2);
    EXPECT_EQ(seance.count(EventKind::core_lost), 1U);

    seance.change().get<Health>(seance.wizard(0)).points = 0;
    seance.run(2 * gameplay_period);
    EXPECT_FALSE(seance.scries()) << "dead";
    EXPECT_EQ(seance.part<WornModes>().told, 0U);
    EXPECT_EQ(seance.part<WornModes>().order_told, 1U) << "what was told stays told";
}

TEST(OrbTells, HealthStaysBelowItsCap) {
    Seance seance;
    const double cap = seance.match->data().wizard.health_cap;
    seance.change().get<Health>(seance.wizard(0)).points = cap;
    seance.begin();
    seance.put_hand(seance.core_at_hand());
    seance.run(ticks(1.7));
    ASSERT_EQ(seance.count(EventKind::scried), 1U);
    EXPECT_LT(seance.newest(EventKind::scried).amount, 3) << "what has decayed";
    EXPECT_LE(seance.part<Health>().points, cap);
}

TEST(OrbTells, AnInterruptedStayBeginsAnew) {
    Seance seance;
    seance.begin();
    const vec3 core = seance.core_at_hand();
    for (int i = 0; i < 4; ++i) {
        seance.put_hand(core);
        seance.run(ticks(1.2));
        seance.put_hand({0, 0, 0});
        seance.run(10);
    }
    EXPECT_EQ(seance.count(EventKind::scried), 0U);
    EXPECT_EQ(seance.count(EventKind::core_near), 4U);
}

TEST(OrbTells, BothPlayersAtOnce) {
    Seance seance;
    seance.begin(0);
    seance.begin(1);
    ASSERT_TRUE(seance.scries(0) && seance.scries(1));
    seance.press_key(2, 0);
    seance.press_key(4, 1);
    EXPECT_EQ(seance.part<WornModes>(0).worn[0], 1U);
    EXPECT_EQ(seance.part<WornModes>(1).worn[0], 3U);
    seance.put_hand(seance.core_at_hand(0), 0);
    seance.put_hand(seance.core_at_hand(1), 1);
    seance.run(2);
    EXPECT_LT(glm::distance(seance.part<Scrying>(0).place, seance.part<Scrying>(1).place), 0.02)
        << "one core";
    EXPECT_GT(glm::distance(seance.core_at_hand(0), seance.core_at_hand(1)), 0.001) << "seen from two sides";
    seance.run(ticks(1.7));
    EXPECT_EQ(seance.count(EventKind::scried, 0), 1U);
    EXPECT_EQ(seance.count(EventKind::scried, 1), 1U);
    EXPECT_EQ(seance.count(EventKind::recipe_told, 0), 1U);
    EXPECT_EQ(seance.count(EventKind::recipe_told, 1), 1U);
}

TEST(Scrying, GoesOnFromAKeyframe) {
    Seance seance(3), other(3);
    seance.begin(0);
    seance.press_key(4, 0);
    seance.press_key(2, 0);
    seance.hold(Button::trace, 0);
    seance.move_hand({0.02, 0.01, 0}, 0);
    seance.begin(1);
    seance.press_key(6, 1);
    while (seance.match->now() % keyframe_interval != 0) seance.run(1);
    ASSERT_EQ(seance.part<Scrying>(0).drawing, 1U);
    Bytes saved;
    seance.match->save(saved);
    ASSERT_TRUE(other.match->restore(saved, seance.match->now()).has_value());
    other.frame = seance.frame;
    for (int i = 0; i < 40; ++i) {
        for (auto* one : {&seance, &other}) {
            if (i == 10) one->release(Button::trace, 0);
            one->hand(1).counts[input::hand::look_up] = i % 3 - 1;
            one->hand(0).counts[input::hand::look_right] = i % 5 - 2;
            one->run(16);
        }
        ASSERT_EQ(seance.match->state_hash(), other.match->state_hash()) << i;
        ASSERT_EQ(seance.match->force_hash(), other.match->force_hash()) << i;
    }
    EXPECT_TRUE(seance.scries(0) && seance.scries(1));
}

TEST(Scrying, NobodyAtTheOrbCostsNothing) {
    Seance seance;
    seance.run(ticks(0.5));
    for (std::uint32_t player = 0; player < players; ++player) {
        EXPECT_TRUE(seance.model(player).primitives.items().empty());
        EXPECT_EQ(seance.model(player).set_number, 0U);
    }
    const auto calls = [&] {
        auto& schedule = seance.match->live();
        for (std::size_t i = 0; i < schedule.size(); ++i)
            if (schedule.system(i).name == "orb probes") return schedule.counted(i).calls;
        return std::uint64_t{99};
    };
    seance.match->live().reset_counts();
    seance.run(100);
    EXPECT_EQ(calls(), 0U);
    seance.begin();
    EXPECT_GT(calls(), 0U);
    seance.press_key(1);
    EXPECT_FALSE(seance.model().primitives.items().empty());
    seance.release(Button::stir);
    seance.run(2 * gameplay_period);
    EXPECT_TRUE(seance.model().primitives.items().empty());
}

TEST(Scrying, EditedRulesKeepDrawnCurves) {
    Seance seance;
    seance.begin();
    seance.press_key(3);
    seance.change().get<WornModes>(seance.wizard(0)).strength[0] = field::constant(0.25);
    const auto before = seance.part<WornModes>();
    const auto next = seance.match->continued_with(duel_data({"orb.core.hold_s=3"}));
    const auto wizard = wizard_of(next->world(), 0);
    EXPECT_EQ(next->world().get<WornModes>(wizard).strength[0], field::constant(0.25));
    EXPECT_EQ(next->world().get<WornModes>(wizard).worn, before.worn);
    EXPECT_TRUE(next->world().has<Scrying>(wizard));
    EXPECT_EQ(next->world().single<Orb>().seed, seance.orb().seed);
    next->tick(seance.frame);
}

}  // namespace
}  // namespace thaum::game::test

// Adds an effect by this source file alone, without a change of the game's files, and gives it to a potion, a
// spell, a power-up and the orb by their data files. The effects of the game are in game/effects/NAME.cpp.
#include <gtest/gtest.h>

#include "game/context/effects.h"
#include "seams/assets.h"
#include "unit/kitchen_rig.h"
#include "unit/message_of.h"

namespace thaum::game::test {
namespace {

/// How often a wizard has giggled.
struct Giggles {
    double count{};
    THAUM_COMPONENT(Giggles, count);
};

class Giggle final : public Effect {
public:
    explicit Giggle(const ConfigTable& entry) : each_time_(entry.number("giggles", {0, 100})) {}

    void begin(const EffectUse& use) const override {
        if (!use.context.world.has<Giggles>(use.wizard))
            use.context.world.commands().add(use.wizard, Giggles{});
    }
    void step(const EffectUse& use) const override {
        if (auto* giggles = use.context.world.find<Giggles>(use.wizard))
            giggles->count += each_time_ * use.strength;
    }
    void over(const EffectUse& use) const override {
        use.context.world.commands().remove<Giggles>(use.wizard);
    }
    void lost(const EffectUse& use) const override {
        auto& world = use.context.world;
        if (world.has<Giggles>(use.wizard)) world.commands().remove<Giggles>(use.wizard);
    }
    ecs::Mask writes(const ecs::World& world) const override { return world.mask<Giggles>(); }

private:
    double each_time_;
};

const EffectRegistration registration({
    .name = "giggle",
    .lasts = true,
    .declare = [](ecs::World& world) { world.declare<Giggles>(); },
    .read = read_effect<Giggle>,
});

constexpr std::string_view giggle_toml = R"(version = 1
[[ingredient]]
name = "salt"
least = 0.1
most = 1.0
[[ingredient]]
name = "down"
least = 0.1
most = 1.0
[[stroke]]
gesture = "v"
[fluid]
lasts_s = 20
[[effect]]
kind = "giggle"
giggles = 3
lasts_s = 2
[[effect]]
kind = "pace"
factor = 1.5
lasts_s = 1
[look]
colour = [1.0, 1.0, 1.0]
effect = "you giggle"
)";

/// Another entry of a list of effects. `list`: "effect", or "vial.effect" in a rule set.
std::string giggling(std::string_view list) {
    return text("\n[[", list, "]]\nkind = \"giggle\"\ngiggles = 1\nlasts_s = 2\n");
}

const std::filesystem::path& with_giggle() {
    static SeamAssets assets;
    static const bool added = [] {
        assets.add("potions", "giggle.toml", giggle_toml);
        assets.append("spells", "shield.toml", giggling("effect"));
        assets.append("rules", "thaum.toml", giggling("vial.effect"));
        assets.append(".", "orb.toml", giggling("effect"));
        assets.append("rules", "classic.toml",
                      "\n[[spark.effect]]\nkind = \"gravity\"\nfactor = 0.4\nlasts_s = 10\n"
                      "[[heart.effect]]\nkind = \"shield\"\nabsorbs_hp = 30\nlasts_s = 60\n");
        return true;
    }();
    EXPECT_TRUE(added);
    return assets.path();
}

/// Index of the gesture "v" in the list of the game's gestures.
constexpr std::uint32_t v = 3;

void brew_giggle(Kitchen& kitchen) {
    kitchen.drop("salt");
    kitchen.drop("down");
    kitchen.draw(drawn(v, 1));
    kitchen.run(2 * gameplay_period);
}

/// A match in the game's arena with the giggles in the data. The test's input in `sample` moves player 1.
struct Duel {
    explicit Duel(const DataChoice& choice = {})
        : match(std::make_shared<const MatchData>(load_match_data(with_giggle(), choice).value()),
                {1, {{.player = 0, .kind = input::DeviceKind::script, .name = "one"}}}) {}

    Simulation match;
    input::DeviceSample sample;

    ecs::Entity wizard() const { return wizard_of(match.world(), 0); }
    void run(Tick length) {
        input::InputFrame frame;
        frame.devices[0] = sample;
        for (Tick t = 0; t < length; ++t) match.tick(frame);
    }
    void place(vec3 body_centre) {
        auto& motion = match.world_to_change().get<Motion>(wizard());
        motion.position = body_centre;
        match.physics().set_state(wizard().index, motion);
    }
    /// Giggles in a gameplay tick.
    double rate() {
        const auto count = [&] {
            const auto* giggles = match.world().find<Giggles>(wizard());
            return giggles == nullptr ? 0 : giggles->count;
        };
        const double before = count();
        run(100 * gameplay_period);
        return (count() - before) / 100;
    }
};

TEST(NewEffect, APotionGivesItUntilItsTimeIsUp) {
    Kitchen kitchen({}, 1, with_giggle());
    brew_giggle(kitchen);
    EXPECT_EQ(kitchen.brewed(), "giggle");
    const auto* giggles = kitchen.world().find<Giggles>(kitchen.wizard(0));
    ASSERT_NE(giggles, nullptr);
    const auto before = giggles->count;
    kitchen.run(10 * gameplay_period);
    EXPECT_EQ(kitchen.world().get<Giggles>(kitchen.wizard(0)).count, before + 30);
    EXPECT_FALSE(kitchen.world().has<Giggles>(kitchen.wizard(1)));
    kitchen.run(ticks(1.0));
    EXPECT_EQ(kitchen.count(EventKind::potion_over), 0U) << "one of two effects is over";
    kitchen.run(ticks(1.0));
    EXPECT_EQ(kitchen.count(EventKind::potion_over), 1U);
    EXPECT_FALSE(kitchen.world().has<Giggles>(kitchen.wizard(0)));
}

TEST(NewEffect, DeathTakesIt) {
    Kitchen kitchen({}, 1, with_giggle());
    brew_giggle(kitchen);
    ASSERT_TRUE(kitchen.world().has<Giggles>(kitchen.wizard(0)));
    kitchen.world().get<Health>(kitchen.wizard(0)).points = 0;
    kitchen.run(2 * gameplay_period);
    EXPECT_FALSE(kitchen.world().has<Giggles>(kitchen.wizard(0)));
    EXPECT_EQ(kitchen.effects(0), Effects{});
}

TEST(NewEffect, ASpellGivesItStrongerByAHarshStroke) {
    for (const bool harsh : {false, true}) {
        Duel duel;
        duel.sample.press(input::Button::trace);
        if (harsh) duel.sample.press(input::Button::fire);
        duel.run(16);
        duel.sample.wand = 1;
        duel.run(16);
        duel.sample = {};
        duel.run(2 * gameplay_period);
        const double strength = harsh ? duel.match.data().casting->harsh_strength : 1;
        EXPECT_GT(duel.match.world().get<Health>(duel.wizard()).ward, 0) << "the shield is there, too";
        EXPECT_NEAR(duel.rate(), strength, 1e-9);
    }
}

TEST(NewEffect, APowerUpGivesItAlsoToAWizardOfFullHealth) {
    Duel duel;
    auto& world = duel.match.world_to_change();
    world.get<Health>(duel.wizard()).points = duel.match.data().wizard.health_cap;
    vec3 place{};
    world.view<const PowerUp, const Motion>().each([&](const PowerUp& one, const Motion& motion) {
        if (one.kind == PowerUpKind::vial) place = motion.position;
    });
    duel.place(place + vec3(0, duel.match.data().wizard.height / 2, 0));
    duel.run(2 * gameplay_period);
    EXPECT_EQ(count_of(duel.match, EventKind::power_up), 1U);
    EXPECT_NEAR(duel.rate(), 1, 1e-9);
}

TEST(Effects, AWizardOfFullHealthTakesAPowerUpForAShieldAndTheDyingAreNotHealed) {
    Duel duel({.rules = "classic"});
    auto& context = duel.match.context_to_change();
    auto& world = context.world;
    vec3 place{};
    world.view<const PowerUp, const Motion>().each([&](const PowerUp& one, const Motion& motion) {
        if (one.kind == PowerUpKind::heart) place = motion.position;
    });
    duel.place(place + vec3(0, duel.match.data().wizard.height / 2, 0));
    world.get<Health>(duel.wizard()).points = duel.match.data().wizard.health_cap;
    duel.run(2 * gameplay_period);
    EXPECT_EQ(world.get<Health>(duel.wizard()).ward, 30);
    world.get<Health>(duel.wizard()).points = -1;
    const auto& heart = duel.match.data().rules.power_ups[static_cast<std::size_t>(PowerUpKind::heart)];
    begin_effects(context, duel.wizard(), heart.effects, {.tick = duel.match.match().played});
    EXPECT_EQ(world.get<Health>(duel.wizard()).points, -1);
}

TEST(NewEffect, GivenAgainItBeginsAnewAndOthersOfItsKindActBesides) {
    Duel duel;
    const auto& data = duel.match.data();
    auto& context = duel.match.context_to_change();
    const auto give = [&](const EffectList& list) {
        begin_effects(context, duel.wizard(), list, {.tick = duel.match.match().played});
    };
    ASSERT_EQ(data.recipes[3].name, "haste");
    const auto pace = [&] {
        const auto& effects = duel.match.world().get<Effects>(duel.wizard());
        return factors_of(data.effects, &effects, duel.match.match().played).pace;
    };
    give(data.recipes[3].effects);
    duel.run(ticks(10.0));
    give(data.recipes[3].effects);
    EXPECT_NEAR(pace(), 1.3, 1e-9);
    duel.run(ticks(10.0));
    give(data.recipes[2].effects);
    EXPECT_NEAR(pace(), 1.3 * 1.5, 1e-9) << "the second drink acts for its whole time";
    duel.run(gameplay_period);  // the component of the first giggle is added at the end of a tick
    give(data.orb->effects);
    duel.run(2 * gameplay_period);
    EXPECT_NEAR(duel.rate(), 3 + 1, 0.1) << "of the potion and of the orb";
}

TEST(Effects, ActOnTheWeightAlsoWithoutABrew) {
    const auto fallen = [](bool light) {
        Duel duel({.rules = "classic"});
        EXPECT_FALSE(duel.match.data().cauldron);
        const auto& spark = duel.match.data().rules.power_ups[static_cast<std::size_t>(PowerUpKind::spark)];
        if (light) begin_effects(duel.match.context_to_change(), duel.wizard(), spark.effects, {});
        const vec3 from = duel.match.world().get<Motion>(duel.wizard()).position + vec3(0, 3, 0);
        duel.place(from);
        duel.run(300);
        return from.y - duel.match.world().get<Motion>(duel.wizard()).position.y;
    };
    EXPECT_GT(fallen(false), 0.3);
    EXPECT_NEAR(fallen(true) / fallen(false), 0.4, 0.01);
}

TEST(NewEffect, AFaultOfAListIsToldWithItsLine) {
    const auto refused = [](std::string_view entry) {
        SeamAssets assets;
        assets.add("potions", "giggle.toml", text(giggle_toml, entry));
        return message_of(load_match_data(assets.path(), {}), "accepted");
    };
    EXPECT_EQ(refused("[[effect]]\nkind = \"health\"\npoints = 1\n"), "accepted");
    const auto unknown = refused("[[effect]]\nkind = \"gigle\"\ngiggles = 1\nlasts_s = 1\n");
    EXPECT_NE(unknown.find("potions/giggle.toml:26: "), std::string::npos) << unknown;
    EXPECT_NE(unknown.find("armour, burn, energy"), std::string::npos) << unknown;
    EXPECT_NE(unknown.find("did you mean 'giggle'"), std::string::npos) << unknown;
    EXPECT_NE(refused("[[effect]]\nkind = \"pace\"\nfactor = 2\n").find("lasts_s"), std::string::npos);
    EXPECT_NE(refused("[[effect]]\nkind = \"pace\"\nfactr = 2\nlasts_s = 1\n").find("mean 'factor'"),
              std::string::npos);
    EXPECT_NE(refused("[[effect]]\nkind = \"health\"\npoints = 1\nlasts_s = 1\n").find("lasts_s"),
              std::string::npos)
        << "a kind that acts at once lasts for no time";
    std::string many;
    for (int i = 0; i < 65; ++i) many += "[[effect]]\nkind = \"health\"\npoints = 1\n";
    EXPECT_NE(refused(many).find("at most 64"), std::string::npos);
}

}  // namespace
}  // namespace thaum::game::test

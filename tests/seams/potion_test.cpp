// Adds a potion with a new effect by this source file and one data file, without a change of the game's
// files. The potions of the game are in game/stations/potions/NAME.cpp and assets/potions/NAME.toml.
#include <gtest/gtest.h>

#include "game/data/potion_effect.h"
#include "seams/assets.h"
#include "unit/kitchen_rig.h"

namespace thaum::game::test {
namespace {

/// How often a wizard has giggled.
struct Giggles {
    std::uint64_t count{};
    THAUM_COMPONENT(Giggles, count);
};

class GiggleEffect final : public PotionEffect {
public:
    explicit GiggleEffect(std::uint64_t each_time) : each_time_(each_time) {}

    void drunk(const PotionUse& use) const override {
        use.context.world.commands().add(use.wizard, Giggles{});
    }
    void over(const PotionUse& use) const override {
        use.context.world.commands().remove<Giggles>(use.wizard);
    }
    void lost(const PotionUse& use) const override {
        auto& world = use.context.world;
        if (world.has<Giggles>(use.wizard)) world.commands().remove<Giggles>(use.wizard);
    }
    ecs::Mask writes(const ecs::World& world) const override { return world.mask<Giggles>(); }
    void add_systems(const PotionSystems& to) const override {
        const auto& world = to.context.world;
        to.schedule.add({.name = "giggles",
                         .period = gameplay_period,
                         .writes = world.mask<Giggles>(),
                         .needs = world.mask<Giggles>(),
                         .run = [this](ecs::World& w, Tick) {
                             w.view<Giggles>().each([&](Giggles& giggles) { giggles.count += each_time_; });
                         }});
    }

private:
    std::uint64_t each_time_;
};

const PotionEffectRegistration registration({
    .name = "giggle",
    .declare = [](ecs::World& world) { world.declare<Giggles>(); },
    .read = [](const ConfigTable& wizard) -> std::shared_ptr<const PotionEffect> {
        const auto giggles = wizard.integer("giggles", {0, 100}, 0);
        return giggles > 0 ? std::make_shared<GiggleEffect>(giggles) : nullptr;
    },
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
[wizard]
lasts_s = 2
giggles = 3
[look]
colour = [1.0, 1.0, 1.0]
effect = "you giggle"
)";

const std::filesystem::path& with_giggle() {
    static SeamAssets assets;
    static const bool added = (assets.add("potions", "giggle.toml", giggle_toml), true);
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

TEST(NewPotion, ItsEffectActsUntilItsTimeIsUp) {
    Kitchen kitchen({}, 1, with_giggle());
    brew_giggle(kitchen);
    EXPECT_EQ(kitchen.brewed(), "giggle");
    const auto* giggles = kitchen.world().find<Giggles>(kitchen.wizard(0));
    ASSERT_NE(giggles, nullptr);
    const auto before = giggles->count;
    kitchen.run(10 * gameplay_period);
    EXPECT_EQ(kitchen.world().get<Giggles>(kitchen.wizard(0)).count, before + 30);
    EXPECT_FALSE(kitchen.world().has<Giggles>(kitchen.wizard(1)));
    kitchen.run(ticks(2.0));
    EXPECT_EQ(kitchen.count(EventKind::potion_over), 1U);
    EXPECT_FALSE(kitchen.world().has<Giggles>(kitchen.wizard(0)));
}

TEST(NewPotion, DeathTakesItsEffect) {
    Kitchen kitchen({}, 1, with_giggle());
    brew_giggle(kitchen);
    ASSERT_TRUE(kitchen.world().has<Giggles>(kitchen.wizard(0)));
    kitchen.world().get<Health>(kitchen.wizard(0)).points = 0;
    kitchen.run(2 * gameplay_period);
    EXPECT_FALSE(kitchen.world().has<Giggles>(kitchen.wizard(0)));
}

TEST(NewPotion, AKeyThatItDoesNotKnowIsAnError) {
    SeamAssets assets;
    assets.add("potions", "giggle.toml", text(giggle_toml, "[more]\n"));
    EXPECT_FALSE(load_match_data(assets.path(), {}));
}

}  // namespace
}  // namespace thaum::game::test

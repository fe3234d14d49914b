// Tests of the carried ingredient: it is seen above the player's own hand and in the other wizard's.
#include <algorithm>

#include "game/context/match_context.h"
#include "unit/hud_rig.h"

namespace thaum::game::hud_tests {
namespace {

constexpr fvec3 iron{0.45F, 0.47F, 0.55F};

class Carried : public ArenaDrawingTest {
protected:
    Carried() : ArenaDrawingTest(size) {}
    void SetUp() override {
        ArenaDrawingTest::SetUp();
        if (IsSkipped() || HasFatalFailure()) return;
        picture = picture_of(*new_match());
        picture.niches.clear();
        stand(picture, match_data()->wizard, 0, {0, 0, 12}, {0, 1.5, 0});
    }

    /// Balls of iron's colour in a player's view.
    std::vector<render::Instance> balls(std::uint32_t viewer) const {
        std::vector<render::Instance> instances;
        add_instances(arena_scene, picture, viewer, instances);
        std::erase_if(instances, [&](const auto& one) {
            return one.mesh != arena_scene.bead || glm::distance(one.tint, iron) > 1e-3F;
        });
        return instances;
    }

    Picture picture;
};

TEST_F(Carried, IngredientIsInThePictureOfEveryShapeOfView) {
    auto& wizard = picture.wizards[0];
    EXPECT_TRUE(balls(0).empty());
    wizard.carries = "iron";
    wizard.carried_colour = iron;
    const auto seen = balls(0);
    ASSERT_EQ(seen.size(), 3U) << "the heap that lies in a niche";
    for (const auto& ball : seen) {
        const vec3 place =
            glm::inverse(look_rotation(wizard.yaw, wizard.pitch)) * (vec3(fvec3(ball.model[3])) - wizard.eye);
        const double radius = glm::length(fvec3(ball.model[0]));
        EXPECT_LT(glm::distance(place, vec3(own_hand)), 0.2) << "near the wand hand";
        EXPECT_LT(radius, 0.05) << "small";
        for (const double aspect : {320.0 / 480, 640.0 / 720, 1280.0 / 720, 1280.0 / 360, 2560.0 / 540}) {
            const double tall = std::tan(field_of_view(HudSettings{}.fov, aspect) / 2);
            EXPECT_LT((std::abs(place.y) + radius) / -place.z, tall) << aspect;
            EXPECT_LT((std::abs(place.x) + radius) / -place.z, tall * aspect) << aspect;
        }
    }
    wizard.dead = true;
    EXPECT_TRUE(balls(0).empty());
}

TEST(TakePicture, HoldsNameAndColourOfTheCarriedIngredient) {
    const auto match = new_match();
    EXPECT_TRUE(picture_of(*match).wizards[1].carries.empty());
    auto& world = match->world_to_change();
    world.add(wizard_of(world, 1), Pouch{.ingredient = 2});
    const auto picture = picture_of(*match);
    EXPECT_EQ(picture.wizards[1].carries, "iron");
    EXPECT_LT(glm::distance(picture.wizards[1].carried_colour, iron), 1e-3F);
    EXPECT_TRUE(picture.wizards[0].carries.empty());
}

TEST_F(Carried, IngredientIsInTheOtherWizardsHand) {
    auto& foe = picture.wizards[1];
    foe.carries = "iron";
    foe.carried_colour = iron;
    const auto seen = balls(0);
    ASSERT_EQ(seen.size(), 3U);
    for (const auto& ball : seen) {
        const double away = glm::distance(vec3(fvec3(ball.model[3])), foe.centre);
        EXPECT_GT(away, 0.25) << "not hidden in the robe";
        EXPECT_LT(away, 0.6);
    }
    foe.dead = true;
    EXPECT_TRUE(balls(0).empty());
}

}  // namespace
}  // namespace thaum::game::hud_tests

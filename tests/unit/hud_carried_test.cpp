// Tests of ingredients in the picture: above the player's own hand, in the other wizard's hand, and in their
// niches, where players take them.
#include <algorithm>

#include "game/context/match_context.h"
#include "game/scene/figures.h"
#include "game/scene/ingredient_shapes.h"
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

    /// Ingredients with the colour of iron that a player's view shows.
    std::vector<render::Instance> carried(std::uint32_t viewer) const {
        std::vector<render::Instance> instances;
        add_instances(arena_scene, picture, viewer, instances);
        std::erase_if(instances, [&](const auto& one) {
            return glm::distance(one.tint, iron) > 1e-3F ||
                   std::find(arena_scene.ingredients.begin(), arena_scene.ingredients.end(), one.mesh) ==
                       arena_scene.ingredients.end();
        });
        return instances;
    }

    /// Expects that a point (m, eye frame) appears near the wand hand in a view of any shape.
    static void expect_near_hand(vec3 point) {
        EXPECT_LT(glm::distance(point, vec3(own_hand)), 0.25);
        for (const double aspect : {320.0 / 480, 640.0 / 720, 1280.0 / 720, 1280.0 / 360, 2560.0 / 540}) {
            const double tall = std::tan(field_of_view(HudSettings{}.fov, aspect) / 2);
            EXPECT_LT(std::abs(point.y) / -point.z, tall) << aspect;
            EXPECT_LT(std::abs(point.x) / -point.z, tall * aspect) << aspect;
        }
    }

    Picture picture;
};

TEST_F(Carried, IngredientIsInThePictureOfEveryShapeOfView) {
    auto& wizard = picture.wizards[0];
    EXPECT_TRUE(carried(0).empty());
    wizard.stations.carries = "iron";
    wizard.stations.carried_colour = iron;
    for (std::size_t shape = 0; shape < ingredient_shapes; ++shape) {
        SCOPED_TRACE(shape);
        wizard.stations.carried_shape = static_cast<IngredientShape>(shape);
        const auto seen = carried(0);
        ASSERT_EQ(seen.size(), 1U);
        EXPECT_EQ(seen[0].mesh, arena_scene.ingredients[shape]);
        const auto to_eye = glm::inverse(look_rotation(wizard.vitals.yaw, wizard.vitals.pitch));
        for (const auto& vertex : ingredient_mesh(wizard.stations.carried_shape).vertices)
            expect_near_hand(to_eye * (vec3(seen[0].model * fvec4(vertex.position, 1)) - wizard.vitals.eye));
    }
    wizard.vitals.dead = true;
    EXPECT_TRUE(carried(0).empty());
}

TEST(TakePicture, HoldsNameColourAndShapeOfTheCarriedIngredient) {
    const auto match = new_match();
    EXPECT_TRUE(picture_of(*match).wizards[1].stations.carries.empty());
    auto& world = match->world_to_change();
    world.add(wizard_of(world, 1), Pouch{.ingredient = 2});
    const auto picture = picture_of(*match);
    EXPECT_EQ(picture.wizards[1].stations.carries, "iron");
    EXPECT_LT(glm::distance(picture.wizards[1].stations.carried_colour, iron), 1e-3F);
    EXPECT_EQ(picture.wizards[1].stations.carried_shape, IngredientShape::ingots);
    EXPECT_TRUE(picture.wizards[0].stations.carries.empty());
}

TEST_F(Carried, IngredientIsInTheOtherWizardsHand) {
    auto& foe = picture.wizards[1];
    foe.stations.carries = "iron";
    foe.stations.carried_colour = iron;
    const auto seen = carried(0);
    ASSERT_EQ(seen.size(), 1U);
    const double away = glm::distance(vec3(fvec3(seen[0].model[3])), foe.vitals.centre);
    EXPECT_GT(away, 0.25) << "not hidden in the robe";
    EXPECT_LT(away, 0.6);
    foe.vitals.dead = true;
    EXPECT_TRUE(carried(0).empty());
}

TEST_F(Carried, AShadeLiesBelowEachIngredientThatWaits) {
    picture.things.clear();
    for (auto& wizard : picture.wizards) wizard.vitals.dead = true;
    picture.niches = {{.position = {4.5, 0, 0}, .there = true}, {.position = {7, 0, 0}}};
    std::vector<render::Instance> shades, lit;
    add_contact_shades(arena_scene, picture, shades);
    ASSERT_EQ(shades.size(), 1U);
    EXPECT_NEAR(shades[0].model[3].x, 4.5F, 1e-4F);
    add_instances(arena_scene, picture, 0, lit);
    EXPECT_TRUE(std::none_of(lit.begin(), lit.end(), [&](const auto& one) {
        return one.mesh == arena_scene.contact;
    })) << "a shade among lit things is a white sheet on the ground";
}

}  // namespace
}  // namespace thaum::game::hud_tests

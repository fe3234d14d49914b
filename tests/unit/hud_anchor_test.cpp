// Tests of the mark on the anchor (a point in the arena) to which the wand's rope would attach.

#include "unit/hud_rig.h"

namespace thaum::game::hud_tests {
namespace {

class AnchorMark : public ArenaDrawingTest {
protected:
    AnchorMark() : ArenaDrawingTest(size) {}
    void SetUp() override {
        ArenaDrawingTest::SetUp();
        if (IsSkipped() || HasFatalFailure()) return;
        picture = picture_of(*new_match());
    }

    ThingPicture anchor() const {
        for (const auto& thing : picture.things)
            if (thing.key.surface == Surface::anchor) return thing;
        ADD_FAILURE() << "no anchor";
        return {};
    }
    /// The marks (drawn as cages) in a player's view around the anchor to which the player's rope would
    /// attach.
    std::vector<render::Instance> marks(std::uint32_t viewer) const {
        std::vector<render::Instance> instances;
        add_instances(arena_scene, picture, viewer, instances);
        std::erase_if(instances,
                      [&](const auto& one) { return one.mesh != arena_scene.teams[viewer].burst; });
        return instances;
    }

    Picture picture;
};

TEST_F(AnchorMark, IsOnTheAnchorInThatPlayersViewOnly) {
    auto& wizard = picture.wizards[1];
    EXPECT_TRUE(marks(1).empty());
    wizard.wand.target = {.kind = TargetKind::hook};
    EXPECT_TRUE(marks(1).empty()) << "a point of a wall";
    const auto thing = anchor();
    wizard.wand.target.thing = {thing.entity, 0};
    for (const double away : {3.0, 30.0}) {
        wizard.vitals.eye = thing.position + vec3(away, 0, 0);
        const auto seen = marks(1);
        ASSERT_EQ(seen.size(), 1U);
        EXPECT_LT(glm::distance(fvec3(seen[0].model[3]), fvec3(thing.position)), 1e-4F);
        const double radius = glm::length(fvec3(seen[0].model[0]));
        EXPECT_GT(radius, 2.6 * thing.key.size.x) << "round the rings of the anchor";
        EXPECT_GT(radius / away, 0.025) << "seen from afar";
        EXPECT_LT(radius, 1.5);
    }
    EXPECT_TRUE(marks(0).empty());
}

}  // namespace
}  // namespace thaum::game::hud_tests

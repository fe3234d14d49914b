// Tests of the paths along which a hand is moved in the volume lab.
#include <gtest/gtest.h>

#include "game/lab/hand_path.h"

namespace thaum::game {
namespace {

TEST(HandPath, GoesWhereItSays) {
    const vec3 workspace(0.16, 0.12, 0.07);
    const auto press = *hand_path("press");
    EXPECT_GT(wanted_place(press, workspace, 0).y, 0.05);
    EXPECT_LT(wanted_place(press, workspace, 2).y, -0.05);
    // A hand that is moved by a mouse begins on the viewer's side, just inside the workspace.
    EXPECT_EQ(place_before({0, 0, 1}, {0.2, 0.1, 0.3}), vec3(0, 0, 0.147));
    EXPECT_LT(glm::distance(place_before({0, 0.8, -0.6}, {0.2, 0.1, 0.3}), vec3(0, 0.049, -0.03675)), 1e-12);
    EXPECT_FALSE(hand_path("sideways"));
    EXPECT_FALSE(hand_path("/nowhere.csv"));
    auto file = HandPath{HandWay::file, *parse_stir_path("time_s,x_m,y_m,z_m\n1,0,0,0\n2,0.1,0,0\n", "path")};
    EXPECT_EQ(wanted_place(file, workspace, 0), vec3(0));
    EXPECT_DOUBLE_EQ(wanted_place(file, workspace, 1.5).x, 0.05);
    EXPECT_DOUBLE_EQ(wanted_place(file, workspace, 9).x, 0.1);
}

}  // namespace
}  // namespace thaum::game

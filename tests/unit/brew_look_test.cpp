// Tests of the values from which the brew (the cauldron's fluid) is drawn: colours, layers that follow the
// surface, arrows and streamlines.
#include "game/scene/brew_look.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/file.h"
#include "game/scene/brew_flow.h"
#include "game/scene/brew_texels.h"

namespace thaum::game {
namespace {

constexpr BowlPlace bowl{.centre = {0, 0.55, 0}, .size = {.radius = 1.5, .height = 1.1, .thickness = 0.15}};

class BrewLookTest : public testing::Test {
protected:
    void SetUp() override {
        const auto file = read_text_file(THAUM_SOURCE_DIR "/assets/cauldron.toml", 1U << 16U).value();
        const auto config = Config::parse(file, "cauldron.toml", 1).value();
        rules = read_cauldron_rules(config);
        rules.ingredients.resize(3);
        rules.ingredients[0].colour = {1, 0, 0};
        rules.ingredients[1].colour = {0, 1, 0};
        place = brew_place(bowl, rules);
        brew = make_brew(rules, place.basin).value();
    }

    const BrewPicture& taken() {
        take_brew(brew, rules, ++state, picture);
        return picture;
    }

    std::vector<render::Texel> texels() {
        std::vector<float> scratch;
        std::vector<render::Texel> out;
        make_texels(taken(), place, scratch, out);
        return out;
    }

    /// Texel of the drawn brew at a position, which is given in the brew's frame.
    render::Texel texel_at(const std::vector<render::Texel>& all, vec3 at) const {
        const auto& l = brew.fluid.lattice;
        const vec3 cell = (at - brew.corner) / l.h;
        const auto i = static_cast<std::size_t>(cell.x), j = static_cast<std::size_t>(cell.y),
                   k = static_cast<std::size_t>(cell.z);
        return all[i + static_cast<std::size_t>(l.cells[0]) * (j + static_cast<std::size_t>(l.cells[1]) * k)];
    }

    /// Gives the whole brew a rigid rotation about +y (rad/s).
    void turn(double speed) {
        fluid::set_velocity(brew.fluid, [&](vec3 p) {
            const vec3 at = p + brew.corner;
            return speed * vec3(at.z, 0, -at.x);
        });
    }

    void fill(std::uint32_t ingredient, const std::function<double(vec3)>& density) {
        const auto slot = substance_for(brew.contents, ingredient);
        ASSERT_TRUE(slot.has_value());
        assign(brew, rules, *slot, ingredient);
        ASSERT_TRUE(slot);
        fluid::set_substance(brew.fluid, *slot, [&](vec3 p) { return density(p + brew.corner); });
    }

    CauldronRules rules;
    BrewPlace place;
    Brew brew;
    BrewPicture picture;
    std::uint64_t state{};
};

TEST(BrewColour, MixRedGreenToYellow) {
    const BrewColours colours{.base = {0.1F, 0.2F, 0.3F},
                              .substances = {fvec3(1, 0, 0), fvec3(0, 1, 0), fvec3(0, 0, 1)}};
    const auto mix = [&](float r, float g, float b) {
        const Rows densities{std::vector{r}, std::vector{g}, std::vector{b}};
        Rows out;
        game::mix(colours, densities, out);
        return fvec3(out[0][0], out[1][0], out[2][0]);
    };
    const auto near = [](fvec3 a, fvec3 b) { return glm::length(a - b) < 1e-6F; };
    EXPECT_TRUE(near(mix(1, 1, 0), {1, 1, 0})) << "yellow";
    EXPECT_TRUE(near(mix(0.5F, 0.5F, 0), {1, 1, 0})) << "half of each density must give the full brightness";
    EXPECT_TRUE(near(mix(1, 1, 1), {1, 1, 1}));
    EXPECT_TRUE(near(mix(1, 0.5F, 0), {1, 0.5F, 0})) << "orange";
    EXPECT_TRUE(near(mix(0, 0, 0), colours.base));
    EXPECT_TRUE(near(mix(0.25F, 0, 0), glm::mix(colours.base, fvec3(1, 0, 0), 0.25F)));
}

TEST(BrewColour, LadlesAreGreenThenYellowThenRed) {
    for (const double share : {0.0, 0.2, 0.3}) EXPECT_EQ(ladle_colour(share), ladle_colour(0));
    for (const double share : {0.37, 0.5, 0.63}) EXPECT_EQ(ladle_colour(share), ladle_colour(0.5));
    for (const double share : {0.7, 1.0, 50.0}) EXPECT_EQ(ladle_colour(share), ladle_colour(1));
    const auto green = ladle_colour(0), yellow = ladle_colour(0.5), red = ladle_colour(1);
    EXPECT_GT(green.g, 2 * green.r);
    EXPECT_GT(std::min(yellow.r, yellow.g), 2 * yellow.b);
    EXPECT_GT(red.r, 2 * red.g);
}

TEST_F(BrewLookTest, SubstancesAreSeenWhereTheyAre) {
    const auto is_left = [](vec3 p) { return p.x < 0 ? 1.0 : 0.0; };
    fill(0, is_left);
    fill(1, [](vec3 p) { return p.z < 0 ? 1.0 : 0.0; });
    const auto all = texels();
    const vec3 down(0, -0.3, 0);
    const auto red = texel_at(all, down + vec3(-0.5, 0, 0.5)),
               green = texel_at(all, down + vec3(0.5, 0, -0.5)),
               yellow = texel_at(all, down + vec3(-0.5, 0, -0.5)),
               base = texel_at(all, down + vec3(0.5, 0, 0.5));
    EXPECT_GT(red.r, 80);
    EXPECT_EQ(red.g, 0);
    EXPECT_EQ(green.r, 0);
    EXPECT_GT(green.g, 80);
    EXPECT_EQ(yellow.r, yellow.g);
    EXPECT_GT(yellow.r, 80);
    EXPECT_EQ(yellow.b, 0);
    EXPECT_GT(base.r, base.b) << "the brew's own amber";
    EXPECT_EQ(red.a, 255);
    EXPECT_LT(base.a, 200);
}

TEST_F(BrewLookTest, ASideThatFacesUpIsLighter) {
    fill(0, [](vec3 p) { return std::exp(-10 * glm::dot(p + vec3(0, 0.4, 0), p + vec3(0, 0.4, 0))); });
    const auto all = texels();
    EXPECT_GT(texel_at(all, {0, -0.22, 0}).r, texel_at(all, {0, -0.58, 0}).r + 10);
}

TEST_F(BrewLookTest, LayersFollowTheSurfaceLessTheDeeperTheyAre) {
    // The density grows linearly with depth. The density found in a layer therefore shows how far the layer
    // was lifted.
    const double depth = place.basin.depth;
    const auto ramp = [&](vec3 p) { return std::clamp(-p.y / depth, 0.0, 1.0); };
    fill(0, ramp);
    const auto level = texels();
    const double lift = 0.12;
    for (auto& height : brew.surface.height) height = lift;
    fluid::refresh_after_edit(brew.surface);
    const auto lifted = texels();
    // The texel's alpha is linear in the density, so the density of each layer follows from it.
    const auto density = [&](const std::vector<render::Texel>& all, double y) {
        return static_cast<double>(texel_at(all, {0.02, y, 0.02}).a) / 255;
    };
    const double h = brew.fluid.lattice.h;
    const double per_m = (density(level, -0.7) - density(level, -0.2)) / 0.5;
    ASSERT_GT(per_m, 0.3);
    for (const int layer : {2, 4, 6, 8}) {
        const double y = -(layer + 0.5) * h;
        const double seen = (density(lifted, y) - density(level, y)) / per_m;
        EXPECT_NEAR(seen, lift * fluid::transmitted(brew.surface.settings, -y, 1), 0.012)
            << "layer " << layer;
    }
}

TEST_F(BrewLookTest, TheSkinFollowsTheSurfaceAndFoamsWhereItIsSteep) {
    std::vector<render::SkinVertex> skin;
    make_skin(taken().surface, place, skin);
    for (const auto& v : skin) {
        EXPECT_EQ(v.normal, fvec3(0, 1, 0));
        const double out = std::hypot(v.position.x, v.position.z);
        EXPECT_LT(out, place.basin.radius);
        EXPECT_NEAR(v.position.y, place.middle.y, 1e-6);
        if (out < 0.8 * width_at(place.basin, 0)) {
            EXPECT_EQ(v.foam, 0);
        }
    }
    // The surface gets a slope of 1/2 along x.
    const auto& s = brew.surface.settings;
    for (std::size_t z = 0; z < s.nodes; ++z) {
        for (std::size_t x = 0; x < s.nodes; ++x)
            brew.surface.height[fluid::surface_node_index(s, x, z)] =
                0.5 * (static_cast<double>(x) * fluid::surface_node_spacing(s) - s.side / 2);
    }
    brew.surface.asleep = 0;
    make_skin(taken().surface, place, skin);
    const fvec3 expected = glm::normalize(fvec3(-0.5F, 1, 0));
    for (const auto& v : skin) {
        EXPECT_NEAR(v.position.y - static_cast<float>(place.middle.y), 0.5F * v.position.x, 1e-3F);
        EXPECT_LT(glm::length(v.normal - expected), 0.02F);
        EXPECT_GT(v.foam, 0.2F);
    }
    std::vector<std::uint32_t> indices;
    make_skin_indices(indices);
    EXPECT_LT(*std::max_element(indices.begin(), indices.end()), skin.size());
    for (std::size_t t = 0; t < indices.size(); t += 3) {
        const auto at = [&](std::size_t i) { return skin[indices[t + i]].position; };
        EXPECT_GT(glm::cross(at(1) - at(0), at(2) - at(0)).y, 0) << "seen from above";
    }
}

TEST_F(BrewLookTest, AStreamlineOfSolidRotationCloses) {
    turn(2);
    const double radius = 0.5;
    for (const double step : {0.1, 0.05}) {
        std::vector<vec3> line;
        follow(taken(), vec3(radius, -0.3, 0) - brew.corner, 2 * pi * radius, step, line);
        ASSERT_GT(line.size(), 20U);
        EXPECT_LT(glm::length(line.back() - line.front()), 1e-3) << "step " << step;
        for (const vec3 p : line) {
            EXPECT_NEAR(off_axis(p + brew.corner), radius, 1e-3);
            EXPECT_NEAR(p.y, line.front().y, 1e-9);
        }
    }
}

TEST_F(BrewLookTest, AStreamlinesErrorGoesWithTheFourthPowerOfItsStep) {
    turn(2);
    // One metre along a circle of radius 0.5 m is an angle of two radians.
    const auto on_circle = [](double angle) {
        return vec3(0.5 * std::cos(angle), -0.3, -0.5 * std::sin(angle));
    };
    const auto error = [&](int steps) {
        std::vector<vec3> line;
        follow(taken(), on_circle(0) - brew.corner, 1, 1.0 / steps, line);
        EXPECT_EQ(line.size(), static_cast<std::size_t>(steps) + 1);
        return glm::distance(line.back() + brew.corner, on_circle(2));
    };
    // With smaller steps, the errors would be close to the rounding errors of the flow's samples.
    for (const int steps : {4, 8})
        EXPECT_NEAR(std::log2(error(steps) / error(2 * steps)), 4, 0.25)
            << steps << " steps: " << error(steps);
}

TEST_F(BrewLookTest, StreamlinesGrowFromTheirTailsAlongTheFlow) {
    const BrewMeshes meshes;
    std::vector<render::Instance> pieces;
    add_streamlines(taken(), place, meshes, pieces);
    EXPECT_TRUE(pieces.empty()) << "at rest";
    turn(1);
    add_streamlines(taken(), place, meshes, pieces);
    ASSERT_GT(pieces.size(), 200U);
    EXPECT_LE(pieces.size(), 30U * 20U);
    std::size_t lines = 1;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const fvec3 from(pieces[i].model[3]), along(pieces[i].model * fvec4(0, 0, -1, 0));
        const vec3 at = vec3(from) - place.middle;
        EXPECT_GT(glm::dot(vec3(along), vec3(at.z, 0, -at.x)), 0);
        if (i == 0) continue;
        const auto& before = pieces[i - 1].model;
        const bool goes_on = glm::distance(fvec3(before[3] - before[2]), from) < 1e-4F;
        if (!goes_on) ++lines;
        EXPECT_EQ(glm::length(pieces[i].model[0]) > glm::length(before[0]), goes_on);
        EXPECT_EQ(glm::length(pieces[i].tint - picture.colours.base) >
                      glm::length(pieces[i - 1].tint - picture.colours.base),
                  goes_on);
    }
    EXPECT_GT(lines, 20U);
    EXPECT_LE(lines, 30U);
}

TEST_F(BrewLookTest, ArrowsPointAlongTheFlowAndAreLongerWhereItIsFaster) {
    const BrewMeshes meshes;
    std::vector<render::Instance> arrows;
    add_arrows(taken(), place, meshes, arrows);
    EXPECT_TRUE(arrows.empty()) << "at rest";
    turn(1);
    add_arrows(taken(), place, meshes, arrows);
    ASSERT_GT(arrows.size(), 100U);
    double shortest = 1, longest = 0;
    for (const auto& arrow : arrows) {
        const fvec3 along(arrow.model * fvec4(0, 0, -1, 0));
        const vec3 middle = vec3(fvec3(arrow.model[3]) + 0.5F * along) - place.middle;
        const vec3 flow(middle.z, 0, -middle.x);
        const double length = glm::length(along);
        EXPECT_NEAR(glm::dot(vec3(along), flow), length * glm::length(flow), 1e-3 * length);
        EXPECT_LT(off_axis(middle), width_at(place.basin, middle.y));
        (glm::length(flow) < 0.3 ? shortest : longest) = length;
    }
    EXPECT_GT(longest, 1.5 * shortest);
}

TEST_F(BrewLookTest, IsMadeAnewOnlyForAnotherStateOrOverlay) {
    BrewLook look;
    look.place = place;
    EXPECT_FALSE(show_brew(picture, {}, look)) << "no picture was taken yet";
    EXPECT_EQ(look.volume.version, 0U);
    turn(1);
    taken();
    EXPECT_TRUE(show_brew(picture, {}, look));
    const auto version = look.volume.version;
    EXPECT_FALSE(show_brew(picture, {}, look));
    EXPECT_EQ(look.volume.version, version);
    EXPECT_TRUE(look.flow.empty());
    EXPECT_TRUE(show_brew(picture, {.arrows = true, .streamlines = true}, look));
    EXPECT_GT(look.flow.size(), 200U);
    EXPECT_GT(look.volume.version, version);
    EXPECT_TRUE(show_brew(taken(), {}, look));
    EXPECT_TRUE(look.flow.empty());
    const auto cells_along = [&](std::size_t axis) {
        return static_cast<std::size_t>(brew.fluid.lattice.cells[axis]);
    };
    EXPECT_EQ(look.volume.texels.size(), cells_along(0) * cells_along(1) * cells_along(2));
    // The box of the volume contains the whole brew.
    EXPECT_NEAR(look.volume.origin.y + look.volume.size.y, place.middle.y, 1e-5);
    EXPECT_LT(look.volume.origin.y, place.middle.y - place.basin.depth + 1e-5);
}

TEST_F(BrewLookTest, NaNAndHugeNumbersBreakNoPicture) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    fill(0, [&](vec3 p) { return p.x < 0 ? nan : 1e30; });
    for (auto& height : brew.surface.height) height = nan;
    for (auto& velocity : brew.surface.velocity) velocity = 1e300;
    brew.surface.asleep = 0;
    BrewLook look;
    look.place = place;
    fluid::set_velocity(brew.fluid, [&](vec3 p) { return p.x < 1 ? vec3(nan) : vec3(1e5, 0, 1e-30); });
    EXPECT_TRUE(show_brew(taken(), {.arrows = true, .streamlines = true}, look));
    for (const auto& v : look.skin) {
        EXPECT_TRUE(std::isfinite(v.position.y) && std::isfinite(v.normal.y) && v.foam >= 0 && v.foam <= 1);
    }
    for (const auto& instance : look.flow) {
        for (int c = 0; c < 4; ++c) EXPECT_TRUE(std::isfinite(glm::length(instance.model[c])));
    }
}

}  // namespace
}  // namespace thaum::game

// Compares a drawn volume with closed forms for the emission and absorption of a uniform medium along a ray
// of known length.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "render/context.h"
#include "render/detail/shaders.h"
#include "render/renderer.h"
#include "unit/picture_part.h"
#include "unit/renderer_rig.h"

namespace thaum::render {
namespace {

constexpr int size = 120;
constexpr float thickness = 1.5F;  // absorption of the medium (1/m)
constexpr float mirrored = 0.02F;  // share of light that water reflects at normal incidence
constexpr Rect whole{0, 0, size, size};
const fquat downwards = glm::angleAxis(-1.5707963F, fvec3(1, 0, 0)),
            upwards = glm::angleAxis(1.5707963F, fvec3(1, 0, 0));

/// An environment without light. Each test adds its own.
Environment darkness() {
    Environment e;
    e.sun.colour = fvec3(0);
    e.ambient = {fvec3(1), fvec3(1)};
    e.fog = {fvec3(0), 0};
    e.sky = {fvec3(0), fvec3(0), fvec3(0)};
    return e;
}

fvec3 middle_of(const Image& image) {
    const auto i = 3 * (static_cast<std::size_t>(image.height / 2) * static_cast<std::size_t>(image.width) +
                        static_cast<std::size_t>(image.width / 2));
    return fvec3(image.rgb[i], image.rgb[i + 1], image.rgb[i + 2]) / 255.0F;
}

/// A ball of radius 1 m about the origin, filled with a uniform medium up to y = 0.
class VolumeTest : public RendererTest<size> {
protected:
    void SetUp() override {
        RendererTest::SetUp();
        if (IsSkipped() || HasFatalFailure()) return;
        for (const float x : {-1.0F, 1.0F}) {
            for (const float z : {-1.0F, 1.0F}) skin.push_back({.position = {x, 0, z}});
        }
        fill({0, 0, 0, 255});
        volume = {.id = renderer->make_volume(),
                  .version = 1,
                  .cells = {2, 2, 2},
                  .texels = texels,
                  .origin = fvec3(-1),
                  .size = fvec3(2, 1, 2),
                  .brightness = 2,
                  .thickness = thickness,
                  .skin = skin,
                  .skin_indices = corners};
        camera = {.position = {0, 3, 0}, .orientation = downwards};
    }

    void fill(Texel with) {
        texels.assign(8, with);
        ++volume.version;
    }

    Frame frame_of(const Volume* shown, Quality quality, Rect viewport = whole) {
        ViewScene view;
        view.camera = camera;
        view.viewport = viewport;
        view.instances = instances;
        view.environment = darkness();
        view.volume = shown;
        return {.width = size, .height = size, .views = {view}, .quality = quality, .bloom = false};
    }

    Image drawn(const Volume* shown, Quality quality = Quality::low) {
        renderer->draw(frame_of(shown, quality));
        return renderer->read_pixels();
    }

    static bool same(const Image& a, const Image& b) { return a.rgb == b.rgb; }

    void stand(fvec3 at, fvec3 scale, fvec3 tint) {
        instances.push_back({.mesh = cube, .model = translated(at) * scaled(scale), .tint = tint});
    }

    static constexpr std::array<std::uint32_t, 6> corners{0, 1, 2, 2, 1, 3};
    std::vector<SkinVertex> skin;
    std::vector<Texel> texels;
    std::vector<Instance> instances;
    Volume volume;
    Camera camera;
};

constexpr float pixel_step = 2.0F / 255;

TEST_F(VolumeTest, AbsorbsLightByTheLawOfBeerAndLambert) {
    stand({0, -3, 0}, {8, 1, 8}, {0.2F, 0.1F, 0.05F});
    for (const auto quality : {Quality::low, Quality::medium}) {
        const auto behind = middle_of(drawn(nullptr, quality));
        ASSERT_GT(behind.r, 0.2F);
        const auto seen = middle_of(drawn(&volume, quality));
        const float left = (1 - mirrored) * std::exp(-thickness * 1);
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(seen[c], left * behind[c], pixel_step);
    }
}

TEST_F(VolumeTest, GivesLightAsLongAsTheWayThroughItIs) {
    fill({255, 128, 0, 255});
    const float half = 128.0F / 255;
    const float given = 1 - std::exp(-thickness * 1), cover = mirrored + (1 - mirrored) * given;
    const fvec3 light = (1 - mirrored) * given * 2.0F * fvec3(1, half * half, 0);
    for (const auto quality : {Quality::low, Quality::medium, Quality::high}) {
        const auto seen = middle_of(drawn(&volume, quality));
        const fvec3 expected = quality == Quality::high ? detail::tone_mapped(light)
                                                        : cover * detail::tone_mapped(light / cover);
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(seen[c], expected[c], pixel_step) << quality_names[static_cast<std::size_t>(quality)];
    }
}

TEST_F(VolumeTest, EndsAtASolidThingInIt) {
    stand({0, -0.9F, 0}, {1, 1, 1}, {0.2F, 0.1F, 0.05F});  // the top is at y = -0.4 m
    const auto behind = middle_of(drawn(nullptr));
    const auto seen = middle_of(drawn(&volume));
    const float left = (1 - mirrored) * std::exp(-thickness * 0.4F);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(seen[c], left * behind[c], pixel_step);
}

TEST_F(VolumeTest, IsHiddenByASolidThingInFront) {
    stand({0, 1, 0}, {3, 0.2F, 3}, {0.2F, 0.1F, 0.05F});
    fill({255, 255, 255, 255});
    for (const auto quality : {Quality::low, Quality::high}) {
        const auto without = drawn(nullptr, quality);
        EXPECT_EQ(middle_of(without), middle_of(drawn(&volume, quality)));
    }
}

TEST_F(VolumeTest, IsSeenFromWithinUpToTheEye) {
    camera.position = {0, -0.2F, 0};
    stand({0, -3, 0}, {8, 1, 8}, {0.2F, 0.1F, 0.05F});
    const auto behind = middle_of(drawn(nullptr));
    const auto seen = middle_of(drawn(&volume));
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(seen[c], std::exp(-thickness * 0.8F) * behind[c], pixel_step);
    // An upward ray leaves the medium at its surface.
    camera.orientation = upwards;
    instances.clear();
    stand({0, 4, 0}, {8, 1, 8}, {0.2F, 0.1F, 0.05F});
    const auto above = middle_of(drawn(nullptr));
    const auto through = middle_of(drawn(&volume));
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(through[c], std::exp(-thickness * 0.2F) * above[c], pixel_step);
}

TEST_F(VolumeTest, ShowsNothingThroughTheWallOfItsVessel) {
    fill({255, 255, 255, 255});
    camera = {.position = {0, -3, 0}, .orientation = upwards};
    EXPECT_TRUE(same(drawn(nullptr), drawn(&volume))) << "the skin is seen from outside only";
}

TEST_F(VolumeTest, FadesIntoTheFog) {
    fill({255, 255, 255, 255});
    auto frame = frame_of(&volume, Quality::low);
    renderer->draw(frame);
    const auto clear = middle_of(renderer->read_pixels());
    frame.views[0].environment.fog = {fvec3(0, 0.5F, 0), 2};
    renderer->draw(frame);
    const auto foggy = middle_of(renderer->read_pixels());
    EXPECT_GT(clear.r, 0.5F);
    EXPECT_LT(foggy.r, pixel_step);
    EXPECT_GT(foggy.g, 0.3F);
}

TEST_F(VolumeTest, HasTheSamePlaceInEveryViewAndSize) {
    fill({255, 0, 0, 255});
    const auto views = split_window(size, size, Split::side_by_side);
    for (const auto quality : {Quality::low, Quality::high}) {
        auto frame = frame_of(&volume, quality, views[0]);
        frame.views.push_back(frame.views[0]);
        frame.views[1].viewport = views[1];
        frame.views[1].camera.position.x = 30;  // the volume is out of this view
        for (const float scale : {1.0F, 0.5F}) {
            frame.internal_scale = scale;
            renderer->draw(frame);
            const auto image = renderer->read_pixels();
            EXPECT_EQ(renderer->statistics().volumes_drawn, 1U);
            int left = 0, right = 0;
            double middle_x = 0, middle_y = 0;
            for (int y = 0; y < size; ++y) {
                for (int x = 0; x < size; ++x) {
                    if (image.rgb[3 * static_cast<std::size_t>(y * size + x)] < 100) continue;
                    ++(x < size / 2 ? left : right);
                    middle_x += x, middle_y += y;
                }
            }
            EXPECT_GT(left, 200);
            EXPECT_EQ(right, 0);
            EXPECT_NEAR(middle_x / left, 0.25 * size - 0.5, 1.0);
            EXPECT_NEAR(middle_y / left, 0.5 * size - 0.5, 1.0);
        }
    }
}

int bright_pixels(const Image& image) {
    int bright = 0;
    for (std::size_t i = 0; i < image.rgb.size(); i += 3) bright += image.rgb[i] >= 100 ? 1 : 0;
    return bright;
}

TEST_F(VolumeTest, StandsInBothViewsOfASplitPictureAsInEachAlone) {
    fill({255, 0, 0, 255});
    for (const auto split : {Split::side_by_side, Split::top_bottom}) {
        const auto views = split_window(size, size, split);
        for (const auto quality : {Quality::low, Quality::medium, Quality::high}) {
            auto frame = frame_of(&volume, quality, views[0]);
            frame.views.push_back(frame.views[0]);
            frame.views[1].viewport = views[1];
            // The second eye is nearer, so the test also detects if the two views are exchanged.
            frame.views[1].camera.position.y = 2.5F;
            renderer->draw(frame);
            const auto both = renderer->read_pixels();
            EXPECT_EQ(renderer->statistics().volumes_drawn, 2U);
            for (std::size_t i = 0; i < 2; ++i) {
                auto alone = frame;
                alone.views = {frame.views[i]};
                renderer->draw(alone);
                const auto seen = part_of(both, views[i]);
                EXPECT_GT(bright_pixels(seen), 200) << "view " << i;
                EXPECT_TRUE(same(seen, part_of(renderer->read_pixels(), views[i]))) << "view " << i;
            }
        }
    }
}

TEST_F(VolumeTest, IsSentOncePerVersion) {
    const auto sent = [&] {
        drawn(&volume);
        return renderer->statistics().volumes_sent;
    };
    EXPECT_EQ(sent(), 1U);
    EXPECT_EQ(sent(), 0U);
    const auto dark = middle_of(drawn(&volume));
    texels.assign(8, {255, 0, 0, 255});
    EXPECT_EQ(sent(), 0U) << "the version is the same";
    EXPECT_EQ(middle_of(drawn(&volume)), dark);
    ++volume.version;
    EXPECT_EQ(sent(), 1U);
    EXPECT_GT(middle_of(drawn(&volume)).r, 0.5F);
    // Texels with another size are sent even if the version is the same.
    texels.assign(1, {0, 255, 0, 255});
    volume.cells = {1, 1, 1};
    volume.texels = texels;
    EXPECT_EQ(sent(), 1U);
    EXPECT_GT(middle_of(drawn(&volume)).g, 0.5F);
}

TEST_F(VolumeTest, AnInvalidVolumeIsNotDrawn) {
    fill({255, 255, 255, 255});
    const auto without = drawn(nullptr);
    EXPECT_EQ(renderer->statistics().volumes_drawn, 0U);
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const auto refused = [&](auto spoil) {
        auto spoilt = volume;
        spoil(spoilt);
        const bool nothing = same(without, drawn(&spoilt));
        return nothing && renderer->statistics().volumes_drawn == 0;
    };
    EXPECT_FALSE(refused([](Volume&) {}));
    EXPECT_TRUE(refused([](Volume& v) { v.cells = {2, 2, 3}; }));
    EXPECT_TRUE(refused([](Volume& v) { v.cells = {-2, -2, 2}; }));
    EXPECT_TRUE(refused([](Volume& v) { v.size.y = 0; }));
    EXPECT_TRUE(refused([&](Volume& v) { v.centre.x = nan; }));
    EXPECT_TRUE(refused([&](Volume& v) { v.radii.z = nan; }));
    EXPECT_TRUE(refused([&](Volume& v) { v.thickness = nan; }));
    EXPECT_TRUE(refused([](Volume& v) { v.skin_indices = {}; }));
}

}  // namespace
}  // namespace thaum::render

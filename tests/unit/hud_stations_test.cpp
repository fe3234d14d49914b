// Tests of the orb and the crystals (stations of the game) in the picture: they are drawn in every view,
// follow the match, and cost no time where they are out of view.
#include <array>
#include <cmath>
#include <cstdlib>
#include <memory>

#include "render/image.h"
#include "unit/hud_rig.h"

namespace thaum::game::hud_tests {
namespace {

using render::Image;

constexpr render::Size window{640, 480};

/// A scene of the court (an arena) with its orb and its crystals.
class Stations : public ArenaDrawingTest {
protected:
    Stations() : ArenaDrawingTest(window) {}

    Image drawn(const Picture& picture, const HudSettings& settings) {
        renderer->draw(make_frame(arena_scene, picture, settings, window_, memory));
        return renderer->read_pixels();
    }
    /// A picture without motion, drawn twice. Scans, such as the voxels of a crystal, are drawn sharply only
    /// in the second picture of an unchanged scene.
    Image settled(const Picture& picture, const HudSettings& settings) {
        drawn(picture, settings);
        return drawn(picture, settings);
    }
    const WizardRules& rules() const { return match_data()->wizard; }

    FrameMemory memory;
};

/// The half of the window that one view covers.
struct Half {
    int left{}, top{}, right{}, bottom{};
};
Half half_of(render::Split split, std::uint32_t player) {
    const auto view = render::split_window(window.width, window.height, split).at(player);
    return {view.x, view.y, view.x + view.width, view.y + view.height};
}

/// Number of pixels of a half that differ by more than `least` in some channel.
int different(const Image& a, const Image& b, const Half& half, int least = 24) {
    int count = 0;
    for (int y = half.top; y < half.bottom; ++y) {
        for (int x = half.left; x < half.right; ++x) {
            const auto i = 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(a.width) +
                                static_cast<std::size_t>(x));
            bool differs = false;
            for (std::size_t c = 0; c < 3; ++c)
                differs = differs || std::abs(int{a.rgb[i + c]} - int{b.rgb[i + c]}) > least;
            count += differs ? 1 : 0;
        }
    }
    return count;
}

/// One wizard in front of the orb, the other one in front of a crystal.
Picture at_both(const Picture& start, const WizardRules& rules, std::uint32_t at_orb) {
    auto picture = start;
    const vec3 orb = picture.orb.middle, crystal = picture.crystals[0].middle;
    const double towards_middle = crystal.z > 0 ? -1.3 : 1.3;
    stand(picture, rules, at_orb, {orb.x + 1.5, 0, orb.z}, orb);
    stand(picture, rules, 1 - at_orb, {crystal.x, 0, crystal.z + towards_middle}, crystal);
    return picture;
}

constexpr std::array splits{render::Split::side_by_side, render::Split::top_bottom};

TEST_F(Stations, OrbAndCrystalAppearInBothHalvesOfBothSplits) {
    const auto start = picture_of(*new_match());
    ASSERT_TRUE(start.orb.there);
    ASSERT_FALSE(start.crystals.empty());
    for (const auto split : splits) {
        for (const std::uint32_t at_orb : {0U, 1U}) {
            const auto picture = at_both(start, rules(), at_orb);
            auto without_flow = picture, without_crystal = picture;
            without_flow.orb.there = false;
            without_crystal.crystals.clear();
            const HudSettings settings{.split = split, .quality = render::Quality::low};
            const auto all = settled(picture, settings);
            const auto no_flow = settled(without_flow, settings),
                       no_crystal = settled(without_crystal, settings);
            const auto orb_half = half_of(split, at_orb), crystal_half = half_of(split, 1 - at_orb);
            EXPECT_GT(different(all, no_flow, orb_half), 900) << at_orb;
            EXPECT_EQ(different(all, no_flow, crystal_half), 0) << at_orb;
            EXPECT_GT(different(all, no_crystal, crystal_half), 900) << at_orb;
            EXPECT_EQ(different(all, no_crystal, orb_half), 0) << at_orb;
        }
    }
}

TEST_F(Stations, RibbonsFollowTheSeedAndTheProbe) {
    auto picture = at_both(picture_of(*new_match()), rules(), 0);
    const HudSettings settings{.watch = Watch::first, .quality = render::Quality::low};
    const Half whole{0, 0, window.width, window.height};
    auto before = picture;
    before.orb.there = false;
    drawn(before, settings);
    drawn(picture, settings);
    EXPECT_EQ(renderer->statistics().meshes_sent, 1U) << "the flow";
    const auto first = drawn(picture, settings);
    EXPECT_EQ(different(first, drawn(picture, settings), whole, 0), 0);
    EXPECT_EQ(renderer->statistics().meshes_sent, 0U) << "a flow that is known is not sent again";
    picture.orb.seed += 1;
    EXPECT_GT(different(first, drawn(picture, settings), whole), 300) << "the ribbons of another flow";
    const auto other = drawn(picture, settings);
    picture.orb.probes[1] = TipPicture{.place = picture.orb.middle + vec3(0.1, 0.1, 0.2)};
    const auto probed = drawn(picture, settings);
    EXPECT_EQ(renderer->statistics().meshes_sent, 1U) << "the ribbon of the probe";
    EXPECT_GT(different(other, probed, whole), 100) << "probe, rod and ribbon of the other wizard";
    picture.orb.probes[1]->place.y -= 0.1;
    drawn(picture, settings);
    EXPECT_EQ(renderer->statistics().meshes_sent, 1U);
}

TEST_F(Stations, OnlyWhoFoundTheCoreSeesIt) {
    auto picture = at_both(picture_of(*new_match()), rules(), 0);
    const HudSettings settings{.watch = Watch::first, .quality = render::Quality::low};
    const Half whole{0, 0, window.width, window.height};
    const auto before = drawn(picture, settings);
    picture.orb.found = {false, true};
    EXPECT_EQ(different(before, drawn(picture, settings), whole, 0), 0) << "the other wizard found it";
    picture.orb.found = {true, false};
    EXPECT_GT(different(before, drawn(picture, settings), whole), 40);
}

TEST_F(Stations, AHoleShowsInTheSamePictureAndSendsOnlyItsBricks) {
    auto picture = at_both(picture_of(*new_match()), rules(), 1);
    const HudSettings settings{.watch = Watch::first, .quality = render::Quality::low};
    const Half whole{0, 0, window.width, window.height};
    const auto rough = drawn(picture, settings);
    EXPECT_GT(renderer->statistics().scan_bricks_sent, 200U) << "all of the crystal";
    drawn(picture, settings);
    EXPECT_EQ(renderer->statistics().scan_bricks_sent, 0U);
    const auto& look = *arena_scene.crystals[0];
    auto carved = std::make_shared<CrystalVoxels>(*look.rough);
    for (std::size_t i = 0; i < carved->density.size(); ++i) {
        const auto x = i % 48, y = i / 48 % 48;
        const auto at = vec2(x, y) - 23.5;
        if (std::hypot(at.x, at.y) < 7) carved->density[i] = 0;
    }
    picture.crystals[0].voxels = carved;
    const auto holed = drawn(picture, settings);
    EXPECT_GT(different(rough, holed, whole), 100);
    EXPECT_GT(renderer->statistics().scan_bricks_sent, 0U);
    EXPECT_LE(renderer->statistics().scan_bricks_sent, 24U) << "a shaft is at most 2 x 2 bricks thick";
    picture.crystals[0].voxels = std::make_shared<CrystalVoxels>(*carved);
    drawn(picture, settings);
    EXPECT_EQ(renderer->statistics().scan_bricks_sent, 0U) << "equal voxels are no change";
}

TEST_F(Stations, UnseenStationsSendAndDrawNothing) {
    auto picture = picture_of(*new_match());
    const vec3 crystal = picture.crystals[0].middle;
    for (const std::uint32_t player : {0U, 1U}) {
        const double away = crystal.z > 0 ? -4 : 4;
        stand(picture, rules(), player, {player == 0 ? 14.0 : 16.0, 0, 0}, {40, 1, away / 100});
    }
    drawn(picture, {.quality = render::Quality::low});
    const auto& statistics = renderer->statistics();
    EXPECT_EQ(statistics.scan_bricks_sent, 0U);
    EXPECT_EQ(statistics.scans_drawn, 0U);
    EXPECT_EQ(statistics.meshes_sent, 2U) << "the crystals from afar, once";
    drawn(picture, {.quality = render::Quality::low});
    EXPECT_EQ(statistics.meshes_sent, 0U);
    EXPECT_EQ(arena_scene.orb->flow.version, 0U) << "no flow is traced for nobody";
}

TEST_F(Stations, ClassicRulesKeepThePaintedOnes) {
    auto loaded = load_match_data(assets, {.rules = "classic"}).value();
    const auto classic = make_arena_scene(*renderer, loaded);
    EXPECT_EQ(classic.orb, nullptr);
    EXPECT_TRUE(classic.crystals.empty());
}

TEST_F(Stations, TheBrewsLookIsMadeOnlyForThoseWhoFaceIt) {
    auto picture = picture_of(*new_match());
    ASSERT_TRUE(picture.cauldron.there);
    const auto& look = *arena_scene.brew;
    const vec3 brew = look.place.middle, behind = brew + vec3(8, 0, 0);
    const auto face = [&](vec3 to) {
        for (std::uint32_t p = 0; p < players; ++p)
            stand(picture, rules(), p, {brew.x + (p == 0 ? 3 : 4), 0, brew.z}, to);
        ++picture.cauldron.brew.state;
        drawn(picture, {});
        return look.shown == picture.cauldron.brew.state;
    };
    EXPECT_TRUE(face(brew));
    EXPECT_FALSE(face(behind));
    EXPECT_TRUE(face(brew + vec3(0, 0, 4))) << "at the edge of the view";
    EXPECT_FALSE(face(behind));
    picture.wizards[1].vitals.dead = true;
    EXPECT_TRUE(face(behind)) << "a dead player looks elsewhere";
}

}  // namespace
}  // namespace thaum::game::hud_tests

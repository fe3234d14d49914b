// Compares fixed scenes with stored pictures by perceptual distance. A person has checked every stored
// picture. After an intended change, check the new pictures and store them:
//
//     THAUM_KEEP_PICTURES=tests/pictures build/release/tests/test_hud
#include <gtest/gtest.h>

#include <cstdlib>
#include <optional>

#include "core/file.h"
#include "core/text.h"
#include "game/bots/bot.h"
#include "game/hud/hud.h"
#include "game/scene/brew_look.h"
#include "render/audit/perceptual.h"
#include "render/context.h"
#include "unit/hud_rig.h"
#include "unit/picture_part.h"
#include "unit/read_png.h"

namespace thaum::game {
namespace {

using render::Image;
using render::part_of;
using render::Quality;

const std::filesystem::path source = THAUM_SOURCE_DIR;
constexpr render::Size window{1278, 720};
constexpr int reduced_by = 3;
// Largest distance allowed from a stored picture: its mean, and the mean of the worst tile (dE*ab, a measure
// of colour differences of which the eye hardly sees 1). On other processors rounding moves some edges by a
// pixel. A missing object changes the picture far more.
constexpr double max_mean = 1, max_worst = 7;

/// Picture reduced to a third of the size. Each pixel is the mean of 3 x 3 pixels.
Image reduced(const Image& in) {
    Image out{in.width / reduced_by, in.height / reduced_by, {}};
    for (int y = 0; y < out.height; ++y) {
        for (int x = 0; x < out.width; ++x) {
            for (int c = 0; c < 3; ++c) {
                int sum = 0;
                for (int k = 0; k < reduced_by * reduced_by; ++k) {
                    const int from_y = reduced_by * y + k / reduced_by,
                              from_x = reduced_by * x + k % reduced_by;
                    const int from = 3 * (from_y * in.width + from_x) + c;
                    sum += in.rgb[static_cast<std::size_t>(from)];
                }
                out.rgb.push_back(static_cast<std::uint8_t>(sum / (reduced_by * reduced_by)));
            }
        }
    }
    return out;
}

std::optional<Image> stored(const std::string& name) {
    return render::read_png(source / "tests/pictures" / (name + ".png"));
}

// Indices of wands in MatchData::wands, which is sorted by name.
constexpr std::uint32_t blast = 0, bolt = 1, lob = 3;

struct Scene {
    Picture picture;
    HudSettings settings;
};

class StoredPictures : public hud_tests::DrawingTest {
protected:
    StoredPictures() : DrawingTest(window) {}
    void SetUp() override {
        DrawingTest::SetUp();
        if (IsSkipped() || HasFatalFailure()) return;
        show("boiling_court");
    }

    /// Makes the scene of an arena.
    void show(const std::string& arena) {
        data =
            std::make_shared<const MatchData>(load_match_data(source / "assets", {.arena = arena}).value());
        arena_scene = make_arena_scene(*renderer, *data);
        Simulation match(data, MatchSetup{1, {bot_device(0, "level_1"), bot_device(1, "level_1")}});
        start = make_picture();
        take_picture(match, start);
    }

    void stand(Picture& p, std::uint32_t player, vec3 feet, vec3 at) const {
        hud_tests::stand(p, data->wizard, player, feet, at);
    }

    Image drawn(const Scene& scene) {
        renderer->draw(make_frame(arena_scene, scene.picture, scene.settings, window, memory));
        return reduced(renderer->read_pixels());
    }

    void expect_stored(const std::string& name, const Image& image) {
        if (const char* keep = std::getenv("THAUM_KEEP_PICTURES"); keep != nullptr) {
            ASSERT_TRUE(render::write_png(source / keep / (name + ".png"), image));
            return;
        }
        const auto known = stored(name);
        ASSERT_TRUE(known) << "tests/pictures/" << name << ".png is missing";
        ASSERT_EQ(known->width, image.width);
        ASSERT_EQ(known->height, image.height);
        const auto d = render::distance(*known, image);
        EXPECT_LT(d.mean, max_mean) << name;
        EXPECT_LT(d.worst, max_worst) << name;
        if (d.mean < max_mean && d.worst < max_worst) return;
        const auto seen = std::filesystem::path(testing::TempDir()) / (name + "_drawn.png");
        EXPECT_TRUE(render::write_png(seen, image));
        ADD_FAILURE() << "look at " << seen;
    }

    void expect_stored(const std::string& name, Scene scene, std::initializer_list<Quality> qualities) {
        for (const auto quality : qualities) {
            scene.settings.quality = quality;
            const auto level = render::quality_names[static_cast<std::size_t>(quality)];
            expect_stored(text(name, "_", level), drawn(scene));
        }
    }

    /// Both wizards stand in the sun and see each other.
    Scene duel() const {
        Scene scene{start, {.split = render::Split::side_by_side}};
        stand(scene.picture, 0, {-9, 0, 1.3}, {-9, 1.1, -1.3});
        stand(scene.picture, 1, {-9, 0, -1.3}, {-9, 1.1, 1.3});
        return scene;
    }

    Scene cauldron() const {
        Scene scene{start, {.watch = Watch::first}};
        stand(scene.picture, 0, {-4.2, 0, 2.6}, {0, 0.9, 0});
        stand(scene.picture, 1, {3.5, 0, -2}, {-4, 1.5, 2.6});
        return scene;
    }

    /// A dark corner that is lit only by a flying bolt.
    Scene night_corner() const {
        Scene scene{start, {.watch = Watch::first}};
        stand(scene.picture, 0, {13.5, 0, -12.5}, {20, 1.2, -19});
        stand(scene.picture, 1, {18, 0, -16.5}, {13, 1.6, -12});
        scene.picture.missiles.push_back({.entity = {},
                                          .player = 1,
                                          .position = {17, 1.3, -17.6},
                                          .velocity = {-20, 0, 20},
                                          .wand = bolt});
        return scene;
    }

    std::shared_ptr<const MatchData> data;
    ArenaScene arena_scene;
    Picture start;
    FrameMemory memory;
};

TEST_F(StoredPictures, StartOfTheDuelInBothSplits) {
    expect_stored("start_stacked", {start, {.split = render::Split::top_bottom}},
                  {Quality::low, Quality::medium, Quality::high});
    expect_stored("start_beside", {start, {.split = render::Split::side_by_side}}, {Quality::medium});
}

TEST_F(StoredPictures, BothWizardsWithTheirMarks) { expect_stored("wizards", duel(), {Quality::medium}); }

TEST_F(StoredPictures, TheCauldronIsTheBrightestThing) {
    expect_stored("cauldron", cauldron(), {Quality::low, Quality::high});
    auto scene = cauldron();
    for (const auto quality : {Quality::low, Quality::medium, Quality::high}) {
        scene.settings.quality = quality;
        const auto image = drawn(scene);
        int best = 0, best_x = 0, best_y = 0;
        // Finds the brightest 8 x 8 pixels, outside the numbers of the HUD.
        for (int y = 50; y + 8 < 180; y += 4) {
            for (int x = 0; x + 8 < image.width; x += 4) {
                int sum = 0;
                for (int k = 0; k < 64; ++k) {
                    const int pixel = (y + k / 8) * image.width + x + k % 8;
                    const auto at = 3 * static_cast<std::size_t>(pixel);
                    for (std::size_t c = 0; c < 3; ++c) sum += image.rgb[at + c];
                }
                if (sum > best) best = sum, best_x = x + 4, best_y = y + 4;
            }
        }
        // The brew, 5 m away in a bowl of radius 1.5 m, is in the middle of the picture.
        EXPECT_NEAR(best_x, 0.5 * image.width, 80);
        EXPECT_NEAR(best_y, 0.5 * image.height, 40);
    }
}

TEST_F(StoredPictures, TheWellFromItsGalleryAndFromItsBottom) {
    show("the_well");
    Scene scene{start, {.watch = Watch::first}};
    stand(scene.picture, 0, {-7.4, 3, 9.6}, {1, 0.5, -1});
    stand(scene.picture, 1, {5.5, 1, -4}, {0, 1.6, 0});
    expect_stored("well_gallery", scene, {Quality::high});
    stand(scene.picture, 0, {9.5, 0, -6.5}, {2, 1.5, -3});
    expect_stored("well_bottom", scene, {Quality::medium});
}

TEST_F(StoredPictures, ABoltLightsTheDark) {
    expect_stored("night", night_corner(), {Quality::low});
    auto dark = night_corner();
    dark.settings.quality = Quality::medium;
    const auto with = drawn(dark);
    dark.picture.missiles.clear();
    EXPECT_GT(render::distance(with, drawn(dark)).mean, max_mean);
}

TEST_F(StoredPictures, AllFiveWandsAsShadowsAndInTheLight) {
    std::vector<render::Instance> instances, fixed, moving;
    add_instances(arena_scene, start, no_player, instances);
    add_casters(arena_scene, start, fixed, moving);
    int placed = 0;
    const auto& wands = start.shown->wands;
    for (const auto* name : {"bolt", "lift", "swing", "blast", "lob"}) {
        const auto number = static_cast<std::size_t>(
            std::find_if(wands.begin(), wands.end(), [&](const auto& w) { return w.name == name; }) -
            wands.begin());
        // The wands float one above the other in front of a wall in the sun, with the tips to the left.
        const auto place = render::translated({-19.4F, 2.95F - 0.44F * static_cast<float>(placed++), 9.7F}) *
                           render::rotated({0, 1, 0}, 3.1415926F);
        moving.push_back({.mesh = arena_scene.wands[number], .model = place});
        instances.push_back(moving.back());
    }
    render::ViewScene view;
    view.viewport = {0, 0, window.width, window.height};
    view.instances = instances;
    view.environment = arena_scene.environment;
    view.camera.position = {-17.6F, 1.9F, 10};
    view.camera.orientation = fquat(look_rotation(pi / 2, 0));
    view.camera.fov_y = 1.15F;
    render::Frame frame{.width = window.width,
                        .height = window.height,
                        .views = {view},
                        .quality = Quality::high,
                        .casters = {fixed, moving}};
    renderer->draw(frame);
    expect_stored("wands_high", reduced(renderer->read_pixels()));
}

/// The bowl of the arena with a simulated brew, seen from any place.
class StoredBrews : public StoredPictures {
protected:
    void SetUp() override {
        StoredPictures::SetUp();
        if (IsSkipped() || HasFatalFailure()) return;
        const auto file = read_text_file(source / "assets/cauldron.toml", 1U << 16U).value();
        const auto config = Config::parse(file, "cauldron.toml", 1).value();
        rules = read_cauldron_rules(config);
        ASSERT_TRUE(data->arena.bowl);
        place = brew_place(*data->arena.bowl, rules);
        brew = make_brew(rules, place.basin).value();
        look = make_brew_look(*renderer, place);
        ASSERT_TRUE(drop(brew, rules, 0, {-0.5, -0.15, 0.3}, 0.45, 0.15));
        ASSERT_TRUE(drop(brew, rules, 5, {0.45, -0.15, -0.2}, 0.45, 0.15));
        EXPECT_TRUE(drop(brew, rules, 5, {0.1, -0.2, 0.55}, 0.4, 0.1));
    }

    /// Stirs in circles. The ladle touches the surface now and then.
    void stir(int steps) {
        constexpr double dt = 0.016;
        for (int i = 0; i < steps; ++i) {
            const double angle = 2 * pi * dt * i;
            const vec3 at(0.6 * std::cos(angle), -0.25, 0.6 * std::sin(angle));
            const vec3 along(-std::sin(angle), 0, std::cos(angle));
            fluid::push(brew.fluid, {at - brew.corner, 0.22, 0.02 * along});
            fluid::advance(brew.fluid, dt);
            const fluid::SurfaceProbe probe{{at.x, at.z}, i % 20 < 10 ? -0.035 : 0.1, 0.12};
            fluid::advance(brew.surface, brew.scratch, {&probe, 1}, dt);
            ladle = LadlePicture{place.middle + at, place.middle + at + vec3(0.25, 0.95, 0.1), 0.8};
        }
    }

    Image seen(vec3 eye, vec3 at, Quality quality, const BrewOverlay& overlay = {}) {
        take_brew(brew, rules, ++state, picture);
        show_brew(picture, overlay, look);
        std::vector<render::Instance> instances, fixed, moving;
        add_instances(arena_scene, start, no_player, instances);
        // Removes the painted surface that an empty bowl shows instead of a brew.
        std::erase_if(instances, [&](const render::Instance& i) {
            return i.mesh == *arena_scene.painted_brew || i.mesh == arena_scene.bubble;
        });
        add_brew(look, instances);
        add_casters(arena_scene, start, fixed, moving);
        if (ladle) {
            add_ladle(look.meshes, *ladle, instances);
            add_ladle(look.meshes, *ladle, moving);
        }
        render::ViewScene view;
        view.viewport = {0, 0, window.width, window.height};
        view.instances = instances;
        view.lights = arena_scene.lights;
        view.environment = arena_scene.environment;
        const vec3 d = at - eye;
        view.camera.position = fvec3(eye);
        view.camera.orientation =
            fquat(look_rotation(std::atan2(-d.x, -d.z), std::atan2(d.y, std::hypot(d.x, d.z))));
        view.camera.fov_y = 0.9F;
        view.volume = &look.volume;
        renderer->draw({.width = window.width,
                        .height = window.height,
                        .views = {view},
                        .quality = quality,
                        .casters = {fixed, moving}});
        return reduced(renderer->read_pixels());
    }

    CauldronRules rules;
    BrewPlace place;
    Brew brew;
    BrewPicture picture;
    BrewLook look;
    std::optional<LadlePicture> ladle;
    std::uint64_t state{};
};

const vec3 before_bowl(-1.7, 2.1, 1.7), in_bowl(0.05, 0.85, -0.05);

TEST_F(StoredBrews, TwoSubstancesAtRest) {
    for (const auto quality : {Quality::low, Quality::medium, Quality::high}) {
        const auto level = render::quality_names[static_cast<std::size_t>(quality)];
        expect_stored(text("brew_rest_", level), seen(before_bowl, in_bowl, quality));
    }
    expect_stored("brew_above", seen({0.01, 3.7, 0}, {0, 0.9, 0}, Quality::medium));
    // Seen from the side and from below, the bowl hides the whole brew.
    const auto low = seen({-3.2, 0.6, 1}, {0, 0.6, 0}, Quality::medium);
    look.volume.texels = {};
    EXPECT_EQ(render::distance(low, seen({-3.2, 0.6, 1}, {0, 0.6, 0}, Quality::medium)).worst, 0);
}

TEST_F(StoredBrews, StirredWithItsFlow) {
    stir(70);
    expect_stored("brew_stirred", seen(before_bowl, in_bowl, Quality::medium));
    expect_stored("brew_flow",
                  seen(before_bowl, in_bowl, Quality::medium, {.arrows = true, .streamlines = true}));
    expect_stored("brew_within", seen({-0.75, 0.7, 0.5}, {0.4, 0.6, -0.1}, Quality::medium));
}

TEST_F(StoredPictures, TheLargestTextInBothSplits) {
    auto scene = duel();
    scene.settings.text_scale = 2.5;
    scene.picture.wizards[0].senses.since_warning_s = 0;
    scene.picture.wizards[0].senses.warning = EventKind::dry;
    scene.picture.feed_lines = 1;
    scene.picture.feed[0] = {.age_s = 1,
                             .event = {.kind = EventKind::death,
                                       .subject = 0,
                                       .by = 1,
                                       .detail = static_cast<std::uint32_t>(hit_kind("bolt_hit"))}};
    expect_stored("text_beside", scene, {Quality::medium});
    scene.settings.split = render::Split::top_bottom;
    expect_stored("text_stacked", scene, {Quality::medium});
}

/// Scenes with both wizards near the bowl, and with one of everything that can be drawn in both views.
class SplitPictures : public StoredBrews {
protected:
    void SetUp() override {
        StoredBrews::SetUp();
        if (IsSkipped() || HasFatalFailure()) return;
        stir(20);
        crowd = start;
        auto& cauldron = crowd.cauldron;
        ASSERT_TRUE(cauldron.there);
        take_brew(brew, rules, ++state, cauldron.brew);
        cauldron.heat = 1;
        for (auto& each : cauldron.ladles) each = ladle;
        stand(crowd, 0, {-3.4, 0, 2.6}, above_bowl);
        stand(crowd, 1, {3.1, 0, 2.9}, above_bowl);
        for (auto& wizard : crowd.wizards) wizard.wand.held = vec3(0.4, 2, -2);
        crowd.missiles.push_back(
            {.entity = {}, .player = 0, .position = {0.6, 1.6, -1}, .velocity = {3, 0, 1}, .wand = bolt});
        crowd.missiles.push_back({.entity = {},
                                  .player = 1,
                                  .position = {-0.7, 1.9, -1},
                                  .velocity = {1, 0, 1},
                                  .wand = lob,
                                  .size = 0.2});
        crowd.burst_count = 1;
        crowd.bursts[0] = {.age_s = 0.1, .player = 1, .place = {0, 1.7, -3}, .radius = 1};
    }

    Image whole(const render::Frame& frame) {
        renderer->draw(frame);
        return renderer->read_pixels();
    }

    /// The same frame with the contents of all views except one removed. The empty views stay, because the
    /// window is cleared to their fog.
    static render::Frame alone(render::Frame frame, std::size_t view) {
        for (std::size_t i = 0; i < frame.views.size(); ++i) {
            if (i == view) continue;
            auto& other = frame.views[i];
            other.instances = other.shades = other.mists = {};
            other.lights = {};
            other.volume = nullptr;
        }
        return frame;
    }

    double without_brew(render::Frame frame, std::size_t view, const Image& seen) {
        for (auto& each : frame.views) each.volume = nullptr;
        return render::distance(seen, part_of(whole(frame), frame.views[view].viewport)).worst;
    }

    void expect_views_alone(render::Size window) {
        const auto frame = make_frame(arena_scene, crowd, settings, window, memory);
        ASSERT_EQ(frame.views.size(), 2U);
        const auto both = whole(frame);
        for (std::size_t i = 0; i < 2; ++i) {
            const auto seen = part_of(both, frame.views[i].viewport);
            const auto d = render::distance(seen, part_of(whole(alone(frame, i)), frame.views[i].viewport));
            EXPECT_LT(d.mean, same_mean) << "view " << i;
            EXPECT_LT(d.worst, same_worst) << "view " << i;
            EXPECT_GT(without_brew(frame, i, seen), max_worst) << "view " << i << " shows no brew";
        }
    }

    static constexpr double same_mean = 0.002, same_worst = 0.3;
    static constexpr vec3 above_bowl{0, 1, 0};
    Picture crowd;
    HudSettings settings;
};

TEST_F(SplitPictures, EachViewIsThatViewDrawnAlone) {
    for (const auto split : {render::Split::side_by_side, render::Split::top_bottom}) {
        for (const auto quality : {Quality::low, Quality::medium, Quality::high}) {
            SCOPED_TRACE(text(split == render::Split::top_bottom ? "stacked " : "beside ",
                              render::quality_names[static_cast<std::size_t>(quality)]));
            settings.split = split;
            settings.quality = quality;
            expect_views_alone({640, 360});
            // In a window higher than 720 px, the views are drawn smaller and enlarged, except at high
            // quality.
            if (quality != Quality::high) expect_views_alone({701, 809});
        }
    }
}

/// The comparison must report each of these changes, because a player would notice them.
TEST_F(StoredPictures, AChangedSceneIsRefused) {
    const auto differs = [&](const Scene& a, const Scene& b) {
        const auto d = render::distance(drawn(a), drawn(b));
        return d.mean >= max_mean || d.worst >= max_worst;
    };
    for (const auto quality : {Quality::low, Quality::medium, Quality::high}) {
        auto whole = duel();
        whole.settings.quality = quality;
        EXPECT_FALSE(differs(whole, whole));
        auto removed = whole;
        stand(removed.picture, 1, {0, -50, 0}, {0, -50, 1});
        removed.picture.wizards[1].vitals.eye = whole.picture.wizards[1].vitals.eye;
        removed.picture.wizards[1].vitals.yaw = whole.picture.wizards[1].vitals.yaw;
        removed.picture.wizards[1].vitals.pitch = whole.picture.wizards[1].vitals.pitch;
        EXPECT_TRUE(differs(whole, removed)) << "a wizard is missing";
        auto other_wand = whole;
        for (auto& w : other_wand.picture.wizards) w.wand.number = blast;
        EXPECT_TRUE(differs(whole, other_wand)) << "another wand in the hand";
    }
}

}  // namespace
}  // namespace thaum::game

// Tests of drawn pictures: both views, meshes, positions of drawn objects, results and captions.
#include "game/hud/layout.h"
#include "game/scene/figures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "core/random.h"
#include "core/text.h"
#include "game/data/event_words.h"
#include "render/context.h"
#include "unit/hud_rig.h"

namespace thaum::game::hud_tests {
namespace {

// ---- drawn pictures ---------------------------------------------------------------------------------------

class Drawn : public ArenaDrawingTest {
protected:
    Drawn() : ArenaDrawingTest(size) {}
    void SetUp() override {
        ArenaDrawingTest::SetUp();
        picture = picture_of(*new_match());
    }

    render::Image draw(const HudSettings& settings) {
        renderer->draw(make_frame(arena_scene, picture, settings, size, memory));
        return renderer->read_pixels();
    }

    static int differing(const render::Image& a, const render::Image& b, const render::Rect& in) {
        int count = 0;
        for (int y = in.y; y < in.y + in.height; ++y) {
            for (int x = in.x; x < in.x + in.width; ++x) {
                const auto i = 3 * (static_cast<std::size_t>(y) * size.width + static_cast<std::size_t>(x));
                count += a.rgb[i] != b.rgb[i] || a.rgb[i + 1] != b.rgb[i + 1] || a.rgb[i + 2] != b.rgb[i + 2];
            }
        }
        return count;
    }

    /// Number of levels of brightness, out of 8, that more than 1 % of the pixels in a rectangle have.
    static int shades(const render::Image& image, const render::Rect& in) {
        std::array<int, 8> levels{};
        for (int y = in.y; y < in.y + in.height; ++y) {
            for (int x = in.x; x < in.x + in.width; ++x) {
                const auto i = 3 * (static_cast<std::size_t>(y) * size.width + static_cast<std::size_t>(x));
                const int sum = image.rgb[i] + image.rgb[i + 1] + image.rgb[i + 2];
                ++levels[static_cast<std::size_t>(sum / 96)];
            }
        }
        const int enough = in.width * in.height / 100;
        return static_cast<int>(
            std::count_if(levels.begin(), levels.end(), [&](int n) { return n > enough; }));
    }

    static HudSettings split(render::Split s) { return {.split = s}; }

    Picture picture;
    FrameMemory memory;
};

constexpr auto both_splits = {render::Split::top_bottom, render::Split::side_by_side};

TEST_F(Drawn, BothViewsShowTheArena) {
    for (const auto s : both_splits) {
        const auto image = draw(split(s));
        for (const auto& view : views_of(split(s), size)) EXPECT_GE(shades(image, view), 3);
    }
}

TEST_F(Drawn, AChangeOfOneViewChangesOnlyItsHalf) {
    for (const auto s : both_splits) {
        picture = picture_of(*new_match());
        const auto before = draw(split(s));
        picture.wizards[0].vitals.yaw += 1;
        // The second player looks away, so that view does not show the first wizard's figure, which has
        // turned.
        const auto after = draw(split(s));
        const auto views = views_of(split(s), size);
        EXPECT_GT(differing(before, after, views[0]), views[0].width * views[0].height / 3);
        EXPECT_LT(differing(before, after, views[1]), views[1].width * views[1].height / 50);
    }
}

TEST_F(Drawn, NumbersChangeInTheirOwnHalf) {
    for (const auto s : both_splits) {
        for (std::uint32_t player = 0; player < players; ++player) {
            picture = picture_of(*new_match());
            const auto before = draw(split(s));
            picture.wizards[player].vitals.health = 37;
            picture.wizards[player].wand.energy = 11;
            const auto after = draw(split(s));
            const auto views = views_of(split(s), size);
            EXPECT_GT(differing(before, after, views[player]), 50);
            EXPECT_EQ(differing(before, after, views[1 - player]), 0);
        }
    }
}

TEST_F(Drawn, TheForceDisplayShowsTheFlowOfANearBrew) {
    ASSERT_TRUE(arena_scene.brew);
    const auto& rules = *match_data()->cauldron;
    auto brew = make_brew(rules, arena_scene.brew->place.basin).value();
    fluid::set_velocity(brew.fluid, [](vec3) { return vec3(0.5, 0, 0); });
    take_brew(brew, rules, 1, picture.cauldron.brew);
    picture.cauldron.there = true;
    picture.wizards[0].vitals.eye = arena_scene.brew->place.middle + vec3(0, 0.8, 2);
    picture.wizards[1].vitals.eye = arena_scene.brew->place.middle + vec3(0, 0.8, 18);
    const auto count = [&](std::uint32_t player, render::MeshId mesh) {
        return std::ranges::count(memory.instances[player], mesh, &render::Instance::mesh);
    };
    for (const bool forces : {true, false, true}) {
        make_frame(arena_scene, picture, {.forces = forces}, size, memory);
        EXPECT_EQ(count(0, arena_scene.brew->meshes.arrow) > 50, forces);
        EXPECT_EQ(count(0, arena_scene.brew->meshes.thread) > 50, forces);
        EXPECT_EQ(count(1, arena_scene.brew->meshes.thread), 0) << "the wizard is too far away";
    }
}

TEST_F(Drawn, ABurstInOnesFaceHidesNothing) {
    const auto shells = [&](double distance) {
        int seen = 0;
        for (const double age : {0.01, 0.1, 0.2, 0.39}) {
            const vec3 place = picture.wizards[0].vitals.eye + vec3(distance, 0, 0);
            picture.burst_count = 1;
            picture.bursts[0] = {.age_s = age, .player = 1, .place = place, .radius = 3.5};
            make_frame(arena_scene, picture, {}, size, memory);
            for (const auto& instance : memory.instances[0]) {
                const double reach = glm::length(fvec3(instance.model[0]));
                if (instance.mesh == arena_scene.teams[1].burst) {
                    EXPECT_GT(distance, 1.2 * reach) << "the burst must not reach the eye";
                    ++seen;
                } else if (instance.mesh == arena_scene.ember) {
                    EXPECT_LT(reach, 0.2 * distance) << "the burst's core must not fill the view";
                }
            }
        }
        return seen;
    };
    EXPECT_EQ(shells(6), 4);
    EXPECT_EQ(shells(1.5), 1);
    EXPECT_EQ(shells(0.2), 0);
}

TEST_F(Drawn, PauseAndResultCoverBothHalves) {
    const auto before = draw({});
    picture.paused = true;
    picture.paused_by = 1;
    const auto paused = draw({});
    picture.phase = Phase::over;
    picture.winner = 0;
    const auto over = draw({});
    for (const auto& view : views_of({}, size)) {
        EXPECT_GT(differing(before, paused, view), view.width * view.height / 2);
        EXPECT_GT(differing(paused, over, view), 100);
    }
}

TEST_F(Drawn, APowerUpIsSeenAndWhenItIsGoneItsRingStays) {
    picture.power_ups = {{.kind = PowerUpKind::vial, .position = {-12, 0, 12}, .returned = 1}};
    const HudSettings alone{.watch = Watch::first};
    const auto view = views_of(alone, size)[0];
    const auto there = draw(alone);
    picture.power_ups[0].returned = 0;
    const auto gone = draw(alone);
    picture.power_ups.clear();
    const auto nothing = draw(alone);
    EXPECT_GT(differing(there, gone, view), 50);
    EXPECT_GT(differing(gone, nothing, view), 10);
}

TEST_F(Drawn, ASinglePlayerHasTheWholeWindow) {
    const HudSettings alone{.watch = Watch::first};
    const auto views = views_of(alone, size);
    EXPECT_EQ(views[0].width, size.width);
    EXPECT_EQ(views[0].height, size.height);
    EXPECT_EQ(views[1].width, 0);
    draw(alone);
    EXPECT_EQ(memory.frame.views.size(), 1U);
}

TEST_F(Drawn, EveryThingOfTheArenaHasAMeshOfItsOwnKind) {
    std::vector<render::Instance> instances;
    add_instances(arena_scene, picture, no_player, instances);
    for (const auto& instance : instances) {
        for (const auto plain : arena_scene.unit_shapes) EXPECT_NE(instance.mesh, plain);
    }
    EXPECT_LE(arena_scene.lights.size(), render::max_lights);
}

/// Position of a point of the first player's own wand as it is drawn (eye frame), for a displacement by the
/// hand.
vec3 own_wand_point(const ArenaScene& arena_scene, Picture& picture, vec3 reach, float along) {
    auto& wizard = picture.wizards[0];
    wizard.wand.reach = reach;
    std::vector<render::Instance> instances;
    add_instances(arena_scene, picture, 0, instances);
    const auto mesh = arena_scene.wands[wizard.wand.number];
    const auto wand = std::find_if(instances.begin(), instances.end(),
                                   [&](const render::Instance& one) { return one.mesh == mesh; });
    EXPECT_NE(wand, instances.end());
    const vec3 place(wand->model * fvec4(0, 0, -along * wand_length, 1));
    return glm::inverse(look_rotation(wizard.vitals.yaw, wizard.vitals.pitch)) * (place - wizard.vitals.eye);
}

void expect_in_view(vec3 point, double aspect, vec3 reach) {
    const double tall = std::tan(field_of_view(HudSettings{}.fov, aspect) / 2);
    EXPECT_LT(point.z, -0.1) << reach.x << ' ' << reach.y << ' ' << reach.z;
    EXPECT_LT(std::abs(point.y / point.z), tall)
        << reach.x << ' ' << reach.y << ' ' << reach.z << " in " << aspect;
    EXPECT_LT(std::abs(point.x / point.z), tall * aspect)
        << reach.x << ' ' << reach.y << ' ' << reach.z << " in " << aspect;
}

TEST_F(Drawn, TheOwnWandStaysInThePictureWhereverTheHandGoes) {
    stand(picture, match_data()->wizard, 0, {0, 0, 12}, {0, 1.5, 0});
    for (const double aspect : {640.0 / 720, 1280.0 / 720, 1280.0 / 360}) {
        for (int i = 0; i < 27; ++i) {
            const vec3 reach = 0.6 * vec3(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
            expect_in_view(own_wand_point(arena_scene, picture, reach, 1), aspect, reach);
        }
        // Displacement of the hand when the mouse pulls it back fully to draw a shot; the whole wand must be
        // in view.
        const vec3 draw(0, -0.51, 0.3);
        for (const float along : {0.5F, 1.0F})
            expect_in_view(own_wand_point(arena_scene, picture, draw, along), aspect, draw);
    }
}

TEST_F(Drawn, SteamRisesFromTheBrewByItsHeat) {
    ASSERT_TRUE(arena_scene.bowl.has_value());
    const auto steam = [&](double heat, double seconds) {
        picture.cauldron.there = true;
        picture.cauldron.heat = heat;
        picture.played_s = seconds;
        std::vector<render::Instance> wisps;
        add_steam(arena_scene, picture, wisps);
        float dense = 0;
        for (const auto& wisp : wisps) {
            const vec3 off = vec3(wisp.model[3]) - *arena_scene.bowl;
            EXPECT_LT(std::hypot(off.x, off.z), 1.2);
            EXPECT_GT(off.y, 0.7);
            EXPECT_LE(wisp.glow, 0.5F);
            dense += wisp.glow;
        }
        return dense;
    };
    for (const double seconds : {0.0, 3.0, 100.0, 3600.0}) {
        EXPECT_GT(steam(0, seconds), 0.2F) << seconds;
        EXPECT_GT(steam(1, seconds), 1.8F * steam(0, seconds)) << seconds;
    }
}

/// Distance along a ray to its entry into the block; infinite if it misses the block.
double entry(const render::Block& block, vec3 eye, vec3 way) {
    double enter = 0, leave = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
        const double a = (block.low[axis] - eye[axis]) / way[axis],
                     b = (block.high[axis] - eye[axis]) / way[axis];
        enter = std::max(enter, std::min(a, b));
        leave = std::min(leave, std::max(a, b));
    }
    return enter <= leave ? enter : std::numeric_limits<double>::infinity();
}

double first_entry(std::span<const render::Block> blocks, vec3 eye, vec3 way) {
    double first = std::numeric_limits<double>::infinity();
    for (const auto& block : blocks) first = std::min(first, entry(block, eye, way));
    return first;
}

TEST_F(Drawn, HidingBlocksLieInsideStone) {
    Random random = random_stream(11, 4);
    const double half = arena_scene.shade.high.x, top = arena_scene.shade.wall_top;
    int hidden = 0;
    for (int i = 0; i < 20000; ++i) {
        const vec3 eye(random.uniform(-half, half), random.uniform(-4, top), random.uniform(-half, half));
        const vec3 way(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
        // Skipped: the eye is inside a block.
        if (first_entry(arena_scene.shade.blocks, eye, way) == 0) continue;
        const double there = first_entry(blocks_seen_from(arena_scene, eye), eye, way);
        if (there == std::numeric_limits<double>::infinity()) continue;
        ++hidden;
        EXPECT_LE(first_entry(arena_scene.shade.blocks, eye, way), there);
    }
    EXPECT_GT(hidden, 5000);
    EXPECT_TRUE(blocks_seen_from(arena_scene, vec3(0, top + 0.1, 0)).empty());
    EXPECT_TRUE(blocks_seen_from(arena_scene, vec3(half + 2, 1, 0)).empty());
}

TEST_F(Drawn, InTheWellNothingIsSeenThroughStone) {
    const auto data = load_match_data(assets, {.arena = "the_well"}).value();
    const auto well = make_arena_scene(*renderer, data);
    EXPECT_EQ(well.shade.low, vec2(-12, -12));
    EXPECT_EQ(well.shade.high, vec2(12, 12));
    EXPECT_EQ(well.shade.wall_top, 10);
    EXPECT_EQ(well.shade.depth, 0);
    Random random = random_stream(12, 4);
    int hidden = 0;
    for (int i = 0; i < 20000; ++i) {
        const vec3 eye(random.uniform(-12, 12), random.uniform(0, 10), random.uniform(-12, 12));
        const vec3 way(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
        if (first_entry(well.shade.blocks, eye, way) == 0) continue;  // skipped: the eye is in stone
        const double there = first_entry(blocks_seen_from(well, eye), eye, way);
        if (there == std::numeric_limits<double>::infinity()) continue;
        ++hidden;
        EXPECT_LE(first_entry(well.shade.blocks, eye, way), there);
    }
    EXPECT_GT(hidden, 5000);
}

TEST_F(Drawn, ContactShadeFollowsRampsAndHangsOverNoEdge) {
    picture.things.clear();
    picture.niches.clear();
    picture.wizards[1].vitals.dead = true;
    const auto shades_at = [&](vec3 feet) {
        picture.wizards[0].vitals.centre = feet + vec3(0, match_data()->wizard.height / 2, 0);
        std::vector<render::Instance> out;
        add_contact_shades(arena_scene, picture, out);
        return out;
    };
    const auto level = shades_at({-15, 0, 15});
    ASSERT_EQ(level.size(), 1U);
    EXPECT_EQ(level[0].model[0].y, 0);
    EXPECT_NEAR(level[0].tint.r, 1, 1e-3);
    // The ramp out of the pit descends from a height of 0 at x = 8 m to -5 m at x = 0.
    const auto tilted = shades_at({4, -2.5, 9});
    ASSERT_EQ(tilted.size(), 1U);
    EXPECT_NEAR(tilted[0].model[0].y / tilted[0].model[0].x, 5.0 / 8, 1e-5);
    EXPECT_NEAR(tilted[0].model[3].y, -2.5, 0.05);
    const auto edge = shades_at({-5, 0, 5.6});  // a wizard 0.4 m from the edge of the pit
    ASSERT_EQ(edge.size(), 1U);
    EXPECT_LT(glm::length(edge[0].model[2]), 0.4F);
    EXPECT_LT(shades_at({-15, 1.5, 15})[0].tint.r, 0.5F) << "weaker in a jump";
    EXPECT_TRUE(shades_at({-15, 3, 15}).empty());
}

TEST(WandLook, AFaultyPartIsRefusedWithItsLine) {
    const auto read = [](const std::string& part) {
        const auto file =
            Config::parse(text("version = 1\n[look]\n[[look.wand]]\n", part), "wand.toml", 1).value();
        const auto look = read_wand_look(file.root().table("look"));
        const auto checked = file.check();
        return std::pair(look, checked ? std::string() : checked.error().message);
    };
    const auto [look, fault] = read("shape = \"ball\"\nradius = 0.1\ncolour = \"#102030\"\n");
    EXPECT_EQ(fault, "");
    ASSERT_EQ(look.wand.size(), 1U);
    EXPECT_EQ(look.wand[0].colour, 0x102030U);
    const auto says = [&](const std::string& part, std::string_view line) {
        EXPECT_NE(read(part).second.find(line), std::string::npos) << read(part).second;
    };
    says("shape = \"banana\"\nradius = 0.1\ncolour = \"glow\"\n", "wand.toml:4");
    says("shape = \"ball\"\nradius = 0.1\ncolour = \"green\"\n", "wand.toml:6");
    says("shape = \"rod\"\nradius = 0.1\ncolour = \"glow\"\nfrom = [0, 0, 1]\nto = [0, 0, 1]\n",
         "wand.toml:8");
    says("shape = \"cage\"\nradius = 0.1\ncolour = \"glow\"\nthickness = 0.1\nbend = 1\n", "wand.toml:8");
}

TEST_F(Drawn, TrianglesStayWithinTheBudget) {
    draw({});
    EXPECT_LT(renderer->statistics().triangles, 2U * 26000U);
    // Each coarser copy of a mesh needs a draw call of its own.
    EXPECT_LT(renderer->statistics().draws, 120U);
}

TEST(Result, ShowsTheWinnersOfRoundAndMatchAndTheStatistics) {
    auto p = picture_of(*new_match());
    p.phase = Phase::between;
    p.ending = Ending::kills;
    p.winner = 1;
    p.match_winner = no_player;
    p.rounds = 3;
    p.rounds_won = {1, 1};
    p.round = 1;
    p.next_round_in_s = 4.2;
    p.match_stats[0][0] = {.shots = 10, .hits = 4, .kills = 1, .damage = 24};
    render::Overlay overlay;
    make_overlay(p, {}, size, overlay);
    EXPECT_TRUE(has_text(overlay, "Tide wins round 2"));
    EXPECT_TRUE(has_text(overlay, "rounds 1 : 1"));
    EXPECT_TRUE(has_text(overlay, "Enter, A: next round (in 5 s)    Esc, B: quit to menu"));
    EXPECT_TRUE(has_text(overlay, "4 of 10 hit (40 %), 24 HP, 1 kill"));
    p.phase = Phase::playing;
    make_overlay(p, {}, size, overlay);
    const auto other_threes = texts_of(overlay, "3").size();
    p.phase = Phase::between;
    p.next_round_in_s = 2.4;
    make_overlay(p, {}, size, overlay);
    EXPECT_FALSE(has_text(overlay, "wins")) << "the last seconds are counted in the views";
    EXPECT_EQ(texts_of(overlay, "3").size(), other_threes + 4) << "in two views, each with its dark copy";
    p.phase = Phase::over;
    p.match_winner = 0;
    p.rounds_won = {2, 1};
    make_overlay(p, {}, size, overlay);
    EXPECT_TRUE(has_text(overlay, "Ember wins"));
    EXPECT_TRUE(has_text(overlay, "Enter, A: rematch    Esc, B: quit to menu"));
    make_overlay(p, {.has_menu = false}, size, overlay);
    EXPECT_TRUE(has_text(overlay, "Enter, A: rematch    Esc, B: quit"));
    make_overlay(p, {.names = {"Bot 3", ""}}, size, overlay);
    EXPECT_TRUE(has_text(overlay, "Bot 3 wins"));
    make_overlay(p, {.names = {"", "WWWWWWWWWWWWWWWW"}}, size, overlay);
    EXPECT_TRUE(has_text(overlay, "WWWWWWWWWWWWWWWW"));
    make_overlay(p, {.can_play_again = false}, size, overlay);
    EXPECT_FALSE(has_text(overlay, "Enter"));
}

TEST(Feed, NamesPlayersAsTheScreenDoes) {
    const Event kill{.kind = EventKind::death, .subject = 1, .by = 0};
    EXPECT_EQ(event_words("{by} beats {whom}", kill, {}), "Ember beats Tide");
    EXPECT_EQ(event_words("{by} beats {whom}", kill, {"Zoë", "{by}"}), "Zoë beats {by}");
}

// ---- captions of the haptic device ------------------------------------------------------------------------

TEST(DeviceCaption, ADriversMessageStandsInItsPlayersViewAboveOurText) {
    const render::Size size{1280, 720};
    auto picture = picture_of(*new_match());
    for (std::uint32_t player = 0; player < players; ++player) {
        picture.wizards[player].senses.force.arm = ArmCondition::gone;
        HudSettings settings;
        auto overlay = overlay_of(picture, settings);
        EXPECT_NE(text_item(overlay, "The arm does not answer: mouse and keys play on"), nullptr);
        settings.device_messages[player] = "The arm's motors are too warm: let them rest";
        overlay = overlay_of(picture, settings);
        EXPECT_EQ(text_item(overlay, "The arm does not answer: mouse and keys play on"), nullptr);
        const auto* told = text_item(overlay, settings.device_messages[player]);
        const auto* ours = text_item(overlay, "Mouse and keys play on");
        ASSERT_TRUE(told != nullptr && ours != nullptr);
        EXPECT_LT(told->position.y, ours->position.y);
        const auto view = views_of(settings, size)[player];
        for (const auto* item : {told, ours}) {
            EXPECT_GT(item->position.y, static_cast<float>(view.y));
            EXPECT_LT(item->position.y + item->size, static_cast<float>(view.y + view.height));
        }
        picture.wizards[player].senses.force.arm = ArmCondition::none;
    }
}

TEST(Captions, ThatAreOffLeaveFaultsAndOfferNoWordsOnTheBrew) {
    const render::Size size{1280, 720};
    auto picture = picture_of(*new_match());
    picture.wizards[0].senses.force.cause = haptics::SafetyCause::over_speed;
    picture.wizards[0].senses.force.arm = ArmCondition::felt;
    picture.wizards[0].stations.at_rim = true;
    picture.wizards[1] = picture.wizards[0];
    HudSettings settings;
    /// Number of views that show the words. Words without a plate behind them are drawn twice, with a dark
    /// copy below.
    const auto shown = [&](std::string_view words) {
        const auto overlay = overlay_of(picture, settings);
        const auto views = views_of(settings, size);
        return std::count_if(views.begin(), views.end(), [&](const auto& view) {
            return std::ranges::any_of(texts_of(overlay, words), [&](const auto* found) {
                return found->position.y >= static_cast<float>(view.y) &&
                       found->position.y < static_cast<float>(view.y + view.height);
            });
        });
    };
    EXPECT_EQ(shown("Pure brew"), 2);
    EXPECT_EQ(shown("Forces wait until the hand is slower"), 2);
    settings.captions = {false, true};
    settings.device_messages[0] = "The arm's motors are too warm: let them rest";
    EXPECT_EQ(shown("Pure brew"), 1) << "the other player still has captions";
    EXPECT_EQ(shown("Forces wait until the hand is slower"), 1);
    EXPECT_EQ(shown(settings.device_messages[0]), 1) << "a fault is told in any case";
    picture.wizards[0].senses.force.cause = haptics::SafetyCause::panic;
    EXPECT_EQ(shown("All forces off: the emergency key brings yours back"), 1);
}

TEST(Captions, OnForcesAreForPlayersWithAnArm) {
    using haptics::SafetyCause;
    auto picture = picture_of(*new_match());
    const auto talks_of_forces = [&] { return has_text(overlay_of(picture), "orces "); };
    for (const auto cause : {SafetyCause::shut_off, SafetyCause::panic, SafetyCause::warm, SafetyCause::stale,
                             SafetyCause::over_speed, SafetyCause::waiting}) {
        for (auto& p : picture.wizards) p.senses.force.cause = cause;
        EXPECT_FALSE(talks_of_forces()) << static_cast<int>(cause);
        picture.wizards[1].senses.force.arm = ArmCondition::felt;
        EXPECT_TRUE(talks_of_forces()) << static_cast<int>(cause);
        picture.wizards[1].senses.force.arm = ArmCondition::none;
    }
}

TEST(Captions, ThatAreOffLeaveTheGaugeOfTheBrew) {
    auto picture = picture_of(*new_match());
    const auto bars = [&](bool at_rim, bool captions) {
        picture.wizards[0].stations.at_rim = at_rim;
        const auto overlay = overlay_of(picture, {.watch = Watch::first, .captions = {captions, captions}});
        return std::ranges::count_if(items_of<render::RectItem>(overlay), [](const auto* bar) {
            return bar->high.y - bar->low.y < 12 && bar->high.x - bar->low.x > 90;
        });
    };
    picture.cauldron.mixed = 0.5;
    picture.cauldron.fresh = 0.8;
    EXPECT_EQ(bars(false, false), 0);
    EXPECT_EQ(bars(true, true), 4) << "mixing and time, each with its track";
    EXPECT_EQ(bars(true, false), 4);
}

TEST(DeviceCaption, LongOnesAreSmallerAndBrokenSoThatTheViewHoldsThem) {
    const HudSettings side{.split = render::Split::side_by_side,
                           .text_scale = 2.5,
                           .device_messages = {std::string(200, 'w'), "short"}};
    const render::Size size{640, 360};
    const auto overlay = overlay_of(picture_of(*new_match()), side, size);
    std::size_t letters = 0;
    const auto* brief = text_item(overlay, "short");
    ASSERT_NE(brief, nullptr);
    for (const auto* line : items_of<render::TextItem>(overlay)) {
        if (line->text.find_first_not_of('w') != std::string::npos) continue;
        letters += line->text.size();
        EXPECT_LE(width_of(line->text, line->size), static_cast<float>(views_of(side, size)[0].width));
        EXPECT_LT(line->size, brief->size);
    }
    EXPECT_EQ(letters, 2 * side.device_messages[0].size()) << "every word, and its dark copy";
}

TEST(PowerUpMesh, TheKindsDifferInOutlineAndAreSmall) {
    // Cells of a 16 x 16 grid that each kind of power-up covers, seen from the front.
    std::vector<std::array<bool, 256>> outlines;
    for (const auto kind : {PowerUpKind::vial, PowerUpKind::heart, PowerUpKind::spark}) {
        const auto mesh = power_up_mesh(kind);
        const auto round = render::bounds(mesh);
        EXPECT_LT(round.radius, 0.6F);
        EXPECT_GT(round.radius, 0.2F);
        EXPECT_LT(mesh.indices.size() / 3, 1500U);
        std::array<bool, 256> outline{};
        for (std::size_t t = 0; t < mesh.indices.size(); t += 3) {
            for (int i = 0; i < 256; ++i) {
                const float a = static_cast<float>(i % 16) / 15, b = static_cast<float>(i) / 255;
                if (a + b > 1) continue;
                const fvec3 at = (1 - a - b) * mesh.vertices[mesh.indices[t]].position +
                                 a * mesh.vertices[mesh.indices[t + 1]].position +
                                 b * mesh.vertices[mesh.indices[t + 2]].position;
                const auto cell = [](float v) {
                    return static_cast<std::size_t>(std::clamp(8 + v * 16, 0.0F, 15.0F));
                };
                outline[cell(at.y) * 16 + cell(at.x)] = true;
            }
        }
        for (const auto& other : outlines) {
            int differing = 0;
            for (std::size_t i = 0; i < 256; ++i) differing += outline[i] != other[i] ? 1 : 0;
            EXPECT_GT(differing, 30);
        }
        outlines.push_back(outline);
    }
}

TEST(FieldOfView, IsAsAskedForInAUsualShape) {
    const double high = field_of_view(90, 16.0 / 9);
    EXPECT_NEAR(std::tan(high / 2) * 16 / 9, 1, 1e-9);
    EXPECT_LT(field_of_view(90, 3.5), high);
    EXPECT_GT(field_of_view(90, 0.9), high);
}

}  // namespace
}  // namespace thaum::game::hud_tests

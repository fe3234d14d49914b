// Tests of what the HUD shows at certain moments: the countdown, what killed a player, what the hand feels,
// and the predicted path of a shot.
#include <set>

#include "game/components/crystal.h"
#include "game/components/orb.h"
#include "game/components/station.h"
#include "game/context/hand_forces.h"
#include "game/data/event_words.h"
#include "game/hud/frame_times.h"
#include "game/hud/layout.h"
#include "game/senses/tactile/felt_source.h"
#include "game/stations/cauldron/potions.h"
#include "unit/hud_rig.h"

namespace thaum::game::hud_tests {
namespace {

constexpr Tick draw_time = 1500;

TEST(Countdown, StandsWhereTheCrosshairIsAndHidesWhatIsNotYetInPlay) {
    auto picture = picture_of(*new_match());
    picture.wizards[0].stations.at_rim = true;
    HudSettings settings;
    settings.prompts.fill(PromptWish::always);
    for (auto& controls : settings.controls) controls.stir = "E";
    EXPECT_TRUE(has_text(overlay_of(picture, settings), "[E] Stir"));
    EXPECT_FALSE(has_text(overlay_of(picture, settings), "8"));
    picture.countdown = 8;
    const auto overlay = overlay_of(picture, settings);
    const auto* number = text_item(overlay, "8");
    ASSERT_NE(number, nullptr);
    EXPECT_GT(number->size, 20);
    EXPECT_FALSE(has_text(overlay, "[E] Stir"));
}

TEST(Countdown, IsEquallyLargeInBothViews) {
    auto picture = picture_of(*new_match());
    picture.countdown = 8;
    for (const auto split : {render::Split::top_bottom, render::Split::side_by_side}) {
        for (const double scale : {1.0, 2.5}) {
            std::set<float> sizes;
            const auto overlay = overlay_of(picture, {.split = split, .text_scale = scale});
            const auto shown = texts_of(overlay, "8");
            for (const auto* words : shown) sizes.insert(words->size);
            EXPECT_EQ(shown.size(), 4U) << "each with its shadow";
            EXPECT_EQ(sizes.size(), 1U) << scale;
        }
    }
}

TEST(Crosshair, SaysTheMassOfAThingOnAPlate) {
    auto picture = picture_of(*new_match());
    auto& target = picture.wizards[0].wand.target;
    for (const auto& [share, words] : {std::pair{0.1, "light"}, {0.4, "medium"}, {0.9, "heavy"}}) {
        target = {.kind = TargetKind::take, .mass_share = share};
        const auto overlay = overlay_of(picture);
        const auto* label = text_item(overlay, words);
        ASSERT_NE(label, nullptr);
        EXPECT_TRUE(std::ranges::any_of(items_of<render::RectItem>(overlay), [&](const auto* plate) {
            const float half = width_of(label->text, label->size) / 2;
            return plate->colour.a > 0.7F && plate->low.x < label->position.x - half &&
                   plate->high.x > label->position.x + half && plate->low.y <= label->position.y &&
                   plate->high.y >= label->position.y + label->size;
        })) << words;
    }
}

TEST(Messages, SayThatTheRimIsTooFar) {
    auto picture = picture_of(*new_match());
    picture.tick = 500;
    HudSettings settings;
    settings.captions = {false, false};
    settings.prompts.fill(PromptWish::never);
    constexpr std::string_view words = "Too far from the cauldron: step to the rim";
    EXPECT_FALSE(has_text(overlay_of(picture, settings), words));
    settings.prompt_uses.missed[0] = MissedStation{400, StationKind::cauldron};
    EXPECT_TRUE(has_text(overlay_of(picture, settings), words));
}

TEST(Messages, OfAGiftNameThePlayersOwnControls) {
    auto picture = picture_of(*new_match());
    auto& p = picture.wizards[0];
    p.senses.since_gift_s = 0.1;
    HudSettings settings;
    settings.captions = {true, true};
    settings.controls[0] = {.fire = "LMB", .throw_ = "G"};
    p.senses.gift = {.kind = EventKind::hands_full, .subject = 0, .by = 0, .detail = 1};
    EXPECT_TRUE(has_text(overlay_of(picture, settings), "your hands are full: [G] takes salt instead"));
    p.senses.gift.kind = EventKind::put_away;
    EXPECT_TRUE(has_text(overlay_of(picture, settings), "the salt goes back to its niche"));
    p.senses.gift.kind = EventKind::caught;
    EXPECT_TRUE(
        has_text(overlay_of(picture, settings), "caught: [G] throws it, a press of [LMB] lets it go"));
}

TEST(WandStrip, ShowsWhatTakesTheNextWandWhereWandsHaveNoKeys) {
    auto picture = picture_of(*new_match());
    HudSettings settings;
    settings.watch = Watch::first;
    EXPECT_NE(text_item(overlay_of(picture, settings), "2"), nullptr);
    settings.controls[0].next_wand = "RB";
    const auto overlay = overlay_of(picture, settings);
    const auto* label = text_item(overlay, "RB");
    ASSERT_NE(label, nullptr);
    for (const auto* digit : {"1", "2", "3", "4", "5"})
        EXPECT_EQ(text_item(overlay, digit), nullptr) << digit;
    auto& in_hand = picture.wizards[0].wand.number;
    const float first = label->position.x;
    in_hand = static_cast<std::uint32_t>((in_hand + 1) % picture.shown->wands.size());
    const auto later = overlay_of(picture, settings);
    ASSERT_NE(text_item(later, "RB"), nullptr);
    EXPECT_NE(text_item(later, "RB")->position.x, first) << "it moves on with the wand in hand";
    settings.controls[0].wands[1] = "2";
    EXPECT_NE(text_item(overlay_of(picture, settings), "2"), nullptr);
}

// ---- cause of a wizard's death ---------------------------------------------------------------------------

Event death_by_thing(std::uint32_t killer) {
    return {.kind = EventKind::death,
            .subject = 1,
            .by = killer,
            .detail = static_cast<std::uint32_t>(EventKind::object_hit)};
}

TEST(Feed, NamesTheThingThatKilled) {
    EXPECT_EQ(event_words("{by} > {cause} > {whom}", death_by_thing(0), {}, "barrel"),
              "Ember > thrown barrel > Tide");
    EXPECT_EQ(event_words("{whom} fell ({cause})", death_by_thing(no_player), {}, "crate"),
              "Tide fell (crate)");
    EXPECT_EQ(event_words("{cause}", death_by_thing(0), {}), "blow");
}

/// Line of the kill feed for a death.
std::string death_line(std::uint32_t by, EventKind cause) {
    const auto& row = row_of(match_data()->presentation->events, EventKind::death);
    const Event event{
        .kind = EventKind::death, .subject = 0, .by = by, .detail = static_cast<std::uint32_t>(cause)};
    return event_words(feed_pattern(row, event), event, {});
}

TEST(Feed, DoesNotNameAFallTwice) {
    EXPECT_EQ(death_line(no_player, EventKind::fall), "Ember fell");
    EXPECT_EQ(death_line(0, EventKind::fall), "Ember fell");
    EXPECT_EQ(death_line(no_player, EventKind::spoilt), "Ember fell (brew)");
    EXPECT_EQ(death_line(1, EventKind::fall), "Tide  \u25B8 fall \u25B8  Ember") << "pushed";
}

TEST(Feed, AViewWithRoomForOneLineShowsItsOwnRecipe) {
    auto match = new_match();
    for (const std::uint32_t player : {0U, 1U}) tell_order(match->context_to_change(), player, 0);
    const auto picture = picture_of(*match);
    ASSERT_EQ(picture.feed_lines, 2U) << "each player is told an order";
    const auto overlay = overlay_of(picture, {.split = render::Split::top_bottom});
    for (const auto* own : {"Azoth of Ember", "Azoth of Tide"}) EXPECT_TRUE(has_text(overlay, own)) << own;
    const float middle = 0.5F * static_cast<float>(size.height);
    const auto shown_above = [&](std::string_view part) {
        return std::ranges::any_of(texts_with(overlay, part),
                                   [&](const auto* words) { return words->position.y < middle; });
    };
    EXPECT_TRUE(shown_above("Azoth of Ember"));
}

TEST(Feed, FindsTheThingInTheVictimsLastBlow) {
    auto match = new_match();
    auto& context = match->context_to_change();
    const auto blow = [&](std::uint32_t victim, Surface thing) {
        record(context, {.kind = EventKind::object_hit,
                         .subject = victim,
                         .by = 1 - victim,
                         .detail = static_cast<std::uint32_t>(thing),
                         .amount = 10});
    };
    blow(1, Surface::crate);
    blow(1, Surface::barrel);
    blow(0, Surface::table);
    record(context, death_by_thing(0));
    const auto picture = picture_of(*match);
    ASSERT_EQ(picture.feed_lines, 1U);
    EXPECT_EQ(picture.feed[0].thing, "barrel");
    EXPECT_TRUE(has_text(overlay_of(picture), "thrown barrel"));
}

// ---- captions of forces ----------------------------------------------------------------------------------

TEST(FeltSource, IsTheStrongestOfAll) {
    auto hand = empty_hand_state();
    EXPECT_EQ(strongest_source(forces_on(hand), "Weight").name, "");
    hand.steady_force.force = {0, -0.5, 0};
    EXPECT_EQ(strongest_source(forces_on(hand), "Weight").name, "Weight");
    hand.tether = {.anchor = hand.device.position + vec3(0, 0, 0.02), .stiffness = 50};
    EXPECT_EQ(strongest_source(forces_on(hand), "Weight").name, "Spring");
    EXPECT_NEAR(strongest_source(forces_on(hand), "Weight").newtons, 1, 1e-12);
    hand.servo.pulses[0] = {.peak = {0, 0, 2}, .length = 20, .at = 10};
    EXPECT_EQ(strongest_source(forces_on(hand), "Weight").name, "Recoil");
    hand.servo.pulses[0].at = 20;  // this pulse is over
    EXPECT_EQ(strongest_source(forces_on(hand), "Weight").name, "Spring");
    hand.servo.fluid.force = {1.5, 0, 0};
    EXPECT_EQ(strongest_source(forces_on(hand), "Weight").name, "Current");
    hand.servo.fluid.surface_force = -1.8;
    EXPECT_EQ(strongest_source(forces_on(hand), "Weight").name, "Surface");
    hand.servo.surface.contacts = 1;
    hand.servo.surface.touched[0].force = {0, 2, 0};
    EXPECT_EQ(strongest_source(forces_on(hand), "Weight").name, "Wall");
}

TEST(FeltSource, NamesFlowAndCrystalInTheHandsFrame) {
    auto match = new_match();
    auto& world = match->world_to_change();
    const auto wizard = wizard_of(world, 0);
    world.add(wizard, AtStation{.yaw = pi / 2, .kind = StationKind::orb});
    world.add(wizard, Scrying{.force = {-0.8, 0, 0}});
    const auto forces = forces_on(world, wizard);
    EXPECT_EQ(strongest_source(forces, "").name, "Flow");
    const vec3 flow = forces.at(static_cast<std::size_t>(ForceSource::flow));
    EXPECT_LT(glm::distance(flow, vec3(0, 0, -0.8)), 1e-9) << "ahead of a wizard who looks along -x";
    world.remove<Scrying>(wizard);
    world.add(wizard, Chisel{.force = {0, 0.5, 0}});
    EXPECT_EQ(strongest_source(forces_on(world, wizard), "").name, "Crystal");
}

TEST(FeltSource, IsSaidWithABarAndWithoutNumbersUnlessTheCurveIsShown) {
    auto picture = picture_of(*new_match());
    auto& force = picture.wizards[0].senses.force;
    force = {.cap = 2, .current = {0, 0, 1}, .source = "Recoil"};
    EXPECT_TRUE(has_text(overlay_of(picture), "Recoil"));
    EXPECT_FALSE(has_text(overlay_of(picture), " N"));
    HudSettings curve;
    curve.forces = true;
    EXPECT_TRUE(has_text(overlay_of(picture, curve), " of 2.00 N"));
    force.current = {0, 0, 0.01};
    EXPECT_FALSE(has_text(overlay_of(picture), "Recoil")) << "a force that nobody feels";
}

// ---- path of a shot while it is drawn --------------------------------------------------------------------

/// Distance of a point from the drawn path of a shot (m).
double distance_from_way(const PlayerPicture& drawn, vec3 point) {
    double nearest = 1e9;
    for (std::uint32_t i = 0; i + 1 < drawn.wand.arc_points; ++i) {
        const vec3 a = drawn.wand.arc[i], way = drawn.wand.arc[i + 1] - a;
        const double share = std::clamp(glm::dot(point - a, way) / glm::dot(way, way), 0.0, 1.0);
        nearest = std::min(nearest, glm::distance(point, a + share * way));
    }
    return nearest;
}

/// Largest distance of the stone from the drawn path, between the path's ends (m).
double worst_of_flight(Simulation& match, const input::InputFrame& frame, const PlayerPicture& drawn) {
    double worst = 0;
    bool on_its_way = false, arrived = false;
    for (Tick t = 0; t < 2000 && !arrived; ++t) {
        match.tick(frame);
        for (const auto& missile : picture_of(match).missiles) {
            on_its_way = on_its_way || glm::distance(missile.position, drawn.wand.arc[0]) < 0.3;
            arrived =
                arrived || glm::distance(missile.position, drawn.wand.arc[drawn.wand.arc_points - 1]) < 0.5;
            if (on_its_way) worst = std::max(worst, distance_from_way(drawn, missile.position));
        }
    }
    EXPECT_TRUE(arrived) << "the stone came down where the way ends";
    return worst;
}

TEST(DrawnShot, ShowsTheWayThatTheStoneThenFlies) {
    const auto data = match_data();
    const auto slot = std::find_if(data->wands.begin(), data->wands.end(), [](const LoadedWand& w) {
                          return w.name == "lob";
                      })->stats.slot;
    Simulation match(data, MatchSetup{1, {bot_device(0, "level_1"), bot_device(1, "level_1")}});
    match.world_to_change().get<Gaze>(wizard_of(match.world(), 0)) = {-pi / 4, 0.3};
    input::InputFrame frame;
    frame.devices[0].wand = static_cast<std::uint8_t>(slot + 1);
    for (Tick t = 0; t < 32; ++t) match.tick(frame);
    EXPECT_EQ(picture_of(match).wizards[0].wand.arc_points, 0U) << "nothing is drawn";
    frame.devices[0].press(input::Button::fire);
    frame.devices[0].counts[input::hand::trigger] = 255;
    for (Tick t = 0; t < draw_time; ++t) match.tick(frame);
    const auto drawn = picture_of(match).wizards[0];
    ASSERT_GT(drawn.wand.arc_points, 5U);
    ASSERT_TRUE(drawn.wand.spring.has_value());
    EXPECT_GT(glm::distance(*drawn.wand.spring, drawn.wand.reach), 0.05) << "the spring is stretched";
    frame.devices[0].buttons = 0;
    frame.devices[0].counts[input::hand::trigger] = 0;
    // Between the picture and the shot, the hand moves back a little, hence the tolerance.
    EXPECT_LT(worst_of_flight(match, frame, drawn), 0.3);
    EXPECT_EQ(picture_of(match).wizards[0].wand.arc_points, 0U);
}

TEST(HudWords, NamesAndFeedStandOnAPlateSoThatNoGroundHidesThem) {
    auto picture = picture_of(*new_match());
    picture.feed_lines = 1;
    picture.feed[0] = {.event = {.kind = EventKind::death, .subject = 1, .by = 0}};
    for (const auto& [size, scale] :
         {std::pair{render::Size{1280, 720}, 1.0}, {render::Size{640, 480}, 2.5}}) {
        const auto overlay = overlay_of(picture, {.text_scale = scale}, size);
        const auto named = texts_with(overlay, "Ember");
        for (const auto* line : named) {
            const float wide = width_of(line->text, line->size);
            const float left =
                line->align == render::Align::right ? line->position.x - wide : line->position.x;
            const auto covers = [&](const auto* plate) {
                return plate->colour.a >= 0.75F && plate->low.x <= left + 1 &&
                       plate->high.x >= left + wide - 4 && plate->low.y <= line->position.y + 1 &&
                       plate->high.y >= line->position.y + line->size - 1;
            };
            EXPECT_TRUE(std::ranges::any_of(items_of<render::RectItem>(overlay), covers))
                << line->text << " at " << line->position.x << ", " << line->position.y;
        }
        EXPECT_GE(named.size(), 4U) << "the name, a line of the feed, and their shadows";
    }
}

TEST(FrameTimesLine, TellsTheWholeAndItsPartsLongestFirst) {
    FrameTimes times{
        .building_ms = 1.26, .showing_ms = 0.04, .quality = render::Quality::low, .resolution = 0.67F};
    times.passes.ms[static_cast<std::size_t>(render::Pass::meshes)] = 12.34;
    times.passes.ms[static_cast<std::size_t>(render::Pass::overlay)] = 3;
    EXPECT_EQ(words_of(times), "picture 16.6 ms, low, 67 %   meshes 12.3   overlay 3.0   building 1.3");
}

TEST(FrameTimesLine, TimesComeNearerToTheNewest) {
    FrameTimes shown;
    FrameTimes newest{.building_ms = 8, .showing_ms = 4, .resolution = 0.5F};
    newest.passes.ms.fill(2);
    approach(shown, newest, 0.25);
    EXPECT_EQ(shown.building_ms, 2);
    EXPECT_EQ(shown.showing_ms, 1);
    EXPECT_EQ(shown.passes.ms.back(), 0.5);
    EXPECT_EQ(shown.resolution, 0.5F);
}

TEST(FrameTimesLine, StandsOnTheScreenOnlyIfAskedFor) {
    const auto picture = picture_of(*new_match());
    EXPECT_FALSE(has_text(overlay_of(picture), "picture"));
    HudSettings settings;
    settings.frame_times = FrameTimes{.building_ms = 3};
    EXPECT_TRUE(has_text(overlay_of(picture, settings), "picture 3.0 ms"));
}

}  // namespace
}  // namespace thaum::game::hud_tests

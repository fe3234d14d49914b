// Tests of what a player sees of strokes and spells: captions, the strip of spells, focus (the energy for
// spells), trail, shield and fog.
#include "game/hud/casting_overlay.h"

#include "core/text.h"
#include "game/hud/stroke_words.h"
#include "game/picture/stroke_pieces.h"
#include "unit/casting_rig.h"

namespace thaum::game::hud_tests {
namespace {

ReadingPicture reading_of(const CastingPicture& casting, StrokeOutcome outcome, std::string_view name,
                          double probability, double force) {
    const auto number = gesture_number(casting, name);
    return {.age_s = 0.1,
            .outcome = outcome,
            .gesture = number,
            .nearest = number,
            .probability = probability,
            .force = force};
}

TEST(StrokeWords, SayWhatWasReadHowSureAndHowHard) {
    const auto picture = new_casting_picture();
    auto casting = picture.wizards[0].casting;
    const auto said = [&](StrokeOutcome outcome, double probability, double force) {
        casting.reading = reading_of(casting, outcome, "circle", probability, force);
        return stroke_caption(casting, *picture.shown);
    };
    EXPECT_EQ(said(StrokeOutcome::cast, 0.971, 0.6).words, "Circle 97 %: Shield, gentle");
    EXPECT_EQ(said(StrokeOutcome::cast, 0.971, 1.2).words, "Circle 97 %: Shield, normal");
    EXPECT_EQ(said(StrokeOutcome::cast, 0.9999, 1.5).words, "Circle 99 %: Shield, harsh");
    EXPECT_FALSE(said(StrokeOutcome::cast, 1, 0.6).failed);
}

/// Presses buttons and a wand's key for some ticks, while the mouse moves to the right by `counts` in each
/// tick.
void press(Simulation& match, std::initializer_list<input::Button> buttons, std::uint8_t wand,
           std::int32_t counts, Tick lasts) {
    input::InputFrame frame;
    for (const auto button : buttons) frame.devices[0].press(button);
    frame.devices[0].wand = wand;
    frame.devices[0].counts[input::hand::look_right] = counts;
    for (Tick t = 0; t < lasts; ++t) match.tick(frame);
}

std::string caption_in(const Simulation& match, const ControlNames& controls = {}) {
    const auto picture = picture_of(match);
    return stroke_caption(picture.wizards[0].casting, *picture.shown, controls).words;
}

TEST(StrokeWords, OfAKeyChordHaveItsKeyAndClaimNoReading) {
    using enum input::Button;
    const auto match = new_match();
    press(*match, {trace}, 0, 0, 40);
    press(*match, {trace}, 1, 0, 30);
    press(*match, {}, 0, 0, 40);
    EXPECT_EQ(caption_in(*match), "[1] Shield, gentle");
    EXPECT_EQ(caption_in(*match, {.wands = {"Insert"}}), "[Insert] Shield, gentle");
    EXPECT_EQ(picture_of(*match).wizards[0].casting.slip, Slip::none) << "a chord is no stroke";
    press(*match, {trace, fire}, 0, 0, 40);
    press(*match, {trace, fire}, 2, 0, 30);
    press(*match, {}, 0, 0, 40);
    EXPECT_EQ(caption_in(*match), "[2] Push, harsh");
    press(*match, {trace}, 3, 0, 40);
    press(*match, {}, 0, 0, 40);
    press(*match, {trace}, 4, 0, 40);
    press(*match, {}, 0, 0, 40);
    EXPECT_EQ(caption_in(*match), "[4] Recall, but it calls the thing lifted last; lift one first");
    press(*match, {trace}, 0, 5, 400);  // the mouse moves 20 cm to the right
    press(*match, {}, 0, 0, 40);
    EXPECT_EQ(caption_in(*match).substr(0, 1), "n") << "a line is not read; the chord is over";
}

TEST(StrokeWords, TellOfAStrokeThatIsTooSmallOrTooShortButNotOfATap) {
    using enum input::Button;
    const auto after = [](std::int32_t counts, Tick lasts) {
        const auto match = new_match();
        press(*match, {}, 0, 0, 40);
        press(*match, {trace}, 0, counts, lasts);
        press(*match, {}, 0, 0, 40);
        return caption_in(*match);
    };
    EXPECT_EQ(after(0, 60), "") << "a tap";
    EXPECT_EQ(after(0, 600), "") << "a hand that waits";
    EXPECT_EQ(after(1, 40), "") << "a tap of a hand that shakes";
    EXPECT_NE(after(1, 120).find("too small"), std::string::npos) << "a centimetre";
    EXPECT_NE(after(10, 60).find("too short"), std::string::npos) << "6 cm in a moment";
    EXPECT_EQ(after(1, 300).find("too "), std::string::npos) << "long enough to be read";
}

TEST(StrokeWords, TellWhyAStrokeDidNothing) {
    const auto picture = new_casting_picture();
    auto casting = picture.wizards[0].casting;
    casting.reading = reading_of(casting, StrokeOutcome::unfocused, "circle", 0.97, 0.6);
    casting.reading.event.amount = 11.2;
    EXPECT_EQ(stroke_caption(casting, *picture.shown).words, "Circle 97 %: Shield needs 12 more focus");
    EXPECT_TRUE(stroke_caption(casting, *picture.shown).failed);
    casting.reading = reading_of(casting, StrokeOutcome::unread, "s", 0.31, 0.6);
    casting.reading.gesture = no_gesture;
    EXPECT_EQ(stroke_caption(casting, *picture.shown).words, "not read; nearest: S");
    casting.reading.probability = 0.004;
    EXPECT_EQ(stroke_caption(casting, *picture.shown).words, "not read") << "0 % is near to nothing";
    casting.reading.nearest = no_gesture;
    EXPECT_EQ(stroke_caption(casting, *picture.shown).words, "not read");
    casting.reading = reading_of(casting, StrokeOutcome::fizzled, "circle", 0.97, 0.6);
    EXPECT_EQ(stroke_caption(casting, *picture.shown).words, "Circle 97 %: Shield does nothing here");
    casting.reading.refusal = "there is a reason";
    EXPECT_EQ(stroke_caption(casting, *picture.shown).words, "Circle 97 %: Shield, but there is a reason");
    EXPECT_TRUE(stroke_caption(casting, *picture.shown).failed);
}

TEST(StrokeWords, TellTheReasonOfTheSpellItself) {
    const auto match = new_match();
    // Uses the star spell by its combination of keys, which calls back the object that was lifted last.
    const auto recall = [&] {
        input::InputFrame frame;
        for (int t = 0; t < 60; ++t) {
            frame.devices[0].press(input::Button::trace);
            frame.devices[0].wand = t > 30 ? 4 : 0;
            match->tick(frame);
        }
        for (int t = 0; t < 40; ++t) match->tick({});
        const auto picture = picture_of(*match);
        return stroke_caption(picture.wizards[0].casting, *picture.shown).words;
    };
    EXPECT_EQ(recall(), "[4] Recall, but it calls the thing lifted last; lift one first");
    // An object for the spell, but out of its reach.
    auto& world = match->world_to_change();
    ecs::Entity thing;
    world.view<const Prop, const Body>().each([&](ecs::Entity e, const Prop&, const Body&) { thing = e; });
    ASSERT_TRUE(thing);
    world.get<LastProp>(wizard_of(world, 0)).thing = thing;
    world.get<Motion>(thing).position = {0, 500, 0};
    match->physics().set_state(thing.index, std::as_const(world).get<Motion>(thing));
    EXPECT_EQ(recall(), "[4] Recall, but the thing lifted last is too far away");
}

TEST(StrokeWords, TellWhyARecalledThingWasNotCaught) {
    const auto match = new_match();
    press(*match, {}, 0, 0, 400);
    auto& world = match->world_to_change();
    const auto wizard = wizard_of(world, 0);
    ecs::Entity thing;
    world.view<const Prop, const Body>().each([&](ecs::Entity e, const Prop&, const Body& body) {
        if (body.mass < 20) thing = e;
    });
    ASSERT_TRUE(thing);
    const auto recall = [&](std::uint32_t wand) {
        world.get<WandBelt>(wizard).selected = wand;
        world.get<LastProp>(wizard).thing = thing;
        world.get<Focus>(wizard).points = 100;
        Motion motion;
        motion.position = world.get<Motion>(wizard).position + vec3(4, 1, 0);
        match->physics().set_state(thing.index, motion);
        press(*match, {input::Button::trace}, 0, 0, 40);
        press(*match, {input::Button::trace}, 4, 0, 30);
        std::string said = caption_in(*match);
        for (int i = 0; i < 40 && said.starts_with("[4] Recall, gentle"); ++i) {
            press(*match, {}, 0, 0, 80);
            said = caption_in(*match);
        }
        return said;
    };
    EXPECT_EQ(recall(0), "it lies before you: only a wand that lifts can catch it");
    EXPECT_EQ(recall(3), "") << "Lift catches it: " << caption_in(*match);
}

TEST(StrokeWords, OnTheBrewSayHowManyTurns) {
    const auto picture = new_casting_picture();
    auto casting = picture.wizards[0].casting;
    casting.reading = reading_of(casting, StrokeOutcome::none, "circle", 0.9, 0.6);
    casting.reading.turns = -2.1;
    EXPECT_EQ(stroke_caption(casting, *picture.shown).words, "Circle 90 %, 2 turns counterclockwise, gentle");
    casting.reading.turns = 1;
    EXPECT_EQ(stroke_caption(casting, *picture.shown).words, "Circle 90 %, 1 turn clockwise, gentle");
}

TEST(StrokeWords, AreGoneAfterAMoment) {
    const auto picture = new_casting_picture();
    auto casting = picture.wizards[0].casting;
    EXPECT_EQ(stroke_caption(casting, *picture.shown).words, "") << "nothing was drawn";
    casting.reading = reading_of(casting, StrokeOutcome::cast, "circle", 0.9, 0.6);
    casting.reading.age_s = reading_seconds + 0.01;
    EXPECT_EQ(stroke_caption(casting, *picture.shown).words, "");
    casting.reading.age_s = 0;
    casting.there = false;
    EXPECT_EQ(stroke_caption(casting, *picture.shown).words, "") << "rules without spells";
}

/// Adds a quarter of a circle to the stroke in the player's picture.
void draw_arc(StrokePicture& stroke, float force) {
    stroke.count = 20;
    stroke.drawing = true;
    for (std::uint32_t i = 0; i < stroke.count; ++i) {
        const float angle = 0.08F * static_cast<float>(i);
        stroke.points[i] = {0.04F * std::sin(angle), 0.04F * std::cos(angle), 0, force};
    }
    stroke.force_now = stroke.force_mean = static_cast<double>(force);
}

TEST(SpellStrip, TakesThePlaceOfTheWandsWhileTraceIsHeld) {
    auto picture = new_casting_picture();
    HudSettings settings;
    for (auto& controls : settings.controls) controls.wands = {"7", "8", "9"};
    EXPECT_FALSE(has_text(overlay_of(picture, settings), "Shield 25"));
    draw_arc(picture.wizards[0].casting.stroke, 0.5F);
    const auto overlay = overlay_of(picture, settings);
    EXPECT_TRUE(has_text(overlay, "Shield"));
    EXPECT_TRUE(has_text(overlay, "25")) << "cost";
    EXPECT_TRUE(has_text(overlay, "Focus 100"));
    EXPECT_TRUE(has_text(overlay, "7")) << "key of the chord";
    EXPECT_TRUE(has_text(overlay, "gentle")) << "force band";
    draw_arc(picture.wizards[0].casting.stroke, 2);
    EXPECT_TRUE(has_text(overlay_of(picture, settings), "harsh"));
}

/// Colours of those texts of an overlay that contain `part`.
std::vector<fvec4> paints_of(const render::Overlay& overlay, std::string_view part) {
    std::vector<fvec4> found;
    for (const auto* words : texts_with(overlay, part)) found.push_back(words->colour);
    return found;
}

TEST(SpellStrip, ASpellThatTheFocusDoesNotAffordIsGreyAndStruckThrough) {
    auto picture = new_casting_picture();
    auto& casting = picture.wizards[0].casting;
    draw_arc(casting.stroke, 0.5F);
    const auto rich = overlay_of(picture);
    casting.focus = 24;
    const auto poor = overlay_of(picture);
    EXPECT_NE(paints_of(rich, "Shield"), paints_of(poor, "Shield"));
    EXPECT_GT(poor.items.size(), 0U);
    EXPECT_GT(items_of<render::LineItem>(poor).size(), items_of<render::LineItem>(rich).size())
        << "the line through it needs no colours";
}

TEST(Focus, ItsNumberStandsBesideTheHealth) {
    auto picture = new_casting_picture();
    picture.wizards[0].casting.focus = 37.9;
    EXPECT_TRUE(has_text(overlay_of(picture), "37"));
}

TEST(FreeCaption, SaysWhatWasAlmostCastAndWhyNot) {
    const auto picture = new_casting_picture();
    auto casting = picture.wizards[0].casting;
    auto& miss = casting.free.miss;
    miss = {.at = 1, .probability = 0.6, .gesture = gesture_number(casting, "star"), .reason = Miss::unclear};
    casting.free.miss_age_s = 0.3;
    const auto said = [&] { return stroke_caption(casting, *picture.shown).words; };
    EXPECT_EQ(said(), "almost: Star 60 %, not clear enough");
    EXPECT_TRUE(stroke_caption(casting, *picture.shown).failed);
    miss.reason = Miss::too_fast;
    EXPECT_EQ(said(), "almost: Star 60 %, too fast");
    miss.reason = Miss::too_small;
    EXPECT_EQ(said(), "almost: Star 60 %, too small");
    casting.reading = reading_of(casting, StrokeOutcome::cast, "circle", 0.97, 0.6);
    EXPECT_EQ(said(), "Circle 97 %: Shield, gentle") << "the newer one counts";
    casting.reading.age_s = 1;
    EXPECT_EQ(said(), "almost: Star 60 %, too small");
    casting.free.miss_age_s = reading_seconds + 0.1;
    EXPECT_EQ(said(), "Circle 97 %: Shield, gentle");
}

TEST(FreeTrail, IsFaintEndsAtTheCrosshairAndGivesWayToAStroke) {
    auto picture = new_casting_picture();
    auto& casting = picture.wizards[0].casting;
    const auto layout = *lay_out({}, {1280, 720}, 5).views[0];
    const auto trail = [&] {
        render::Overlay out;
        add_free_trail(out, casting, 0, layout);
        return out;
    };
    EXPECT_TRUE(trail().items.empty()) << "a hand that needs a button";
    casting.free.count = 30;
    for (std::uint32_t i = 0; i < casting.free.count; ++i)
        casting.free.trail[i] = fvec3(0.002F * static_cast<float>(i), 3, 0);
    const auto drawn = trail();
    ASSERT_EQ(drawn.items.size(), 29U);
    const auto& last = std::get<render::LineItem>(drawn.items.back());
    EXPECT_NEAR(last.to.x, layout.centre.x, 0.01);
    EXPECT_NEAR(last.to.y, layout.centre.y, 0.01);
    EXPECT_LT(std::get<render::LineItem>(drawn.items.front()).to.x, layout.centre.x);
    EXPECT_LE(last.colour.a, 0.4F);
    EXPECT_LT(std::get<render::LineItem>(drawn.items.front()).colour.a, last.colour.a);
    draw_arc(casting.stroke, 0.3F);
    EXPECT_TRUE(trail().items.empty());
}

TEST(ForceBand, OfAChordHasTheForceOfTheChord) {
    auto match = new_match();
    const auto wizard = wizard_of(match->world(), 0);
    match->tick({});
    auto& world = match->world_to_change();
    world.add(wizard, DrawnStroke{.count = 2, .over = by_chord});
    CastingPicture casting;
    take_casting(*match, wizard, 0, casting);
    EXPECT_FALSE(casting.stroke.chord) << "nothing was read yet";
    world.get<LastReading>(wizard) = {.at = 1, .probability = 1, .force = 1.5, .gesture = 0, .nearest = 0};
    take_casting(*match, wizard, 0, casting);
    EXPECT_TRUE(casting.stroke.drawing && casting.stroke.chord);
    EXPECT_EQ(force_word(*casting.rules, casting.stroke.force_mean), "harsh");
    casting.there = true;
    auto picture = new_casting_picture();
    picture.wizards[0].casting = casting;
    EXPECT_TRUE(has_text(overlay_of(picture), "harsh"));
    EXPECT_FALSE(has_text(overlay_of(picture), "gentle"));
}

/// Draws what the HUD shows of a stroke in the first view into `out`. Returns the number of its lines.
std::size_t lines_of_stroke(const CastingPicture& casting, const ViewLayout& layout, render::Overlay& out) {
    out.items.clear();
    static const auto shown = new_casting_picture().shown;
    add_stroke(out, casting, *shown, 0, layout);
    return out.items.size();
}

TEST(StrokeTrail, IsWiderWithForceAndStaysInItsView) {
    auto picture = new_casting_picture();
    auto& casting = picture.wizards[0].casting;
    casting.gestures.reset();  // without gestures no stroke is likely to be a spell
    const auto layout = *lay_out({}, {640, 480}, 5).views[0];
    render::Overlay gentle, harsh;
    draw_arc(casting.stroke, 0.3F);
    ASSERT_GT(lines_of_stroke(casting, layout, gentle), 30U);
    draw_arc(casting.stroke, 2);
    for (auto& p : casting.stroke.points) p.x *= 30;  // as if the hand moved far
    ASSERT_EQ(lines_of_stroke(casting, layout, harsh), gentle.items.size());
    const auto& thin = std::get<render::LineItem>(gentle.items[0]);
    const auto& thick = std::get<render::LineItem>(harsh.items[0]);
    EXPECT_GT(thick.width, thin.width);
    for (const auto* line : items_of<render::LineItem>(harsh)) {
        EXPECT_GE(line->to.x, static_cast<float>(layout.view.x));
        EXPECT_LE(line->to.x, static_cast<float>(layout.view.x + layout.view.width));
        EXPECT_GE(line->to.y, static_cast<float>(layout.view.y));
        EXPECT_LE(line->to.y, static_cast<float>(layout.view.y + layout.view.height));
    }
}

/// Longest line (px) in the picture of a circle, half-way along which the hand rests for `rest` points.
float longest_line(std::uint32_t rest) {
    auto picture = new_casting_picture();
    auto& casting = picture.wizards[0].casting;
    casting.gestures.reset();
    auto& stroke = casting.stroke;
    stroke.drawing = true;
    stroke.count = 100 + rest;
    for (std::uint32_t i = 0; i < stroke.count; ++i) {
        const std::uint32_t moved = i < 50 ? i : std::max(50U, i - std::min(i, rest));
        const float angle = 0.0628F * static_cast<float>(moved);
        stroke.points[i] = {0.04F * std::sin(angle), 0.04F * std::cos(angle), 0, 1};
    }
    render::Overlay out;
    lines_of_stroke(casting, *lay_out({}, {1280, 720}, 5).views[0], out);
    float longest = 0;
    for (const auto* line : items_of<render::LineItem>(out))
        longest = std::max(longest, glm::distance(line->from, line->to));
    return longest;
}

TEST(StrokeTrail, IsDrawnAsItWasHoweverLongAHandRests) {
    EXPECT_LT(longest_line(412), 1.3F * longest_line(0));
}

TEST(StrokePicture, HasPiecesOfEqualLengthOfALongStroke) {
    std::vector<float> longest;
    // Number of points that a rest halfway adds to 3,000 evenly spaced points along a line.
    for (const std::size_t rest : {0U, 5000U}) {
        const auto at = [&](std::size_t i) {
            return fvec2(static_cast<float>(i < 1500 ? i : i < 1500 + rest ? 1500 : i - rest), 0);
        };
        longest.push_back(0);
        std::size_t pieces = 0, next = 0;
        each_piece(3000 + rest, 100, at, [&](std::size_t from, std::size_t to) {
            EXPECT_EQ(from, next);
            next = to;
            ++pieces;
            longest.back() = std::max(longest.back(), glm::distance(at(from), at(to)));
        });
        EXPECT_EQ(next, 2999 + rest) << "the newest point is there";
        EXPECT_LE(pieces, 101U);
    }
    EXPECT_EQ(longest[0], longest[1]);
}

TEST(StrokeTrail, FadesAfterTheStrokeAndBreaksIfItWasNotRead) {
    auto picture = new_casting_picture();
    auto& casting = picture.wizards[0].casting;
    const auto layout = *lay_out({}, {1280, 720}, 5).views[0];
    render::Overlay read, missed, older;
    draw_arc(casting.stroke, 0.3F);
    casting.stroke.drawing = false;
    casting.stroke.since_end_s = 0.3;
    casting.stroke.read = true;
    lines_of_stroke(casting, layout, read);
    casting.stroke.since_end_s = 0.9;
    lines_of_stroke(casting, layout, older);
    casting.stroke.read = false;
    lines_of_stroke(casting, layout, missed);
    EXPECT_LT(missed.items.size(), older.items.size()) << "it has gaps";
    EXPECT_LT(std::get<render::LineItem>(older.items.back()).colour.a,
              std::get<render::LineItem>(read.items.back()).colour.a);
}

TEST(ShieldSeen, FlashesLessThanThreeTimesASecond) {
    EXPECT_LT(1 / flash_apart_seconds, 3);
    auto match = new_match();
    const auto wizard = wizard_of(match->world(), 0);
    match->world_to_change().get<Health>(wizard).ward = 1000;
    match->world_to_change().get<Health>(wizard).ward_until = ticks(20);
    std::size_t flashes = 0;
    double before = 1e6;
    CastingPicture casting;
    for (Tick t = 0; t < ticks(2.0); t += 8) {
        for (Tick i = 0; i < 8; ++i) match->tick({});
        if (t % 96 == 0)
            hurt(match->context_to_change(), wizard, match->match().played,
                 {.points = 1, .by = 1, .how = EventKind::object_hit});
        take_casting(*match, wizard, 0, casting);
        if (casting.since_flash_s < before) ++flashes;
        before = casting.since_flash_s;
    }
    EXPECT_GE(flashes, 4U);
    EXPECT_LE(flashes, 6U) << "hits come ten times a second";
}

TEST(FogSeen, VeilsTheViewOfWhoStandsInIt) {
    auto picture = new_casting_picture();
    const auto veils = [&] {
        render::Overlay out;
        add_fog_veil(out, picture, 0, *lay_out({}, {1280, 720}, 5).views[0]);
        return out.items.size();
    };
    EXPECT_EQ(veils(), 0U);
    picture.fogs.push_back({picture.wizards[0].vitals.eye, 4, 1.6, 1});
    EXPECT_EQ(veils(), 1U);
    picture.fogs[0].place.x += 5;
    EXPECT_EQ(veils(), 0U);
}

}  // namespace
}  // namespace thaum::game::hud_tests

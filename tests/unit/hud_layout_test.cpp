// Tests of the HUD's layout: at every size of text and window no panels overlap, and texts stay inside their
// panels.
#include "game/hud/layout.h"

#include <thread>
#include <tuple>

#include "core/text.h"
#include "game/hud/menu.h"
#include "render/font.h"
#include "unit/hud_rig.h"
#include "unit/hud_words.h"

namespace thaum::game::hud_tests {
namespace {

struct Arranged {
    Watch watch{};
    render::Split split{};
    std::string_view name;
    bool replay = false;
};
constexpr std::array<Arranged, 6> arrangements{
    {{Watch::both, render::Split::top_bottom, "stacked"},
     {Watch::both, render::Split::side_by_side, "beside"},
     {Watch::first, render::Split::top_bottom, "alone"},
     {Watch::both, render::Split::top_bottom, "replay, stacked", true},
     {Watch::both, render::Split::side_by_side, "replay, beside", true},
     {Watch::second, render::Split::top_bottom, "replay, alone", true}}};
constexpr std::array<render::Size, 8> windows{
    {{640, 480}, {640, 360}, {800, 600}, {1280, 720}, {1366, 768}, {1920, 1080}, {2560, 1080}, {3840, 2160}}};

/// The bar at the bottom of a replay, with the longest possible texts.
ReplayBar busy_bar() {
    return {
        .length = 600'000,
        .indexed = 100'000,
        .target = 590'000,
        .speed = 0.25,
        .paused = true,
        .eyes = "Ember's eyes",
        .keys =
            "Space: pause   Left, Right: 5 s   Up, Down: speed   Home, End   Page Up, Down: kill   V: eyes",
        .kills = {{50'000, 0, 1}, {50'100, 1, 1}}};
}

HudSettings settings_of(const Arranged& how, double text_scale) {
    HudSettings settings{.split = how.split, .watch = how.watch, .text_scale = text_scale};
    if (how.replay) settings.replay = busy_bar();
    return settings;
}

/// Calls f(settings, window, name) for every size of text and window and every arrangement of views.
template <class F>
void each_case(F f) {
    for (const auto& how : arrangements) {
        for (const auto& window : windows) {
            for (double scale = 1; scale <= 2.5; scale += 0.25) {
                f(settings_of(how, scale), window,
                  text(how.name, " ", window.width, " x ", window.height, " at ", scale));
            }
        }
    }
}

struct NamedBox {
    std::string name;
    Panel box;
};

std::vector<NamedBox> boxes_of(const HudLayout& layout) {
    std::vector<NamedBox> boxes{{"score", layout.score}, {"notices", layout.notices}};
    if (layout.lesson) boxes.push_back({"lesson", *layout.lesson});
    if (layout.replay) {
        const auto& bar = *layout.replay;
        boxes.push_back({"clock", bar.clock});
        boxes.push_back({"state", bar.state});
        boxes.push_back({"track", bar.track});
        boxes.push_back({"keys", bar.keys});
    }
    for (std::uint32_t p = 0; p < players; ++p) {
        if (!layout.views[p]) continue;
        const auto& v = *layout.views[p];
        const auto add = [&](std::string_view name, const Panel& box) {
            boxes.push_back({text(name, " ", p + 1), box});
        };
        add("health", v.health);
        add("name", v.name);
        add("strip", v.strip);
        add("feed", v.feed);
        add("messages", v.messages);
        add("forces", v.forces);
        add("heard", v.heard);
        if (!layout.lesson) add("figure", v.figure);
        if (v.aside.high.x > v.aside.low.x) add("aside", v.aside);
        if (v.likely.high.x > v.likely.low.x) add("likely", v.likely);
        add("ring", {v.centre - fvec2(v.ring), v.centre + fvec2(v.ring)});
    }
    return boxes;
}

TEST(HudLayout, NoTwoPanelsOverlapAtAnySize) {
    for (const std::size_t wands : {1U, 5U, 6U, 9U, 105U}) {
        const bool lesson = wands > 100;
        each_case([&](const HudSettings& settings, render::Size window, const std::string& name) {
            const auto boxes = boxes_of(lay_out(settings, window, wands % 100,
                                                {.lesson = lesson, .cards = {wands == 5, wands == 6}}));
            for (std::size_t a = 0; a < boxes.size(); ++a) {
                for (std::size_t b = a + 1; b < boxes.size(); ++b) {
                    EXPECT_FALSE(overlap(boxes[a].box, boxes[b].box))
                        << name << ", " << wands << " wands: " << boxes[a].name << " and " << boxes[b].name;
                }
            }
        });
    }
}

TEST(HudLayout, EveryPanelHasRoomInsideItsView) {
    each_case([](const HudSettings& settings, render::Size window, const std::string& name) {
        const auto layout = lay_out(settings, window, 5);
        for (const auto& [what, box] : boxes_of(layout)) {
            EXPECT_GE(box.low.x, 0) << name << ": " << what;
            EXPECT_GE(box.low.y, 0) << name << ": " << what;
            EXPECT_LE(box.high.x, static_cast<float>(window.width)) << name << ": " << what;
            EXPECT_LE(box.high.y, static_cast<float>(window.height)) << name << ": " << what;
            EXPECT_GT(box.high.x - box.low.x, 10) << name << ": " << what;
            EXPECT_GT(box.high.y - box.low.y, 8) << name << ": " << what;
        }
    });
}

TEST(HudLayout, ALikelySpellHasRoomAtUsualSizes) {
    each_case([](const HudSettings& settings, render::Size window, const std::string& name) {
        if (window.width < 1280 || settings.text_scale > 2) return;
        for (const auto& view : lay_out(settings, window, 5).views) {
            if (view) EXPECT_GE(view->likely.high.y - view->likely.low.y, 13.9F * view->unit) << name;
        }
    });
}

TEST(HudLayout, LargerTextIsLargerUpToWhatTheViewHolds) {
    for (const auto& how : arrangements) {
        for (const auto& window : windows) {
            float before = 0;
            for (double scale = 1; scale <= 2.5; scale += 0.25) {
                const auto layout = lay_out(settings_of(how, scale), window, 5);
                // In a replay the bar of times below takes more room from the views as the text grows.
                if (layout.replay) continue;
                EXPECT_GE(layout.unit, before);
                before = layout.unit;
            }
            const auto usual = lay_out(settings_of(how, 1), window, 5).unit;
            if (how.replay) continue;
            EXPECT_GE(before, 1.3F * usual) << how.name << " " << window.width << " x " << window.height;
        }
    }
}

TEST(HudLayout, WindowsOfAnyShapeHaveALayout) {
    for (const auto& window : {render::Size{1, 1}, {16384, 100}, {100, 16384}, {2, 4000}}) {
        for (const auto& how : arrangements) {
            const auto layout = lay_out(settings_of(how, 2.5), window, 5);
            for (const auto& [what, box] : boxes_of(layout)) {
                EXPECT_TRUE(std::isfinite(box.low.x) && std::isfinite(box.high.y)) << what;
            }
            overlay_of(picture_of(*new_match()), settings_of(how, 1), window);
        }
    }
}

TEST(HudLayout, TheBarOfAReplayIsBelowTheViewsAndGrowsWithTheText) {
    for (const auto& window : windows) {
        float before = 0;
        for (double scale = 1; scale <= 2.5; scale += 0.25) {
            const auto bar = lay_out_replay_bar(scale, window);
            EXPECT_GE(bar.unit, before);
            before = bar.unit;
            const HudSettings settings{.text_scale = scale, .replay = busy_bar()};
            for (const auto& view : views_of(settings, window))
                EXPECT_LE(static_cast<float>(view.y + view.height), bar.band.low.y);
            EXPECT_LE(bar.keys.high.y, bar.band.high.y);
            EXPECT_GE(bar.clock.low.y, bar.band.low.y);
            EXPECT_LE(bar.band.high.y - bar.band.low.y, 0.23F * static_cast<float>(window.height));
        }
        EXPECT_GE(before, 1.3F * lay_out_replay_bar(1, window).unit)
            << window.width << " x " << window.height;
    }
}

TEST(HudLayout, TheKeysOfAReplayAreAsReadableAsTheRestOfItsBar) {
    const auto picture = picture_of(*new_match());
    for (const auto& window : windows) {
        for (const double scale : {1.0, 1.5, 2.0, 2.5}) {
            const HudSettings settings{.text_scale = scale, .replay = busy_bar()};
            const float unit = lay_out_replay_bar(scale, window).unit;
            const auto overlay = overlay_of(picture, settings, window);
            for (const auto* words : texts_with(overlay, "Page Up")) {
                EXPECT_GE(words->size, std::floor(0.8F * 10.5F * unit))
                    << window.width << " x " << window.height << " at " << scale;
            }
        }
    }
}

TEST(HudLayout, APlaceOnTheTrackIsATick) {
    const auto bar = lay_out_replay_bar(1, {1280, 720});
    EXPECT_EQ(tick_at(bar, bar.track.low.x, 1000), 0U);
    EXPECT_EQ(tick_at(bar, bar.track.high.x, 1000), 1000U);
    EXPECT_EQ(tick_at(bar, (bar.track.low.x + bar.track.high.x) / 2, 1000), 500U);
    EXPECT_EQ(tick_at(bar, -100, 1000), 0U);
    EXPECT_EQ(tick_at(bar, 9999, 1000), 1000U);
    EXPECT_EQ(tick_at(bar, 600, 0), 0U);
}

TEST(HudLayout, TheBarOfAReplayTellsTimeSpeedAndEyes) {
    auto picture = picture_of(*new_match());
    picture.tick = 65'432;
    auto overlay = overlay_of(picture, {.replay = busy_bar()}, size);
    EXPECT_TRUE(has_text(overlay, "1:05.4 / 10:00"));
    EXPECT_TRUE(has_text(overlay, "0.25 x"));
    EXPECT_TRUE(has_text(overlay, "on the way to 9:50"));
    auto at_end = busy_bar();
    at_end.length = picture.tick;
    at_end.speed = 2;
    at_end.eyes = "both views";
    at_end.target = {};
    overlay = overlay_of(picture, {.replay = at_end});
    EXPECT_TRUE(has_text(overlay, "end, 2 x, both views"));
}

TEST(FittedWords, BreakAtSpacesAndShrinkOnlyIfTheyMust) {
    const auto whole = fit("one two three", 10, {1000, 100});
    EXPECT_EQ(whole.lines, std::vector<std::string>{"one two three"});
    EXPECT_EQ(whole.size, 10);
    const auto broken = fit("one two three", 10, {width_of("one two", 10) + 1, 100});
    EXPECT_EQ(broken.lines, (std::vector<std::string>{"one two", "three"}));
    EXPECT_EQ(broken.size, 10);
    const auto small = fit("one two three", 10, {70, 13});
    EXPECT_LT(small.size, 10);
    EXPECT_GT(small.size, 4);
    EXPECT_LE(small.height(), 13);
    EXPECT_TRUE(fit("", 10, {40, 13}).lines.empty());
}

// ---- texts that a match shows -----------------------------------------------------------------------------

/// A match with as many texts as possible at once.
Picture talkative() {
    auto picture = picture_of(*new_match());
    for (auto& p : picture.wizards) {
        p.stations.carries = "iron";
        p.stations.at_rim = true;
        p.senses.since_gift_s = 0.5;
        p.senses.gift = {.kind = EventKind::power_up, .amount = 25};
        p.senses.since_warning_s = 0.1;
        p.senses.warning = EventKind::dry;
        p.senses.force.arm = ArmCondition::felt;
        p.senses.force.cause = haptics::SafetyCause::shut_off;
        p.senses.heard_lines = static_cast<std::uint32_t>(p.senses.heard.size());
        p.senses.heard.fill(
            {.words = "surface of the brew", .from = HeardFrom::below, .important = true, .verb = "pushes"});
        p.senses.felt.fill(0.5F);
        p.senses.since_felt_s = 0;
        p.senses.hurts = 1;
    }
    picture.cauldron.contents[0] = "ember";
    picture.cauldron.contents[1] = "salt";
    picture.cauldron.owner = 1;
    picture.cauldron.spoils_in_s = 12;
    picture.feed_lines = static_cast<std::uint32_t>(picture.feed.size());
    for (auto& line : picture.feed) {
        line.event = {.kind = EventKind::death,
                      .subject = 0,
                      .by = 1,
                      .detail = static_cast<std::uint32_t>(hit_kind("bolt_hit"))};
    }
    picture.practice.lesson = "Take Swing with {wand:swing}. Hold {fire} on the anchor: cross the pit.";
    picture.practice.hint = "Look up at the anchor, walk forward, let go beyond.";
    picture.caption.words = "read wands/bolt.toml";
    picture.overloaded = true;
    picture.skipped = 1107;
    picture.mark = 3;
    return picture;
}

TEST(HudLayout, ASoundInWordsHasRoomAtAnySize) {
    each_case([&](const HudSettings& settings, render::Size window, const std::string& name) {
        const auto layout = lay_out(settings, window, 5);
        for (const auto& view : layout.views) {
            if (!view) continue;
            EXPECT_GE(view->heard.high.y - view->heard.low.y, heard_line_high * view->unit - 0.5F) << name;
            const fvec2 room(
                view->heard.high.x - view->heard.low.x - 12 * view->unit,
                std::min(view->heard.high.y - view->heard.low.y, 2 * heard_line_high * view->unit));
            EXPECT_GE(fit("step, behind", 13 * view->unit, room).size, std::floor(8.5F * view->unit)) << name;
        }
    });
}

TEST(HudLayout, NoTwoTextsOverlapWhenAllIsSaidAtOnce) {
    auto font = render::Font::load();
    if (!font) GTEST_SKIP() << font.error().message;
    const auto picture = talkative();
    std::size_t said = 0;
    each_case([&](HudSettings settings, render::Size window, const std::string& name) {
        settings.forces = name.size() % 2 == 0;  // some cases with the curve of forces, some without
        settings.heard = {HeardWish::all, HeardWish::all};
        settings.prompts = {PromptWish::always, PromptWish::always};
        for (auto& one : settings.controls) one = {.fire = "Left mouse", .stir = "E", .throw_ = "F"};
        for (auto& one : settings.device_messages) one = "The arm's motors are too warm: let them rest";
        const auto words = words_of(overlay_of(picture, settings, window), *font);
        said += words.size();
        expect_apart(words, name);
        for (const auto& [line, box] : words) {
            EXPECT_GE(box.low.x, -1) << name << ": " << line;
            EXPECT_LE(box.high.x, static_cast<float>(window.width) + 1) << name << ": " << line;
        }
    });
    EXPECT_GT(said, 20U * arrangements.size() * windows.size() * 7);
}

/// The end of a match, with a full table of hits.
Picture finished() {
    auto picture = picture_of(*new_match());
    picture.phase = Phase::over;
    picture.ending = Ending::kills;
    picture.match_winner = 1;
    picture.rounds = 3;
    picture.rounds_won = {1, 2};
    for (auto& stats : picture.match_stats)
        for (std::size_t cause = 0; cause < 6; ++cause)
            stats[cause] = {.shots = 140, .hits = 123, .kills = 12, .damage = 1444};
    return picture;
}

TEST(ResultPanel, HidesWhatIsBelowItAndItsWordsKeepApart) {
    auto font = render::Font::load();
    if (!font) GTEST_SKIP() << font.error().message;
    const auto picture = finished();
    each_case([&](HudSettings settings, render::Size window, const std::string& name) {
        if (settings.replay) return;
        settings.names = {"WWWWWWWWWWWWWWWW", "Bot 3"};
        const auto overlay = overlay_of(picture, settings, window);
        const auto plates = items_of<render::RectItem>(overlay);
        const auto panel = std::ranges::find_if(plates, [](const auto* box) { return box->colour.a >= 1; });
        ASSERT_NE(panel, plates.end()) << name;
        const auto& outer = **panel;
        const auto words = words_of(overlay, *font);
        EXPECT_GE(words.size(), 15U) << name;
        expect_apart(words, name);
        for (const auto& [line, box] : words) {
            EXPECT_TRUE(box.low.x >= outer.low.x && box.high.x <= outer.high.x && box.low.y >= outer.low.y &&
                        box.high.y <= outer.high.y)
                << name << ": " << line << " leaves the panel";
        }
    });
}

TEST(ResultPanel, GrowsWithTheTextAsFarAsTheWindowHolds) {
    auto picture = finished();
    const auto size_at = [&](double scale, render::Size window) {
        const auto overlay = overlay_of(picture, {.text_scale = scale}, window);
        return texts_with(overlay, "hit").back()->size;
    };
    EXPECT_GE(size_at(1, {640, 480}), 10);
    EXPECT_GE(size_at(2.5, {640, 480}), 1.25F * size_at(1, {640, 480})) << "the table is full";
    EXPECT_GE(size_at(2.5, {1280, 720}), 1.35F * size_at(1, {1280, 720}));
    for (auto& stats : picture.match_stats)
        for (std::size_t cause = 2; cause < 6; ++cause) stats[cause] = {};
    EXPECT_GE(size_at(2.5, {640, 480}), 1.8F * size_at(1, {640, 480}));
    EXPECT_GE(size_at(2.5, {1280, 720}), 2 * size_at(1, {1280, 720}));
}

/// Texts of a panel, with their places and sizes.
std::vector<std::tuple<std::string, float, float, float>> places_of_words(const Picture& picture,
                                                                          const HudSettings& settings,
                                                                          render::Size window) {
    const auto overlay = overlay_of(picture, settings, window);
    std::vector<std::tuple<std::string, float, float, float>> words;
    for (const auto* one : items_of<render::TextItem>(overlay))
        words.emplace_back(one->text, one->position.x, one->position.y, one->size);
    return words;
}

TEST(ResultPanel, IsTheSameWhateverPanelWasDrawnBefore) {
    struct Drawn {
        Picture picture;
        HudSettings settings;
        render::Size window{1280, 720};
    };
    std::vector<Drawn> panels(7, {finished(), {}});
    panels[1].settings.names[0] = "Somebody else";  // name of the player who has lost
    panels[2].window = {640, 480};
    panels[3].settings.text_scale = 2.5;
    panels[4].picture.wizards[0].vitals.kills += 17;
    panels[5].picture.match_stats[0][0].shots += 1000;
    panels[6].picture.paused = true;
    panels[6].picture.phase = Phase::playing;
    std::vector<std::vector<std::tuple<std::string, float, float, float>>> all;
    for (std::size_t i = 0; i < 2 * panels.size(); ++i) {
        const auto& panel = panels[i % panels.size()];
        const auto places = [&] { return places_of_words(panel.picture, panel.settings, panel.window); };
        all.push_back(places());
        std::vector<std::tuple<std::string, float, float, float>> first;
        std::thread([&] { first = places(); }).join();
        EXPECT_EQ(all.back(), first) << "a thread that has drawn no panel, " << i;
        EXPECT_EQ(all.back(), all[i % panels.size()]);
    }
    for (std::size_t i = 1; i < panels.size(); ++i) EXPECT_NE(all[i], all[0]) << i;
}

TEST(HudLayout, ANameOfFifteenLettersIsAsLargeAsAShortOne) {
    const auto picture = picture_of(*new_match());
    const auto size_of = [&](HudSettings settings, render::Size window, const std::string& words) {
        settings.names = {words, words};
        const auto overlay = overlay_of(picture, settings, window);
        return text_item(overlay, words)->size;
    };
    for (const auto& how : arrangements) {
        for (const auto& window : windows) {
            const auto settings = settings_of(how, 1);
            EXPECT_EQ(size_of(settings, window, "Ångström Ödland"), size_of(settings, window, "Zoë"))
                << how.name << " " << window.width << " x " << window.height;
        }
    }
    EXPECT_GE(size_of(settings_of(arrangements[0], 1), {640, 480}, "WWWWWWWWWWWWWWWW"), 9);
    EXPECT_GE(size_of(settings_of(arrangements[1], 2.5), {640, 480}, "WWWWWWWWWWWWWWWW"), 5);
}

/// The longest text of the guided lessons, with the keys of one half of the keyboard.
Picture in_lesson() {
    auto picture = picture_of(*new_match());
    picture.practice.on = true;
    picture.practice.score = "1 of 8: Look and move, 99 %";
    picture.practice.below = "{pause}: skip or leave";
    picture.practice.lesson = "Walk with {move} and look around with {look}.";
    picture.practice.hint = "Carry an ingredient to the rim. Move the ladle in circles.";
    return picture;
}

/// Font size of the first text that contains `part` (px); 0 if there is none.
float size_of_text(const render::Overlay& overlay, std::string_view part) {
    const auto found = texts_with(overlay, part);
    return found.empty() ? 0 : found[0]->size;
}

TEST(Lesson, IsLargerThanItsTitleHasItsHintAndGrowsWithTheText) {
    const auto picture = in_lesson();
    for (const auto& window : windows) {
        float usual = 0;
        for (double scale = 1; scale <= 2.5; scale += 0.25) {
            HudSettings settings{.watch = Watch::first, .text_scale = scale};
            settings.controls[0] = {
                .fire = "Left mouse", .move = "Keypad 8 4 5 6", .look = "Up Left Down Right"};
            const auto overlay = overlay_of(picture, settings, window);
            const auto where = text(window.width, " x ", window.height, " at ", scale);
            const float words = size_of_text(overlay, "Walk");
            if (scale == 1) usual = words;
            EXPECT_GE(words, size_of_text(overlay, "of 8")) << where;
            EXPECT_GE(size_of_text(overlay, "Carry"), 0.8F * words) << where << ": the hint is there";
            EXPECT_TRUE(has_text(overlay, "[Keypad 8 4 5 6]")) << where;
            EXPECT_TRUE(has_text(overlay, "[Up Left Down Right]")) << where;
            EXPECT_TRUE(has_text(overlay, "1 of 8: Look and move, 99 %")) << where;
            EXPECT_GE(words, scale == 2.5 ? 1.25F * usual : usual) << where;
        }
    }
}

TEST(MenuFoot, LongHelpAndKeysAreBrokenIntoLinesInsteadOfTiny) {
    MenuPicture menu{.title = "Settings", .line = {}, .seats = {}, .rows = {}, .note = {}, .hint = {}};
    menu.rows = {{.label = "Carried weight",
                  .help = "Lets the hand feel less of the weight; the match stays the same."},
                 {.label = "Back", .help = "Goes back."}};
    menu.hint =
        "choose: arrows, W and S, mouse or pad    confirm: Enter, A, click    back: Esc, B, right button";
    for (const auto& window : windows) {
        const auto size_at = [&](double scale, std::string_view part) {
            render::Overlay overlay;
            add_menu(overlay, menu, window, scale);
            return size_of_text(overlay, part);
        };
        for (const std::string_view part : {"Lets the", "choose"}) {
            EXPECT_GE(size_at(2.5, part), 1.4F * size_at(1, part))
                << part << " " << window.width << " x " << window.height;
        }
    }
}

TEST(FittedWords, KeepAControlInItsBracketsOnOneLine) {
    EXPECT_EQ(fit("Walk to [W A S D], 100 %", 10, {width_of("[W A S D],", 10) + 1, 100}).lines,
              (std::vector<std::string>{"Walk to", "[W A S D],", "100 %"}));
    EXPECT_EQ(fit("a [b c", 10, {width_of("a [b", 10) + 1, 100}).lines,
              (std::vector<std::string>{"a [b", "c"}));
}

}  // namespace
}  // namespace thaum::game::hud_tests

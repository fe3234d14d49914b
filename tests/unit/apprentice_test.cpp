// Tests of the Apprentice: its file of lessons, and a scripted player who does the whole course with device samples.
#include "game/bots/apprentice.h"

#include <gtest/gtest.h>

#include "core/text.h"
#include "unit/game_duel.h"

namespace thaum::game::test {
namespace {

// The file ------------------------------------------------------------------------------------------------------

/// A sound file of one step, with other lines for the step's keys.
std::string file_with(std::string_view text_line, std::string_view goal, std::string_view more = "") {
    return thaum::text(
        "version = 1\narena = \"boiling_court\"\nend = \"Done\"\n"
        "[place.here]\nposition = [1, 0, 2]\n"
        "[[step]]\nname = \"One\"\n",
        text_line, "\nhint = \"Try\"\nplayer = \"here\"\n", goal, "\n", more);
}
constexpr auto sound_text = "text = \"Press {fire} for {wand:bolt}\"";
constexpr auto sound_goal =
    "goal = [{moved_m = 2, turned_deg = 90}, {event = \"bolt_hit\", count = 3, soon_s = 4}]";

std::string lessons_fault(const std::string& toml) {
    const auto lessons = parse_lessons(toml, "apprentice.toml");
    return lessons ? std::string() : lessons.error().message;
}

TEST(LessonsFile, TheShippedOneIsSound) {
    const auto lessons = load_lessons(assets());
    ASSERT_TRUE(lessons) << lessons.error().message;
    EXPECT_GE(lessons->steps.size(), 7U);
    EXPECT_EQ(lessons->arena, "boiling_court");
}

TEST(LessonsFile, GivesDeedsInOrderWithTheirConditions) {
    const auto lessons = parse_lessons(file_with(sound_text, sound_goal), "apprentice.toml");
    ASSERT_TRUE(lessons) << lessons.error().message;
    const auto& step = lessons->steps.at(0);
    ASSERT_EQ(step.deeds.size(), 2U);
    EXPECT_EQ(step.deeds[0].conditions.size(), 2U);
    EXPECT_FALSE(step.deeds[0].soon);
    const auto& hits = step.deeds[1].conditions.at(0);
    EXPECT_EQ(hits.kind, ConditionKind::event);
    EXPECT_EQ(hits.event, hit_kind("bolt_hit"));
    EXPECT_EQ(hits.amount, 3);
    EXPECT_EQ(step.deeds[1].soon, ticks(4.0));
    ASSERT_TRUE(step.player);
    EXPECT_EQ(step.player->feet, vec3(1, 0, 2));
    EXPECT_FALSE(step.dummy);
}

TEST(LessonsFile, FaultsAreToldWithFileLineAndKey) {
    const auto with_goal = [](std::string_view goal) { return lessons_fault(file_with(sound_text, goal)); };
    const auto tells = [](const std::string& fault, std::string_view words) {
        EXPECT_NE(fault.find("apprentice.toml:"), std::string::npos) << fault;
        EXPECT_NE(fault.find(words), std::string::npos) << fault;
        EXPECT_EQ(fault.find('\n'), std::string::npos) << fault;
    };
    EXPECT_EQ(lessons_fault(file_with(sound_text, sound_goal)), "");
    tells(with_goal("goal = [{danced_s = 2}]"), ":11: unknown goal 'danced_s'");
    tells(with_goal("goal = [{event = \"bolt_miss\"}]"), ":11: unknown event 'bolt_miss'");
    tells(with_goal("goal = [{moved_m = 2, count = 3}]"), ":11: 'count' needs 'event'");
    tells(with_goal("goal = [{near = \"there\", within_m = 2}]"), ":11: 'near': no place 'there'");
    tells(with_goal("goal = [{readiness = 0.5, wand = \"broom\"}]"),
          ":11: 'wand' must be one of: blast, bolt");
    tells(with_goal("goal = [{moved_m = -2}]"), "'moved_m' is -2");
    tells(with_goal("goal = [{soon_s = 2}]"), "a deed needs a condition");
    tells(with_goal("goal = []"), "a step needs a goal");
    tells(with_goal(""), "a step needs a goal");
    tells(lessons_fault(
              file_with("text = \"one two three four five six seven eight nine ten eleven twelve thirteen\"",
                        sound_goal)),
          ":8: 'text' has 13 words: at most 12");
    tells(lessons_fault(file_with("text = \"Press {fier}\"", sound_goal)), ":8: 'text' may contain {move}");
    tells(lessons_fault(file_with("text = \"Take {wand:broom}\"", sound_goal)),
          ":8: 'text' may contain {move}");
    const auto file = file_with(sound_text, sound_goal);
    tells(lessons_fault(file + file.substr(file.find("[[step]]"))), "a second step has the name 'One'");
    tells(lessons_fault("version = 1\narena = \"boiling_court\"\nend = \"Done\"\n"), "at least one [[step]]");
}

}  // namespace
}  // namespace thaum::game::test

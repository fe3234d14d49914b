// Tests of the Apprentice (the game's guided course): its file of lessons, and a scripted player who
// completes all lessons with device samples.
#include "game/range/apprentice.h"

#include <gtest/gtest.h>

#include "core/file.h"
#include "core/text.h"
#include "unit/game_duel.h"
#include "unit/message_of.h"

namespace thaum::game::test {
namespace {

// File of lessons ------------------------------------------------------------------------------------------

/// A correct file of lessons with one step. The arguments are the lines for the step's text, its goal and
/// further keys.
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
    return message_of(parse_lessons(toml, "apprentice.toml"));
}

TEST(LessonsFile, TheShippedOneIsSound) {
    const auto lessons = load_lessons(assets()).value();
    EXPECT_GE(lessons.steps.size(), 7U);
    EXPECT_EQ(lessons.arena, "boiling_court");
}

TEST(LessonsFile, GivesDeedsInOrderWithTheirConditions) {
    const auto lessons = parse_lessons(file_with(sound_text, sound_goal), "apprentice.toml").value();
    const auto& step = lessons.steps.at(0);
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

TEST(LessonsFile, WordsThatCannotBeReadAreRefused) {
    const auto refused = [](const std::string& toml, std::string_view words) {
        const auto fault = lessons_fault(toml);
        EXPECT_NE(fault.find("apprentice.toml:"), std::string::npos) << fault;
        EXPECT_NE(fault.find(words), std::string::npos) << fault;
        EXPECT_LT(fault.size(), 400U) << fault;
    };
    const auto with_text = [](std::string_view words) {
        return file_with(thaum::text("text = \"", words, "\""), sound_goal);
    };
    const auto with_name = [](std::string_view name) {
        auto file = file_with(sound_text, sound_goal);
        return file.replace(file.find("\"One\""), 5, thaum::text("\"", name, "\""));
    };
    const std::string long_word(10'000, 'w');
    refused(with_text(long_word), ":8: 'text' has a word of 10000 characters: at most 24");
    refused(with_name(long_word), ":7: 'name' has 10000 characters: at most 24");
    refused(with_text(""), ":8: 'text' is empty: write some words");
    refused(with_text("  "), ":8: 'text' is empty");
    refused(with_name(""), ":7: 'name' is empty");
    for (const auto* odd :
         {"A\\nB", "A\\u001B[31m", "A\\u0007", "A\xF0\x9F\x94\xA5", "A\xD7\x90", "A\\u202E"}) {
        refused(with_text(odd), ":8: 'text': character 2 cannot be shown; use Latin");
        refused(with_name(odd), ":7: 'name': character 2 cannot be shown; use Latin");
    }
    auto end = file_with(sound_text, sound_goal);
    end.replace(end.find("\"Done\""), 6, "\"Done\\u001B\"");
    refused(end, ":3: 'end': character 5 cannot be shown");
    std::string deeds = "goal = [";
    for (int i = 0; i < 2000; ++i) deeds += "{moved_m = 5}, ";
    refused(file_with(sound_text, deeds + "]"), ":11: 'goal' has 2000 deeds: at most 16");
    auto many = std::string("version = 1\narena = \"boiling_court\"\nend = \"Done\"\n");
    for (int i = 0; i < 51; ++i)
        many +=
            thaum::text("[[step]]\nname = \"", i, "\"\ntext = \"A\"\nhint = \"B\"\ngoal = [{moved_m = 1}]\n");
    refused(many, "the course has 51 steps: at most 50");
}

TEST(LessonsFile, PlacesWhereNobodyCanStandAreRefused) {
    const auto fault_of_place = [](std::string_view position, std::string_view arena = "boiling_court") {
        auto file = file_with(sound_text, sound_goal);
        file.replace(file.find("[1, 0, 2]"), 9, position);
        file.replace(file.find("boiling_court"), 13, arena);
        return message_of(parse_lessons(file, "apprentice.toml", assets()));
    };
    const auto refused = [&](std::string_view position, std::string_view why) {
        EXPECT_EQ(fault_of_place(position), thaum::text("apprentice.toml:5: the place 'here' ", why,
                                                        ": choose a free place on the ground of the arena"));
    };
    EXPECT_EQ(fault_of_place("[13.5, 0, 5.5]"), "");
    EXPECT_EQ(fault_of_place("[-4, -5, 9]"), "") << "the bottom of a pit is ground, too";
    refused("[400, -400, 400]", "is outside the walls");
    refused("[20.4, 0, 0]", "is outside the walls");
    refused("[7, 0, 3.5]", "is inside a solid thing");
    refused("[10, 0, 4.5]", "is inside a solid thing");
    refused("[13, -2, -3]", "is inside a solid thing");
    refused("[0, 0, 0]", "is in the cauldron");
    refused("[1, 0.2, 1]", "is in the cauldron");
    refused("[-4, 0, 9]", "has no ground below it");
    refused("[13, 4, -3]", "has no ground below it");
    EXPECT_TRUE(fault_of_place("[0, 0, 5]", "nowhere").starts_with("apprentice.toml:2: 'arena': "))
        << fault_of_place("[0, 0, 5]", "nowhere");
    auto shipped = *read_text_file(assets() / "apprentice.toml", 1U << 16U);
    shipped.replace(shipped.find("boiling_court"), 13, "the_well");
    const auto message = message_of(parse_lessons(shipped, "apprentice.toml", assets()));
    EXPECT_NE(message.find("the place '"), std::string::npos)
        << "the places are those of another arena: " << message;
}

}  // namespace
}  // namespace thaum::game::test

// Adds a command to the program by this source file alone, without a change of the game's files. A command of
// the game is in game/app/tool_commands/NAME.cpp, and has a line in game/app/dispatch.cpp, so that `thaum`
// lists it and starts thaum-tools for it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <set>
#include <sstream>

#include "game/app/command.h"

namespace thaum::game {
namespace {

int hum(const std::vector<std::string>& words) {
    if (words.empty()) return refuse({"hum needs a tune"});
    std::printf("hum, %s\n", words[0].c_str());
    return done;
}

const CommandRegistration registration_of_hum(
    {.name = "hum", .help = "usage: thaum hum TUNE\n", .run = hum, .summary = "hum a tune"});

/// Exit code of a command line, followed by what it prints.
std::string printed(std::vector<std::string> words) {
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    const int code = dispatch(std::move(words), "");
    std::fflush(stdout);
    return std::to_string(code) + " " + testing::internal::GetCapturedStdout() +
           testing::internal::GetCapturedStderr();
}

TEST(NewCommand, RunsAndHasHelp) {
    EXPECT_EQ(printed({"hum", "low"}), "0 hum, low\n");
    EXPECT_EQ(printed({"hum"}), "2 thaum: hum needs a tune\n");
    EXPECT_EQ(printed({"hum", "--help"}), "0 usage: thaum hum TUNE\n");
    EXPECT_EQ(printed({"help", "hum"}), "0 usage: thaum hum TUNE\n");
}

TEST(Commands, TheListHasEachCommandOfThisProgramOnceAndNoOther) {
    std::istringstream lines(printed({"help"}));
    std::multiset<std::string> listed, there;
    for (std::string line; std::getline(lines, line);)
        if (line.starts_with("  ")) listed.insert(line.substr(2, line.find(' ', 2) - 2));
    for (const auto& command : commands()) there.emplace(command.name);
    EXPECT_EQ(listed, there);
    EXPECT_TRUE(listed.contains("play") && listed.contains("scenario") && listed.contains("hum"));
    EXPECT_NE(printed({"help"}).find("\n  hum       hum a tune\n"), std::string::npos);
}

}  // namespace
}  // namespace thaum::game

// Tests that each rule reports faults in small source trees that break it, and none in correct ones.
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

#include "structure/rules.h"

namespace thaum::structure {
namespace {

namespace fs = std::filesystem;

class Rules : public ::testing::Test {
protected:
    Rules() {
        auto name = (fs::temp_directory_path() / "thaum-rules-XXXXXX").string();
        root_ = ::mkdtemp(name.data());
    }
    ~Rules() override { fs::remove_all(root_); }
    Rules(const Rules&) = delete;
    Rules& operator=(const Rules&) = delete;

    void add(const fs::path& path, std::string_view text) const {
        fs::create_directories((root_ / path).parent_path());
        std::ofstream(root_ / path) << text;
    }

    /// Faults that are reported for one file in engine/ or game/ with the given include in its second line.
    Faults arrow(const fs::path& from, const std::string& include) const {
        add(from, "// what it is for\n#include " + include + "\n");
        auto faults = upward_includes(root_);
        fs::remove(root_ / from);
        return faults;
    }

    const fs::path& root() const { return root_; }

private:
    fs::path root_;
};

TEST_F(Rules, IncludesMayPointDown) {
    EXPECT_EQ(arrow("engine/ecs/a.h", "\"core/a.h\""), Faults{});
    EXPECT_EQ(arrow("engine/fluid/a.h", "\"field/a.h\""), Faults{});
    EXPECT_EQ(arrow("engine/render/a.cpp", "\"ecs/a.h\""), Faults{});
    EXPECT_EQ(arrow("engine/input/a.cpp", "\"haptics/a.h\""), Faults{});
    EXPECT_EQ(arrow("engine/input/a.cpp", "\"tactile/a.h\""), Faults{});
    EXPECT_EQ(arrow("engine/core/a.cpp", "<vector>"), Faults{});
    EXPECT_EQ(arrow("engine/core/a.cpp", "<toml++/toml.h>"), Faults{});
    EXPECT_EQ(arrow("engine/core/a.cpp", "\"core/detail/a.h\""), Faults{});
    EXPECT_EQ(arrow("game/hud/a.cpp", "\"game/match/a.h\""), Faults{});
    EXPECT_EQ(arrow("game/wands/a.cpp", "\"game/context/a.h\""), Faults{});
    EXPECT_EQ(arrow("game/match/a.cpp", "\"render/a.h\""), Faults{});
    EXPECT_EQ(arrow("game/components/a.h", "\"game/components/b.h\""), Faults{});
    EXPECT_EQ(arrow("game/components/a.h", "\"physics/b.h\""), Faults{});
    EXPECT_EQ(arrow("engine/examples/a.cpp", "\"input/log.h\""), Faults{});
}

TEST_F(Rules, IncludesMustNotPointUp) {
    EXPECT_EQ(arrow("engine/core/a.cpp", "\"ecs/world.h\""),
              Faults{"engine/core/a.cpp:2: core -> engine/ecs/world.h: only lower floors may be included"});
    EXPECT_EQ(arrow("engine/ecs/a.h", "\"game/match/match.h\""),
              Faults{"engine/ecs/a.h:2: ecs -> game/match/match.h: only lower floors may be included"});
    EXPECT_EQ(arrow("engine/field/a.h", "\"fluid/solver.h\"").size(), 1);
    EXPECT_EQ(arrow("engine/physics/a.h", "\"render/mesh.h\"").size(), 1);
    EXPECT_EQ(arrow("engine/haptics/a.h", "\"input/log.h\"").size(), 1);
    EXPECT_EQ(arrow("engine/ecs/a.h", "\"field/grid.h\"").size(), 1);
}

TEST_F(Rules, RoomsOfTheGameHaveFloors) {
    EXPECT_EQ(
        arrow("game/context/a.h", "\"game/match/a.h\""),
        Faults{"game/context/a.h:2: game/context -> game/match/a.h: only lower floors may be included"});
    EXPECT_EQ(arrow("game/stations/a.cpp", "\"game/wands/a.h\"").size(), 1);
    EXPECT_EQ(arrow("game/wands/a.cpp", "\"game/match/a.h\"").size(), 1);
    EXPECT_EQ(arrow("game/match/a.cpp", "\"game/hud/a.h\"").size(), 1);
    EXPECT_EQ(arrow("game/match/a.cpp", "\"game/attic/a.h\"").size(), 1);
    EXPECT_EQ(arrow("game/attic/a.cpp", "\"game/data/a.h\"").size(), 1);
}

TEST_F(Rules, NumericalPartsMustNotIncludeTheEcs) {
    for (const auto* part : {"field", "fluid", "haptics", "tactile", "gesture"}) {
        EXPECT_EQ(arrow(fs::path("engine") / part / "a.h", "\"ecs/world.h\"").size(), 1) << part;
    }
}

TEST_F(Rules, DetailAndComponentsAreClosed) {
    EXPECT_EQ(arrow("engine/ecs/a.h", "\"core/detail/a.h\"").size(), 1);
    EXPECT_EQ(arrow("game/match/a.h", "\"physics/detail/a.h\"").size(), 1);
    EXPECT_EQ(arrow("game/match/a.h", "\"game/hud/detail/a.h\"").size(), 1);
    EXPECT_EQ(arrow("game/components/a.h", "\"game/match/a.h\"").size(), 1);
    EXPECT_EQ(arrow("engine/core/a.h", "\"nowhere/a.h\"").size(), 1);
}

TEST_F(Rules, BaselinesAndAuditsStandApart) {
    EXPECT_EQ(arrow("engine/fluid/a.cpp", "\"fluid/classic/a.h\"").size(), 1);
    EXPECT_EQ(arrow("engine/gesture/a.h", "\"gesture/trials/a.h\"").size(), 1);
    EXPECT_EQ(arrow("engine/input/a.cpp", "\"haptics/audit/a.h\"").size(), 1);
    EXPECT_EQ(arrow("game/match/a.cpp", "\"render/audit/a.h\"").size(), 1);
    EXPECT_EQ(arrow("game/app/a.cpp", "\"gesture/trials/a.h\""), Faults{});
    EXPECT_EQ(arrow("engine/gesture/trials/a.cpp", "\"gesture/trials/a.h\""), Faults{});
    EXPECT_EQ(arrow("engine/fluid/classic/a.cpp", "\"fluid/detail/a.h\""), Faults{});
}

TEST_F(Rules, NoSpellingOfAnIncludeEscapesTheRules) {
    add("engine/render/mesh.h", "// render/mesh.h: meshes\n");
    EXPECT_EQ(arrow("engine/core/a.h", "\"../render/mesh.h\"").size(), 1);
    EXPECT_EQ(arrow("engine/core/a.h", "\"engine/render/mesh.h\"").size(), 1);
    EXPECT_EQ(arrow("engine/core/a.h", "<render/mesh.h>").size(), 1);
    EXPECT_EQ(arrow("engine/core/deep/a.h", "\"../../render/mesh.h\"").size(), 1);
    EXPECT_EQ(arrow("engine/core/a.inl", "\"render/mesh.h\"").size(), 1);
}

TEST_F(Rules, MachinePathsAreFound) {
    const auto home = std::string("/ho") + "me/someone/x";
    add("README.md", "one\ntwo " + home + "\n");
    add("assets/a.bin", std::string("\0\x01", 2) + root().string() + "/assets");
    add("build/CMakeCache.txt", home);
    add(".git/config", home);
    add("doc.md", "https://example.com" + home + "\n$HOME/x ~/x\n");
    const auto faults = machine_paths(root());
    ASSERT_EQ(faults.size(), 2);
    EXPECT_TRUE(faults[0].starts_with("README.md:2: "));
    EXPECT_TRUE(faults[1].starts_with("assets/a.bin:1: "));
}

TEST_F(Rules, ForgottenTestsAreFound) {
    add("tests/core.cmake", "thaum_test(test_core SOURCES unit/built.cpp)");
    add("tests/unit/built.cpp", "");
    add("tests/unit/forgotten.cpp", "");
    const auto faults = unbuilt_tests(root());
    ASSERT_EQ(faults.size(), 1);
    EXPECT_TRUE(faults[0].starts_with("tests/unit/forgotten.cpp:1: "));
}

TEST_F(Rules, HeadersWithoutATitleAreFound) {
    add("engine/core/good.h", "// core/good.h: says what it is\n");
    add("engine/core/bare.h", "#pragma once\n");
    add("engine/core/moved.h", "// ecs/moved.h: an old place\n");
    add("engine/core/inner/bare.h", "// core/bare.h: says what it is\n");
    add("engine/core/detail/inner.h", "#pragma once\n");
    EXPECT_EQ(headers_without_title(root()).size(), 3);
}

TEST_F(Rules, InternalHeadersBesideDetailAreFound) {
    add("engine/fluid/open.h", "#include \"fluid/by_header.h\"\n");
    add("engine/fluid/by_header.h", "");
    add("engine/fluid/tested.h", "");
    add("engine/fluid/own.h", "");
    add("engine/fluid/own.cpp", "#include \"fluid/own.h\"\n#include \"fluid/detail/inner.h\"\n");
    add("engine/fluid/detail/inner.h", "");
    add("game/match/a.cpp", "#include \"fluid/open.h\"\n");
    add("tests/unit/a.cpp", "#include \"fluid/tested.h\"\n");
    EXPECT_EQ(internal_headers(root()),
              Faults{"engine/fluid/own.h:1: only its own folder includes it; move it to detail/"});
}

TEST_F(Rules, FilesOpenedAroundTheRuleAreFound) {
    add("engine/core/file.cpp", "int fd = ::open(name, 0);\n");
    add("engine/audio/good.cpp",
        "#include <fstream>\n// fopen(name)\nauto a = Device::open(name);\nread_text_file(name, 9);\n");
    add("tests/unit/free.cpp", "std::ifstream in(name);\n");
    EXPECT_EQ(opens_around_the_rule(root()), Faults{});
    for (const auto* line :
         {"int fd = ::open(name, 0);", "if (::open(name, 0) < 0)", "auto* f = fopen(name, \"r\");",
          "auto* f = std::fopen(name, \"r\");", "std::ifstream in(name);", "std::ofstream out{name};",
          "std::fstream(name) >> word;", "luaL_loadfilex(lua, name, 0);", "read_own_text_file(name, 9);",
          "const char* home = std::getenv(\"HOME\");"}) {
        add("engine/audio/bad.cpp", std::string("// one\n") + line + "\n");
        const auto faults = opens_around_the_rule(root());
        ASSERT_EQ(faults.size(), 1) << line;
        EXPECT_TRUE(faults[0].starts_with("engine/audio/bad.cpp:2: ")) << line;
    }
}

TEST_F(Rules, LongFilesAreFound) {
    std::string lines;
    for (int i = 0; i < 600; ++i) lines += "int a;\n";
    add("engine/core/full.cpp", lines);
    add("tests/unit/long.h", lines + "int b;\n");
    add("assets/long.toml", lines + lines);
    EXPECT_EQ(long_files(root()),
              Faults{"tests/unit/long.h:1: the file has 601 lines, more than 600; split it "
                     "where its subject changes"});
}

TEST_F(Rules, LongCommentsAreFoundButTablesAreNot) {
    const std::string words(106, 'w');
    add("engine/core/words.h",
        "int a;\n/// " + words + "w\n///     " + words + "\n// | " + words + "\n// " + words + "\n");
    EXPECT_EQ(long_comments(root()),
              Faults{"engine/core/words.h:2: the comment is longer than 110 characters"});
}

TEST_F(Rules, NamesOutsideTheNamespaceOfTheirRoomAreFound) {
    add("game/bots/right.h",
        "namespace thaum::game::inline data {\nstruct A;\n}\nnamespace thaum::game::inline bots {\n}\n");
    add("game/bots/wrong.h", "namespace thaum::game {\n}\n");
    add("game/data/traits.h", "namespace thaum::haptics {\n}\n");
    EXPECT_EQ(wrong_namespaces(root()),
              Faults{"game/bots/wrong.h:1: names stand in namespace thaum::game::inline bots"});
}

}  // namespace
}  // namespace thaum::structure

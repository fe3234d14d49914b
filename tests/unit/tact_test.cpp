// Tests of .tact files, the effects of bHaptics' designer: what is read and what is refused. Reading what the
// designer would write for a clip must give that clip.
#include "tactile/detail/tact.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "unit/message_of.h"
#include "unit/tact_writer.h"
#include "unit/tactile_rig.h"

namespace thaum::tactile {
namespace {

Clip random_clip(Random& random, std::size_t frames) {
    Clip clip{"a clip \"with\" \xc3\xa9", {}};
    clip.frames.resize(frames);
    for (auto& frame : clip.frames) {
        if (random.below(3) == 0) continue;  // leaves some frames silent
        for (auto& s : frame.strength)
            s = random.below(2) == 0 ? 0 : static_cast<std::uint8_t>(random.below(101));
    }
    clip.frames[frames / 2].strength[3] = 100;
    return clip;
}

std::string fault_of(const std::string& json) { return message_of(import_tact(json)); }

Clip clip_in(const std::string& json) {
    const auto imported = import_tact(json);
    EXPECT_TRUE(imported.has_value()) << (imported ? "" : imported.error().message);
    return imported ? imported->clip : Clip{};
}

/// A .tact file with one effect of 100 ms for the front of a vest.
std::string file_with(const std::string& mode, const std::string& extra = "") {
    return R"({"project":{"name":"p","tracks":[{"enable":true,"effects":[{"startTime":0,"offsetTime":100,"modes":{)"
           R"("VestFront":)" +
           mode + "}}]}]}" + extra + "}";
}

std::string dots(const std::string& steps, bool connected = false) {
    return std::string(R"({"mode":"DOT_MODE","dotMode":{"dotConnected":)") + (connected ? "true" : "false") +
           R"(,"feedback":[)" + steps + "]}}";
}

std::vector<int> course_of(const Clip& clip, std::size_t cell) {
    std::vector<int> course;
    for (const auto& frame : clip.frames) course.push_back(frame.strength[cell]);
    return course;
}

TEST(Tact, AWrittenClipIsReadAsItIs) {
    Random random = random_stream(7, 1);
    for (int round = 0; round < 50; ++round) {
        const auto clip = random_clip(random, 1 + random.below(round == 0 ? 3000 : 60));
        const auto json = tact_of(clip);
        const auto imported = import_tact(json).value();
        EXPECT_EQ(imported.clip, clip);
        EXPECT_EQ(imported.clipped, 0U);
        EXPECT_EQ(imported.skipped, 0U);
        EXPECT_EQ(tact_of(imported.clip), json);
        // Some programs that play the file read only the frames of `feedback`, so without tracks the clip
        // must be the same.
        auto half = nlohmann::json::parse(json);
        half["project"]["tracks"].clear();
        auto baked = clip_in(half.dump());
        baked.frames.resize(clip.frames.size());
        EXPECT_EQ(baked, clip);
    }
}

TEST(Tact, TheShippedClipIsRead) {
    const auto bank = shipped_effects();
    const auto& death = bank.effects[*bank.find("death")];
    ASSERT_EQ(death.clip.size(), 30U);
    EXPECT_EQ(death.duration_ms(), 600);
    EXPECT_EQ(death.clip[0].strength[1], 100);
    EXPECT_EQ(death.clip[0].strength[17], 0);
    EXPECT_GT(death.clip[15].strength[37], 30);
}

TEST(Tact, DotsFadeByTheirPlaybackType) {
    const auto step = [](const std::string& type) {
        return file_with(dots(R"({"startTime":0,"endTime":100,"playbackType":")" + type +
                              R"(","pointList":[{"index":7,"intensity":"0.800"}]})"));
    };
    EXPECT_EQ(course_of(clip_in(step("NONE")), 7), (std::vector<int>{80, 80, 80, 80, 80}));
    EXPECT_EQ(course_of(clip_in(step("FADE_IN")), 7), (std::vector<int>{0, 16, 32, 48, 64}));
    EXPECT_EQ(course_of(clip_in(step("FADE_OUT")), 7), (std::vector<int>{80, 64, 48, 32, 16}));
    EXPECT_EQ(course_of(clip_in(step("FADE_IN_OUT")), 7), (std::vector<int>{0, 32, 64, 64, 32}));
}

TEST(Tact, ConnectedDotsFadeIntoTheNextStep) {
    const auto clip =
        clip_in(file_with(dots(R"({"startTime":0,"endTime":100,"pointList":[{"index":2,"intensity":"1.000"}]},
        {"startTime":100,"endTime":100,"pointList":[{"index":5,"intensity":0.5}]})",
                               true)));
    EXPECT_EQ(course_of(clip, 2), (std::vector<int>{100, 80, 60, 40, 20, 0}));
    EXPECT_EQ(course_of(clip, 5), (std::vector<int>{0, 10, 20, 30, 40, 50}));
}

TEST(Tact, APointOnAPathIsFeltBetweenTheCells) {
    const std::string path = R"({"mode":"PATH_MODE","pathMode":{"feedback":[{"playbackType":"NONE",
        "movingPattern":"CONST_SPEED","pointList":[{"x":"0.100","y":"0.300","intensity":"1.000","time":0},
        {"x":"0.900","y":"0.700","intensity":"1.000","time":90}]}]}})";
    const auto clip = clip_in(file_with(path));
    ASSERT_EQ(clip.frames.size(), 5U);
    for (std::size_t f = 0; f < 5; ++f) {
        double energy = 0, x = 0, y = 0;
        for (std::size_t i = 0; i < clip_side; ++i) {
            const double e = clip.frames[f].strength[i] * clip.frames[f].strength[i];
            const std::size_t column = i % 4, row = i / 4;
            energy += e;
            x += e * static_cast<double>(column) / 3;
            y += e * static_cast<double>(row) / 4;
        }
        EXPECT_NEAR(x / energy, 0.1 + 0.8 * static_cast<double>(f) / 5, 0.01) << f;
        EXPECT_NEAR(y / energy, 0.3 + 0.4 * static_cast<double>(f) / 5, 0.01) << f;
        EXPECT_NEAR(std::sqrt(energy), 100, 1.5) << f;
    }
}

TEST(Tact, PathsWithTimesMoveByThem) {
    const auto path = [](const std::string& pattern) {
        return file_with(
            R"({"mode":"PATH_MODE","pathMode":{"feedback":[{"movingPattern":")" + pattern +
            R"(","pointList":[{"x":0,"y":0,"time":0},{"x":0.3333333333,"y":0,"time":80},{"x":1,"y":0,"time":100}]}]}})");
    };
    EXPECT_LT(course_of(clip_in(path("CONST_TDM")), 1)[1], 60) << "slow on the first part";
    EXPECT_GT(course_of(clip_in(path("CONST_SPEED")), 1)[1], 70);
}

TEST(Tact, ForeignPartsAreSkippedAndWrongValuesClipped) {
    const auto imported =
        import_tact(
            R"({"project":{"tracks":[{"effects":[{"startTime":0,"offsetTime":20,"modes":{"ForearmL":{},"VestBack":)" +
            dots(
                R"({"startTime":0,"endTime":20,"pointList":[{"index":25,"intensity":"7"},{"index":-1,"intensity":"loud"},
             {"index":3,"intensity":1e300}]})") +
            R"(}},{"modes":7}]},{"enable":false,"effects":[{"modes":{"VestBack":{}}}]}]}})")
            .value();
    EXPECT_EQ(imported.clip.frames.size(), 1U);
    EXPECT_EQ(imported.clip.frames[0].strength[39], 100);
    EXPECT_EQ(imported.clip.frames[0].strength[20], 100) << "a strength that is no number counts as full";
    EXPECT_EQ(imported.clip.frames[0].strength[23], 100);
    EXPECT_EQ(imported.clipped, 4U);
    EXPECT_EQ(imported.skipped, 3U);
}

TEST(Tact, FramesAreReadWhereTheTracksHaveNothing) {
    const auto clip = clip_in(file_with(dots(""), R"(,"name":"n","feedback":{"0":[{"position":"VestFront",
        "values":[0,50]}],"40":[{"position":"VestBack","values":[200,"30"]},{"position":"Head","values":[9]}],"x":[]})"));
    ASSERT_EQ(clip.frames.size(), 3U);
    EXPECT_EQ(clip.frames[0].strength[1], 50);
    EXPECT_EQ(clip.frames[2].strength[20], 100);
    EXPECT_EQ(clip.frames[2].strength[21], 30);
    EXPECT_EQ(clip.name, "p");
}

TEST(Tact, WhatIsNoEffectIsRefusedInOneLine) {
    EXPECT_EQ(fault_of("{\n \"project\": x}"), "the file is not JSON from byte 15 on, in line 2, column 13");
    EXPECT_EQ(fault_of("[]"), "the file is not a JSON object");
    EXPECT_NE(fault_of("{\"project\":").find("it ends before all brackets"), std::string::npos);
    EXPECT_EQ(fault_of("{}"), "the file has nothing for the vest (VestFront or VestBack)");
    EXPECT_EQ(fault_of(std::string(100'000, '[')), "the file is nested deeper than 32 levels");
    EXPECT_EQ(fault_of(std::string(5U << 20U, ' ')), "the file has more than 4 MiB");
    EXPECT_EQ(fault_of(file_with(dots(R"({"startTime":0,"endTime":90000,"pointList":[{"index":1}]})"))), "")
        << "a length beyond the limit is clipped";
    EXPECT_EQ(fault_of(R"({"feedback":{"99999":[{"position":"VestFront","values":[9]}]}})"),
              "the effect is longer than a minute");
}

TEST(Tact, AFileCannotMakeUsDrawForever) {
    std::string steps = R"({"startTime":0,"endTime":60000,"pointList":[{"index":1}]})";
    const std::string one = "," + steps;
    for (int i = 0; i < 10'000; ++i) steps += one;
    EXPECT_EQ(fault_of(file_with(dots(steps))), "the file has more to draw than an effect can need");
}

TEST(TactClip, PlaysOnEveryLayoutAndExactlyOnAJacket) {
    for (const auto* name : layout_names) {
        TactileRig rig(name);
        const auto& clip = rig.bank.effects[rig.effect("death")].clip;
        rig.start("death", Where::own());
        std::vector<Tick> lit;
        for (int f = 0; f < 90; ++f) {
            const auto& frame = rig.frame();
            if (!frame.is_silent()) lit.push_back(frame.tick);
            EXPECT_LE(energy_of(frame), 1.5);
            if (name != std::string("x40") || f != 60) continue;
            // The mixer's limit on the energy of all motors together is not reached, so each motor has the
            // strength of its cell.
            for (std::size_t i = 0; i < 40; ++i) {
                // A frame of the motor's signal, from 472 to 480 ms, lies in two frames of the clip.
                const int strength = std::max(clip[23].strength[i], clip[24].strength[i]);
                EXPECT_NEAR(frame.amplitude[i], 0.9 * strength / 100, 1e-6) << i;
            }
        }
        ASSERT_FALSE(lit.empty()) << name;
        EXPECT_EQ(lit.front(), 1000U);
        EXPECT_GT(lit.back(), 1450U);
    }
}

}  // namespace
}  // namespace thaum::tactile

// Tests of files of strokes, sessions, labels and gestures: what is read, and how faults are reported.
#include <gtest/gtest.h>

#include "gesture/gesture_file.h"
#include "gesture/stroke_csv.h"
#include "gesture/stroke_recorder.h"
#include "unit/gesture_shapes.h"
#include "unit/message_of.h"

namespace thaum::gesture {
namespace {

TEST(GestureCsv, StrokesAreRowsOfEqualUserGestureAndSample) {
    const auto set =
        read_strokes(
            "user,gesture,sample,t,x,y,z,force\n1,o,0,0,1,2,3,4\n1,v,0,0,5,6,7,8\n1,o,0,0.5,9,9,9,9\n", "f")
            .value();
    ASSERT_EQ(set.strokes.size(), 2U);
    EXPECT_EQ(set.strokes[0].gesture, "o");
    ASSERT_EQ(set.strokes[0].points.size(), 2U);
    EXPECT_EQ(set.strokes[0].points[0].at, vec3(1, 2, 3));
    EXPECT_EQ(set.strokes[0].points[1].t, 0.5);
    EXPECT_EQ(set.strokes[1].points[0].force, 8);
    EXPECT_TRUE(set.has_depth && set.has_force);
}

TEST(GestureCsv, ColumnsMayStandInAnyOrderAndForceMayBeMissing) {
    const auto set =
        read_strokes("y,x,extra,sample,t,gesture,user\r\n2,1,?,a,0,o,me\r\n\r\n4,3,?,a,1,o,me\r\n", "f")
            .value();
    EXPECT_EQ(set.strokes[0].points[1].at, vec3(3, 4, 0));
    EXPECT_FALSE(set.has_depth);
    EXPECT_FALSE(set.has_force);
}

TEST(GestureCsv, TextOfStrokesReadsBackToTheSame) {
    const std::vector<Stroke> strokes{{"u", "g", "1", ess()}, {"u", "g", "2", circle()}};
    const auto set = read_strokes(to_csv(strokes), "f").value();
    ASSERT_EQ(set.strokes.size(), 2U);
    for (std::size_t i = 0; i < 100; ++i) {
        EXPECT_EQ(set.strokes[1].points[i].at, strokes[1].points[i].at);
        EXPECT_EQ(set.strokes[1].points[i].t, strokes[1].points[i].t);
    }
}

TEST(GestureCsv, NamesMayHoldWhatSeparatesCells) {
    const std::vector<Stroke> strokes{{"Doe, Jane", "\"o\"", " 1", ess()}};
    const auto set = read_strokes(to_csv(strokes), "f").value();
    EXPECT_EQ(set.strokes[0].user, strokes[0].user);
    EXPECT_EQ(set.strokes[0].gesture, strokes[0].gesture);
    EXPECT_EQ(set.strokes[0].sample, strokes[0].sample);
}

std::string fault_of(std::string_view csv) { return message_of(read_strokes(csv, "file.csv"), "none"); }

TEST(GestureCsv, FaultsNameFileAndLine) {
    const std::string title = "user,gesture,sample,t,x,y\n";
    EXPECT_EQ(fault_of(""), "file.csv:1: the file is empty");
    EXPECT_EQ(fault_of(title), "file.csv:1: no stroke");
    EXPECT_EQ(fault_of("user,gesture,sample,t,x\n"),
              "file.csv:1: no column 'y'; there are: user, gesture, sample, t, x");
    EXPECT_EQ(fault_of(title + "1,o,0,0,1\n"), "file.csv:2: the number of cells is 5, that of titles 6");
    EXPECT_EQ(fault_of(title + "1,o,0,0,1,nan\n"),
              "file.csv:2: 'nan' in the column 'y' is not a finite number");
    EXPECT_EQ(fault_of(title + "1,o,0,0,1,1e999\n"),
              "file.csv:2: '1e999' in the column 'y' is not a finite number");
    EXPECT_EQ(fault_of(title + "1,o,0,0,1,two\n"),
              "file.csv:2: 'two' in the column 'y' is not a finite number");
    EXPECT_EQ(fault_of(title + "1,o,0,1,1,1\n1,o,0,0.5,1,1\n"),
              "file.csv:3: time runs backwards, from 1 to 0.5 s");
    EXPECT_EQ(fault_of(title + "1,,0,0,1,1\n"), "file.csv:2: a name must have 1 to 200 characters");
}

TEST(GestureCsv, LabelsAndSessionsAreRead) {
    const auto sessions = read_sessions("user,t,x,y\na,0,1,1\nb,0,2,2\na,1,3,3\n", "f").value();
    ASSERT_EQ(sessions.sessions.size(), 2U);
    EXPECT_EQ(sessions.sessions[0].points.size(), 2U);
    const auto labels = read_labels("user,gesture,t_start,t_end\na,o,0.25,1\n", "f").value();
    EXPECT_EQ(labels[0].start, 0.25);
    EXPECT_FALSE(read_labels("user,gesture,t_start,t_end\na,o,2,1\n", "f"));
}

TEST(GestureFile, ReadsBackToTheSameBits) {
    Gesture gesture = gesture_of("swirl \"one\"\n", {circle(0.3, 2), ess()},
                                 {.direction_sensitive = false,
                                  .rotation = 0.5,
                                  .min_scale = 0.25,
                                  .max_scale = 3,
                                  .closed = true,
                                  .planar = true,
                                  .gentle_below = 1,
                                  .harsh_above = 4});
    gesture.strokes[0][3].force = 0.1;
    const auto config = Config::parse(to_file(gesture), "g.toml", gesture_file_version).value();
    const auto read = read_gesture(config).value();
    EXPECT_EQ(read.name, gesture.name);
    EXPECT_NEAR(read.options.rotation, 0.5, 1e-15);
    EXPECT_EQ(read.options.closed, true);
    EXPECT_EQ(read.options.harsh_above, 4);
    ASSERT_EQ(read.strokes.size(), 2U);
    for (std::size_t i = 0; i < 100; ++i) {
        EXPECT_EQ(read.strokes[0][i].at, gesture.strokes[0][i].at);
        EXPECT_EQ(read.strokes[0][i].force, gesture.strokes[0][i].force);
    }
}

TEST(StrokeRecorder, CutsStrokesWhileTheButtonIsDown) {
    StrokeRecorder recorder;
    const auto hold = [&](double from, double to, bool down) {
        for (double t = from; t < to; t += 0.001) recorder.feed({t, {t, 0, 0}, 1}, down);
    };
    hold(0, 0.2, false);
    hold(0.2, 0.7, true);
    hold(0.7, 0.8, false);
    hold(0.8, 0.85, true);  // a press that is too short for a stroke
    hold(0.85, 1, false);
    hold(1, 1.3, true);
    recorder.end();
    ASSERT_EQ(recorder.strokes().size(), 2U);
    EXPECT_EQ(recorder.strokes()[0].front().t, 0);
    EXPECT_NEAR(recorder.strokes()[0].back().t, 0.5, 0.003);
    EXPECT_NEAR(recorder.strokes()[0].back().at.x, 0.7, 0.003);
    EXPECT_NEAR(recorder.strokes()[1].back().t, 0.3, 0.003);
}

std::string gesture_fault(const std::string& stroke) {
    const auto config = Config::parse("version = 1\nname = \"g\"\n[[stroke]]\n" + stroke, "g.toml", 1);
    if (!config) return config.error().message;
    return message_of(read_gesture(*config), "none");
}

TEST(GestureFile, FaultsNameTheColumn) {
    EXPECT_EQ(gesture_fault("t = [0, 1]\nx = [0, 1]\ny = [0, 1]\n"), "none");
    EXPECT_NE(gesture_fault("t = [0, 1]\nx = [0]\ny = [0, 1]\n").find("1 numbers instead of 2"),
              std::string::npos);
    EXPECT_NE(gesture_fault("t = [1, 0]\nx = [0, 1]\ny = [0, 1]\n").find("backwards"), std::string::npos);
    EXPECT_NE(gesture_fault("t = [0]\nx = [0]\ny = [0]\n").find("two points"), std::string::npos);
    EXPECT_NE(gesture_fault("t = [0, nan]\nx = [0, 1]\ny = [0, 1]\n"), "none");
}

}  // namespace
}  // namespace thaum::gesture

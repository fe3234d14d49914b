// Tests of the recorder of what a player feels: its rows, the names of its files, and a full disk.
#include "game/jackets/makers/recorder.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <fstream>
#include <thread>

#include "core/file.h"
#include "core/text.h"
#include "game/jackets/felt_rows.h"
#include "game/live/tactile.h"
#include "unit/jacket_rig.h"
#include "unit/message_of.h"

namespace thaum::game {
namespace {

using input::rig::jacket_frame;

std::string read(const std::filesystem::path& file) { return read_text_file(file, 1U << 20U).value(); }

tactile::TactileFrame frame_at(Tick tick) {
    auto frame = jacket_frame(40, {{0, 0.5F}, {39, 1.0F}});
    frame.tick = tick;
    return frame;
}

std::string row_of(Tick tick, int player) {
    std::string row = text(tick, ",", player, ",0.5000");
    for (int i = 1; i < 39; ++i) row += ",0.0000";
    return row + ",1.0000\n";
}

TEST(FeltRecorder, WritesTheTableOfAReplay) {
    const TemporaryFolder folder;
    const auto file = folder.path() / "felt.csv";
    const auto recorder = felt_recorder(file, 1);
    ASSERT_TRUE(recorder->open());
    recorder->write(frame_at(8), 1);
    recorder->silence();
    recorder->write(frame_at(32), 2);
    EXPECT_TRUE(recorder->is_connected());
    EXPECT_EQ(std::filesystem::file_size(file), 0U)
        << "a file takes its name at once, and is empty or complete";
    recorder->close();
    EXPECT_EQ(read(file), felt_header() + row_of(8, 2) + row_of(32, 2));
    EXPECT_EQ(felt_header().find("tick,player,front_1_1,front_1_2,"), 0U);
}

TEST(FeltRecorder, NoFileIsEverReplaced) {
    const TemporaryFolder folder;
    const auto file = folder.path() / "felt.csv";
    std::ofstream(file) << "mine\n";
    std::filesystem::create_symlink("nowhere", folder.path() / "felt_2.csv");
    for (int i = 0; i < 2; ++i) {
        const auto recorder = felt_recorder(file, 0);
        ASSERT_TRUE(recorder->open());
        recorder->write(frame_at(8 * static_cast<Tick>(i)), 0);
    }
    EXPECT_EQ(read(file), "mine\n");
    EXPECT_EQ(read(folder.path() / "felt_3.csv"), felt_header() + row_of(0, 1));
    EXPECT_EQ(read(folder.path() / "felt_4.csv"), felt_header() + row_of(8, 1));
}

TEST(FeltRecorder, TwoAtOnceWriteTwoFiles) {
    const TemporaryFolder folder;
    const auto first = felt_recorder(folder.path() / "felt.csv", 0);
    const auto second = felt_recorder(folder.path() / "felt.csv", 1);
    ASSERT_TRUE(first->open());
    ASSERT_TRUE(second->open());
    EXPECT_TRUE(second->name().ends_with("/felt_2.csv")) << second->name();
    first->write(frame_at(8), 0);
    second->write(frame_at(16), 0);
    first->close();
    second->close();
    EXPECT_EQ(read(folder.path() / "felt.csv"), felt_header() + row_of(8, 1));
    EXPECT_EQ(read(folder.path() / "felt_2.csv"), felt_header() + row_of(16, 2));
}

TEST(FeltRecorder, AFolderThatIsMissingIsToldInOneLine) {
    const auto recorder = felt_recorder("/no/such/folder/felt.csv", 0);
    const auto message = message_of(recorder->open());
    EXPECT_NE(message.find("/no/such/folder/felt.csv: cannot create: "), std::string::npos) << message;
    recorder->write(frame_at(0), 0);
    recorder->close();
    EXPECT_EQ(recorder->name(), "recording of what is felt, /no/such/folder/felt.csv");
}

TEST(FeltRecorder, AFullDiskIsToldOnceAndLeavesNoFile) {
    const TemporaryFolder folder;
    rlimit before{};
    ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    rlimit limited = before;
    limited.rlim_cur = 10'000;
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &limited), 0);
    const auto recorder = felt_recorder(folder.path() / "felt.csv", 0);
    EXPECT_TRUE(recorder->open());
    int rows = 0;
    while (recorder->is_connected() && rows < 10'000)
        recorder->write(frame_at(8 * static_cast<Tick>(rows++)), 0);
    const auto fault = recorder->fault();
    recorder->close();
    ::setrlimit(RLIMIT_FSIZE, &before);
    std::signal(SIGXFSZ, handler);
    EXPECT_LT(rows, 1000) << "noticed while the match goes on";
    EXPECT_EQ(fault, "it cannot be written, such as on a full disk; nothing is kept");
    EXPECT_EQ(recorder->open().error().message, fault) << "it is not tried again";
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(FeltRecorder, EveryFrameIsWrittenInASession) {
    const TemporaryFolder folder;
    const auto file = folder.path() / "felt.csv";
    Settings settings;
    settings.players[1].jacket = "record:" + file.string();
    constexpr Tick frames = 400;
    std::string wanted = felt_header();
    {
        LiveTactile tactile([](const input::PadState&) { return nullptr; });
        tactile.apply(settings);
        while (tactile.jacket_layout(1) != "abstract_4x5") std::this_thread::yield();
        for (Tick i = 0; i < frames; ++i) {
            // The recorder's queue holds 32 frames, so at most 16 may wait before the next one is sent.
            while (tactile.jacket_report(1).frames_sent + 16 < i) std::this_thread::yield();
            auto frame = frame_at(8 * i);
            if (i % 5 == 0) frame.amplitude.fill(0);
            tactile.feel_jacket(1, frame);
            if (i % 5 != 0) wanted += row_of(8 * i, 2);
        }
        while (tactile.jacket_report(1).frames_sent < frames) std::this_thread::yield();
    }
    EXPECT_EQ(read(file), wanted);
}

}  // namespace
}  // namespace thaum::game

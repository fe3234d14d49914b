// Tests of reading a log from any tick on.
#include <gtest/gtest.h>

#include "unit/input_log_samples.h"

namespace thaum::input {
namespace {

using samples::Folder;

TEST(InputLog, SeekingReadsOnFromAnyTickForwardsAndBack) {
    const Folder folder;
    constexpr Tick length = 5000;
    auto writer = LogWriter::create(folder / "log", samples::header()).value();
    const auto frame_at = [](Tick t) { return samples::random_frame(t, 2); };
    samples::record(writer, length, frame_at);
    ASSERT_TRUE(writer.close("draw"));
    auto reader = LogReader::open(folder / "log").value();
    InputFrame frame;
    for (const Tick to : {4999U, 0U, 512U, 511U, 513U, 2048U, 3U, 4608U, 1U, 4607U}) {
        reader.seek(to);
        for (Tick t = to; t < std::min<Tick>(to + 600, length); ++t) {
            ASSERT_TRUE(reader.next(frame));
            ASSERT_EQ(frame, frame_at(t)) << "tick " << t << " after seeking " << to;
        }
    }
    for (const Tick beyond : {length, length + 1, length + 5000}) {
        reader.seek(beyond);
        EXPECT_FALSE(reader.next(frame)) << beyond;
    }
    reader.seek(4000);
    EXPECT_TRUE(reader.next(frame)) << "the end is no end of seeking";
    EXPECT_TRUE(reader.ended_cleanly());
}

TEST(InputLog, ChangedBeforeSeekingIsDamage) {
    const Folder folder;
    auto writer = LogWriter::create(folder / "log", samples::header()).value();
    samples::record(writer, 5000, samples::calm_frame);
    ASSERT_TRUE(writer.close("draw"));
    auto reader = LogReader::open(folder / "log").value();
    std::filesystem::resize_file(folder / "log", std::filesystem::file_size(folder / "log") / 2);
    reader.seek(4900);
    InputFrame frame;
    EXPECT_FALSE(reader.next(frame));
    EXPECT_EQ(reader.ending(), LogEnding::damaged);
    reader.seek(10);
    EXPECT_TRUE(reader.next(frame));
    EXPECT_EQ(frame, samples::calm_frame(10));
}

}  // namespace
}  // namespace thaum::input

#include "input/log.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <zstd.h>

#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <thread>

#include "core/sanitizers.h"
#include "unit/allocations.h"
#include "unit/input_log_samples.h"
#include "unit/message_of.h"

namespace thaum::input {
namespace {

using samples::blocks_of;
using samples::contains;
using samples::Folder;

/// Reads all frames of a log that can be read and compares them with the recorded ones.
template <class Frame>
void expect_frames(LogReader& reader, Frame frame_at) {
    InputFrame frame;
    for (Tick t = 0; t < reader.ticks(); ++t) {
        ASSERT_TRUE(reader.next(frame)) << t;
        ASSERT_EQ(frame, frame_at(t)) << t;
    }
    EXPECT_FALSE(reader.next(frame));
}

bool one_line(const std::string& s) { return !s.empty() && s.find('\n') == std::string::npos; }

std::string open_error(const std::filesystem::path& path) {
    const auto reader = LogReader::open(path);
    if (reader) return "no error";
    EXPECT_TRUE(one_line(reader.error().message)) << reader.error().message;
    EXPECT_NE(reader.error().message.find(path.filename().string()), std::string::npos);
    return reader.error().message;
}

TEST(InputLog, RoundTripOfRandomFrames) {
    const Folder folder;
    for (const std::size_t devices : {0U, 1U, 2U, 4U}) {
        for (const Tick count : {Tick{0}, Tick{1}, Tick{511}, Tick{512}, Tick{513}, Tick{2049}}) {
            const auto path = folder / text(devices, "-", count);
            const auto frame_at = [&](Tick t) { return samples::random_frame(t, devices); };
            auto writer = LogWriter::create(path, samples::header(devices)).value();
            samples::record(writer, count, frame_at);
            ASSERT_TRUE(writer.close("draw"));
            EXPECT_EQ(writer.ticks_on_disk(), count);

            auto reader = LogReader::open(path).value();
            EXPECT_EQ(reader.header(), samples::header(devices));
            EXPECT_EQ(reader.ticks(), count);
            EXPECT_TRUE(reader.ended_cleanly()) << reader.ending_reason();
            EXPECT_EQ(reader.result(), "draw");
            expect_frames(reader, frame_at);
            reader.seek(0);
            expect_frames(reader, frame_at);
        }
    }
}

TEST(InputLog, HashesAndMarks) {
    const Folder folder;
    auto writer = LogWriter::create(folder / "log", samples::header()).value();
    writer.append_hash(0, 10, 20);
    writer.mark(1);
    samples::record(writer, 5000, samples::calm_frame);
    writer.mark(0xffffffffU);
    ASSERT_TRUE(writer.close(""));

    const auto reader = LogReader::open(folder / "log").value();
    EXPECT_EQ(reader.hash_at(0), (HashRecord{0, 10, 20}));
    for (Tick t = 128; t <= 5000; t += 128) EXPECT_EQ(reader.hash_at(t), samples::hash_of(t));
    EXPECT_EQ(reader.hash_at(129), std::nullopt);
    EXPECT_EQ(reader.hash_at(5120), std::nullopt);
    EXPECT_EQ(reader.hashes().size(), 40U);
    const std::vector<Mark> marks{{0, MarkKind::user, 1},
                                  {2048, MarkKind::keyframe, 0},
                                  {4096, MarkKind::keyframe, 0},
                                  {5000, MarkKind::user, 0xffffffffU}};
    EXPECT_EQ(reader.marks(), marks);
}

TEST(InputLog, MoreMarksThanABlockHoldsAreDropped) {
    const Folder folder;
    auto writer = LogWriter::create(folder / "log", samples::header()).value();
    for (std::uint32_t i = 0; i < 1000; ++i) writer.mark(i);
    writer.append({});
    ASSERT_TRUE(writer.close(std::string(10000, 'x')));
    const auto reader = LogReader::open(folder / "log").value();
    EXPECT_EQ(reader.marks().size(), detail::block_marks);
    EXPECT_EQ(reader.result().size(), detail::result_limit);
}

TEST(InputLog, WithoutCloseAllIsKeptButCutOff) {
    const Folder folder;
    samples::record(
        *std::make_unique<LogWriter>(LogWriter::create(folder / "log", samples::header()).value()), 700,
        samples::calm_frame);
    auto reader = LogReader::open(folder / "log").value();
    EXPECT_EQ(reader.ticks(), 700U);
    EXPECT_EQ(reader.ending(), LogEnding::cut_off);
    EXPECT_TRUE(contains(reader.ending_reason(), "cut off after tick 700")) << reader.ending_reason();
    expect_frames(reader, samples::calm_frame);
}

TEST(InputLog, SamePathIsRefused) {
    const Folder folder;
    auto first = LogWriter::create(folder / "log", samples::header()).value();
    const auto message = message_of(LogWriter::create(folder / "log", samples::header()));
    EXPECT_TRUE(contains(message, "exists")) << message;
    samples::record(first, 100, samples::calm_frame);
    EXPECT_TRUE(first.close("done"));
    EXPECT_EQ(LogReader::open(folder / "log").value().ticks(), 100U);
    EXPECT_FALSE(LogWriter::create(folder / "missing/log", samples::header()));
}

TEST(InputLog, IsInUseUntilItIsClosed) {
    const Folder folder;
    EXPECT_FALSE(log_in_use(folder / "log"));
    {
        auto writer = LogWriter::create(folder / "log", samples::header()).value();
        EXPECT_TRUE(log_in_use(folder / "log"));
        EXPECT_TRUE(LogReader::open(folder / "log").has_value()) << "may be read meanwhile";
    }
    EXPECT_FALSE(log_in_use(folder / "log"));
}

TEST(InputLog, HeaderBeyondTheLimitsIsRefused) {
    const Folder folder;
    const auto refused = [&](auto change) {
        auto header = samples::header();
        change(header);
        const auto writer = LogWriter::create(folder / "log", header);
        EXPECT_FALSE(std::filesystem::exists(folder / "log"));
        return !writer && one_line(writer.error().message);
    };
    EXPECT_TRUE(refused([](LogHeader& h) { h.files.resize(1001); }));
    EXPECT_TRUE(refused([](LogHeader& h) { h.devices.resize(5); }));
    EXPECT_TRUE(refused([](LogHeader& h) { h.arena.resize(65537); }));
    EXPECT_TRUE(refused([](LogHeader& h) { h.overrides.assign(300, std::string(60000, 'x')); }));
    EXPECT_TRUE(refused([](LogHeader& h) { h.devices[0].player = 2; }));
    EXPECT_TRUE(refused([](LogHeader& h) { h.devices[0].turn_rad_per_s = NAN; }));
    EXPECT_TRUE(refused([](LogHeader& h) { h.devices[0].force_percent = 101; }));
    EXPECT_TRUE(refused([](LogHeader& h) { h.devices[0].weight_reduction = 101; }));
    EXPECT_TRUE(refused([](LogHeader& h) { h.devices[0].blow_reduction = 255; }));
    EXPECT_TRUE(refused([](LogHeader& h) { h.devices[0].fluid_reduction[6] = 101; }));
    EXPECT_TRUE(refused([](LogHeader& h) { h.devices[0].fluid_reduction[0] = 255; }));
    EXPECT_TRUE(refused([](LogHeader& h) { h.devices[0].aim_assist = 101; }));
    EXPECT_TRUE(refused([](LogHeader& h) { h.devices[0].recoil_reduction = 101; }));
    EXPECT_TRUE(refused([](LogHeader& h) { h.devices[0].roughness_reduction = 255; }));
    EXPECT_TRUE(refused([](LogHeader& h) { h.devices[0].box_um[2] = DeviceSpec::max_box_um + 1; }));
    EXPECT_TRUE(refused([](LogHeader& h) { h.kinds.resize(17); }));
    EXPECT_TRUE(refused([](LogHeader& h) { std::swap(h.kinds[0], h.kinds[1]); }));
    EXPECT_TRUE(refused([](LogHeader& h) { h.kinds[1].group = h.kinds[0].group; }));
    EXPECT_TRUE(refused([](LogHeader& h) { h.kinds[0].kinds[1].number = 0; }));
    EXPECT_TRUE(refused([](LogHeader& h) { h.kinds[0].kinds[1].name.resize(65537); }));
    EXPECT_TRUE(refused([](LogHeader& h) { h.profile.resize(1001); }));
    EXPECT_TRUE(refused([](LogHeader& h) { h.profile[1].player = 2; }));
    EXPECT_TRUE(refused([](LogHeader& h) { h.profile[1] = h.profile[0]; }));
    EXPECT_TRUE(refused([](LogHeader& h) { h.profile[1].bytes.resize((16U << 20U) + 1); }));
    EXPECT_TRUE(refused([](LogHeader& h) { h.profile[1].bytes.resize(16U << 20U); }))
        << "no room for the rest";
}

TEST(InputLog, OtherFilesAreRefusedInOneLine) {
    const Folder folder;
    const auto path = folder / "file";
    EXPECT_TRUE(contains(open_error(path), "No such file"));
    ASSERT_TRUE(write_text_file(path, ""));
    EXPECT_TRUE(contains(open_error(path), "empty"));
    ASSERT_TRUE(write_text_file(path, "THAUMLO"));
    EXPECT_TRUE(contains(open_error(path), "not a Thaum log"));
    ASSERT_TRUE(write_text_file(path, "THAUMLOG"));
    EXPECT_TRUE(contains(open_error(path), "cut off"));
    std::filesystem::remove(path);  // no writer replaces a file that begins like a recording
    ASSERT_TRUE(write_text_file(path, std::string(5000, 'x')));
    EXPECT_TRUE(contains(open_error(path), "not a Thaum log"));
    EXPECT_TRUE(contains(open_error(folder.path()), "not an ordinary file"));
    ASSERT_EQ(::mkfifo((folder / "fifo").c_str(), 0600), 0);
    EXPECT_TRUE(contains(open_error(folder / "fifo"), "not an ordinary file"));
    EXPECT_TRUE(contains(open_error("/dev/zero"), "not an ordinary file"));
}

TEST(InputLog, HugeFileIsRefusedWithoutReadingIt) {
    const Folder folder;
    auto log = samples::small_log(folder);
    ASSERT_TRUE(samples::put_file(folder / "file", log));
    ASSERT_EQ(::truncate((folder / "file").c_str(), off_t{10} << 30U), 0);  // a sparse file
    EXPECT_TRUE(contains(open_error(folder / "file"), "larger than a log"));
}

TEST(InputLog, NewerFormatIsRefused) {
    const Folder folder;
    auto log = samples::small_log(folder);
    log[8] = std::byte{3};
    ASSERT_TRUE(samples::put_file(folder / "file", log));
    EXPECT_TRUE(contains(open_error(folder / "file"), "log format 3 is newer"));
    EXPECT_FALSE(read_log_header(folder / "file"));
    log[8] = std::byte{0};
    ASSERT_TRUE(samples::put_file(folder / "file", log));
    EXPECT_TRUE(contains(open_error(folder / "file"), "damaged"));
}

TEST(InputLog, EveryTruncationReadsToItsLastWholeBlock) {
    const Folder folder;
    for (const auto& [log, frame_at] : samples::logs_of_all_formats(folder)) {
        const auto blocks = blocks_of(log);
        ASSERT_EQ(blocks.size(), 4U);
        const samples::Scratch file(folder / text("cut", log.size()));
        ASSERT_TRUE(file.set(log));
        for (std::size_t size = log.size(); size-- > 0;) {
            ASSERT_EQ(::truncate(file.path.c_str(), static_cast<off_t>(size)), 0);
            if (size < blocks[0].begin) {
                ASSERT_NE(open_error(file.path), "no error") << size;
                continue;
            }
            Tick whole = 0;
            for (const auto& block : blocks) whole = block.end <= size ? block.last : whole;
            auto reader = LogReader::open(file.path).value();
            ASSERT_EQ(reader.ending(), LogEnding::cut_off) << size;
            ASSERT_TRUE(one_line(reader.ending_reason()));
            ASSERT_EQ(reader.ticks(), whole) << size;
            expect_frames(reader, frame_at);
        }
    }
}

/// A file as after a power cut: its size is right, but the last pages are zeros.
TEST(InputLog, ATailOfZerosReadsAsCutOff) {
    const Folder folder;
    const auto log = samples::small_log(folder);
    const auto blocks = blocks_of(log);
    const samples::Scratch file(folder / "zeros");
    for (auto from = blocks[0].begin; from + 16 <= log.size(); ++from) {
        auto cut = log;
        std::fill(cut.begin() + static_cast<std::ptrdiff_t>(from), cut.end(), std::byte{});
        ASSERT_TRUE(file.set(cut));
        auto reader = LogReader::open(file.path).value();
        Tick whole = 0;
        for (const auto& block : blocks) whole = block.end <= from ? block.last : whole;
        ASSERT_EQ(reader.ending(), LogEnding::cut_off) << from << reader.ending_reason();
        ASSERT_GE(reader.ticks(), whole) << from;
        ASSERT_LE(reader.ticks(), whole + 512) << from << ": a block may end with zeros of its own";
        if (from % 16 == 0) expect_frames(reader, samples::calm_frame);
    }
    // Megabytes of zeros behind a block, as after a preallocation.
    auto long_tail = Bytes(log.begin(), log.begin() + static_cast<std::ptrdiff_t>(blocks[1].end));
    long_tail.resize(long_tail.size() + (3U << 20U));
    ASSERT_TRUE(file.set(long_tail));
    const auto reader = LogReader::open(file.path).value();
    EXPECT_EQ(reader.ending(), LogEnding::cut_off);
    EXPECT_EQ(reader.ticks(), blocks[1].last);
    // Zeros in the middle mean damage, because something was written after them.
    auto hole = log;
    std::fill_n(hole.begin() + static_cast<std::ptrdiff_t>(blocks[1].begin), 64, std::byte{});
    ASSERT_TRUE(file.set(hole));
    EXPECT_EQ(LogReader::open(file.path)->ending(), LogEnding::damaged);
}

/// Damages a log byte by byte, in three ways each. Every damage must be reported at the block that contains
/// it. Opening a log is slow with the address sanitizer, so there each byte is damaged in only one of the
/// three ways.
void expect_flips_found(const samples::StoredLog& stored, const samples::Scratch& file) {
    constexpr std::array flips{0x01, 0x80, 0xff};
    const auto& log = stored.bytes;
    const auto blocks = blocks_of(log);
    ASSERT_TRUE(file.set(log));
    for (std::size_t at = 0; at < log.size(); ++at) {
        const auto byte = std::span(log).subspan(at, 1);
        for (std::size_t i = 0; i < flips.size(); ++i) {
            if (THAUM_ADDRESS_SANITIZER != 0 && i != at % flips.size()) continue;
            const int flip = flips.at(i);
            const auto flipped = byte[0] ^ static_cast<std::byte>(flip);
            ASSERT_TRUE(file.set_from(at, std::span(&flipped, 1)));
            if (at < blocks[0].begin) {
                ASSERT_NE(open_error(file.path), "no error") << at;
                continue;
            }
            Tick first = 0;
            for (const auto& block : blocks) first = block.begin <= at ? block.first : first;
            auto reader = LogReader::open(file.path).value();
            ASSERT_EQ(reader.ending(), LogEnding::damaged) << at;
            ASSERT_TRUE(contains(reader.ending_reason(), text("tick ", first, ": block damaged"))) << at;
            ASSERT_EQ(reader.ticks(), first) << at;
            if (flip == 0xff) expect_frames(reader, stored.frame_at);
        }
        ASSERT_TRUE(file.set_from(at, byte));
    }
}

TEST(InputLog, EveryFlippedByteIsFound) {
    const Folder folder;
    for (const auto& stored : samples::logs_of_all_formats(folder))
        expect_flips_found(stored, samples::Scratch(folder / text("flipped", stored.bytes.size())));
}

TEST(InputLog, MissingMovedAndForeignBlocksAreDamage) {
    const Folder folder;
    const auto log = samples::small_log(folder);
    const auto blocks = blocks_of(log);
    const auto ending_of = [&](const Bytes& bytes) {
        EXPECT_TRUE(samples::put_file(folder / "file", bytes));
        const auto reader = LogReader::open(folder / "file").value();
        return std::pair(reader.ending(), reader.ticks());
    };
    const auto at = [](Bytes& bytes, std::size_t i) {
        return bytes.begin() + static_cast<std::ptrdiff_t>(i);
    };

    auto missing = log;
    missing.erase(at(missing, blocks[1].begin), at(missing, blocks[1].end));
    EXPECT_EQ(ending_of(missing), std::pair(LogEnding::damaged, Tick{512}));

    auto longer = log;
    longer.push_back(std::byte{0});
    EXPECT_EQ(ending_of(longer), std::pair(LogEnding::damaged, Tick{1100}));

    auto header = samples::header();
    header.seed++;
    {
        auto writer = LogWriter::create(folder / "other", header).value();
        samples::record(writer, 1100, samples::calm_frame);
    }
    auto foreign = samples::bytes_of(folder / "other");
    foreign.resize(blocks_of(foreign)[0].begin);
    foreign.insert(foreign.end(), at(const_cast<Bytes&>(log), blocks[0].begin),
                   const_cast<Bytes&>(log).end());
    EXPECT_EQ(ending_of(foreign), std::pair(LogEnding::damaged, Tick{0}));
}

TEST(InputLog, ChangedAfterOpeningIsDamage) {
    const Folder folder;
    auto log = samples::small_log(folder);
    const auto path = folder / "small.thaumlog";
    auto reader = LogReader::open(path).value();
    InputFrame frame;
    for (int i = 0; i < 512; ++i) ASSERT_TRUE(reader.next(frame));
    ASSERT_EQ(::truncate(path.c_str(), static_cast<off_t>(blocks_of(log)[0].end + 50)), 0);
    EXPECT_FALSE(reader.next(frame));
    EXPECT_FALSE(reader.next(frame));
    EXPECT_EQ(reader.ending(), LogEnding::damaged);
}

/// 100 MiB of zeros packed into a few kilobytes, with a small stated size. Only the stated size is unpacked.
TEST(InputLog, AZipBombIsRefused) {
    const Folder folder;
    const auto log = samples::small_log(folder);
    const auto place = blocks_of(log)[0];
    const Bytes zeros(100U << 20U);
    Bytes packed(ZSTD_compressBound(zeros.size()));
    packed.resize(ZSTD_compress(packed.data(), packed.size(), zeros.data(), zeros.size(), 19));
    for (const std::size_t said : {std::size_t{1000}, detail::raw_limit, zeros.size()}) {
        ASSERT_TRUE(samples::put_file(
            folder / "bomb",
            samples::with_block(log, place, samples::signed_block(log, place.begin, packed, said))));
        const auto reader = LogReader::open(folder / "bomb").value();
        EXPECT_EQ(reader.ending(), LogEnding::damaged);
        EXPECT_EQ(reader.ticks(), 0U);
    }
}

// With a file size limit, `write` fails as with a full disk: part of a block is written, then an error
// follows.
TEST(InputLog, FullDiskKeepsAValidLog) {
    const Folder folder;
    const auto frame_at = [](Tick t) { return samples::random_frame(t, 2); };
    rlimit before{};
    ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
    auto limited = before;
    limited.rlim_cur = 200000;
    auto writer = LogWriter::create(folder / "log", samples::header(), WhenBehind::wait).value();
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &limited), 0);
    samples::record(writer, 20000, frame_at);
    const auto closed = writer.close("never seen");
    ::setrlimit(RLIMIT_FSIZE, &before);

    ASSERT_FALSE(closed);
    auto reader = LogReader::open(folder / "log").value();
    EXPECT_GT(reader.ticks(), 512U);
    EXPECT_EQ(reader.ticks() % 512, 0U);
    EXPECT_EQ(reader.ending(), LogEnding::cut_off);
    EXPECT_TRUE(contains(reader.ending_reason(), "no end block")) << reader.ending_reason();
    EXPECT_TRUE(one_line(closed.error().message));
    EXPECT_TRUE(contains(closed.error().message, text("kept up to tick ", reader.ticks())))
        << closed.error().message;
    EXPECT_EQ(writer.ticks_on_disk(), reader.ticks());
    expect_frames(reader, frame_at);
}

struct Progress {
    std::atomic<Tick> appended{0}, on_disk{0};
};

/// Records a match at about 60 times real time until the process is killed. Never returns.
[[noreturn]] void record_forever(const std::filesystem::path& path, Progress& progress) {
    auto writer = LogWriter::create(path, samples::header()).value();
    for (Tick t = 0;; ++t) {
        writer.append(samples::random_frame(t, 2));
        progress.on_disk = writer.ticks_on_disk();
        progress.appended = t + 1;
        if (t % 64 == 0) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
}

TEST(InputLog, KilledWhileRecordingLosesOnlyTheLastBlocks) {
    const Folder folder;
    void* shared =
        ::mmap(nullptr, sizeof(Progress), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    ASSERT_NE(shared, MAP_FAILED);
    for (int run = 0; run < 8; ++run) {
        const auto path = folder / text("log", run);
        auto& progress = *new (shared) Progress;
        const auto child = ::fork();
        ASSERT_GE(child, 0);
        if (child == 0) record_forever(path, progress);
        while (progress.appended < 700 + 331 * static_cast<Tick>(run)) {
            std::this_thread::sleep_for(std::chrono::microseconds(100));
        }
        ASSERT_EQ(::kill(child, SIGKILL), 0);
        ASSERT_EQ(::waitpid(child, nullptr, 0), child);

        auto reader = LogReader::open(path).value();
        EXPECT_EQ(reader.ending(), LogEnding::cut_off) << reader.ending_reason();
        EXPECT_EQ(reader.ticks() % 512, 0U);
        EXPECT_GE(reader.ticks(), progress.on_disk);
        std::printf("[ killed   ] at tick %llu, kept %llu\n",
                    static_cast<unsigned long long>(progress.appended.load()),
                    static_cast<unsigned long long>(reader.ticks()));
        expect_frames(reader, [](Tick t) { return samples::random_frame(t, 2); });
    }
    ::munmap(shared, sizeof(Progress));
}

TEST(InputLog, NoAllocationWhileRecording) {
    const Folder folder;
    auto writer = LogWriter::create(folder / "log", samples::header()).value();
    std::vector<InputFrame> frames;
    for (Tick t = 0; t < 512; ++t) frames.push_back(samples::random_frame(t, 2));
    const auto block = [&] {
        const auto first = writer.ticks();
        for (const auto& frame : frames) {
            writer.append(frame);
            const auto t = writer.ticks();
            if (t % hash_interval == 0) writer.append_hash(t, t, t);
        }
        writer.mark(1);
        while (writer.ticks_on_disk() < first) std::this_thread::yield();
    };
    block();
    block();
    const auto before = test::allocations();
    for (int i = 0; i < 50; ++i) block();
    EXPECT_EQ(test::allocations() - before, 0U);
    EXPECT_EQ(writer.extra_blocks(), 0U);
}

TEST(InputLog, TooSlowADiskStopsRecordingAndKeepsAWholeLog) {
    const Folder folder;
    auto writer = LogWriter::create(folder / "log", samples::header()).value();
    std::vector<InputFrame> frames;
    for (Tick t = 0; t < 512; ++t) frames.push_back(samples::random_frame(t, 2));
    Tick given = 0;
    for (; given < 4000 * 512 && !writer.error(); ++given) writer.append(frames[given % 512]);
    EXPECT_GT(writer.extra_blocks(), 0U);
    const auto closed = writer.close("");
    auto reader = LogReader::open(folder / "log").value();
    // The frames come from memory, faster than zstd packs them, so the writer gives up and closing fails.
    // Only if this thread does not run for a while can the writer keep up.
    if (!closed) {
        EXPECT_TRUE(contains(closed.error().message, text("kept up to tick ", reader.ticks())));
        EXPECT_EQ(reader.ending(), LogEnding::cut_off);
    }
    expect_frames(reader, [&](Tick t) { return frames[t % 512]; });
}

// Size of a log -------------------------------------------------------------------------------------

/// Input of two players who never rest: a mouse at 1 kHz with changing speed, keys and buttons; a gamepad at
/// 250 Hz whose sticks wander and tremble.
class BusyHands {
public:
    InputFrame next() {
        InputFrame frame;
        mouse(frame.devices[0]);
        if (tick_ % 4 == 0) move_pad();
        frame.devices[1] = pad_;
        ++tick_;
        return frame;
    }

private:
    std::int32_t rounded(double v) { return static_cast<std::int32_t>(std::lround(v)); }

    void mouse(DeviceSample& s) {
        vx_ = 0.98 * vx_ + normal_(random_) * 1.5;
        vy_ = 0.98 * vy_ + normal_(random_) * 0.8;
        s.counts[hand::look_right] = rounded(vx_);
        s.counts[hand::look_up] = rounded(vy_);
        if (random_() % 180 == 0) keys_ ^= 1U << random_() % 4;
        if (random_() % 90 == 0) buttons_ ^= 1U << random_() % 5;
        if (random_() % 500 == 0) s.counts[hand::wheel] = random_() % 2 == 0 ? 1 : -1;
        s.counts[hand::strafe] =
            127 * static_cast<int>(keys_ & 1U) - 127 * static_cast<int>(keys_ >> 1U & 1U);
        s.counts[hand::forward] =
            127 * static_cast<int>(keys_ >> 2U & 1U) - 127 * static_cast<int>(keys_ >> 3U & 1U);
        s.counts[hand::trigger] = (buttons_ & 1U) != 0 ? 255 : 0;
        s.buttons = buttons_;
    }

    void move_pad() {
        for (std::size_t i = 0; i < 5; ++i) {
            stick_[i] = std::clamp(stick_[i] + 0.03 * normal_(random_), -1.0, 1.0);
            const double trembling = std::clamp(stick_[i] + 0.01 * normal_(random_), -1.0, 1.0);
            pad_.counts[hand::strafe + i] = rounded(trembling * 127);
        }
        pad_.counts[hand::trigger] = std::max(pad_.counts[hand::trigger] * 2, 0);
        if (random_() % 25 == 0) pad_.buttons ^= 1U << random_() % 6;
    }

    std::mt19937_64 random_{1};
    std::normal_distribution<double> normal_;
    Tick tick_ = 0;
    double vx_ = 0, vy_ = 0;
    std::array<double, 5> stick_{};
    std::uint32_t keys_ = 0, buttons_ = 0;
    DeviceSample pad_;
};

template <class Frame>
std::uintmax_t match_size(const std::filesystem::path& path, const char* name, Frame next) {
    constexpr Tick match = 240000;
    std::vector<InputFrame> frames;
    for (Tick t = 0; t < match; ++t) frames.push_back(next());
    auto writer = LogWriter::create(path, samples::header(), WhenBehind::wait).value();
    std::chrono::nanoseconds appending{0};
    for (Tick t = 0; t < match; t += 512) {
        const auto begin = std::chrono::steady_clock::now();
        const auto end = std::min(t + 512, match);
        for (auto i = t; i < end; ++i) writer.append(frames[i]);
        appending += std::chrono::steady_clock::now() - begin;
        writer.append_hash(end / 128 * 128, samples::hash_of(end).state, samples::hash_of(end).force);
        while (writer.ticks_on_disk() + 2048 < end) std::this_thread::yield();
    }
    EXPECT_TRUE(writer.close("5 : 3"));
    const auto size = std::filesystem::file_size(path);
    const auto begin = std::chrono::steady_clock::now();
    auto reader = LogReader::open(path).value();
    const std::chrono::duration<double> opening = std::chrono::steady_clock::now() - begin;
    std::printf("[ size     ] %s, 4 minutes: %.1f KiB, append %.1f ns, open %.1f ms\n", name,
                static_cast<double>(size) / 1024,
                static_cast<double>(appending.count()) / static_cast<double>(match), opening.count() * 1e3);
    expect_frames(reader, [&](Tick t) { return frames[t]; });
    return size;
}

TEST(InputLog, FourMinutesTakeAtMostTwoMebibytes) {
    const Folder folder;
    BusyHands hands;
    EXPECT_LE(match_size(folder / "busy", "mouse and pad, never still", [&] { return hands.next(); }),
              2U * 1024 * 1024);
    EXPECT_LE(match_size(folder / "idle", "nobody there", [] { return InputFrame{}; }), 100U * 1024);
}

}  // namespace
}  // namespace thaum::input

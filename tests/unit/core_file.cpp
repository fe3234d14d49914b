#include "core/file.h"
#include "core/file_writer.h"
#include "core/write_rule.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <thread>

#include "core/text.h"

namespace thaum {
namespace {

namespace fs = std::filesystem;

class CoreFile : public ::testing::Test {
protected:
    ~CoreFile() override { fs::permissions(folder_, fs::perms::owner_all); }

    fs::path in_folder(std::string_view name) const { return folder_ / name; }

    std::size_t files() const {
        return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_), {}));
    }

    /// Expects that a call failed with an error of one line that names the path and contains `what`.
    static void expect_refused(const auto& result, const fs::path& path, std::string_view what) {
        ASSERT_FALSE(result.has_value());
        const auto& message = result.error().message;
        EXPECT_TRUE(message.starts_with(path.string() + ": ")) << message;
        EXPECT_NE(message.find(what), std::string::npos) << message;
        EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    }

private:
    const TemporaryFolder own_;
    const fs::path folder_ = own_.path();
};

TEST(CoreStreams, NoFileGetsTheNumberOfAClosedStream) {
    const auto attempt = [] {
        for (int stream = STDIN_FILENO; stream <= STDERR_FILENO; ++stream) ::close(stream);
        occupy_closed_streams();
        const int file = ::dup(STDIN_FILENO);
        const bool refused = ::write(STDOUT_FILENO, "a", 1) < 0 && errno == EBADF;
        std::_Exit(file > STDERR_FILENO && refused ? 0 : 1);
    };
    EXPECT_EXIT(attempt(), ::testing::ExitedWithCode(0), "");
}

TEST_F(CoreFile, ReadsWhatWasWritten) {
    const auto path = in_folder("a");
    for (const auto size : {0U, 1U, 4096U, 1'000'000U}) {
        Bytes bytes(size);
        for (std::size_t i = 0; i < size; ++i) bytes[i] = static_cast<std::byte>(i * 31);
        ASSERT_TRUE(write_file(path, bytes));
        EXPECT_EQ(read_file(path, size), bytes);
    }
    ASSERT_TRUE(write_text_file(path, std::string_view("a\0b\n", 4)));
    EXPECT_EQ(read_text_file(path, 100), std::string("a\0b\n", 4));
}

TEST_F(CoreFile, TheLimitCountsBytes) {
    const auto path = in_folder("a");
    ASSERT_TRUE(write_text_file(path, "12345"));
    EXPECT_TRUE(read_file(path, 5));
    expect_refused(read_file(path, 4), path, "5 bytes, more than the limit of 4");
}

TEST_F(CoreFile, RefusesObjectsThatAreNoOrdinaryFile) {
    expect_refused(read_file(in_folder("none"), 10), in_folder("none"), "No such file");
    fs::create_directory(in_folder("folder"));
    expect_refused(read_file(in_folder("folder"), 10), in_folder("folder"), "not an ordinary file");
    ASSERT_EQ(::mkfifo(in_folder("fifo").c_str(), 0600), 0);
    expect_refused(read_file(in_folder("fifo"), 10), in_folder("fifo"), "not an ordinary file");
    expect_refused(read_file("/dev/zero", 10), "/dev/zero", "not an ordinary file");
    expect_refused(read_text_file(in_folder("none"), 10), in_folder("none"), "No such file");
}

TEST_F(CoreFile, FollowsLinksButNotInCircles) {
    ASSERT_TRUE(write_text_file(in_folder("a"), "x"));
    fs::create_symlink(in_folder("a"), in_folder("link"));
    EXPECT_EQ(read_text_file(in_folder("link"), 10), "x");
    fs::create_symlink(in_folder("loop"), in_folder("loop"));
    EXPECT_FALSE(read_file(in_folder("loop"), 10));
}

TEST_F(CoreFile, ReplacesAndLeavesNothingBeside) {
    const auto path = in_folder("a");
    ASSERT_TRUE(write_text_file(path, "the old and longer text"));
    ASSERT_TRUE(write_text_file(path, "new"));
    EXPECT_EQ(read_text_file(path, 100), "new");
    EXPECT_EQ(files(), 1);
}

TEST_F(CoreFile, AFailedWriteLeavesTheOldState) {
    const auto folder = in_folder("folder");
    fs::create_directories(folder / "full");
    expect_refused(write_text_file(folder, "x"), folder, "not an ordinary file");
    EXPECT_EQ(files(), 1);
    const auto nowhere = in_folder("missing") / "a";
    expect_refused(write_text_file(nowhere, "x"), nowhere, "cannot create");
}

TEST_F(CoreFile, AFullDiskIsAnError) {
    // Simulates a full disk: in a child process no file may grow beyond 4 KiB.
    const auto path = in_folder("a");
    ASSERT_TRUE(write_text_file(path, "old"));
    const auto attempt = [&] {
        std::signal(SIGXFSZ, SIG_IGN);
        const rlimit limit{4096, 4096};
        if (::setrlimit(RLIMIT_FSIZE, &limit) != 0) ::_exit(3);
        const auto result = write_text_file(path, std::string(100'000, 'x'));
        std::fputs(result ? "written" : result.error().message.c_str(), stderr);
        ::_exit(0);
    };
    EXPECT_EXIT(attempt(), ::testing::ExitedWithCode(0), "cannot write: File too large");
    EXPECT_EQ(files(), 1);
    EXPECT_EQ(read_text_file(path, 100), "old");
}

/// A link at the name of the writer's temporary file must not redirect the bytes to another file.
TEST_F(CoreFile, ALinkAtTheTemporaryNameIsNotFollowed) {
    const auto path = in_folder("a"), precious = in_folder("precious");
    ASSERT_TRUE(write_text_file(precious, "precious"));
    for (const auto* ending : {"", "-0", "-1"})
        fs::create_symlink(precious, path.string() + text(".", ::getpid(), ending, ".part"));
    ASSERT_TRUE(write_text_file(path, "x"));
    EXPECT_EQ(read_text_file(precious, 100), "precious");
    EXPECT_EQ(read_text_file(path, 100), "x");
}

TEST_F(CoreFile, AnInputIsNeverReplacedUnderAnyName) {
    const auto input = in_folder("input"), data = in_folder("data");
    fs::create_directories(data / "below");
    ASSERT_TRUE(write_text_file(input, "input"));
    ASSERT_TRUE(write_text_file(data / "below/file", "data"));
    fs::create_hard_link(input, in_folder("hard"));
    fs::create_symlink(input, in_folder("soft"));
    fs::create_hard_link(data / "below/file", in_folder("hard_data"));
    protect_input(input);
    protect_input(data);
    for (const auto* name :
         {"input", "hard", "soft", "data/../input", "data/below/file", "data/new", "hard_data"})
        expect_refused(write_text_file(in_folder(name), "x"), in_folder(name), "is read by this command");
    EXPECT_EQ(read_text_file(input, 100), "input");
    EXPECT_EQ(read_text_file(data / "below/file", 100), "data");
    EXPECT_TRUE(write_text_file(in_folder("other"), "x"));
}

TEST_F(CoreFile, WhatWasReadIsNeverReplaced) {
    const auto whole = in_folder("whole"), start = in_folder("start"), own = in_folder("own");
    for (const auto& file : {whole, start, own}) std::ofstream(file) << "old";
    fs::create_hard_link(whole, in_folder("hard"));
    fs::create_symlink(start, in_folder("soft"));
    auto begun = FileWriter::create(whole).value();
    ASSERT_TRUE(read_file(whole, 100));
    ASSERT_TRUE(read_start(start, 1));
    ASSERT_EQ(read_own_text_file(own, 100), "old");
    EXPECT_FALSE(read_text_file(in_folder("missing"), 100));
    for (const auto* name : {"whole", "start", "hard", "soft"})
        expect_refused(write_text_file(in_folder(name), "new"), in_folder(name), "is read by this command");
    begun.write("new");
    expect_refused(begun.close(), fs::canonical(whole), "is read by this command");
    for (const auto* name : {"own", "missing"}) EXPECT_TRUE(write_text_file(in_folder(name), "new"));
    EXPECT_EQ(read_text_file(whole, 100), "old");
    EXPECT_EQ(read_text_file(start, 100), "old");
}

TEST_F(CoreFile, WhatWasWrittenMayBeReadAndWrittenAgain) {
    const auto path = in_folder("a");
    ASSERT_TRUE(write_text_file(path, "first"));
    EXPECT_EQ(read_text_file(path, 100), "first");
    EXPECT_TRUE(write_text_file(path, "second"));
    protect_input(path);
    expect_refused(write_text_file(path, "third"), path, "is read by this command");
}

TEST_F(CoreFile, TheLongestNameThatAFolderHoldsCanBeWritten) {
    const auto path = in_folder(std::string(255, 'n'));
    ASSERT_TRUE(write_text_file(path, "x"));
    EXPECT_EQ(read_text_file(path, 100), "x");
    EXPECT_EQ(files(), 1);
    expect_refused(write_text_file(in_folder(std::string(256, 'n')), "x"), in_folder(std::string(256, 'n')),
                   "File name too long");
}

TEST_F(CoreFile, ANewFileTakesItsNameAtOnce) {
    const auto path = in_folder("a");
    auto file = FileWriter::create_new(path).value();
    EXPECT_TRUE(fs::exists(path));
    expect_refused(FileWriter::create_new(path), path, "File exists");
    file.write("x");
    ASSERT_TRUE(file.close());
    EXPECT_EQ(read_text_file(path, 100), "x");
    EXPECT_EQ(files(), 1);
    { const auto left = FileWriter::create_new(in_folder("b")).value(); }
    EXPECT_EQ(files(), 1) << "one that is never closed gives its name back";
    fs::create_symlink(in_folder("nowhere"), in_folder("link"));
    EXPECT_FALSE(FileWriter::create_new(in_folder("link")));
    EXPECT_FALSE(FileWriter::create_new(in_folder("no_folder") / "a"));
}

TEST_F(CoreFile, ARecordingIsNeverReplaced) {
    const auto log = in_folder("log"), short_file = in_folder("short");
    std::ofstream(log) << "THAUMLOG and more";
    std::ofstream(short_file) << "THAUMLO";
    expect_refused(write_text_file(log, "x"), log, "is a recording");
    expect_refused(check_output(log), log, "is a recording");
    EXPECT_TRUE(write_text_file(short_file, "x"));
    // A link to a recording that appears while the file is written must not redirect the bytes to the
    // recording.
    auto file = FileWriter::create(in_folder("late")).value();
    fs::create_hard_link(log, in_folder("late"));
    expect_refused(file.close(), fs::canonical(in_folder("late")), "is a recording");
    EXPECT_EQ(files(), 3);
}

TEST_F(CoreFile, TheStartOfAFileCanBeReplacedAtTheEnd) {
    const auto path = in_folder("a");
    for (const std::size_t length : {4U, 100U, 200'000U}) {
        auto file = FileWriter::create(path).value();
        file.write("size");
        file.write(std::string(length, '.'));
        const std::string start = "1234";
        file.replace_start(std::as_bytes(std::span(start)));
        file.write("end");
        ASSERT_TRUE(file.close());
        EXPECT_EQ(read_text_file(path, 1'000'000), "1234" + std::string(length, '.') + "end");
    }
}

TEST_F(CoreFile, AFinishedFileWaitsForItsPlace) {
    const auto path = in_folder("a");
    ASSERT_TRUE(write_text_file(path, "old"));
    {
        auto file = FileWriter::create(path).value();
        file.write("new");
        ASSERT_TRUE(file.finish());
        EXPECT_EQ(read_text_file(path, 100), "old");
    }
    EXPECT_EQ(files(), 1) << "one that is never closed leaves nothing";
    auto file = FileWriter::create(path).value();
    file.write("new");
    ASSERT_TRUE(file.finish());
    auto moved = std::move(file);
    ASSERT_TRUE(moved.close());
    EXPECT_EQ(read_text_file(path, 100), "new");
    EXPECT_EQ(files(), 1);
}

TEST_F(CoreFile, TheStartOfALongFileIsReadAlone) {
    const auto path = in_folder("a");
    ASSERT_TRUE(write_text_file(path, "0123456789"));
    EXPECT_EQ(read_start(path, 4).value().size(), 4U);
    EXPECT_EQ(read_start(path, 40).value().size(), 10U);
    EXPECT_FALSE(read_start(in_folder("none"), 4));
}

TEST_F(CoreFile, ALinkStaysALinkAndRightsStay) {
    const auto goal = in_folder("goal"), link = in_folder("link");
    ASSERT_TRUE(write_text_file(goal, "old"));
    fs::permissions(goal, fs::perms::owner_read | fs::perms::owner_write);
    fs::create_symlink("goal", link);
    ASSERT_TRUE(write_text_file(link, "new"));
    EXPECT_TRUE(fs::is_symlink(link));
    EXPECT_EQ(read_text_file(goal, 100), "new");
    EXPECT_EQ(fs::status(goal).permissions(), fs::perms::owner_read | fs::perms::owner_write);
    fs::create_symlink("nothing", in_folder("dangling"));
    expect_refused(write_text_file(in_folder("dangling"), "x"), in_folder("dangling"), "leads nowhere");
}

TEST_F(CoreFile, LongWorkLearnsFirstThatItsOutputCannotBeWritten) {
    expect_refused(check_output("/dev/full"), "/dev/full", "not an ordinary file");
    expect_refused(check_output("/proc/x"), "/proc/x", "cannot create");
    expect_refused(make_folder("/proc/x"), "/proc/x", "cannot create");
    ASSERT_TRUE(write_text_file(in_folder("a"), "old"));
    EXPECT_TRUE(check_output(in_folder("a")));
    EXPECT_EQ(read_text_file(in_folder("a"), 100), "old");
    expect_refused(make_folder(in_folder("a")), in_folder("a"), "cannot create");
    EXPECT_TRUE(make_folder(in_folder("b/c")));
    EXPECT_EQ(files(), 2);
}

/// For root, a rename would replace the device /dev/null by an ordinary file, so the writer must refuse it.
TEST_F(CoreFile, NeverReplacesADevice) {
    expect_refused(write_text_file("/dev/null", "x"), "/dev/null", "not an ordinary file");
    EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST_F(CoreFile, PiecesBecomeAFileOnlyAtTheEnd) {
    const auto path = in_folder("a");
    const std::string piece(70'000, 'p');
    {
        auto file = FileWriter::create(path).value();
        file.write(piece);
    }
    EXPECT_EQ(files(), 0) << "given up";
    auto file = FileWriter::create(path).value();
    for (const auto* small : {"one,", "two,"}) file.write(small);
    file.write(piece);
    file.write("end");
    EXPECT_FALSE(fs::exists(path));
    ASSERT_TRUE(file.close());
    EXPECT_EQ(read_text_file(path, 1U << 20U), text("one,two,", piece, "end"));
    EXPECT_EQ(files(), 1);
}

/// The superuser can write to every folder, so the child process gives up its rights first.
TEST_F(CoreFile, AFolderWithoutRightsIsAnError) {
    const auto locked = in_folder("locked");
    fs::create_directory(locked);
    fs::permissions(locked, fs::perms::owner_read | fs::perms::owner_exec);
    const auto attempt = [&] {
        if (::geteuid() == 0 && ::seteuid(65534) != 0) ::_exit(3);
        const auto result = write_text_file(locked / "a", "x");
        std::fputs(result ? "written" : result.error().message.c_str(), stderr);
        ::_exit(0);  // not exit(), whose leak check would need the rights
    };
    EXPECT_EXIT(attempt(), ::testing::ExitedWithCode(0), "cannot create: Permission denied");
    fs::permissions(locked, fs::perms::owner_all);
    EXPECT_TRUE(fs::is_empty(locked));
}

TEST_F(CoreFile, AReaderNeverSeesHalfAFile) {
    const auto path = in_folder("a");
    const std::string first(100'000, 'a');
    const std::string second(50'000, 'b');
    ASSERT_TRUE(write_text_file(path, first));
    std::jthread writer([&] {
        for (int i = 0; i < 200; ++i) {
            if (!write_text_file(path, i % 2 == 0 ? second : first)) std::abort();
        }
    });
    for (int i = 0; i < 500; ++i) {
        const auto seen = read_text_file(path, 200'000);
        EXPECT_TRUE(seen == first || seen == second);
    }
}

}  // namespace
}  // namespace thaum

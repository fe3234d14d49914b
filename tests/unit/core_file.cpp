#include "core/file.h"
#include "core/file_writer.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <thread>

#include "core/text.h"

namespace thaum {
namespace {

namespace fs = std::filesystem;

class CoreFile : public ::testing::Test {
protected:
    CoreFile() {
        auto name = (fs::temp_directory_path() / "thaum-file-XXXXXX").string();
        folder_ = ::mkdtemp(name.data());
    }
    ~CoreFile() override {
        fs::permissions(folder_, fs::perms::owner_all);
        fs::remove_all(folder_);
    }
    CoreFile(const CoreFile&) = delete;
    CoreFile& operator=(const CoreFile&) = delete;

    fs::path in_folder(std::string_view name) const { return folder_ / name; }

    std::size_t files() const {
        return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_), {}));
    }

    /// The message names the path, is one line and holds `what`.
    static void expect_refused(const auto& result, const fs::path& path, std::string_view what) {
        ASSERT_FALSE(result.has_value());
        const auto& message = result.error().message;
        EXPECT_TRUE(message.starts_with(path.string() + ": ")) << message;
        EXPECT_NE(message.find(what), std::string::npos) << message;
        EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    }

private:
    fs::path folder_;
};

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

TEST_F(CoreFile, RefusesWhatIsNoOrdinaryFile) {
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
    // /dev/full takes no byte, but it cannot be renamed onto; so the temporary name itself leads there.
    const auto path = in_folder("a");
    fs::create_symlink("/dev/full", path.string() + text(".", ::getpid(), ".part"));
    expect_refused(write_text_file(path, "x"), path, "cannot write: No space left");
    EXPECT_EQ(files(), 0);
}

/// As root a rename would make /dev/null a file for everybody.
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

/// As root every folder can be written to, so the child gives its rights away first.
TEST_F(CoreFile, AFolderWithoutRightsIsAnError) {
    const auto locked = in_folder("locked");
    fs::create_directory(locked);
    fs::permissions(locked, fs::perms::owner_read | fs::perms::owner_exec);
    const auto attempt = [&] {
        if (::geteuid() == 0 && ::seteuid(65534) != 0) ::_exit(3);
        const auto result = write_text_file(locked / "a", "x");
        std::fputs(result ? "written" : result.error().message.c_str(), stderr);
        ::_exit(0);  // the leak check of exit() cannot work without the rights
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
    std::thread writer([&] {
        for (int i = 0; i < 200; ++i) {
            if (!write_text_file(path, i % 2 == 0 ? second : first)) std::abort();
        }
    });
    for (int i = 0; i < 500; ++i) {
        const auto seen = read_text_file(path, 200'000);
        EXPECT_TRUE(seen == first || seen == second);
    }
    writer.join();
}

}  // namespace
}  // namespace thaum

// Tests of watching files that change while a program runs: each change is reported once, when the file is
// complete.
#include <gtest/gtest.h>

#include <fstream>

#include "core/file.h"
#include "core/file_watch.h"

namespace thaum {
namespace {

namespace fs = std::filesystem;
using Paths = std::vector<fs::path>;

class FileWatchTest : public testing::Test {
protected:
    fs::path file(std::string_view name) const { return folder_.path() / name; }
    void write(std::string_view name, std::string_view words) const { std::ofstream(file(name)) << words; }
    /// Polls twice and returns the second result. A change is reported when the file has not changed between
    /// two polls.
    static Paths two_looks(FileWatch& watch) {
        EXPECT_EQ(watch.look(), Paths());
        return watch.look();
    }

private:
    const TemporaryFolder folder_;
};

TEST_F(FileWatchTest, ReportsAChangeOnceAfterTheFileStayedTheSame) {
    write("a", "one");
    write("b", "one");
    FileWatch watch({file("a"), file("b")});
    EXPECT_EQ(two_looks(watch), Paths());
    write("a", "twelve");
    EXPECT_EQ(two_looks(watch), Paths{file("a")});
    EXPECT_EQ(two_looks(watch), Paths());
}

TEST_F(FileWatchTest, WaitsForAFileThatIsStillBeingWritten) {
    write("a", "one");
    write("b", "one");
    FileWatch watch({file("a"), file("b")});
    write("a", "ready");
    write("b", "h");
    EXPECT_EQ(watch.look(), Paths());
    write("b", "ha");
    EXPECT_EQ(watch.look(), Paths()) << "b grows, so a is not reported either; they may belong together";
    write("b", "half");
    EXPECT_EQ(two_looks(watch), (Paths{file("a"), file("b")}));
}

TEST_F(FileWatchTest, ARenamedFileIsAnotherThoughItsTimeAndSizeAreTheSame) {
    write("a", "one");
    FileWatch watch({file("a")});
    write("new", "two");
    fs::last_write_time(file("new"), fs::last_write_time(file("a")));
    fs::rename(file("new"), file("a"));
    EXPECT_EQ(two_looks(watch), Paths{file("a")});
}

TEST_F(FileWatchTest, ReportsAFileThatWasDeletedAndMadeAgain) {
    write("a", "one");
    FileWatch watch({file("a"), file("never")});
    fs::remove(file("a"));
    EXPECT_EQ(two_looks(watch), Paths{file("a")});
    fs::create_directory(file("a"));
    EXPECT_EQ(two_looks(watch), Paths{file("a")});
    fs::remove(file("a"));
    write("a", "one");
    EXPECT_EQ(two_looks(watch), Paths{file("a")});
}

}  // namespace
}  // namespace thaum

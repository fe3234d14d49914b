// Tests of finding joysticks that the user may not read, in folders laid out as Linux does.
#include "input/locked_sticks.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/file.h"

namespace thaum::input {
namespace {

/// If the test runs as root, gives up root's rights as long as the object exists.
struct AsNobody {
    static constexpr uid_t nobody = 65534;
    bool was_root = ::geteuid() == 0;
    AsNobody() { change(nobody); }
    ~AsNobody() { change(0); }
    AsNobody(const AsNobody&) = delete;
    AsNobody& operator=(const AsNobody&) = delete;
    void change(uid_t user) const {
        if (was_root) {
            ASSERT_EQ(::seteuid(user), 0);
        }
    }
};

class LockedSticks : public testing::Test {
protected:
    void add(const std::string& event, const std::string& name, const std::string& keys, ::mode_t rights) {
        const auto about = folder_.path() / "class" / event / "device";
        std::filesystem::create_directories(about / "capabilities");
        std::filesystem::create_directories(folder_.path() / "dev");
        ASSERT_TRUE(write_text_file(about / "name", name + "\n"));
        ASSERT_TRUE(write_text_file(about / "capabilities" / "key", keys + "\n"));
        if (rights == 0) return;
        ASSERT_TRUE(write_text_file(folder_.path() / "dev" / event, "."));
        ASSERT_EQ(::chmod((folder_.path() / "dev" / event).c_str(), rights), 0);
    }
    TemporaryFolder folder_;
};

TEST_F(LockedSticks, AreJoysticksWhoseFileMayNotBeRead) {
    const std::string pad = "7cdb000000000000 0 0 0 0", stick = "fff00000000 0 0 0 0",
                      keyboard =
                          "1000000000007 "
                          "ff9f207ac14057ff";
    add("event0", "Keyboard", keyboard, 0200);
    add("event1", "Pad that may be read", pad, 0444);
    add("event2", "Pad", pad, 0200);
    add("event3", "Stick", stick, 0200);
    add("event4", "Pad that has just been pulled out", pad, 0);
    ASSERT_EQ(::chmod(folder_.path().c_str(), 0755), 0);
    std::vector<LockedStick> found;
    {
        const AsNobody nobody;
        found = locked_sticks(folder_.path() / "class", folder_.path() / "dev");
    }
    EXPECT_EQ(found, (std::vector<LockedStick>{{"Pad", folder_.path() / "dev" / "event2"},
                                               {"Stick", folder_.path() / "dev" / "event3"}}));
    EXPECT_TRUE(locked_sticks(folder_.path() / "none", folder_.path() / "dev").empty());
}

}  // namespace
}  // namespace thaum::input

// Tests of opening arms (haptic devices) with any driver: what the engine adds to a driver that only reads
// and writes (tests/drivers/fake_arm), and what it does if drivers hang, fail or return wrong values.
#include "input/arm_driver.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <thread>

#include "core/clock.h"
#include "core/file.h"
#include "drivers/fake_hd/fake_hd.h"
#include "input/arm_silence.h"
#include "input/open_arm.h"
#include "unit/message_of.h"

namespace thaum::input {
namespace {

constexpr std::int64_t ns_per_ms = 1'000'000;

template <class F>
bool eventually(F holds) {
    for (int i = 0; i < 20'000; ++i) {
        if (holds()) return true;
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return false;
}

bool says(const std::string& line, std::string_view part) { return line.find(part) != std::string::npos; }

/// Opens arm `number` of a driver. The fake driver reads its scripts, $FAKE_ARMS, when arms are listed and
/// when one is opened.
Expected<std::unique_ptr<OpenArm>> open_of(std::string_view driver, std::size_t number = 0,
                                           const ArmPatience& patience = {}) {
    for (const auto& place : arm_places())
        if (place.kind->name == driver && number-- == 0) return open_arm(place, patience);
    return fail("no such arm");
}

/// A file into which a fake arm writes its forces and ticks, for the test to read.
struct Live {
    const TemporaryFolder folder{};
    const std::filesystem::path file = folder.path() / "live";

    Live() { std::ofstream(file).flush(); }
    FakeHdLive now() const {
        FakeHdLive arm{};
        std::ifstream(file, std::ios::binary).read(reinterpret_cast<char*>(&arm), sizeof arm);
        return arm;
    }
    double push() const { return now().force[2]; }
    std::string word() const { return "live=" + file.string(); }
};

void plug_in(const std::string& scripts) { ::setenv("FAKE_ARMS", scripts.c_str(), 1); }

/// A program that uses an arm: in each tick it asks for the same force along z.
struct Pusher {
    std::atomic<double> newton{1};
    std::atomic<std::uint64_t> ticks{0};
    ArmTick tick() {
        return {[](void* context, const ArmReading&) {
                    auto& self = *static_cast<Pusher*>(context);
                    ++self.ticks;
                    return vec3(0, 0, self.newton.load());
                },
                this};
    }
};

// ---- a test driver whose calls fail on demand -------------------------------------------------------------

std::atomic<bool> open_hangs{false}, close_hangs{false}, start_fails{false}, read_hangs{false},
    write_hangs{false};
std::atomic<double> told_peak{1};
std::atomic<int> opened{0}, closed{0}, given_up{0};
std::atomic<double> last_force{0};
std::atomic<double> max_change{0};  ///< largest increase of the force from one tick to the next (N)

void wait_while(const std::atomic<bool>& hangs) {
    while (hangs) std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

class Fickle final : public ArmDriver {
public:
    explicit Fickle(bool may_hang) : may_hang_(may_hang) {}

    Expected<void> open() override {
        if (may_hang_) wait_while(open_hangs);
        ++opened;
        return {};
    }
    ArmFacts spec() const override {
        ArmFacts facts{.serial = "1\x1b]0;owned\x07"};
        facts.spec.name = std::string(1000, 'x');
        facts.spec.peak_force = told_peak;
        facts.spec.workspace = {0.1, std::nan(""), 1e9};
        facts.spec.max_stiffness = -1;
        facts.spec.sensed = 1 << 30;
        return facts;
    }
    Expected<bool> start(std::uint64_t) override {
        if (start_fails) return fail("the arm\n does not start: wait");
        return false;
    }
    ArmFault read(ArmReading&) noexcept override { return wait_while(read_hangs), 0; }
    ArmFault write(vec3 force) noexcept override {
        max_change = std::max(max_change.load(), force.z - last_force);
        last_force = force.z;
        if (force.z != 0) wait_while(write_hangs);
        return 0;
    }
    void give_up() override { last_force = 0, ++given_up; }
    ArmStatus status(ArmFault) const override { return {}; }
    void close() override {
        if (may_hang_) wait_while(close_hangs);
        ++closed;
    }

private:
    bool may_hang_;
};

std::vector<std::string> find_one() { return {"one"}; }
std::unique_ptr<ArmDriver> make_fickle(const std::string&) { return std::make_unique<Fickle>(false); }
std::unique_ptr<ArmDriver> make_hanging(const std::string&) { return std::make_unique<Fickle>(true); }

// These drivers are registered out of alphabetical order. The list of drivers must be sorted all the same.
const ArmDriverRegistration last_driver(
    {.name = "zz", .about = "", .find = find_one, .make = make_hanging, .at_hang = AtHang::write_zero});
const ArmDriverRegistration first_driver(
    {.name = "aa", .about = "", .find = find_one, .make = make_fickle, .at_hang = AtHang::write_zero});
const ArmDriverRegistration deaf_driver(
    {.name = "keeps", .about = "", .find = find_one, .make = make_fickle, .at_hang = AtHang::keeps_force});
const ArmDriverRegistration lost_driver(
    {.name = "lets go", .about = "", .find = find_one, .make = make_fickle, .at_hang = AtHang::give_up});

// ---- the list of drivers ----------------------------------------------------------------------------------

TEST(ArmDrivers, AreSortedByNameWhateverTheLinkerDid) {
    std::vector<std::string_view> names;
    for (const auto& kind : arm_drivers()) names.push_back(kind.name);
    EXPECT_EQ(names, (std::vector<std::string_view>{"aa", "fake", "keeps", "lets go", "openhaptics", "zz"}));
}

TEST(ArmDrivers, PlacesListTheArmsOfEachInItsOrder) {
    plug_in("name=First;name=Second");
    std::vector<std::string> places;
    for (const auto& place : arm_places()) places.push_back(std::string(place.kind->name) + " " + place.arm);
    EXPECT_EQ(places, (std::vector<std::string>{"aa one", "fake 0", "fake 1", "keeps one", "lets go one",
                                                "openhaptics Default Device", "zz one"}));
}

// ---- a driver that reads and writes -----------------------------------------------------------------------

TEST(ArmDrivers, TheEngineTicksAnArmWithoutAThread) {
    const Live live;
    plug_in(live.word());
    Pusher pusher;
    auto arm = open_of("fake").value();
    EXPECT_EQ(name_of(arm->facts()), "Fake A0");
    EXPECT_TRUE(is_called(arm->facts(), "FAKE") && is_called(arm->facts(), "a0"));
    EXPECT_TRUE(is_called(arm->facts(), "arm"));
    EXPECT_FALSE(is_called(arm->facts(), "phantom"));
    const auto begun = monotonic_ns();
    ASSERT_TRUE(arm->start(pusher.tick()));
    EXPECT_FALSE(arm->start(pusher.tick()));
    ASSERT_TRUE(eventually([&] { return pusher.ticks > 300; }));
    EXPECT_GE(monotonic_ns() - begun, 290 * ns_per_ms) << "faster than 1 kHz";
    EXPECT_EQ(live.push(), 1);
    EXPECT_EQ(arm->status().state, ArmPresence::present);
    EXPECT_GE(arm->times().ticks, 300U);
    arm.reset();
    const auto ticks = pusher.ticks.load();
    EXPECT_EQ(live.now().left[2], 0) << "closed with a force";
    EXPECT_EQ(live.now().max_force, 1);
    EXPECT_EQ(live.now().initiated, 0U);
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    EXPECT_EQ(pusher.ticks, ticks);
}

TEST(ArmDrivers, ForcesAreLimitedToTheArmsPeak) {
    const Live live;
    plug_in("peak=2," + live.word());
    Pusher pusher;
    pusher.newton = 1e6;
    auto arm = open_of("fake").value();
    ASSERT_TRUE(arm->start(pusher.tick()));
    ASSERT_TRUE(eventually([&] { return live.push() != 0; }));
    EXPECT_NEAR(live.push(), 2, 1e-12);
    pusher.newton = std::nan("");
    EXPECT_TRUE(eventually([&] { return live.push() == 0; }));
}

TEST(ArmDrivers, TwoArmsTickBesideEachOther) {
    const Live one, two;
    plug_in(one.word() + ";" + two.word());
    Pusher left, right;
    right.newton = 2;
    auto first = open_of("fake", 0), second = open_of("fake", 1);
    ASSERT_TRUE(first && second);
    ASSERT_TRUE((*first)->start(left.tick()) && (*second)->start(right.tick()));
    ASSERT_TRUE(eventually([&] { return one.push() == 1 && two.push() == 2; }));
    first->reset();
    EXPECT_EQ(one.push(), 0);
    const auto then = right.ticks.load();
    EXPECT_TRUE(eventually([&] { return right.ticks > then + 50; }));
    EXPECT_EQ(two.push(), 2);
    EXPECT_EQ((*second)->status().state, ArmPresence::present);
}

TEST(ArmDrivers, SilenceReachesEveryArm) {
    const Live one, two;
    plug_in(one.word() + ";" + two.word());
    Pusher left, right;
    auto first = open_of("fake", 0), second = open_of("fake", 1);
    ASSERT_TRUE(first && second);
    ASSERT_TRUE((*first)->start(left.tick()) && (*second)->start(right.tick()));
    ASSERT_TRUE(eventually([&] { return one.push() == 1 && two.push() == 1; }));
    silence_arms_and_wait();
    EXPECT_EQ(one.push(), 0);
    EXPECT_EQ(two.push(), 0);
    end_silence();
    EXPECT_TRUE(eventually([&] { return one.push() == 1 && two.push() == 1; }));
}

TEST(ArmDrivers, AnArmIsOpenOnce) {
    plug_in("name=Fake");
    auto arm = open_of("fake").value();
    EXPECT_TRUE(says(message_of(open_of("fake")), "open already"));
    arm.reset();
    EXPECT_TRUE(open_of("fake"));
}

TEST(ArmDrivers, MoreArmsThanThereIsRoomForAreRefused) {
    std::string scripts = "name=Fake";
    for (std::size_t i = 0; i < max_open_arms; ++i) scripts += ";name=Fake";
    plug_in(scripts);
    Pusher pusher;
    std::vector<std::unique_ptr<OpenArm>> arms;
    for (std::size_t i = 0; i <= max_open_arms; ++i) {
        auto arm = open_of("fake", i).value();
        const auto started = arm->start(pusher.tick());
        EXPECT_EQ(started.has_value(), i < max_open_arms) << i;
        arms.push_back(std::move(arm));
    }
}

TEST(ArmDrivers, AFaultEndsTheTicksWithoutForce) {
    const Live live;
    plug_in("vanish=50,control," + live.word());
    Pusher pusher;
    auto arm = open_of("fake").value();
    EXPECT_EQ(arm->facts().serial.find('\x1b'), std::string::npos);
    ASSERT_TRUE(arm->start(pusher.tick()));
    ASSERT_TRUE(eventually([&] { return arm->status().state == ArmPresence::lost; }));
    EXPECT_EQ(arm->status().text.find_first_of("\x1b\n"), std::string::npos) << arm->status().text;
    EXPECT_TRUE(says(arm->status().text, "plug it in again"));
    EXPECT_EQ(pusher.ticks, 49U);
    EXPECT_EQ(live.push(), 0);
}

TEST(ArmDrivers, AnAbsentArmIsSaidToBe) {
    plug_in("absent");
    EXPECT_TRUE(says(message_of(open_of("fake")), "plug it in again"));
}

// ---- drivers that hang, fail or return wrong values -------------------------------------------------------

TEST(ArmDrivers, FactsAreChecked) {
    told_peak = 1;
    const auto arm = open_of("aa").value();
    const auto& facts = arm->facts();
    EXPECT_LE(facts.spec.name.size(), 100U);
    EXPECT_EQ(facts.serial.find_first_of("\x1b\x07"), std::string::npos);
    EXPECT_EQ(facts.spec.workspace, vec3(0.1, 0, 0));
    EXPECT_EQ(facts.spec.max_stiffness, 0);
    EXPECT_LE(facts.spec.sensed, 16);
}

TEST(ArmDrivers, AnArmOfUnknownForceIsRefusedAndClosed) {
    for (const double peak : {0.0, -1.0, 1e300, static_cast<double>(NAN)}) {
        told_peak = peak;
        const int before = closed;
        EXPECT_TRUE(says(message_of(open_of("aa")), "how much force")) << peak;
        EXPECT_EQ(closed, before + 1);
    }
    told_peak = 1;
}

TEST(ArmDrivers, AStartThatFailsIsALine) {
    Pusher pusher;
    start_fails = true;
    const auto arm = open_of("aa").value();
    const auto started = arm->start(pusher.tick());
    start_fails = false;
    ASSERT_FALSE(started);
    EXPECT_EQ(started.error().message.find('\n'), std::string::npos);
    EXPECT_EQ(pusher.ticks, 0U);
}

/// A call of `open` that hangs is abandoned after a time limit. The driver is refused until the call returns,
/// and the arm is then closed.
TEST(ArmDrivers, AnOpenThatHangsIsGivenUp) {
    open_hangs = true;
    const int before = closed;
    EXPECT_TRUE(says(message_of(open_of("zz", 0, {.open_ns = 50 * ns_per_ms})), "hangs"));
    EXPECT_TRUE(arms_hang());
    EXPECT_TRUE(says(message_of(open_of("zz")), "still hangs"));
    EXPECT_TRUE(open_of("aa")) << "another driver is not refused";
    open_hangs = false;
    EXPECT_TRUE(eventually([&] { return !arms_hang() && closed > before; }));
    EXPECT_TRUE(open_of("zz"));
}

TEST(ArmDrivers, ACloseThatHangsIsGivenUpWithoutForce) {
    Pusher pusher;
    auto arm = open_of("zz", 0, {.close_ns = 50 * ns_per_ms}).value();
    ASSERT_TRUE(arm->start(pusher.tick()));
    ASSERT_TRUE(eventually([&] { return last_force == 1; }));
    close_hangs = true;
    arm.reset();
    EXPECT_EQ(last_force, 0);
    EXPECT_TRUE(arms_hang());
    close_hangs = false;
    EXPECT_TRUE(eventually([&] { return !arms_hang(); }));
}

/// A read never returns. The arm is lost after 0.5 s, and closing it waits no longer than necessary. The test
/// runs in a process of its own, because the process can never use the driver again.
TEST(ArmDrivers, AReadThatHangsIsALostArm) {
    ::testing::FLAGS_gtest_death_test_style = "fast";
    plug_in("hang=50");
    const auto lose = [] {
        Pusher pusher;
        auto arm = open_of("fake");
        if (!arm || !(*arm)->start(pusher.tick())) std::_Exit(9);
        if (!eventually([&] { return says((*arm)->status().text, "ticks have stopped"); })) std::_Exit(8);
        const auto begun = monotonic_ns();
        arm->reset();
        if (monotonic_ns() > begun + 5'000 * ns_per_ms) std::_Exit(7);
        const auto again = open_of("fake");
        std::_Exit(arms_hang() && !again && pusher.ticks == 49 ? 0 : 6);
    };
    EXPECT_EXIT(lose(), ::testing::ExitedWithCode(0), "");
}

// ---- the watchdog ends the force when a call hangs --------------------------------------------------------

/// An open arm with a program that makes it exert a force of 1 N.
struct Pushed {
    Pusher pusher{};
    std::unique_ptr<OpenArm> arm{};

    explicit Pushed(std::string_view driver) {
        arm = std::move(*open_of(driver));
        EXPECT_TRUE(arm->start(pusher.tick()));
        EXPECT_TRUE(eventually([] { return last_force == 1; }));
    }
};

/// A read or a write of the driver hangs, and nothing closes the arm. The watchdog alone must end the force.
/// If ticks come again after all, the force returns, but gradually.
TEST(ArmDrivers, ACallThatHangsLeavesNoForce) {
    for (auto* hangs : {&read_hangs, &write_hangs}) {
        const Pushed pushed("aa");
        *hangs = true;
        EXPECT_TRUE(eventually([] { return last_force == 0; }));
        max_change = 0;
        *hangs = false;
        EXPECT_TRUE(eventually([] { return last_force == 1; }));
        EXPECT_LT(max_change, 0.05) << "of 1 N";
        EXPECT_EQ(pushed.arm->status().state, ArmPresence::present);
    }
}

/// The watchdog (a thread that ends the force of an arm that hangs) has ended a force. Then a delayed write
/// sets another force, which the watchdog must end, too.
TEST(ArmDrivers, AForceThatComesLateIsEndedAgain) {
    const Pushed pushed("aa");
    write_hangs = true;
    for (int round = 0; round < 3; ++round) {
        EXPECT_TRUE(eventually([] { return last_force == 0; }));
        last_force = 1;
    }
    EXPECT_TRUE(eventually([] { return last_force == 0; }));
    write_hangs = false;
}

TEST(ArmDrivers, AnArmIsGivenUpWhereThatIsAllItsLibraryAllows) {
    const Pushed pushed("lets go");
    const int before = given_up;
    read_hangs = true;
    EXPECT_TRUE(eventually([] { return last_force == 0; }));
    EXPECT_GT(given_up, before);
    read_hangs = false;
}

/// The driver says that the arm's library allows calls from one thread only. The watchdog runs in another
/// thread, so it must call nothing, and cannot end the force of an arm that hangs.
TEST(ArmDrivers, ALibraryThatTakesNoSecondThreadGetsNone) {
    const Pushed pushed("keeps");
    const int before = given_up;
    read_hangs = true;
    EXPECT_TRUE(eventually([&] { return pushed.arm->status().state == ArmPresence::lost; }));
    EXPECT_EQ(last_force, 1);
    EXPECT_EQ(given_up, before);
    read_hangs = false;
}

/// The watchdog gives up an arm (ends its use) only to end a force. If the arm has none, a read that hangs
/// makes it count as lost, but the watchdog must not give it up.
TEST(ArmDrivers, AnArmThatRestsIsNotGivenUp) {
    Pushed pushed("lets go");
    pushed.pusher.newton = 0;
    EXPECT_TRUE(eventually([] { return last_force == 0; }));
    const auto then = pushed.pusher.ticks.load();
    EXPECT_TRUE(eventually([&] { return pushed.pusher.ticks > then + 2; }));
    const int before = given_up;
    read_hangs = true;
    EXPECT_TRUE(eventually([&] { return pushed.arm->status().state == ArmPresence::lost; }));
    read_hangs = false;
    EXPECT_EQ(given_up, before);
}

// ---- ends of the program ----------------------------------------------------------------------------------

/// Two open arms that exert forces while the program ends.
struct TwoPushed {
    Pusher left{}, right{};
    std::unique_ptr<OpenArm> first{}, second{};

    void start(const Live& one, const Live& two) {
        first = std::move(*open_of("fake", 0));
        second = std::move(*open_of("fake", 1));
        if (!first->start(left.tick()) || !second->start(right.tick())) std::_Exit(9);
        if (!eventually([&] { return one.push() == 1 && two.push() == 1; })) std::_Exit(8);
    }
};

/// Runs a program that exerts forces with two arms and is ended by a signal. Neither arm may keep its force.
void expect_end(const std::function<void(const Live&, const Live&)>& program, int signal) {
    ::testing::FLAGS_gtest_death_test_style = "fast";
    const Live one, two;
    plug_in(one.word() + ";" + two.word());
    EXPECT_EXIT(program(one, two), ::testing::KilledBySignal(signal), "");
    EXPECT_EQ(one.now().max_force, 1);
    EXPECT_EQ(two.now().max_force, 1);
    EXPECT_EQ(one.push(), 0);
    EXPECT_EQ(two.push(), 0);
}

[[noreturn]] void wait_for_the_end() {
    for (;;) std::this_thread::sleep_for(std::chrono::seconds(1));
}

void push_and_get(int signal, const Live& one, const Live& two) {
    static TwoPushed arms;
    arms.start(one, two);
    ::kill(::getpid(), signal);
    wait_for_the_end();
}

TEST(ArmEnds, EveryArmIsWithoutForceAfterASignal) {
    expect_end([](auto& one, auto& two) { push_and_get(SIGTERM, one, two); }, SIGTERM);
}

TEST(ArmEnds, EveryArmIsWithoutForceAfterAFaultOfTheMainThread) {
    expect_end([](auto& one, auto& two) { push_and_get(SIGSEGV, one, two); }, SIGSEGV);
}

/// The servo thread of one arm crashes. The other arm's thread must still end the force of its arm.
TEST(ArmEnds, EveryArmIsWithoutForceAfterAFaultOfOneArmsThread) {
    const auto fail_in_a_tick = [](const Live&, const Live&) {
        static Pusher pusher;
        static std::atomic<int> ticks{0};
        const auto faulty = [](void*, const ArmReading&) {
            if (++ticks == 200) std::raise(SIGSEGV);
            return vec3(0, 0, 1);
        };
        const auto first = std::move(*open_of("fake", 0));
        const auto second = std::move(*open_of("fake", 1));
        if (!first->start(pusher.tick()) || !second->start({faulty, nullptr})) std::_Exit(9);
        wait_for_the_end();
    };
    expect_end(fail_in_a_tick, SIGSEGV);
}

}  // namespace
}  // namespace thaum::input

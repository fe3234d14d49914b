// Tests of the OpenHaptics driver with a fake libHD.so, which enforces the library's rules and fails on
// request.
#include <dlfcn.h>
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <thread>

#include "core/file.h"
#include "drivers/fake_hd/fake_hd.h"
#include "input/open_arm.h"
#include "unit/message_of.h"

namespace thaum::input {
namespace {

using std::chrono::milliseconds;

void* fake() {
    static void* library = ::dlopen(FAKE_HD, RTLD_LAZY | RTLD_GLOBAL);
    return library;
}

template <class F>
F function(const char* name) {
    return reinterpret_cast<F>(::dlsym(fake(), name));
}

FakeHdReport report() { return function<FakeHdReport (*)()>("fakeHdReport")(); }

void tell(const std::string& words) { ::setenv("FAKE_HD", words.c_str(), 1); }

/// Waits until the condition holds. The time limit is long enough for the slowest machine.
template <class F>
bool soon(F holds) {
    for (int i = 0; i < 5000; ++i) {
        if (holds()) return true;
        std::this_thread::sleep_for(milliseconds(1));
    }
    return false;
}

void expect_no_rule_broken() {
    const auto broken = report().broken;
    for (std::size_t rule = 0; rule < broken.size(); ++rule) EXPECT_EQ(broken[rule], 0U) << "rule " << rule;
}

/// Opens the arm that the driver finds with this library.
Expected<std::unique_ptr<OpenArm>> open_by(const std::string& library) {
    ::setenv("THAUM_LIBHD", library.c_str(), 1);
    for (const auto& place : arm_places())
        if (place.kind->name == "openhaptics") return open_arm(place);
    return fail("the driver is not registered");
}

Expected<std::unique_ptr<OpenArm>> open_fake(const std::string& words = "") {
    tell(words);
    return open_by(FAKE_HD);
}

std::string refusal(const std::string& words) { return message_of(open_fake(words), "opened"); }

bool has(const std::string& line, std::string_view part) { return line.find(part) != std::string::npos; }

/// A program that uses the arm: notes what the arm measures in each tick, and requests a force.
struct Hand {
    std::atomic<std::uint64_t> ticks{0}, unusable{0};
    std::atomic<std::int32_t> x_um{0}, y_urad{0};
    std::atomic<std::uint32_t> buttons{0};
    std::atomic<double> stiffness{0};  // stiffness of the spring to x = 0 (N/m)
    std::atomic<double> push{0};       // force along z (N)

    static vec3 step(void* context, const ArmReading& r) {
        auto& hand = *static_cast<Hand*>(context);
        ++hand.ticks;
        if (!r.usable) return ++hand.unusable, vec3(0);
        hand.x_um = r.position_um[0];
        hand.y_urad = r.rotation_urad[1];
        hand.buttons = r.buttons;
        return {-hand.stiffness * r.position_um[0] * 1e-6, 0, hand.push.load()};
    }
    ArmTick tick() { return {step, this}; }
};

/// A file with the path along which the fake library moves a hand.
struct Way {
    explicit Way(std::string_view lines) { std::ofstream(file) << lines; }
    const TemporaryFolder folder{};
    const std::string file = (folder.path() / "way").string();
};

// ---- opening an arm ---------------------------------------------------------------------------------------

TEST(OpenHaptics, NoLibrary) {
    const auto arm = open_by("/nowhere/libHD.so");
    ASSERT_FALSE(arm);
    const auto& line = arm.error().message;
    EXPECT_TRUE(has(line, "no OpenHaptics: ") && has(line, "/nowhere/libHD.so") && has(line, "THAUM_LIBHD"))
        << line;
    EXPECT_FALSE(has(line, "\n"));
}

TEST(OpenHaptics, AFileThatIsNoLibrary) {
    const Way text("this is no library\n");
    const auto message = message_of(open_by(text.file));
    EXPECT_TRUE(has(message, "no OpenHaptics: ")) << message;
}

TEST(OpenHaptics, TooOldALibrary) {
    const auto arm = open_by(FAKE_HD_OLD);
    ASSERT_FALSE(arm);
    const auto& line = arm.error().message;
    EXPECT_TRUE(has(line, "too old") && has(line, "hdScheduleSynchronous") && has(line, "install")) << line;
}

TEST(OpenHaptics, SaysWhatToDo) {
    EXPECT_TRUE(has(refusal("absent"), "plug it in"));
    EXPECT_TRUE(has(refusal("no_permission"), "may not open its port"));
    EXPECT_TRUE(has(refusal("busy"), "another program has the arm: close it"));
    EXPECT_TRUE(has(refusal("no_licence"), "licence"));
    EXPECT_TRUE(has(refusal("manual"), "not calibrated: put the stylus into its inkwell"));
    EXPECT_TRUE(has(refusal("mute"), "does not say how much force"));
    EXPECT_EQ(refusal("no_null_name"), "opened");
    EXPECT_EQ(refusal("needs_update"), "opened");
    expect_no_rule_broken();
}

TEST(OpenHaptics, ARefusalLeavesItFreeToBeOpened) {
    EXPECT_NE(refusal("manual"), "opened");
    EXPECT_EQ(refusal(""), "opened");
    EXPECT_EQ(refusal(""), "opened");
}

TEST(OpenHaptics, OnlyOneIsOpen) {
    const auto arm = open_fake().value();
    EXPECT_TRUE(has(refusal(""), "open already"));
    EXPECT_TRUE(has(refusal(""), "open already"));
    EXPECT_EQ(arm->status().state, ArmPresence::present);
}

TEST(OpenHaptics, ReportsSerialDriverAndSpecOfTheArm) {
    const auto arm = open_fake().value();
    const auto& facts = arm->facts();
    EXPECT_EQ(facts.spec.name, "Touch");
    EXPECT_EQ(facts.serial, "F0000001");
    EXPECT_EQ(facts.driver, "3.50.0");
    EXPECT_EQ(facts.spec.sensed, 6);
    EXPECT_EQ(facts.spec.actuated, 3);
    EXPECT_EQ(facts.spec.peak_force, 3.3);
    EXPECT_EQ(facts.spec.continuous_force, 0.88);
    EXPECT_DOUBLE_EQ(facts.spec.max_stiffness, 400);
    EXPECT_DOUBLE_EQ(facts.spec.max_damping, 4);
    EXPECT_NEAR(glm::length(facts.spec.workspace - vec3(0.16, 0.12, 0.07)), 0, 1e-12);
    EXPECT_EQ(facts.spec.update_rate, 1000);
}

// ---- ticks of an arm --------------------------------------------------------------------------------------

TEST(OpenHaptics, TicksByTheRules) {
    Hand hand;
    auto arm = open_fake().value();
    ASSERT_TRUE(arm->start(hand.tick()));
    EXPECT_FALSE(arm->start(hand.tick()));
    ASSERT_TRUE(soon([&] { return hand.ticks > 200; }));
    EXPECT_EQ(arm->status().state, ArmPresence::present);
    const auto times = arm->times();
    EXPECT_GE(times.ticks, 200U);
    EXPECT_GE(times.answer_worst, times.answer_median);
    arm.reset();
    expect_no_rule_broken();
}

/// The simulated hand holds 10 mm to the right against a spring. If forces are in N, positions in m and the
/// frames agree, both springs balance except for the dry friction.
TEST(OpenHaptics, AWallHoldsTheHandAsItsStiffnessSays) {
    const Way right("0 10 0 0 0\n");
    Hand hand;
    hand.stiffness = 200;
    auto arm = open_fake("path=" + right.file).value();
    ASSERT_TRUE(arm->start(hand.tick()));
    ASSERT_TRUE(soon([&] { return hand.ticks > 400; }));
    const auto current = report();
    // The simulated hand holds with 400 N/m: 400 (0.01 - x) = 200 x at the position x (m). Dry friction of
    // 0.26 N can hold the tip up to 0.43 mm away from there.
    EXPECT_NEAR(current.position[0], 0.00667, 0.0005);
    EXPECT_NEAR(current.force[0], -200 * current.position[0], 0.02);
    EXPECT_NEAR(hand.x_um, current.position[0] * 1e6, 56);
    // The fake stylus turns by 10 rad/m.
    EXPECT_NEAR(hand.y_urad, hand.x_um * 10, 560);
    arm.reset();
    expect_no_rule_broken();
}

TEST(OpenHaptics, ButtonsComeThrough) {
    const Way pressing("0 0 0 0 0\n20 0 0 0 2\n400 0 0 0 3\n800 0 0 0 0\n");
    Hand hand;
    const auto arm = open_fake("path=" + pressing.file).value();
    ASSERT_TRUE(arm->start(hand.tick()));
    EXPECT_TRUE(soon([&] { return hand.buttons == 2; }));
    EXPECT_TRUE(soon([&] { return hand.buttons == 3; }));
    EXPECT_TRUE(soon([&] { return hand.buttons == 0; }));
}

TEST(OpenHaptics, NeverMoreThanTheArmGives) {
    Hand hand;
    hand.push = 1e6;
    auto arm = open_fake().value();
    ASSERT_TRUE(arm->start(hand.tick()));
    ASSERT_TRUE(soon([&] { return hand.ticks > 50; }));
    EXPECT_NEAR(report().force[2], 3.3, 1e-9);
    hand.push = std::nan("");
    const auto then = hand.ticks.load();
    ASSERT_TRUE(soon([&] { return hand.ticks > then + 3; }));
    EXPECT_EQ(report().force[2], 0);
    EXPECT_EQ(arm->status().state, ArmPresence::present);
    arm.reset();
    expect_no_rule_broken();
}

TEST(OpenHaptics, LeavesTheArmWithoutForce) {
    Hand hand;
    hand.push = 2;
    auto arm = open_fake().value();
    ASSERT_TRUE(arm->start(hand.tick()));
    ASSERT_TRUE(soon([&] { return report().force[2] == 2; }));
    arm.reset();
    // The force that the last frame has set acts from the next tick on.
    const auto left = report();
    EXPECT_EQ(left.max_force, 2);
    EXPECT_EQ(left.left[2], 0);
    EXPECT_TRUE(soon([&] {
        const auto again = open_fake();
        return again && report().force[2] == 0;
    }));
    expect_no_rule_broken();
}

TEST(OpenHaptics, LeavesTheArmWithoutForceWhateverTheNumberOfItsTask) {
    Hand hand;
    hand.push = 2;
    auto arm = open_fake("task=zero").value();
    ASSERT_TRUE(arm->start(hand.tick()));
    ASSERT_TRUE(soon([&] { return report().force[2] == 2; }));
    arm.reset();
    EXPECT_EQ(report().left[2], 0);
    expect_no_rule_broken();
}

// ---- faults of library and arm ----------------------------------------------------------------------------

TEST(OpenHaptics, AnArmThatVanishesIsLost) {
    Hand hand;
    hand.push = 1;
    auto arm = open_fake("vanish=100").value();
    ASSERT_TRUE(arm->start(hand.tick()));
    ASSERT_TRUE(soon([&] { return arm->status().state != ArmPresence::present; }));
    EXPECT_EQ(arm->status().state, ArmPresence::lost);
    EXPECT_TRUE(has(arm->status().text, "plug it in")) << arm->status().text;
    EXPECT_TRUE(soon([&] { return report().force[2] == 0; }));
    const auto ticks = hand.ticks.load();
    EXPECT_LT(ticks, 110U);
    std::this_thread::sleep_for(milliseconds(20));
    EXPECT_EQ(hand.ticks, ticks);
    arm.reset();
    expect_no_rule_broken();
    EXPECT_EQ(refusal(""), "opened");
}

TEST(OpenHaptics, WarmMotorsAreAFault) {
    Hand hand;
    auto arm = open_fake("warm=50").value();
    ASSERT_TRUE(arm->start(hand.tick()));
    ASSERT_TRUE(soon([&] { return arm->status().state == ArmPresence::fault; }));
    EXPECT_TRUE(has(arm->status().text, "too warm"));
    EXPECT_EQ(caption_of(arm->status()), "The arm's motors are too warm: let them rest");
    arm.reset();
    expect_no_rule_broken();
}

TEST(OpenHaptics, TicksThatStopAreALostArm) {
    Hand hand;
    auto arm = open_fake("stop=60").value();
    ASSERT_TRUE(arm->start(hand.tick()));
    // Waits for these words, because a library that gets no processor for 0.5 s before its first tick counts
    // as lost for another reason.
    ASSERT_TRUE(soon([&] { return has(arm->status().text, "ticks have stopped"); }));
    EXPECT_EQ(arm->status().state, ArmPresence::lost);
    EXPECT_EQ(caption_of(arm->status()), "The arm's ticks have stopped: plug it in again");
    arm.reset();
    expect_no_rule_broken();
}

TEST(OpenHaptics, WhatIsNoNumberIsSaidToBeNone) {
    Hand hand;
    const auto arm = open_fake("nan=50").value();
    ASSERT_TRUE(arm->start(hand.tick()));
    ASSERT_TRUE(soon([&] { return hand.ticks > 150; }));
    EXPECT_GT(hand.unusable, 0U);
    EXPECT_LE(hand.unusable, 10U);
    EXPECT_EQ(arm->status().state, ArmPresence::present);
}

TEST(OpenHaptics, LateTicksAreCounted) {
    Hand hand;
    const auto arm = open_fake("late=20").value();
    ASSERT_TRUE(arm->start(hand.tick()));
    ASSERT_TRUE(soon([&] { return hand.ticks > 200; }));
    const auto times = arm->times();
    EXPECT_GE(times.missed, 4U * 9U);  // nine or more late ticks, with four missed ticks each
    EXPECT_GE(times.jitter_worst, 4000);
}

// ---- two arms ---------------------------------------------------------------------------------------------

FakeHdReport report_of(int arm) { return function<FakeHdReport (*)(int)>("fakeHdReportOf")(arm); }

/// The default arm and the arm named Right, each with its own script.
struct TwoArms {
    std::unique_ptr<OpenArm> first{}, second{};
    Hand left{}, right{};

    TwoArms(const std::string& words, const std::string& second_words) {
        tell(words);
        ::setenv("FAKE_HD_SECOND", second_words.c_str(), 1);
        ::setenv("THAUM_HD_ARMS", "Default Device,Right", 1);
        first = opened(0);
        second = opened(1);
    }
    ~TwoArms() {
        ::unsetenv("FAKE_HD_SECOND");
        ::unsetenv("THAUM_HD_ARMS");
    }
    TwoArms(const TwoArms&) = delete;
    TwoArms& operator=(const TwoArms&) = delete;

    static Expected<std::unique_ptr<OpenArm>> try_to_open(std::size_t number) {
        ::setenv("THAUM_LIBHD", FAKE_HD, 1);
        for (const auto& place : arm_places())
            if (place.kind->name == "openhaptics" && number-- == 0) return open_arm(place);
        return fail("no such arm");
    }
    static std::unique_ptr<OpenArm> opened(std::size_t number) { return try_to_open(number).value(); }
    bool start() { return first && second && first->start(left.tick()) && second->start(right.tick()); }
    bool pushes(double left_n, double right_n) const {
        return report_of(0).force[2] == left_n && report_of(1).force[2] == right_n;
    }
};

/// Each hand is held at another place, and each arm gets another force. Neither may affect the other arm.
TEST(OpenHaptics, TwoArmsHaveTheirOwnPlacesAndForces) {
    const Way right("0 10 0 0 0\n"), left("0 -10 0 0 1\n");
    TwoArms arms("path=" + left.file, "path=" + right.file);
    arms.left.push = 1;
    arms.right.push = 2;
    ASSERT_TRUE(arms.start());
    EXPECT_EQ(arms.first->facts().serial, "F0000001");
    EXPECT_EQ(arms.second->facts().serial, "F0000002");
    ASSERT_TRUE(soon([&] { return arms.left.ticks > 300 && arms.right.ticks > 300; }));
    EXPECT_NEAR(arms.left.x_um, -10'000, 700);
    EXPECT_NEAR(arms.right.x_um, 10'000, 700);
    EXPECT_EQ(arms.left.buttons, 1U);
    EXPECT_EQ(arms.right.buttons, 0U);
    EXPECT_TRUE(arms.pushes(1, 2));
    EXPECT_EQ(arms.first->status().state, ArmPresence::present);
    EXPECT_EQ(arms.second->status().state, ArmPresence::present);
    expect_no_rule_broken();
}

/// The library's thread must stop while an arm is opened or closed; the other arm then has no force.
TEST(OpenHaptics, OpeningAndClosingOneLeavesTheOther) {
    TwoArms arms("", "");
    arms.left.push = 1;
    arms.right.push = 2;
    arms.second.reset();
    ASSERT_TRUE(arms.first->start(arms.left.tick()));
    ASSERT_TRUE(soon([&] { return report_of(0).force[2] == 1; }));
    const auto stops = report_of(0).stops;
    arms.second = TwoArms::opened(1);
    ASSERT_TRUE(arms.second && arms.second->start(arms.right.tick()));
    EXPECT_GT(report_of(0).stops, stops);
    EXPECT_TRUE(soon([&] { return arms.pushes(1, 2); }));
    arms.first.reset();
    EXPECT_EQ(report_of(0).left[2], 0);
    const auto then = arms.right.ticks.load();
    EXPECT_TRUE(soon([&] { return arms.right.ticks > then + 50 && report_of(1).force[2] == 2; }));
    EXPECT_EQ(arms.second->status().state, ArmPresence::present);
    EXPECT_EQ(report_of(1).stops_with_force, 0U);
    expect_no_rule_broken();
    arms.second.reset();
    EXPECT_EQ(report_of(1).left[2], 0);
}

/// The program tries to open a lost arm again and again. That must not stop the other arm each time.
TEST(OpenHaptics, AnArmThatIsGoneDoesNotDisturbTheOther) {
    TwoArms arms("", "vanish=100,back=1000000");
    arms.left.push = arms.right.push = 1;
    ASSERT_TRUE(arms.start());
    ASSERT_TRUE(soon([&] { return arms.second->status().state == ArmPresence::lost; }));
    EXPECT_TRUE(soon([&] { return report_of(1).force[2] == 0; }));
    arms.second.reset();
    EXPECT_TRUE(has(TwoArms::try_to_open(1).error().message, "plug it in"));
    const auto stops = report_of(0).stops;
    for (int i = 0; i < 20; ++i) EXPECT_TRUE(has(TwoArms::try_to_open(1).error().message, "plug it in"));
    EXPECT_EQ(report_of(0).stops, stops);
    const auto then = arms.left.ticks.load();
    EXPECT_TRUE(soon([&] { return arms.left.ticks > then + 50 && report_of(0).force[2] == 1; }));
    EXPECT_EQ(arms.first->status().state, ArmPresence::present);
    EXPECT_EQ(report_of(0).stops_with_force, 0U);
    expect_no_rule_broken();
}

/// One thread of the library serves both arms. If one arm's step crashes, neither keeps its force.
TEST(ArmEnds, AFaultInTheLibrarysThreadLeavesNoArmWithAForce) {
    ::testing::FLAGS_gtest_death_test_style = "fast";
    const Way one(""), two("");
    const auto faulty = [](void* context, const ArmReading&) {
        if (++*static_cast<std::atomic<int>*>(context) == 200) std::raise(SIGSEGV);
        return vec3(0, 0, 1);
    };
    const auto fail_in_a_tick = [&] {
        static std::atomic<int> ticks{0};
        TwoArms arms("live=" + one.file, "live=" + two.file);
        arms.left.push = 1;
        if (!arms.first->start(arms.left.tick()) || !arms.second->start({faulty, &ticks})) std::_Exit(9);
        for (;;) std::this_thread::sleep_for(milliseconds(100));
    };
    EXPECT_EXIT(fail_in_a_tick(), ::testing::KilledBySignal(SIGSEGV), "");
    for (const auto* way : {&one, &two}) {
        FakeHdLive arm{};
        std::ifstream(way->file, std::ios::binary).read(reinterpret_cast<char*>(&arm), sizeof arm);
        EXPECT_EQ(arm.max_force, 1);
        EXPECT_EQ(arm.force[2], 0);
    }
}

// ---- the fake library itself ------------------------------------------------------------------------------

/// The fake library must count each violation of OpenHaptics' rules; otherwise the tests above prove nothing.
TEST(FakeHd, SeesWhereRulesAreBroken) {
    tell("");
    using Handle = unsigned int;
    const auto init = function<Handle (*)(const char*)>("hdInitDevice");
    const auto begin = function<void (*)(Handle)>("hdBeginFrame");
    const auto end = function<void (*)(Handle)>("hdEndFrame");
    const auto get = function<void (*)(unsigned int, double*)>("hdGetDoublev");
    const auto set = function<void (*)(unsigned int, const double*)>("hdSetDoublev");
    const auto start = function<void (*)()>("hdStartScheduler");
    const auto stop = function<void (*)()>("hdStopScheduler");
    const auto disable = function<void (*)(Handle)>("hdDisableDevice");
    const auto handle = init(nullptr);
    double numbers[16] = {3300};
    get(0x2050, numbers);
    begin(handle), begin(handle), end(handle), end(handle);
    numbers[0] = 3300;
    begin(handle), set(0x2700, numbers), end(handle);
    begin(handle + 1);
    start();
    begin(handle);
    disable(handle);
    stop();
    const auto broken = report().broken;
    EXPECT_EQ(broken[fake_hd_outside_frame], 1U);
    EXPECT_EQ(broken[fake_hd_unpaired], 2U);
    EXPECT_EQ(broken[fake_hd_wrong_units], 1U);
    EXPECT_EQ(broken[fake_hd_wrong_value], 1U);
    EXPECT_EQ(broken[fake_hd_wrong_thread], 1U);
    EXPECT_EQ(broken[fake_hd_wrong_order], 1U);
}

}  // namespace
}  // namespace thaum::input

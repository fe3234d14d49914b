// Tests of HID jackets: the bytes of their reports, and that a jacket that is pulled out, refuses reports or
// is slow leaves no motor on. The byte traces in tests/tactile were written by hand from the layout in
// game/jackets/hid_report.h.
#include "game/jackets/makers/hid.h"

#include <gtest/gtest.h>

#include <limits>

#include "game/jackets/hid_report.h"
#include "game/live/tactile.h"
#include "unit/jacket_rig.h"
#include "unit/message_of.h"

namespace thaum::game {
namespace {

using input::rig::jacket_frame;
using input::rig::trace;

std::string bytes_of(const HidReport& report) { return {report.begin(), report.end()}; }
const std::string& silent_report() {
    static const auto bytes = trace("hid_silent.hex");
    return bytes;
}
tactile::TactileFrame some_frame() {
    return jacket_frame(40, {{0, 1.0F}, {19, 0.33F}, {6, 0.06F}, {20, 0.8F}, {39, 1.0F}});
}

TEST(HidReport, HasTheBytesOfTheTraces) {
    EXPECT_EQ(bytes_of(hid_report(some_frame())), trace("hid_x40.hex"));
    EXPECT_EQ(bytes_of(hid_report({})), silent_report());
}

TEST(HidReport, EachActuatorHasAPlaceOfItsOwn) {
    std::array<bool, hid_motors> taken{};
    for (std::size_t actuator = 0; actuator < hid_motors; ++actuator) {
        const auto report = hid_report(jacket_frame(40, {{actuator, 1.0F}}));
        int lit = 0;
        for (std::size_t motor = 0; motor < hid_motors; ++motor) {
            const unsigned strength = report.at(1 + motor / 2) >> (motor % 2 == 0 ? 4U : 0U) & 0xFU;
            if (strength == 0) continue;
            EXPECT_EQ(strength, 15U);
            EXPECT_FALSE(taken.at(motor)) << actuator;
            taken.at(motor) = true;
            ++lit;
            const bool back = motor >= 10 && motor < 30;
            EXPECT_EQ(back, actuator >= 20) << actuator;
            EXPECT_EQ(motor >= 20, actuator % 4 >= 2) << "columns on the wearer's right come last";
        }
        EXPECT_EQ(lit, 1) << actuator;
    }
}

TEST(HidReport, AnyAmplitudesGiveALegalReport) {
    auto frame = jacket_frame(40, {{0, std::nanf("")},
                                   {1, std::numeric_limits<float>::infinity()},
                                   {4, -std::numeric_limits<float>::infinity()},
                                   {5, 7.0F}});
    EXPECT_EQ(hid_report(frame)[1], 0x0FU);
    EXPECT_EQ(hid_report(frame)[2], 0x0FU);
    frame.count = 1;
    EXPECT_EQ(bytes_of(hid_report(frame)), silent_report()) << "motors without an actuator";
}

/// State and settings of a fake device, and the reports that it got.
struct FakeDevice {
    bool plugged{true}, accepts{true}, allowed{true};
    double report_s{};  ///< time that a report takes (s)
    double now_s{10};   ///< time of the jacket's clock (s)
    int opened{}, closed{};
    std::vector<std::string> reports{};

    bool on() const { return !reports.empty() && reports.back() != silent_report(); }
};

class FakePort final : public HidPort {
public:
    explicit FakePort(FakeDevice& device) : device_(device) { ++device.opened; }
    ~FakePort() override { ++device_.closed; }
    bool write(std::span<const std::uint8_t> report) override {
        device_.now_s += device_.report_s;
        if (!device_.plugged || !device_.accepts) return false;
        device_.reports.emplace_back(report.begin(), report.end());
        return true;
    }
    bool is_there() override { return device_.plugged; }

private:
    FakeDevice& device_;
};

std::unique_ptr<input::TactileOutput> jacket_of(FakeDevice& device) {
    return hid_jacket(
        {0x1209, 0xC0DE},
        [&device](const HidId& id) -> Expected<std::unique_ptr<HidPort>> {
            EXPECT_EQ(words_of(id), "1209:c0de");
            if (!device.plugged) return fail("it is not plugged in");
            if (!device.allowed) return fail("you may not write to it");
            return std::make_unique<FakePort>(device);
        },
        [&device] { return device.now_s; });
}

TEST(HidJacket, SendsAReportWhenItChangedAndAfterHalfOfItsTime) {
    FakeDevice device;
    const auto jacket = jacket_of(device);
    EXPECT_EQ(jacket->name(), "HID jacket 1209:c0de");
    ASSERT_TRUE(jacket->open());
    ASSERT_EQ(device.reports, std::vector{silent_report()}) << "motors that were left on stop at once";
    for (const double now_s : {1.0, 1.008, 1.04, 1.0499}) jacket->write(some_frame(), now_s);
    EXPECT_EQ(device.reports.size(), 2U);
    EXPECT_EQ(device.reports.back(), trace("hid_x40.hex"));
    for (const double now_s : {1.051, 1.06, 1.1}) jacket->write(some_frame(), now_s);
    EXPECT_EQ(device.reports.size(), 3U);
    jacket->silence();
    EXPECT_EQ(device.reports.back(), silent_report());
    for (const double now_s : {1.2, 1.9}) jacket->write(jacket_frame(40, {{3, 1e-3F}}), now_s);
    EXPECT_EQ(device.reports.size(), 4U) << "too weak for the jacket, which is silent already";
    EXPECT_TRUE(jacket->is_connected());
    jacket->close();
    EXPECT_EQ(device.closed, 1);
}

TEST(HidJacket, ClosingStopsTheMotors) {
    FakeDevice device;
    auto jacket = jacket_of(device);
    ASSERT_TRUE(jacket->open());
    jacket->write(some_frame(), 1);
    EXPECT_TRUE(device.on());
    jacket.reset();
    EXPECT_FALSE(device.on());
    EXPECT_EQ(device.closed, 1);
}

TEST(HidJacket, OneThatIsPulledOutIsNoticedEvenInSilence) {
    FakeDevice device;
    const auto jacket = jacket_of(device);
    ASSERT_TRUE(jacket->open());
    device.plugged = false;
    EXPECT_FALSE(jacket->is_connected());
    EXPECT_EQ(jacket->fault(), "it is gone");
    EXPECT_EQ(jacket->open().error().message, "it is not plugged in");
    jacket->write(some_frame(), 2);  // a closed jacket ignores calls
    jacket->silence();
    device.plugged = true;
    ASSERT_TRUE(jacket->open());
    EXPECT_EQ(device.reports.back(), silent_report()) << "it may have kept a motor on";
    EXPECT_TRUE(jacket->is_connected());
}

TEST(HidJacket, OneThatRefusesReportsIsClosed) {
    FakeDevice device;
    const auto jacket = jacket_of(device);
    ASSERT_TRUE(jacket->open());
    device.accepts = false;
    jacket->write(some_frame(), 1);
    EXPECT_FALSE(jacket->is_connected());
    EXPECT_EQ(jacket->fault(), "it is gone, or takes no report of 20 bytes");
    EXPECT_EQ(jacket->open().error().message, "it is gone, or takes no report of 20 bytes");
    EXPECT_EQ(device.opened, device.closed);
    device.allowed = false;
    EXPECT_EQ(jacket->open().error().message, "you may not write to it");
}

TEST(HidJacket, OneThatHangsGetsSilenceWhenItTakesReportsAgain) {
    FakeDevice device;
    const auto jacket = jacket_of(device);
    ASSERT_TRUE(jacket->open());
    device.report_s = 0.099;
    jacket->write(some_frame(), 1);
    EXPECT_TRUE(jacket->is_connected()) << "slow, but in time";
    device.report_s = 5;
    jacket->write(jacket_frame(40, {{7, 1.0F}}), 1.2);
    EXPECT_FALSE(device.on()) << "the late report is followed by silence";
    EXPECT_FALSE(jacket->is_connected());
    EXPECT_EQ(jacket->fault(), "it took 5000 ms for a report, more than 100 ms; plug it in directly");
    EXPECT_EQ(device.closed, 1);
    EXPECT_FALSE(jacket->open()) << "it is as slow as before";
    device.report_s = 0.001;
    EXPECT_TRUE(jacket->open());
}

TEST(HidPort, NumbersThatNoDeviceHasAreToldInOneLine) {
    const auto message = message_of(open_hid_port({0xFFFF, 0xFFFE}));
    EXPECT_TRUE(message == "it is not plugged in" || message == "the system lists no HID devices") << message;
}

}  // namespace
}  // namespace thaum::game

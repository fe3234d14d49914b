#include "game/jackets/makers/hid.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "core/one_line.h"
#include "core/text.h"
#include "game/jackets/hid_report.h"
#include "game/jackets/jacket.h"
#include "game/jackets/jacket_output.h"
#include "input/tactile_playback.h"

namespace thaum::game::inline jackets {
namespace {

constexpr std::size_t max_of_name_shown = 100;
constexpr double longest_report_s = 0.1;  ///< longest time that a device may take for a report

class HidJacket final : public JacketOutput {
public:
    HidJacket(const HidId& id, OpenHidPort open, ClockSeconds clock)
        : id_(id), open_(std::move(open)), clock_(std::move(clock)) {}
    ~HidJacket() override { HidJacket::close(); }

    Expected<void> open() override;
    void write(const tactile::TactileFrame& frame, double now_s) override;
    void silence() override;
    bool is_connected() override;
    void close() override;
    std::string name() const override { return text("HID jacket ", words_of(id_)); }

private:
    bool send(const HidReport& report);
    void give_up(std::string fault);

    const HidId id_;
    const OpenHidPort open_;
    const ClockSeconds clock_;
    const HidReport silent_ = hid_report({});
    std::unique_ptr<HidPort> port_{};
    HidReport last_{};       ///< the last report that the device took
    double again_at_s_ = 0;  ///< time at which the last report is sent again (s)
};

Expected<void> HidJacket::open() {
    close();
    auto port = open_(id_);
    if (!port) return port.error();
    port_ = std::move(*port);
    // Stops motors that an earlier program left running.
    if (!send(silent_)) return fail(fault_);
    return {};
}

/// Sends a report. Closes the device and returns false if the report was not sent in time.
bool HidJacket::send(const HidReport& report) {
    const double began_s = clock_();
    if (!port_->write(report)) {
        give_up("it is gone, or takes no report of 20 bytes");
        return false;
    }
    last_ = report;
    const double taken_s = clock_() - began_s;
    if (taken_s <= longest_report_s) return true;
    if (report != silent_) port_->write(silent_);
    give_up(text("it took ", fixed(1e3 * taken_s, 0), " ms for a report, more than ",
                 fixed(1e3 * longest_report_s, 0), " ms; plug it in directly"));
    return false;
}

void HidJacket::give_up(std::string fault) {
    fault_ = std::move(fault);
    port_.reset();
}

void HidJacket::write(const tactile::TactileFrame& frame, double now_s) {
    if (port_ == nullptr) return;
    const auto report = hid_report(frame);
    if (report == last_ && (report == silent_ || now_s < again_at_s_)) return;
    if (!send(report)) return;
    const double life_s = 1e-3 * static_cast<double>(frame.time_to_live);
    again_at_s_ = now_s + std::min(life_s, input::TactilePlayback::longest_life_s) / 2;
}

void HidJacket::silence() {
    if (port_ != nullptr) send(silent_);
}

bool HidJacket::is_connected() {
    if (port_ != nullptr && !port_->is_there()) give_up("it is gone");
    return port_ != nullptr;
}

void HidJacket::close() {
    silence();
    port_.reset();
}

Expected<std::string> read(std::string_view, std::string_view place) {
    if (const auto id = read_hid_id(place)) return words_of(*id);
    return fail("write \"hid:VVVV:PPPP\" with four hexadecimal digits each, as `lsusb` prints them");
}

std::unique_ptr<input::TactileOutput> make(const Jacket& jacket, std::uint32_t) {
    return hid_jacket(read_hid_id(jacket.place).value());
}

std::vector<FoundJacket> find() {
    std::vector<FoundJacket> found;
    for (const auto& [id, name] : hid_devices())
        found.push_back(
            {"HID device", text("\"hid:", words_of(id), "\" is ", printable(name, max_of_name_shown))});
    return found;
}

const JacketRegistration registration({.name = "hid",
                                       .order = 3,
                                       .forms = {{"hid", {"x40", 40}}},
                                       .shown = {"hid:VVVV:PPPP"},
                                       .read = read,
                                       .make = make,
                                       .find = find});

}  // namespace

double steady_seconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

std::unique_ptr<input::TactileOutput> hid_jacket(const HidId& id, OpenHidPort open, ClockSeconds clock) {
    return std::make_unique<HidJacket>(id, std::move(open), std::move(clock));
}

}  // namespace thaum::game::inline jackets

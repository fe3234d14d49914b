// A driver of simulated arms, for tests. It is not part of the product: a test program has the driver if it
// is linked with this file.
//
// $FAKE_ARMS holds a script for each arm, with semicolons between them. A script is a list of words with
// commas between them:
//
//     name=MODEL        model of the arm (default Fake); serial numbers are A0, A1, ...
//     peak=N            peak force of the arm (N; default 3.3)
//     path=FILE         positions of the hand: lines "ms x_mm y_mm z_mm buttons", with straight motion
//                       between them
//     live=FILE         file with the arm's forces (a FakeHdLive), kept up to date while the program runs
//     felt              the numbers of ticks below are counted from the first tick with a force
//     vanish=N          from tick N on, reading fails, as if the arm were unplugged
//     back=K            after a vanish, opening fails K times and then succeeds
//     hang=N            from tick N on, reading never returns
//     absent            opening fails
//     control           the arm's name and messages contain control codes of a terminal
#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <map>
#include <mutex>
#include <sstream>
#include <thread>

#include "drivers/fake_hd/fake_hd.h"
#include "drivers/fake_hd/script.h"
#include "haptics/simulated.h"
#include "input/arm_driver.h"

namespace {

using namespace thaum;
using namespace thaum::input;
using fake_hd::Script;

constexpr ArmFault gone = 1;

std::vector<std::string> scripts() {
    std::vector<std::string> all;
    const char* told = std::getenv("FAKE_ARMS");
    std::istringstream in(told != nullptr ? told : "");
    for (std::string script; std::getline(in, script, ';');) all.push_back(script);
    return all;
}

/// State that an arm keeps while no program uses it.
struct Plugged {
    bool went_wrong = false, came_back = false;
    std::uint64_t refused = 0;
};

Plugged& plugged(const std::string& arm) {
    static std::mutex mutex;
    static std::map<std::string, Plugged> all;
    const std::lock_guard lock(mutex);
    return all[arm];
}

FakeHdLive* map_live(const std::string& file) {
    const int fd = ::open(file.c_str(), O_RDWR | O_CREAT, 0600);
    if (fd < 0 || ::ftruncate(fd, sizeof(FakeHdLive)) != 0) return nullptr;
    void* memory = ::mmap(nullptr, sizeof(FakeHdLive), PROT_READ | PROT_WRITE, MAP_SHARED, fd, 0);
    ::close(fd);
    return memory == MAP_FAILED ? nullptr : static_cast<FakeHdLive*>(memory);
}

class FakeArm final : public ArmDriver {
public:
    explicit FakeArm(std::string arm) : arm_(std::move(arm)), plugged_(plugged(arm_)) {
        const auto all = scripts();
        const auto number = std::strtoull(arm_.c_str(), nullptr, 10);
        script_ = fake_hd::script_of(number < all.size() ? all[number] : "absent");
    }

    Expected<void> open() override {
        if (script_.has("absent") || is_missing())
            return fail("the fake arm does not answer: plug it in again");
        device_ = haptics::simulated_device(device_spec(), haptics::Hand{});
        state_ = haptics::resting_at(place_at(script_.path, 0).target);
        told_ = vec3(0);
        if (script_.has("live")) live_ = map_live(script_.of("live"));
        update_live();
        return {};
    }

    ArmFacts spec() const override {
        ArmFacts facts{.spec = device_spec(), .serial = "A" + arm_, .driver = "test", .family = "fake"};
        if (script_.has("control")) facts.serial = "A\x1b[2J\n" + arm_;
        return facts;
    }

    /// Moves the arm by one tick under the last force that was written.
    ArmFault read(ArmReading& reading) noexcept override {
        const auto place = place_at(script_.path, static_cast<double>(ticks_));
        move(place.target);
        if (is_due("hang"))
            for (;;) std::this_thread::sleep_for(std::chrono::hours(1));
        if (is_due("vanish") && !plugged_.came_back) {
            plugged_.went_wrong = true;
            return gone;
        }
        const vec3 at = haptics::measured_position(device_, state_);
        for (int axis = 0; axis < 3; ++axis)
            reading.position_um[static_cast<std::size_t>(axis)] = quantised(at[axis] * 1e6);
        reading.buttons = static_cast<std::uint32_t>(place.buttons);
        return 0;
    }

    ArmFault write(vec3 force) noexcept override {
        const std::lock_guard lock(mutex_);
        told_ = force;
        update_live();
        return 0;
    }

    ArmStatus status(ArmFault) const override {
        return {ArmPresence::lost, script_.has("control") ? "the arm\x1b[2J is gone\n: plug it in again"
                                                          : "the fake arm is gone: plug it in again"};
    }

    void close() override {
        const std::lock_guard lock(mutex_);
        if (live_ == nullptr) return;
        live_->left = numbers_of(told_);
        live_->force = {};
        live_->initiated = 0;
    }

private:
    haptics::DeviceSpec device_spec() const {
        haptics::DeviceSpec spec{
            .name = script_.has("name") ? script_.of("name") : "Fake", .sensed = 3, .actuated = 3};
        spec.peak_force = script_.has("peak") ? std::strtod(script_.of("peak").c_str(), nullptr) : 3.3;
        spec.continuous_force = 0.88;
        spec.max_stiffness = 400;
        spec.max_damping = 4;
        spec.workspace = {0.16, 0.12, 0.07};
        spec.mass = 0.045;
        spec.damping = 0.2;
        spec.update_rate = 1000;
        return spec;
    }

    void move(vec3 target) noexcept {
        const std::lock_guard lock(mutex_);
        state_ = haptics::step(device_, state_, target, told_);
        ++ticks_;
        if (felt_at_ == 0 && told_ != vec3(0)) felt_at_ = ticks_;
        update_live();
    }

    bool is_due(const char* word) const {
        const auto at = script_.number(word);
        const auto now = !script_.has("felt") ? ticks_ : felt_at_ == 0 ? 0 : ticks_ - felt_at_;
        return at != 0 && now >= at;
    }

    /// Whether the arm has vanished and not come back yet.
    bool is_missing() {
        if (!plugged_.went_wrong || plugged_.came_back) return false;
        if (plugged_.refused++ < script_.number("back")) return true;
        plugged_.came_back = true;
        return false;
    }

    static std::array<double, 3> numbers_of(vec3 v) { return {v.x, v.y, v.z}; }

    void update_live() noexcept {
        if (live_ == nullptr) return;
        live_->force = numbers_of(told_);
        live_->max_force = std::max(live_->max_force, glm::length(told_));
        live_->ticks = ticks_;
        live_->initiated = 1;
    }

    std::string arm_;
    Plugged& plugged_;
    Script script_{};
    haptics::SimulatedDevice device_{};
    haptics::SimulatedState state_{};
    std::mutex mutex_{};  ///< needed because the engine's watchdog writes while a read hangs
    vec3 told_{};         ///< force that the program wrote last (N)
    std::uint64_t ticks_ = 0;
    std::uint64_t felt_at_ = 0;   ///< tick of the first force; 0: none yet
    FakeHdLive* live_ = nullptr;  ///< never unmapped, because a tick that hung may return late
};

std::vector<std::string> find_fakes() {
    std::vector<std::string> arms;
    for (std::size_t i = 0; i < scripts().size(); ++i) arms.push_back(std::to_string(i));
    return arms;
}

std::unique_ptr<ArmDriver> make_fake(const std::string& arm) { return std::make_unique<FakeArm>(arm); }

const ArmDriverRegistration registration({.name = "fake",
                                          .about = "simulated arms of the tests (FAKE_ARMS)",
                                          .find = find_fakes,
                                          .make = make_fake,
                                          .at_hang = AtHang::write_zero});

}  // namespace

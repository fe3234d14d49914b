// Driver for arms of the Phantom class (Touch, Omni, Premium), through the vendor's libHD.so. The library is
// loaded when an arm is opened, and is never linked. Its declarations are our own, made from the documented
// constants and signatures of its C functions. tests/drivers/fake_hd enforces the rules that the library
// probably has.
//
// The library has one servo thread, which calls us for every arm. It is never unloaded, because it cannot be
// loaded twice.
//
// Several arms: $THAUM_HD_ARMS lists their names in the vendor's setup, with commas between them. The library
// has one current device for all threads, so only its own thread may choose among several. Its devices are
// therefore opened and closed while the scheduler stands still, as documented: the other arms are first set
// to zero force.
#include <algorithm>
#include <array>
#include <atomic>
#include <map>
#include <mutex>
#include <sstream>

#include "core/clock.h"
#include "core/environment.h"
#include "core/text.h"
#include "input/arm_driver.h"
#include "input/detail/hd_api.h"

namespace thaum::input {

using namespace hd;

namespace {

// ---- calibration ------------------------------------------------------------------------------------------

/// A calibration, run by the library's thread. It is never destroyed, because the library may run it late.
struct Calibration {
    const Api* api{};
    Handle handle{};
    bool update = false;             ///< true: calibrate the arm; false: only query its state
    std::atomic<bool> asked{false};  ///< true: the library's thread must run the calibration, once
    std::atomic<bool> done{false};
    std::atomic<unsigned int> status{0}, code{0};
};

Calibration& calibration() {
    static Calibration the;
    return the;
}

unsigned int do_calibration(void*) {
    auto& c = calibration();
    if (!c.asked.exchange(false)) return callback_done;
    const auto& api = *c.api;
    api.hdMakeCurrentDevice(c.handle);
    api.hdBeginFrame(c.handle);
    if (c.update)
        api.hdUpdateCalibration(api.hdCheckCalibrationStyle());
    else
        c.status = api.hdCheckCalibration();
    api.hdEndFrame(c.handle);
    c.code = take_error(api);
    c.done = true;
    return callback_done;
}

/// Runs the calibration. Returns its error, or the library's error if the library did not run it.
unsigned int run_calibration(const Api& api, Handle handle, bool update) {
    auto& c = calibration();
    c.api = &api;
    c.handle = handle;
    c.update = update;
    c.status = c.code = 0;
    c.done = false;
    c.asked = true;
    api.hdScheduleSynchronous(do_calibration, nullptr, first_priority);
    c.asked = false;
    const auto refused = take_error(api);
    return c.done ? c.code.load() : refused;
}

/// Calibrates an arm that can do so by itself. Other arms need the user's hand.
Expected<void> calibrate(const Api& api, Handle handle) {
    auto code = run_calibration(api, handle, false);
    if (code == 0 && calibration().status == calibration_needs_update) {
        code = run_calibration(api, handle, true);
        if (code == 0) code = run_calibration(api, handle, false);
    }
    if (code != 0) return fail(advice(api, code));
    if (calibration().status == calibration_ok) return {};
    return fail(
        "the arm is not calibrated: put the stylus into its inkwell (or the arm into its rest position) "
        "until its "
        "light is steady, and start again");
}

constexpr const char* default_arm = "Default Device";

/// Opens the arm with this name. The default arm has several names, of which some systems know only one, so
/// all are tried.
Expected<Handle> init_device(const Api& api, const std::string& arm) {
    unsigned int gravest = 0;
    take_error(api);  // an earlier error is not this arm's fault
    const std::vector<const char*> names =
        arm == default_arm ? std::vector<const char*>{nullptr, default_arm, "Default PHANToM"}
                           : std::vector<const char*>{arm.c_str()};
    for (const char* name : names) {
        const auto handle = api.hdInitDevice(name);
        const auto code = take_error(api);
        if (code == 0 && handle != invalid_handle) return handle;
        gravest = std::max(gravest, code);  // a wrong name has a lower code than a fault of the arm
    }
    return fail(advice(api, gravest));
}

/// The library's servo thread calls this with the number by which the engine finds the arm.
unsigned int on_servo_tick(void* number) {
    const auto ticks = static_cast<std::uint64_t>(reinterpret_cast<std::uintptr_t>(number));
    return run_arm_tick(ticks) ? callback_continue : callback_done;
}

// ---- the driver -------------------------------------------------------------------------------------------

class OpenHaptics;

/// The arms that are open in the library. Never destroyed, because a call that hangs may use it late.
struct Session {
    /// Held while a thread opens or closes an arm, so that only one does at a time.
    std::mutex mutex{};
    std::vector<OpenHaptics*> arms{};  ///< the open arms
    bool running = false;              ///< true: the library's scheduler runs
    /// The last failure to open an arm, and when it was. Trying again stops the ticks of the open arms for a
    /// moment. So while any arm is open, the next try comes later.
    struct Refusal {
        std::int64_t at_ns{};
        std::string line{};
    };
    std::map<std::string, Refusal> refusals{};
};

Session& session() {
    static auto* the = new Session();
    return *the;
}

class OpenHaptics final : public ArmDriver {
public:
    explicit OpenHaptics(std::string arm) : arm_(std::move(arm)) {}

    Expected<void> open() override;
    ArmFacts spec() const override { return facts_; }
    Expected<bool> start(std::uint64_t ticks) override;
    void close() override;
    void give_up() override;

    ArmFault read(ArmReading& reading) noexcept override {
        rests_ = false;
        begin_frame();
        reading = hd::read(*api_, reading.time_ns);
        return take_error(*api_);
    }
    ArmFault write(vec3 force) noexcept override {
        const bool paused = paused_;
        end_frame(paused ? vec3(0) : force);
        const auto fault = take_error(*api_);
        rests_ = paused && fault == 0;
        in_tick_ = false;
        return fault;
    }
    bool write_zero() noexcept override;
    void note(ArmFault fault) noexcept override {
        copy_error_string(*api_, fault, words_.data(), words_.size());
    }

    ArmStatus status(ArmFault fault) const override {
        const bool silent = fault == comm_error || fault == comm_config || fault == timer_error;
        return {silent ? ArmPresence::lost : ArmPresence::fault, advice(fault, words_.data())};
    }

private:
    Expected<void> start_library();
    void leave();
    /// Disables the arm in the library, which ends its force. Done once, by whichever thread comes first.
    void disable() {
        if (handle_ != invalid_handle && !disabled_.exchange(true)) api_->hdDisableDevice(handle_);
    }
    void stop_scheduler() const;
    void go_on() const;
    /// Whether zero force was sent to the arm, or it never had a force.
    bool is_without_force() const { return !ticks_asked_ || ended_ || rests_ || disabled_; }

    void begin_frame() noexcept {
        in_frame_ = in_tick_ = true;
        api_->hdMakeCurrentDevice(handle_);
        api_->hdBeginFrame(handle_);
    }
    void end_frame(vec3 force) noexcept {
        hd::write(*api_, force);
        api_->hdEndFrame(handle_);
        in_frame_ = false;
    }

    std::string arm_;  ///< name of the arm in the vendor's setup
    const Api* api_{};
    Handle handle_ = invalid_handle;
    ArmFacts facts_{};
    /// True: the library was asked to run our ticks, and may have run some.
    std::atomic<bool> ticks_asked_{false};
    std::atomic<unsigned long> task_{0};  ///< the scheduler's number for our ticks, once it accepted them
    std::atomic<bool> accepted_{false};   ///< true: the scheduler has taken our ticks
    std::atomic<bool> in_frame_{false};   ///< true: the servo thread has begun a frame (hdBeginFrame)
    /// true: the servo thread is in a read or write, or between the two.
    std::atomic<bool> in_tick_{false};
    std::atomic<bool> disabled_{false};  ///< true: the library was asked to disable the arm
    std::atomic<bool> paused_{false};    ///< true: ticks give no force, because the scheduler will stop
    std::atomic<bool> rests_{false};     ///< true: the last tick gave zero force because of `paused_`
    std::atomic<bool> ended_{false};     ///< true: the ticks have ended without being stopped by us
    std::atomic<bool> left_without_force_{false};  ///< true: the library accepted the last zero force
    /// true: the arm was closed in the library (`leave`); guarded by the session's mutex.
    bool left_ = false;
    std::array<char, 96> words_{};  ///< the library's text for the fault that ended the ticks
};

/// Sends zero force in the open frame of the library, or in a new one. If that frame has failed, another one
/// is tried. The arm is made the current one first, because after a fault in the library's thread another arm
/// may be current.
bool OpenHaptics::write_zero() noexcept {
    if (in_frame_)
        api_->hdMakeCurrentDevice(handle_);
    else
        begin_frame();
    end_frame(vec3(0));
    ended_ = true;
    left_without_force_ = take_error(*api_) == 0 || write_zero_frame(*api_, handle_);
    in_tick_ = false;
    return left_without_force_;
}

/// Stops the ticks of all arms. Before it does so, the arms other than this one get zero as their last force.
void OpenHaptics::stop_scheduler() const {
    constexpr std::int64_t patience_ns = 200'000'000, look_ns = 200'000;
    auto& s = session();
    if (!s.running) return;
    for (auto* other : s.arms) other->paused_ = other != this;
    const auto until = monotonic_ns() + patience_ns;
    const auto has_stopped = [&](const OpenHaptics* other) {
        return other == this || other->is_without_force();
    };
    while (!std::all_of(s.arms.begin(), s.arms.end(), has_stopped) && monotonic_ns() < until)
        sleep_until_ns(monotonic_ns() + look_ns);
    api_->hdStopScheduler();
    s.running = false;
}

/// Starts the ticks of the open arms again.
void OpenHaptics::go_on() const {
    auto& s = session();
    if (!s.arms.empty() && !s.running) {
        api_->hdStartScheduler();
        s.running = true;
    }
    for (auto* other : s.arms) other->paused_ = false;
}

Expected<void> OpenHaptics::open() {
    constexpr std::int64_t try_again_ns = 5'000'000'000;
    auto& s = session();
    const std::lock_guard lock(s.mutex);
    auto& refusal = s.refusals[arm_];
    if (!s.arms.empty() && refusal.at_ns != 0 && monotonic_ns() < refusal.at_ns + try_again_ns)
        return fail(refusal.line);
    auto opened = start_library();
    if (!opened) leave();
    refusal = opened ? Session::Refusal{} : Session::Refusal{monotonic_ns(), opened.error().message};
    return opened;
}

Expected<void> OpenHaptics::start_library() {
    auto& s = session();
    const auto loaded = load(library_name());
    if (!loaded) return loaded.error();
    api_ = *loaded;
    const auto& api = *api_;
    stop_scheduler();
    const auto handle = init_device(api, arm_);
    if (!handle) return handle.error();
    handle_ = *handle;
    s.arms.push_back(this);
    api.hdMakeCurrentDevice(handle_);
    if (const auto code = take_error(api); code != 0) return fail(advice(api, code));
    facts_ = facts_of(api);
    for (const auto capability : {force_output, max_force_clamping, force_ramping}) api.hdEnable(capability);
    api.hdSetSchedulerRate(servo_hz);
    go_on();
    if (const auto code = take_error(api); code != 0) return fail(advice(api, code));
    return calibrate(api, handle_);
}

Expected<bool> OpenHaptics::start(std::uint64_t ticks) {
    auto* argument = reinterpret_cast<void*>(static_cast<std::uintptr_t>(ticks));
    ticks_asked_ = true;
    const auto task = api_->hdScheduleAsynchronous(on_servo_tick, argument, first_priority);
    if (const auto code = take_error(*api_); code != 0) return fail(advice(*api_, code));
    task_ = task;
    accepted_ = true;
    return true;
}

void OpenHaptics::close() {
    const std::lock_guard lock(session().mutex);
    leave();
}

/// If the library only stopped calling, the arm gets a last zero as in `close`. But stopping the scheduler
/// may hang as well, if the library's only servo thread hangs in a tick of any arm or another thread is
/// opening or closing an arm.
void OpenHaptics::give_up() {
    auto& s = session();
    const std::unique_lock lock(s.mutex, std::try_to_lock);
    if (rests_) return;  // another arm is being opened, and this one already has zero force
    const bool hangs = !lock || std::any_of(s.arms.begin(), s.arms.end(),
                                            [](const auto* arm) { return arm->in_tick_.load(); });
    if (hangs) return disable();
    leave();
}

/// Closes the arm in the library. The ticks of the other arms go on.
void OpenHaptics::leave() {
    auto& s = session();
    if (api_ == nullptr || left_) return;
    left_ = true;
    const bool was_running = s.running;
    stop_scheduler();
    if (handle_ != invalid_handle) {
        if (was_running && ticks_asked_ && !left_without_force_ && !disabled_) {
            api_->hdMakeCurrentDevice(handle_);
            write_zero_frame(*api_, handle_);
        }
        if (accepted_ && !ended_) api_->hdUnschedule(task_);
        disable();
    }
    std::erase(s.arms, this);
    go_on();
    take_error(*api_);
}

// ---- registration -----------------------------------------------------------------------------------------

std::vector<std::string> find_arms() {
    std::istringstream words(environment_value("THAUM_HD_ARMS").value_or(""));
    std::vector<std::string> arms;
    for (std::string arm; std::getline(words, arm, ',');)
        if (!arm.empty() && std::find(arms.begin(), arms.end(), arm) == arms.end()) arms.push_back(arm);
    return arms.empty() ? std::vector<std::string>{default_arm} : arms;
}

std::unique_ptr<ArmDriver> make_arm(const std::string& arm) { return std::make_unique<OpenHaptics>(arm); }

const ArmDriverRegistration registration({.name = "openhaptics",
                                          .about = "Touch, Omni or Premium, by OpenHaptics (THAUM_LIBHD: "
                                                   "path of libHD.so; THAUM_HD_ARMS: names of several arms)",
                                          .find = find_arms,
                                          .make = make_arm,
                                          .at_hang = AtHang::give_up});

}  // namespace
}  // namespace thaum::input

// Driver for arms of the Phantom class (Touch, Omni, Premium), through the vendor's libHD.so. The library is loaded when an arm
// is opened, and is never linked. Its declarations are our own, made from the documented constants and signatures of its C
// functions. tests/drivers/fake_hd enforces the rules that we believe it has.
//
// The library has one servo thread, which calls us. It is never unloaded, because it cannot be loaded twice.
#include <algorithm>
#include <array>
#include <atomic>

#include "core/text.h"
#include "input/arm_driver.h"
#include "input/detail/hd_api.h"

namespace thaum::input {

using namespace hd;

namespace {

// ---- calibration -------------------------------------------------------------------------------------------------------

/// A task in the library's thread. It is never destroyed, because the library may run it late.
struct Calibration {
    const Api* api{};
    Handle handle{};
    bool update = false;             ///< true: the arm shall calibrate itself; false: its state is asked for
    std::atomic<bool> asked{false};  ///< the task runs once
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

/// Runs the task. Returns the error of the task, or that of a library that did not run it.
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

/// Calibrates an arm that can do so itself. Other arms need a hand.
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

/// Takes the default arm. On some systems only one of its names works.
Expected<Handle> init_device(const Api& api) {
    unsigned int gravest = 0;
    take_error(api);  // an earlier error is not this arm's fault
    for (const char* name : {static_cast<const char*>(nullptr), "Default Device", "Default PHANToM"}) {
        const auto handle = api.hdInitDevice(name);
        const auto code = take_error(api);
        if (code == 0 && handle != invalid_handle) return handle;
        gravest = std::max(gravest, code);  // a wrong name has a lower code than a fault of the arm
    }
    return fail(advice(api, gravest));
}

/// The library's servo thread calls this with the number of our ticks.
unsigned int on_servo_tick(void* number) {
    const auto ticks = static_cast<std::uint64_t>(reinterpret_cast<std::uintptr_t>(number));
    return run_arm_tick(ticks) ? callback_continue : callback_done;
}

// ---- the driver --------------------------------------------------------------------------------------------------------

class OpenHaptics final : public ArmDriver {
public:
    Expected<void> open() override {
        auto opened = start_library();
        if (!opened) close();
        return opened;
    }
    ArmFacts spec() const override { return facts_; }

    Expected<bool> start(std::uint64_t ticks) override {
        auto* argument = reinterpret_cast<void*>(static_cast<std::uintptr_t>(ticks));
        ticks_asked_ = true;
        const auto task = api_->hdScheduleAsynchronous(on_servo_tick, argument, first_priority);
        if (const auto code = take_error(*api_); code != 0) return fail(advice(*api_, code));
        task_ = task;
        accepted_ = true;
        return true;
    }

    void close() override {
        if (running_) {
            api_->hdStopScheduler();
            if (ticks_asked_ && !left_without_force_) write_zero_frame(*api_, handle_);
            if (accepted_ && !ended_) api_->hdUnschedule(task_);
        }
        if (handle_ != invalid_handle) api_->hdDisableDevice(handle_);
        if (api_ != nullptr) take_error(*api_);
    }

    void give_up() override {
        if (handle_ != invalid_handle) api_->hdDisableDevice(handle_);
    }

    ArmFault read(ArmReading& reading) noexcept override {
        in_frame_ = true;
        api_->hdBeginFrame(handle_);
        reading = hd::read(*api_, reading.time_ns);
        return take_error(*api_);
    }

    ArmFault write(vec3 force) noexcept override {
        hd::write(*api_, force);
        api_->hdEndFrame(handle_);
        in_frame_ = false;
        return take_error(*api_);
    }

    /// The frame may have failed, so another one is tried.
    bool write_zero() noexcept override {
        if (!in_frame_) api_->hdBeginFrame(handle_);
        hd::write(*api_, vec3(0));
        api_->hdEndFrame(handle_);
        in_frame_ = false;
        ended_ = true;
        left_without_force_ = take_error(*api_) == 0 || write_zero_frame(*api_, handle_);
        return left_without_force_;
    }

    void note(ArmFault fault) noexcept override {
        copy_error_string(*api_, fault, words_.data(), words_.size());
    }

    ArmStatus status(ArmFault fault) const override {
        const bool silent = fault == comm_error || fault == comm_config || fault == timer_error;
        return {silent ? ArmPresence::lost : ArmPresence::fault, advice(fault, words_.data())};
    }

private:
    Expected<void> start_library();

    const Api* api_{};
    Handle handle_ = invalid_handle;
    ArmFacts facts_{};
    bool running_ = false;                         ///< the library's scheduler runs
    std::atomic<bool> ticks_asked_{false};         ///< the library may have called our ticks
    std::atomic<unsigned long> task_{0};           ///< the scheduler's number of our ticks, once accepted
    std::atomic<bool> accepted_{false};            ///< the scheduler has taken our ticks
    std::atomic<bool> in_frame_{false};            ///< the servo thread has begun a frame
    std::atomic<bool> ended_{false};               ///< the ticks have ended by themselves
    std::atomic<bool> left_without_force_{false};  ///< the library took the last zero of the ticks
    std::array<char, 96> words_{};                 ///< the library's words for the fault that ended the ticks
};

Expected<void> OpenHaptics::start_library() {
    const auto loaded = load(library_name());
    if (!loaded) return tl::unexpected(loaded.error());
    api_ = *loaded;
    const auto& api = *api_;
    const auto handle = init_device(api);
    if (!handle) return tl::unexpected(handle.error());
    handle_ = *handle;
    api.hdMakeCurrentDevice(handle_);
    if (const auto code = take_error(api); code != 0) return fail(advice(api, code));
    facts_ = facts_of(api);
    for (const auto capability : {force_output, max_force_clamping, force_ramping}) api.hdEnable(capability);
    api.hdSetSchedulerRate(servo_hz);
    api.hdStartScheduler();
    running_ = true;
    if (const auto code = take_error(api); code != 0) return fail(advice(api, code));
    return calibrate(api, handle_);
}

// ---- registration ------------------------------------------------------------------------------------------------------

std::vector<std::string> find_arms() { return {"Default Device"}; }

std::unique_ptr<ArmDriver> make_arm(const std::string&) { return std::make_unique<OpenHaptics>(); }

const ArmDriverRegistration registration(
    {.name = "openhaptics",
     .about = "Touch, Omni or Premium, by OpenHaptics (THAUM_LIBHD is the path of libHD.so)",
     .find = find_arms,
     .make = make_arm});

}  // namespace
}  // namespace thaum::input

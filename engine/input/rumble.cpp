#include "input/rumble.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <string>
#include <utility>

#include "core/one_line.h"
#include "core/text.h"
#include "input/detail/rumble_effect.h"

// Linux runs the motors of most pads by its module ff-memless. Its effects begin at the next tick of a timer,
// up to 10 ms late. An effect that was changed and is stopped before that tick leaves the motors on for ever.
// So a running effect is never changed. There are two effects: while one runs, the other gets the new values
// and is started, and then the first is stopped. Stopping the first begins the other at once. So neither a
// stop nor the end of the program can leave a motor on.
//
// SDL's own rumble is not used, because it can leave the motors on. It changes the one effect that runs, and
// gives it a length of 65.5 s in Linux, which SDL cuts short only while the program polls it. A program that
// is stopped or hangs would leave the motors on for a minute, and one that is killed between the change of
// the effect and its start would leave them on for ever. SDL also locks all joysticks while it updates them.
// Without SDL, the thread of the motors needs no lock that the thread which polls SDL holds.

namespace thaum::input {
namespace {

constexpr std::size_t max_shown = 60;  ///< longest part of a pad's name in messages (bytes)

/// An open device file; the destructor closes it.
class DeviceFile {
public:
    DeviceFile() = default;
    DeviceFile(const std::string& path, int flags)
        : fd_(::open(path.c_str(), flags | O_NONBLOCK | O_CLOEXEC)) {}
    DeviceFile(DeviceFile&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}
    DeviceFile& operator=(DeviceFile&& other) noexcept {
        std::swap(fd_, other.fd_);
        return *this;
    }
    ~DeviceFile() {
        if (fd_ >= 0) ::close(fd_);
    }

    bool is_open() const { return fd_ >= 0; }
    int fd() const { return fd_; }

private:
    int fd_ = -1;
};

bool runs_rumble(const DeviceFile& file) {
    std::array<std::uint8_t, FF_CNT / 8> bits{};
    int effects = 0;
    return ::ioctl(file.fd(), EVIOCGBIT(EV_FF, bits.size()), bits.data()) >= 0 &&
           (bits.at(FF_RUMBLE / 8) & (1U << (FF_RUMBLE % 8U))) != 0 &&
           ::ioctl(file.fd(), EVIOCGEFFECTS, &effects) >= 0 && effects >= 2;
}

class Rumble final : public TactileOutput {
public:
    Rumble(std::string path, std::string name) : path_(std::move(path)), name_(std::move(name)) {}
    ~Rumble() override { end(); }

    Expected<void> open() override;
    void write(const tactile::TactileFrame& frame, double now_s) override;
    void silence() override;
    bool is_connected() override;
    void close() override { end(); }
    std::string name() const override { return text("pad '", printable(name_, max_shown), "'"); }

private:
    void upload(ff_effect& effect);
    void play(const ff_effect& effect, bool on);
    bool is_running(const ff_effect& wanted) const;
    void end();

    const std::string path_, name_;
    DeviceFile file_{};
    bool failed_ = false;                 ///< true: a call has failed since the device was opened
    std::array<ff_effect, 2> effects_{};  ///< the effects that run in turn; id below 0: not uploaded
    std::size_t current_ = 0;             ///< index of the effect that runs, or ran last
    /// true: the effect was started and not stopped, but it may have ended by itself.
    bool running_ = false;
    double extend_at_s_ = 0;  ///< time at which the running effect is half over and must be extended (s)
};

Expected<void> Rumble::open() {
    DeviceFile file(path_, O_RDWR);
    if (!file.is_open())
        return fail(text("no rumble: ", path_, ": ", std::strerror(errno),
                         errno == EACCES ? "; allow this user to write to it" : ""));
    if (!runs_rumble(file)) return fail("no rumble: it has no motors, or its driver does not run them");
    file_ = std::move(file);
    failed_ = running_ = false;
    for (auto& effect : effects_) effect.id = -1;
    return {};
}

void Rumble::write(const tactile::TactileFrame& frame, double now_s) {
    auto& before = effects_[current_];
    const auto wanted = detail::rumble_effect(frame, -1);
    if (wanted.u.rumble.strong_magnitude == 0 && wanted.u.rumble.weak_magnitude == 0) return silence();
    if (is_running(wanted)) {
        if (now_s < extend_at_s_) return;
        play(before, true);  // starts the effect again, so that its time begins anew without a gap
    } else {
        auto& next = effects_[1 - current_];
        const auto id = next.id;
        next = wanted;
        next.id = id;
        upload(next);
        play(next, true);
        if (running_) play(before, false);
        current_ = 1 - current_;
    }
    running_ = true;
    extend_at_s_ = now_s + 0.5e-3 * wanted.replay.length;
}

/// Tests whether an effect with the wanted strengths and duration runs already.
bool Rumble::is_running(const ff_effect& wanted) const {
    const auto& current = effects_[current_];
    return running_ && current.u.rumble.strong_magnitude == wanted.u.rumble.strong_magnitude &&
           current.u.rumble.weak_magnitude == wanted.u.rumble.weak_magnitude &&
           current.replay.length == wanted.replay.length;
}

void Rumble::silence() {
    if (std::exchange(running_, false)) play(effects_[current_], false);
}

bool Rumble::is_connected() {
    pollfd state{file_.fd(), 0, 0};
    return !failed_ && ::poll(&state, 1, 0) >= 0 && (state.revents & (POLLHUP | POLLERR | POLLNVAL)) == 0;
}

void Rumble::upload(ff_effect& effect) {
    if (::ioctl(file_.fd(), EVIOCSFF, &effect) < 0) failed_ = true;
}

void Rumble::play(const ff_effect& effect, bool on) {
    input_event event{};
    event.type = EV_FF;
    event.code = static_cast<std::uint16_t>(effect.id);
    event.value = on ? 1 : 0;
    if (::write(file_.fd(), &event, sizeof event) != static_cast<ssize_t>(sizeof event)) failed_ = true;
}

void Rumble::end() {
    if (!file_.is_open()) return;
    silence();
    for (auto& effect : effects_)
        if (effect.id >= 0) ::ioctl(file_.fd(), EVIOCRMFF, static_cast<unsigned long>(effect.id));
    file_ = DeviceFile();
}

}  // namespace

std::unique_ptr<TactileOutput> rumble_output(const PadState& pad) {
    return std::make_unique<Rumble>(pad.path, pad.name);
}

}  // namespace thaum::input

// input/tactile_output.h: the interface of devices that play tactile frames: a pad with motors, a jacket, or
// a fake in tests. A TactilePlayer (input/tactile_player.h) calls an output.
#pragma once
#include <string>

#include "core/error.h"
#include "tactile/frame.h"

namespace thaum::input {

/// One device. A single thread makes all calls. It is neither a servo nor the simulation thread, so calls may
/// take a while.
class TactileOutput {
public:
    TactileOutput() = default;
    TactileOutput(const TactileOutput&) = delete;
    TactileOutput& operator=(const TactileOutput&) = delete;
    virtual ~TactileOutput() = default;

    /// Opens the device, or opens it again after `close`. The error is one line without the device's name.
    /// After an error the device is closed.
    virtual Expected<void> open() = 0;
    /// Plays a frame at once, and at most for about its time to live, even if no call follows. `now_s` is the
    /// time of the call on a steady clock. Amplitudes may have any value.
    virtual void write(const tactile::TactileFrame& frame, double now_s) = 0;
    /// Stops all actuators at once.
    virtual void silence() = 0;
    /// False once the device is gone or has refused a call.
    virtual bool is_connected() = 0;
    /// Why the device is no longer connected, as words for one line, without the device's name.
    virtual std::string fault() { return "it is gone"; }
    /// True for a recorder: `write` gets every frame that is not silent, unmerged, and late frames too.
    virtual bool wants_every_frame() const { return false; }
    /// Stops all actuators and frees the device.
    virtual void close() = 0;
    /// Name for messages: "pad 'Microsoft X-Box 360 pad'".
    virtual std::string name() const = 0;
};

}  // namespace thaum::input

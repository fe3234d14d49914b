// input/detail/silence.h: how arm_silence.h ends the forces of all arms. Every function may be called in a
// signal handler.
#pragma once

namespace thaum::input::ticks {

/// If `wanted` is true, every tick from now on gives its arm no force; otherwise ticks give force again.
void silence(bool wanted) noexcept;
/// Between `begin_stop` and `end_stop`, while a signal stops the process, no arm gets a force, whatever
/// `silence` says. Several threads may be between the two calls.
void begin_stop() noexcept;
void end_stop() noexcept;
/// Whether zero force was sent to every open arm.
bool are_silent() noexcept;
/// Whether this thread is the servo thread of an arm. While this thread handles a signal, that arm gets no
/// tick.
bool is_arms_thread() noexcept;
/// Sends zero force to each arm of this servo thread. Called by this thread after a fault or in exit(), when
/// it will never run a tick again.
void end_broken() noexcept;

}  // namespace thaum::input::ticks

// input/detail/silence.h: how arm_silence.h ends the forces of all arms. Every function may be called in a
// signal handler.
#pragma once

namespace thaum::input::ticks {

/// From now on every tick gives its arm no force, or force again.
void silence(bool wanted) noexcept;
/// No force from `begin_stop` to `end_stop`, whatever `silence` says. Several threads may be between the two.
void begin_stop() noexcept;
void end_stop() noexcept;
/// Whether every open arm was told to exert nothing.
bool are_silent() noexcept;
/// Whether this thread is the servo thread of an arm. While it handles a signal, that arm gets no tick.
bool is_arms_thread() noexcept;
/// Tells each arm of this servo thread to exert nothing. For a thread that will never tick again.
void end_broken() noexcept;

}  // namespace thaum::input::ticks

// input/detail/silence.h: what arm_silence.h asks of the ticks. All of it may be called in a signal handler.
#pragma once

namespace thaum::input::hd {

/// Whether ticks from now on tell the arm to exert nothing.
void silence_ticks(bool wanted) noexcept;
/// The same from `begin_stop` to `end_stop`, whatever silence_ticks says. Several threads may be between the two.
void begin_stop() noexcept;
void end_stop() noexcept;
/// Whether the arm was told so, or there is none.
bool ticks_are_silent() noexcept;
/// Whether this thread is the one that ticks: while it handles a signal no tick comes.
bool is_arms_thread() noexcept;
/// For the arm's thread where it will never tick again: tells the arm to exert nothing, in the frame that the fault has left
/// open or in a new one.
void end_broken_tick() noexcept;

}  // namespace thaum::input::hd

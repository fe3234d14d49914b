// input/detail/silence.h: what arm_silence.h asks of the ticks. All of it may be called in a signal handler.
#pragma once

namespace thaum::input::hd {

/// Whether ticks from now on tell the arm to exert nothing.
void silence_ticks(bool wanted) noexcept;
/// Whether the arm was told so, or there is none.
bool ticks_are_silent() noexcept;
/// Whether this thread is the arm's, in a tick: then no other tick comes.
bool is_in_tick() noexcept;
/// Where this thread's fault is in our own step: ends the frame around it without force.
void end_broken_step() noexcept;

}  // namespace thaum::input::hd

// input/arm_silence.h: removes the arm's force when the program ends in any way. A device keeps exerting its
// last command, so the last command must be zero. The arm's own thread sends it. That thread runs as long as
// the process lives, also while another thread handles a signal or aborts.
//
// While a library hangs or stops calling, the engine's watchdog ends the force (detail/stall_watch.h). Nothing helps
// against SIGKILL, SIGSTOP, a power cut or a library that rejects the zero, or if the stack overflows in a thread that
// start_thread did not start. Only the device's own watchdog acts then (input/arm_driver.h).
#pragma once

namespace thaum::input {

/// Makes every arm exert no force from its next tick on, until `end_silence`. For any thread, also in a
/// signal handler.
void silence_arms() noexcept;
void end_silence() noexcept;

/// Calls silence_arms and waits until the arm was told, at most 0.2 s. For any thread, also in a signal
/// handler.
void silence_arms_and_wait() noexcept;

/// Makes the force zero before the process ends by exit(), by quick_exit() or by a signal. That covers faults, aborts (a
/// failed assertion, an uncaught exception), requests to end (SIGTERM, SIGINT, SIGQUIT, SIGHUP), a broken
/// pipe and a limit. The force is also zero while the process is stopped (SIGTSTP, SIGTTIN, SIGTTOU). The
/// process then ends or stops as it would have done otherwise. Signals that are ignored or handled elsewhere
/// stay unchanged, and so do real-time signals, which libraries use. A second call does nothing.
void guard_ends();

}  // namespace thaum::input

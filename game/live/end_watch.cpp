#include "game/live/end_watch.h"

#include "core/tell_user.h"
#include "input/arm_silence.h"

namespace thaum::game::inline live {
namespace {

std::atomic<bool> end_asked{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler sets it");

void note_signal(int) {
    input::silence_arms();
    end_asked = true;
}

}  // namespace

EndWatch::EndWatch() {
    end_asked = false;
    input::end_silence();
    for (std::size_t i = 0; i < signals.size(); ++i) {
        struct sigaction action {};
        action.sa_handler = note_signal;
        action.sa_flags = static_cast<int>(SA_RESETHAND);
        ::sigaction(signals[i], &action, &before_[i]);
    }
}

EndWatch::~EndWatch() {
    for (std::size_t i = 0; i < signals.size(); ++i) ::sigaction(signals[i], &before_[i], nullptr);
}

const std::atomic<bool>& EndWatch::asked() { return end_asked; }

void tell_end_by_signal() {
    if (end_asked) tell_user("ended by a signal");
}

}  // namespace thaum::game::inline live

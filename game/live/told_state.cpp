#include "game/live/told_state.h"

#include "core/tell_user.h"
#include "core/text.h"

namespace thaum::game::inline live {

void ToldState::tell(const std::string& whose, std::string state, std::uint64_t times_opened) {
    if (state.empty() || state == told_) return;
    if (!told_.empty() || times_opened == 0) tell_user(text(whose, state));
    told_ = std::move(state);
}

}  // namespace thaum::game::inline live

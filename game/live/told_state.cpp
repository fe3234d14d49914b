#include "game/live/told_state.h"

#include <cstdio>

namespace thaum::app {

void ToldState::tell(const std::string& whose, std::string state, std::uint64_t times_opened) {
    if (state.empty() || state == told_) return;
    if (!told_.empty() || times_opened == 0) std::fprintf(stderr, "%s%s\n", whose.c_str(), state.c_str());
    told_ = std::move(state);
}

}  // namespace thaum::app

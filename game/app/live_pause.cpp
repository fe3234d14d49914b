#include "game/app/live_pause.h"

#include "core/text.h"
#include "game/app/live_hands.h"

namespace thaum::app {

PauseWords pause_words(std::uint32_t paused_by, const std::array<bool, game::players>& pad_lost) {
    for (std::size_t p = game::players; p-- > 0;) {
        if (pad_lost[p])
            return {text("Player ", p + 1, ": pad lost"),
                    text(how_to_rejoin, ", or keypad 0 for half of the keyboard")};
    }
    return {"Paused", paused_by < game::players ? text("by player ", paused_by + 1) : std::string()};
}

}  // namespace thaum::app

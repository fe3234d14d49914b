#include "game/live/live_pause.h"

#include "core/text.h"
#include "game/live/live_hands.h"

namespace thaum::app {

namespace {

/// "Pad 1 of Ember is not plugged in", or the like for two pads; empty if no pad is lost.
std::string lost_pads(const PauseFacts& facts) {
    std::string pads;
    std::size_t count = 0;
    for (std::uint32_t p = 0; p < game::players; ++p) {
        if (!facts.lost_pad[p]) continue;
        pads += text(count++ == 0 ? "Pad " : " and pad ", *facts.lost_pad[p] + 1, " of ",
                     game::name_of(facts.names, p));
    }
    if (count == 0) return {};
    return text(pads, count == 1 ? " is not plugged in" : " are not plugged in");
}

}  // namespace

PauseWords pause_words(const PauseFacts& facts) {
    if (auto head = lost_pads(facts); !head.empty()) {
        const auto half = facts.key_for_half.empty() ? std::string() : text(", or ", facts.key_for_half);
        return {std::move(head), text(how_to_rejoin, half, half.empty() ? "" : " for half of the keyboard")};
    }
    if (facts.focus_lost) return {"Paused", "the window lost the focus"};
    const bool known = facts.paused_by < game::players;
    return {"Paused", known ? text("by ", game::name_of(facts.names, facts.paused_by)) : std::string()};
}

}  // namespace thaum::app

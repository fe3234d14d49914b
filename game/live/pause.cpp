#include "game/live/pause.h"

#include "core/text.h"
#include "game/live/hands.h"

namespace thaum::game::inline live {

namespace {

/// Sentence on lost pads that ends with `end`, such as "pad 1 of Ember is not plugged in". `plugged_again`
/// chooses between pads that are plugged in again and those that are not. Empty if there is no such pad.
std::string lost_pads(const PauseFacts& facts, bool plugged_again, std::string_view end) {
    std::string pads;
    std::size_t count = 0;
    for (std::uint32_t p = 0; p < players; ++p) {
        if (!facts.lost_pad[p] || facts.plugged_again[p] != plugged_again) continue;
        pads += text(count++ == 0 ? "pad " : " and pad ", *facts.lost_pad[p] + 1, " of ",
                     name_of(facts.names, p));
    }
    return count == 0 ? std::string() : text(pads, count == 1 ? " is " : " are ", end);
}

}  // namespace

PauseWords pause_words(const PauseFacts& facts) {
    PauseWords words{.missing = lost_pads(facts, false, "not plugged in")};
    if (facts.heir_of_half < players) words.half_for = name_of(facts.names, facts.heir_of_half);
    if (!words.missing.empty()) {
        const auto half = facts.key_for_half.empty() ? std::string() : text(", or ", facts.key_for_half);
        words.head = capitalised(words.missing);
        words.line = text(how_to_rejoin, half, half.empty() ? "" : " for half of the keyboard");
        return words;
    }
    if (const auto back = lost_pads(facts, true, "plugged in again"); !back.empty()) {
        words.head = capitalised(back);
        words.line = press_to_rejoin;
        return words;
    }
    if (facts.focus_lost) return {"Paused", "the window lost the focus"};
    const bool known = facts.paused_by < players;
    return {"Paused", known ? text("by ", name_of(facts.names, facts.paused_by)) : std::string()};
}

}  // namespace thaum::game::inline live

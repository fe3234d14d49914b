#include "game/data/event_words.h"

#include <cmath>

#include "core/text.h"
#include "game/components/power_up.h"
#include "game/data/presentation.h"

namespace thaum::game::inline data {
namespace {

/// Name of the cause of an event's harm. If a player moved the thing that did it, the name begins with
/// "thrown".
std::string cause_words(const Event& event, std::string_view thing) {
    if (!thing.empty()) return text(event.by < players ? "thrown " : "", thing);
    const bool about_cause = info_of(event.kind).with == EventWith::cause;
    const auto index = cause_of(about_cause ? static_cast<EventKind>(event.detail) : event.kind);
    return std::string(index < causes().size() ? causes()[index] : "magic");
}

std::string power_up_words(const Event& event) {
    return event.detail < power_up_names.size() ? capitalised(power_up_names[event.detail]) : std::string();
}

/// Name of a potion with a capital letter. Event::detail is the potion's number; for recipe_told, its lowest
/// 8 bits are.
std::string potion_words(const Event& event, const BrewWords& brew) {
    const bool told = event.kind == EventKind::recipe_told;
    return capitalised(brew.potion(told ? event.detail & 0xFFU : event.detail));
}

std::string effect_words(const Event& event, const BrewWords& brew) {
    return event.detail < brew.potions.size() ? brew.potions[event.detail].effect : std::string();
}

std::string spell_words(const Event& event, const Presentation& shown) {
    return event.detail < shown.spells.size() ? shown.spells[event.detail].shown : std::string();
}

std::string word_of(EventWord word, const Event& event, const PlayerNames& names, const Presentation& shown,
                    std::string_view thing) {
    const auto& brew = shown.brew;
    const auto named = [&](std::uint32_t player) {
        return player < players ? std::string(name_of(names, player)) : std::string();
    };
    switch (word) {
        case EventWord::by: return named(event.by);
        case EventWord::whom: return named(event.subject);
        case EventWord::cause: return cause_words(event, thing);
        case EventWord::power_up: return power_up_words(event);
        case EventWord::amount: return text(std::lround(event.amount));
        case EventWord::spell: return spell_words(event, shown);
        case EventWord::gain:
            return event.detail == static_cast<std::uint32_t>(PowerUpKind::spark) ? "energy" : "health";
        case EventWord::potion: return potion_words(event, brew);
        case EventWord::effect: return effect_words(event, brew);
        case EventWord::fault: return std::string(words_of_fault(static_cast<BrewFault>(event.detail)));
        case EventWord::recipe: return words_of_order(brew, event.detail);
        case EventWord::ingredient: return std::string(brew.ingredient(event.detail));
    }
    return {};
}

}  // namespace

bool is_alone(const Event& event) { return event.by >= players || event.by == event.subject; }

const std::string& feed_pattern(const EventRow& row, const Event& event) {
    if (!is_alone(event)) return row.feed;
    const bool about_cause = info_of(event.kind).with == EventWith::cause;
    const bool fell = about_cause && event.detail == static_cast<std::uint32_t>(EventKind::fall);
    return fell ? row.feed_fall : row.feed_alone;
}

std::string event_words(const std::string& pattern, const Event& event, const PlayerNames& names,
                        std::string_view thing, const Presentation& shown) {
    std::string out;
    for (const auto& piece : pieces_of(pattern)) {
        out += piece.plain;
        if (piece.word) out += word_of(*piece.word, event, names, shown, thing);
    }
    return out;
}

}  // namespace thaum::game::inline data

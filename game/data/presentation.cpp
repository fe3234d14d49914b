#include "game/data/presentation.h"

#include <algorithm>
#include <array>

#include "core/near_name.h"
#include "core/text.h"
#include "game/data/control_words.h"
#include "game/data/wand.h"
#include "game/data/words_pattern.h"

namespace thaum::game::inline data {
namespace {

/// Names of events that a data file may describe. `whose` names their owner ("the rules") in the message that
/// rejects another name.
struct Known {
    std::vector<std::string_view> names;
    std::string_view whose;
};

constexpr std::array<std::string_view, 12> word_names{"by",     "whom",  "cause",  "power_up",
                                                      "amount", "gain",  "spell",  "potion",
                                                      "effect", "fault", "recipe", "ingredient"};

/// The first unknown name in braces in the plain parts of an event's text; empty if there is none.
/// `controls`: names of controls are allowed there.
std::string unknown_braces_in(std::string_view plain, bool controls) {
    if (!controls) return has_brace(plain) ? std::string(plain) : "";
    for (const auto& piece : control_pieces_of(plain))
        if (has_brace(piece.plain)) return piece.plain;
    return "";
}

/// Reads a text, and reports braces with an unknown name. `controls`: names of controls are allowed.
std::string read_words(const ConfigTable& table, std::string_view key, std::string fallback,
                       bool controls = false) {
    auto words = table.string(key, std::move(fallback));
    for (const auto& piece : pieces_of(words)) {
        const auto unknown = unknown_braces_in(piece.plain, controls);
        if (unknown.empty()) continue;
        table.report(
            key, text("'", key,
                      "' may contain {by}, {whom}, {cause}, {power_up}, {amount}, {gain}, {spell}, {potion}, "
                      "{effect}, {fault}, {recipe}, {ingredient}",
                      controls ? ", and controls such as {fire}" : "", words_on_braces(unknown, word_names)));
    }
    return words;
}

EventRow read_row(const ConfigTable& table) {
    EventRow row;
    row.mark = static_cast<HudMark>(table.choice("mark", {"none", "hit", "fall", "warning", "gift"}, 0));
    row.caption = read_words(table, "caption", "", row.mark == HudMark::gift);
    row.feed = read_words(table, "feed", "");
    row.feed_alone = read_words(table, "feed_alone", row.feed);
    row.feed_fall = read_words(table, "feed_fall", row.feed_alone);
    row.sound = table.string("sound", "");
    row.tactile = table.string("tactile", "");
    return row;
}

void read_rows(const ConfigTable& table, const Known& known, EventRows& rows) {
    std::string all;
    for (const auto name : known.names) all += text(all.empty() ? "" : ", ", name);
    for (const auto& key : table.keys()) {
        if (key == "version") continue;
        if (std::find(known.names.begin(), known.names.end(), key) != known.names.end())
            rows[static_cast<std::size_t>(*event_kind(key))] = read_row(table.table(key));
        else
            table.report(key, text("'", key, "' is no event of ", known.whose, did_you_mean(key, known.names),
                                   "; there are ", all));
    }
    for (const auto name : known.names) {
        if (!table.has(name))
            table.report("", text("event '", name, "' has no row: add a table of that name"));
    }
}

bool is_hit_of_wand(const EventKindInfo& info) {
    const auto registered = [&](const HitKind& hit) { return hit.name == info.name; };
    const auto& hits = event_kinds().hits;
    return std::any_of(hits.begin(), hits.end(), registered);
}

}  // namespace

std::string line_of(const MissingName& missing) {
    return missing.file.empty() ? missing.words
                                : text(missing.file, ": [", missing.table, "]: ", missing.words);
}

namespace {

/// The wand that registered this kind of event as its hit; null if no wand did.
const WandKind* wand_of_hit(EventKind kind) {
    const auto has_it = [&](const WandKind& wand) {
        return std::ranges::any_of(wand.hits, [&](const HitKind& hit) { return hit.name == name_of(kind); });
    };
    const auto& kinds = wand_kinds();
    const auto found = std::ranges::find_if(kinds, has_it);
    return found == kinds.end() ? nullptr : &*found;
}

}  // namespace

std::string file_of_event(EventKind kind) {
    const auto* wand = wand_of_hit(kind);
    return wand == nullptr ? "events.toml" : text("wands/", wand->name, ".toml");
}

std::string table_of_event(EventKind kind) {
    return text(wand_of_hit(kind) == nullptr ? "" : "event.", name_of(kind));
}

std::vector<WordsPiece> pieces_of(std::string_view pattern) {
    return split_at_names<WordsPiece>(pattern, [](WordsPiece& piece, std::string_view name) {
        const auto found = std::find(word_names.begin(), word_names.end(), name);
        if (found == word_names.end()) return false;
        piece.word = static_cast<EventWord>(found - word_names.begin());
        return true;
    });
}

EventRows read_event_rows(const Config& file) {
    EventRows rows(event_kinds().kinds.size());
    Known known{.names = {}, .whose = "the rules"};
    for (const auto& info : event_kinds().kinds) {
        const bool event = !info.name.empty() && info.name != name_of(EventKind::none);
        if (event && !is_hit_of_wand(info)) known.names.push_back(info.name);
    }
    read_rows(file.root(), known, rows);
    return rows;
}

void read_hit_rows(const ConfigTable& wand, bool is_own_file, const std::vector<HitKind>& hits,
                   EventRows& rows) {
    if (!is_own_file) {
        if (wand.has("event"))
            wand.report("event",
                        "'event': the file with the name of the wand's kind says how hits are shown");
        return;
    }
    Known known{.names = {}, .whose = "this wand"};
    for (const auto& hit : hits) known.names.push_back(hit.name);
    if (!hits.empty() || wand.has("event")) read_rows(wand.table("event"), known, rows);
}

WandSounds read_wand_sounds(const ConfigTable& wand) {
    const auto table = wand.table("sound");
    const auto name = [&](std::string_view key) { return table.string(key, ""); };
    return {.fire = name("fire"),
            .burst = name("burst"),
            .take = name("take"),
            .ready = name("ready"),
            .hold = name("hold")};
}

SpellPresentation read_spell_presentation(std::string_view name, const ConfigTable& spell) {
    const auto table = spell.table("event");
    const auto look = spell.table("look");
    const auto sign = look.choice("sign", {spell_signs.begin(), spell_signs.end()}, 0);
    const auto colour = hex_colour(look.string("colour", "#FFFFFF"));
    if (!colour) look.report("colour", "'colour' must be \"#RRGGBB\"");
    return {.name = std::string(name),
            .sound = table.string("sound", ""),
            .tactile = table.string("tactile", ""),
            .sign = static_cast<SpellSign>(sign),
            .colour = colour.value_or(0xFFFFFF)};
}

SpellSign sign_of(const Presentation& shown, std::uint32_t spell) {
    return spell < shown.spells.size() ? shown.spells[spell].sign : SpellSign::none;
}

const EventRow& row_of(const EventRows& rows, EventKind kind) {
    static const EventRow none;
    const auto number = static_cast<std::size_t>(kind);
    return number < rows.size() ? rows[number] : none;
}

}  // namespace thaum::game::inline data

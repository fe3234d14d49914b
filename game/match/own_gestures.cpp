#include "game/match/own_gestures.h"

#include <algorithm>
#include <tuple>

#include "core/one_line.h"
#include "core/text.h"
#include "gesture/gesture_file.h"

namespace thaum::game::inline match {
namespace {

/// Maximum size of a gesture file (bytes). Three strokes of some seconds need a tenth of it.
constexpr std::size_t max_text = std::size_t{1} << 20U;

std::string words_of(const input::ProfileData& item) {
    return text("gesture '", printable(item.name, 40), "' of player ", item.player + 1);
}

Expected<gesture::Gesture> read_item(const input::ProfileData& item) {
    const auto what = words_of(item);
    if (item.bytes.size() > max_text)
        return fail(text(what, ": more than ", max_text, " bytes; record shorter strokes"));
    const std::string_view toml(reinterpret_cast<const char*>(item.bytes.data()), item.bytes.size());
    const auto config = Config::parse(toml, what, gesture::gesture_file_version);
    if (!config) return config.error();
    auto gesture = gesture::read_gesture(*config);
    if (gesture && gesture->name != item.name)
        return fail(text(what, ": its text is of a gesture '", printable(gesture->name, 40), "'"));
    return gesture;
}

/// Replaces the shipped gesture that has the same name by the player's own.
Expected<void> replace(std::vector<gesture::Gesture>& gestures, const input::ProfileData& item) {
    if (item.kind != gesture_kind)
        return fail(text("profile data of the unknown kind '", printable(item.kind, 40), "'"));
    const auto shipped =
        std::find_if(gestures.begin(), gestures.end(), [&](const auto& g) { return g.name == item.name; });
    if (shipped == gestures.end())
        return fail(text(words_of(item), ": the game has no gesture of this name"));
    auto gesture = read_item(item);
    if (!gesture) return gesture.error();
    *shipped = std::move(*gesture);
    return {};
}

}  // namespace

input::ProfileData profile_of(const gesture::Gesture& gesture, std::uint32_t player) {
    const auto toml = gesture::to_file(gesture);
    const auto bytes = std::as_bytes(std::span(toml));
    return {.kind = std::string(gesture_kind),
            .name = gesture.name,
            .player = player,
            .bytes = {bytes.begin(), bytes.end()}};
}

Expected<void> use_profile(const MatchData& data, std::vector<input::ProfileData> profile,
                           MatchSetup& setup) {
    std::sort(profile.begin(), profile.end(), [](const auto& a, const auto& b) {
        return std::tie(a.kind, a.name, a.player) < std::tie(b.kind, b.name, b.player);
    });
    std::array<std::vector<gesture::Gesture>, players> sets;
    for (const auto& item : profile) {
        if (item.player >= players || !data.gestures)
            return fail(text(words_of(item), ": this match has no such player or no gestures"));
        auto& set = sets[item.player];
        const auto shipped = data.gestures->gestures();
        if (set.empty()) set.assign(shipped.begin(), shipped.end());
        if (auto replaced = replace(set, item); !replaced) return replaced;
    }
    auto given = decltype(setup.gestures){};
    for (std::uint32_t p = 0; p < players; ++p) {
        if (sets[p].empty()) continue;
        if (const auto fault = fault_of(sets[p]))
            return fail(text("gestures of player ", p + 1, ": ", *fault));
        given[p] = std::make_shared<const GestureSet>(std::move(sets[p]));
    }
    setup.gestures = std::move(given);
    setup.profile = std::move(profile);
    return {};
}

}  // namespace thaum::game::inline match

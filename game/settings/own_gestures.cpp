#include "game/settings/own_gestures.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/file.h"
#include "core/text.h"
#include "game/data/reading.h"
#include "game/settings/player_name.h"
#include "gesture/collisions.h"
#include "gesture/gesture_file.h"

namespace thaum::game::inline settings {
namespace {

constexpr std::size_t max_own_gesture = std::size_t{1} << 20U;  // maximum size of a gesture file (bytes)

std::filesystem::path file_of(const std::filesystem::path& folder, const std::string& name) {
    return folder / (file_name_of(name) + ".toml");
}

/// Why a recorded gesture does not suit the match's data or the player's other gestures; std::nullopt if it
/// does.
std::optional<std::string> fault_of(const MatchData& data, std::vector<input::ProfileData> others,
                                    const input::ProfileData& item) {
    MatchSetup scratch;
    if (const auto used = use_profile(data, {item}, scratch); !used) return used.error().message;
    others.push_back(item);
    const auto used = use_profile(data, std::move(others), scratch);
    if (used) return {};
    return text("it is left out, since it does not fit beside the other own gestures (", used.error().message,
                "): record it anew with shorter strokes");
}

/// Text about the more frequent of two mistakes: strokes of the player's own gesture taken for the other
/// gesture, or the reverse. An example is "Star: 12 % of such strokes are taken for it".
std::string words_of(const gesture::Pair& pair, bool own_is_first, std::string_view other) {
    const auto &own = own_is_first ? pair.a_as_b : pair.b_as_a,
               &others = own_is_first ? pair.b_as_a : pair.a_as_b;
    // For two equal gestures there are few confident mistakes, because the recogniser is sure of neither. So
    // the nearest gesture counts, too.
    const bool taken = 2 * std::max(own.taken, others.taken) >= std::max(own.nearer, others.nearer);
    const double of_own = taken ? own.taken : own.nearer, of_others = taken ? others.taken : others.nearer;
    const auto percent = text(other, ": ", std::lround(100 * std::max(of_own, of_others)), " % of ");
    if (of_own >= of_others)
        return text(percent, taken ? "such strokes are taken for it" : "such strokes are nearer to it");
    return text(percent, taken ? "its strokes are taken for this" : "its strokes are nearer to this");
}

}  // namespace

std::filesystem::path own_gestures_folder(const std::filesystem::path& settings_file,
                                          const Settings& settings, std::size_t player) {
    if (settings_file.empty()) return {};
    const auto& name = settings.players.at(player).name;
    const auto words = name.empty() ? text("player-", player + 1) : name;
    return settings_file.parent_path() / "gestures" / file_name_of(words);
}

std::vector<input::ProfileData> load_own_gestures(const std::filesystem::path& folder, const MatchData& data,
                                                  std::uint32_t player, std::vector<std::string>& faults) {
    std::vector<input::ProfileData> own;
    if (folder.empty() || !data.gestures) return own;
    for (const auto& shipped : data.gestures->gestures()) {
        const auto file = file_of(folder, shipped.name);
        std::error_code error;
        if (!std::filesystem::exists(file, error)) continue;
        const auto toml = read_own_text_file(file, max_own_gesture);
        if (!toml) {
            faults.push_back(toml.error().message);
            continue;
        }
        const auto bytes = std::as_bytes(std::span(*toml));
        input::ProfileData item{.kind = std::string(gesture_kind),
                                .name = shipped.name,
                                .player = player,
                                .bytes = {bytes.begin(), bytes.end()}};
        if (const auto fault = fault_of(data, own, item))
            faults.push_back(text(file.string(), ": ", *fault));
        else
            own.push_back(std::move(item));
    }
    return own;
}

Expected<void> save_own_gesture(const std::filesystem::path& folder, const gesture::Gesture& gesture) {
    if (folder.empty()) return fail("there is no home folder to save it in");
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    return write_text_file(file_of(folder, gesture.name), gesture::to_file(gesture));
}

bool forget_own_gesture(const std::filesystem::path& folder, const std::string& name) {
    std::error_code error;
    return !folder.empty() && std::filesystem::remove(file_of(folder, name), error);
}

std::vector<input::ProfileData> with_own_gesture(std::vector<input::ProfileData> profile,
                                                 const gesture::Gesture& gesture, std::uint32_t player) {
    std::erase_if(profile,
                  [&](const auto& item) { return item.name == gesture.name && item.player == player; });
    profile.push_back(profile_of(gesture, player));
    return profile;
}

Expected<void> check_own_gesture(const gesture::Gesture& gesture, const MatchData& data,
                                 const std::vector<input::ProfileData>& profile, std::uint32_t player) {
    MatchSetup setup;
    if (auto used = use_profile(data, with_own_gesture(profile, gesture, player), setup); !used) return used;
    const auto set = setup.gestures[player]->gestures();
    const auto pairs = gesture::compare_gestures(set, {}, recognise_drawn);
    if (!pairs) return pairs.error();
    for (const auto& pair : *pairs) {
        const auto &a = set[pair.a].name, &b = set[pair.b].name;
        const bool first = a == gesture.name;
        if (pair.collides() && (first || b == gesture.name))
            return fail(text("it is too like ", words_of(pair, first, capitalised(first ? b : a))));
    }
    return {};
}

}  // namespace thaum::game::inline settings

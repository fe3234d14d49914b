#include "game/app/own_gestures.h"

#include <algorithm>

#include "core/file.h"
#include "core/text.h"
#include "game/app/player_name.h"
#include "gesture/collisions.h"
#include "gesture/gesture_file.h"

namespace thaum::app {
namespace {

constexpr std::size_t largest_own_gesture = std::size_t{1} << 20U;  // bytes of a file

std::filesystem::path file_of(const std::filesystem::path& folder, const std::string& name) {
    return folder / (file_name_of(name) + ".toml");
}

}  // namespace

std::filesystem::path own_gestures_folder(const std::filesystem::path& settings_file,
                                          const Settings& settings, std::size_t player) {
    if (settings_file.empty()) return {};
    const auto& name = settings.players.at(player).name;
    const auto words = name.empty() ? text("player-", player + 1) : name;
    return settings_file.parent_path() / "gestures" / file_name_of(words);
}

std::vector<input::ProfileData> load_own_gestures(const std::filesystem::path& folder,
                                                  const game::MatchData& data, std::uint32_t player,
                                                  std::vector<std::string>& faults) {
    std::vector<input::ProfileData> own;
    if (folder.empty() || !data.gestures) return own;
    for (const auto& shipped : data.gestures->gestures()) {
        const auto file = file_of(folder, shipped.name);
        std::error_code error;
        if (!std::filesystem::exists(file, error)) continue;
        const auto toml = read_text_file(file, largest_own_gesture);
        if (!toml) {
            faults.push_back(toml.error().message);
            continue;
        }
        const auto bytes = std::as_bytes(std::span(*toml));
        input::ProfileData item{.kind = std::string(game::gesture_kind),
                                .name = shipped.name,
                                .player = player,
                                .bytes = {bytes.begin(), bytes.end()}};
        game::MatchSetup scratch;
        if (const auto used = game::use_profile(data, {item}, scratch); !used)
            faults.push_back(text(file.string(), ": ", used.error().message));
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

std::vector<std::string> likeness_words(const gesture::Gesture& gesture, const game::MatchData& data,
                                        const std::vector<input::ProfileData>& profile,
                                        std::uint32_t player) {
    game::MatchSetup setup;
    const bool used = data.gestures && game::use_profile(data, profile, setup).has_value();
    if (!used) return {};
    const auto* own = setup.gestures[player].get();
    const auto set = (own != nullptr ? *own : *data.gestures).gestures();
    const auto pairs = gesture::compare_gestures(set);
    if (!pairs) return {pairs.error().message};
    std::vector<std::string> words;
    for (const auto& pair : *pairs) {
        const auto &a = set[pair.a].name, &b = set[pair.b].name;
        if (!pair.collides() || (a != gesture.name && b != gesture.name)) continue;
        words.push_back(text("like ", a == gesture.name ? b : a, ": they may be mistaken"));
    }
    return words;
}

}  // namespace thaum::app

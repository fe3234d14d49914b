// game/settings/own_gestures.h: the gestures that players drew themselves, one file for each gesture and player, in the folder
// `gestures` beside the settings file:
//
//     gestures/PLAYER/GESTURE.toml     PLAYER is the player's name, or player-1 and player-2
//
// A match takes their text as it is, and its log holds it (game/match/own_gestures.h).
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "game/match/own_gestures.h"
#include "game/settings/settings.h"

namespace thaum::app {

/// Whether the gesture that the player of the range has drawn counts now.
enum class Verdict : std::uint8_t {
    none,    ///< nothing was drawn
    kept,    ///< it counts from now on
    refused  ///< the player may draw it again
};

/// Own gestures with which the range goes on, and words for its player.
struct OwnGestures {
    std::vector<input::ProfileData> profile{};
    std::vector<std::string> words{};
    Verdict verdict{};
};

/// Folder of a player's own gestures; empty if there is no settings file.
std::filesystem::path own_gestures_folder(const std::filesystem::path& settings_file,
                                          const Settings& settings, std::size_t player);

/// Own gestures of a player that fit the match's data, and fit beside each other. Others are left out; `faults` receives a
/// line for each.
std::vector<input::ProfileData> load_own_gestures(const std::filesystem::path& folder,
                                                  const game::MatchData& data, std::uint32_t player,
                                                  std::vector<std::string>& faults);

/// Writes a gesture, replacing one of the same name.
Expected<void> save_own_gesture(const std::filesystem::path& folder, const gesture::Gesture& gesture);
/// Deletes a player's own gesture, so that the shipped one counts again. Returns whether there was one.
bool forget_own_gesture(const std::filesystem::path& folder, const std::string& name);

/// The own gestures of all players with this one of a player, in place of an older one of the same name.
std::vector<input::ProfileData> with_own_gesture(std::vector<input::ProfileData> profile,
                                                 const gesture::Gesture& gesture, std::uint32_t player);

/// Refuses a gesture that does not fit beside the player's other gestures, or is so like one of them that strokes would be
/// mistaken (gesture/collisions.h). The error names the other one: "it is too like V: 12 % of such strokes are
/// taken for it".
/// `profile`: own gestures so far.
Expected<void> check_own_gesture(const gesture::Gesture& gesture, const game::MatchData& data,
                                 const std::vector<input::ProfileData>& profile, std::uint32_t player);

}  // namespace thaum::app

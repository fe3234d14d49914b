// game/app/own_gestures.h: the gestures that players drew themselves, one file for each gesture and player, in the folder
// `gestures` beside the settings file:
//
//     gestures/PLAYER/GESTURE.toml     PLAYER is the player's name, or player-1 and player-2
//
// A match takes their text as it is, and its log holds it (game/match/own_gestures.h).
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "game/app/settings.h"
#include "game/match/own_gestures.h"

namespace thaum::app {

/// Own gestures with which the range goes on, and words for its player.
struct OwnGestures {
    std::vector<input::ProfileData> profile{};
    std::vector<std::string> words{};
};

/// Folder of a player's own gestures; empty if there is no settings file.
std::filesystem::path own_gestures_folder(const std::filesystem::path& settings_file,
                                          const Settings& settings, std::size_t player);

/// Own gestures of a player that fit the match's data. Others are left out; `faults` receives a line for each.
std::vector<input::ProfileData> load_own_gestures(const std::filesystem::path& folder,
                                                  const game::MatchData& data, std::uint32_t player,
                                                  std::vector<std::string>& faults);

/// Writes a gesture, replacing one of the same name.
Expected<void> save_own_gesture(const std::filesystem::path& folder, const gesture::Gesture& gesture);
/// Deletes a player's own gesture, so that the shipped one counts again. Returns whether there was one.
bool forget_own_gesture(const std::filesystem::path& folder, const std::string& name);

/// Warnings where a gesture is so like another gesture of the same player that strokes may be mistaken; empty: none.
std::vector<std::string> likeness_words(const gesture::Gesture& gesture, const game::MatchData& data,
                                        const std::vector<input::ProfileData>& profile, std::uint32_t player);

}  // namespace thaum::app

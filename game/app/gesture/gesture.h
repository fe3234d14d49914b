// game/app/gesture/gesture.h: the actions of `thaum gesture ACTION ...`. Each takes the words after the
// action and returns the exit code.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"
#include "gesture/stroke.h"

namespace thaum::game::inline app {

extern const std::string_view gesture_eval_help, gesture_spot_help, gesture_check_help, gesture_record_help,
    gesture_generate_help;

int run_gesture_eval(const std::vector<std::string>& words);
int run_gesture_spot(const std::vector<std::string>& words);
int run_gesture_record(const std::vector<std::string>& words);
int run_gesture_generate(const std::vector<std::string>& words);
int run_gesture_check(const std::vector<std::string>& words);

/// The channels of strokes that the value of --channels names: x and y, with or without the depth z and the
/// force f. For an empty value, all channels that the file has. The error says what is wrong.
Expected<gesture::Channels> choose_channels(const std::string& word, bool has_depth, bool has_force);
/// Name of the channels as a value of --channels: xy, xyz, xyf or xyzf.
std::string name_of(gesture::Channels channels);

}  // namespace thaum::game::inline app

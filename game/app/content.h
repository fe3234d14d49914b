// game/app/content.h: checks all data files at once. The game's own readers read them. Names in them are
// compared with the files that exist: every name needs its file, and every file must be named.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace thaum::game::inline app {

struct ContentReport {
    std::size_t files{};                ///< number of files in the folder, without those that nothing reads
    std::vector<std::string> faults{};  ///< one line for each fault: file, line, key, what is wrong, what is
                                        ///< allowed
    /// One line for each probable mistake with which the game can be played all the same.
    std::vector<std::string> notes{};
};

/// Reads all data files of a folder. A file that nothing reads or that nothing names is a fault.
ContentReport check_content(const std::filesystem::path& assets);

/// One line on a report for the start screen: the first fault, and how many more there are. Empty if there is
/// no fault.
std::string short_words(const ContentReport& report);

}  // namespace thaum::game::inline app

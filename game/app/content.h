// game/app/content.h: all data files at once. They are read by the readers that the game uses, and the names in them are
// compared with the files that are there, in both directions.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace thaum::app {

struct ContentReport {
    std::size_t files{};                ///< files of the folder, without those that nothing reads
    std::vector<std::string> faults{};  ///< one line each: file, line, key, what is wrong, what is allowed
    std::vector<std::string> notes{};   ///< lines on what can be played, and is probably not meant
};

/// Reads all data files of a folder. A file that nothing reads, and one that nothing names, are faults.
ContentReport check_content(const std::filesystem::path& assets);

/// One line on a report for the start screen: the first fault, and how many more there are. Empty: no fault.
std::string short_words(const ContentReport& report);

}  // namespace thaum::app

// field/detail/sample_file.h: the file of samples that a header names, even if the header was made on another
// computer with other rules for names.
#pragma once
#include <filesystem>
#include <string>
#include <string_view>

namespace thaum::field {

/// Path of the file of samples that a header names, relative to the header's folder. If there is no such
/// file, tries the name without quotes, with Windows separators and without regard to capitals, then a file
/// beside the header with the last part of the name. If none or several match, returns the path as the header
/// gives it.
std::filesystem::path sample_file(const std::filesystem::path& header, std::string_view name);

/// A note for the user if a file of samples was found under another name or in another folder than the header
/// says; empty: no note is needed.
std::string note_on_place(const std::filesystem::path& header, std::string_view name,
                          const std::filesystem::path& found);

}  // namespace thaum::field

// field/detail/sample_file.h: the file of samples that a header names, also where the header comes from another computer.
#pragma once
#include <filesystem>
#include <string>
#include <string_view>

namespace thaum::field {

/// Path of the file of samples that a header names, relative to the header's folder. If there is none of that name: the
/// one file that the name leads to without quotes, with Windows separators and without regard to capitals, or else the one
/// file beside the header with the last part of the name. The path as it is named if there is no such file, or more than
/// one.
std::filesystem::path sample_file(const std::filesystem::path& header, std::string_view name);

/// A note on a file of samples that lies elsewhere than the header says, or in another folder; empty: none is needed.
std::string note_on_place(const std::filesystem::path& header, std::string_view name,
                          const std::filesystem::path& found);

}  // namespace thaum::field

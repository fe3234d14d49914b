// structure/rules.h: rules that the source tree must keep. Each rule reads a tree and returns its faults,
// one line each ("file:line: fault"). The rules can also be tested on small trees that break them.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace thaum::structure {

using Faults = std::vector<std::string>;

/// Every #include in engine/ and game/ must point to a part on a lower floor (level of the tree; see `floors`
/// in rules.cpp).
Faults upward_includes(const std::filesystem::path& root);

/// No file may contain a path of one machine, such as a home folder or the path of this tree.
Faults machine_paths(const std::filesystem::path& root);

/// Every tests/**/*.cpp must be named in a CMake file of tests/, so that it is built.
Faults unbuilt_tests(const std::filesystem::path& root);

/// Every header directly in an engine folder must open with "// part/name.h: purpose".
Faults headers_without_title(const std::filesystem::path& root);

/// Finds headers of engine/ outside of detail/ that no file of another folder includes, neither directly nor
/// through another header of the same folder. Such a header belongs in detail/.
Faults internal_headers(const std::filesystem::path& root);

/// No file of engine/, game/ or tools/ may open files itself, except those listed: other readers would
/// not declare what they read (core/write_rule.h). Only those listed may read a file as the program's
/// own, or an environment variable.
Faults opens_around_the_rule(const std::filesystem::path& root);

/// A source in engine/, game/, tools/ or tests/ has at most 600 lines.
Faults long_files(const std::filesystem::path& root);

/// A line that is a comment has at most 110 characters, unless it belongs to a table or a drawing, which are
/// indented.
Faults long_comments(const std::filesystem::path& root);

/// Code in game/ROOM must be in the namespace thaum::game::inline ROOM.
Faults wrong_namespaces(const std::filesystem::path& root);

}  // namespace thaum::structure

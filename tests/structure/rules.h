// structure/rules.h: what the tree itself must hold to. Each rule reads a tree and returns the faults it finds, one
// line each ("file:line: what"), so that the rules can also be tried on made-up trees that break them.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace thaum::structure {

using Faults = std::vector<std::string>;

/// Every #include in engine/ and game/ points to a lower floor of the house (see `floors` in rules.cpp).
Faults upward_arrows(const std::filesystem::path& root);

/// No file names a folder of the machine it was made on: a home folder, or the place of this tree.
Faults machine_paths(const std::filesystem::path& root);

/// Every tests/**/*.cpp is built, that is, named in a CMake file of tests/.
Faults unbuilt_tests(const std::filesystem::path& root);

/// Every header at the top of an engine folder opens with "// part/name.h: what it is for".
Faults headers_without_idea(const std::filesystem::path& root);

}  // namespace thaum::structure

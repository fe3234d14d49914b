// core/environment.h: reads environment variables. An empty variable counts as not set for every reader,
// because people switch a variable off by making it empty.
#pragma once
#include <optional>
#include <string>

namespace thaum {

/// Value of an environment variable; std::nullopt if it is not set or empty.
std::optional<std::string> environment_value(const char* name);

}  // namespace thaum

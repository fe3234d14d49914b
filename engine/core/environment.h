// core/environment.h: reads environment variables. An empty variable counts as one that is not set, for all alike: people
// switch a variable off by setting it to nothing.
#pragma once
#include <optional>
#include <string>

namespace thaum {

/// Value of an environment variable; std::nullopt if it is not set or empty.
std::optional<std::string> environment_value(const char* name);

}  // namespace thaum

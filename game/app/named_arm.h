// game/app/named_arm.h: opens the force feedback arm that a command-line option names.
#pragma once
#include <memory>
#include <string>

#include "input/open_arm.h"

namespace thaum::game::inline app {

/// Opens the first arm with this name, or the arm with this number ("arm:0"). Other arms are closed again.
/// The error begins with `option`, and lists the arms that were found.
Expected<std::unique_ptr<input::OpenArm>> open_named_arm(std::string_view option, const std::string& name);

}  // namespace thaum::game::inline app

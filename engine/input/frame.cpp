#include "input/frame.h"

namespace thaum::input {

std::string_view name_of(DeviceKind kind) {
    constexpr std::array<std::string_view, device_kinds> names{
        "keyboard_mouse", "keyboard_half", "pad", "bot", "script", "arm"};
    return names[static_cast<std::size_t>(kind)];
}

}  // namespace thaum::input

#include "game/command_line/exit_code.h"

#include "core/tell_user.h"
#include "core/text.h"

namespace thaum::game::inline command_line {

int refuse(const Error& error) {
    const auto more = error.more.size();
    tell_user(text("thaum: ", error.message,
                   more == 0 ? "" : text(" (", more, " more: thaum check, for data files)")));
    return wrong_use;
}

}  // namespace thaum::game::inline command_line

#include "game/command_line/exit_code.h"

#include "core/tell_user.h"
#include "core/text.h"

namespace thaum::app {

int refuse(const Error& error) {
    tell_user(text("thaum: ", error.message));
    return wrong_use;
}

}  // namespace thaum::app

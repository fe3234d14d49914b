#include "game/command_line/exit_code.h"

#include <cstdio>

#include "core/one_line.h"

namespace thaum::app {

int refuse(const Error& error) {
    std::fprintf(stderr, "thaum: %s\n", in_one_line(error.message).c_str());
    return wrong_use;
}

}  // namespace thaum::app

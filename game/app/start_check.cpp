// Checks the processor before every constructor of the program and its libraries runs. Those constructors are
// compiled for x86-64-v3, and an older processor would stop them at an illegal instruction, without a
// message. This file is compiled for older processors (tools/cmake/targets.cmake).
#include <unistd.h>

#include "core/processor.h"
#include "game/app/command.h"

namespace {

/// Writes a text to standard error by a system call, the only output that works this early.
void say(const char* text) {
    unsigned length = 0;
    while (text[length] != '\0') ++length;
    if (write(STDERR_FILENO, text, length) < 0) _exit(thaum::game::wrong_use);
}

void refuse_older_processors(int, char**, char**) {
    const auto missing = thaum::missing_of_x86_64_v3();
    if (missing.length == 0) return;
    say("thaum: this build needs a processor of x86-64-v3 and this one lacks");
    say(missing.text);
    say("; build with -DTHAUM_PORTABLE=ON (./thaum does so by itself)\n");
    _exit(thaum::game::wrong_use);
}

[[gnu::section(".preinit_array"), gnu::used]] void (*const first_of_all)(int, char**,
                                                                         char**) = refuse_older_processors;

}  // namespace

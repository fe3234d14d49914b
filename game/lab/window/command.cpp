#include "game/command_line/command.h"

#include "game/lab/window/lab.h"

namespace thaum::game::inline lab {
namespace {

const CommandRegistration registration_of_lab({.name = "lab", .help = "", .run = run_lab});

}  // namespace
}  // namespace thaum::game::inline lab

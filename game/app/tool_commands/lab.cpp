#include "game/lab/window/lab.h"

#include "game/app/command.h"

namespace thaum::game::inline app {
namespace {

const CommandRegistration registration_of_lab({.name = "lab", .help = "", .run = run_lab});

}  // namespace
}  // namespace thaum::game::inline app

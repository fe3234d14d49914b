// The benchmarks are a program of their own, because they count allocations by replacing malloc.
#include "game/app/command.h"

namespace thaum::game::inline app {
namespace {

int run_bench(const std::vector<std::string>& words) { return become("thaum-bench", words); }

const CommandRegistration registration_of_bench({.name = "bench", .help = "", .run = run_bench});

}  // namespace
}  // namespace thaum::game::inline app

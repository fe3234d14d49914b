// thaum-tools: the program with all commands. A program that links to further wands, spells, commands or
// drivers of arms has this main function, too.
#include <string>
#include <utility>
#include <vector>

#include "game/app/command.h"
#include "game/app/program.h"

namespace thaum::game::inline app {
namespace {

int dispatch_words(std::vector<std::string> words) { return dispatch(std::move(words), ""); }

}  // namespace

}  // namespace thaum::game::inline app

int main(int argc, char** argv) { return thaum::game::run_program(argc, argv, thaum::game::dispatch_words); }

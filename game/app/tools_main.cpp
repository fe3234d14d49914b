// thaum-tools: the program with all commands. A program that links to further wands, spells, commands or
// drivers of arms has this main function, too.
#include <string>
#include <utility>
#include <vector>

#include "game/app/command.h"
#include "game/app/program.h"

namespace thaum::app {
namespace {

int dispatch_words(std::vector<std::string> words) { return dispatch(std::move(words), ""); }

}  // namespace

}  // namespace thaum::app

int main(int argc, char** argv) { return thaum::app::run_program(argc, argv, thaum::app::dispatch_words); }

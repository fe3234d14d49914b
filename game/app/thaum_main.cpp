// thaum: the program that players start. For a command that it lacks, it replaces itself by thaum-tools
// (exec).
#include <string>
#include <utility>
#include <vector>

#include "game/app/command.h"
#include "game/app/program.h"

namespace thaum::game::inline app {
namespace {

int dispatch_words(std::vector<std::string> words) { return dispatch(std::move(words), "thaum-tools"); }

}  // namespace

}  // namespace thaum::game::inline app

int main(int argc, char** argv) { return thaum::game::run_program(argc, argv, thaum::game::dispatch_words); }

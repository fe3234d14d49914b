// thaum: the program that players start. For the commands that it does not have itself it becomes thaum-tools.
#include <string>
#include <vector>

#include "game/app/command.h"
#include "game/app/program.h"

namespace thaum::app {
namespace {

int dispatch_words(std::vector<std::string> words) {
    const std::vector<Command> commands = {
        play_command(),
        range_command(),
        {"replay", summaries::replay, "", nullptr},
        {"shots", summaries::shots, "", nullptr},
        {"diff", summaries::diff, "", nullptr},
        {"scenario", summaries::scenario, "", nullptr},
        {"league", summaries::league, "", nullptr},
        {"lab", summaries::lab, "", nullptr},
        bench_command(),
        {"plot", summaries::plot, "", nullptr},
        {"sounds", summaries::sounds, "", nullptr},
        {"gesture", summaries::gesture, "", nullptr},
        doctor_command(),
    };
    return dispatch(commands, std::move(words));
}

}  // namespace

}  // namespace thaum::app

int main(int argc, char** argv) { return thaum::app::run_program(argc, argv, thaum::app::dispatch_words); }

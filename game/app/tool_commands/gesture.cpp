// thaum gesture: measures and checks the recognisers of gestures.
#include "game/app/gesture/gesture.h"

#include <array>
#include <cstdio>

#include "core/near_name.h"
#include "core/text.h"
#include "game/app/command.h"
#include "game/app/program.h"

namespace thaum::game::inline app {
namespace {

constexpr std::string_view gesture_help =
    R"(usage: thaum gesture ACTION ...

  eval STROKES     how often a recogniser is right, how well it knows that, and its time
  spot SESSIONS    finds gestures in continuous motion, without a button
  record NAME      strokes drawn now, or of a match or a file, as a gesture file
  check FILE ...   which gestures of template files collide, and by how much
  generate         the shipped templates, and strokes of users to test them with

`thaum gesture ACTION --help` explains an action. Files of strokes are CSV, gzipped or not:
user,gesture,sample,t,x,y[,z][,force], one row a point, times in seconds. Sessions are
user,t,x,y[,z][,force] with labels user,gesture,t_start,t_end in a file of their own.
)";

struct Action {
    std::string_view name;
    const std::string_view* help;
    int (*run)(const std::vector<std::string>& words);
};

constexpr std::array actions{Action{"eval", &gesture_eval_help, run_gesture_eval},
                             Action{"spot", &gesture_spot_help, run_gesture_spot},
                             Action{"record", &gesture_record_help, run_gesture_record},
                             Action{"check", &gesture_check_help, run_gesture_check},
                             Action{"generate", &gesture_generate_help, run_gesture_generate}};

int run_gesture(const std::vector<std::string>& words) {
    for (const auto& action : actions) {
        if (words.empty() || words[0] != action.name) continue;
        const std::vector<std::string> remaining(words.begin() + 1, words.end());
        if (asks_for_help(remaining)) {
            std::printf("%s", std::string(*action.help).c_str());
            return done;
        }
        return action.run(remaining);
    }
    if (asks_for_help(words)) {
        std::printf("%s", std::string(gesture_help).c_str());
        return done;
    }
    const std::string what = words.empty() ? "no action"
                                           : text("unknown action '", words[0], "'",
                                                  did_you_mean(words[0], actions, &Action::name));
    return refuse({text(what, "; `thaum gesture --help` lists them")});
}

const CommandRegistration registration_of_gesture({.name = "gesture", .help = "", .run = run_gesture});

}  // namespace

}  // namespace thaum::game::inline app

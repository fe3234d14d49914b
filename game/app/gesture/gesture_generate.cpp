// thaum gesture generate: makes the shipped templates (the example strokes of each gesture), and strokes of
// synthetic users to test them with.
#include <cstdio>
#include <filesystem>

#include "core/file.h"
#include "core/text.h"
#include "game/app/command.h"
#include "game/app/gesture/gesture.h"
#include "game/command_line/arguments.h"
#include "gesture/generated_users.h"
#include "gesture/gesture_file.h"
#include "gesture/stroke_csv.h"

namespace thaum::game::inline app {

const std::string_view gesture_generate_help =
    R"(usage: thaum gesture generate --out FOLDER [OPTIONS]

Draws the gestures of the game as people who do not exist draw them, and writes:

  circle.toml v.toml s.toml star.toml   templates, three careful strokes of each; those of seed 1
                                        are assets/gestures
  strokes.csv     gentle and harsh strokes of other users, in metres, seconds and newtons
  scribbles.csv   as many strokes of the same users that mean nothing

  --seed S        seed of all strokes (default 1)
  --users N       users, 1 to 1000 (default 20)
  --samples N     gentle strokes and harsh ones of each gesture by each user (default 3)
  --out FOLDER    folder to write to; it is made if it is missing

A user has a place to begin at, a way round, proportions, tilt, corners, tremor, pace, force and
device (a mouse has no depth); each stroke differs from them by jitter. The recogniser sets its
thresholds with other synthetic strokes. Even so, a generated set flatters: quote public ones.
)";

int run_gesture_generate(const std::vector<std::string>& words) {
    static constexpr Option options[] = {{"--out", 1}, {"--seed", 1}, {"--users", 1}, {"--samples", 1}};
    const auto arguments = Arguments::parse(words, options);
    if (!arguments) return refuse(arguments.error());
    const auto seed = arguments->whole("--seed", 0, ~std::uint64_t{0}, 1),
               users = arguments->whole("--users", 1, 1000, 20),
               samples = arguments->whole("--samples", 1, 100, 3);
    for (const auto* whole : {&seed, &users, &samples}) {
        if (!*whole) return refuse(whole->error());
    }
    const auto out = arguments->value("--out");
    if (!arguments->plain().empty() || !out)
        return refuse({"name a folder with --out; see `thaum gesture generate --help`"});
    const std::filesystem::path folder = *out;
    std::error_code fault;
    std::filesystem::create_directories(folder, fault);
    if (fault) return refuse({text("cannot create ", *out, ": ", fault.message())});
    const auto templates = gesture::generated_templates(*seed);
    for (const auto& gesture : templates) {
        const auto written = write_text_file(folder / (gesture.name + ".toml"), gesture::to_file(gesture));
        if (!written) return refuse(written.error());
    }
    const gesture::GeneratedSetSettings settings{.users = *users, .samples = *samples, .seed = *seed};
    const auto strokes = gesture::generated_strokes(settings),
               scribbles = gesture::generated_scribbles(settings);
    for (const auto& [name, set] :
         {std::pair{"strokes.csv", &strokes}, std::pair{"scribbles.csv", &scribbles}}) {
        if (const auto written = write_text_file(folder / name, gesture::to_csv(*set)); !written)
            return refuse(written.error());
    }
    std::printf("%zu gestures, %zu strokes and %zu scribbles of %zu users\n", templates.size(),
                strokes.size(), scribbles.size(), static_cast<std::size_t>(*users));
    return done;
}

}  // namespace thaum::game::inline app

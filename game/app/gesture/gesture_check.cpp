// thaum gesture check: which gestures of template files the recogniser would confuse.
#include <algorithm>
#include <cstdio>

#include "core/one_line.h"
#include "core/text.h"
#include "game/app/command.h"
#include "game/app/gesture/gesture.h"
#include "game/command_line/arguments.h"
#include "game/data/reading.h"
#include "gesture/collisions.h"
#include "gesture/gesture_file.h"

namespace thaum::game::inline app {

const std::string_view gesture_check_help =
    R"(usage: thaum gesture check FILE.toml ...

Draws 400 variations of each gesture and reads them among all gestures as a match does. Lists the
pairs of which strokes are mistaken, and the closest others: share of strokes that are accepted as
the other gesture, and share that are nearer to it than to their own, each way; and the distance
between the two, as a multiple of the usual distance of a stroke from its own gesture. Exits with 1
if a pair collides: more than 2 % taken for the other, or more than 5 % nearer to it.
)";

namespace {

constexpr std::size_t shown_pairs = 10;

std::string whole_percent(double share) { return fixed(100 * share, 0) + " %"; }

void print_pair(const gesture::Pair& pair, std::span<const gesture::Gesture> gestures) {
    const auto name = [&](std::uint32_t g) { return printable(gestures[g].name, 20); };
    const auto each_way = [](double there, double back) {
        return text(whole_percent(there), ", ", whole_percent(back));
    };
    std::printf("  %-20s %-20s %14s %14s %8s  %s\n", name(pair.a).c_str(), name(pair.b).c_str(),
                each_way(pair.a_as_b.taken, pair.b_as_a.taken).c_str(),
                each_way(pair.a_as_b.nearer, pair.b_as_a.nearer).c_str(), fixed(pair.separation, 1).c_str(),
                pair.collides() ? "collide" : "");
}

}  // namespace

int run_gesture_check(const std::vector<std::string>& words) {
    const auto arguments = Arguments::parse(words, {});
    if (!arguments) return refuse(arguments.error());
    if (arguments->plain().empty()) return refuse({"name the gesture files to check"});
    std::vector<gesture::Gesture> gestures;
    bool depth = false, force = false;
    for (const auto& path : arguments->plain()) {
        auto gesture = gesture::load_gesture(path);
        if (!gesture) return refuse(gesture.error());
        for (const auto& stroke : gesture->strokes) {
            depth =
                depth || std::any_of(stroke.begin(), stroke.end(), [](const auto& p) { return p.at.z != 0; });
            force = force ||
                    std::any_of(stroke.begin(), stroke.end(), [](const auto& p) { return p.force != 0; });
        }
        gestures.push_back(std::move(*gesture));
    }
    const auto pairs = gesture::compare_gestures(gestures, {.channels = {depth, force}}, recognise_drawn);
    if (!pairs) return refuse(pairs.error());
    const auto collisions =
        std::count_if(pairs->begin(), pairs->end(), [](const auto& p) { return p.collides(); });
    std::printf("  %-20s %-20s %14s %14s %8s\n", "gesture", "other", "taken for it", "nearer to it",
                "distance");
    std::size_t printed = 0;
    for (const auto& pair : *pairs) {
        if (pair.collides() || printed < shown_pairs) print_pair(pair, gestures);
        ++printed;
    }
    std::printf("%zu gestures, %zu pairs, %zu collide\n", gestures.size(), pairs->size(),
                static_cast<std::size_t>(collisions));
    return collisions > 0 ? does_not_hold : done;
}

}  // namespace thaum::game::inline app

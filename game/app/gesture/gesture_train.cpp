// thaum gesture train: trains a network of the papers on a file of strokes and writes it as TOML.
#include <cstdio>

#include "core/file.h"
#include "core/text.h"
#include "game/app/command.h"
#include "game/app/gesture/gesture.h"
#include "game/app/gesture/stroke_files.h"
#include "game/command_line/arguments.h"
#include "gesture/evaluation.h"
#include "gesture/stroke_networks.h"

namespace thaum::app {

const std::string_view gesture_train_help =
    R"(usage: thaum gesture train STROKES --method tdnn|directions --out NET.toml [OPTIONS]

Trains a network of the papers by back-propagation on all strokes of the file and writes it.
The same strokes, seed and epochs give the same file on every machine.

  --method M      tdnn: paper 002, windows of 8 transitions between 5x5 states;
                  directions: paper 000, directional vectors
  --out FILE      file of the network
  --seed S        seed of the first weights and of the order of the strokes (default 1)
  --epochs N      most rounds over all strokes (default 60)
)";

namespace {

std::vector<gesture::Gesture> all_gestures(const gesture::StrokeSet& set) {
    const auto index = gesture::index_of(set.strokes);
    std::vector<std::vector<std::size_t>> numbers(index.gestures.size());
    for (std::size_t s = 0; s < set.strokes.size(); ++s) numbers[index.gesture_of[s]].push_back(s);
    return gesture::gestures_of(set.strokes, index, numbers);
}

/// Share of the strokes whose largest output is right.
double share_right(const gesture::StrokeNetwork& network, std::span<const gesture::Gesture> gestures) {
    std::size_t right = 0, all = 0;
    for (std::size_t g = 0; g < gestures.size(); ++g) {
        for (const auto& stroke : gestures[g].strokes) {
            const auto outputs = gesture::outputs_of(network, stroke);
            const auto best = std::max_element(outputs.begin(), outputs.end()) - outputs.begin();
            right += static_cast<std::size_t>(best) == g;
            ++all;
        }
    }
    return static_cast<double>(right) / static_cast<double>(all);
}

}  // namespace

int run_gesture_train(const std::vector<std::string>& words) {
    static constexpr Option options[] = {{"--method", 1}, output("--out"), {"--seed", 1}, {"--epochs", 1}};
    const auto arguments = Arguments::parse(words, options);
    if (!arguments) return refuse(arguments.error());
    const auto out = arguments->value("--out");
    const auto method = arguments->value("--method").value_or("");
    const auto seed = arguments->whole("--seed", 0, ~std::uint64_t{0}, 1),
               epochs = arguments->whole("--epochs", 1, 100'000, 60);
    if (!seed) return refuse(seed.error());
    if (!epochs) return refuse(epochs.error());
    if (arguments->plain().size() != 1 || !out)
        return refuse({"name one file of strokes and --out FILE; see `thaum gesture train --help`"});
    if (method != "tdnn" && method != "directions")
        return refuse({text("--method '", method, "': must be tdnn or directions")});
    if (const auto free = check_output(*out); !free) return refuse(free.error());
    const auto set = load_strokes(arguments->plain()[0]);
    if (!set) return refuse(set.error());
    const auto gestures = all_gestures(*set);
    if (gestures.size() > gesture::most_nodes)
        return refuse({text(gestures.size(), " gestures, more than ", gesture::most_nodes, " outputs")});
    const auto kind = method == "tdnn" ? gesture::NetworkKind::tdnn : gesture::NetworkKind::directions;
    const auto training = gesture::train_network(kind, gestures, {.seed = *seed, .epochs = *epochs});
    if (training.samples == 0) return refuse({"no stroke moves, so there is nothing to train with"});
    if (const auto written = write_text_file(*out, gesture::to_file(training.network)); !written)
        return refuse(written.error());
    std::printf(
        "%zu gestures, %zu samples, %zu epochs\nmean squared error   %s\nright on the strokes %s %%\n",
        gestures.size(), training.samples, training.epochs, fixed(training.error, 5).c_str(),
        fixed(100 * share_right(training.network, gestures), 2).c_str());
    return done;
}

}  // namespace thaum::app

#include "gesture/trials/stroke_networks.h"

#include <algorithm>

#include "gesture/trials/dot.h"

namespace thaum::gesture {
namespace {

// Longest step from one cell of the grid to the next; a longer one counts as this (cells).
constexpr double widest_step = 2;

bool all_finite(Points stroke) {
    return std::all_of(stroke.begin(), stroke.end(), [](const auto& p) { return is_finite(p); });
}

struct Cell {
    int x{}, y{};
    bool operator==(const Cell&) const = default;
};

/// Cells of the grid that the stroke visits, in order.
std::vector<Cell> visited_cells(Points stroke) {
    vec2 low(stroke[0].at), high = low;
    for (const auto& p : stroke) {
        low = glm::min(low, vec2(p.at));
        high = glm::max(high, vec2(p.at));
    }
    const double side = std::max(high.x - low.x, high.y - low.y);
    if (!(side > 0) || !std::isfinite(side)) return {};
    const vec2 corner = (low + high) / 2.0 - side / 2;
    const auto cell_of = [&](double at, double from) {
        const double place = (at - from) / side * static_cast<double>(grid_side);
        return std::clamp(static_cast<int>(place), 0, static_cast<int>(grid_side) - 1);
    };
    std::vector<Cell> cells;
    for (const auto& p : stroke) {
        const Cell c{cell_of(p.at.x, corner.x), cell_of(p.at.y, corner.y)};
        if (cells.empty() || !(cells.back() == c)) cells.push_back(c);
    }
    return cells;
}

std::size_t nodes_of_input(NetworkKind kind) {
    return kind == NetworkKind::tdnn ? 2 * window_transitions : 3 * direction_vectors;
}

}  // namespace

std::vector<std::vector<double>> transition_windows(Points stroke) {
    if (stroke.empty() || !all_finite(stroke)) return {};
    const auto cells = visited_cells(stroke);
    if (cells.size() < 2) return {};
    std::vector<double> steps;
    for (std::size_t i = 1; i < cells.size(); ++i) {
        steps.push_back(std::clamp<double>(cells[i].x - cells[i - 1].x, -widest_step, widest_step));
        steps.push_back(std::clamp<double>(cells[i].y - cells[i - 1].y, -widest_step, widest_step));
    }
    constexpr std::size_t width = 2 * window_transitions;
    if (steps.size() < width) steps.insert(steps.begin(), width - steps.size(), 0.0);
    std::vector<std::vector<double>> windows;
    for (std::size_t first = 0; first + width <= steps.size(); first += 2) {
        const auto begin = steps.begin() + static_cast<std::ptrdiff_t>(first);
        windows.emplace_back(begin, begin + static_cast<std::ptrdiff_t>(width));
    }
    return windows;
}

std::vector<double> direction_input(Points stroke) {
    if (stroke.size() < 2 || !all_finite(stroke)) return {};
    const auto points = equally_spaced(stroke);
    std::vector<double> input;
    bool moves = false;
    for (std::size_t i = 0; i < direction_vectors; ++i) {
        const std::size_t a = i * (dot_points - 1) / direction_vectors,
                          b = (i + 1) * (dot_points - 1) / direction_vectors;
        const vec3 step = points[b].at - points[a].at;
        const double length = glm::length(step);
        moves = moves || (length > 0 && std::isfinite(length));
        const vec3 unit = length > 0 && std::isfinite(length) ? step / length : vec3(0);
        for (int c = 0; c < 3; ++c) input.push_back(unit[c]);
    }
    return moves ? input : std::vector<double>{};
}

std::vector<std::vector<double>> inputs_of(NetworkKind kind, Points stroke) {
    if (kind == NetworkKind::tdnn) return transition_windows(stroke);
    auto input = direction_input(stroke);
    if (input.empty()) return {};
    return {std::move(input)};
}

std::vector<double> outputs_of(const StrokeNetwork& network, Points stroke) {
    const auto& n = network.network;
    const auto inputs = inputs_of(network.kind, stroke);
    std::vector<double> sum(n.outputs, inputs.empty() ? -1.0 : 0.0), hidden(n.hidden), output(n.outputs);
    for (const auto& input : inputs) {
        run_network(n, input, hidden, output);
        for (std::size_t o = 0; o < n.outputs; ++o) sum[o] += output[o] / static_cast<double>(inputs.size());
    }
    return sum;
}

StrokeNetwork train_network(NetworkKind kind, std::span<const Gesture> gestures,
                            const TrainingSettings& settings) {
    std::vector<TrainingSample> samples;
    for (std::size_t g = 0; g < gestures.size(); ++g) {
        for (const auto& stroke : gestures[g].strokes) {
            for (auto& input : inputs_of(kind, stroke)) samples.push_back({std::move(input), g});
        }
    }
    auto start = random_network(nodes_of_input(kind), hidden_nodes, gestures.size(), settings.seed);
    return {kind, train(std::move(start), samples, settings).network};
}

}  // namespace thaum::gesture

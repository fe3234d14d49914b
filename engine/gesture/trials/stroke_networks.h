// gesture/trials/stroke_networks.h: the two networks of the papers, from stroke to gesture. They are
// baselines for comparison; the recogniser that the game uses is in recogniser.h.
//
// Time-delay network (paper 002, on the game HaptiCast, section 3.2). The workspace is a grid of 5x5 states
// in the x-y plane; z is disregarded. The input is a sliding window of the 8 most recent transitions between
// states: 16 nodes. There are 24 hidden nodes, and one output for each gesture (the paper has 4: circles both
// ways and diagonal strokes). The paper does not say how a transition is encoded. With 8 transitions in 16
// nodes there are two numbers for each: the steps in x and y. The grid here is the square around the stroke,
// because strokes of data sets come without a workspace. The answer to a whole stroke is the mean of the
// outputs over its windows.
//
// Directional vectors (paper 000, Mora and Lee 2008, section 8). "Haptic proxy positions were converted to
// directional vectors (e.g. Right: 1,0,0; 1,0,0; ...)." The paper gives no size: here there are 16 unit
// vectors at equal steps of arc length, and 24 hidden nodes.
#pragma once
#include <array>
#include <span>
#include <vector>

#include "gesture/gesture.h"
#include "gesture/trials/network.h"

namespace thaum::gesture {

/// Form in which a network gets a stroke: transitions between cells of a grid (tdnn), or directions.
enum class NetworkKind : std::uint8_t { tdnn, directions };

inline constexpr std::size_t grid_side = 5;
inline constexpr std::size_t window_transitions = 8;
inline constexpr std::size_t hidden_nodes = 24;
inline constexpr std::size_t direction_vectors = 16;

/// A network, and the form in which it gets strokes.
struct StrokeNetwork {
    NetworkKind kind{};
    Network network;

    bool operator==(const StrokeNetwork&) const = default;
};

/// Inputs of the time-delay network for a stroke: windows of 8 transitions from cell to cell. A stroke of
/// fewer than 8 transitions gives one window with zeros in front; a stroke without a transition, or with
/// values that are not finite, gives none.
std::vector<std::vector<double>> transition_windows(Points stroke);

/// Input of the network of directions: unit vectors along the stroke, three numbers each; empty for a stroke
/// without two different places.
std::vector<double> direction_input(Points stroke);

/// Inputs of a network of this kind for one stroke.
std::vector<std::vector<double>> inputs_of(NetworkKind kind, Points stroke);

/// Mean of the network's outputs over all inputs made from the stroke; all -1 for a stroke without inputs.
std::vector<double> outputs_of(const StrokeNetwork& network, Points stroke);

/// A network with one output for each gesture, in their order.
StrokeNetwork train_network(NetworkKind kind, std::span<const Gesture> gestures,
                            const TrainingSettings& settings);

}  // namespace thaum::gesture

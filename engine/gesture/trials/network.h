// gesture/trials/network.h: a network of one hidden layer, trained by back-propagation
// (Rumelhart, Hinton, Williams 1986).
//
//     hidden = tanh(W1 input + b1)        output = tanh(W2 hidden + b2)
//
// Targets are 1 for the right output and -1 for the others. Training is gradient descent with momentum on the
// sum of squared errors, one sample at a time in an order drawn from the seed. tanh is computed from
// core/maths, and sums have a fixed order, so equal seeds give equal weights on every processor.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

namespace thaum::gesture {

/// Hyperbolic tangent with the same bits on every processor; the error is below 1e-15.
double det_tanh(double x);

/// Weights of a network with one hidden layer.
struct Network {
    std::size_t inputs{}, hidden{}, outputs{};
    std::vector<double> first;   ///< W1 and b1: `hidden` rows of `inputs` weights and a bias
    std::vector<double> second;  ///< W2 and b2: `outputs` rows of `hidden` weights and a bias

    bool operator==(const Network&) const = default;
};

/// One input with its right output.
struct TrainingSample {
    std::vector<double> input;
    std::size_t output{};  ///< number of the right output
};

/// Settings of a training.
struct TrainingSettings {
    std::uint64_t seed = 1;
    std::size_t epochs = 60;
    double rate = 0.005;  ///< learning rate in the first epoch; it falls to a tenth in the last
    double momentum = 0.8;
    double enough = 1e-3;  ///< mean squared error of an epoch at which training ends early
};

/// Result of a training.
struct Training {
    Network network;
    std::size_t epochs{};  ///< number of epochs that were run
    double error{};        ///< mean squared error of the last epoch
};

/// A network with small random weights.
Network random_network(std::size_t inputs, std::size_t hidden, std::size_t outputs, std::uint64_t seed);

/// Computes the outputs. Allocates nothing: `hidden` and `output` must have the sizes of the layers.
void run_network(const Network& network, std::span<const double> input, std::span<double> hidden,
                 std::span<double> output);

/// Adds the gradient of half the sum of squared errors of one sample to `first` and `second`, which are
/// arranged like the weights of the network's two layers.
void add_slope(const Network& network, const TrainingSample& sample, std::vector<double>& first,
               std::vector<double>& second);

/// Trains a network by gradient descent.
Training train(Network network, std::span<const TrainingSample> samples, const TrainingSettings& settings);

}  // namespace thaum::gesture

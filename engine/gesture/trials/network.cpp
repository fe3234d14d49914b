#include "gesture/trials/network.h"

#include <algorithm>
#include <cmath>

#include "core/maths.h"
#include "core/random.h"

namespace thaum::gesture {
namespace {

/// Weighted sum with one row of weights, of which the last is the bias.
double row_sum(const double* row, std::span<const double> values) {
    double sum = row[values.size()];
    for (std::size_t i = 0; i < values.size(); ++i) sum += row[i] * values[i];
    return sum;
}

/// Working memory of the training: values and errors of the two layers.
struct Layers {
    std::vector<double> hidden, output, error_output, error_hidden;

    explicit Layers(const Network& n)
        : hidden(n.hidden), output(n.outputs), error_output(n.outputs), error_hidden(n.hidden) {}
};

/// Computes the outputs for a sample, then their errors, and from these the errors of the hidden layer
/// (back-propagation). Returns the sum of squared errors.
double propagate(const Network& n, const TrainingSample& sample, Layers& l) {
    run_network(n, sample.input, l.hidden, l.output);
    double squares = 0;
    for (std::size_t o = 0; o < n.outputs; ++o) {
        const double error = l.output[o] - (o == sample.output ? 1.0 : -1.0);
        squares += error * error;
        l.error_output[o] = error * (1 - l.output[o] * l.output[o]);
    }
    for (std::size_t h = 0; h < n.hidden; ++h) {
        double sum = 0;
        for (std::size_t o = 0; o < n.outputs; ++o)
            sum += l.error_output[o] * n.second[o * (n.hidden + 1) + h];
        l.error_hidden[h] = sum * (1 - l.hidden[h] * l.hidden[h]);
    }
    return squares;
}

/// Adds the gradient of one layer's weights: error of each output times each input, and 1 for the bias.
void add_layer(std::span<const double> errors, std::span<const double> inputs, std::vector<double>& slope) {
    for (std::size_t r = 0; r < errors.size(); ++r) {
        double* row = &slope[r * (inputs.size() + 1)];
        for (std::size_t i = 0; i < inputs.size(); ++i) row[i] += errors[r] * inputs[i];
        row[inputs.size()] += errors[r];
    }
}

/// One step of gradient descent with momentum: velocity = momentum * velocity - rate * gradient.
void descend(std::vector<double>& weights, std::vector<double>& velocity, std::span<const double> errors,
             std::span<const double> inputs, double rate, double momentum) {
    for (std::size_t r = 0; r < errors.size(); ++r) {
        const std::size_t row = r * (inputs.size() + 1);
        for (std::size_t i = 0; i <= inputs.size(); ++i) {
            const double slope = errors[r] * (i < inputs.size() ? inputs[i] : 1.0);
            velocity[row + i] = momentum * velocity[row + i] - rate * slope;
            weights[row + i] += velocity[row + i];
        }
    }
}

}  // namespace

double det_tanh(double x) {
    if (std::isnan(x)) return x;
    const double size = std::abs(x);
    if (size > 22) return x > 0 ? 1.0 : -1.0;
    if (size < 0.05) {  // for small numbers, the quotient below would lose digits
        const double q = x * x;
        return x * (1 + q * (-1.0 / 3 +
                             q * (2.0 / 15 + q * (-17.0 / 315 + q * (62.0 / 2835 - q * 1382.0 / 155925)))));
    }
    const double e = det::exp(-2 * size);
    const double result = (1 - e) / (1 + e);
    return x > 0 ? result : -result;
}

Network random_network(std::size_t inputs, std::size_t hidden, std::size_t outputs, std::uint64_t seed) {
    Network n{.inputs = inputs, .hidden = hidden, .outputs = outputs, .first = {}, .second = {}};
    Random random = random_stream(seed, 1);
    const auto fill = [&](std::vector<double>& weights, std::size_t rows, std::size_t columns) {
        const double range = std::sqrt(3.0 / static_cast<double>(columns));
        weights.resize(rows * (columns + 1));
        for (double& w : weights) w = random.uniform(-range, range);
    };
    fill(n.first, hidden, inputs);
    fill(n.second, outputs, hidden);
    return n;
}

void run_network(const Network& n, std::span<const double> input, std::span<double> hidden,
                 std::span<double> output) {
    for (std::size_t h = 0; h < n.hidden; ++h)
        hidden[h] = det_tanh(row_sum(&n.first[h * (n.inputs + 1)], input));
    for (std::size_t o = 0; o < n.outputs; ++o)
        output[o] = det_tanh(row_sum(&n.second[o * (n.hidden + 1)], hidden.first(n.hidden)));
}

void add_slope(const Network& n, const TrainingSample& sample, std::vector<double>& first,
               std::vector<double>& second) {
    Layers l(n);
    propagate(n, sample, l);
    add_layer(l.error_hidden, sample.input, first);
    add_layer(l.error_output, l.hidden, second);
}

Training train(Network network, std::span<const TrainingSample> samples, const TrainingSettings& settings) {
    Training result{.network = std::move(network)};
    Network& n = result.network;
    Layers l(n);
    std::vector<double> first(n.first.size()), second(n.second.size());
    std::vector<std::size_t> order(samples.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    Random random = random_stream(settings.seed, 2);
    for (std::size_t epoch = 0; epoch < settings.epochs && !samples.empty(); ++epoch) {
        for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random.below(i)]);
        const double done = static_cast<double>(epoch) / static_cast<double>(settings.epochs);
        const double rate = settings.rate * (1 - 0.9 * done);
        double squares = 0;
        for (const auto i : order) {
            squares += propagate(n, samples[i], l);
            descend(n.second, second, l.error_output, l.hidden, rate, settings.momentum);
            descend(n.first, first, l.error_hidden, samples[i].input, rate, settings.momentum);
        }
        result.epochs = epoch + 1;
        result.error = squares / static_cast<double>(samples.size() * n.outputs);
        if (result.error < settings.enough) break;
    }
    return result;
}

}  // namespace thaum::gesture

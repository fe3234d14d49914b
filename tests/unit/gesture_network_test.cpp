// Tests of the neural networks of the papers, which recognise gestures: back-propagation against finite
// differences, and training from a seed.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/hash.h"
#include "gesture/trials/stroke_networks.h"
#include "gesture/variations.h"
#include "unit/gesture_shapes.h"

namespace thaum::gesture {
namespace {

TEST(GestureNetwork, TanhIsRightToTheLastDigits) {
    for (double x = -25; x < 25; x += 0.0371) EXPECT_NEAR(det_tanh(x), std::tanh(x), 3e-15) << x;
    EXPECT_EQ(det_tanh(0), 0);
    EXPECT_EQ(det_tanh(1e300), 1);
    EXPECT_EQ(det_tanh(-1e300), -1);
    EXPECT_TRUE(std::isnan(det_tanh(std::nan(""))));
}

double half_squares(const Network& n, const TrainingSample& sample) {
    std::vector<double> hidden(n.hidden), output(n.outputs);
    run_network(n, sample.input, hidden, output);
    double sum = 0;
    for (std::size_t o = 0; o < n.outputs; ++o) {
        const double e = output[o] - (o == sample.output ? 1.0 : -1.0);
        sum += e * e / 2;
    }
    return sum;
}

TEST(GestureNetwork, SlopeEqualsFiniteDifferences) {
    auto n = random_network(5, 7, 3, 11);
    const TrainingSample sample{{0.3, -1, 0.5, 2, -0.7}, 1};
    std::vector<double> first(n.first.size()), second(n.second.size());
    add_slope(n, sample, first, second);
    constexpr double h = 1e-6;
    const auto check = [&](std::vector<double>& weights, const std::vector<double>& slope) {
        for (std::size_t i = 0; i < weights.size(); ++i) {
            const double w = weights[i];
            weights[i] = w + h;
            const double up = half_squares(n, sample);
            weights[i] = w - h;
            const double down = half_squares(n, sample);
            weights[i] = w;
            EXPECT_NEAR(slope[i], (up - down) / (2 * h), 1e-8) << i;
        }
    };
    check(n.first, first);
    check(n.second, second);
}

TEST(GestureNetwork, LearnsWhatNoSingleLayerCan) {
    std::vector<TrainingSample> samples;
    for (int a = -1; a <= 1; a += 2) {
        for (int b = -1; b <= 1; b += 2) samples.push_back({{double(a), double(b)}, a == b ? 0U : 1U});
    }
    const auto t = train(random_network(2, 6, 2, 3), samples, {.epochs = 3000, .rate = 0.05});
    EXPECT_LT(t.error, 0.01);
    for (const auto& s : samples) EXPECT_LT(half_squares(t.network, s), 0.1);
}

std::vector<Gesture> paper_gestures() {
    std::vector<Gesture> gestures;
    const std::vector<std::pair<std::string, Course>> shapes{
        {"clockwise", circle(0, -1)},
        {"counter-clockwise", circle()},
        {"rising", dash()},
        {"falling", drawn([](double u) { return vec3(u, -u, 0); })}};
    Random random = random_stream(5, 0);
    for (const auto& [name, course] : shapes) {
        Gesture g = gesture_of(name, {});
        for (int i = 0; i < 12; ++i) g.strokes.push_back(variation_of(course, random, careful));
        gestures.push_back(std::move(g));
    }
    return gestures;
}

double share_right(const StrokeNetwork& network, std::uint64_t seed) {
    const auto gestures = paper_gestures();
    Random random = random_stream(seed, 1);
    int right = 0;
    for (int i = 0; i < 80; ++i) {
        const std::size_t g = static_cast<std::size_t>(i) % 4;
        const auto outputs = outputs_of(network, variation_of(gestures[g].strokes[0], random, careful));
        right += std::max_element(outputs.begin(), outputs.end()) - outputs.begin() ==
                 static_cast<std::ptrdiff_t>(g);
    }
    return right / 80.0;
}

TEST(GestureNetwork, BothPapersNetworksLearnTheirFourGestures) {
    const auto gestures = paper_gestures();
    const auto tdnn = train_network(NetworkKind::tdnn, gestures, {.epochs = 150});
    EXPECT_EQ(tdnn.network.inputs, 16U);
    EXPECT_EQ(tdnn.network.hidden, 24U);
    EXPECT_EQ(tdnn.network.outputs, 4U);
    EXPECT_GE(share_right(tdnn, 1), 0.85);
    EXPECT_GE(share_right(train_network(NetworkKind::directions, gestures, {.epochs = 150}), 2), 0.95);
}

TEST(GestureNetwork, EqualSeedsGiveEqualWeightsAndOthersOthers) {
    const auto gestures = paper_gestures();
    const auto a = train_network(NetworkKind::directions, gestures, {.seed = 4, .epochs = 5}),
               b = train_network(NetworkKind::directions, gestures, {.seed = 4, .epochs = 5}),
               c = train_network(NetworkKind::directions, gestures, {.seed = 5, .epochs = 5});
    EXPECT_EQ(a, b);
    EXPECT_NE(a, c);
}

TEST(GestureNetwork, TransitionsFollowTheGrid) {
    const auto windows = transition_windows(drawn([](double u) { return vec3(u, 0, 0); }));
    ASSERT_EQ(windows.size(), 1U);
    ASSERT_EQ(windows[0].size(), 16U);
    double x = 0, y = 0;
    for (std::size_t i = 0; i < 16; i += 2) {
        x += windows[0][i];
        y += windows[0][i + 1];
    }
    EXPECT_EQ(x, 4);  // the stroke went from the first to the fifth column of the grid
    EXPECT_EQ(y, 0);
    EXPECT_TRUE(transition_windows({}).empty());
}

}  // namespace
}  // namespace thaum::gesture

#include "gesture/collisions.h"

#include <algorithm>
#include <tuple>

#include "core/text.h"
#include "gesture/variations.h"

namespace thaum::gesture {
namespace {

constexpr std::size_t variations = 400;  // number of variations (synthetic strokes) of each gesture

using Shares = std::vector<std::vector<Mistaken>>;

/// Scatter of a gesture's variations (synthetic strokes). Users who draw one shape with two different forces
/// keep the forces apart on purpose, so their force scatters less. But a force that only follows speed
/// scatters as much as the pace: a user who draws the gesture of the larger force slowly would be taken to
/// have drawn the other one.
VariationSettings scatter_of(const Recogniser& recogniser, std::uint32_t gesture) {
    constexpr double force_of_twins = 0.15;
    VariationSettings scatter;
    if (!recogniser.counts_force()) return scatter;
    for (std::uint32_t other = 0; other < recogniser.gestures(); ++other) {
        if (recogniser.are_twins(gesture, other)) scatter.force = force_of_twins;
    }
    return scatter;
}

/// Draws variations (synthetic strokes) of each gesture and returns the shares of them that were recognised
/// as each gesture: [drawn gesture][recognised gesture].
Shares read_variations(const Recogniser& recogniser, std::span<const Gesture> gestures,
                       const ReadStroke& read, RecogniserSpace& space) {
    Shares shares(gestures.size(), std::vector<Mistaken>(gestures.size()));
    for (std::size_t g = 0; g < gestures.size(); ++g) {
        Random random = random_stream(recogniser.settings().seed, 0xc0 + g);
        const auto scatter = scatter_of(recogniser, static_cast<std::uint32_t>(g));
        for (std::size_t v = 0; v < variations; ++v) {
            const auto& strokes = gestures[g].strokes;
            const auto stroke = variation_of(strokes[v % strokes.size()], random, scatter);
            const auto r = read ? read(recogniser, stroke, space) : recogniser.recognise(stroke, space);
            if (r.gesture == Recognition::none) continue;
            auto& mistaken = shares[g][r.gesture];
            mistaken.nearer += 1.0 / variations;
            if (r.accepted) mistaken.taken += 1.0 / variations;
        }
    }
    return shares;
}

/// Least distance of a template of `from` to the gesture `to`. The recogniser knows only `to`, because a
/// nearer gesture would otherwise be its answer.
Expected<double> distance_between(const Gesture& from, const Gesture& to, const RecogniserSettings& settings,
                                  RecogniserSpace& space) {
    auto alone = settings;
    alone.calibrate = false;
    const auto recogniser = Recogniser::make(std::span(&to, 1), alone);
    if (!recogniser) return recogniser.error();
    double least = 1;
    for (const auto& stroke : from.strokes) {
        const auto r = recogniser->recognise(stroke, space);
        if (r.gesture != Recognition::none) least = std::min(least, static_cast<double>(r.distance));
    }
    return least;
}

}  // namespace

Expected<std::vector<Pair>> compare_gestures(std::span<const Gesture> gestures,
                                             const RecogniserSettings& settings, const ReadStroke& read) {
    const auto recogniser = Recogniser::make(gestures, settings);
    if (!recogniser) return recogniser.error();
    RecogniserSpace space;
    const auto shares = read_variations(*recogniser, gestures, read, space);
    const auto& usual = recogniser->calibration().usual;
    std::vector<Pair> pairs;
    for (std::uint32_t a = 0; a < gestures.size(); ++a) {
        for (std::uint32_t b = a + 1; b < gestures.size(); ++b) {
            const auto there = distance_between(gestures[a], gestures[b], settings, space),
                       back = distance_between(gestures[b], gestures[a], settings, space);
            if (!there) return there.error();
            if (!back) return back.error();
            const double width = static_cast<double>(std::max(usual[a], usual[b]));
            pairs.push_back({a, b, shares[a][b], shares[b][a], std::min(*there, *back) / width});
        }
    }
    std::sort(pairs.begin(), pairs.end(), [](const Pair& p, const Pair& q) {
        const double nearer_p = -p.nearer(), nearer_q = -q.nearer();
        return std::tie(nearer_p, p.separation, p.a, p.b) < std::tie(nearer_q, q.separation, q.a, q.b);
    });
    return pairs;
}

}  // namespace thaum::gesture

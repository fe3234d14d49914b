#include "gesture/trials/methods.h"

#include <algorithm>
#include <array>

#include "core/text.h"
#include "gesture/prefix.h"
#include "gesture/recogniser.h"
#include "gesture/trials/dot.h"
#include "gesture/trials/stroke_networks.h"

namespace thaum::gesture {
namespace {

constexpr std::array<std::string_view, 6> names{"dot", "tdnn", "directions", "elastic", "default", "early"};

/// The gesture with the highest score, as an answer. The highest possible score is 1, so 1 - score serves as
/// the distance.
Answer answer_of(std::span<const double> scores) {
    Answer answer;
    double best = -2, second = -2;
    for (std::uint32_t g = 0; g < scores.size(); ++g) {
        if (scores[g] > best) {
            second = best;
            best = scores[g];
            answer.gesture = g;
        } else {
            second = std::max(second, scores[g]);
        }
    }
    answer.evidence = evidence_of(static_cast<float>(1 - best), static_cast<float>(1 - second), 1);
    answer.probability = 1;
    return answer;
}

class DotClassifier : public Classifier {
public:
    DotClassifier(std::span<const Gesture> gestures, Channels channels)
        : channels_(channels), scores_(gestures.size()) {
        for (std::uint32_t g = 0; g < gestures.size(); ++g) {
            for (const auto& stroke : gestures[g].strokes) {
                StrokeVector vector{};
                if (make_vector(stroke, channels, vector)) templates_.push_back({g, vector});
            }
        }
    }

    Answer classify(Points stroke) override {
        StrokeVector vector{};
        if (!make_vector(stroke, channels_, vector)) return {};
        std::fill(scores_.begin(), scores_.end(), -1.0);
        for (const auto& t : templates_)
            scores_[t.gesture] = std::max(scores_[t.gesture], dot_product(vector, t.vector));
        return answer_of(scores_);
    }

private:
    struct Template {
        std::uint32_t gesture{};
        StrokeVector vector{};
    };
    Channels channels_;
    std::vector<Template> templates_;
    std::vector<double> scores_;
};

class NetworkClassifier : public Classifier {
public:
    NetworkClassifier(NetworkKind kind, std::span<const Gesture> gestures, std::uint64_t seed)
        : network_(train_network(kind, gestures, training_for(gestures, seed))) {}

    Answer classify(Points stroke) override {
        if (inputs_of(network_.kind, stroke).empty()) return {};
        return answer_of(outputs_of(network_, stroke));
    }

private:
    /// With fewer strokes, the training needs more epochs (passes over all strokes) for as many steps.
    static TrainingSettings training_for(std::span<const Gesture> gestures, std::uint64_t seed) {
        std::size_t strokes = 0;
        for (const auto& g : gestures) strokes += g.strokes.size();
        return {.seed = seed,
                .epochs = std::clamp<std::size_t>(6000 / std::max<std::size_t>(strokes, 1), 30, 300)};
    }
    StrokeNetwork network_;
};

class ElasticClassifier : public Classifier {
public:
    explicit ElasticClassifier(Recogniser recogniser) : recogniser_(std::move(recogniser)) {}

    Answer classify(Points stroke) override {
        const auto r = recogniser_.recognise(stroke, space_);
        if (r.gesture == Recognition::none) return {};
        return {r.gesture, r.evidence, r.probability};
    }

private:
    Recogniser recogniser_;
    RecogniserSpace space_;
};

class EarlyClassifier : public Classifier {
public:
    explicit EarlyClassifier(PrefixReader reader) : reader_(std::move(reader)) {}

    Answer classify(Points stroke) override {
        const auto likely = reader_.read(stroke, space_);
        return {likely.gesture, likely.evidence, likely.probability};
    }

private:
    PrefixReader reader_;
    PrefixSpace space_;
};

}  // namespace

std::span<const std::string_view> method_names() { return names; }

std::optional<Method> method_of(std::string_view name) {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) return std::nullopt;
    return static_cast<Method>(found - names.begin());
}

Expected<std::unique_ptr<Classifier>> make_classifier(Method method, std::span<const Gesture> gestures,
                                                      const MethodSettings& settings) {
    if (method == Method::dot) return std::make_unique<DotClassifier>(gestures, settings.channels);
    if (method == Method::tdnn || method == Method::directions) {
        const auto kind = method == Method::tdnn ? NetworkKind::tdnn : NetworkKind::directions;
        return std::make_unique<NetworkClassifier>(kind, gestures, settings.seed);
    }
    if (method == Method::early) {
        auto reader = PrefixReader::make(
            gestures,
            {.channels = settings.channels, .seed = settings.seed, .calibrate = settings.calibrate});
        if (!reader) return reader.error();
        return std::make_unique<EarlyClassifier>(std::move(*reader));
    }
    auto recogniser = Recogniser::make(gestures, {.channels = settings.channels,
                                                  .exhaustive = method == Method::elastic,
                                                  .seed = settings.seed,
                                                  .calibrate = settings.calibrate});
    if (!recogniser) return recogniser.error();
    return std::make_unique<ElasticClassifier>(std::move(*recogniser));
}

}  // namespace thaum::gesture

#include "gesture/trials/evaluation.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/random.h"
#include "core/text.h"
#include "gesture/prefix.h"

namespace thaum::gesture {
namespace {

constexpr std::uint32_t none = 0xffffffff;
constexpr double false_accepts_wanted = 0.01;
/// Largest number of strokes to which the weights of a calibration are fitted. Of more strokes, only every
/// second, third or so is taken: that is enough for the weights, and saves time.
constexpr std::size_t max_fitted = 20'000;

using Numbers = std::vector<std::vector<std::size_t>>;

/// Draws `count` elements at random, without repetition, and removes the others.
void draw(std::vector<std::size_t>& from, std::size_t count, Random& random) {
    const std::size_t most = std::min(count, from.size());
    for (std::size_t i = 0; i < most; ++i) std::swap(from[i], from[i + random.below(from.size() - i)]);
    from.resize(most);
}

/// One round of a test, in which the templates stay the same: a user and the number of the repeat.
struct Fold {
    std::uint32_t user{};
    std::size_t repeat{};
};

class Evaluator {
public:
    Evaluator(std::span<const Stroke> strokes, const EvaluationSettings& settings)
        : strokes_(strokes), settings_(settings), index_(index_of(strokes)) {}

    Expected<Evaluation> run() {
        if (auto fault = check()) return fail(*fault);
        const std::size_t users = settings_.protocol == Protocol::random ? 1 : index_.users.size();
        for (std::size_t repeat = 0; repeat < settings_.repeats; ++repeat) {
            for (std::uint32_t user = 0; user < users; ++user) {
                if (auto done = run_fold({user, repeat}); !done) return done.error();
            }
        }
        result_.gestures = index_.gestures;
        return std::move(result_);
    }

private:
    std::optional<std::string> check() const {
        if (index_.gestures.size() < 2)
            return "the strokes are of one gesture; there is nothing to tell apart";
        if (index_.gestures.size() > max_gestures)
            return text(index_.gestures.size(), " gestures, more than ", max_gestures);
        if (settings_.protocol == Protocol::leave_user_out && index_.users.size() < 2)
            return "all strokes are of one user; use --protocol random or user-dependent";
        return std::nullopt;
    }

    /// Chooses at random the gestures that get no templates in this repeat (marked 1), so that the right
    /// answer to their strokes is "nothing". The choice is the same for all users.
    std::vector<char> unknown_gestures(std::size_t repeat) const {
        std::vector<std::size_t> order(index_.gestures.size());
        for (std::size_t g = 0; g < order.size(); ++g) order[g] = g;
        Random random = random_stream(settings_.seed, 0x10000 + repeat);
        draw(order,
             static_cast<std::size_t>(
                 std::lround(settings_.unknown_share * static_cast<double>(order.size()))),
             random);
        std::vector<char> unknown(index_.gestures.size());
        for (const auto g : order) unknown[g] = 1;
        return unknown;
    }

    Expected<void> run_fold(const Fold& fold) {
        Random random = random_stream(settings_.seed, 0x100 * fold.user + fold.repeat);
        auto templates = draw_templates(index_, settings_.protocol, fold.user, settings_.templates, random);
        const auto unknown = unknown_gestures(fold.repeat);
        std::vector<char> used(strokes_.size());
        for (std::size_t g = 0; g < templates.size(); ++g) {
            if (unknown[g] != 0) templates[g].clear();
            for (const auto s : templates[g]) used[s] = 1;
        }
        auto gestures = gestures_of(strokes_, index_, templates);
        std::vector<std::uint32_t> number;  // for each gesture of the classifier, its number in the data set
        for (std::uint32_t g = 0; g < templates.size(); ++g) {
            if (!templates[g].empty()) number.push_back(g);
        }
        const auto classifier = make_classifier(
            settings_.method, gestures, {settings_.channels, settings_.seed, settings_.own_calibration});
        if (!classifier) return classifier.error();
        for (std::size_t s = 0; s < strokes_.size(); ++s) {
            const bool own = index_.user_of[s] == fold.user;
            if (used[s] != 0 || (settings_.protocol != Protocol::random && !own)) continue;
            const auto g = index_.gesture_of[s];
            // No template: there was no stroke to make one of.
            if (templates[g].empty() && unknown[g] == 0) continue;
            test(s, **classifier, number, unknown[g] == 0);
        }
        return {};
    }

    void test(std::size_t s, Classifier& classifier, std::span<const std::uint32_t> number, bool known) {
        const auto answer = classifier.classify(beginning_of(strokes_[s].points, settings_.at));
        Trial trial{.truth = index_.gesture_of[s], .answer = none, .known = known};
        if (answer.gesture != none) trial.answer = number[answer.gesture];
        trial.group = index_.users.size() > 1 ? index_.user_of[s] : static_cast<std::uint32_t>(s % 2);
        trial.evidence = answer.evidence;
        trial.probability = answer.probability;
        result_.trials.push_back(trial);
    }

    std::span<const Stroke> strokes_;
    const EvaluationSettings& settings_;
    GestureIndex index_;
    Evaluation result_;
};

std::vector<std::uint32_t> groups_of(std::span<const Trial> trials) {
    std::vector<std::uint32_t> groups;
    for (const auto& t : trials) groups.push_back(t.group);
    std::sort(groups.begin(), groups.end());
    groups.erase(std::unique(groups.begin(), groups.end()), groups.end());
    return groups;
}

/// Sets the probabilities of the strokes of one group, mostly those of one user, by the weights of a
/// calibration that is fitted to the other groups.
void calibrate_group(std::vector<Trial>& trials, std::uint32_t group) {
    std::vector<LabelledEvidence> samples;
    const std::size_t stride = trials.size() / max_fitted + 1;
    std::size_t number = 0;
    for (const auto& t : trials) {
        if (t.group != group && t.answer != none && number++ % stride == 0)
            samples.push_back({t.evidence, t.right(), 1});
    }
    Calibration calibration{.weights = fit_weights(samples), .usual = {}, .threshold = {}};
    for (auto& t : trials) {
        if (t.group == group) t.probability = t.answer == none ? 0 : calibration.probability(t.evidence);
    }
}

/// The threshold that only the share `false_accepts_wanted` of the probabilities exceeds. `unknown` has those
/// of strokes of gestures without templates, so accepting one is wrong.
double threshold_of(std::vector<double> unknown) {
    if (unknown.empty()) return 0;
    std::sort(unknown.begin(), unknown.end(), std::greater<>());
    const auto rank = static_cast<std::size_t>(false_accepts_wanted * static_cast<double>(unknown.size()));
    return unknown[std::min(rank, unknown.size() - 1)];
}

template <class Wanted>
double unknown_threshold(std::span<const Trial> trials, Wanted wanted) {
    std::vector<double> unknown;
    for (const auto& t : trials) {
        if (!t.known && wanted(t)) unknown.push_back(t.probability);
    }
    return threshold_of(std::move(unknown));
}

OpenSet open_set_of(std::span<const Trial> trials) {
    std::size_t known = 0, unknown = 0, correct = 0, wrong = 0, best = 0;
    const double least = unknown_threshold(trials, [](const Trial&) { return true; });
    for (const auto group : groups_of(trials)) {
        const double threshold = unknown_threshold(trials, [&](const Trial& t) { return t.group != group; });
        for (const auto& t : trials) {
            if (t.group != group) continue;
            (t.known ? known : unknown) += 1;
            const bool accepted = t.probability > threshold;
            correct += t.right() && accepted;
            wrong += !t.known && accepted;
            best += t.right() && t.probability > least;
        }
    }
    const auto share = [](std::size_t a, std::size_t b) {
        return b > 0 ? static_cast<double>(a) / static_cast<double>(b) : 0;
    };
    return {share(correct, known), share(wrong, unknown), share(best, known)};
}

void sum_up(Evaluation& e) {
    e.confusion.assign(e.gestures.size(), std::vector<std::size_t>(e.gestures.size() + 1));
    std::size_t right = 0, known = 0;
    for (const auto& t : e.trials) {
        auto& bin = e.reliability[std::min<std::size_t>(9, static_cast<std::size_t>(t.probability * 10))];
        ++bin.count;
        bin.confidence += t.probability;
        bin.right += t.right() ? 1 : 0;
        if (!t.known) continue;
        ++known;
        right += t.right();
        ++e.confusion[t.truth][t.answer == none ? e.gestures.size() : t.answer];
    }
    e.accuracy = known > 0 ? static_cast<double>(right) / static_cast<double>(known) : 0;
    for (auto& bin : e.reliability) {
        if (bin.count == 0) continue;
        bin.confidence /= static_cast<double>(bin.count);
        bin.right /= static_cast<double>(bin.count);
        e.calibration_error += std::abs(bin.confidence - bin.right) * static_cast<double>(bin.count) /
                               static_cast<double>(e.trials.size());
    }
}

}  // namespace

std::optional<Protocol> protocol_of(std::string_view name) {
    if (name == "user-dependent") return Protocol::user_dependent;
    if (name == "leave-user-out") return Protocol::leave_user_out;
    if (name == "random") return Protocol::random;
    return std::nullopt;
}

GestureIndex index_of(std::span<const Stroke> strokes) {
    std::map<std::string, std::uint32_t> gestures, users;
    for (const auto& s : strokes) {
        gestures.try_emplace(s.gesture);
        users.try_emplace(s.user);
    }
    GestureIndex index;
    for (auto& [name, number] : gestures) {
        number = static_cast<std::uint32_t>(index.gestures.size());
        index.gestures.push_back(name);
    }
    for (auto& [name, number] : users) {
        number = static_cast<std::uint32_t>(index.users.size());
        index.users.push_back(name);
    }
    for (const auto& s : strokes) {
        index.gesture_of.push_back(gestures[s.gesture]);
        index.user_of.push_back(users[s.user]);
    }
    return index;
}

Certainty certainty_of(const Evaluation& evaluation, double min_probability) {
    std::size_t told = 0, right = 0;
    for (const auto& t : evaluation.trials) {
        if (t.answer == none || t.probability < min_probability) continue;
        ++told;
        right += t.right();
    }
    const auto share = [](std::size_t a, std::size_t b) {
        return b > 0 ? static_cast<double>(a) / static_cast<double>(b) : 0;
    };
    return {share(told, evaluation.trials.size()), share(right, told)};
}

Numbers draw_templates(const GestureIndex& index, Protocol protocol, std::uint32_t user, std::size_t count,
                       Random& random) {
    Numbers templates(index.gestures.size());
    for (std::size_t s = 0; s < index.gesture_of.size(); ++s) {
        const bool own = index.user_of[s] == user;
        const bool may = protocol == Protocol::random || own == (protocol == Protocol::user_dependent);
        if (may) templates[index.gesture_of[s]].push_back(s);
    }
    for (auto& numbers : templates) draw(numbers, count, random);
    return templates;
}

std::vector<Gesture> gestures_of(std::span<const Stroke> strokes, const GestureIndex& index,
                                 std::span<const std::vector<std::size_t>> templates) {
    std::vector<Gesture> gestures;
    for (std::size_t g = 0; g < templates.size(); ++g) {
        if (templates[g].empty()) continue;
        Gesture gesture{.name = index.gestures[g], .options = {}, .strokes = {}};
        for (const auto s : templates[g]) gesture.strokes.push_back(strokes[s].points);
        gestures.push_back(std::move(gesture));
    }
    return gestures;
}

Expected<Evaluation> evaluate(std::span<const Stroke> strokes, const EvaluationSettings& settings) {
    auto evaluation = Evaluator(strokes, settings).run();
    if (!evaluation) return evaluation;
    if (evaluation->trials.empty())
        return fail("no stroke is left to test; ask for fewer templates or give more strokes");
    if (!settings.own_calibration) {
        for (const auto group : groups_of(evaluation->trials)) calibrate_group(evaluation->trials, group);
    }
    sum_up(*evaluation);
    if (settings.unknown_share > 0) evaluation->open_set = open_set_of(evaluation->trials);
    return evaluation;
}

}  // namespace thaum::gesture

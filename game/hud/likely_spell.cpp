#include "game/hud/likely_spell.h"

#include <algorithm>
#include <cmath>

#include "gesture/prefix.h"

namespace thaum::game::inline hud {
namespace {

constexpr double check_s = 0.024;  // drawing time between two recognitions of an unfinished stroke (s)
constexpr std::uint32_t none = gesture::LikelyGesture::none;

bool is_same(const DrawnPoint& a, const DrawnPoint& b) {
    return a.x == b.x && a.y == b.y && a.z == b.z && a.force == b.force;
}

/// What was recognised in one unfinished stroke so far.
struct Answers {
    const GestureSet* gestures = nullptr;
    double apart_s{};
    std::uint32_t points{};  ///< number of points of the stroke at the last recognition
    DrawnPoint first{}, newest{};
    std::uint32_t told = none;

    /// Whether the stored recognitions are of an earlier part of this stroke.
    bool are_of(const CastingPicture& casting) const {
        const auto& stroke = casting.stroke;
        return points > 0 && gestures == casting.gestures.get() && apart_s == stroke.apart_s &&
               points <= stroke.count && is_same(stroke.points[0], first) &&
               is_same(stroke.points[points - 1], newest);
    }
};

/// Working memory of the search. Results kept from earlier pictures save time and do not change the answer.
struct LikelySpace {
    gesture::PrefixSpace prefix{};
    std::array<gesture::StrokePoint, StrokePicture::max_points> points{};
    /// Recognitions for the strokes of both players, the most recently used first.
    std::array<Answers, 2> answers{};

    Answers& answers_of(const CastingPicture& casting) {
        if (!answers[0].are_of(casting)) std::swap(answers[0], answers[1]);
        if (!answers[0].are_of(casting))
            answers[0] = {.gestures = casting.gestures.get(), .apart_s = casting.stroke.apart_s};
        return answers[0];
    }
};

gesture::Points points_of(const StrokePicture& stroke, LikelySpace& space) {
    for (std::uint32_t i = 0; i < stroke.count; ++i) {
        const auto& p = stroke.points[i];
        space.points[i] = {i * stroke.apart_s, vec3(p.x, p.y, p.z), p.force};
    }
    return gesture::Points(space.points).first(stroke.count);
}

bool is_long_enough(gesture::Points stroke, double least) {
    double length = 0;
    for (std::size_t i = 1; i < stroke.size() && length < least; ++i)
        length += glm::distance(stroke[i - 1].at, stroke[i].at);
    return length >= least;
}

/// The gesture that the screen shows at present for an unfinished stroke. It is computed from all
/// recognitions since the start of the stroke, so it depends only on the stroke.
std::uint32_t told_gesture(const CastingPicture& casting, LikelySpace& space) {
    const auto& stroke = casting.stroke;
    auto& answers = space.answers_of(casting);
    const auto whole = points_of(stroke, space);
    const auto every = static_cast<std::uint32_t>(std::max(1.0, std::floor(check_s / stroke.apart_s + 0.5)));
    for (auto n = answers.points + every; n <= stroke.count; n += every) {
        const auto so_far = whole.first(n);
        answers.told = is_long_enough(so_far, casting.rules->smallest)
                           ? casting.gestures->prefixes().tell(so_far, answers.told, space.prefix)
                           : none;
        answers.points = n;
        answers.first = stroke.points[0];
        answers.newest = stroke.points[n - 1];
    }
    return answers.told;
}

}  // namespace

const SpellPresentation* likely_spell(const CastingPicture& casting, const Presentation& shown) {
    const auto& stroke = casting.stroke;
    if (!stroke.drawing || stroke.on_brew || stroke.curve || stroke.chord || !casting.gestures)
        return nullptr;
    thread_local const auto space = std::make_unique<LikelySpace>();
    const auto told = told_gesture(casting, *space);
    if (told == none) return nullptr;
    const auto name = casting.gestures->name(told);
    const auto found = std::find_if(shown.spells.begin(), shown.spells.end(),
                                    [&](const auto& s) { return s.gesture == name; });
    return found == shown.spells.end() ? nullptr : &*found;
}

}  // namespace thaum::game::inline hud

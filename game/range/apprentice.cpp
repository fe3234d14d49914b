#include "game/range/apprentice.h"

#include <algorithm>
#include <cmath>

#include "game/components/cauldron.h"
#include "game/context/aim.h"
#include "game/data/wand_slots.h"

namespace thaum::game::inline range {
namespace {

constexpr Tick praise = ticks(1.5);  ///< time between a completed step and the next one (ticks)
constexpr double one_floor = 1.5;    ///< largest height difference between positions on the same floor (m)
/// Force of the ladle (the player's tool for stirring) above which it counts as pushing the brew (N)
constexpr double pushing_force = 1e-3;
constexpr double drift = 0.05;  ///< speed below which the ladle does not count as stirring (m/s)
constexpr double fallen = 2;    ///< depth below the step's place at which the player counts as fallen (m)
/// Displacement between two ticks that is too large for walking: the player was placed elsewhere (m)
constexpr double jump = 1;

double along_ground(vec3 way) { return std::hypot(way.x, way.z); }

/// State of the player's hand that the conditions of a lesson test.
struct Hand {
    const LoadedWand* wand{};
    std::optional<vec3> held{};
};

Hand hand_of(const Simulation& match, ecs::Entity wizard) {
    const auto* wand = wand_in_hand(match.data(), match.world().get<WandBelt>(wizard));
    if (wand == nullptr || match.world().has<Dead>(wizard)) return {};
    return {wand, wand->rules->held_at(match.world(), wizard)};
}

/// Whether the thing that the player holds is the first obstacle between the dummy's eye and a position.
bool stands_between(const Simulation& match, vec3 held, vec3 place) {
    const auto& world = match.world();
    const auto dummy = wizard_of(world, dummys);
    const vec3 eye = eye_of(match.data().wizard, world.get<Motion>(dummy).position);
    const auto hit = match.physics().ray(eye, place, physics::all_layers, dummy.index);
    const auto met = hit ? world.entity(hit->key) : ecs::Entity{};
    const auto* motion = met ? world.find<Motion>(met) : nullptr;
    return motion != nullptr && motion->position == held;
}

/// Whether the thing that the player holds hides the player's eye or the middle of the body from the dummy.
bool guards(const Simulation& match, ecs::Entity wizard, const Hand& hand) {
    if (!hand.held || !hand.wand->rules->grasp()) return false;
    const vec3 body = match.world().get<Motion>(wizard).position;
    return stands_between(match, *hand.held, body) ||
           stands_between(match, *hand.held, eye_of(match.data().wizard, body));
}

/// Distance that the ladle (the player's tool for stirring) moved through the brew since the last look,
/// parallel to the surface (m).
double way_stirred(const Simulation& match, ecs::Entity wizard) {
    const auto* ladle = match.world().find<Ladle>(wizard);
    if (ladle == nullptr || glm::length(ladle->force) < pushing_force) return 0;
    const double speed = along_ground(ladle->velocity);
    return speed < drift ? 0 : speed * gameplay_dt;
}

bool is_near(vec3 feet, vec3 place, double within) {
    return along_ground(feet - place) <= within && std::abs(feet.y - place.y) <= one_floor;
}

double readiness_of(const Simulation& match, ecs::Entity wizard, const Hand& hand, std::string_view wand) {
    if (hand.wand == nullptr || hand.wand->name != wand) return 0;
    return hand.wand->rules->readiness(match.world(), wizard).value_or(0);
}

/// Motion of the player since the match was last looked at.
struct Steps {
    double way{}, turn{};  ///< distance along the ground (m) and rotation of the view (rad)
    vec3 feet{};
};

/// New value of the quantity that a lesson's condition measures, given its value when the match was last
/// looked at. Events are counted in Apprentice::measure_events.
double measured(const Simulation& match, const Condition& condition, const Steps& steps, double before) {
    const auto wizard = wizard_of(match.world(), practising);
    const auto hand = hand_of(match, wizard);
    const auto timed = [&](bool on) { return before + (on ? gameplay_dt : 0); };
    switch (condition.kind) {
        case ConditionKind::moved: return before + steps.way;
        case ConditionKind::turned: return before + steps.turn;
        case ConditionKind::near:
            return is_near(steps.feet, condition.place, condition.amount) ? condition.amount : before;
        case ConditionKind::readiness:
            return std::max(before, readiness_of(match, wizard, hand, condition.wand));
        case ConditionKind::lifted: return timed(hand.held && hand.wand->rules->grasp());
        case ConditionKind::guarded: return timed(guards(match, wizard, hand));
        case ConditionKind::hung: return timed(hand.held && hand.wand->rules->rope());
        case ConditionKind::carried: return timed(match.world().has<Pouch>(wizard));
        case ConditionKind::stirred: return before + way_stirred(match, wizard);
        case ConditionKind::event: return before;
    }
    return before;
}

/// Whether the player stands far below the place of the lesson's step, as in a pit.
bool has_fallen(const Simulation& match, const LessonStep& step, vec3 feet) {
    const auto& stance = match.world().get<Stance>(wizard_of(match.world(), practising));
    return step.player && stance.grounded != 0 && feet.y < step.player->feet.y - fallen;
}

bool is_met(const Condition& condition, double reached) { return reached >= condition.amount * (1 - 1e-9); }

}  // namespace

void Apprentice::skip() {
    if (!is_over()) begin(at_ + 1);
}

void Apprentice::repeat() {
    if (!is_over()) begin(at_);
}

void Apprentice::begin(std::size_t step) {
    at_ = step;
    deed_ = 0;
    done_ = false;
    begins_ = true;
    reached_.assign(is_over() ? 0 : deed().conditions.size(), 0);
    to_place_ = {!is_over(), !is_over()};
}

void Apprentice::follow(const Simulation& match) {
    const auto now = now_ = match.match().played;
    if (is_over() || match.match().paused != 0 || now % gameplay_period != 0) return;
    if (begins_) {
        begins_ = false;
        since_ = placed_ = now;
        seen_events_ = match.events().count();
        reached_.assign(deed().conditions.size(), 0);
    } else {
        measure_events(match);
    }
    measure(match);
    if (to_place_[practising]) placed_ = now;
    advance(now);
}

DummyKind Apprentice::dummy_kind() const {
    if (is_over() || begins_ || now_ < placed_ + lessons_.steps[at_].dummy_waits) return DummyKind::still;
    return lessons_.steps[at_].dummy_kind;
}

/// Counts the player's events for the conditions of the present deed (thing to be done). A wizard who returns
/// to life appears at a pad, a place to start from. The wizard is then moved to the step's place again.
void Apprentice::measure_events(const Simulation& match) {
    match.events().each_new(seen_events_, [&](const Event& event) {
        if (event.kind == EventKind::spawn && event.subject < players) to_place_[event.subject] = true;
        for (std::size_t i = 0; i < reached_.size() && event.by == practising; ++i) {
            const auto& condition = deed().conditions[i];
            if (condition.kind == ConditionKind::event && condition.event == event.kind) ++reached_[i];
        }
    });
}

void Apprentice::measure(const Simulation& match) {
    const auto wizard = wizard_of(match.world(), practising);
    const auto& gaze = match.world().get<Gaze>(wizard);
    const vec3 place = match.world().get<Motion>(wizard).position;
    const double way = along_ground(place - last_place_);
    const double turn = std::hypot(angle_between(last_yaw_, gaze.yaw), gaze.pitch - last_pitch_);
    const bool placed = way > jump || begins_;
    last_place_ = place;
    last_yaw_ = gaze.yaw;
    last_pitch_ = gaze.pitch;
    const Steps steps{.way = placed ? 0 : way,
                      .turn = placed ? 0 : turn,
                      .feet = place - vec3(0, match.data().wizard.height / 2, 0)};
    if (done_) return;
    if (has_fallen(match, lessons_.steps[at_], steps.feet)) to_place_[practising] = true;
    for (std::size_t i = 0; i < reached_.size(); ++i)
        reached_[i] = measured(match, deed().conditions[i], steps, reached_[i]);
}

/// Goes on to the next deed (a thing that the player must do) or to the next step, if the present one is
/// completed.
void Apprentice::advance(Tick now) {
    if (done_) {
        if (now >= since_ + praise) begin(at_ + 1);
        return;
    }
    if (deed().soon && now > since_ + *deed().soon) {
        deed_ = 0;
        since_ = now;
        reached_.assign(deed().conditions.size(), 0);
        return;
    }
    const auto& conditions = deed().conditions;
    for (std::size_t i = 0; i < reached_.size(); ++i)
        if (!is_met(conditions[i], reached_[i])) return;
    since_ = now;
    done_ = ++deed_ == lessons_.steps[at_].deeds.size();
    if (done_)
        --deed_;
    else
        reached_.assign(deed().conditions.size(), 0);
}

double Apprentice::share() const {
    if (is_over() || done_) return 1;
    double part = 0;
    for (std::size_t i = 0; i < reached_.size(); ++i)
        part += std::min(1.0, reached_[i] / deed().conditions[i].amount);
    const auto deeds = static_cast<double>(lessons_.steps[at_].deeds.size());
    return (static_cast<double>(deed_) +
            part / static_cast<double>(std::max<std::size_t>(1, reached_.size()))) /
           deeds;
}

int Apprentice::percent() const {
    return std::min(static_cast<int>(100 * share()), is_over() || done_ ? 100 : 99);
}

}  // namespace thaum::game::inline range

#include "game/picture/picture.h"

#include <algorithm>
#include <cmath>

#include "game/components/fog.h"
#include "game/context/arms.h"
#include "game/context/hand_forces.h"
#include "game/context/shot.h"
#include "game/data/event_words.h"
#include "game/data/wand_slots.h"
#include "game/senses/tactile/felt_source.h"
#include "game/stations/cauldron/brewing.h"
#include "game/stations/cauldron/ladle.h"

namespace thaum::game::inline picture {
namespace {

constexpr double feed_seconds = 5;
constexpr double long_ago = 1e6;
/// Upper bound on the speed of anything that moves by itself (m/s). What was faster between two pictures has
/// been put elsewhere.
constexpr double fastest = 60;

/// Age of an event (s). The time of an event is in ticks of play.
double age(const Match& match, Tick at) { return match.played >= at ? seconds(match.played - at) : 0; }

ThingPicture thing_of(ecs::Entity e, const Motion& motion, const Look& look, const Body* body,
                      const Pad* pad) {
    ThingPicture thing{.entity = e.index,
                       .key = {.surface = look.surface},
                       .fixed = body == nullptr || body->mass <= 0,
                       .position = motion.position,
                       .orientation = motion.orientation};
    if (body != nullptr) {
        thing.key = {look.surface, body->shape, body->mesh, body->size};
    }
    if (pad != nullptr) thing.team = pad->player;
    return thing;
}

void take_things(const ecs::World& world, Picture& out) {
    out.things.clear();
    world.view<const Motion, const Look, ecs::Maybe<const Body>, ecs::Maybe<const Pad>>().each(
        [&](ecs::Entity e, const Motion& motion, const Look& look, const Body* body, const Pad* pad) {
            if (look.surface != Surface::wizard) out.things.push_back(thing_of(e, motion, look, body, pad));
        });
}

void take_missiles(const Simulation& match, Picture& out) {
    out.missiles.clear();
    const auto& wands = match.data().wands;
    for (std::uint32_t wand = 0; wand < wands.size(); ++wand) {
        wands[wand].rules->show(match.world(), [&](const Missile& m) {
            out.missiles.push_back({m.entity, m.player, m.position, m.velocity, wand, m.size});
        });
    }
}

void take_power_ups(const Simulation& match, Picture& out) {
    out.power_ups.clear();
    const auto played = match.match().played;
    match.world().view<const PowerUp, const Motion>().each([&](const PowerUp& p, const Motion& motion) {
        const auto again = match.data().rules.power_ups[static_cast<std::size_t>(p.kind)].again;
        const double left = p.back_at > played ? seconds(p.back_at - played) / seconds(again) : 0;
        out.power_ups.push_back({p.kind, motion.position, 1 - left});
    });
}

/// Computes the path of the shot for which a wand is being drawn, up to the first thing in its way.
void take_arc(const Simulation& match, ecs::Entity wizard, const ShotKind& shot, PlayerPicture& out) {
    constexpr double step_s = 0.06;
    const quat looking = look_rotation(out.vitals.yaw, out.vitals.pitch);
    vec3 place = out.vitals.eye + looking * (wand_tip + out.wand.reach);
    vec3 velocity = looking * vec3(0, 0, -shot.speed);
    while (out.wand.arc_points < out.wand.arc.size()) {
        const vec3 next = place + velocity * step_s + vec3(0, -shot.fall * step_s * step_s / 2, 0);
        const auto hit = match.physics().ray(place, next, physics::all_layers, wizard.index);
        out.wand.arc.at(out.wand.arc_points++) = hit ? hit->point : next;
        if (hit) return;
        place = next;
        velocity.y -= shot.fall * step_s;
    }
}

void take_belt(const Simulation& match, ecs::Entity wizard, const LoadedWand* wand, const WandBelt& belt,
               PlayerPicture& out) {
    out.wand.name = wand == nullptr ? std::string_view{} : std::string_view(wand->name);
    out.wand.number = wand == nullptr ? 0 : static_cast<std::uint32_t>(wand - match.data().wands.data());
    out.wand.energy = energy_in_hand(match.data(), belt);
    out.wand.energy_cap = wand == nullptr ? 0 : wand->stats.energy_cap;
    out.wand.readiness = wand != nullptr ? wand->rules->readiness(match.world(), wizard).value_or(0) : 0;
    out.wand.fired = belt.fired;
    const auto& wands = match.data().wands;
    for (std::size_t i = 0; i < wands.size(); ++i)
        out.wand.charges.at(i) = belt.energy[wands[i].stats.energy_slot];
}

/// Copies what a drawn wand shows: the path of its shot, and the spring of its sling.
void take_draw(const Simulation& match, ecs::Entity wizard, const LoadedWand* wand,
               const HandState& hand_state, PlayerPicture& out) {
    if (wand == nullptr || out.wand.readiness <= 0) return;
    const auto shot = wand->rules->shot(out.wand.readiness, match.data().wizard.gravity);
    if (!shot || !(shot->fall > 0)) return;
    take_arc(match, wizard, *shot, out);
    if (!(hand_state.tether.stiffness > 0)) return;
    const auto player = match.world().get<Wizard>(wizard).player;
    out.wand.spring = match.haptic_setup().wand_per_hand[player] * hand_state.tether.anchor;
}

void take_held(const Simulation& match, ecs::Entity wizard, const LoadedWand* wand, PlayerPicture& out) {
    if (wand == nullptr) return;
    out.wand.held = wand->rules->held_at(match.world(), wizard);
    out.wand.holds_thing = out.wand.held && wand->rules->grasp();
}

/// Fills in the target, which the crosshair marks: the thing that the wand would take hold of, or the foe for
/// a wand that shoots.
void take_target(const Simulation& match, ecs::Entity wizard, const LoadedWand* wand, PlayerPicture& out) {
    constexpr double foe_reach = 60;  // distance up to which a foe under the crosshair is marked (m)
    if (wand == nullptr || out.stations.works()) return;
    out.wand.target = wand->rules->target(match.context(), wizard);
    if (out.wand.target.kind != TargetKind::nothing || !wand->rules->shot(1, match.data().wizard.gravity))
        return;
    const auto [eye, ahead] = sight_of(match.context(), wizard);
    const auto hit = match.physics().ray(eye, eye + foe_reach * ahead, physics::all_layers, wizard.index);
    const auto met = hit ? match.world().entity(hit->key) : ecs::Entity{};
    if (met && match.world().has<Wizard>(met)) out.wand.target.kind = TargetKind::foe;
}

void take_force(const Simulation& match, ecs::Entity wizard, std::uint32_t player, const LoadedWand* wand,
                const HandState& hand_state, ForcePicture& out) {
    const auto& trace = match.felt(player);
    out.arm = arm_condition(match.world(), player);
    out.cause = static_cast<haptics::SafetyCause>(hand_state.servo.safety.cause);
    out.cap = match.haptic_setup().on[player] ? force_cap(match.haptic_setup(), player) : 0;
    out.current = hand_state.servo.safety.output;
    out.source = strongest_source(forces_on(match.world(), wizard),
                                  wand != nullptr ? wand->look.steady_force : std::string_view())
                     .name;
    out.created = hand_state.servo.energy.most_created;
    // The plot of the force on the hand has only complete columns, so a column that is shown never changes.
    // The oldest column of the ring buffer is being overwritten, so it is left out.
    const auto fills = match.match().played / force_column;
    for (std::size_t i = 0; i < out.strongest.size(); ++i) {
        const auto* from = &trace[(fills + 1 + i) * force_column % trace.size()];
        out.strongest[i] = *std::max_element(from, from + force_column);
    }
}

void take_brewing(const Simulation& match, ecs::Entity wizard, const Motion& motion, PlayerPicture& out) {
    const auto& rules = match.data().cauldron;
    if (!rules || out.vitals.dead) return;
    const auto* ladle = match.world().find<Ladle>(wizard);
    out.stations.stirs = ladle != nullptr;
    out.stations.refilled = ladle != nullptr && is_refilling(rules->aura, match.world(), match.brew(), *ladle,
                                                             match.match().played);
    const auto& cauldron = match.world().single<Cauldron>();
    out.stations.at_rim = within_reach(match.data(), cauldron, motion.position);
    out.stations.misses_rim =
        presses_stir(match.world(), wizard) && !out.stations.stirs && !out.stations.at_rim &&
        glm::length(motion.position - cauldron.middle) <
            match.data().arena.bowl->size.radius + rules->ladle.reach + missed_station_m;
    const auto* pouch = match.world().find<Pouch>(wizard);
    if (out.stations.stirs || out.stations.at_rim)
        take_recipe(match, match.world().get<Wizard>(wizard).player, wizard,
                    pouch != nullptr ? pouch->ingredient : no_ingredient, out.stations.recipe);
    if (pouch == nullptr) return;
    const auto& ingredient = rules->ingredients[pouch->ingredient];
    out.stations.carries = ingredient.name;
    out.stations.carried_colour = fvec3(ingredient.colour);
    out.stations.carried_shape = ingredient.shape;
}

void take_effects(const Simulation& match, ecs::Entity wizard, const Health& health, PlayerPicture& out) {
    const auto played = match.match().played;
    out.vitals.poisoned_s = played < health.poisoned_until ? seconds(health.poisoned_until - played) : 0;
    if (out.vitals.dead) return;
    const auto* half = match.world().find<WorkHalf>(wizard);
    out.stations.work_half = half != nullptr && half->held != 0;
    const auto& effects = match.world().get<Effects>(wizard);
    std::string_view giver;
    for (const auto& one : match.data().effects) {
        const auto until = effects.until.at(one.number);
        if (played >= until) continue;
        if (one.giver != giver && out.vitals.givers == out.vitals.giver_names.size()) return;
        if (one.giver != giver) giver = out.vitals.giver_names.at(out.vitals.givers++) = one.giver;
        auto& left = out.vitals.giver_left_s.at(out.vitals.givers - 1);
        left = std::max(left, seconds(until - played));
    }
}

void take_niches(const Simulation& match, Picture& out) {
    out.niches.clear();
    match.world().view<const Niche, const Motion>().each([&](const Niche& niche, const Motion& motion) {
        const auto& ingredient = match.data().cauldron->ingredients[niche.ingredient];
        out.niches.push_back({.position = motion.position,
                              .colour = fvec3(ingredient.colour),
                              .shape = ingredient.shape,
                              .there = match.match().played >= niche.back_at});
    });
}

/// Time in which a cloud of fog appears, and also in which it vanishes (s).
constexpr double fog_spreads = 0.4;

void take_fogs(const Simulation& match, Picture& out) {
    out.fogs.clear();
    const auto played = match.match().played;
    match.world().view<const Fog, const Motion>().each([&](const Fog& fog, const Motion& motion) {
        if (played >= fog.until) return;
        const double age_s = played > fog.began ? seconds(played - fog.began) : 0;
        const double left_s = seconds(fog.until - played);
        out.fogs.push_back({.place = motion.position,
                            .radius = fog.radius,
                            .sight = fog.sight,
                            .strength = std::min({1.0, age_s / fog_spreads, left_s / fog_spreads})});
    });
}

/// Copies the wizard's work at cauldron, orb and crystals, and the strokes and spells.
void take_magic(const Simulation& match, ecs::Entity wizard, std::uint32_t player, const Motion& motion,
                const Health& health, PlayerPicture& out) {
    take_brewing(match, wizard, motion, out);
    take_effects(match, wizard, health, out);
    take_casting(match, wizard, player, out.casting);
    take_work(match, wizard, player, out.stations.work);
    if (out.vitals.dead) return;
    take_scrying(match, wizard, player, out.stations.scrying);
    take_carving(match, wizard, player, out.stations.carving);
}

void take_wizards(const Simulation& match, Picture& out) {
    const auto& rules = match.data().wizard;
    const auto& state = match.match();
    match.world()
        .view<const Wizard, const Motion, const Gaze, const Health, const WandBelt, const HandState,
              const Score, ecs::Maybe<const Dead>>()
        .each([&](ecs::Entity e, const Wizard& wizard, const Motion& motion, const Gaze& gaze,
                  const Health& health, const WandBelt& belt, const HandState& hand_state, const Score& score,
                  const Dead* dead) {
            auto& p = out.wizards[wizard.player];
            p = {};
            p.vitals.centre = motion.position;
            p.vitals.eye = eye_of(rules, motion.position);
            p.vitals.yaw = gaze.yaw;
            p.vitals.pitch = gaze.pitch;
            p.vitals.dead = dead != nullptr;
            p.vitals.shielded = !p.vitals.dead && state.played < health.shielded_until;
            p.vitals.lives = static_cast<std::uint32_t>(score.deaths) * 2 + (p.vitals.dead ? 1 : 0);
            p.vitals.health = std::max(health.points, 0.0);
            p.vitals.health_full = rules.health;
            p.vitals.health_cap = rules.health_cap;
            p.vitals.kills = score.kills;
            p.vitals.deaths = score.deaths;
            p.senses.since_hit_s = p.senses.since_warning_s = p.senses.since_gift_s = long_ago;
            if (dead != nullptr && dead->returns_at > state.played)
                p.vitals.returns_in_s = seconds(dead->returns_at - state.played);
            const auto* wand = wand_in_hand(match.data(), belt);
            take_belt(match, e, wand, belt, p);
            if (!p.vitals.dead) take_held(match, e, wand, p);
            p.wand.reach =
                wand_tip_of(match.haptic_setup().wand_per_hand[wizard.player], hand_state) - wand_tip;
            p.wand.turn = stylus_turn(match.world(), wizard.player);
            if (!p.vitals.dead) take_draw(match, e, wand, hand_state, p);
            take_force(match, e, wizard.player, wand, hand_state, p.senses.force);
            take_magic(match, e, wizard.player, motion, health, p);
            if (!p.vitals.dead) take_target(match, e, wand, p);
        });
}

vec3 direction(vec3 from, vec3 to) {
    const vec3 d = to - from;
    const double length = glm::length(d);
    return length > 1e-6 ? d / length : vec3(0);
}

/// Mark for the direction of a hurt: towards the player who caused it, or else towards the place of the
/// event.
HurtMark mark_of(const Picture& picture, const Event& event, HudMark how, double age_s) {
    const auto& victim = picture.wizards[event.subject];
    HurtMark mark{.age_s = age_s};
    if (event.by < players && event.by != event.subject)
        mark.towards = direction(victim.vitals.eye, picture.wizards[event.by].vitals.eye);
    else if (how != HudMark::fall)
        mark.towards = direction(victim.vitals.centre, event.place);
    return mark;
}

void note_hurt(const Event& event, HudMark how, double age_s, Picture& out) {
    if (event.by < players && event.by != event.subject)
        out.wizards[event.by].senses.since_hit_s = std::min(out.wizards[event.by].senses.since_hit_s, age_s);
    auto& victim = out.wizards[event.subject];
    if (age_s < mark_seconds && victim.senses.hurts < victim.senses.marks.size())
        victim.senses.marks[victim.senses.hurts++] = mark_of(out, event, how, age_s);
}

void note_gift(const Event& event, double age_s, PlayerPicture& out) {
    if (age_s >= out.senses.since_gift_s) return;
    out.senses.since_gift_s = age_s;
    out.senses.gift = event;
}

void note_warning(const Event& event, double age_s, PlayerPicture& out) {
    if (age_s >= out.senses.since_warning_s) return;
    out.senses.since_warning_s = age_s;
    out.senses.warning = event.kind;
}

void note_mark(const Event& event, HudMark mark, double age_s, Picture& out) {
    switch (mark) {
        case HudMark::none: break;
        case HudMark::hit:
        case HudMark::fall: note_hurt(event, mark, age_s, out); break;
        case HudMark::warning: note_warning(event, age_s, out.wizards[event.subject]); break;
        case HudMark::gift: note_gift(event, age_s, out.wizards[event.subject]); break;
    }
}

/// Name of the thing that killed a player, taken from the last blow before the death: "barrel". Empty if it
/// was no thing.
std::string_view thing_that_killed(const EventJournal& events, std::uint64_t death) {
    const auto& event = events[death];
    if (event.kind != EventKind::death || static_cast<EventKind>(event.detail) != EventKind::object_hit)
        return {};
    for (auto i = death; i > events.first(); --i) {
        const auto& blow = events[i - 1];
        const bool his = blow.kind == EventKind::object_hit && blow.subject == event.subject;
        if (his && blow.detail < surface_names.size()) return surface_names.at(blow.detail);
    }
    return {};
}

void note(const EventJournal& events, std::uint64_t number, double age_s, Picture& out) {
    const auto& event = events[number];
    if (event.subject >= players) return;
    const auto& row = row_of(out.shown->events, event.kind);
    note_mark(event, row.mark, age_s, out);
    if (event.kind == EventKind::burst && age_s < burst_seconds && out.burst_count < out.bursts.size())
        out.bursts[out.burst_count++] = {age_s, event.subject, event.place, event.amount};
    if (event.kind == EventKind::cast && age_s < cast_seconds && out.cast_count < out.casts.size())
        out.casts[out.cast_count++] = {age_s, event.subject, sign_of(*out.shown, event.detail), event.amount,
                                       event.place};
    if (!feed_pattern(row, event).empty() && age_s < feed_seconds && out.feed_lines < out.feed.size())
        out.feed[out.feed_lines++] = {age_s, event, thing_that_killed(events, number)};
}

/// Copies events, the newest first, so that a full list lacks only the oldest. Events too old to be shown are
/// left out.
void take_events(const Simulation& match, Picture& out) {
    const auto& events = match.events();
    out.feed_lines = out.burst_count = out.cast_count = 0;
    for (auto i = events.count(); i > events.first(); --i) {
        const auto age_s = age(match.match(), events[i - 1].tick);
        if (age_s > feed_seconds) break;
        note(events, i - 1, age_s, out);
    }
    std::reverse(out.feed.begin(), out.feed.begin() + out.feed_lines);
}

void take_round(const Simulation& match, Picture& out) {
    const auto& m = match.match();
    const auto& rules = match.data().round;
    out.tick = match.now();
    out.played_s = seconds(m.played);
    const auto end = round_ends_at(rules, m);
    out.left_s = end > m.played ? seconds(end - m.played) : 0;
    out.boils_over = m.phase == Phase::playing && m.boils_over_since != 0;
    out.surge = m.phase == Phase::playing ? surge_at(rules, m.played - m.round_began) : 1;
    out.phase = m.phase;
    out.ending = m.ending;
    out.winner = m.winner;
    out.match_winner = ahead(m);
    out.round = m.round;
    out.rounds = rules.rounds;
    out.rounds_won = m.rounds_won;
    out.next_round_in_s = m.phase == Phase::between ? seconds(rules.interval - m.waited) : 0;
    out.match_stats = match.world().single<EventLog>().match_stats;
    out.paused = m.paused != 0;
    out.paused_by = m.paused_by;
    out.skipped = m.skipped;
    out.kills_to_win = rules.kills;
}

bool jumped(vec3 from, vec3 to, double dt) {
    // The extra 1 m allows for a body that the solver pushes out of an overlap in one step.
    return !(glm::length(to - from) <= 1 + fastest * dt);
}

/// Interpolates an angle, the short way across +-pi.
double turned(double from, double to, double alpha) {
    return from + alpha * std::remainder(to - from, 2 * pi);
}

void interpolate_thing(const ThingPicture& from, double alpha, double dt, ThingPicture& to) {
    if (to.fixed || jumped(from.position, to.position, dt)) return;
    to.position = glm::mix(from.position, to.position, alpha);
    to.orientation = glm::slerp(from.orientation, to.orientation, alpha);
}

void interpolate_wizard(const PlayerPicture& from, double alpha, double dt, PlayerPicture& to) {
    if (from.vitals.lives != to.vitals.lives || jumped(from.vitals.centre, to.vitals.centre, dt)) return;
    to.vitals.centre = glm::mix(from.vitals.centre, to.vitals.centre, alpha);
    to.vitals.eye = glm::mix(from.vitals.eye, to.vitals.eye, alpha);
    to.vitals.yaw = turned(from.vitals.yaw, to.vitals.yaw, alpha);
    to.vitals.pitch = glm::mix(from.vitals.pitch, to.vitals.pitch, alpha);
    to.wand.reach = glm::mix(from.wand.reach, to.wand.reach, alpha);
    if (from.wand.held && to.wand.held) to.wand.held = glm::mix(*from.wand.held, *to.wand.held, alpha);
    to.wand.readiness = glm::mix(from.wand.readiness, to.wand.readiness, alpha);
}

}  // namespace

Picture make_picture() {
    Picture picture;
    picture.things.reserve(1024);
    picture.missiles.reserve(256);
    picture.power_ups.reserve(64);
    picture.fogs.reserve(16);
    return picture;
}

void take_picture(const Simulation& match, Picture& out) {
    out.overloaded = false;
    out.data = match.shared_data();
    out.shown = match.data().presentation;
    take_round(match, out);
    take_things(match.world(), out);
    take_missiles(match, out);
    take_power_ups(match, out);
    take_niches(match, out);
    take_fogs(match, out);
    take_cauldron(match, out.cauldron);
    take_orb(match, out.orb);
    take_crystals(match, out.crystals);
    take_wizards(match, out);
    take_events(match, out);
}

int seconds_to_start(const Picture& picture) {
    constexpr double counted = 3;
    if (picture.countdown > 0) return picture.countdown;
    if (picture.phase != Phase::between || picture.next_round_in_s > counted) return 0;
    return std::max(1, static_cast<int>(std::ceil(picture.next_round_in_s)));
}

void interpolate(const Picture& from, const Picture& to, double alpha, Picture& out) {
    out = to;
    if (from.tick >= to.tick) return;
    const double dt = seconds(to.tick - from.tick);
    for (std::size_t i = 0; i < out.things.size(); ++i) {
        auto& thing = out.things[i];
        // Both lists of things have the same order, so the thing usually has the same index, unless one came
        // or went.
        const auto same = [&](const ThingPicture& t) { return t.entity == thing.entity; };
        const auto found = i < from.things.size() && same(from.things[i])
                               ? from.things.begin() + static_cast<std::ptrdiff_t>(i)
                               : std::find_if(from.things.begin(), from.things.end(), same);
        if (found != from.things.end()) interpolate_thing(*found, alpha, dt, thing);
    }
    for (auto& missile : out.missiles) {
        const auto found = std::find_if(from.missiles.begin(), from.missiles.end(),
                                        [&](const MissilePicture& m) { return m.entity == missile.entity; });
        if (found != from.missiles.end())
            missile.position = glm::mix(found->position, missile.position, alpha);
    }
    for (std::size_t p = 0; p < players; ++p) interpolate_wizard(from.wizards[p], alpha, dt, out.wizards[p]);
}

}  // namespace thaum::game::inline picture

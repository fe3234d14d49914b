#include "game/senses/tactile/tactile_scene.h"

#include <algorithm>
#include <cmath>

#include "game/components/hand_state.h"
#include "game/match/great_work.h"
#include "game/match/hurt_side.h"

namespace thaum::game::inline senses {
namespace {

constexpr double full_harm = 60;         ///< harm at which an event is felt at full strength (HP)
constexpr double full_recoil = 3;        ///< kick of the hand at which a shot is felt at full strength (N)
constexpr double full_drag = 20;         ///< drag on the ladle at which stirring is felt at full strength (N)
constexpr Tick quiet_after_event = 250;  ///< time after an event for which no sounds are felt (ticks)
constexpr double chest = 1.15;           ///< assumed height above the feet of a blow whose height is unknown
                                         ///< (m)

/// Smallest change of an arm's angle that is passed to the mixers (rad)
constexpr double min_raise = 0.02;

/// Keys by which lasting effects are known from frame to frame.
constexpr std::uint32_t heart_key = 1, stir_key = 2, work_key = 3, first_sound_key = 10;

/// Part of the body on which a player feels an event. It is on the side of the event's position, or on the
/// side of the player who caused the event.
tactile::Where where_of(const Simulation& match, const Event& event, std::uint32_t player) {
    const auto& world = match.world();
    const auto wizard = wizard_of(world, player);
    const auto way = way_to_cause(match, event, player);
    if (!way) return tactile::Where::own();
    const double feet = world.get<Motion>(wizard).position.y - match.data().wizard.height / 2;
    const double height = info_of(event.kind).placed ? std::clamp(event.place.y - feet, 0.9, 1.35) : chest;
    return tactile::Where::from(tactile::to_body_frame(*way, world.get<Gaze>(wizard).yaw), height);
}

bool has_arms(const tactile::Layout& layout) {
    return std::any_of(layout.actuators.begin(), layout.actuators.end(), [](const auto& actuator) {
        const auto region = tactile::region_of(actuator.place.part);
        return region != tactile::Region::torso && region != tactile::Region::whole;
    });
}

/// Angle of the arm that holds the wand, counted forwards from hanging down (rad). The wand points where the
/// wizard looks; the arm of a dead wizard hangs down.
double raised_arm(const Simulation& match, std::uint32_t player) {
    const auto& world = match.world();
    const auto wizard = wizard_of(world, player);
    return world.has<Dead>(wizard) ? 0 : std::clamp(pi / 2 + world.get<Gaze>(wizard).pitch, 0.0, pi);
}

}  // namespace

tactile::Faders figure_faders() {
    tactile::Faders faders;
    faders.of(tactile::Purpose::recoil) = 0;
    return faders;
}

double since_felt_s(Tick now, Tick felt_at) {
    return felt_at == 0 ? 1e6 : seconds(now - std::min(now, felt_at));
}

TactileScene::TactileScene(const MatchEffects& effects, const tactile::EffectBank& bank, std::uint32_t player)
    : effects_(effects), bank_(bank), player_(player) {
    cues_.reserve(256);
}

std::size_t TactileScene::add(const tactile::Layout& layout) {
    outputs_.push_back(
        {.mixer = std::make_unique<tactile::TactileMixer>(layout, bank_), .has_arms = has_arms(layout)});
    if (outputs_.back().has_arms) {
        any_arms_ = true;
        outputs_.back().mixer->set_pose(tactile::pose_with_arms(0, raised_));
    }
    return outputs_.size() - 1;
}

void TactileScene::set_used(std::size_t layout, bool used) {
    auto& output = outputs_[layout];
    if (output.used == used) return;
    output.used = used;
    output.mixer->stop();
    output.frame = {};
}

void TactileScene::set_faders(std::size_t layout, const tactile::Faders& faders) {
    outputs_[layout].mixer->set_faders(faders);
}

void TactileScene::feel(const BodyCue& cue, Tick now) {
    if (cues_.size() < cues_.capacity()) cues_.push_back(cue);
    for (auto& output : outputs_) {
        if (!output.used) continue;
        if (cue.key == 0)
            output.mixer->start(cue.effect, cue.where, cue.strength, now);
        else
            output.mixer->drive(cue.key, cue.effect, cue.where, cue.strength, now);
    }
}

/// Starts an effect on the body, unless its file is missing or faulty (`effect` has no number).
void TactileScene::feel(const EffectNumber& effect, BodyCue cue, Tick now) {
    if (!effect) return;
    cue.effect = *effect;
    feel(cue, now);
}

void TactileScene::feel_event(const Simulation& match, const Event& event) {
    const bool about_spell = row_of(match.data().presentation->events, event.kind).tactile == of_spell;
    const auto& effects = about_spell ? effects_.spells : effects_.events;
    const auto number = about_spell ? event.detail : static_cast<std::size_t>(event.kind);
    if (event.subject != player_ || number >= effects.size() || !effects[number]) return;
    quiet_until_ = match.now() + quiet_after_event;
    const bool strikes = strikes_body(event.kind);
    feel({.effect = *effects[number],
          .where = strikes ? where_of(match, event, player_) : tactile::Where::own(),
          .strength = strikes ? std::clamp(event.amount / full_harm, 0.0, 1.0) : 1,
          .event = event.kind},
         match.now());
}

void TactileScene::feel_events(const Simulation& match) {
    follower_.each_event(match, [&](const Event& event) { feel_event(match, event); });
}

/// Moves the right arm, which holds the wand, as the wizard does, on layouts that have motors on the arms.
void TactileScene::follow_arm(const Simulation& match, bool anew) {
    if (!any_arms_) return;
    const double raised = raised_arm(match, player_);
    if (!anew && std::abs(raised - raised_) < min_raise) return;
    raised_ = raised;
    const auto pose = tactile::pose_with_arms(0, raised);
    for (auto& output : outputs_)
        if (output.has_arms) output.mixer->set_pose(pose);
}

void TactileScene::feel_steps(const Simulation& match, ecs::Entity wizard) {
    const auto& world = match.world();
    if (!stride_.walks(world.get<Stance>(wizard), world.get<Motion>(wizard), seconds(tactile::frame_ticks)))
        return;
    left_foot_ = !left_foot_;
    feel(left_foot_ ? effects_.walk_left : effects_.walk_right, {}, match.now());
}

void TactileScene::feel_own(const Simulation& match) {
    const auto& world = match.world();
    const auto wizard = wizard_of(world, player_);
    const auto& belt = world.get<WandBelt>(wizard);
    if (fired_ != belt.fired) {
        const double kick = glm::length(world.get<HandState>(wizard).kick.peak);
        feel(effects_.recoil, {.strength = std::clamp(kick / full_recoil, 0.2, 1.0)}, match.now());
    }
    fired_ = belt.fired;
    if (world.has<Dead>(wizard)) return;
    feel_steps(match, wizard);
    feel_foes_work(match);
    const double health = world.get<Health>(wizard).points / match.data().wizard.health;
    if (health > 0 && health < loud_heart_health)
        feel(effects_.heartbeat, {.strength = 1 - health / loud_heart_health, .key = heart_key}, match.now());
    if (const auto* ladle = world.find<Ladle>(wizard)) {
        const double drag = std::min(1.0, glm::length(ladle->force) / full_drag);
        if (drag > 0) feel(effects_.stir, {.strength = drag, .key = stir_key}, match.now());
    }
}

/// If the foe holds both Azoth and the Lens (two rare things), and so is about to win, the player feels a
/// heartbeat. It becomes faster the longer the foe holds them.
void TactileScene::feel_foes_work(const Simulation& match) {
    const auto& world = match.world();
    if (!match.data().crystal || world.count<GreatWork>() == 0) return;
    const auto held = held_both_for(world, 1 - player_, match.match().played);
    if (held == 0) return;
    const double share = seconds(held) / std::max(seconds(match.data().crystal->work_lasts), 1e-3);
    feel(effects_.great_work, {.strength = std::min(share, 1.0), .key = work_key}, match.now());
}

/// Lets the player feel sounds. For a moment after each event they are silent, so that only the event is
/// felt.
void TactileScene::feel_sound(Tick now) {
    constexpr double least = 1.0 / 256;  // smallest strength that is played; less starts no motor
    const bool quiet = now < quiet_until_ && quiet_until_ - now <= quiet_after_event;
    for (std::uint32_t band = 0; band < felt_bands; ++band) {
        const double strength = quiet || sound_.at(band) < least ? 0 : sound_.at(band);
        const bool ends = strength == 0 && sounding_.at(band);
        if ((strength == 0 && !ends) || !effects_.sounds.at(band)) continue;
        sounding_.at(band) = !ends;
        for (auto& output : outputs_)
            if (output.used && output.hears)
                output.mixer->drive(first_sound_key + band, *effects_.sounds.at(band), tactile::Where::own(),
                                    strength, now);
    }
}

void TactileScene::take(const Simulation& match) {
    cues_.clear();
    const bool followed = follower_.goes_on(match);
    const bool paused = match.match().paused != 0;
    follow_arm(match, !followed);
    if (!followed || paused) {
        for (auto& output : outputs_) output.mixer->stop();
    }
    if (!followed) {
        follower_.skip_events(match);
        fired_ = match.world().get<WandBelt>(wizard_of(match.world(), player_)).fired;
        stride_ = {};
    } else if (!paused) {
        feel_events(match);
        if (match.match().phase == Phase::playing) feel_own(match);
        feel_sound(match.now());
    }
    follower_.look(match);
    for (auto& output : outputs_)
        if (output.used) output.frame = output.mixer->mix(match.now());
}

}  // namespace thaum::game::inline senses

#include "game/senses/felt_words.h"

#include <cmath>

#include "game/data/wand_slots.h"

namespace thaum::game::inline senses {
namespace {

/// Force on the hand above which its source is put into words, and the lower force at which the words end
/// (N). The difference keeps the words from flickering.
constexpr double told_from_n = 0.15, told_to_n = 0.08;
/// Minimum time for which a force is described with the same side, so that words do not flicker while the
/// force turns (ticks).
constexpr Tick min_time_of_side = 1000;

/// Name of the wand's steady force: the one in its data file (the look), or "wand" if it has none.
std::string_view steady_words(const Simulation& match, ecs::Entity wizard) {
    static const WandLook plain;
    const auto* wand = wand_in_hand(match.data(), match.world().get<WandBelt>(wizard));
    if (wand == nullptr || wand->look.steady_force == plain.steady_force) return "wand";
    return wand->look.steady_force;
}

/// Side of the body on which an effect is felt. No side for an effect that defines its own places on the
/// body.
HeardFrom side_of(const BodyCue& cue, const tactile::Effect& effect) {
    if (cue.where.kind != tactile::Where::Kind::from || !effect.places.empty()) return HeardFrom::here;
    const vec3 from = cue.where.direction;
    if (std::abs(from.z) >= std::abs(from.x)) return from.z > 0 ? HeardFrom::ahead : HeardFrom::behind;
    return from.x > 0 ? HeardFrom::right : HeardFrom::left;
}

}  // namespace

HeardFrom side_of_force(vec3 newtons) {
    const vec3 size = glm::abs(newtons);
    if (size.y >= size.x && size.y >= size.z) return newtons.y > 0 ? HeardFrom::above : HeardFrom::below;
    if (size.x >= size.z) return newtons.x > 0 ? HeardFrom::right : HeardFrom::left;
    return newtons.z > 0 ? HeardFrom::behind : HeardFrom::ahead;
}

void HandWords::take(const Simulation& match, std::uint32_t player, HeardLines& lines) {
    const auto wizard = wizard_of(match.world(), player);
    const auto forces = forces_on(match.world(), wizard);
    for (std::size_t i = 0; i < force_sources; ++i) {
        auto& told = told_.at(i);
        const bool was_on = told.on;
        told.on = glm::length(forces.at(i)) > (was_on ? told_to_n : told_from_n);
        if (!told.on) continue;
        if (!was_on || match.now() < told.side_since || match.now() - told.side_since >= min_time_of_side) {
            const auto side = side_of_force(forces.at(i));
            if (!was_on || side != told.side) told.side_since = match.now();
            told.side = side;
        }
        const auto& words = force_words.at(i);
        const bool kick = i == static_cast<std::size_t>(ForceSource::recoil);
        lines.add({.words = words.words.empty() ? steady_words(match, wizard) : words.words,
                   .from = kick ? HeardFrom::here : told.side,
                   .verb = words.verb});
    }
}

ToldBySounds told_by_sounds(const MatchSounds& sounds, const audio::SoundBank& bank) {
    const auto tells = [&](const SoundNumber& number) {
        return number && !bank.sounds[*number].caption.empty();
    };
    const auto cue = [&](Cue of) { return tells(sounds.cues.at(static_cast<std::size_t>(of))); };
    ToldBySounds told{.heart = cue(Cue::heartbeat), .stir = cue(Cue::stir), .steps = cue(Cue::step_stone)};
    for (const auto& number : sounds.events) told.events.push_back(tells(number));
    return told;
}

void add_body_words(const TactileScene& scene, const MatchEffects& effects, const tactile::EffectBank& bank,
                    const ToldBySounds& sounds, HeardLines& lines) {
    const auto is_told = [&](const BodyCue& cue) {
        if (cue.event != EventKind::none) return sounds.tells(cue.event);
        const bool step = cue.effect == effects.walk_left || cue.effect == effects.walk_right;
        return cue.effect == effects.recoil || (step && sounds.steps) ||
               (cue.effect == effects.heartbeat && sounds.heart) ||
               (cue.effect == effects.stir && sounds.stir);
    };
    for (const auto& cue : scene.cues()) {
        const auto& effect = bank.effects[cue.effect];
        if (effect.caption.empty() || is_told(cue)) continue;
        const auto side = side_of(cue, effect);
        lines.add({.words = effect.caption,
                   .from = side,
                   .important = effect.important,
                   .own = side != HeardFrom::here});
    }
}

}  // namespace thaum::game::inline senses

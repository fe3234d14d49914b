#include "game/hud/prompts.h"

#include "core/text.h"

namespace thaum::game::inline hud {
namespace {

struct Offer {
    PromptKind kind{};
    const std::string* control{};
    std::string what;
    std::string before{};  ///< text for what the player must do before: "Hold [E], then "
};

/// The spell with the lowest wand key, for a player who is hurt, has no shield and has enough
/// focus for it; null for other players.
const SpellStats* spell_in_need(const PlayerPicture& p) {
    constexpr double hurt_below = 0.8;  // share of full health below which a player counts as hurt
    const auto& casting = p.casting;
    if (!casting.there || casting.first_spell == nullptr || casting.stroke.drawing || casting.ward > 0)
        return nullptr;
    if (p.vitals.health > hurt_below * p.vitals.health_full || casting.focus < casting.first_spell->focus)
        return nullptr;
    return casting.first_spell;
}

/// Whether the carried ingredient would spoil the recipe that the brew follows.
bool would_spoil(std::string_view carried, const RecipePicture& recipe) {
    return recipe.step == RecipeStep::stroke ||
           (recipe.step == RecipeStep::ingredient && recipe.next != carried);
}

/// Whether the recipe's next step must still wait until the newest ingredient is mixed well enough.
bool is_too_soon(const RecipePicture& recipe) {
    return recipe.step == RecipeStep::ingredient && recipe.reached < recipe.least;
}

/// The prompt for a player who stands at the cauldron's rim without holding the ladle. There the control for
/// fire still shoots the wand, so a player who carries an ingredient is told to stir first and then to drop
/// it.
Offer offer_at_rim(const PlayerPicture& p, const ControlNames& controls) {
    const bool strays = p.stations.recipe.step == RecipeStep::ingredient && !p.stations.recipe.secret;
    if (!p.stations.carries.empty() && strays && would_spoil(p.stations.carries, p.stations.recipe))
        return {PromptKind::put_away, &controls.throw_, text("Put away ", p.stations.carries)};
    const bool drops =
        p.stations.recipe.step != RecipeStep::stroke && p.stations.recipe.step != RecipeStep::spoilt;
    if (p.stations.carries.empty() || !drops || is_too_soon(p.stations.recipe) || controls.stir.empty())
        return {PromptKind::stir, &controls.stir, "Stir"};
    return {PromptKind::drop, &controls.fire, text("Drop ", p.stations.carries),
            text(capitalised(hold_or_press(controls.stir_toggles)), "[", controls.stir, "], then ")};
}

/// Returns the one prompt for the player: the most urgent action among those possible now.
std::optional<Offer> offer_to(const PlayerPicture& p, const ControlNames& controls) {
    if (p.vitals.dead) return std::nullopt;
    if (p.stations.stirs && !p.stations.carries.empty() && would_spoil(p.stations.carries, p.stations.recipe))
        return Offer{PromptKind::put_away, &controls.throw_, text("Put away ", p.stations.carries)};
    if (p.stations.stirs) {
        if (p.stations.carries.empty() || is_too_soon(p.stations.recipe)) return std::nullopt;
        return Offer{PromptKind::drop, &controls.fire, text("Drop ", p.stations.carries)};
    }
    if (p.stations.scrying.scries && !p.stations.scrying.draws && !p.stations.scrying.told &&
        p.stations.scrying.newest < max_orb_modes)
        return Offer{PromptKind::draw_curve, &controls.trace,
                     text("Draw the strength of ", p.stations.scrying.modes.at(p.stations.scrying.newest))};
    if (p.stations.scrying.scries || p.stations.carving.carves) return std::nullopt;
    if (p.stations.at_rim) return offer_at_rim(p, controls);
    if (p.stations.scrying.near && p.stations.scrying.faces)
        return Offer{PromptKind::scry, &controls.stir, "Scry"};
    if (p.stations.carving.near && p.stations.carving.faces)
        return Offer{PromptKind::carve, &controls.stir, "Carve"};
    if (p.wand.holds_thing) return Offer{PromptKind::throw_thing, &controls.throw_, "Throw"};
    if (p.wand.held) return std::nullopt;
    if (p.wand.target.kind == TargetKind::take) return Offer{PromptKind::lift, &controls.fire, "Lift"};
    if (p.wand.target.kind == TargetKind::hook) return Offer{PromptKind::swing, &controls.fire, "Swing"};
    if (const auto* spell = spell_in_need(p))
        return Offer{PromptKind::cast, &controls.trace, text("Draw ", spell->gesture, ": ", spell->shown)};
    return std::nullopt;
}

void count_uses(const PlayerPicture& before, const PlayerPicture& after, std::uint32_t player,
                PromptUses& uses) {
    const auto done = [&](PromptKind kind) { ++uses.of(player, kind); };
    if (before.vitals.lives != after.vitals.lives || after.vitals.dead) return;
    if (!before.stations.stirs && after.stations.stirs) done(PromptKind::stir);
    if (!before.stations.scrying.scries && after.stations.scrying.scries) done(PromptKind::scry);
    if (!before.stations.scrying.draws && after.stations.scrying.draws) done(PromptKind::draw_curve);
    if (!before.stations.carving.carves && after.stations.carving.carves) done(PromptKind::carve);
    const bool hands_free = !before.stations.carries.empty() && after.stations.carries.empty();
    const bool put_away =
        after.senses.gift.kind == EventKind::put_away && after.senses.gift.tick != before.senses.gift.tick;
    if (hands_free && (after.stations.stirs || put_away))
        done(put_away ? PromptKind::put_away : PromptKind::drop);
    if (!before.wand.held && after.wand.held)
        done(after.wand.holds_thing ? PromptKind::lift : PromptKind::swing);
    const auto& reading = after.casting.reading;
    if (reading.outcome == StrokeOutcome::cast && reading.age_s < before.casting.reading.age_s)
        done(PromptKind::cast);
    if (before.wand.holds_thing && !after.wand.held && after.wand.fired != before.wand.fired)
        done(PromptKind::throw_thing);
}

/// The station that the player has tried to use from too far away, or from which the player was just pushed
/// away.
std::optional<StationKind> missed_station(const PlayerPicture& before, const PlayerPicture& after) {
    const bool lost_crystal = before.stations.carving.carves && !after.stations.carving.near;
    const bool lost_orb = before.stations.scrying.scries && !after.stations.scrying.near;
    if (after.stations.misses_rim ||
        (before.stations.stirs && !after.stations.stirs && !after.stations.at_rim))
        return StationKind::cauldron;
    if (after.stations.scrying.misses || lost_orb) return StationKind::orb;
    if (after.stations.carving.misses || lost_crystal) return StationKind::crystal;
    return std::nullopt;
}

}  // namespace

std::optional<Prompt> prompt_of(const PlayerPicture& player, const ControlNames& controls) {
    const auto offer = offer_to(player, controls);
    if (!offer || offer->control->empty()) return std::nullopt;
    return Prompt{offer->kind, text(offer->before, "[", *offer->control, "] ", offer->what)};
}

std::string_view words_of_missed_station(Tick now, std::uint32_t player, const PromptUses& uses) {
    constexpr Tick shown = ticks(2.0);
    const auto& missed = uses.missed[player];
    if (!missed || now < missed->at || now >= missed->at + shown) return {};
    switch (missed->station) {
        case StationKind::cauldron: return "Too far from the cauldron: step to the rim";
        case StationKind::orb: return "Out of reach of the orb: step up to it";
        case StationKind::crystal: return "Out of reach of the crystal: step up to it";
    }
    return {};
}

float strength_of(const Prompt& prompt, std::uint32_t player, PromptWish wish, const PromptUses& uses) {
    if (wish == PromptWish::always) return 1;
    if (wish == PromptWish::never) return 0;
    const auto done = uses.of(player, prompt.kind);
    if (done >= PromptUses::learnt) return 0;
    return 1 - static_cast<float>(done) / static_cast<float>(PromptUses::learnt);
}

void count_uses(const Picture& before, const Picture& after, PromptUses& uses) {
    if (after.tick <= before.tick) return;
    for (std::uint32_t player = 0; player < players; ++player) {
        const auto& wizard = after.wizards[player];
        count_uses(before.wizards[player], wizard, player, uses);
        if (const auto missed = missed_station(before.wizards[player], wizard))
            uses.missed[player] = MissedStation{after.tick, *missed};
        const bool near = wizard.stations.stirs || wizard.stations.at_rim || wizard.stations.scrying.near ||
                          wizard.stations.carving.near;
        if (near || wizard.vitals.dead) uses.missed[player].reset();
    }
}

}  // namespace thaum::game::inline hud

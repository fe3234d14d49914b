#include "game/hud/station_card.h"

#include <algorithm>
#include <cmath>

#include "core/text.h"
#include "game/data/teams.h"
#include "game/hud/overlay.h"

namespace thaum::game::inline hud {
namespace {

std::string share_in_percent(double share) {
    return text(static_cast<int>(std::floor(100 * share + 1e-9)), " %");
}

float focus_share(const PlayerPicture& p) {
    return static_cast<float>(std::clamp(p.casting.focus / std::max(p.casting.focus_cap, 1.0), 0.0, 1.0));
}

// ---- Orb --------------------------------------------------------------------------------------------------

/// The order of ingredients that the orb shows to the player: "Azoth: moss, salt, mist".
std::string words_of_order(const ScryingPicture& orb) {
    std::string words = text(capitalised(orb.potion), ": ");
    for (std::size_t i = 0; i < orb.order.size() && !orb.order.at(i).empty(); ++i)
        words += text(i == 0 ? "" : ", ", orb.order.at(i));
    return words;
}

std::string words_of_search(const ScryingPicture& orb, const ControlNames& controls) {
    const auto time = text(fixed(orb.wanted_s, 1), " s");
    if (orb.told) return words_of_order(orb);
    if (!orb.scries)
        return text("Orb: ", hold_or_press(controls.stir_toggles), bracketed(controls.stir, "Stir"),
                    " and find its core");
    if (orb.core_near) return text("At the core: stay ", fixed(orb.held_s, 1), " of ", time);
    return text("Find the core, stay there for ", time);
}

/// The keys for choosing among the orb's haptic modes, up to number `last`: "[1] to [6]", or the control for
/// the next mode.
std::string keys_of(const ControlNames& controls, std::size_t last) {
    const auto& keys = controls.wands;
    if (last > keys.size() || keys[0].empty() || keys[last - 1].empty())
        return bracketed(controls.next_wand, "next wand");
    return text("[", keys[0], "] to [", keys[last - 1], "]");
}

std::string words_of_modes(const ScryingPicture& orb, const ControlNames& controls) {
    std::string worn;
    std::size_t last = 0;
    for (std::size_t i = 0; i < orb.modes.size(); ++i) {
        if (orb.modes.at(i).empty()) continue;
        last = i + 1;
        if (!orb.worn.at(i)) continue;
        worn += text(worn.empty() ? "" : " and ", orb.modes.at(i));
    }
    const auto keys = keys_of(controls, std::min(last, controls.wands.size()));
    if (worn.empty()) return text("No mode: choose with ", keys);
    return text(capitalised(worn), "; others: ", keys);
}

RimCard orb_card_of(const Picture& picture, const HudSettings& settings, std::uint32_t player) {
    const auto& p = picture.wizards[player];
    const auto& orb = p.stations.scrying;
    RimCard card;
    card.gauge = {
        .mixed = static_cast<float>(std::clamp(orb.held_s / std::max(orb.wanted_s, 1e-3), 0.0, 1.0)),
        .fresh = focus_share(p),
        .paint = opaque(team_colours(player).glow)};
    if (orb.told) card.gauge.mixed = 1;
    if (orb.scries && orb.newest < max_orb_modes) card.curve = orb.curve;
    if (!settings.captions[player]) return card;
    const auto& controls = settings.controls[player];
    card.step = words_of_search(orb, controls);
    card.potions = words_of_potions(p);
    if (!orb.order[0].empty() && !orb.told)
        card.potions = text(words_of_order(orb), card.potions.empty() ? "" : "   ", card.potions);
    if (!orb.scries) return card;
    card.brew = orb.draws && orb.newest < max_orb_modes
                    ? text("Drawing the strength of ", orb.modes.at(orb.newest))
                    : words_of_modes(orb, controls);
    return card;
}

// ---- Crystal ----------------------------------------------------------------------------------------------

/// Words for the effect that the tool would have at its present position. A sign on the crystal shows the
/// same by shape and colour.
std::string_view words_of_worth(const CarvingPicture& crystal) {
    switch (crystal.tip.worth) {
        case DabWorth::helps: return "good place";
        case DabWorth::spoils: return "spoils the key";
        case DabWorth::nothing: break;
    }
    return "nothing here";
}

/// Advice on what to do with the chosen tool.
std::string words_of_tool(const CarvingPicture& crystal, const ControlNames& controls) {
    const auto fire = text(": ", hold_or_press(controls.fire_toggles), bracketed(controls.fire, "use wand"));
    const auto here = text(" (", words_of_worth(crystal), ")");
    const auto tool = crystal.tools.at(crystal.tool);
    if (tool == "melt") return text("Melt what is amber", fire, here);
    if (tool == "construct") return text("Build where the key is pale", fire, here);
    if (tool == "stamp") return text("Stamp a star of crystal", fire, here);
    if (tool == "paint") return text("Paint, only for the eye", fire);
    return text(capitalised(tool), fire, here);
}

/// Names of the controls that turn the crystal.
std::string keys_of_turning(const ControlNames& controls) {
    if (controls.aside.empty()) return {};
    return text("   turn it: [", controls.aside, "]");
}

RimCard crystal_card_of(const Picture& picture, const HudSettings& settings, std::uint32_t player) {
    const auto& p = picture.wizards[player];
    const auto& crystal = p.stations.carving;
    RimCard card;
    card.gauge = {.mixed = static_cast<float>(std::clamp(crystal.overlap, 0.0, 1.0)),
                  .fresh = focus_share(p),
                  .goal = static_cast<float>(std::clamp(crystal.wanted, 0.0, 1.0)),
                  .paint = opaque(team_colours(player).glow)};
    if (!settings.captions[player]) return card;
    const auto& controls = settings.controls[player];
    card.step = crystal.carves ? words_of_tool(crystal, controls)
                               : text("Crystal: ", hold_or_press(controls.stir_toggles),
                                      bracketed(controls.stir, "Stir"), " and carve the key");
    card.brew =
        crystal.overlap > 0
            ? text("Key ", share_in_percent(crystal.overlap), " of ", share_in_percent(crystal.wanted))
            : text("Untouched; carve ", share_in_percent(crystal.wanted), " of the key");
    const auto tools = std::ranges::find_if(crystal.tools, &std::string_view::empty) - crystal.tools.begin();
    if (crystal.carves)
        card.brew +=
            text("   tools: ", keys_of(controls, static_cast<std::size_t>(tools)), keys_of_turning(controls));
    card.potions = words_of_potions(p);
    return card;
}

/// Whether a wizard searches the orb, or is near it and looks at it.
bool at_orb(const PlayerPicture& p) {
    return p.stations.scrying.scries || (p.stations.scrying.near && p.stations.scrying.faces);
}

bool at_crystal(const PlayerPicture& p) {
    return p.stations.carving.carves || (p.stations.carving.near && p.stations.carving.faces);
}

}  // namespace

bool has_card(const PlayerPicture& p) { return at_cauldron(p) || at_orb(p) || at_crystal(p); }

RimCard card_of(const Picture& picture, const HudSettings& settings, std::uint32_t player) {
    const auto& p = picture.wizards[player];
    if (at_orb(p)) return orb_card_of(picture, settings, player);
    if (at_crystal(p)) return crystal_card_of(picture, settings, player);
    return rim_card_of(picture, settings, player);
}

}  // namespace thaum::game::inline hud

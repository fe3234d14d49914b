#include "game/data/spell.h"

namespace thaum::game::inline data {

std::string_view name_of_spell(std::uint32_t number) {
    return number < spell_kinds().size() ? spell_kinds()[number].name : std::string_view();
}

LoadedSpell read_spell(const SpellKind& kind, const Config& file) {
    const auto root = file.root();
    LoadedSpell spell{.kind = &kind};
    spell.stats.slot = static_cast<std::uint32_t>(root.integer("slot", {1, wand_slots}) - 1);
    spell.stats.gesture = root.string("gesture");
    spell.stats.focus = root.number("focus", {0, 1e6});
    spell.stats.shown = root.table("look").string("shown");
    spell.rules = kind.read(root);
    spell.effects = read_effects(root);
    return spell;
}

}  // namespace thaum::game::inline data

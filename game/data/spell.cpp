#include "game/data/spell.h"

#include <utility>

namespace thaum::game::inline data {

LoadedSpell read_spell(std::string name, std::uint32_t number, const Config& file) {
    const auto root = file.root();
    LoadedSpell spell{.name = std::move(name)};
    spell.kind = kind_of_file(spell_kinds(), root, spell.name, "spell");
    if (spell.kind == nullptr) return spell;
    spell.stats.slot = static_cast<std::uint32_t>(root.integer("slot", {1, wand_slots}) - 1);
    spell.stats.gesture = root.string("gesture");
    spell.stats.focus = root.number("focus", {0, 1e6});
    spell.stats.shown = root.table("look").string("shown");
    spell.rules = spell.kind->read(root, number);
    spell.effects = read_effects(root);
    return spell;
}

std::string_view name_of_spell(std::span<const LoadedSpell> spells, std::uint32_t number) {
    return number < spells.size() ? std::string_view(spells[number].name) : std::string_view();
}

}  // namespace thaum::game::inline data

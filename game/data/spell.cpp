#include "game/data/spell.h"

#include <algorithm>

namespace thaum::game::inline data {
namespace {

std::vector<SpellKind>& known_spells() {
    static std::vector<SpellKind> all;
    return all;
}

}  // namespace

SpellRegistration::SpellRegistration(const SpellKind& kind) {
    auto& all = known_spells();
    // The linker chooses the order of registrations, so the list is sorted to be independent of it.
    const auto after =
        std::find_if(all.begin(), all.end(), [&](const auto& k) { return kind.name < k.name; });
    all.insert(after, kind);
}

const std::vector<SpellKind>& spell_kinds() { return known_spells(); }

std::string_view name_of_spell(std::uint32_t number) {
    return number < known_spells().size() ? known_spells()[number].name : std::string_view();
}

LoadedSpell read_spell(const SpellKind& kind, const Config& file) {
    const auto root = file.root();
    LoadedSpell spell{.kind = &kind};
    spell.stats.slot = static_cast<std::uint32_t>(root.integer("slot", {1, wand_slots}) - 1);
    spell.stats.gesture = root.string("gesture");
    spell.stats.focus = root.number("focus", {0, 1e6});
    spell.stats.shown = root.table("look").string("shown");
    spell.rules = kind.read(root);
    return spell;
}

}  // namespace thaum::game::inline data

#include "game/app/content_use.h"

#include <algorithm>
#include <set>

#include "core/text.h"

namespace thaum::game::inline app {
namespace {

std::string file_of(const MatchData& reading) { return text("arenas/", reading.choice.arena, ".toml"); }

bool is_crystal(const Thing& thing) { return game::is_crystal(thing.surface, thing.body.shape); }

std::ptrdiff_t niches_of(const MatchData& reading, const RecipeIngredient& wanted) {
    const auto& name = reading.cauldron->ingredients[wanted.ingredient].name;
    return std::ranges::count(reading.arena.niches, name, &NichePlace::ingredient);
}

bool can_brew(const MatchData& reading, const Recipe& recipe) {
    return reading.cauldron && std::ranges::all_of(recipe.ingredients, [&](const RecipeIngredient& one) {
               return niches_of(reading, one) > 0;
           });
}

/// Reports spells that can never be cast, because they cost more focus (what wizards spend on spells) than a
/// wizard can ever have.
void find_dear_spells(const MatchData& reading, std::vector<MissingName>& faults) {
    for (const auto& spell : reading.spells)
        if (reading.casting && spell.stats.focus > reading.casting->focus_cap)
            faults.push_back(
                {.file = text("spells/", spell.name, ".toml"),
                 .table = "",
                 .key = "focus",
                 .words = text("is ", spell.stats.focus, ", and a wizard has at most ",
                               reading.casting->focus_cap, " (cap in casting.toml): it can never be cast")});
}

void find_dear_wands(const MatchData& reading, std::vector<MissingName>& faults) {
    for (const auto& wand : reading.wands)
        if (wand.stats.energy_cost > wand.stats.energy_cap)
            faults.push_back({.file = text("wands/", wand.name, ".toml"),
                              .table = "energy",
                              .key = "cost",
                              .words = text("is ", wand.stats.energy_cost, ", and the wand has at most ",
                                            wand.stats.energy_cap, " (cap): it can never be used")});
}

void find_same_names(const MatchData& reading, std::vector<MissingName>& faults) {
    for (auto spell = reading.spells.begin(); spell != reading.spells.end(); ++spell) {
        const auto same = std::find_if(reading.spells.begin(), spell, [&](const LoadedSpell& other) {
            return other.stats.shown == spell->stats.shown;
        });
        if (same == spell) continue;
        faults.push_back({.file = text("spells/", spell->name, ".toml"),
                          .table = "look",
                          .key = "shown",
                          .words = text("is '", spell->stats.shown, "', as that of spells/", same->name,
                                        ".toml: nobody could tell them apart")});
    }
}

void find_useless_niches(const MatchData& reading, std::vector<MissingName>& faults) {
    if (reading.rules.cauldron && !reading.arena.bowl && !reading.arena.niches.empty())
        faults.push_back({.file = file_of(reading),
                          .table = "",
                          .key = "niche",
                          .words = "nothing uses the niches: the arena has no solid with the shape 'bowl'"});
}

void find_unbrewable(std::span<const MatchData> readings, std::vector<MissingName>& faults) {
    std::set<std::string> seen;
    for (const auto& reading : readings)
        for (const auto& recipe : reading.recipes) {
            if (!seen.insert(recipe.name).second) continue;
            if (std::ranges::any_of(readings, [&](const MatchData& one) { return can_brew(one, recipe); }))
                continue;
            faults.push_back({.file = text("potions/", recipe.name, ".toml"),
                              .table = "",
                              .key = "ingredient",
                              .words = "no arena has a niche of each: nobody can brew it"});
        }
}

/// Notes ingredients for which an arena has fewer niches (places to pick up an ingredient) than for others.
/// Probably a niche, or one of a mirrored pair, was forgotten.
void note_few_niches(const MatchData& reading, std::vector<MissingName>& notes) {
    if (!reading.cauldron || reading.arena.niches.empty()) return;
    std::ptrdiff_t most = 0;
    for (const auto& recipe : reading.recipes)
        for (const auto& one : recipe.ingredients) most = std::max(most, niches_of(reading, one));
    std::set<std::uint32_t> seen;
    for (const auto& recipe : reading.recipes)
        for (const auto& one : recipe.ingredients) {
            const auto niches = niches_of(reading, one);
            if (niches == most || !seen.insert(one.ingredient).second) continue;
            notes.push_back({.file = file_of(reading),
                             .table = "",
                             .key = "niche",
                             .words = text(niches, niches == 1 ? " niche of '" : " niches of '",
                                           reading.cauldron->ingredients[one.ingredient].name, "', which ",
                                           recipe.name, " needs, and ", most, " of others")});
        }
}

/// Notes a potion that is half of the Great Work (two things that win a round if held together), in an arena
/// without a crystal. There the other half cannot be had. An arena without an orb is not noted: the orb only
/// tells players sooner the order of such a potion's ingredients.
void note_half_work(const MatchData& reading, std::vector<MissingName>& notes) {
    if (std::ranges::any_of(reading.arena.things, is_crystal)) return;
    for (const auto& recipe : reading.recipes)
        if (has_kind(recipe.effects, "work_half") && can_brew(reading, recipe))
            notes.push_back(
                {.file = file_of(reading),
                 .table = "",
                 .key = "solid",
                 .words = text("no box with the surface 'crystal', which the Great Work needs besides ",
                               recipe.name)});
}

/// One MatchData for each arena. Several readings of one arena differ only in rule set and match length.
std::vector<const MatchData*> one_of_each_arena(std::span<const MatchData> readings) {
    std::vector<const MatchData*> all;
    for (const auto& reading : readings)
        if (std::ranges::none_of(all,
                                 [&](const auto* one) { return one->choice.arena == reading.choice.arena; }))
            all.push_back(&reading);
    return all;
}

}  // namespace

UseFindings find_unusable(std::span<const MatchData> readings) {
    UseFindings found;
    if (readings.empty()) return found;
    const auto& first = readings.front();
    find_dear_spells(first, found.faults);
    find_dear_wands(first, found.faults);
    find_same_names(first, found.faults);
    find_unbrewable(readings, found.faults);
    for (const auto* reading : one_of_each_arena(readings)) {
        find_useless_niches(*reading, found.faults);
        note_few_niches(*reading, found.notes);
        note_half_work(*reading, found.notes);
    }
    return found;
}

}  // namespace thaum::game::inline app

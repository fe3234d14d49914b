#include "game/data/brew_words.h"

#include <array>

#include "core/text.h"
#include "game/data/match_data.h"

namespace thaum::game::inline data {
namespace {

struct FaultWords {
    std::string_view name, words;
};

constexpr std::array<FaultWords, 13> faults{
    {{"none", ""},
     {"order", "Wrong order: no recipe has this ingredient here"},
     {"early", "Too early: the one before was not mixed enough. The recipe is spoilt"},
     {"late", "Too late: the brew is mixed too far. The recipe is spoilt"},
     {"off", "This brew is spoilt: let it boil over"},
     {"full", "The brew holds three ingredients at most"},
     {"soon", "Too early: stir until it is mixed enough"},
     {"unfinished", "An ingredient is missing"},
     {"foreign", "This is your foe's brew: stir harder to take it"},
     {"gesture", "Wrong gesture: draw the one that is shown"},
     {"sense", "Wrong way round"},
     {"gentle", "Too gentle: draw it harder"},
     {"hard", "Too hard: draw it more gently"}}};

const FaultWords& row_of(BrewFault fault) {
    const auto number = static_cast<std::size_t>(fault);
    return faults[number < faults.size() ? number : 0];
}

}  // namespace

std::string_view name_of_fault(BrewFault fault) { return row_of(fault).name; }

std::string_view words_of_fault(BrewFault fault) { return row_of(fault).words; }

BrewWords brew_words_of(const MatchData& data) {
    BrewWords words;
    if (data.cauldron)
        for (const auto& ingredient : data.cauldron->ingredients)
            words.ingredients.push_back(ingredient.name);
    for (const auto& recipe : data.recipes) words.potions.push_back({recipe.name, recipe.words});
    return words;
}

std::vector<std::string_view> names_of_order(const BrewWords& words, std::uint32_t detail) {
    std::vector<std::string_view> names;
    for (std::uint32_t i = 1; i <= max_recipe_ingredients; ++i) {
        const auto name = words.ingredient((detail >> (8 * i)) & 0xFFU);
        if (!name.empty()) names.push_back(name);
    }
    return names;
}

std::string words_of_order(const BrewWords& words, std::uint32_t detail) {
    std::string all;
    for (const auto name : names_of_order(words, detail)) all += text(all.empty() ? "" : ", ", name);
    return all;
}

}  // namespace thaum::game::inline data

// game/data/brew_words.h: names of potions, ingredients and brewing faults, for people.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "game/components/cauldron.h"

namespace thaum::game::inline data {

struct MatchData;

/// Short name of a player's fault in brewing for tables and scenarios, such as "early"; empty for a number
/// that stands for no fault.
std::string_view name_of_fault(BrewFault fault);
/// A player's fault in brewing and the advice against it, in one text: "Too early: stir on before the next
/// ingredient".
std::string_view words_of_fault(BrewFault fault);

struct PotionWords {
    std::string name, effect;
};

/// Names of a match's ingredients and potions, by their numbers.
struct BrewWords {
    std::vector<std::string> ingredients;
    std::vector<PotionWords> potions;

    std::string_view ingredient(std::uint32_t number) const {
        return number < ingredients.size() ? std::string_view(ingredients[number]) : std::string_view();
    }
    std::string_view potion(std::uint32_t number) const {
        return number < potions.size() ? std::string_view(potions[number].name) : std::string_view();
    }
};
BrewWords brew_words_of(const MatchData& data);

/// Names of a recipe's ingredients in their right order. `detail`: that order, as in the event
/// EventKind::recipe_told, which reveals it to a player. The names point into `words`.
std::vector<std::string_view> names_of_order(const BrewWords& words, std::uint32_t detail);
/// Names of a recipe's ingredients in the order that `detail` reveals, in one text: "moss, salt, mist".
std::string words_of_order(const BrewWords& words, std::uint32_t detail);

}  // namespace thaum::game::inline data

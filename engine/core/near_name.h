// core/near_name.h: finds the known name nearest to a misspelt one, for messages that end with "did you mean
// 'damage'?".
#pragma once
#include <concepts>
#include <functional>
#include <ranges>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace thaum {

/// The name that needs the fewest edits to become the word: adding, leaving out or replacing a letter, or
/// swapping two neighbours. Small and capital letters count as equal, and so do '_' and '-'. Empty if no name
/// is near, or if the word is one of the names.
std::string_view near_name(std::string_view word, std::span<const std::string_view> names);

/// Words for a message, such as "; did you mean 'damage'?", or nothing if no name is near.
std::string did_you_mean(std::string_view word, std::span<const std::string_view> names);

/// did_you_mean for things that have names: did_you_mean(word, materials, &Material::name).
template <std::ranges::range Things, class Name = std::identity>
requires(!std::convertible_to<const Things&, std::span<const std::string_view>>) std::string
    did_you_mean(std::string_view word, const Things& things, Name name = {}) {
    std::vector<std::string_view> names;
    for (const auto& thing : things) names.emplace_back(std::invoke(name, thing));
    return did_you_mean(word, std::span<const std::string_view>(names));
}

}  // namespace thaum

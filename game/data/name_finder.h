// game/data/name_finder.h: finds sounds or effects by the names in data files, and records missing ones.
#pragma once
#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/error.h"
#include "core/near_name.h"
#include "core/text.h"
#include "game/data/presentation.h"

namespace thaum::game::inline data {

/// Whether a bank of sounds or effects has left out the file of this name because of its faults. Those faults
/// are reported elsewhere.
template <class Bank>
bool is_left_out(const Bank& bank, std::string_view name) {
    return std::ranges::any_of(bank.faulty, [&](const LeftOut& faulty) { return faulty.name == name; });
}

/// A name without folder and ending, which data files should not write: "bolt_shot" for
/// "sounds/bolt_shot.toml".
inline std::string bare_name(std::string_view name) {
    name.remove_prefix(std::min(name.rfind('/') + 1, name.size()));
    if (name.ends_with(".toml")) name.remove_suffix(5);
    return std::string(name);
}

/// Looks up names in a bank of sounds or effects. Each element of `things` has a name.
template <class Bank, class Thing>
class NameFinder {
public:
    /// `kind` and `folder` are nouns for messages: "sound", "sounds". All arguments must outlive the finder.
    NameFinder(const Bank& bank, const std::vector<Thing>& things, std::string_view kind,
               std::string_view folder)
        : bank_(bank), things_(things), kind_(kind), folder_(folder) {}

    /// Finds the sound or effect of this name. If there is none, adds a message to `place`, which says where
    /// a data file has the name, and records `place` in `missing`.
    std::optional<std::uint32_t> find(std::string_view name, MissingName place) {
        if (name.empty()) return std::nullopt;
        const auto number = bank_.find(name);
        if (number || is_left_out(bank_, name)) return number;
        place.words =
            text("there is no ", kind_, " '", name, "', ", folder_, "/", name, ".toml", meant_by(name));
        missing.push_back(std::move(place));
        return number;
    }

    std::vector<MissingName> missing{};

private:
    std::string meant_by(std::string_view name) const {
        const auto bare = bare_name(name);
        if (bare != name && bank_.find(bare)) return text("; did you mean '", bare, "'?");
        return did_you_mean(bare, things_, &Thing::name);
    }

    const Bank& bank_;
    const std::vector<Thing>& things_;
    std::string_view kind_, folder_;
};

}  // namespace thaum::game::inline data

// game/jackets/jacket.h: the jacket of a player, as the settings file names it: WORD or WORD:PLACE. Each
// maker of jackets has words of its own; game/jackets/makers has one source for each maker (jacket_maker.h).
#pragma once
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"
#include "game/jackets/jacket_maker.h"
#include "tactile/layout.h"

namespace thaum::game::inline jackets {

/// The picture of a jacket: 4 x 5 cells in front, then as many at the back.
inline constexpr JacketLayout figure_layout{"abstract_4x5", 40};
/// The layout of no jacket.
inline constexpr JacketLayout no_layout{};

struct Jacket {
    const JacketMaker* maker{};  ///< null: none
    const JacketForm* form{};    ///< one of the maker's forms; null: none
    /// Place in the maker's own spelling (JacketMaker::read): equal places of a maker are one device, or one
    /// file.
    std::string place{};
    bool operator==(const Jacket&) const = default;

    explicit operator bool() const { return maker != nullptr; }
    const JacketLayout& layout() const { return form == nullptr ? no_layout : form->layout; }
};

/// The usual layouts of all jackets, each once.
std::vector<JacketLayout> jacket_layouts();

/// All values that the setting may have, for messages: "\"bhaptics\", \"osc:HOST:PORT\" or ...".
std::string jacket_forms();

/// Reads the setting. The error says what is wrong with it.
Expected<Jacket> parse_jacket(std::string_view words);

/// The layout that a player has written for a jacket: a file of assets/tactile/layouts by its name without
/// ending, or any other file by its path. It may have fewer actuators than the jacket has motors; those that
/// follow stay off. The error is one line, and then the jacket has its usual layout.
Expected<tactile::Layout> load_own_layout(const std::string& words, const Jacket& jacket,
                                          const std::filesystem::path& assets);

/// Whether two jackets are one device, or one file.
bool is_same_device(const Jacket& a, const Jacket& b);

/// The jacket as an output, not opened yet; null for none. `player`: 0 or 1.
std::unique_ptr<input::TactileOutput> jacket_output(const Jacket& jacket, std::uint32_t player);

}  // namespace thaum::game::inline jackets

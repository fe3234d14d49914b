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

/// The layout in which the screen shows a jacket: 4 x 5 cells for the front, then as many for the back.
inline constexpr JacketLayout figure_layout{"abstract_4x5", 40};
/// Layout for a player without a jacket.
inline constexpr JacketLayout no_layout{};

struct Jacket {
    const JacketMaker* maker{};  ///< maker of the jacket; null: no jacket
    const JacketForm* form{};    ///< which of the maker's kinds of jacket it is; null: no jacket
    /// Place of the jacket (address, device or file) in the maker's own spelling (JacketMaker::read): equal
    /// places of a maker are one device, or one file.
    std::string place{};
    bool operator==(const Jacket&) const = default;

    explicit operator bool() const { return maker != nullptr; }
    const JacketLayout& layout() const { return form == nullptr ? no_layout : form->layout; }
};

/// The usual layouts of all kinds of jacket, each layout once.
std::vector<JacketLayout> jacket_layouts();

/// All values that the setting may have, for messages: "\"bhaptics\", \"osc:HOST:PORT\" or ...".
std::string jacket_forms();

/// Reads the value of the setting `jacket`. The error says what is wrong with it.
Expected<Jacket> parse_jacket(std::string_view words);

/// Loads the layout that a player has written for a jacket. `words`: the name of a file in
/// assets/tactile/layouts without its ending, or the path of any other file. The layout may have fewer
/// actuators than the jacket has motors; the remaining motors stay off. The error is one line; after it, the
/// jacket is to have its usual layout.
Expected<tactile::Layout> load_own_layout(const std::string& words, const Jacket& jacket,
                                          const std::filesystem::path& assets);

/// Whether two jackets are the same device, or the same file.
bool is_same_device(const Jacket& a, const Jacket& b);

/// Output to the jacket, not opened yet; null if there is no jacket. `player`: 0 or 1.
std::unique_ptr<input::TactileOutput> jacket_output(const Jacket& jacket, std::uint32_t player);

}  // namespace thaum::game::inline jackets

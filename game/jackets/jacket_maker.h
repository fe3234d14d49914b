// game/jackets/jacket_maker.h: support for the jackets of one maker. Each maker has one source file in
// game/jackets/makers, which registers a JacketMaker. Everything else, such as the settings and `thaum
// doctor`, knows a maker's jackets by that value alone.
#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"
#include "core/registry.h"
#include "input/tactile_output.h"

namespace thaum::game::inline jackets {

struct Jacket;

/// Layout of a jacket: how many motors it has, and where they sit.
struct JacketLayout {
    std::string_view name{};  ///< file of assets/tactile/layouts, without its ending
    std::size_t motors{};     ///< number of motors, each of which is an actuator of the layout
};

/// One kind of jacket. The setting is "WORD:PLACE", or "WORD" alone.
struct JacketForm {
    std::string_view word;
    JacketLayout layout;
    /// Place (address, device or file) that is meant if the setting is the word alone, as JacketMaker::read
    /// returns it; std::nullopt: the word alone is no valid setting.
    std::optional<std::string_view> usual_place{};
};

/// Result of the check of a jacket by `thaum doctor`.
struct JacketCheck {
    bool usable{};
    std::string words{};   ///< text that follows the jacket's name in a line, with the space or colon before
                           ///< it
    std::string advice{};  ///< advice to the user about the jacket's state; empty: none
};
/// Opens the jacket, leaves it silent and closes it again; reports how that went.
JacketCheck check_by_opening(const Jacket& jacket, input::TactileOutput& output);

/// A device that is plugged in, and the setting that would name it.
struct FoundJacket {
    std::string_view what;  ///< one or two words for the kind of device
    std::string words;
};

struct JacketMaker {
    std::string_view name;  ///< name of the maker's source file, without its ending
    int order = 100;        ///< order in lists: smaller ones first, equal ones by their names
    std::vector<JacketForm> forms;
    std::vector<std::string_view> shown;  ///< settings as lists show them to users: "osc:HOST:PORT"
    /// Reads the place, which follows the colon in the setting. Returns it in a normal form, which is the
    /// same for the same device. The error says how to write a place.
    Expected<std::string> (*read)(std::string_view word, std::string_view place);
    /// Makes the output to a jacket. The output is not opened yet.
    std::unique_ptr<input::TactileOutput> (*make)(const Jacket& jacket, std::uint32_t player);
    JacketCheck (*check)(const Jacket& jacket, input::TactileOutput& output) = check_by_opening;
    /// Devices that are plugged in, whatever the settings say; null: they cannot be listed.
    std::vector<FoundJacket> (*find)() = nullptr;
    /// Why players may not write a layout of their own for this jacket; empty: they may.
    std::string_view keeps_layout{};
};

/// Registers a maker when the program starts.
using JacketRegistration = Registration<JacketMaker>;

/// All makers, in the order of lists.
inline const std::vector<JacketMaker>& jacket_makers() { return registry_of<JacketMaker>().all(); }

}  // namespace thaum::game::inline jackets

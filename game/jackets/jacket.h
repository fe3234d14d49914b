// game/jackets/jacket.h: the jacket of a player, as the settings file names it.
//
//     ""                    none
//     "osc:HOST:PORT"       40 motors, by UDP and OSC (input/osc_jacket.h)
//     "osc16:HOST:PORT"     the same with 16 motors
//     "bhaptics"            a vest of bHaptics, by the Player on this machine (bhaptics_jacket.h)
//     "bhaptics:HOST:PORT"  the same by a Player at another place
//     "hid:VVVV:PPPP"       40 motors, by HID reports (hid_report.h)
//     "audio"               two speakers or shakers on the usual sound device (audio_jacket.h)
//     "audio8"              eight of them on its channels of 7.1 sound
//     "audio:DEVICE"        the same on a device of this name; "audio8:DEVICE"
//     "record:FILE.csv"     no jacket: a file with what it would play (felt_recorder.h)
//
// HOST is a name, an IPv4 address, or an IPv6 address in brackets. VVVV and PPPP are the numbers of maker and product,
// four hexadecimal digits each.
#pragma once
#include <array>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "core/error.h"
#include "game/jackets/hid_jacket.h"
#include "input/osc_jacket.h"
#include "tactile/layout.h"

namespace thaum::app {

struct Jacket {
    enum class Link : std::uint8_t { none, osc, bhaptics, hid, audio, record };
    /// `own`: a layout that the player has written (load_own_layout).
    enum class Layout : std::uint8_t { none, x40, x16, speakers, shakers8, figure, own };

    Link link{};
    input::NetAddress address{};  ///< of osc and bhaptics
    Layout layout{};
    HidId hid{};         ///< of hid
    std::string name{};  ///< device of audio, empty for the usual one; path of record
    bool operator==(const Jacket&) const = default;
};

/// The usual layouts, in the order of Layout.
inline constexpr std::array<Jacket::Layout, 5> jacket_layouts{
    Jacket::Layout::x40, Jacket::Layout::x16, Jacket::Layout::speakers, Jacket::Layout::shakers8,
    Jacket::Layout::figure};

/// Name of a layout's file in assets/tactile/layouts, without its ending; empty for none, "own" for an own one.
std::string_view name_of(Jacket::Layout layout);
/// Number of motors of a usual layout; 0 for none and for an own one.
std::size_t motors_of(Jacket::Layout layout);

/// Reads the setting. The error says what is wrong with it.
Expected<Jacket> parse_jacket(std::string_view words);

/// The layout that a player has written for a jacket: a file of assets/tactile/layouts by its name without ending, or
/// any other file by its path. It may have fewer actuators than the jacket has motors; those that follow stay off. The
/// error is one line, and then the jacket has its usual layout.
Expected<tactile::Layout> load_own_layout(const std::string& words, const Jacket& jacket,
                                          const std::filesystem::path& assets);

/// Whether two jackets are one device, or one file.
bool is_same_device(const Jacket& a, const Jacket& b);

/// The jacket as an output, not opened yet; null for none. `player`: 0 or 1.
std::unique_ptr<input::TactileOutput> jacket_output(const Jacket& jacket, std::uint32_t player);

}  // namespace thaum::app

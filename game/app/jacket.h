// game/app/jacket.h: the jacket of a player, as the settings file names it.
//
//     ""                    none
//     "osc:HOST:PORT"       40 motors, by UDP and OSC (input/osc_jacket.h)
//     "osc16:HOST:PORT"     the same with 16 motors
//     "bhaptics"            a vest of bHaptics, by the Player on this machine (bhaptics_jacket.h)
//     "bhaptics:HOST:PORT"  the same by a Player at another place
//
// HOST is a name, an IPv4 address, or an IPv6 address in brackets.
#pragma once
#include <memory>
#include <string_view>

#include "core/error.h"
#include "input/osc_jacket.h"

namespace thaum::app {

struct Jacket {
    enum class Link : std::uint8_t { none, osc, bhaptics };
    enum class Layout : std::uint8_t { none, x40, x16 };

    Link link{};
    input::NetAddress address{};
    Layout layout{};
    bool operator==(const Jacket&) const = default;
};

/// Name of a layout's file in assets/tactile/layouts, without its ending; empty for none.
std::string_view name_of(Jacket::Layout layout);
/// Number of motors of a layout.
std::size_t motors_of(Jacket::Layout layout);

/// Reads the setting. The error says what is wrong with it.
Expected<Jacket> parse_jacket(std::string_view words);

/// The jacket as an output, not opened yet; null for none.
std::unique_ptr<input::TactileOutput> jacket_output(const Jacket& jacket);

}  // namespace thaum::app

// game/app/faders.h: how much of what the cauldron's brew gives a player's hand wants to feel, by source. What the brew gets of the hand
// does not depend on it.
#pragma once
#include <array>
#include <string>
#include <string_view>

#include "core/config.h"
#include "haptics/fluid_touch.h"
#include "input/frame.h"

namespace thaum::app {

struct Fader {
    double share = 1;  ///< 0 to 1, of what the data files say
    bool on = true;    ///< off, nothing is felt, and the fader stays where it is
    bool operator==(const Fader&) const = default;
};
/// By haptics::fluid_modes.
using Faders = std::array<Fader, haptics::fluid_modes.size()>;

/// "Viscosity"; and what it does, in a few words.
std::string_view label_of_fader(std::size_t source);
std::string_view told_of_fader(std::size_t source);

/// "75 %", "off (75 %)".
std::string shown(const Fader& fader);
/// `steps` of 5 % up or down, on or off.
void change(Fader& fader, int steps);

/// The table of settings: a number for each source that is told, and `off`, a list of names. What is not told stays.
Faders read_faders(const ConfigTable& table, Faders faders);
/// The value of `off`.
std::string off_words(const Faders& faders);

/// For the log's header.
void ask_for(const Faders& faders, input::DeviceSpec& device);

}  // namespace thaum::app

// game/settings/faders.h: faders for the cauldron's forces on a player's hand, one for each source of force.
// They do not change how strongly the hand acts on the brew.
#pragma once
#include <array>
#include <string>
#include <string_view>

#include "core/config.h"
#include "haptics/fluid_touch.h"
#include "input/frame.h"

namespace thaum::game::inline settings {

struct Fader {
    double share = 1;  ///< share of the force that the data files give (0 to 1)
    bool on = true;    ///< false: nothing of this source is felt; `share` keeps its value for later
    bool operator==(const Fader&) const = default;
};
/// One fader for each source of force in the brew, in the order of haptics::fluid_modes.
using Faders = std::array<Fader, haptics::fluid_modes.size()>;

/// Name of a fader's source of force ("Viscosity"). The function effect_of_fader gives the fader's effect in
/// one sentence.
std::string_view label_of_fader(std::size_t source);
std::string_view effect_of_fader(std::size_t source);

/// Text of a share: "75 %", "7.5 %".
std::string percent_words(double share);
/// A share that is changed by `steps` steps of 1 / `in_all`, limited to 0 to 1.
double moved_share(double share, int steps, int in_all);

/// Text of a fader's value: "75 %", "off (75 %)".
std::string shown(const Fader& fader);
/// Changes the share of a fader by `steps` of 5 %, whether the fader is on or off.
void change(Fader& fader, int steps);

/// Reads one player's table in the settings file: a number for each source, and `off`, a list of source
/// names. Sources without an entry keep their value from `faders`.
Faders read_faders(const ConfigTable& table, Faders faders);
/// Value of the key `off` in the settings file: the names of the sources that are off.
std::string off_words(const Faders& faders);

/// Writes the faders into the DeviceSpec that is stored in the header of the match's log.
void ask_for(const Faders& faders, input::DeviceSpec& device);

}  // namespace thaum::game::inline settings

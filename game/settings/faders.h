// game/settings/faders.h: share of the cauldron's forces that a player's hand feels, one fader for each source.
// The hand acts on the brew with full strength whatever the faders say.
#pragma once
#include <array>
#include <string>
#include <string_view>

#include "core/config.h"
#include "haptics/fluid_touch.h"
#include "input/frame.h"

namespace thaum::app {

struct Fader {
    double share = 1;  ///< share of the force that the data files give (0 to 1)
    bool on = true;    ///< false: nothing of this source is felt, and `share` keeps its value
    bool operator==(const Fader&) const = default;
};
/// One fader for each mode, in the order of haptics::fluid_modes.
using Faders = std::array<Fader, haptics::fluid_modes.size()>;

/// Name of the fader's source ("Viscosity"), and its effect in one sentence.
std::string_view label_of_fader(std::size_t source);
std::string_view effect_of_fader(std::size_t source);

/// Text of a share: "75 %", "7.5 %".
std::string percent_words(double share);
/// A share that is moved by `steps` of which `in_all` make the whole; at most 1, at least 0.
double moved_share(double share, int steps, int in_all);

/// Text of a fader's value: "75 %", "off (75 %)".
std::string shown(const Fader& fader);
/// Moves the fader up or down by `steps` of 5 %, or switches it on or off.
void change(Fader& fader, int steps);

/// Reads one player's table of the settings file: a number for each source, and `off`, a list of names.
/// Sources without a line keep their value from `faders`.
Faders read_faders(const ConfigTable& table, Faders faders);
/// Value of the key `off` in the settings file: the names of the sources that are off.
std::string off_words(const Faders& faders);

/// Writes the faders into the DeviceSpec that the log's header keeps.
void ask_for(const Faders& faders, input::DeviceSpec& device);

}  // namespace thaum::app

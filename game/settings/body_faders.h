// game/settings/body_faders.h: strengths of the effects that jackets and motors play, with one fader for each
// kind of effect (purpose).
#pragma once
#include <string_view>

#include "core/config.h"
#include "tactile/mixer.h"

namespace thaum::game::inline settings {

/// Name of the fader of a kind of effect ("Hits"). The function effect_of gives, in one sentence, what the
/// fader changes.
std::string_view label_of(tactile::Purpose purpose);
std::string_view effect_of(tactile::Purpose purpose);

/// Reads a player's table in the settings file, which has a number for each kind of effect (purpose). Kinds
/// without an entry keep their value.
tactile::Faders read_body_faders(const ConfigTable& table, tactile::Faders faders);

}  // namespace thaum::game::inline settings

// game/stations/crystal/grain.h: tools in the hands of wizards, as against hits that chip.
//
// The key gives its crystal a grain: what would lead away from the key goes slowly. So a careful hand comes to an end,
// although it moves a ball with a radius of three voxels along shapes that are as thin.
#pragma once
#include "game/stations/crystal/crystal.h"

namespace thaum::game {

/// Applies a tool to a touched crystal and counts its overlap, as cut_crystal does. Of a change that leads away from the
/// key only the share CrystalRules::against_key is made.
field::Edit carve_crystal(MatchContext& context, CrystalBodies& bodies, Crystal& crystal,
                          const field::Tool& tool, const field::Dab& dab);

/// Effect of a tool on the overlap of crystal and key.
enum class DabWorth : std::uint8_t { nothing, helps, spoils };

/// Tries a tool on a copy of the voxels near it, so that the match does not notice. `dab.seconds` is the length of the
/// trial. The crystal must be touched.
DabWorth worth_of_dab(const MatchContext& context, const CrystalBodies& bodies, const Crystal& crystal,
                      const field::Tool& tool, const field::Dab& dab);

}  // namespace thaum::game

// game/stations/crystal/grain.h: how wizards' tools change a crystal, in contrast to hits that chip it.
//
// The key's shape gives its crystal a grain: of a change that leads away from the key's shape, only a share
// is carried out. So a careful hand succeeds, although its tool is a ball with a radius of three voxels and
// parts of the key are just as thin.
#pragma once
#include "game/stations/crystal/crystal.h"

namespace thaum::game::inline stations {

/// Applies a tool to a touched crystal and updates its overlap, as cut_crystal does. Of a change that leads
/// away from the key's shape, only the share CrystalRules::against_key is carried out.
field::Edit carve_crystal(MatchContext& context, CrystalBodies& bodies, Crystal& crystal,
                          const field::Tool& tool, const field::Dab& dab);

/// Effect of a tool on the overlap of crystal and key.
enum class DabWorth : std::uint8_t { nothing, helps, spoils };

/// Finds out what a tool would do to the overlap, on a copy of the voxels near it, without changing the
/// match. `dab`: one use of the tool, for which `dab.seconds` is the time that is tried. The crystal must be
/// touched.
DabWorth worth_of_dab(const MatchContext& context, const CrystalBodies& bodies, const Crystal& crystal,
                      const field::Tool& tool, const field::Dab& dab);

}  // namespace thaum::game::inline stations

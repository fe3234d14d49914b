// game/jackets/felt_rows.h: table of the vibrations that players feel on the body. A row has the tick, the
// player and the amplitudes of the 40 cells in which the screen shows the body (layout abstract_4x5). `thaum
// replay --tactile` and the recorder of a session write the same table.
#pragma once
#include <cstdint>
#include <string>

#include "tactile/frame.h"

namespace thaum::game::inline jackets {

/// First line of the table: the names of the columns.
std::string felt_header();
/// Appends the row of one frame, the strengths in all cells at one moment.
void append_felt(std::string& rows, std::uint32_t player, const tactile::TactileFrame& frame);

}  // namespace thaum::game::inline jackets

// game/jackets/felt_rows.h: rows of a table of what players feel on the body: tick, player,
// and the cells of the figure (layout abstract_4x5). `thaum replay --tactile` and the recorder
// of a session write the same table.
#pragma once
#include <cstdint>
#include <string>

#include "tactile/frame.h"

namespace thaum::game::inline jackets {

/// Names of the columns, with the end of the line.
std::string felt_header();
/// Appends the row of one frame.
void append_felt(std::string& rows, std::uint32_t player, const tactile::TactileFrame& frame);

}  // namespace thaum::game::inline jackets

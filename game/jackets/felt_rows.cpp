#include "game/jackets/felt_rows.h"

#include "core/text.h"

namespace thaum::game::inline jackets {
namespace {

/// Number of rows and columns of cells on each side of the body, front and back.
constexpr int rows_of_cells = 5, columns_of_cells = 4;
constexpr std::size_t cells = 2 * rows_of_cells * columns_of_cells;

}  // namespace

std::string felt_header() {
    std::string names = "tick,player";
    for (const auto* side : {"front", "back"}) {
        for (int row = 1; row <= rows_of_cells; ++row)
            for (int column = 1; column <= columns_of_cells; ++column)
                names += text(",", side, "_", row, "_", column);
    }
    return names + "\n";
}

void append_felt(std::string& rows, std::uint32_t player, const tactile::TactileFrame& frame) {
    rows += text(frame.tick, ",", player + 1);
    for (std::size_t cell = 0; cell < cells; ++cell)
        rows += text(",", fixed(static_cast<double>(frame.amplitude.at(cell)), 4));
    rows += "\n";
}

}  // namespace thaum::game::inline jackets

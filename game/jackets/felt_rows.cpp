#include "game/jackets/felt_rows.h"

#include "core/text.h"
#include "game/hud/picture.h"

namespace thaum::app {

std::string felt_header() {
    std::string names = "tick,player";
    for (const auto* side : {"front", "back"}) {
        for (int row = 1; row <= 5; ++row)
            for (int column = 1; column <= 4; ++column) names += text(",", side, "_", row, "_", column);
    }
    return names + "\n";
}

void append_felt(std::string& rows, std::uint32_t player, const tactile::TactileFrame& frame) {
    rows += text(frame.tick, ",", player + 1);
    for (std::size_t cell = 0; cell < game::figure_cells; ++cell)
        rows += text(",", fixed(static_cast<double>(frame.amplitude.at(cell)), 4));
    rows += "\n";
}

}  // namespace thaum::app

#include "game/jackets/hid_report.h"

#include <algorithm>
#include <cmath>

namespace thaum::game::inline jackets {
namespace {

/// Index in the layout x40 (rows from the top, each from the wearer's left) of motor number `motor` of the
/// report.
std::size_t actuator_at(std::size_t motor) {
    constexpr std::size_t columns = 4, motors_of_pair = 10;  // columns of motors on each side of the body;
                                                             // motors in a pair of columns
    constexpr std::size_t first_of_back = 20;
    const auto pair = motor / motors_of_pair;  // 0 front left, 1 back left, 2 back right, 3 front right
    const auto in_pair = motor % motors_of_pair;
    const bool back = pair == 1 || pair == 2, right = pair >= 2;
    const auto row = in_pair / 2, column = in_pair % 2 + (right ? 2U : 0U);
    return (back ? first_of_back : 0) + row * columns + column;
}

std::uint8_t strength_of(const tactile::TactileFrame& frame, std::size_t motor) {
    constexpr float strongest = 15;
    const auto actuator = actuator_at(motor);
    const float amplitude = actuator < frame.count ? frame.amplitude[actuator] : 0;
    // NaN fails this comparison and becomes 0.
    const float share = amplitude > 0 ? std::min(amplitude, 1.0F) : 0.0F;
    return static_cast<std::uint8_t>(std::lround(share * strongest));
}

}  // namespace

HidReport hid_report(const tactile::TactileFrame& frame) {
    HidReport report{};
    for (std::size_t i = 0; i < hid_motors / 2; ++i)
        report.at(1 + i) =
            static_cast<std::uint8_t>(strength_of(frame, 2 * i) << 4U | strength_of(frame, 2 * i + 1));
    return report;
}

}  // namespace thaum::game::inline jackets

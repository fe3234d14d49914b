#include "tactile/clip.h"

namespace thaum::tactile {

BodyPoint clip_place(std::size_t cell) {
    // Positions of the cells of a jacket of usual size (m). On the skin, columns are about 100 mm apart and
    // rows 90 mm.
    constexpr std::array across{-0.145, -0.05, 0.05, 0.145};
    constexpr double top = 1.29, row = 0.09, outer_depth = 0.055, inner_depth = 0.11;
    const std::size_t column = cell % 4, row_number = cell % clip_side / 4;
    const double depth = column == 0 || column == 3 ? outer_depth : inner_depth;
    const vec3 at(across[column], top - row * static_cast<double>(row_number), depth);
    return cell < clip_side ? BodyPoint{Part::front, at} : BodyPoint{Part::back, {at.x, at.y, -at.z}};
}

}  // namespace thaum::tactile

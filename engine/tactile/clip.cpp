#include "tactile/clip.h"

#include <algorithm>
#include <cmath>

namespace thaum::tactile {

BodyPoint clip_place(std::size_t cell) {
    // Cells of a jacket of usual size (m); the skin between two columns is about 100 mm, between two rows 90 mm.
    constexpr std::array across{-0.145, -0.05, 0.05, 0.145};
    constexpr double top = 1.29, row = 0.09, outer_depth = 0.055, inner_depth = 0.11;
    const std::size_t column = cell % 4, row_number = cell % clip_side / 4;
    const double depth = column == 0 || column == 3 ? outer_depth : inner_depth;
    const vec3 at(across[column], top - row * static_cast<double>(row_number), depth);
    return cell < clip_side ? BodyPoint{Part::front, at} : BodyPoint{Part::back, {at.x, at.y, -at.z}};
}

Clip clip_of(std::string name, std::span<const TactileFrame> frames) {
    Clip clip{std::move(name), {}};
    for (const auto& frame : frames) {
        const Tick age = frame.tick - frames.front().tick;
        const Tick last = (age + frame_ticks - 1) / clip_frame_ticks;
        for (Tick at = age / clip_frame_ticks; at <= last && at < most_clip_frames; ++at) {
            if (clip.frames.size() <= at) clip.frames.resize(at + 1);
            for (std::size_t i = 0; i < clip_cells; ++i) {
                const double percent =
                    std::clamp(100.0 * static_cast<double>(frame.amplitude[i]), 0.0, 100.0);
                auto& strength = clip.frames[at].strength[i];
                strength = std::max(strength, static_cast<std::uint8_t>(std::lround(percent)));
            }
        }
    }
    return clip;
}

}  // namespace thaum::tactile

#include "render/quality.h"

#include <algorithm>

namespace thaum::render {
namespace {

constexpr double slow_ms = 1000.0 / 30;
constexpr double quick_ms = 9;
// A picture of 46 ms takes about 1/30 s at the lowest resolution. One of 20 ms takes at most 27 ms at the
// next higher resolution, so that the resolution does not alternate while the work stays the same.
constexpr double hopeless_ms = 46, easy_ms = 20;
constexpr float resolution_step = 0.2F, lowest_resolution = 0.6F;
// Number of pictures after each decision that are not measured, since shaders and memory may be new.
constexpr int settling = 8;
constexpr int judged = 60;
constexpr int nearly_all = 57;

Quality stepped(Quality q, int by) { return static_cast<Quality>(static_cast<int>(q) + by); }

/// The next lower resolution of the same preset or, if that would not do, the next lower preset.
AutoQuality lowered(const AutoQuality& state) {
    const bool would_do = state.resolution > lowest_resolution + 0.1F && 2 * state.hopeless <= judged;
    AutoQuality next{.current = state.current, .most = state.most, .resolution = state.resolution};
    if (would_do) {
        next.resolution -= resolution_step;
    } else if (state.current != Quality::low) {
        next.current = next.most = stepped(state.current, -1);
        next.resolution = 1;
    } else {
        next.resolution = std::max(state.resolution - resolution_step, lowest_resolution);
    }
    return next;
}

AutoQuality decided(const AutoQuality& state) {
    if (2 * state.slow > judged) return lowered(state);
    AutoQuality next{.current = state.current, .most = state.most, .resolution = state.resolution};
    if (state.resolution < 1) {
        if (state.easy >= nearly_all) next.resolution = std::min(state.resolution + resolution_step, 1.0F);
    } else if (state.quick >= nearly_all && state.current < state.most) {
        next.current = stepped(state.current, +1);
    }
    return next;
}

}  // namespace

float internal_scale_of(Quality quality, int height) {
    // Greatest height of a picture (px) that is drawn in full, also by a software rasteriser.
    constexpr float lines = 720;
    if (quality == Quality::high || height <= 0) return 1;
    return std::clamp(lines / static_cast<float>(height), 0.25F, 1.0F);
}

float finest_px(Quality quality) { return quality == Quality::low ? 2 : 1; }

bool is_software(std::string_view renderer) {
    constexpr std::array known{"llvmpipe", "softpipe", "swrast", "SwiftShader", "Software Rasterizer"};
    return std::any_of(known.begin(), known.end(),
                       [&](std::string_view name) { return renderer.find(name) != std::string_view::npos; });
}

Quality first_quality(std::string_view renderer) {
    return is_software(renderer) ? Quality::medium : Quality::high;
}

AutoQuality after_frame(AutoQuality state, double frame_ms) {
    if (++state.frames <= settling) return state;
    state.slow += frame_ms > slow_ms;
    state.quick += frame_ms < quick_ms;
    state.hopeless += frame_ms > hopeless_ms;
    state.easy += frame_ms < easy_ms;
    return state.frames < settling + judged ? state : decided(state);
}

}  // namespace thaum::render

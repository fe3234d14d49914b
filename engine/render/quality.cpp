#include "render/quality.h"

#include <algorithm>

namespace thaum::render {
namespace {

// Times include the wait for the screen. A screen of 60 Hz turns any time from 17 to 33 ms into 33.3 ms and
// any from 34 to 49 ms into 50 ms, give or take its jitter, so that the limits lie between those.
constexpr double slow_ms = 36.5;
constexpr double quick_ms = 9;
// If half of the work is that of pixels, a picture of 52 ms takes 36 ms at the lowest resolution. If all of
// it is, one of 20.5 ms takes 36.4 ms when the resolution rises from 0.6 to 0.8, so that no work alternates.
constexpr double hopeless_ms = 52, easy_ms = 20.5;
constexpr float resolution_step = 0.2F, lowest_resolution = 0.6F;
// Number of pictures after each decision that are not measured, since shaders and memory may be new.
constexpr int settling = 8;
constexpr int judged = 60;
constexpr int nearly_all = 57;

Quality stepped(Quality q, int by) { return static_cast<Quality>(static_cast<int>(q) + by); }

/// The same choice with nothing measured yet.
AutoQuality undecided(const AutoQuality& state) {
    return {.current = state.current,
            .most = state.most,
            .resolution = state.resolution,
            .most_resolution = state.most_resolution};
}

/// The next lower resolution of the same preset or, if that would not do, the next lower preset.
AutoQuality lowered(const AutoQuality& state) {
    const bool would_do = state.resolution > lowest_resolution + 0.1F && 2 * state.hopeless <= judged;
    if (!would_do && state.current != Quality::low) {
        const auto below = stepped(state.current, -1);
        return {.current = below, .most = below};
    }
    AutoQuality next = undecided(state);
    next.resolution = std::max(state.resolution - resolution_step, lowest_resolution);
    // The last step up was in vain, with a screen that waits for example, and would be so again.
    if (state.raised) next.most_resolution = next.resolution;
    return next;
}

AutoQuality decided(const AutoQuality& state) {
    if (2 * state.slow > judged) return lowered(state);
    AutoQuality next = undecided(state);
    if (state.resolution < state.most_resolution) {
        next.raised = state.easy >= nearly_all;
        if (next.raised)
            next.resolution = std::min(state.resolution + resolution_step, state.most_resolution);
    } else if (state.resolution >= 1 && state.quick >= nearly_all && state.current < state.most) {
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

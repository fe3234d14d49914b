#include "render/quality.h"

#include <algorithm>

namespace thaum::render {
namespace {

constexpr double slow_ms = 1000.0 / 30;
constexpr double quick_ms = 9;
// Number of pictures after each decision that are not measured, since shaders and memory may be new.
constexpr int settling = 8;
constexpr int judged = 60;
constexpr int nearly_all = 57;

Quality stepped(Quality q, int by) { return static_cast<Quality>(static_cast<int>(q) + by); }

AutoQuality decided(const AutoQuality& state) {
    AutoQuality next{.current = state.current, .most = state.most};
    if (2 * state.slow > judged && state.current != Quality::low) {
        next.current = next.most = stepped(state.current, -1);
    } else if (state.quick >= nearly_all && state.current < state.most) {
        next.current = stepped(state.current, +1);
    }
    return next;
}

}  // namespace

float internal_scale_of(Quality quality, int height) {
    // Greatest height of a picture (px) that a software rasteriser draws in full as fast as it would draw a
    // quarter of the pixels and enlarge the result.
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
    return state.frames < settling + judged ? state : decided(state);
}

}  // namespace thaum::render

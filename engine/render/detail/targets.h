// Where views are drawn before they get to the window: smaller than it, or as light that the last pass makes pixels of.
#pragma once
#include "render/detail/gpu_mesh.h"
#include "render/detail/shaders.h"

namespace thaum::render::detail {

/// A colour texture, with depth or without.
struct Target {
    Framebuffer framebuffer;
    Texture colour;
    Renderbuffer depth;
    int width{}, height{};
};

/// Makes the target anew if its size is another; `format` GL_RGBA8 or GL_RGBA16F.
void resize(Target& target, GLint format, bool with_depth, int width, int height);

/// Bright light that shines beyond its edges: a quarter of one view's size, blurred.
struct Bloom {
    Target bright, blurred;
};

/// Place of one view: in the target it was drawn into, and in the window (px, from the bottom left).
struct ViewPlace {
    Rect drawn, shown;
};

/// Turns one view's light into the window's pixels. Nothing of it reaches another view. Without bloom `bloom` is null. Returns
/// the number of draw calls.
std::size_t compose(const Target& light, const ViewPlace& view, Bloom* bloom, const Programs& programs,
                    const VertexArray& no_attributes);

}  // namespace thaum::render::detail

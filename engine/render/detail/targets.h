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

/// What is bright shines beyond its edges: a quarter of the size, blurred.
struct Bloom {
    Target bright, blurred;
};

/// From the target's light to the window's pixels. Returns the number of draw calls.
std::size_t compose(const Target& light, Bloom& bloom, const Programs& programs, bool with_bloom,
                    const VertexArray& no_attributes, int width, int height);

}  // namespace thaum::render::detail

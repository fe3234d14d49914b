// Intermediate targets of the views: in pixels or in linear light, at most as large as the window. The last
// pass brings them into the window.
#pragma once
#include "render/detail/gpu_mesh.h"
#include "render/detail/shaders.h"

namespace thaum::render::detail {

/// A colour texture, with or without depth.
struct Target {
    Framebuffer framebuffer;
    Texture colour;
    Renderbuffer depth;
    int width{}, height{};
};

/// Recreates the target if its size differs. `format` is GL_RGBA16F, or GL_RGBA for pixels of 8 bits a colour
/// in the layout of windows.
void resize(Target& target, GLint format, bool with_depth, int width, int height);

/// Targets for bloom (bright light that spreads beyond its edges): a quarter of one view's width and height.
struct Bloom {
    Target bright, blurred;
};

/// Place of one view in the target it was drawn into and in the window, from the bottom left (px).
struct ViewPlace {
    Rect drawn, shown;
};

/// Brings one view's pixels into the window, stretched if the sizes differ. No pixel of another view shows.
/// Returns the number of draw calls.
std::size_t show(const Target& pixels, const ViewPlace& view, const SmallProgram& program,
                 const VertexArray& no_attributes);

/// Converts one view's light to the window's pixels. No light spreads to another view. A null `bloom` means
/// no bloom. Returns the number of draw calls.
std::size_t compose(const Target& light, const ViewPlace& view, Bloom* bloom, const Programs& programs,
                    const VertexArray& no_attributes);

}  // namespace thaum::render::detail

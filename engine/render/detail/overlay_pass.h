// The overlay on the GPU: draws text, marks and panels over the views.
#pragma once
#include <vector>

#include "core/error.h"
#include "render/detail/gl.h"
#include "render/detail/shaders.h"
#include "render/detail/shapes2d.h"

namespace thaum::render::detail {

class OverlayPass {
public:
    /// Fails if there is no font.
    static Expected<OverlayPass> make();
    /// Draws the overlay into the window's framebuffer. Returns the number of draw calls.
    std::size_t draw(const Frame& frame, const Programs& programs);
    Font& font() { return font_; }

private:
    explicit OverlayPass(Font font);
    void send_atlas();
    std::size_t draw_runs(const Programs& programs) const;

    Font font_;
    Atlas atlas_;
    VertexArray array_;
    Buffer vertices_;
    Texture texels_;       // texture with the pictures of all characters
    int texels_height_{};  // height of that texture (px)
    std::vector<OverlayVertex> built_;
};

}  // namespace thaum::render::detail

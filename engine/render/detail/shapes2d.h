// Overlay shapes as triangles in pixels. Slanted edges get a fringe one pixel wide over which the colour
// fades out. The fringe costs almost nothing, while multisampling is expensive. No OpenGL.
#pragma once
#include <cstdint>
#include <vector>

#include "render/font.h"
#include "render/scene.h"

namespace thaum::render::detail {

/// A vertex in the layout of the overlay's vertex shader.
struct OverlayVertex {
    fvec2 position;        // position from the top left (px)
    fvec2 texel;           // position in the texture of characters (texels)
    std::uint32_t colour;  // sRGB and alpha, one byte each, red in the lowest
};

/// Grey pictures of characters in one texture of fixed width and growing height.
class Atlas {
public:
    static constexpr int width = 1024;  // width of the texture; also the widest glyph (px)
    // Largest height of the texture (px). When it is reached, the texture is cleared before the next frame.
    static constexpr int limit = 4096;

    Atlas() { clear(); }
    /// Top-left texel of a glyph's picture, which is added if it is missing; negative if the texture is full.
    glm::ivec2 place(char32_t character, int size, const Glyph& glyph);
    /// Place of a fully covered texel, which shapes that are not text use.
    fvec2 solid() const { return {0.5F, 0.5F}; }
    void start_frame();

    int height() const { return static_cast<int>(texels_.size()) / width; }
    const std::vector<std::uint8_t>& texels() const { return texels_; }
    /// Returns true if the texture has changed since the last call.
    bool take_changed();

private:
    struct Key {
        char32_t character;
        int size;
        bool operator==(const Key&) const = default;
    };
    struct Entry {
        Key key;
        glm::ivec2 at;
    };
    void clear();
    std::vector<Entry>& bucket(Key key);

    std::vector<std::uint8_t> texels_;
    std::vector<std::vector<Entry>> buckets_;
    int shelf_y_{}, shelf_height_{}, pen_x_{};
    bool full_{}, changed_{};
};

/// Builds the triangles, three vertices each, in the order of the items.
void build(const Overlay& overlay, Font& font, Atlas& atlas, std::vector<OverlayVertex>& out);

}  // namespace thaum::render::detail

// Overlay shapes as triangles in pixels. Slanted edges are smoothed by a fringe one pixel wide over which the colour
// fades out, which costs nothing where multisampling would cost everything. Pure: no OpenGL.
#pragma once
#include <cstdint>
#include <vector>

#include "render/font.h"
#include "render/scene.h"

namespace thaum::render::detail {

/// As the overlay's vertex shader takes it.
struct OverlayVertex {
    fvec2 position;        // px from the top left
    fvec2 texel;           // of the glyph atlas
    std::uint32_t colour;  // sRGB and alpha, one byte each, red lowest
};

/// Grey pictures of characters on one sheet of fixed width that grows downwards.
class Atlas {
public:
    static constexpr int width = 1024;  // px; also the widest glyph
    static constexpr int limit = 4096;  // px of height; beyond, it starts anew with the next frame

    Atlas() { clear(); }
    /// Top-left texel of a glyph's picture; negative if there is no place left.
    glm::ivec2 place(char32_t character, int size, const Glyph& glyph);
    /// The middle of a texel that is all covered, for what is not text.
    fvec2 solid() const { return {0.5F, 0.5F}; }
    void start_frame();

    int height() const { return static_cast<int>(texels_.size()) / width; }
    const std::vector<std::uint8_t>& texels() const { return texels_; }
    /// Whether texels changed since the last call.
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

/// Three vertices a triangle, in the items' order.
void build(const Overlay& overlay, Font& font, Atlas& atlas, std::vector<OverlayVertex>& out);

}  // namespace thaum::render::detail

// render/font.h: the only typeface of the game. Lays out text and draws glyphs to grey pixels on the CPU. The
// Renderer has one Font; code that lays out a HUD on another thread creates another. A Font must not be
// shared between threads.
#pragma once
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string_view>
#include <vector>

#include "core/error.h"
#include "core/maths.h"

namespace thaum::render {

/// One character at one size: grey coverage, rows from the top.
struct Glyph {
    int width{}, height{};  ///< size of the coverage picture (px)
    /// Place of the coverage picture's left edge, to the right of the pen, and of its top edge, above the
    /// base line (px).
    int left{}, top{};
    int advance{};  ///< distance to the next pen position (px)
    std::vector<std::uint8_t> coverage;
};

/// A character and its place in a line.
struct PlacedGlyph {
    char32_t character{};
    int x{}, y{};  ///< top-left pixel of the glyph, relative to the line's top left (px)
};

/// One line of text. All its pixels are inside a box of `width` x `height` (px).
struct Line {
    std::vector<PlacedGlyph> glyphs;
    int width{}, height{};
};

/// Letters of one typeface at any size.
class Font {
public:
    /// Loads DejaVu Sans Bold from the usual system folders. The error names the package to install.
    static Expected<Font> load();
    /// Loads the first font file in `candidates` that exists.
    static Expected<Font> load(const std::vector<std::filesystem::path>& candidates);
    Font(Font&&) noexcept;
    Font& operator=(Font&&) noexcept;
    ~Font();

    /// Lays out one line. `size` is the em, 4 to 400 (px). Characters missing from the face become its empty
    /// box.
    Line lay_out(std::u32string_view line, int size);
    /// Picture of a character at a size (px). It is drawn on first use.
    const Glyph& glyph(char32_t character, int size);
    /// Size of the box of UTF-8 text (px). '\n' starts a new line.
    fvec2 measure(std::string_view text, float size);
    /// Distance from the top of one line to the top of the next (px).
    int line_height(int size);

    /// Rounds a requested em to whole pixels within 4 to 400.
    static int whole_size(float size);

private:
    struct State;
    struct Extent {
        int above{}, below{};  // distances from the base line to the top and to the bottom of a line (px)
    };
    Extent extent_of(int size);
    explicit Font(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

/// Splits text at '\n' and decodes it. Always returns at least one line, which may be empty.
std::vector<std::u32string> lines_of(std::string_view text);

}  // namespace thaum::render

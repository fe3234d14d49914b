// render/font.h: the one type face of the game, laid out and drawn to grey pixels on the CPU. The Renderer has one
// of its own; code that lays out a HUD on another thread makes another. Not to be shared between threads.
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
    int width{}, height{};  ///< px of the picture
    int left{}, top{};      ///< px from the pen on the base line: right to its left edge, up to its top
    int advance{};          ///< px to the next pen
    std::vector<std::uint8_t> coverage;
};

struct PlacedGlyph {
    char32_t character{};
    int x{}, y{};  ///< px of the top-left pixel, from the top-left corner of the line's box
};

/// One line of text. Every pixel lies in a box of width x height px.
struct Line {
    std::vector<PlacedGlyph> glyphs;
    int width{}, height{};
};

class Font {
public:
    /// DejaVu Sans Bold from where systems keep it; the error names the package to install.
    static Expected<Font> load();
    /// The first of these files that exists.
    static Expected<Font> load(const std::vector<std::filesystem::path>& candidates);
    Font(Font&&) noexcept;
    Font& operator=(Font&&) noexcept;
    ~Font();

    /// Sizes are the em in px, 4 to 400; characters the face lacks become its empty box.
    Line lay_out(std::u32string_view line, int size);
    const Glyph& glyph(char32_t character, int size);
    /// Size of the box of UTF-8 text in px; '\n' starts a new line.
    fvec2 measure(std::string_view text, float size);
    /// px from one line's top to the next one's.
    int line_height(int size);

    /// The em used for a size asked for: whole pixels within 4 to 400.
    static int whole_size(float size);

private:
    struct State;
    struct Extent {
        int above{}, below{};  // px from the base line
    };
    Extent extent_of(int size);
    explicit Font(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

/// Code points of UTF-8 text; each faulty byte becomes U+FFFD.
std::u32string decode_utf8(std::string_view text);

/// The lines of text that '\n' separates; one, maybe empty, if there is none.
std::vector<std::u32string> lines_of(std::string_view text);

}  // namespace thaum::render

#include "render/font.h"
#include "core/utf8.h"

#include <ft2build.h>

#include <algorithm>
#include <cmath>
#include <map>
#include FT_FREETYPE_H

#include "core/bytes.h"
#include "core/file.h"
#include "core/text.h"

namespace thaum::render {

struct Font::State {
    FT_Library library = nullptr;
    FT_Face face = nullptr;
    Bytes file;  // font file; must outlive the face, since FreeType reads from it
    int size = 0;
    std::map<std::pair<char32_t, int>, Glyph> glyphs;
    std::map<int, Extent> extents;

    State() = default;
    State(const State&) = delete;
    State& operator=(const State&) = delete;
    ~State() {
        if (face != nullptr) FT_Done_Face(face);
        if (library != nullptr) FT_Done_FreeType(library);
    }

    void use_size(int wanted) {
        if (wanted == size) return;
        FT_Set_Pixel_Sizes(face, 0, static_cast<FT_UInt>(wanted));
        size = wanted;
    }
};

namespace {

constexpr std::size_t max_font = 32U << 20U;  // largest font file (bytes)

/// Rounds 26.6 fixed point to whole pixels.
int pixels(FT_Pos fixed) { return static_cast<int>((fixed + 32) >> 6); }
int pixels_up(FT_Pos fixed) { return static_cast<int>((fixed + 63) >> 6); }

std::vector<std::uint8_t> copied(const FT_Bitmap& bitmap) {
    std::vector<std::uint8_t> out;
    out.reserve(std::size_t{bitmap.width} * bitmap.rows);
    for (unsigned row = 0; row < bitmap.rows; ++row) {
        const auto* first = bitmap.buffer + static_cast<std::ptrdiff_t>(row) * bitmap.pitch;
        out.insert(out.end(), first, first + bitmap.width);
    }
    return out;
}

Glyph rendered(FT_Face face, char32_t character) {
    Glyph out;
    // The automatic hinter is used, because it aligns stems to the pixel grid in both directions; the font's
    // own hints do so only vertically.
    if (FT_Load_Char(face, character, FT_LOAD_RENDER | FT_LOAD_FORCE_AUTOHINT) != 0) return out;
    const auto& slot = *face->glyph;
    out.advance = pixels(slot.advance.x);
    if (slot.bitmap.pixel_mode != FT_PIXEL_MODE_GRAY || slot.bitmap.pitch < 0) return out;
    out.width = static_cast<int>(slot.bitmap.width);
    out.height = static_cast<int>(slot.bitmap.rows);
    out.left = slot.bitmap_left;
    out.top = slot.bitmap_top;
    out.coverage = copied(slot.bitmap);
    return out;
}

int kerning(FT_Face face, char32_t left, char32_t right) {
    FT_Vector k{};
    if (FT_Get_Kerning(face, FT_Get_Char_Index(face, left), FT_Get_Char_Index(face, right),
                       FT_KERNING_DEFAULT, &k) != 0) {
        return 0;
    }
    return pixels(k.x);
}

Error no_font(const std::vector<std::filesystem::path>& candidates) {
    std::string looked;
    for (const auto& path : candidates) looked += text(looked.empty() ? "" : ", ", path.string());
    return fail(text("no font for text: looked for ", looked, "; install the package fonts-dejavu-core"));
}

}  // namespace

std::vector<std::u32string> lines_of(std::string_view text) {
    std::vector<std::u32string> out(1);
    for (const char32_t c : decode_utf8(text)) {
        if (c == U'\n')
            out.emplace_back();
        else
            out.back().push_back(c);
    }
    return out;
}

Font::Font(std::unique_ptr<State> state) : state_(std::move(state)) {}
Font::Font(Font&&) noexcept = default;
Font& Font::operator=(Font&&) noexcept = default;
Font::~Font() = default;

Expected<Font> Font::load() {
    return load({"/usr/share/fonts/truetype/dejavu/DejaVuSans-Bold.ttf",
                 "/usr/share/fonts/dejavu-sans-fonts/DejaVuSans-Bold.ttf",
                 "/usr/share/fonts/dejavu/DejaVuSans-Bold.ttf", "/usr/share/fonts/TTF/DejaVuSans-Bold.ttf"});
}

Expected<Font> Font::load(const std::vector<std::filesystem::path>& candidates) {
    std::error_code ignored;
    const auto found = std::find_if(candidates.begin(), candidates.end(),
                                    [&](const auto& path) { return std::filesystem::exists(path, ignored); });
    if (found == candidates.end()) return no_font(candidates);
    auto state = std::make_unique<State>();
    auto file = read_file(*found, max_font);
    if (!file) return file.error();
    state->file = std::move(*file);
    if (FT_Init_FreeType(&state->library) != 0)
        return fail("FreeType does not start: check the package libfreetype6");
    if (FT_New_Memory_Face(state->library, reinterpret_cast<const FT_Byte*>(state->file.data()),
                           static_cast<FT_Long>(state->file.size()), 0, &state->face) != 0 ||
        !FT_IS_SCALABLE(state->face)) {
        return fail(text(found->string(), ": not an outline font that FreeType can read"));
    }
    return Font(std::move(state));
}

int Font::whole_size(float size) {
    if (!std::isfinite(size)) return 16;
    return static_cast<int>(std::lround(std::clamp(size, 4.0F, 400.0F)));
}

const Glyph& Font::glyph(char32_t character, int size) {
    const auto key = std::pair(character, size);
    if (const auto found = state_->glyphs.find(key); found != state_->glyphs.end()) return found->second;
    state_->use_size(size);
    return state_->glyphs.emplace(key, rendered(state_->face, character)).first->second;
}

int Font::line_height(int size) {
    const auto extent = extent_of(size);
    return extent.above + extent.below;
}

/// Heights above and below the base line: those of the face's metrics, or more if hinting lifts an accent
/// higher.
Font::Extent Font::extent_of(int size) {
    if (const auto found = state_->extents.find(size); found != state_->extents.end()) return found->second;
    state_->use_size(size);
    const auto& metrics = state_->face->size->metrics;
    Extent out{pixels_up(metrics.ascender), pixels_up(-metrics.descender)};
    for (const char32_t c : std::u32string_view(U"\u00C5\u0150|gj\u00C7")) {
        const Glyph& g = glyph(c, size);
        out.above = std::max(out.above, g.top);
        out.below = std::max(out.below, g.height - g.top);
    }
    state_->extents.emplace(size, out);
    return out;
}

Line Font::lay_out(std::u32string_view line, int size) {
    Line out;
    const auto [base, below] = extent_of(size);
    out.height = base + below;
    int pen = 0, low = 0, high = 0;
    char32_t before = 0;
    for (const char32_t c : line) {
        const Glyph& g = glyph(c, size);
        state_->use_size(size);
        if (before != 0) pen += kerning(state_->face, before, c);
        out.glyphs.push_back({c, pen + g.left, base - g.top});
        low = std::min(low, pen + g.left);
        pen += g.advance;
        high = std::max({high, pen, out.glyphs.back().x + g.width});
        before = c;
    }
    // Some letters reach left of the pen. The box of the line includes these parts.
    for (auto& g : out.glyphs) g.x -= low;
    out.width = high - low;
    return out;
}

fvec2 Font::measure(std::string_view text, float size) {
    const int px = whole_size(size);
    fvec2 out(0);
    for (const auto& line : lines_of(text)) {
        const auto laid = lay_out(line, px);
        out.x = std::max(out.x, static_cast<float>(laid.width));
        out.y += static_cast<float>(laid.height);
    }
    return out;
}

}  // namespace thaum::render

// render/quality.h: how much work a picture is, in three presets:
//
//              inside       point lights      sun's shadow             colours
//   low        720 lines    4, each vertex    baked into the vertices  fog and tone curve at each vertex
//   medium     720 lines    8, each vertex    map, one bilinear tap    the same, in the sun and in the shade
//   high       the window's 8, each pixel     map, nine taps           16-bit floats, tone mapped at the end, bloom
//
// At low what is finer than two pixels is drawn plainly: joints of far stone, meshes with coarser copies.
// A volume is marched in 7, 10 and 28 steps, at low and medium with a third of the view's pixels along a side.
//
// `auto` is not a preset but a way to choose one: it begins by what draws (a processor or a graphics card) and goes by
// measured times. It never flaps: a preset that proved too slow is not tried again.
#pragma once
#include <array>
#include <cstdint>
#include <string_view>

namespace thaum::render {

enum class Quality : std::uint8_t { low, medium, high };
inline constexpr std::size_t qualities = 3;
inline constexpr std::array<std::string_view, qualities> quality_names{"low", "medium", "high"};

/// Frame::internal_scale for a window so many px high.
float internal_scale_of(Quality quality, int height);

/// What is smaller than so many px may be drawn plainly (Patch::plain, coarser copies).
float finest_px(Quality quality);

/// Whether the processor draws. `renderer` is OpenGL's GL_RENDERER.
bool is_software(std::string_view renderer);

/// Where `auto` begins. `renderer` is OpenGL's GL_RENDERER: a software rasteriser begins at medium.
Quality first_quality(std::string_view renderer);

/// What `auto` knows. `{.now = first_quality(...)}` knows nothing yet; begin anew when the window changes its size.
struct AutoQuality {
    Quality now{};
    Quality most = Quality::high;  ///< what is above proved too slow
    int frames{};                  ///< since the last decision or change
    int slow{}, quick{};           ///< of these
};

/// After a picture that took `frame_ms` to draw and present. Decides once per 60 pictures: down when more than half of
/// them took longer than 1/30 s; up when nearly all took less than 9 ms, since a preset costs up to three times the one below.
AutoQuality after_frame(AutoQuality state, double frame_ms);

}  // namespace thaum::render

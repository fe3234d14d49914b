// render/quality.h: the cost of a picture, in three presets:
//
//              resolution*  point lights      sun's shadow             colours
//   low        720 lines    4, each vertex    baked into the vertices  fog and tone curve at each vertex
//   medium     720 lines    8, each vertex    map, one bilinear tap    the same, twice: in sun and in shade
//   high       the window's 8, each pixel     map, four taps           16-bit floats, tone mapped last, bloom
//
// * `auto` (see below) draws 60 to 100 percent of it.
//
// At high, large fixed meshes (stone) have light at each pixel only near a light: elsewhere light changes so
// little within a triangle that its vertices do.
//
// At low, detail finer than two pixels is left out: far stone is drawn without joints, and far meshes as
// coarser copies. A volume is ray-marched in 7, 10 and 28 steps, at low and medium with a third of the view's
// pixels along a side.
//
// `auto` is not a preset but a way to choose one. It starts from the device that draws (a processor or a
// graphics card) and then follows measured times, so that about 30 pictures a second are drawn if the device
// can. It first lowers the resolution of the views, to 60 percent at least: medium at 60 percent takes as
// long as low in full and is nearer to the best picture. It never alternates between presets: one that proved
// too slow is not tried again. Where vertical sync waits for a screen of less than 50 Hz, no picture takes
// less than 20.5 ms, so there the resolution never rises again.
#pragma once
#include <array>
#include <cstdint>
#include <string_view>

namespace thaum::render {

/// Presets of picture quality, from the fastest to the best.
enum class Quality : std::uint8_t { low, medium, high };
inline constexpr std::size_t qualities = 3;
inline constexpr std::array<std::string_view, qualities> quality_names{"low", "medium", "high"};

/// Factor by which views are drawn smaller (Frame::internal_scale) than a window of this height (px).
float internal_scale_of(Quality quality, int height);

/// Size of detail below which it may be left out: a patch (piece of a large mesh) is then drawn in its plain
/// form, or a mesh as a coarser copy (px).
float finest_px(Quality quality);

/// Returns true if the processor draws, instead of a graphics card. `renderer` is OpenGL's GL_RENDERER.
bool is_software(std::string_view renderer);

/// Preset with which the automatic choice begins. `renderer` is OpenGL's GL_RENDERER. A software rasteriser
/// starts at medium.
Quality first_quality(std::string_view renderer);

/// State of the automatic choice of a preset. Start with `{.current = first_quality(...)}`, again whenever
/// the window changes its size.
struct AutoQuality {
    Quality current{};
    Quality most = Quality::high;  ///< highest preset that has not proved too slow
    int frames{};                  ///< number of pictures since the last decision or change of size
    int slow{}, quick{};           ///< numbers of slow and of fast pictures among `frames`
    /// Numbers of pictures among `frames` that a lower resolution would not make fast enough, and of those
    /// that would stay fast enough at a higher one.
    int hopeless{}, easy{};
    /// Share of the preset's resolution along a side: 1, 0.8 or 0.6.
    float resolution = 1;
    float most_resolution = 1;  ///< highest share that has not proved too slow right after it was reached
    bool raised{};              ///< true: the last decision raised the resolution
};

/// Updates the state after a picture that took `frame_ms` to draw and present. After each decision it ignores
/// 8 pictures and judges the next 60. If more than half of them took longer than 36.5 ms (two refreshes of a
/// 60 Hz screen, with their jitter, take less), it lowers the resolution. It lowers the preset instead if the
/// resolution is lowest already, or if more than half took longer than 52 ms, which the lowest resolution
/// would hardly bring below 36.5 ms; at low it can only lower the resolution. It raises the resolution if
/// nearly all took less than 20.5 ms, but never again to one that was too slow at once. At full resolution it
/// raises the preset if nearly all took less than 9 ms, since a preset costs up to three times as much as the
/// one below.
AutoQuality after_frame(AutoQuality state, double frame_ms);

}  // namespace thaum::render

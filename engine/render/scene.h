// render/scene.h: one picture as plain data. Game code fills a Frame; Renderer::draw shows it. Nothing here touches
// OpenGL, so a frame can be built on any thread; what its spans point to must live until draw returns.
//
// World: m, right-handed, +y up; a camera looks along its -z. Colours are linear light (render/colour.h). Pixels
// count from the top-left corner of the window, x right, y down.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "core/maths.h"
#include "render/colour.h"
#include "render/occlusion.h"
#include "render/quality.h"
#include "render/volume.h"

namespace thaum::render {

/// What Renderer::upload gave.
using MeshId = std::uint32_t;

struct Camera {
    fvec3 position{0, 1.7F, 0};
    fquat orientation{1, 0, 0, 0};  ///< turns camera axes into world axes
    float fov_y = 1.2F;             ///< rad, whole angle from bottom to top
    float near_plane = 0.05F;       ///< m
    float far_plane = 400;          ///< m
};

/// A mesh at a place. The matrix is rotation, scale and translation, without shear. An instance whose matrix is not
/// finite is not drawn.
struct Instance {
    MeshId mesh{};
    fmat4 model{1};
    fvec3 tint{1};  ///< multiplies the mesh's colours
    float glow{};   ///< 0: lit by the scene; 1: shines by itself, in its own colour
    float sun = 1;  ///< share of the sun that reaches it, where no shadow map tells
};

struct PointLight {
    fvec3 position{0};
    fvec3 colour{1};
    float radius = 8;  ///< m; nothing is lit beyond
};

/// Lights a view may have; draw uses the first ones, at Quality::low the first four.
inline constexpr std::size_t max_lights = 8;

struct Sun {
    fvec3 direction = glm::normalize(fvec3(-0.55F, 0.32F, -0.78F));  ///< unit, from the ground to the sun
    fvec3 colour = 1.0F * render::colour(0xFFCBA4);
};

struct Sky {
    fvec3 zenith = render::colour(0x231B45);
    fvec3 horizon = render::colour(0x8A5C8C);
    fvec3 sun_glow = render::colour(0xC8683A);  ///< added around the sun
};

/// Far things fade into the colour: half of it at 0.83 / density.
struct Fog {
    fvec3 colour = render::colour(0x5C4470);
    float density = 0.012F;  ///< 1/m
};

/// Light from everywhere: from above and from the ground.
struct Ambient {
    fvec3 above = 0.9F * render::colour(0x8078B8);
    fvec3 below = 0.9F * render::colour(0x4A3A48);
};

/// What surrounds the court. The defaults are dusk: violet sky, low warm sun.
struct Environment {
    Sun sun;
    Sky sky;
    Fog fog;
    Ambient ambient;
};

struct Rect {
    int x{}, y{}, width{}, height{};  ///< px
};

enum class Split : std::uint8_t { none, side_by_side, top_bottom };

/// Where the two players' views stand: they touch, cover the window and do not overlap. Split::none gives the
/// whole window and an empty one.
std::array<Rect, 2> split_window(int width, int height, Split split);

/// One view of the world.
struct ViewScene {
    Camera camera;
    Rect viewport;
    std::span<const Instance> instances;
    std::span<const PointLight> lights;  ///< up to max_lights
    Environment environment;
    /// Flat shade over the ground, drawn last: what is there is multiplied by the mesh's colour. tint.r from 0 (not at
    /// all) to 1 says how strongly.
    std::span<const Instance> shades{};
    /// Soft and seen through, drawn after all else in the world, without order: round meshes, densest where they face the eye. The
    /// tint is their light, and `glow` the share of what is behind them that they hide at most.
    std::span<const Instance> mists{};
    /// Blocks that `instances` fill, or a little more: what one of them hides is not drawn. For the sky up to 64 count.
    std::span<const Block> blocks{};
    const Volume* volume{};  ///< none where it is null; drawn after all that is solid
};

/// What keeps the sun away, in all views. `fixed` never changes from frame to frame: its shadow is drawn once and kept.
struct Casters {
    std::span<const Instance> fixed, moving;
};

// The overlay: flat shapes and text over the views, in order, blended by alpha. Edges that are not along pixels are
// smoothed. Lengths in px.

struct RectItem {
    fvec2 low, high;  ///< top-left and bottom-right corner
    fvec4 colour{1};
    float corner{};  ///< radius of rounded corners
};

struct TriangleItem {
    fvec2 a, b, c;
    fvec4 colour{1};
};

/// A piece of a ring, from `start` over `sweep` rad; 0 is up and positive is clockwise, as on a clock. An inner
/// radius of 0 gives a slice of pie.
struct ArcItem {
    fvec2 centre;
    float inner{}, outer{};
    float start{}, sweep{};
    fvec4 colour{1};
};

struct LineItem {
    fvec2 from, to;
    float width = 1;
    fvec4 colour{1};
};

enum class Align : std::uint8_t { left, centre, right };

/// UTF-8; '\n' starts a new line. `position` is the top of the text's box (Font::measure) at its left, middle or
/// right. `size` is the em, rounded to whole pixels.
struct TextItem {
    std::string text;
    fvec2 position;
    float size = 16;
    fvec4 colour{1};
    Align align = Align::left;
};

using OverlayItem = std::variant<RectItem, TriangleItem, ArcItem, LineItem, TextItem>;

struct Overlay {
    std::vector<OverlayItem> items;
};

/// The whole picture.
struct Frame {
    int width{}, height{};         ///< px, of the window's framebuffer
    std::vector<ViewScene> views;  ///< one, or two that do not overlap; what they leave is black
    Overlay overlay;
    float internal_scale = 1;  ///< 0.25 to 1: views are drawn at this part of the window's size and stretched
    Quality quality = Quality::low;
    bool bloom = true;  ///< at Quality::high
    Casters casters{};  ///< the sun is that of the first view
};

}  // namespace thaum::render

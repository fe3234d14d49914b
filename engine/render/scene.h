// render/scene.h: one picture as plain data. Game code fills a Frame; Renderer::draw shows it. Nothing here
// uses OpenGL, so any thread can build a frame. The data behind its spans must live until draw returns.
//
// The world frame is in m, right-handed, +y up; a camera looks along its -z. Colours are linear light
// (render/colour.h). Pixels count from the top-left corner of the window, x right, y down.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "core/maths.h"
#include "render/colour.h"
#include "render/mesh.h"
#include "render/occlusion.h"
#include "render/quality.h"
#include "render/scan.h"
#include "render/volume.h"

namespace thaum::render {

/// Handle of a mesh, returned by Renderer::upload.
using MeshId = std::uint32_t;

/// Position, direction and projection from which a view is seen.
struct Camera {
    fvec3 position{0, 1.7F, 0};
    fquat orientation{1, 0, 0, 0};  ///< rotation from camera axes to world axes
    float fov_y = 1.2F;             ///< whole angle from bottom to top (rad)
    float near_plane = 0.05F;       ///< distance of the near plane (m)
    float far_plane = 400;          ///< distance of the far plane (m)
};

/// A mesh at a place. The matrix consists of rotation, scale and translation, without shear. An instance with
/// a matrix that is not finite is not drawn.
struct Instance {
    MeshId mesh{};
    fmat4 model{1};
    fvec3 tint{1};  ///< factor of the mesh's colours
    float glow{};   ///< share of its own colour that the object emits; 0: lit by the scene only
    float sun = 1;  ///< share of the sunlight that reaches it; ignored where a shadow map decides
};

/// A light at a place.
struct PointLight {
    fvec3 position{0};
    fvec3 colour{1};
    float radius = 8;  ///< distance beyond which the light has no effect (m)
};

/// Largest number of lights of a view. If there are more, draw() uses the first ones; at Quality::low it uses
/// the first four.
inline constexpr std::size_t max_lights = 8;

/// The light that casts shadows.
struct Sun {
    /// Direction from the ground to the sun (unit).
    fvec3 direction = glm::normalize(fvec3(-0.55F, 0.32F, -0.78F));
    fvec3 colour = 1.0F * render::colour(0xFFCBA4);
};

/// Colours behind everything.
struct Sky {
    fvec3 zenith = render::colour(0x231B45);
    fvec3 horizon = render::colour(0x8A5C8C);
    fvec3 sun_glow = render::colour(0xC8683A);  ///< colour added around the sun
};

/// Blends far objects into a colour; at the distance 0.83 / density the colour has a share of one half.
struct Fog {
    fvec3 colour = render::colour(0x5C4470);
    float density = 0.012F;  ///< density of the fog (1/m)
};

/// Light that comes from all directions: one colour from above, one from the ground.
struct Ambient {
    fvec3 above = 0.9F * render::colour(0x8078B8);
    fvec3 below = 0.9F * render::colour(0x4A3A48);
};

/// Surroundings of the arena. The defaults are dusk: violet sky, low warm sun.
struct Environment {
    Sun sun;
    Sky sky;
    Fog fog;
    Ambient ambient;
};

/// A part of the window.
struct Rect {
    int x{}, y{}, width{}, height{};  ///< position and size (px)
};

/// How the window is divided between two players.
enum class Split : std::uint8_t { none, side_by_side, top_bottom };

/// Viewports of the two players. They are adjacent, cover the window and do not overlap. Split::none returns
/// the whole window and an empty rectangle.
std::array<Rect, 2> split_window(int width, int height, Split split);

/// One view of the world.
struct ViewScene {
    Camera camera;
    Rect viewport;
    std::span<const Instance> instances;
    std::span<const PointLight> lights;  ///< point lights, up to max_lights
    Environment environment;
    /// Flat shade on the ground, drawn after all solid objects. It multiplies the colour below by the mesh's
    /// colour. tint.r from 0 (no effect) to 1 sets the strength.
    std::span<const Instance> shades{};
    /// Soft translucent objects, drawn after everything else in the world, in any order. They are round
    /// meshes, densest where they face the eye. The tint is the light that they emit. `glow` is the greatest
    /// share of the background that they hide.
    std::span<const Instance> mists{};
    /// Blocks filled by `instances`, or slightly larger ones. Objects hidden by one of these blocks are not
    /// drawn. The first 64 also hide the sky.
    std::span<const Block> blocks{};
    const Volume* volume{};         ///< volume to draw after all solid objects; null: none
    std::span<const Scan> scans{};  ///< scans, drawn after `volume`
    ScanDetail scan_detail = ScanDetail::automatic;
};

/// Objects that cast the sun's shadow, in all views. `fixed` never changes from frame to frame, so its shadow
/// is drawn once and kept.
struct Casters {
    std::span<const Instance> fixed, moving;
};

// The overlay: flat shapes and text over the views, drawn in order with alpha blending. Slanted edges are
// smoothed. Lengths are in px.

/// A filled rectangle.
struct RectItem {
    fvec2 low, high;  ///< top-left and bottom-right corner
    fvec4 colour{1};
    float corner{};  ///< radius of rounded corners
};

/// A filled triangle.
struct TriangleItem {
    fvec2 a, b, c;
    fvec4 colour{1};
};

/// A piece of a ring, from `start` over `sweep` (rad). 0 is up and positive is clockwise, as on a clock. An
/// inner radius of 0 gives a slice of pie.
struct ArcItem {
    fvec2 centre;
    float inner{}, outer{};
    float start{}, sweep{};
    fvec4 colour{1};
};

/// A straight line.
struct LineItem {
    fvec2 from, to;
    float width = 1;
    fvec4 colour{1};
};

/// Which side of a text stands at its position.
enum class Align : std::uint8_t { left, centre, right };

/// UTF-8 text; '\n' starts a new line. `position` is the top of the text's box (Font::measure) at its left,
/// middle or right. `size` is the em, rounded to whole pixels.
struct TextItem {
    std::string text;
    fvec2 position;
    float size = 16;
    fvec4 colour{1};
    Align align = Align::left;
};

/// One shape or text of the overlay.
using OverlayItem = std::variant<RectItem, TriangleItem, ArcItem, LineItem, TextItem>;

/// Items that are drawn over the views, in this order.
struct Overlay {
    std::vector<OverlayItem> items;
};

/// New triangles of a mesh that changes, such as a line that follows a hand.
struct MeshChange {
    MeshId mesh{};
    /// Version of the triangles, above 0. They are sent only if it differs from the last version that was
    /// sent for this mesh.
    std::uint64_t version{};
    const MeshData* triangles{};
};

/// The whole picture.
struct Frame {
    int width{}, height{};           ///< size of the window's framebuffer (px)
    std::vector<ViewScene> views{};  ///< one view, or two that do not overlap; the rest is black
    Overlay overlay{};
    float internal_scale = 1;  ///< scale of the views' resolution, 0.25 to 1; the result is stretched
    Quality quality = Quality::low;
    /// true: bright light spreads (bloom); used at Quality::high only.
    bool bloom = true;
    Casters casters{};                      ///< objects that cast shadows in the sunlight of the first view
    std::span<const MeshChange> changes{};  ///< meshes that may have changed; sent before anything is drawn
};

}  // namespace thaum::render

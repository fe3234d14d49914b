// The shader programs of the renderer, and the uniforms that a view sets in them.
#pragma once
#include <array>

#include "render/detail/batches.h"
#include "render/detail/program.h"
#include "render/quality.h"
#include "render/scene.h"

namespace thaum::render::detail {

// Texture units. The overlay uses the first one as well.
inline constexpr GLint picture_unit = 0, shadow_unit = 1, bloom_unit = 2;

struct MeshProgram {
    Program program;
    GLint view_projection{}, eye{}, sun_direction{}, sun_colour{}, ambient_above{}, ambient_below{};
    GLint light_position{}, light_colour{}, fog_colour{}, fog_rate{}, detail_range{};
    GLint shadow_matrix{}, shadow_lift{}, shadow_texel{};
    /// Uniforms of the instance (placed copy of a mesh), only in programs that draw a single one.
    GLint model{}, tint_glow{}, instance_sun{};
};

struct SkyProgram {
    Program program;
    GLint forward{}, right{}, up{}, zenith{}, horizon{}, sun_direction{}, sun_glow{}, fog_colour{},
        cleared_to_fog{};
};

struct MistProgram {
    Program program;
    GLint view_projection{}, eye{};
};

/// A program with one parameter, a matrix or a length in texels.
struct SmallProgram {
    Program program;
    GLint parameter{};
    /// Uniform that says which part of the picture the program reads; -1 if there is none.
    GLint part{};
};

struct Programs {
    std::array<MeshProgram, qualities> mesh;  ///< programs for meshes, indexed by Quality
    /// Programs for a single instance of a mesh, indexed by Quality.
    std::array<MeshProgram, qualities> alone;
    /// Programs for a single instance that the sun never reaches, at Quality::medium and at Quality::high.
    MeshProgram sunless, sunless_of_light;
    /// Programs for Quality::high and a single instance whose light changes little between vertices, where it
    /// is computed. The sun never reaches the second.
    MeshProgram even_of_light, sunless_even_of_light;
    /// Programs for the sky: one writes tone-mapped pixels, the other linear light, which the last pass
    /// converts.
    SkyProgram sky, sky_of_light;
    /// Programs for mists (steam and spells): one writes tone-mapped pixels, the other linear light, which
    /// the last pass converts.
    MistProgram mist, mist_of_light;
    /// `shadow` draws the depth of what casts shadows, `shade` flat shades on the ground (parameter:
    /// view_projection).
    SmallProgram shadow, shade;
    /// Bloom: `bright` extracts bright light (parameter: texel), `blur` blurs along one axis (parameter:
    /// way).
    SmallProgram bright, blur;
    SmallProgram show;     ///< brings a view into the window as it is
    SmallProgram compose;  ///< converts light to pixels, with bloom (parameter: bloom_strength)
    /// Overlay: `overlay` draws text, `shape` all other items (parameter: pixel).
    SmallProgram overlay, shape;
};

/// Sets a uniform of the program in use.
inline void put(GLint place, fvec3 v) { glUniform3f(place, v.x, v.y, v.z); }

/// Looks up the uniforms of a program with the lighting of meshes.
MeshProgram mesh_program(Program program);

/// Loads all programs. The error names the file.
Expected<Programs> load_programs(const std::filesystem::path& shaders);

/// What a shader needs to read the sun's shadow map.
struct ShadowView {
    fmat4 to_map{1};  ///< maps the world to coordinates and depth in the shadow map, 0 to 1
    float lift{};     ///< offset along a surface's normal, against shadows of the surface on itself (m)
    float texel{};    ///< width of a texel, as a share of the shadow map's
};

void use_mesh_program(const MeshProgram& program, const ViewScene& view, const Sight& sight, Quality quality,
                      const ShadowView& shadow);
/// Sets the uniforms of the one instance that a program of Programs::alone draws; the program must be in use.
void set_instance(const MeshProgram& program, const GpuInstance& instance);
/// Sets up the program of the sky. `cleared_to_fog`: the framebuffer was cleared to the colour of the view's
/// fog.
void use_sky_program(const SkyProgram& program, const ViewScene& view, float aspect, bool cleared_to_fog);

/// Applies the tone curve of tone.glsl to linear light.
fvec3 tone_mapped(fvec3 light);

}  // namespace thaum::render::detail

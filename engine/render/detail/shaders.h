// The programs of the renderer and how a view's numbers get into them.
#pragma once
#include <array>

#include "render/detail/batches.h"
#include "render/detail/program.h"
#include "render/quality.h"
#include "render/scene.h"

namespace thaum::render::detail {

// Texture units; the overlay uses the first as well.
inline constexpr GLint picture_unit = 0, shadow_unit = 1, bloom_unit = 2;

struct MeshProgram {
    Program program;
    GLint view_projection{}, eye{}, sun_direction{}, sun_colour{}, ambient_above{}, ambient_below{};
    GLint light_position{}, light_colour{}, fog_colour{}, fog_rate{}, detail_range{};
    GLint shadow_matrix{}, shadow_lift{}, shadow_texel{};
    GLint model{}, tint_glow{}, instance_sun{};  ///< of one that draws a single instance
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
    GLint part{};  ///< uniform for the part of the picture that screen.vert reads; -1 where there is none
};

struct Programs {
    std::array<MeshProgram, qualities> mesh;   ///< by Quality
    std::array<MeshProgram, qualities> alone;  ///< by Quality, for a single instance
    MeshProgram sunless;                       ///< at medium, for a single one that the sun never reaches
    SkyProgram sky, sky_of_light;              ///< tone mapped, and for what the last pass tone maps
    MistProgram mist, mist_of_light;           ///< likewise
    SmallProgram shadow, shade;                ///< view_projection
    SmallProgram bright, blur;                 ///< texel, way
    SmallProgram compose;                      ///< bloom_strength
    SmallProgram overlay, shape;               ///< pixel; for text, and for all else
};

/// Finds the uniforms of a program that lights as meshes are lit.
MeshProgram mesh_program(Program program);

/// The error names the file.
Expected<Programs> load_programs(const std::filesystem::path& shaders);

/// How the sun's map is read.
struct ShadowView {
    fmat4 to_map{1};  ///< world to [0, 1]
    float lift{};     ///< m
    float texel{};    ///< of the map's width
};

void use_mesh_program(const MeshProgram& program, const ViewScene& view, const Sight& sight, Quality quality,
                      const ShadowView& shadow);
/// For one of Programs::alone, which is in use.
void set_instance(const MeshProgram& program, const GpuInstance& instance);
/// `cleared_to_fog`: what nothing covers has the colour of the view's fog already.
void use_sky_program(const SkyProgram& program, const ViewScene& view, float aspect, bool cleared_to_fog);

/// As tone.glsl has it.
fvec3 tone_mapped(fvec3 light);

}  // namespace thaum::render::detail

#include "render/detail/shaders.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace thaum::render::detail {
namespace {

using Folder = std::filesystem::path;
using Variant = std::vector<std::string_view>;

constexpr std::size_t lights_at_low = 4;  // lights at Quality::low; same value as in light.glsl

Variant variant_of(Quality quality) {
    switch (quality) {
        case Quality::low: return {"FEW_LIGHTS"};
        case Quality::medium: return {"SHADOW"};
        case Quality::high: return {"SHADOW", "SOFT", "PER_PIXEL"};
    }
    return {};
}

/// Files of a shader variant. A .glsl file belongs to the stage of the file before it, so lighting and tone
/// curve are compiled into the stage that uses them.
std::vector<Folder> mesh_files(const Folder& shaders, Quality quality) {
    const auto vert = shaders / "mesh.vert", light = shaders / "light.glsl", tone = shaders / "tone.glsl",
               shadow = shaders / "shadow.glsl";
    switch (quality) {
        case Quality::low: return {vert, light, tone, shaders / "flat.frag"};
        case Quality::medium: return {vert, light, tone, shaders / "shaded.frag", shadow};
        case Quality::high: return {vert, shaders / "mesh.frag", light, shadow};
    }
    return {};
}

Expected<MeshProgram> load_mesh_program(const Folder& shaders, Quality quality, const Variant& variant) {
    auto program = load_program(mesh_files(shaders, quality), variant);
    if (!program) return program.error();
    return mesh_program(std::move(*program));
}

Expected<SkyProgram> load_sky_program(const Folder& shaders, const Variant& variant) {
    auto program =
        load_program({shaders / "sky.vert", shaders / "tone.glsl", shaders / "flat.frag"}, variant);
    if (!program) return program.error();
    SkyProgram out{.program = std::move(*program)};
    const auto named = [&](const char* name) { return uniform(out.program, name); };
    out.forward = named("forward");
    out.right = named("right");
    out.up = named("up");
    out.zenith = named("zenith");
    out.horizon = named("horizon");
    out.sun_direction = named("sun_direction");
    out.sun_glow = named("sun_glow");
    out.fog_colour = named("fog_colour");
    out.cleared_to_fog = named("cleared_to_fog");
    return out;
}

Expected<MistProgram> load_mist_program(const Folder& shaders, const Variant& variant) {
    auto program =
        load_program({shaders / "mist.vert", shaders / "tone.glsl", shaders / "mist.frag"}, variant);
    if (!program) return program.error();
    MistProgram out{.program = std::move(*program)};
    out.view_projection = uniform(out.program, "view_projection");
    out.eye = uniform(out.program, "eye");
    return out;
}

Expected<SmallProgram> load_small_program(const std::vector<Folder>& files, const char* parameter) {
    auto program = load_program(files);
    if (!program) return program.error();
    SmallProgram out{.program = std::move(*program)};
    out.parameter = uniform(out.program, parameter);
    out.part = uniform(out.program, "part");
    glUseProgram(out.program.get());
    for (const char* sampler : {"picture", "atlas"}) glUniform1i(uniform(out.program, sampler), picture_unit);
    glUniform1i(uniform(out.program, "bloom"), bloom_unit);
    return out;
}

Variant alone(Variant variant) {
    variant.emplace_back("ALONE");
    return variant;
}

/// Takes the loaded programs and keeps the first error.
struct Loading {
    std::optional<Error> error;
    template <class T>
    void take(Expected<T> loaded, T& to) {
        if (loaded)
            to = std::move(*loaded);
        else if (!error)
            error = loaded.error();
    }
};

void set(GLint place, fvec3 v) { glUniform3f(place, v.x, v.y, v.z); }

void set_lights(const MeshProgram& p, std::span<const PointLight> lights, std::size_t most) {
    std::array<fvec4, max_lights> position{};
    std::array<fvec3, max_lights> colour{};
    const auto count = std::min(lights.size(), most);
    for (std::size_t i = 0; i < count; ++i) {
        const float radius = std::max(lights[i].radius, 1e-3F);
        position[i] = fvec4(lights[i].position, 1 / (radius * radius));
        colour[i] = lights[i].colour;
    }
    glUniform4fv(p.light_position, max_lights, &position[0].x);
    glUniform3fv(p.light_colour, max_lights, &colour[0].x);
}

}  // namespace

MeshProgram mesh_program(Program program) {
    MeshProgram out{.program = std::move(program)};
    const auto named = [&](const char* name) { return uniform(out.program, name); };
    out.view_projection = named("view_projection");
    out.eye = named("eye");
    out.sun_direction = named("sun_direction");
    out.sun_colour = named("sun_colour");
    out.ambient_above = named("ambient_above");
    out.ambient_below = named("ambient_below");
    out.light_position = named("light_position");
    out.light_colour = named("light_colour");
    out.fog_colour = named("fog_colour");
    out.fog_rate = named("fog_rate");
    out.detail_range = named("detail_range");
    out.shadow_matrix = named("shadow_matrix");
    out.shadow_lift = named("shadow_lift");
    out.shadow_texel = named("shadow_texel");
    out.model = named("model");
    out.tint_glow = named("tint_glow");
    out.instance_sun = named("instance_sun");
    glUseProgram(out.program.get());
    glUniform1i(named("shadow_map"), shadow_unit);
    return out;
}

Expected<Programs> load_programs(const Folder& shaders) {
    Programs out;
    Loading loading;
    for (std::size_t q = 0; q < qualities; ++q) {
        const auto quality = static_cast<Quality>(q);
        const auto variant = variant_of(quality);
        loading.take(load_mesh_program(shaders, quality, variant), out.mesh[q]);
        loading.take(load_mesh_program(shaders, quality, alone(variant)), out.alone[q]);
    }
    // Like the program for Quality::low, which has no shadow map, but with all lights.
    loading.take(load_mesh_program(shaders, Quality::low, alone({})), out.sunless);
    loading.take(load_mesh_program(shaders, Quality::high, alone({"PER_PIXEL"})), out.sunless_of_light);
    loading.take(load_mesh_program(shaders, Quality::medium, alone({"SHADOW", "SOFT", "LINEAR"})),
                 out.even_of_light);
    loading.take(load_mesh_program(shaders, Quality::low, alone({"LINEAR"})), out.sunless_even_of_light);
    loading.take(load_sky_program(shaders, {}), out.sky);
    loading.take(load_sky_program(shaders, {"LINEAR"}), out.sky_of_light);
    loading.take(load_mist_program(shaders, {}), out.mist);
    loading.take(load_mist_program(shaders, {"LINEAR"}), out.mist_of_light);
    const auto small = [&](const std::vector<Folder>& files, const char* parameter, SmallProgram& to) {
        loading.take(load_small_program(files, parameter), to);
    };
    small({shaders / "shadow.vert", shaders / "shadow.frag"}, "view_projection", out.shadow);
    small({shaders / "shade.vert", shaders / "flat.frag"}, "view_projection", out.shade);
    small({shaders / "screen.vert", shaders / "bright.frag"}, "texel", out.bright);
    small({shaders / "screen.vert", shaders / "blur.frag"}, "way", out.blur);
    small({shaders / "show.vert", shaders / "show.frag"}, "", out.show);
    small({shaders / "screen.vert", shaders / "compose.frag", shaders / "tone.glsl"}, "bloom_strength",
          out.compose);
    small({shaders / "overlay.vert", shaders / "overlay.frag"}, "pixel", out.overlay);
    small({shaders / "overlay.vert", shaders / "shape.frag"}, "pixel", out.shape);
    if (loading.error) return *loading.error;
    return out;
}

void use_mesh_program(const MeshProgram& p, const ViewScene& view, const Sight& sight, Quality quality,
                      const ShadowView& shadow) {
    const auto& e = view.environment;
    glUseProgram(p.program.get());
    glUniformMatrix4fv(p.view_projection, 1, GL_FALSE, &sight.to_clip[0][0]);
    set(p.eye, sight.eye);
    set(p.sun_direction, e.sun.direction);
    set(p.sun_colour, e.sun.colour);
    set(p.ambient_above, e.ambient.above);
    set(p.ambient_below, e.ambient.below);
    set(p.fog_colour, e.fog.colour);
    // With this rate, density^2 / ln 2, exp2(-rate d^2) in the shader equals exp(-(density d)^2).
    glUniform1f(p.fog_rate, e.fog.density * e.fog.density * 1.442695F);
    const auto fading = fading_of(sight.pixel_angle);
    glUniform2f(p.detail_range, fading.from, 1 / (fading.gone - fading.from));
    set_lights(p, view.lights, quality == Quality::low ? lights_at_low : max_lights);
    if (quality == Quality::low) return;
    glUniformMatrix4fv(p.shadow_matrix, 1, GL_FALSE, &shadow.to_map[0][0]);
    glUniform1f(p.shadow_lift, shadow.lift);
    glUniform1f(p.shadow_texel, shadow.texel);
}

void set_instance(const MeshProgram& p, const GpuInstance& instance) {
    glUniformMatrix4fv(p.model, 1, GL_FALSE, &instance.model[0][0]);
    glUniform4fv(p.tint_glow, 1, &instance.tint_glow.x);
    glUniform1f(p.instance_sun, instance.sun);
}

void use_sky_program(const SkyProgram& p, const ViewScene& view, float aspect, bool cleared_to_fog) {
    const auto& e = view.environment;
    const float high = std::tan(view.camera.fov_y / 2);
    const auto axis = [&](fvec3 v) { return view.camera.orientation * v; };
    glUseProgram(p.program.get());
    set(p.forward, axis({0, 0, -1}));
    set(p.right, high * aspect * axis({1, 0, 0}));
    set(p.up, high * axis({0, 1, 0}));
    set(p.zenith, e.sky.zenith);
    set(p.horizon, e.sky.horizon);
    set(p.sun_direction, e.sun.direction);
    set(p.sun_glow, e.sky.sun_glow);
    set(p.fog_colour, e.fog.colour);
    glUniform1i(p.cleared_to_fog, cleared_to_fog ? 1 : 0);
}

fvec3 tone_mapped(fvec3 light) {
    const fvec3 x = glm::max(light - 0.004F, fvec3(0));
    return (x * (6.2F * x + 0.5F)) / (x * (6.2F * x + 1.7F) + 0.06F);
}

}  // namespace thaum::render::detail

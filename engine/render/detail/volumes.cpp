#include "render/detail/volumes.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/assert.h"
#include "render/detail/screen_part.h"

namespace thaum::render::detail {
namespace {

// Texture units of volumes. Their numbers follow those of the units in detail/shaders.h.
constexpr GLint texels_unit = 3, opaque_unit = 4;
constexpr GLuint skin_position = 0, skin_normal = 1, skin_foam = 2;

bool all_finite(fvec3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }
bool positive(fvec3 v) { return all_finite(v) && v.x > 0 && v.y > 0 && v.z > 0; }

/// Bounding box of the ellipsoid that bounds a volume (m).
Block box_of(const Volume& volume) {
    return {vec3(volume.centre - volume.radii), vec3(volume.centre + volume.radii)};
}

bool is_inside(const Volume& volume, fvec3 eye) {
    const fvec3 from = (eye - volume.centre) / volume.radii;
    return eye.y < volume.centre.y && glm::dot(from, from) < 1;
}

/// Part of the view that the volume's skin (its upper surface) may cover, with one more
/// pixel on each side for interpolation.
Rect part_of(const Volume& volume, const Sight& sight, const Rect& view) {
    fvec3 low(std::numeric_limits<float>::max()), high(-low);
    for (const auto& v : volume.skin) low = glm::min(low, v.position), high = glm::max(high, v.position);
    return screen_part(low, high, sight.to_clip, view);
}

int steps_of(Quality quality) {
    switch (quality) {
        case Quality::low: return 7;
        case Quality::medium: return 10;
        case Quality::high: return 28;
    }
    return 7;
}

void filter(GLenum target, GLint how) {
    for (const GLenum name : {GLenum{GL_TEXTURE_MIN_FILTER}, GLenum{GL_TEXTURE_MAG_FILTER}})
        glTexParameteri(target, name, how);
    for (const GLenum name :
         {GLenum{GL_TEXTURE_WRAP_S}, GLenum{GL_TEXTURE_WRAP_T}, GLenum{GL_TEXTURE_WRAP_R}})
        glTexParameteri(target, name, GL_CLAMP_TO_EDGE);
}

template <class T>
void fill_buffer(GLenum target, const Buffer& buffer, std::span<const T> data) {
    glBindBuffer(target, buffer.get());
    glBufferData(target, static_cast<GLsizeiptr>(data.size_bytes()), data.data(), GL_STREAM_DRAW);
}

void scissored_clear(const Rect& part, GLbitfield what) {
    glEnable(GL_SCISSOR_TEST);
    glScissor(part.x, part.y, part.width, part.height);
    glClearColor(0, 0, 0, 0);
    glClear(what);
    glDisable(GL_SCISSOR_TEST);
}

}  // namespace

bool drawable(const Volume& volume) {
    std::size_t texels = 1;
    for (const int n : volume.cells) {
        if (n < 1) return false;
        texels *= static_cast<std::size_t>(n);
    }
    return texels == volume.texels.size() && positive(volume.size) && positive(volume.radii) &&
           all_finite(volume.origin) && all_finite(volume.centre) && std::isfinite(volume.brightness) &&
           std::isfinite(volume.thickness) && !volume.skin_indices.empty();
}

SeenVolume seen(const Volume& volume, const Camera& camera, const Sight& sight, const Rect& view) {
    SeenVolume its{
        .volume = &volume, .inside = is_inside(volume, camera.position), .view = view, .part = view};
    if (!its.inside) its.part = part_of(volume, sight, view);
    if (its.part.width <= 0 || its.part.height <= 0) its.volume = nullptr;
    return its;
}

void add_dipped(const Volume& volume, std::span<const Instance> instances,
                std::span<const Bounds> mesh_bounds, std::span<const PatchTable> patches,
                std::vector<Instance>& out) {
    const auto box = box_of(volume);
    for (const auto& instance : instances) {
        if (!patches[instance.mesh].patches.empty() || !finite(instance.model)) continue;
        const auto there = placed(mesh_bounds[instance.mesh], instance.model);
        const fvec3 nearest = glm::clamp(there.centre, fvec3(box.low), fvec3(box.high));
        if (glm::distance(nearest, there.centre) < there.radius) out.push_back(instance);
    }
}

int march_share(Quality quality) { return quality == Quality::high ? 1 : 3; }

Expected<Volumes::MarchProgram> Volumes::load_march(const std::filesystem::path& shaders, bool inside,
                                                    bool linear) {
    std::vector<std::string_view> variant;
    if (inside) variant.emplace_back("INSIDE");
    if (linear) variant.emplace_back("LINEAR");
    std::vector<std::filesystem::path> files{shaders / "march.vert", shaders / "light.glsl",
                                             shaders / "march.frag", shaders / "tone.glsl"};
    auto program = load_program(files, variant);
    if (!program) return program.error();
    MarchProgram out{.view = mesh_program(std::move(*program))};
    const auto named = [&](const char* name) { return uniform(out.view.program, name); };
    out.forward = named("forward");
    out.right = named("right");
    out.up = named("up");
    out.zenith = named("zenith");
    out.horizon = named("horizon");
    out.foam_colour = named("foam_colour");
    out.depth_range = named("depth_range");
    out.origin = named("origin");
    out.inverse_size = named("inverse_size");
    out.centre = named("centre");
    out.inverse_radii = named("inverse_radii");
    out.brightness = named("brightness");
    out.thickness = named("thickness");
    out.steps = named("steps");
    glUniform1i(named("texels"), texels_unit);
    glUniform1i(named("opaque"), opaque_unit);
    return out;
}

Expected<Volumes::SkinProgram> Volumes::load_skin(const std::filesystem::path& shaders, bool inside) {
    std::vector<std::string_view> variant;
    if (inside) variant.emplace_back("INSIDE");
    auto program = load_program({shaders / "skin.vert", shaders / "skin.frag"}, variant);
    if (!program) return program.error();
    SkinProgram out{.program = std::move(*program)};
    out.view_projection = uniform(out.program, "view_projection");
    out.to_picture = uniform(out.program, "to_picture");
    glUseProgram(out.program.get());
    glUniform1i(uniform(out.program, "picture"), picture_unit);
    return out;
}

Expected<Volumes> Volumes::load(const std::filesystem::path& shaders) {
    Volumes out;
    for (const std::size_t inside : {0U, 1U}) {
        for (const std::size_t linear : {0U, 1U}) {
            auto march = load_march(shaders, inside == 1, linear == 1);
            if (!march) return march.error();
            out.march_[inside][linear] = std::move(*march);
        }
        auto skin = load_skin(shaders, inside == 1);
        if (!skin) return skin.error();
        out.skin_[inside] = std::move(*skin);
    }
    return out;
}

VolumeId Volumes::make() {
    all_.push_back({make_texture(), make_vertex_array(), make_buffer(), make_buffer(), 0, {}, 0, false});
    const auto& gpu = all_.back();
    glBindVertexArray(gpu.array.get());
    glBindBuffer(GL_ARRAY_BUFFER, gpu.vertices.get());
    attribute(skin_position, 3, sizeof(SkinVertex), offsetof(SkinVertex, position));
    attribute(skin_normal, 3, sizeof(SkinVertex), offsetof(SkinVertex, normal));
    attribute(skin_foam, 1, sizeof(SkinVertex), offsetof(SkinVertex, foam));
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, gpu.indices.get());
    bind(texels_unit, GL_TEXTURE_3D, gpu.texels);
    glActiveTexture(GL_TEXTURE0 + texels_unit);
    filter(GL_TEXTURE_3D, GL_LINEAR);
    glActiveTexture(GL_TEXTURE0);
    return static_cast<VolumeId>(all_.size() - 1);
}

void Volumes::send(const Volume& volume) {
    THAUM_ASSERT(volume.id < all_.size(), "a volume that was never made");
    auto& gpu = all_[volume.id];
    if (gpu.filled && gpu.version == volume.version && gpu.cells == volume.cells) return;
    glActiveTexture(GL_TEXTURE0 + texels_unit);
    glBindTexture(GL_TEXTURE_3D, gpu.texels.get());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    const auto [x, y, z] = volume.cells;
    if (!gpu.filled || gpu.cells != volume.cells)
        glTexImage3D(GL_TEXTURE_3D, 0, GL_RGBA8, x, y, z, 0, GL_RGBA, GL_UNSIGNED_BYTE, volume.texels.data());
    else
        glTexSubImage3D(GL_TEXTURE_3D, 0, 0, 0, 0, x, y, z, GL_RGBA, GL_UNSIGNED_BYTE, volume.texels.data());
    glActiveTexture(GL_TEXTURE0);
    glBindVertexArray(gpu.array.get());
    fill_buffer(GL_ARRAY_BUFFER, gpu.vertices, volume.skin);
    fill_buffer(GL_ELEMENT_ARRAY_BUFFER, gpu.indices, volume.skin_indices);
    gpu.index_count = static_cast<GLsizei>(volume.skin_indices.size());
    gpu.cells = volume.cells;
    gpu.version = volume.version;
    gpu.filled = true;
    ++sent_;
}

void Volumes::begin(int width, int height, Quality quality) {
    const GLint format = quality == Quality::high ? GL_RGBA16F : GL_RGBA8;
    if (marched_.width == width && marched_.height == height && format_ == format) return;
    marched_ = {};
    format_ = format;
    resize(marched_, format, false, width, height);
    depth_ = make_texture();
    glBindTexture(GL_TEXTURE_2D, depth_.get());
    glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, width, height, 0, GL_DEPTH_COMPONENT,
                 GL_UNSIGNED_INT, nullptr);
    filter(GL_TEXTURE_2D, GL_NEAREST);
    depth_target_ = make_framebuffer();
    glBindFramebuffer(GL_FRAMEBUFFER, depth_target_.get());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth_.get(), 0);
    glDrawBuffer(GL_NONE);
    glReadBuffer(GL_NONE);
}

void Volumes::begin_depth(const SeenVolume& its, const Sight& sight, const SmallProgram& depth_program) {
    send(*its.volume);
    glBindFramebuffer(GL_FRAMEBUFFER, depth_target_.get());
    glViewport(its.view.x, its.view.y, its.view.width, its.view.height);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glDepthMask(GL_TRUE);
    glEnable(GL_CULL_FACE);
    glDisable(GL_BLEND);
    scissored_clear(its.part, GL_DEPTH_BUFFER_BIT);
    glUseProgram(depth_program.program.get());
    glUniformMatrix4fv(depth_program.parameter, 1, GL_FALSE, &sight.to_clip[0][0]);
}

void Volumes::march(const ViewScene& view, const SeenVolume& its, const Sight& sight, Quality quality,
                    const VertexArray& no_attributes) {
    glBindFramebuffer(GL_FRAMEBUFFER, marched_.framebuffer.get());
    // The depth passes of all views came before, so the viewport may still be that of another view.
    glViewport(its.view.x, its.view.y, its.view.width, its.view.height);
    glDisable(GL_DEPTH_TEST);
    scissored_clear(its.part, GL_COLOR_BUFFER_BIT);
    bind(texels_unit, GL_TEXTURE_3D, all_[its.volume->id].texels);
    bind(opaque_unit, GL_TEXTURE_2D, depth_);
    const auto& program = march_[its.inside ? 1 : 0][quality == Quality::high ? 1 : 0];
    use_mesh_program(program.view, view, sight, quality, {});
    set_eye(program, view);
    set_volume(program, *its.volume);
    glUniform1i(program.steps, steps_of(quality));
    draw(its, no_attributes);
}

void Volumes::set_eye(const MarchProgram& p, const ViewScene& view) {
    const auto& camera = view.camera;
    const float high = std::tan(camera.fov_y / 2);
    const float aspect = static_cast<float>(view.viewport.width) / static_cast<float>(view.viewport.height);
    put(p.forward, camera.orientation * fvec3(0, 0, -1));
    put(p.right, camera.orientation * fvec3(high * aspect, 0, 0));
    put(p.up, camera.orientation * fvec3(0, high, 0));
    put(p.zenith, view.environment.sky.zenith);
    put(p.horizon, view.environment.sky.horizon);
    const float nearest = 1 / camera.near_plane, farthest = 1 / camera.far_plane;
    glUniform2f(p.depth_range, nearest, nearest - farthest);
}

void Volumes::set_volume(const MarchProgram& p, const Volume& volume) {
    put(p.origin, volume.origin);
    put(p.inverse_size, 1.0F / volume.size);
    put(p.centre, volume.centre);
    put(p.inverse_radii, 1.0F / volume.radii);
    put(p.foam_colour, volume.foam);
    glUniform1f(p.brightness, volume.brightness);
    glUniform1f(p.thickness, volume.thickness);
}

void Volumes::draw(const SeenVolume& its, const VertexArray& no_attributes) const {
    const auto& gpu = all_[its.volume->id];
    glBindVertexArray((its.inside ? no_attributes : gpu.array).get());
    if (its.inside)
        glDrawArrays(GL_TRIANGLES, 0, 3);
    else
        glDrawElements(GL_TRIANGLES, gpu.index_count, GL_UNSIGNED_INT, nullptr);
}

void Volumes::show(const SeenVolume& its, const Sight& sight, const Rect& at,
                   const VertexArray& no_attributes) {
    const auto& p = skin_[its.inside ? 1 : 0];
    glUseProgram(p.program.get());
    glUniformMatrix4fv(p.view_projection, 1, GL_FALSE, &sight.to_clip[0][0]);
    const fvec2 size(static_cast<float>(marched_.width), static_cast<float>(marched_.height));
    const fvec2 factor(static_cast<float>(its.view.width) / static_cast<float>(at.width),
                       static_cast<float>(its.view.height) / static_cast<float>(at.height));
    const fvec2 shift = fvec2(static_cast<float>(its.view.x), static_cast<float>(its.view.y)) -
                        factor * fvec2(static_cast<float>(at.x), static_cast<float>(at.y));
    glUniform4f(p.to_picture, factor.x / size.x, factor.y / size.y, shift.x / size.x, shift.y / size.y);
    bind(picture_unit, GL_TEXTURE_2D, marched_.colour);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    glDepthMask(GL_TRUE);
    if (its.inside) glDisable(GL_DEPTH_TEST);
    draw(its, no_attributes);
}

}  // namespace thaum::render::detail

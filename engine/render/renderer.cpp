#include "render/renderer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "core/assert.h"
#include "core/text.h"
#include "render/detail/batches.h"
#include "render/detail/gl.h"
#include "render/detail/program.h"
#include "render/detail/shapes2d.h"

namespace thaum::render {

using namespace detail;

namespace {

struct GpuMesh {
    VertexArray array;
    Buffer vertices, indices;
    GLsizei index_count{};
};

struct MeshProgram {
    Program program;
    GLint view_projection{}, eye{}, sun_direction{}, sun_colour{}, ambient_above{}, ambient_below{};
    GLint light_count{}, light_position{}, light_colour{}, fog_colour{}, fog_rate{};
};

struct SkyProgram {
    Program program;
    GLint forward{}, right{}, up{}, zenith{}, horizon{}, sun_direction{}, sun_glow{}, fog_colour{};
};

struct OverlayProgram {
    Program program;
    GLint pixel{};
};

/// Where views are drawn when they are smaller than the window.
struct InnerTarget {
    Framebuffer framebuffer;
    Renderbuffer colour, depth;
    int width{}, height{};
};

struct OverlayBuffers {
    VertexArray array;
    Buffer vertices;
    Texture atlas;
    int atlas_height{};
    std::vector<OverlayVertex> built;
};

constexpr GLsizei sky_corners = 16 * 10 * 6;  // as sky.vert has them

// Attribute numbers, as the shaders have them.
constexpr GLuint at_position = 0, at_normal = 1, at_colour = 2, at_model = 3, at_tint = 7;

const void* offset(std::size_t bytes) { return reinterpret_cast<const void*>(bytes); }

void attribute(GLuint index, GLint floats, std::size_t stride, std::size_t start) {
    glEnableVertexAttribArray(index);
    glVertexAttribPointer(index, floats, GL_FLOAT, GL_FALSE, static_cast<GLsizei>(stride), offset(start));
}

template <class T>
void fill_buffer(GLenum target, const Buffer& buffer, const std::vector<T>& data, GLenum usage) {
    glBindBuffer(target, buffer.get());
    glBufferData(target, static_cast<GLsizeiptr>(data.size() * sizeof(T)), data.data(), usage);
}

GpuMesh make_mesh() {
    GpuMesh mesh{make_vertex_array(), make_buffer(), make_buffer(), 0};
    glBindVertexArray(mesh.array.get());
    glBindBuffer(GL_ARRAY_BUFFER, mesh.vertices.get());
    attribute(at_position, 3, sizeof(Vertex), offsetof(Vertex, position));
    attribute(at_normal, 3, sizeof(Vertex), offsetof(Vertex, normal));
    attribute(at_colour, 3, sizeof(Vertex), offsetof(Vertex, colour));
    for (GLuint i = at_model; i <= at_tint; ++i) glVertexAttribDivisor(i, 1);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, mesh.indices.get());
    return mesh;
}

OverlayBuffers make_overlay_buffers() {
    OverlayBuffers out{make_vertex_array(), make_buffer(), make_texture(), 0, {}};
    glBindVertexArray(out.array.get());
    glBindBuffer(GL_ARRAY_BUFFER, out.vertices.get());
    attribute(0, 2, sizeof(OverlayVertex), offsetof(OverlayVertex, position));
    attribute(1, 2, sizeof(OverlayVertex), offsetof(OverlayVertex, texel));
    glEnableVertexAttribArray(2);
    glVertexAttribPointer(2, 4, GL_UNSIGNED_BYTE, GL_TRUE, sizeof(OverlayVertex),
                          offset(offsetof(OverlayVertex, colour)));
    glBindTexture(GL_TEXTURE_2D, out.atlas.get());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    return out;
}

Expected<MeshProgram> load_mesh_program(const std::filesystem::path& shaders) {
    auto program = load_program({shaders / "mesh.vert", shaders / "mesh.frag", shaders / "tone.glsl"});
    if (!program) return tl::unexpected(program.error());
    MeshProgram out{.program = std::move(*program)};
    const auto named = [&](const char* name) { return uniform(out.program, name); };
    out.view_projection = named("view_projection");
    out.eye = named("eye");
    out.sun_direction = named("sun_direction");
    out.sun_colour = named("sun_colour");
    out.ambient_above = named("ambient_above");
    out.ambient_below = named("ambient_below");
    out.light_count = named("light_count");
    out.light_position = named("light_position");
    out.light_colour = named("light_colour");
    out.fog_colour = named("fog_colour");
    out.fog_rate = named("fog_rate");
    return out;
}

Expected<SkyProgram> load_sky_program(const std::filesystem::path& shaders) {
    auto program = load_program({shaders / "sky.vert", shaders / "tone.glsl", shaders / "sky.frag"});
    if (!program) return tl::unexpected(program.error());
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
    return out;
}

Expected<OverlayProgram> load_overlay_program(const std::filesystem::path& shaders) {
    auto program = load_program({shaders / "overlay.vert", shaders / "overlay.frag"});
    if (!program) return tl::unexpected(program.error());
    OverlayProgram out{.program = std::move(*program)};
    out.pixel = uniform(out.program, "pixel");
    glUseProgram(out.program.get());
    glUniform1i(uniform(out.program, "atlas"), 0);
    return out;
}

void set(GLint place, fvec3 v) { glUniform3f(place, v.x, v.y, v.z); }

void set_lights(const MeshProgram& p, std::span<const PointLight> lights) {
    std::array<fvec4, max_lights> position{};
    std::array<fvec3, max_lights> colour{};
    const auto count = std::min(lights.size(), max_lights);
    for (std::size_t i = 0; i < count; ++i) {
        const float radius = std::max(lights[i].radius, 1e-3F);
        position[i] = fvec4(lights[i].position, 1 / (radius * radius));
        colour[i] = lights[i].colour;
    }
    glUniform1i(p.light_count, static_cast<GLint>(count));
    glUniform4fv(p.light_position, max_lights, &position[0].x);
    glUniform3fv(p.light_colour, max_lights, &colour[0].x);
}

void set_mesh_uniforms(const MeshProgram& p, const ViewScene& view, const fmat4& view_projection) {
    const auto& e = view.environment;
    glUseProgram(p.program.get());
    glUniformMatrix4fv(p.view_projection, 1, GL_FALSE, &view_projection[0][0]);
    set(p.eye, view.camera.position);
    set(p.sun_direction, e.sun.direction);
    set(p.sun_colour, e.sun.colour);
    set(p.ambient_above, e.ambient.above);
    set(p.ambient_below, e.ambient.below);
    set(p.fog_colour, e.fog.colour);
    // exp2(-rate d^2) is exp(-(density d)^2).
    glUniform1f(p.fog_rate, e.fog.density * e.fog.density * 1.442695F);
    set_lights(p, view.lights);
}

void draw_sky(const SkyProgram& p, const ViewScene& view, float aspect) {
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
    glDrawArrays(GL_TRIANGLES, 0, sky_corners);
}

void draw_batch(const GpuMesh& mesh, const Batch& batch, const Buffer& instances) {
    glBindVertexArray(mesh.array.get());
    glBindBuffer(GL_ARRAY_BUFFER, instances.get());
    const auto start = batch.first * sizeof(GpuInstance);
    for (GLuint column = 0; column < 4; ++column) {
        attribute(at_model + column, 4, sizeof(GpuInstance), start + column * sizeof(fvec4));
    }
    attribute(at_tint, 4, sizeof(GpuInstance), start + offsetof(GpuInstance, tint_glow));
    glDrawElementsInstanced(GL_TRIANGLES, mesh.index_count, GL_UNSIGNED_INT, nullptr,
                            static_cast<GLsizei>(batch.count));
}

void resize(InnerTarget& target, int width, int height) {
    if (target.width == width && target.height == height) return;
    target = {make_framebuffer(), make_renderbuffer(), make_renderbuffer(), width, height};
    glBindRenderbuffer(GL_RENDERBUFFER, target.colour.get());
    glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, width, height);
    glBindRenderbuffer(GL_RENDERBUFFER, target.depth.get());
    glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, width, height);
    glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer.get());
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, target.colour.get());
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, target.depth.get());
    THAUM_ASSERT(glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE,
                 text("no framebuffer of ", width, " x ", height));
}

int scaled_length(int length, float scale) {
    return std::max(1, static_cast<int>(std::lround(static_cast<float>(length) * scale)));
}

/// Edges that touch before touch after, since edges are scaled and not sizes.
Rect scaled_rect(const Rect& r, float scale) {
    const auto edge = [&](int at) { return static_cast<int>(std::lround(static_cast<float>(at) * scale)); };
    const int x = edge(r.x), y = edge(r.y);
    return {x, y, edge(r.x + r.width) - x, edge(r.y + r.height) - y};
}

}  // namespace

struct Renderer::State {
    MeshProgram mesh_program;
    SkyProgram sky_program;
    OverlayProgram overlay_program;
    Font font;
    Atlas atlas;
    std::vector<GpuMesh> meshes;
    std::vector<Bounds> mesh_bounds;  // by mesh, as `meshes`
    Buffer instance_buffer;
    VertexArray no_attributes;
    OverlayBuffers overlay;
    InnerTarget inner;
    Batches batches;
    DrawStatistics statistics;
    int drawn_width{}, drawn_height{};  // what read_pixels reads

    void draw_views(const Frame& frame);
    void draw_view(const ViewScene& view, std::size_t first_batch, std::size_t batch_count, const Rect& at,
                   int height);
    void draw_overlay(const Frame& frame);
    void send_atlas();
};

namespace {

/// Uses every shader once, into both kinds of framebuffer: drivers compile at the first use, which took 20 to 260 ms
/// each on a software rasteriser.
void warm_up(Renderer& renderer) {
    const MeshId mesh = renderer.upload(box(fvec3(0.5F), fvec3(1)));
    const Instance instance{.mesh = mesh, .model = translated({0, 1.7F, -3})};
    const PointLight light;
    ViewScene view;
    view.viewport = {0, 0, 8, 8};
    view.instances = {&instance, 1};
    view.lights = {&light, 1};
    Frame frame{.width = 8, .height = 8, .views = {view}, .overlay = {}};
    frame.overlay.items.push_back(TextItem{.text = "a", .position = {0, 0}, .size = 8});
    renderer.draw(frame);
    frame.internal_scale = 0.5F;
    renderer.draw(frame);
    renderer.replace(mesh, {});
    glFinish();
}

}  // namespace

Renderer::Renderer(std::unique_ptr<State> state) : state_(std::move(state)) {}
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;
Renderer::~Renderer() = default;

Expected<Renderer> Renderer::create(const std::filesystem::path& assets) {
    const auto shaders = assets / "shaders";
    auto mesh = load_mesh_program(shaders);
    if (!mesh) return tl::unexpected(mesh.error());
    auto sky = load_sky_program(shaders);
    if (!sky) return tl::unexpected(sky.error());
    auto overlay = load_overlay_program(shaders);
    if (!overlay) return tl::unexpected(overlay.error());
    auto font = Font::load();
    if (!font) return tl::unexpected(font.error());
    auto state = std::make_unique<State>(State{.mesh_program = std::move(*mesh),
                                               .sky_program = std::move(*sky),
                                               .overlay_program = std::move(*overlay),
                                               .font = std::move(*font),
                                               .atlas = {},
                                               .meshes = {},
                                               .mesh_bounds = {},
                                               .instance_buffer = make_buffer(),
                                               .no_attributes = make_vertex_array(),
                                               .overlay = make_overlay_buffers(),
                                               .inner = {},
                                               .batches = {},
                                               .statistics = {},
                                               .drawn_width = 0,
                                               .drawn_height = 0});
    Renderer renderer(std::move(state));
    warm_up(renderer);
    return renderer;
}

MeshId Renderer::upload(const MeshData& mesh) {
    auto& s = *state_;
    s.meshes.push_back(make_mesh());
    s.mesh_bounds.emplace_back();
    const auto id = static_cast<MeshId>(s.meshes.size() - 1);
    replace(id, mesh);
    return id;
}

void Renderer::replace(MeshId id, const MeshData& mesh) {
    auto& s = *state_;
    THAUM_ASSERT(id < s.meshes.size(), "a mesh that was never uploaded cannot be replaced");
    auto& gpu = s.meshes[id];
    glBindVertexArray(gpu.array.get());
    fill_buffer(GL_ARRAY_BUFFER, gpu.vertices, mesh.vertices, GL_STATIC_DRAW);
    fill_buffer(GL_ELEMENT_ARRAY_BUFFER, gpu.indices, mesh.indices, GL_STATIC_DRAW);
    gpu.index_count = static_cast<GLsizei>(mesh.indices.size());
    s.mesh_bounds[id] = bounds(mesh);
}

void Renderer::draw(const Frame& frame) {
    auto& s = *state_;
    s.statistics = {};
    s.drawn_width = frame.width;
    s.drawn_height = frame.height;
    if (frame.width <= 0 || frame.height <= 0) return;
    s.draw_views(frame);
    s.draw_overlay(frame);
}

const DrawStatistics& Renderer::statistics() const { return state_->statistics; }

fvec2 Renderer::measure(std::string_view text, float size) { return state_->font.measure(text, size); }

Image Renderer::read_pixels() {
    const auto& s = *state_;
    Image image{std::max(s.drawn_width, 0), std::max(s.drawn_height, 0), {}};
    const auto row = 3 * static_cast<std::size_t>(image.width);
    image.rgb.resize(row * static_cast<std::size_t>(image.height));
    if (image.rgb.empty()) return image;
    glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, image.width, image.height, GL_RGB, GL_UNSIGNED_BYTE, image.rgb.data());
    // OpenGL counts rows from below.
    for (std::size_t low = 0, high = static_cast<std::size_t>(image.height) - 1; low < high; ++low, --high) {
        std::swap_ranges(&image.rgb[low * row], &image.rgb[low * row] + row, &image.rgb[high * row]);
    }
    return image;
}

void Renderer::State::draw_views(const Frame& frame) {
    const float scale = std::clamp(frame.internal_scale, 0.25F, 1.0F);
    const bool whole = scale == 1.0F;
    const int width = scaled_length(frame.width, scale), height = scaled_length(frame.height, scale);
    if (!whole) resize(inner, width, height);
    glBindFramebuffer(GL_FRAMEBUFFER, whole ? 0 : inner.framebuffer.get());
    glViewport(0, 0, width, height);
    glDepthMask(GL_TRUE);
    glClearColor(0, 0, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);

    batches.instances.clear();
    batches.batches.clear();
    batches.culled = 0;
    std::vector<std::size_t> counts;
    for (const auto& view : frame.views) {
        const auto& r = view.viewport;
        const float aspect = r.height > 0 ? static_cast<float>(r.width) / static_cast<float>(r.height) : 1;
        const fmat4 matrix = projection_matrix(view.camera, aspect) * view_matrix(view.camera);
        counts.push_back(collect(view.instances, mesh_bounds, matrix, batches));
    }
    fill_buffer(GL_ARRAY_BUFFER, instance_buffer, batches.instances, GL_STREAM_DRAW);
    statistics.instances_drawn = batches.instances.size();
    statistics.instances_culled = batches.culled;

    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LEQUAL);
    glEnable(GL_CULL_FACE);
    glDisable(GL_BLEND);
    std::size_t first = 0;
    for (std::size_t i = 0; i < frame.views.size(); ++i) {
        draw_view(frame.views[i], first, counts[i], scaled_rect(frame.views[i].viewport, scale), height);
        first += counts[i];
    }
    if (whole) return;
    glBindFramebuffer(GL_READ_FRAMEBUFFER, inner.framebuffer.get());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    glBlitFramebuffer(0, 0, width, height, 0, 0, frame.width, frame.height, GL_COLOR_BUFFER_BIT, GL_LINEAR);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

void Renderer::State::draw_view(const ViewScene& view, std::size_t first_batch, std::size_t batch_count,
                                const Rect& at, int height) {
    if (at.width <= 0 || at.height <= 0) return;
    glViewport(at.x, height - at.y - at.height, at.width, at.height);
    const float aspect = static_cast<float>(view.viewport.width) / static_cast<float>(view.viewport.height);
    set_mesh_uniforms(mesh_program, view, projection_matrix(view.camera, aspect) * view_matrix(view.camera));
    for (std::size_t i = first_batch; i < first_batch + batch_count; ++i) {
        const auto& batch = batches.batches[i];
        const auto& mesh = meshes[batch.mesh];
        draw_batch(mesh, batch, instance_buffer);
        statistics.triangles += batch.count * static_cast<std::size_t>(mesh.index_count) / 3;
    }
    // Last, so that only pixels that nothing covers are paid for.
    glBindVertexArray(no_attributes.get());
    draw_sky(sky_program, view, aspect);
    statistics.draws += batch_count + 1;
}

void Renderer::State::send_atlas() {
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, overlay.atlas.get());
    if (!atlas.take_changed()) return;
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    if (overlay.atlas_height != atlas.height()) {
        overlay.atlas_height = atlas.height();
        glTexImage2D(GL_TEXTURE_2D, 0, GL_R8, Atlas::width, atlas.height(), 0, GL_RED, GL_UNSIGNED_BYTE,
                     atlas.texels().data());
    } else {
        glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, Atlas::width, atlas.height(), GL_RED, GL_UNSIGNED_BYTE,
                        atlas.texels().data());
    }
}

void Renderer::State::draw_overlay(const Frame& frame) {
    overlay.built.clear();
    atlas.start_frame();
    build(frame.overlay, font, atlas, overlay.built);
    if (overlay.built.empty()) return;
    send_atlas();
    glViewport(0, 0, frame.width, frame.height);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glUseProgram(overlay_program.program.get());
    glUniform2f(overlay_program.pixel, 2 / static_cast<float>(frame.width),
                2 / static_cast<float>(frame.height));
    glBindVertexArray(overlay.array.get());
    fill_buffer(GL_ARRAY_BUFFER, overlay.vertices, overlay.built, GL_STREAM_DRAW);
    glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(overlay.built.size()));
    ++statistics.draws;
}

}  // namespace thaum::render

#include "render/renderer.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "core/assert.h"
#include "core/hash.h"
#include "render/detail/batches.h"
#include "render/detail/gpu_mesh.h"
#include "render/detail/overlay_pass.h"
#include "render/detail/read_back.h"
#include "render/detail/scans.h"
#include "render/detail/shaders.h"
#include "render/detail/shadow_map.h"
#include "render/detail/simplify.h"
#include "render/detail/sky_cells.h"
#include "render/detail/targets.h"
#include "render/detail/volumes.h"
#include "render/detail/warm_up.h"

namespace thaum::render {

using namespace detail;

namespace {

int scaled_length(int length, float scale) {
    return std::max(1, static_cast<int>(std::lround(static_cast<float>(length) * scale)));
}

/// Scales a rectangle by its edges instead of its size, so that adjacent rectangles stay adjacent.
Rect scaled_rect(const Rect& r, float scale) {
    const auto edge = [&](int at) { return static_cast<int>(std::lround(static_cast<float>(at) * scale)); };
    const int x = edge(r.x), y = edge(r.y);
    return {x, y, edge(r.x + r.width) - x, edge(r.y + r.height) - y};
}

float aspect_of(const Rect& r) {
    return r.height > 0 ? static_cast<float>(r.width) / static_cast<float>(r.height) : 1;
}

/// Returns true if the views cover every pixel of the window.
bool cover_window(const Frame& frame) {
    int covered = 0;
    for (const auto& view : frame.views) covered += view.viewport.width * view.viewport.height;
    return covered == frame.width * frame.height;
}

/// Returns true if the views cover the window and their fog has the same colour. The window is then cleared
/// to that colour.
bool share_fog(const Frame& frame) {
    for (const auto& view : frame.views)
        if (view.environment.fog.colour != frame.views[0].environment.fog.colour) return false;
    return !frame.views.empty() && cover_window(frame);
}

/// Converts y to count from the bottom of a target `height` px high, as in OpenGL.
Rect from_below(const Rect& r, int height) { return {r.x, height - r.y - r.height, r.width, r.height}; }

/// The batches (draw calls) of one view; they begin at index `first` in the frame's Batches.
struct ViewBatches {
    Sight sight;
    Rect at{};  // viewport inside the target (px)
    std::size_t first{}, solid{}, shades{}, mists{};
    // Number of patchworks (large fixed meshes in patches, such as walls), the last batches of `solid`.
    std::size_t patchworks{};
    SeenVolume volume{};
    std::vector<SeenScan> scans{};
};

}  // namespace

struct Renderer::State {
    Programs programs;
    OverlayPass overlay;
    std::vector<GpuMesh> meshes;
    std::vector<Bounds> mesh_bounds;            // bounds of each mesh
    std::vector<Levels> mesh_levels;            // coarser copies of each mesh
    std::vector<PatchTable> mesh_patches;       // pieces of those meshes that are drawn in patches
    std::vector<std::uint64_t> mesh_revisions;  // number of times that each mesh was changed
    // Last MeshChange::version that was sent for each mesh; 0: none.
    std::vector<std::uint64_t> mesh_versions;
    Buffer instance_buffer, patch_buffer;
    VertexArray no_attributes;
    // Targets of the views, at most as large as the window; `light` holds linear light for Quality::high.
    Target pixels, light;
    std::vector<Bloom> blooms;  // bloom (bright light that spreads) of each view
    ShadowMap shadow_map;
    Volumes volumes;
    Scans scans;
    Batches batches;
    DrawStatistics statistics;
    PassClock clock;
    int drawn_width{}, drawn_height{};  // size that read_pixels reads (px)
    const Target* drawn{};              // target of the views of the last draw; null before the first one
    bool cleared_to_fog{};              // true: this frame was cleared to the fog's colour
    SkyCells sky;                       // scratch memory, kept between frames
    std::vector<Hidden> hidden;         // regions that blocks hide from the view that collect_view works on
    std::vector<Instance> dipped;       // instances that are partly inside the brew (volume) of a view

    void draw_views(const Frame& frame);
    const Target& begin_target(const Frame& frame, int width, int height);
    std::vector<ViewBatches> collect_views(const Frame& frame, float scale, int height);
    void collect_volume(const ViewScene& view, int height, Quality quality, ViewBatches& its);
    void march_volumes(const Frame& frame, std::span<const ViewBatches> of_views, int width, int height);
    void show_volumes(std::span<const ViewBatches> of_views, int height);
    void show_views(const Frame& frame, std::span<const ViewBatches> of_views, const Target& target);
    void draw_scans(const Frame& frame, std::span<const ViewBatches> of_views, GLuint framebuffer,
                    int height);
    void draw_mists(std::span<const ViewBatches> of_views, const MistProgram& program, int height);
    ShadowView update_shadow(const Frame& frame);
    ViewBatches collect_view(const ViewScene& view, const Rect& at, Quality quality);
    void draw_view(const ViewScene& view, const ViewBatches& its, Quality quality, const ShadowView& shadow,
                   int height);
    void draw_batches(std::size_t first, std::size_t count);
    void draw_patchworks(const MeshProgram& program, const ViewBatches& its,
                         IndexRange (*which)(const ChosenPatches&));
    void draw_stone(const ViewScene& view, const ViewBatches& its, Quality quality, const ShadowView& shadow);
    void draw_open_sky(const ViewScene& view);
    void draw_shades(const ViewBatches& its);
};

Renderer::Renderer(std::unique_ptr<State> state) : state_(std::move(state)) {}
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;
Renderer::~Renderer() = default;

Expected<Renderer> Renderer::create(const std::filesystem::path& assets) {
    auto programs = load_programs(assets / "shaders");
    if (!programs) return programs.error();
    auto volumes = Volumes::load(assets / "shaders");
    if (!volumes) return volumes.error();
    auto scans = Scans::load(assets / "shaders");
    if (!scans) return scans.error();
    auto overlay = OverlayPass::make();
    if (!overlay) return overlay.error();
    auto state = std::make_unique<State>(State{.programs = std::move(*programs),
                                               .overlay = std::move(*overlay),
                                               .meshes = {},
                                               .mesh_bounds = {},
                                               .mesh_levels = {},
                                               .mesh_patches = {},
                                               .mesh_revisions = {},
                                               .mesh_versions = {},
                                               .instance_buffer = make_buffer(),
                                               .patch_buffer = make_buffer(),
                                               .no_attributes = make_vertex_array(),
                                               .pixels = {},
                                               .light = {},
                                               .blooms = {},
                                               .shadow_map = {},
                                               .volumes = std::move(*volumes),
                                               .scans = std::move(*scans),
                                               .batches = {},
                                               .statistics = {},
                                               .clock = {},
                                               .drawn_width = 0,
                                               .drawn_height = 0,
                                               .drawn = nullptr,
                                               .cleared_to_fog = false,
                                               .sky = {},
                                               .hidden = {},
                                               .dipped = {}});
    return Renderer(std::move(state));
}

void Renderer::warm_up(Quality quality) { detail::warm_up(*this, quality); }

std::string Renderer::device() const {
    const auto* name = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
    return name == nullptr ? std::string() : std::string(name);
}

MeshId Renderer::upload(const MeshData& mesh) {
    auto& s = *state_;
    s.meshes.push_back(make_mesh());
    s.mesh_bounds.emplace_back();
    s.mesh_levels.emplace_back();
    s.mesh_patches.emplace_back();
    s.mesh_revisions.push_back(0);
    s.mesh_versions.push_back(0);
    const auto id = static_cast<MeshId>(s.meshes.size() - 1);
    replace(id, mesh);
    return id;
}

MeshId Renderer::upload_with_copies(const MeshData& mesh) {
    const auto id = upload(mesh);
    Levels levels;
    for (const auto& copy : coarser_copies(mesh)) levels.push_back({upload(copy.mesh), copy.error});
    state_->mesh_levels[id] = std::move(levels);
    return id;
}

MeshId Renderer::upload(const Patchwork& patchwork) {
    auto all = joined(patchwork);
    const auto id = upload(all.mesh);
    auto& s = *state_;
    s.meshes[id].index_count = static_cast<GLsizei>(all.table.full_count);
    s.mesh_patches[id] = std::move(all.table);
    return id;
}

void Renderer::replace(MeshId id, const MeshData& mesh) {
    auto& s = *state_;
    THAUM_ASSERT(id < s.meshes.size(), "a mesh that was never uploaded cannot be replaced");
    fill_mesh(s.meshes[id], mesh);
    s.mesh_levels[id].clear();
    s.mesh_patches[id] = {};
    s.mesh_bounds[id] = bounds(mesh);
    ++s.mesh_revisions[id];
}

VolumeId Renderer::make_volume() { return state_->volumes.make(); }

ScanId Renderer::make_scan() { return state_->scans.make(); }

void Renderer::draw(const Frame& frame) {
    auto& s = *state_;
    s.statistics = {};
    s.clock.start();
    s.drawn_width = frame.width;
    s.drawn_height = frame.height;
    if (frame.width <= 0 || frame.height <= 0) return;
    for (const auto& change : frame.changes) {
        if (change.triangles == nullptr || s.mesh_versions.at(change.mesh) == change.version) continue;
        replace(change.mesh, *change.triangles);
        s.mesh_versions[change.mesh] = change.version;
        ++s.statistics.meshes_sent;
    }
    s.draw_views(frame);
    s.statistics.draws += s.overlay.draw(frame, s.programs);
    s.clock.end(Pass::overlay);
}

const DrawStatistics& Renderer::statistics() const { return state_->statistics; }

void Renderer::measure_passes(bool on) { state_->clock.on = on; }

const PassTimes& Renderer::pass_times() const { return state_->clock.times(); }

fvec2 Renderer::measure(std::string_view text, float size) {
    return state_->overlay.font().measure(text, size);
}

std::vector<float> Renderer::read_depths() {
    const auto& drawn = state_->drawn;
    if (drawn == nullptr) return {};
    return read_depths_of(drawn->framebuffer, drawn->width, drawn->height);
}

Image Renderer::read_pixels() { return read_back(state_->drawn_width, state_->drawn_height); }

void Renderer::State::draw_views(const Frame& frame) {
    const float scale = std::clamp(frame.internal_scale, 0.25F, 1.0F);
    const int width = scaled_length(frame.width, scale), height = scaled_length(frame.height, scale);
    const ShadowView shadow = update_shadow(frame);
    clock.end(Pass::changes);
    const auto of_views = collect_views(frame, scale, height);
    clock.end(Pass::selection);
    march_volumes(frame, of_views, width, height);
    clock.end(Pass::volumes);
    const Target& target = begin_target(frame, width, height);
    for (std::size_t i = 0; i < frame.views.size(); ++i) {
        draw_view(frame.views[i], of_views[i], frame.quality, shadow, height);
        // After a flush, a software rasteriser fills this view on its threads while this thread processes the
        // vertices of the next one.
        glFlush();
    }
    clock.end(Pass::meshes);
    show_volumes(of_views, height);
    clock.end(Pass::volumes);
    draw_scans(frame, of_views, target.framebuffer.get(), height);
    clock.end(Pass::scans);
    draw_mists(of_views, frame.quality == Quality::high ? programs.mist_of_light : programs.mist, height);
    clock.end(Pass::mists);
    show_views(frame, of_views, target);
    clock.end(Pass::window);
}

/// Binds and clears the target into which the views are drawn, and returns it.
const Target& Renderer::State::begin_target(const Frame& frame, int width, int height) {
    const bool of_light = frame.quality == Quality::high;
    auto& target = of_light ? light : pixels;
    resize(target, of_light ? GL_RGBA16F : GL_RGBA, true, width, height);
    glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer.get());
    glViewport(0, 0, width, height);
    glDepthMask(GL_TRUE);
    cleared_to_fog = share_fog(frame);
    const fvec3 fog = cleared_to_fog ? frame.views[0].environment.fog.colour : fvec3(0);
    const fvec3 behind = of_light ? fog : tone_mapped(fog);
    glClearColor(behind.r, behind.g, behind.b, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    drawn = &target;
    return target;
}

/// Copies each view separately from the shared target to the window. Otherwise bright or stretched light
/// would spread to the adjacent view.
void Renderer::State::show_views(const Frame& frame, std::span<const ViewBatches> of_views,
                                 const Target& target) {
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    if (!cover_window(frame)) {
        glClearColor(0, 0, 0, 1);
        glClear(GL_COLOR_BUFFER_BIT);
    }
    const bool of_light = frame.quality == Quality::high;
    blooms.resize(of_views.size());
    for (std::size_t i = 0; i < of_views.size(); ++i) {
        const ViewPlace place{from_below(of_views[i].at, target.height),
                              from_below(frame.views[i].viewport, frame.height)};
        if (place.drawn.width <= 0 || place.drawn.height <= 0) continue;
        if (of_light)
            statistics.draws +=
                compose(target, place, frame.bloom ? &blooms[i] : nullptr, programs, no_attributes);
        else
            statistics.draws += show(target, place, programs.show, no_attributes);
    }
    // Without a flush the overlay would be drawn together with this, tile by tile. A software rasteriser
    // takes its fast way only in tiles in which it draws nothing but rectangles.
    glFlush();
}

std::vector<ViewBatches> Renderer::State::collect_views(const Frame& frame, float scale, int height) {
    batches.clear();
    std::vector<ViewBatches> out;
    for (const auto& view : frame.views)
        out.push_back(collect_view(view, scaled_rect(view.viewport, scale), frame.quality));
    statistics.instances_drawn = batches.instances.size();
    statistics.instances_culled = batches.culled;
    for (std::size_t i = 0; i < frame.views.size(); ++i)
        collect_volume(frame.views[i], height, frame.quality, out[i]);
    fill_buffer(GL_ARRAY_BUFFER, instance_buffer, batches.instances, GL_STREAM_DRAW);
    // The patches use GL_ARRAY_BUFFER, since an index buffer would be part of a mesh's vertex array.
    fill_buffer(GL_ARRAY_BUFFER, patch_buffer, batches.patch_indices, GL_STREAM_DRAW);
    return out;
}

/// Collects what is needed to draw the volume of a view, whose target is `height` px high.
void Renderer::State::collect_volume(const ViewScene& view, int height, Quality quality, ViewBatches& its) {
    const auto& at = its.at;
    if (view.volume == nullptr || at.width <= 0 || at.height <= 0 || !drawable(*view.volume)) return;
    const int share = march_share(quality);
    const Rect marched{at.x / share, (height - at.y - at.height) / share, std::max(at.width / share, 1),
                       std::max(at.height / share, 1)};
    its.volume = seen(*view.volume, view.camera, its.sight, marched);
    if (its.volume.volume == nullptr) return;
    dipped.clear();
    add_dipped(*view.volume, view.instances, mesh_bounds, mesh_patches, dipped);
    its.volume.first = batches.batches.size();
    its.volume.count = collect(dipped, {mesh_bounds, mesh_levels}, its.sight, batches);
}

/// Marches rays through the volumes of all views. This runs before the views are drawn, because it does not
/// need them and so need not wait for them.
void Renderer::State::march_volumes(const Frame& frame, std::span<const ViewBatches> of_views, int width,
                                    int height) {
    const auto is_seen = [](const ViewBatches& its) { return its.volume.volume != nullptr; };
    if (std::none_of(of_views.begin(), of_views.end(), is_seen)) return;
    const auto before = volumes.sent();
    const int share = march_share(frame.quality);
    volumes.begin((width + share - 1) / share, (height + share - 1) / share, frame.quality);
    // The work is ordered by target, not by view: each change of the target makes the rasteriser pass over
    // all of the target's tiles.
    for (const auto& its : of_views) {
        if (!is_seen(its)) continue;
        volumes.begin_depth(its.volume, its.sight, programs.shadow);
        draw_batches(its.volume.first, its.volume.count);
    }
    for (std::size_t i = 0; i < of_views.size(); ++i) {
        const auto& its = of_views[i];
        if (!is_seen(its)) continue;
        volumes.march(frame.views[i], its.volume, its.sight, frame.quality, no_attributes);
        ++statistics.volumes_drawn;
    }
    statistics.volumes_sent = volumes.sent() - before;
}

/// Draws the volumes over their views. This runs after all views, so that the vertices of the last view are
/// processed before anything waits for the ray marching.
void Renderer::State::show_volumes(std::span<const ViewBatches> of_views, int height) {
    for (const auto& its : of_views) {
        if (its.volume.volume == nullptr) continue;
        const Rect at = from_below(its.at, height);
        glViewport(at.x, at.y, at.width, at.height);
        glEnable(GL_DEPTH_TEST);
        glEnable(GL_CULL_FACE);
        volumes.show(its.volume, its.sight, at, no_attributes);
        statistics.draws += 2;  // the skin (upper surface) of the volume, and the ray-marched part behind it
    }
}

void Renderer::State::draw_scans(const Frame& frame, std::span<const ViewBatches> of_views,
                                 GLuint framebuffer, int height) {
    for (std::size_t i = 0; i < of_views.size(); ++i) {
        const auto& its = of_views[i];
        if (its.scans.empty()) continue;
        const auto scene =
            hash_scene(batches, its.first, its.solid, {mesh_bounds, mesh_revisions}, its.scans);
        const auto counts = scans.draw({.view = &frame.views[i],
                                        .sight = &its.sight,
                                        .at = from_below(its.at, height),
                                        .framebuffer = framebuffer,
                                        .number = i,
                                        .quality = frame.quality,
                                        .scene = scene},
                                       its.scans, no_attributes);
        statistics.draws += counts.draws;
        statistics.scans_drawn += counts.drawn;
        statistics.scans_marched += counts.marched;
        statistics.scan_bricks_sent += counts.bricks_sent;
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    }
}

void Renderer::State::draw_mists(std::span<const ViewBatches> of_views, const MistProgram& program,
                                 int height) {
    for (const auto& its : of_views) {
        if (its.mists == 0) continue;
        glViewport(its.at.x, height - its.at.y - its.at.height, its.at.width, its.at.height);
        glEnable(GL_DEPTH_TEST);
        glDepthMask(GL_FALSE);
        glEnable(GL_CULL_FACE);
        glEnable(GL_BLEND);
        glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
        glUseProgram(program.program.get());
        glUniformMatrix4fv(program.view_projection, 1, GL_FALSE, &its.sight.to_clip[0][0]);
        const fvec3 eye(its.sight.eye);
        glUniform3fv(program.eye, 1, &eye.x);
        draw_batches(its.first + its.solid + its.shades, its.mists);
    }
}

ShadowView Renderer::State::update_shadow(const Frame& frame) {
    if (frame.quality == Quality::low || frame.views.empty()) return {};
    const auto counts = shadow_map.update(frame.casters, frame.views[0].environment.sun.direction, meshes,
                                          mesh_bounds, mesh_revisions, programs.shadow);
    statistics.shadow_draws = counts.draws;
    statistics.shadow_triangles = counts.triangles;
    return shadow_map.bind();
}

ViewBatches Renderer::State::collect_view(const ViewScene& view, const Rect& at, Quality quality) {
    const auto& camera = view.camera;
    const fmat4 matrix = projection_matrix(camera, aspect_of(view.viewport)) * view_matrix(camera);
    const float pixel_angle =
        finest_px(quality) * 2 * std::tan(camera.fov_y / 2) / static_cast<float>(std::max(at.height, 1));
    hidden.clear();
    add_hidden(view.blocks, vec3(camera.position), hidden);
    // At other qualities all light is computed at the vertices.
    const auto lights = quality == Quality::high ? view.lights.first(std::min(view.lights.size(), max_lights))
                                                 : std::span<const PointLight>{};
    ViewBatches its{.sight = {matrix, camera.position, pixel_angle, hidden, lights},
                    .at = at,
                    .first = batches.batches.size()};
    const MeshTables tables{mesh_bounds, mesh_levels};
    its.solid = collect(view.instances, tables, its.sight, batches);
    arrange(its.first, mesh_patches, its.sight, batches);
    for (std::size_t i = its.first; i < its.first + its.solid; ++i)
        its.patchworks += mesh_patches[batches.batches[i].mesh].patches.empty() ? 0 : 1;
    its.shades = collect(view.shades, tables, its.sight, batches);
    its.mists = collect(view.mists, tables, its.sight, batches);
    its.scans = seen_scans(view.scans, its.sight, at.width, at.height);
    its.sight.hidden = {};
    return its;
}

void Renderer::State::draw_batches(std::size_t first, std::size_t count) {
    for (std::size_t i = first; i < first + count; ++i) {
        const auto& batch = batches.batches[i];
        statistics.triangles += draw_batch(meshes[batch.mesh], batch, instance_buffer);
    }
    statistics.draws += count;
}

/// Draws those patches of large meshes that `which` selects, such as the sunlit ones. The shader program must
/// be in use.
void Renderer::State::draw_patchworks(const MeshProgram& program, const ViewBatches& its,
                                      IndexRange (*which)(const ChosenPatches&)) {
    const auto end = its.first + its.solid;
    for (std::size_t i = end - its.patchworks; i < end; ++i) {
        const auto& batch = batches.batches[i];
        const auto range = which(batch.patches);
        if (range.count == 0) continue;
        set_instance(program, batches.instances[batch.first]);
        statistics.triangles += draw_patches(meshes[batch.mesh], range, patch_buffer);
        ++statistics.draws;
    }
}

/// Draws the patchworks (large fixed meshes in patches). From Quality::medium on, patches that no sun reaches
/// have programs of their own, without a shadow map. At Quality::high only patches near a light have their
/// light computed at each pixel.
void Renderer::State::draw_stone(const ViewScene& view, const ViewBatches& its, Quality quality,
                                 const ShadowView& shadow) {
    const auto draw = [&](const MeshProgram& program, const ShadowView& map,
                          IndexRange (*which)(const ChosenPatches&)) {
        use_mesh_program(program, view, its.sight, quality, map);
        draw_patchworks(program, its, which);
    };
    const auto& program = programs.alone[static_cast<std::size_t>(quality)];
    if (quality == Quality::low) {
        draw(program, shadow, [](const ChosenPatches& p) { return p.all(); });
    } else if (quality == Quality::medium) {
        draw(program, shadow, [](const ChosenPatches& p) { return p.sunlit; });
        draw(programs.sunless, {}, [](const ChosenPatches& p) { return p.sunless; });
    } else {
        draw(program, shadow, [](const ChosenPatches& p) { return p.sunlit.first_of(p.near_light_sunlit); });
        draw(programs.sunless_of_light, {},
             [](const ChosenPatches& p) { return p.sunless.first_of(p.near_light_sunless); });
        draw(programs.even_of_light, shadow,
             [](const ChosenPatches& p) { return p.sunlit.after(p.near_light_sunlit); });
        draw(programs.sunless_even_of_light, {},
             [](const ChosenPatches& p) { return p.sunless.after(p.near_light_sunless); });
    }
}

void Renderer::State::draw_view(const ViewScene& view, const ViewBatches& its, Quality quality,
                                const ShadowView& shadow, int height) {
    const auto& at = its.at;
    if (at.width <= 0 || at.height <= 0) return;
    glViewport(at.x, height - at.y - at.height, at.width, at.height);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LEQUAL);
    glDepthMask(GL_TRUE);
    glEnable(GL_CULL_FACE);
    glDisable(GL_BLEND);
    use_mesh_program(programs.mesh[static_cast<std::size_t>(quality)], view, its.sight, quality, shadow);
    draw_batches(its.first, its.solid - its.patchworks);
    if (its.patchworks > 0) draw_stone(view, its, quality, shadow);
    // The sky is drawn after all solid objects, so that only uncovered pixels are shaded.
    glBindVertexArray(no_attributes.get());
    use_sky_program(quality == Quality::high ? programs.sky_of_light : programs.sky, view,
                    aspect_of(view.viewport), cleared_to_fog);
    draw_open_sky(view);
    draw_shades(its);
}

void Renderer::State::draw_shades(const ViewBatches& its) {
    if (its.shades == 0) return;
    glDepthMask(GL_FALSE);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ZERO, GL_SRC_COLOR);
    glUseProgram(programs.shade.program.get());
    glUniformMatrix4fv(programs.shade.parameter, 1, GL_FALSE, &its.sight.to_clip[0][0]);
    draw_batches(its.first + its.solid, its.shades);
}

/// Draws the sky only in cells that no block is known to cover.
void Renderer::State::draw_open_sky(const ViewScene& view) {
    open_sky_cells(view.camera, aspect_of(view.viewport), view.blocks, sky);
    if (sky.firsts.empty()) return;
    glMultiDrawArrays(GL_TRIANGLES, sky.firsts.data(), sky.counts.data(),
                      static_cast<GLsizei>(sky.firsts.size()));
    ++statistics.draws;
}

}  // namespace thaum::render

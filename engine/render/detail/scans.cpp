#include "render/detail/scans.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "core/assert.h"
#include "core/hash.h"
#include "render/detail/frustum.h"
#include "render/detail/screen_part.h"

namespace thaum::render::detail {
namespace {

// Texture units of scans. Their numbers follow those of the units in detail/shaders.h.
constexpr GLint density_unit = 3, bricks_unit = 4, scene_depth_unit = 5, table_unit = 6, paint_unit = 7,
                materials_unit = 8, drawn_depth_unit = 9;

void set_samplers(const Program& program) {
    const auto set = [&](const char* name, GLint unit) { glUniform1i(uniform(program, name), unit); };
    glUseProgram(program.get());
    set("picture", picture_unit);
    set("density", density_unit);
    set("bricks", bricks_unit);
    set("opaque", scene_depth_unit);
    set("table", table_unit);
    set("paint", paint_unit);
    set("material_table", materials_unit);
    set("drawn_depth", drawn_depth_unit);
}

/// Half size of the box of samples (m, own frame).
fvec3 half_of(const Scan& scan) {
    return 0.5F * scan.spacing *
           fvec3(static_cast<float>(scan.count[0] - 1), static_cast<float>(scan.count[1] - 1),
                 static_cast<float>(scan.count[2] - 1));
}

Rect joined(const Rect& a, const Rect& b) {
    if (a.width <= 0) return b;
    const int x = std::min(a.x, b.x), y = std::min(a.y, b.y);
    return {x, y, std::max(a.x + a.width, b.x + b.width) - x, std::max(a.y + a.height, b.y + b.height) - y};
}

/// Rectangle of a view in a target with 1 / `share` of the view's resolution, with `more` additional pixels
/// on each side.
Rect shared(const Rect& r, int share, int more, int width, int height) {
    const int x = std::max(r.x / share - more, 0), y = std::max(r.y / share - more, 0);
    return {x, y, std::min((r.x + r.width) / share + 1 + more, width) - x,
            std::min((r.y + r.height) / share + 1 + more, height) - y};
}

void allocate_depth(const Texture& texture, int width, int height) {
    glBindTexture(GL_TEXTURE_2D, texture.get());
    // The format of the views' targets (detail/targets.h), so that a copy of their depth converts nothing.
    glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT32F, width, height, 0, GL_DEPTH_COMPONENT, GL_FLOAT,
                 nullptr);
    for (const GLenum name : {GLenum{GL_TEXTURE_MIN_FILTER}, GLenum{GL_TEXTURE_MAG_FILTER}})
        glTexParameteri(GL_TEXTURE_2D, name, GL_NEAREST);
    for (const GLenum name : {GLenum{GL_TEXTURE_WRAP_S}, GLenum{GL_TEXTURE_WRAP_T}})
        glTexParameteri(GL_TEXTURE_2D, name, GL_CLAMP_TO_EDGE);
}

int share_of(Quality quality) {
    switch (quality) {
        case Quality::low: return 3;
        case Quality::medium: return 2;
        case Quality::high: return 1;
    }
    return 1;
}

/// Hash of everything that decides how the scans look, except the scene around them.
std::uint64_t hash_scans(const ScanView& view, std::span<const SeenScan> seen) {
    std::uint64_t hash = hash_value(view.view->camera);
    hash = hash_combine(hash, hash_value(std::array{view.at.width, view.at.height}));
    hash = hash_combine(hash, static_cast<std::uint64_t>(view.quality));
    for (const auto& its : seen) {
        const auto& scan = *its.scan;
        hash = hash_combine(hash, hash_value(std::array<std::uint64_t, 3>{
                                      scan.id, scan.version, static_cast<std::uint64_t>(scan.look)}));
        hash = hash_combine(hash, hash_value(scan.model));
        hash = hash_combine(hash, hash_value(std::array{scan.spacing, scan.colour}));
        hash = hash_combine(
            hash, hash_value(std::array{scan.unit, scan.step, scan.level, scan.sun, scan.low, scan.high,
                                        scan.lit ? 1.0F : 0.0F, scan.leaps ? 1.0F : 0.0F}));
        hash = hash_combine(hash, hash_colours(scan));
    }
    return hash;
}

std::uint64_t hash_light(const ViewScene& view) {
    const auto hash = hash_combine(hash_value(view.environment), hash_bytes(std::as_bytes(view.lights)));
    return view.volume == nullptr ? hash : hash_combine(hash, view.volume->version);
}

}  // namespace

std::vector<SeenScan> seen_scans(std::span<const Scan> scans, const Sight& sight, int width, int height) {
    std::vector<SeenScan> seen;
    if (width <= 0 || height <= 0) return seen;
    const auto planes = frustum_planes(sight.to_clip);
    for (const auto& scan : scans) {
        if (!drawable(scan)) continue;
        const fvec3 half = half_of(scan);
        SeenScan its{.scan = &scan, .bounds = placed({fvec3(0), glm::length(half)}, scan.model)};
        if (!within(planes, its.bounds) ||
            is_hidden(sight.hidden, its.bounds.centre, fvec3(its.bounds.radius)))
            continue;
        its.to_samples = glm::scale(fmat4(1), 1.0F / scan.spacing) * glm::translate(fmat4(1), half) *
                         glm::inverse(scan.model);
        its.part = screen_part(-half, half, sight.to_clip * scan.model, {0, 0, width, height});
        if (its.part.width > 0 && its.part.height > 0) seen.push_back(its);
    }
    std::stable_sort(seen.begin(), seen.end(), [&](const SeenScan& a, const SeenScan& b) {
        return glm::distance(a.bounds.centre, sight.eye) > glm::distance(b.bounds.centre, sight.eye);
    });
    return seen;
}

SceneHashes hash_scene(const Batches& batches, std::size_t first, std::size_t count, const MeshStates& meshes,
                       std::span<const SeenScan> scans) {
    SceneHashes out;
    for (std::size_t b = first; b < first + count; ++b) {
        const auto& batch = batches.batches[b];
        for (std::size_t i = batch.first; i < batch.first + batch.count; ++i) {
            const auto& model = batches.instances[i].model;
            const auto hash = hash_combine(hash_value(model, batch.mesh), meshes.revisions[batch.mesh]);
            out.all = hash_combine(out.all, hash);
            const auto there = placed(meshes.bounds[batch.mesh], model);
            const bool near = std::any_of(scans.begin(), scans.end(), [&](const SeenScan& its) {
                return glm::distance(there.centre, its.bounds.centre) < there.radius + its.bounds.radius;
            });
            if (near) out.near = hash_combine(out.near, hash);
        }
    }
    return out;
}

Expected<Scans::MarchProgram> Scans::load_march(const std::filesystem::path& shaders, const char* file,
                                                const std::vector<std::string_view>& variant) {
    auto program = load_program({shaders / "scan.vert", shaders / file, shaders / "scan.glsl",
                                 shaders / "light.glsl", shaders / "tone.glsl"},
                                variant);
    if (!program) return program.error();
    MarchProgram out{.view = mesh_program(std::move(*program))};
    const auto named = [&](const char* name) { return uniform(out.view.program, name); };
    out.forward = named("forward");
    out.right = named("right");
    out.up = named("up");
    out.to_samples = named("to_samples");
    out.to_opaque = named("to_opaque");
    out.depth_range = named("depth_range");
    out.start = named("start");
    out.last = named("last");
    out.spacing = named("spacing");
    out.nearest = named("nearest");
    out.leaps = named("leaps");
    out.step_length = named("step_length");
    out.level = named("level");
    out.colour = named("colour");
    out.painted = named("painted");
    out.behind_things = named("behind_things");
    out.sun = named("sun");
    out.linear = named("linear");
    set_samplers(out.view.program);
    return out;
}

Expected<Scans::ShowProgram> Scans::load_show(const std::filesystem::path& shaders, bool solid) {
    std::vector<std::string_view> variant;
    if (solid) variant.emplace_back("SOLID");
    auto program = load_program({shaders / "screen.vert", shaders / "scan_show.frag"}, variant);
    if (!program) return program.error();
    ShowProgram out{.program = std::move(*program)};
    const auto named = [&](const char* name) { return uniform(out.program, name); };
    out.to_picture = named("to_picture");
    out.inside = named("inside");
    out.corner = named("corner");
    out.to_opaque = named("to_opaque");
    out.depth_range = named("depth_range");
    set_samplers(out.program);
    return out;
}

Expected<Scans> Scans::load(const std::filesystem::path& shaders) {
    Scans out;
    glGetIntegerv(GL_MAX_3D_TEXTURE_SIZE, &out.max_samples_);
    auto surface = load_march(shaders, "scan_surface.frag", {});
    if (!surface) return surface.error();
    out.surface_ = std::move(*surface);
    for (std::size_t lit = 0; lit < 2; ++lit) {
        for (std::size_t painted = 0; painted < 2; ++painted) {
            std::vector<std::string_view> variant;
            if (lit == 1) variant.emplace_back("LIT");
            if (painted == 1) variant.emplace_back("PAINTED");
            auto light = load_march(shaders, "scan_light.frag", variant);
            if (!light) return light.error();
            out.light_.at(lit).at(painted) = std::move(*light);
        }
    }
    for (auto* show : {&out.show_solid_, &out.show_light_}) {
        auto loaded = load_show(shaders, show == &out.show_solid_);
        if (!loaded) return loaded.error();
        *show = std::move(*loaded);
    }
    return out;
}

ScanId Scans::make() {
    all_.push_back(make_gpu_scan());
    return static_cast<ScanId>(all_.size() - 1);
}

ScanCounts Scans::draw(const ScanView& view, std::span<const SeenScan> seen,
                       const VertexArray& no_attributes) {
    if (targets_.size() <= view.number) targets_.resize(view.number + 1);
    Drawing drawing{.view = view, .targets = targets_[view.number], .no_attributes = no_attributes};
    std::vector<SeenScan> shown;
    for (const auto& its : seen) {
        THAUM_ASSERT(its.scan->id < all_.size(), "a scan that was never made");
        if (*std::ranges::max_element(its.scan->count) > max_samples_) continue;
        drawing.counts.bricks_sent += send(*its.scan, all_[its.scan->id], scratch_);
        if (!all_[its.scan->id].shows) continue;
        shown.push_back(its);
        drawing.part = joined(drawing.part, its.part);
    }
    drawing.counts.drawn = shown.size();
    if (shown.empty()) return drawing.counts;
    auto& targets = drawing.targets;
    const auto scans = hash_scans(view, shown);
    const auto near = hash_combine(scans, view.scene.near);
    const auto all = hash_combine(hash_combine(scans, view.scene.all), hash_light(*view.view));
    const auto detail = view.view->scan_detail;
    const bool sharp =
        detail == ScanDetail::sharp || (detail == ScanDetail::automatic && near == targets.near);
    const bool again = all == targets.all && sharp == targets.sharp;
    drawing.share = sharp ? 1 : share_of(view.quality);
    targets.near = near;
    targets.all = all;
    targets.sharp = sharp;
    draw_look(drawing, shown, ScanLook::surface, again);
    draw_look(drawing, shown, ScanLook::translucent, again);
    return drawing.counts;
}

/// Draws all scans (volumes of samples) of one kind, surfaces or translucent ones. If `again` is true,
/// nothing has changed since their last picture, which the target still holds: it is shown once more.
void Scans::draw_look(Drawing& drawing, std::span<const SeenScan> seen, ScanLook look, bool again) {
    const bool solid = look == ScanLook::surface;
    if (std::none_of(seen.begin(), seen.end(), [&](const SeenScan& its) { return its.scan->look == look; }))
        return;
    auto& target = solid ? drawing.targets.solid : drawing.targets.light;
    // Drawing scans needs the depth of the scene. So does showing a kept quick picture (one with fewer rays
    // than pixels), which compares the depth at each pixel of the view with that at the larger pixels.
    if (!again || drawing.share > 1) copy_depth(drawing);
    if (!again) {
        clear(drawing, target, solid);
        for (const auto& its : seen)
            if (its.scan->look == look) march(drawing, its, target);
    }
    show(drawing, target, solid);
}

/// Copies the depth of the view's scene, where scans may cover it.
void Scans::copy_depth(const Drawing& drawing) {
    auto& targets = drawing.targets;
    const auto& at = drawing.view.at;
    if (targets.width != at.width || targets.height != at.height) {
        targets.opaque = make_texture();
        targets.width = at.width;
        targets.height = at.height;
        allocate_depth(targets.opaque, at.width, at.height);
    }
    const auto& part = drawing.part;
    glBindFramebuffer(GL_READ_FRAMEBUFFER, drawing.view.framebuffer);
    glBindTexture(GL_TEXTURE_2D, targets.opaque.get());
    glCopyTexSubImage2D(GL_TEXTURE_2D, 0, part.x, part.y, at.x + part.x, at.y + part.y, part.width,
                        part.height);
}

void Scans::clear(const Drawing& drawing, DrawnTarget& target, bool with_depth) {
    const auto& at = drawing.view.at;
    const GLint format = drawing.view.quality == Quality::high ? GL_RGBA16F : GL_RGBA8;
    const int width = (at.width + drawing.share - 1) / drawing.share,
              height = (at.height + drawing.share - 1) / drawing.share;
    if (target.width != width || target.height != height || target.format != format) {
        target = {make_framebuffer(), make_texture(), make_texture(), width, height, format};
        glBindTexture(GL_TEXTURE_2D, target.colour.get());
        glTexImage2D(GL_TEXTURE_2D, 0, format, width, height, 0, GL_RGBA,
                     format == GL_RGBA16F ? GL_HALF_FLOAT : GL_UNSIGNED_BYTE, nullptr);
        for (const GLenum name : {GLenum{GL_TEXTURE_MIN_FILTER}, GLenum{GL_TEXTURE_MAG_FILTER}})
            glTexParameteri(GL_TEXTURE_2D, name, GL_NEAREST);
        glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer.get());
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, target.colour.get(), 0);
        if (with_depth) {
            allocate_depth(target.depth, width, height);
            glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, target.depth.get(), 0);
        }
    }
    glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer.get());
    glViewport(0, 0, width, height);
    // Two pixels more on each side, since the view interpolates between the pixels of the target.
    const auto part = shared(drawing.part, drawing.share, 2, width, height);
    glEnable(GL_SCISSOR_TEST);
    glScissor(part.x, part.y, part.width, part.height);
    glClearColor(0, 0, 0, 0);
    glDepthMask(GL_TRUE);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glDisable(GL_SCISSOR_TEST);
}

/// Runs the program at each pixel of a rectangle. A solid scan tests and writes depth; others are blended.
void Scans::fill(Drawing& drawing, const Rect& part, bool solid, GLenum depth_test) {
    glEnable(GL_SCISSOR_TEST);
    glScissor(part.x, part.y, part.width, part.height);
    glDisable(GL_CULL_FACE);
    if (solid) {
        glEnable(GL_DEPTH_TEST);
        glDepthFunc(depth_test);
        glDepthMask(GL_TRUE);
        glDisable(GL_BLEND);
    } else {
        glDisable(GL_DEPTH_TEST);
        glEnable(GL_BLEND);
        glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    }
    glBindVertexArray(drawing.no_attributes.get());
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glDisable(GL_SCISSOR_TEST);
    ++drawing.counts.draws;
}

void Scans::march(Drawing& drawing, const SeenScan& its, DrawnTarget& target) {
    const auto& scan = *its.scan;
    const auto& gpu = all_[scan.id];
    const bool solid = scan.look == ScanLook::surface;
    const auto& program = solid ? surface_ : light_.at(scan.lit ? 1 : 0).at(gpu.painted ? 1 : 0);
    use_mesh_program(program.view, *drawing.view.view, *drawing.view.sight, drawing.view.quality, {});
    set_scan(program, drawing, its, target);
    bind(density_unit, GL_TEXTURE_3D, gpu.density);
    bind(bricks_unit, GL_TEXTURE_3D, gpu.bricks);
    bind(paint_unit, GL_TEXTURE_3D, gpu.paint);
    bind(table_unit, GL_TEXTURE_1D, gpu.table);
    bind(materials_unit, GL_TEXTURE_1D, gpu.materials);
    bind(scene_depth_unit, GL_TEXTURE_2D, drawing.targets.opaque);
    const auto part = shared(its.part, drawing.share, 1, target.width, target.height);
    fill(drawing, part, solid, GL_LESS);
    ++drawing.counts.marched;
}

void Scans::set_scan(const MarchProgram& p, const Drawing& drawing, const SeenScan& its,
                     const DrawnTarget& target) const {
    const auto& scan = *its.scan;
    const auto& camera = drawing.view.view->camera;
    const auto& viewport = drawing.view.view->viewport;
    const auto& at = drawing.view.at;
    const float high = std::tan(camera.fov_y / 2);
    const float aspect = static_cast<float>(viewport.width) / static_cast<float>(viewport.height);
    put(p.forward, camera.orientation * fvec3(0, 0, -1));
    put(p.right, camera.orientation * fvec3(high * aspect, 0, 0));
    put(p.up, camera.orientation * fvec3(0, high, 0));
    const glm::mat3 turn(its.to_samples);
    glUniformMatrix3fv(p.to_samples, 1, GL_FALSE, &turn[0][0]);
    glUniform4f(p.to_opaque, static_cast<float>(at.width) / static_cast<float>(target.width),
                static_cast<float>(at.height) / static_cast<float>(target.height), 0, 0);
    const float nearest = 1 / camera.near_plane, farthest = 1 / camera.far_plane;
    glUniform2f(p.depth_range, nearest, nearest - farthest);
    put(p.start, fvec3(its.to_samples * fvec4(camera.position, 1)));
    put(p.last, fvec3(static_cast<float>(scan.count[0] - 1), static_cast<float>(scan.count[1] - 1),
                      static_cast<float>(scan.count[2] - 1)));
    put(p.spacing, scan.spacing);
    glUniform1f(p.nearest, camera.near_plane);
    glUniform1f(p.leaps, scan.leaps ? 1 : 0);
    glUniform1f(p.step_length, drawing.share > 1 ? 2 * scan.step : scan.step);
    glUniform1f(p.level, scan.level);
    put(p.colour, scan.colour);
    glUniform1i(p.painted, all_[scan.id].painted ? 1 : 0);
    // With fewer rays than pixels, rays go on behind objects. If they ended there, the edge of an object in
    // front would leave a seam of missing pixels.
    glUniform1i(p.behind_things, drawing.share == 1 ? 1 : 0);
    glUniform1f(p.sun, scan.sun);
    glUniform1i(p.linear, drawing.view.quality == Quality::high ? 1 : 0);
}

/// Draws the picture of the scans, which a target holds, over the view.
void Scans::show(Drawing& drawing, const DrawnTarget& target, bool solid) const {
    const auto& p = solid ? show_solid_ : show_light_;
    const auto& at = drawing.view.at;
    const auto& camera = drawing.view.view->camera;
    const fvec2 size(static_cast<float>(target.width), static_cast<float>(target.height)),
        whole(static_cast<float>(at.width), static_cast<float>(at.height));
    glBindFramebuffer(GL_FRAMEBUFFER, drawing.view.framebuffer);
    glViewport(at.x, at.y, at.width, at.height);
    glUseProgram(p.program.get());
    glUniform4f(p.to_picture, size.x / whole.x, size.y / whole.y, 0, 0);
    glUniform4f(p.to_opaque, whole.x / size.x, whole.y / size.y, 0, 0);
    glUniform4i(p.inside, 0, 0, target.width - 1, target.height - 1);
    glUniform2f(p.corner, static_cast<float>(at.x), static_cast<float>(at.y));
    const float nearest = 1 / camera.near_plane, farthest = 1 / camera.far_plane;
    glUniform2f(p.depth_range, nearest, nearest - farthest);
    bind(picture_unit, GL_TEXTURE_2D, target.colour);
    bind(solid ? drawn_depth_unit : scene_depth_unit, GL_TEXTURE_2D,
         solid ? target.depth : drawing.targets.opaque);
    const auto& part = drawing.part;
    fill(drawing, {at.x + part.x, at.y + part.y, part.width, part.height}, solid, GL_LEQUAL);
}

}  // namespace thaum::render::detail

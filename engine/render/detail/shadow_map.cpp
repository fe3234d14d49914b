#include "render/detail/shadow_map.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "core/assert.h"
#include "core/hash.h"

namespace thaum::render::detail {
namespace {

constexpr GLsizei side = 2048;  // side of the shadow map (texels)

Texture make_depth_texture() {
    Texture texture = make_texture();
    glBindTexture(GL_TEXTURE_2D, texture.get());
    glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, side, side, 0, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT,
                 nullptr);
    // Linear filtering compares and blends four texels in one access.
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
    // Outside the shadow map everything is in the sun: the texels at its edge stay clear (prepare_drawing). A
    // software rasteriser takes longer with GL_CLAMP_TO_BORDER.
    for (const GLenum wrap : {GLenum{GL_TEXTURE_WRAP_S}, GLenum{GL_TEXTURE_WRAP_T}})
        glTexParameteri(GL_TEXTURE_2D, wrap, GL_CLAMP_TO_EDGE);
    return texture;
}

Framebuffer make_depth_target(const Texture& texture) {
    Framebuffer target = make_framebuffer();
    glBindFramebuffer(GL_FRAMEBUFFER, target.get());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, texture.get(), 0);
    glDrawBuffer(GL_NONE);
    glReadBuffer(GL_NONE);
    THAUM_ASSERT(glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE, "no shadow map");
    return target;
}

/// Rotates the world to axes with the sun at +z.
glm::mat3 sun_axes(fvec3 towards_sun) {
    const fvec3 z = glm::normalize(towards_sun);
    const fvec3 other = std::abs(z.y) < 0.99F ? fvec3(0, 1, 0) : fvec3(1, 0, 0);
    const fvec3 x = glm::normalize(glm::cross(other, z));
    return glm::transpose(glm::mat3(x, glm::cross(z, x), z));
}

std::uint64_t key_of(std::span<const Instance> fixed, fvec3 towards_sun,
                     std::span<const std::uint64_t> revisions) {
    std::uint64_t key = hash_value(towards_sun);
    for (const auto& i : fixed) {
        const std::uint64_t revision = i.mesh < revisions.size() ? revisions[i.mesh] : 0;
        key = hash_combine(hash_combine(key, revision), hash_value(i.model, i.mesh));
    }
    return key;
}

bool same_place(const Instance& a, const Instance& b) { return a.mesh == b.mesh && a.model == b.model; }

/// Sets the OpenGL state for drawing shadow casters. finish_drawing() restores what other code expects.
void prepare_drawing() {
    glViewport(0, 0, side, side);
    glEnable(GL_SCISSOR_TEST);
    glScissor(1, 1, side - 2, side - 2);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
    // Walls have no outer faces and no mesh has holes, so both sides of a triangle cast a shadow.
    glDisable(GL_CULL_FACE);
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(1.5F, 4);
    // Objects between the sun and the map's near plane cast shadows too.
    glEnable(GL_DEPTH_CLAMP);
}

void finish_drawing() {
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_DEPTH_CLAMP);
    glDisable(GL_POLYGON_OFFSET_FILL);
}

/// Clears the whole map, with its edge.
void clear_all() {
    glDisable(GL_SCISSOR_TEST);
    glClear(GL_DEPTH_BUFFER_BIT);
    glEnable(GL_SCISSOR_TEST);
}

void copy_depth(GLint x0, GLint y0, GLint x1, GLint y1) {
    glBlitFramebuffer(x0, y0, x1, y1, x0, y0, x1, y1, GL_DEPTH_BUFFER_BIT, GL_NEAREST);
}

}  // namespace

void ShadowMap::make_targets() {
    fixed_ = make_depth_texture();
    all_ = make_depth_texture();
    fixed_target_ = make_depth_target(fixed_);
    all_target_ = make_depth_target(all_);
    instances_ = make_buffer();
    made_ = true;
}

void ShadowMap::fit(const Casters& casters, fvec3 towards_sun, std::span<const Bounds> mesh_bounds) {
    const auto axes = sun_axes(towards_sun);
    fvec3 low(1e9F), high(-1e9F);
    for (const auto& i : casters.fixed) {
        if (!finite(i.model)) continue;
        const auto there = placed(mesh_bounds[i.mesh], i.model);
        const fvec3 centre = axes * there.centre;
        low = glm::min(low, centre - there.radius);
        high = glm::max(high, centre + there.radius);
    }
    if (low.x > high.x) low = fvec3(-1), high = fvec3(1);
    texel_m_ = std::max(high.x - low.x, high.y - low.y) / static_cast<float>(side);
    to_clip_ = glm::ortho(low.x, high.x, low.y, high.y, -high.z, -low.z) * fmat4(axes);
}

ShadowMap::Counts ShadowMap::draw(std::span<const Instance> instances, std::span<const GpuMesh> meshes,
                                  std::span<const Bounds> mesh_bounds, const SmallProgram& program) {
    batches_.clear();
    Counts counts;
    counts.draws = collect(instances, {mesh_bounds}, {.to_clip = to_clip_}, batches_);
    fill_buffer(GL_ARRAY_BUFFER, instances_, batches_.instances, GL_STREAM_DRAW);
    glUseProgram(program.program.get());
    glUniformMatrix4fv(program.parameter, 1, GL_FALSE, &to_clip_[0][0]);
    for (const auto& batch : batches_.batches) {
        counts.triangles += draw_batch(meshes[batch.mesh], batch, instances_);
    }
    return counts;
}

ShadowMap::Print ShadowMap::print_of(const Bounds& there) const {
    const fvec3 at = fvec3(to_clip_ * fvec4(there.centre, 1));
    // The rows of the matrix tell how far one metre along each axis of the shadow map is in clip space.
    const auto reach = [&](int row) {
        const fvec3 per_m(to_clip_[0][row], to_clip_[1][row], to_clip_[2][row]);
        return there.radius * glm::length(per_m);
    };
    const auto texel = [](float clip) {
        return static_cast<GLint>(std::lround((0.5F + 0.5F * std::clamp(clip, -1.0F, 1.0F)) * float(side)));
    };
    const auto within = [](GLint v) { return std::clamp(v, 0, GLint{side}); };
    return {within(texel(at.x - reach(0)) - 2), within(texel(at.y - reach(1)) - 2),
            within(texel(at.x + reach(0)) + 2), within(texel(at.y + reach(1)) + 2)};
}

void ShadowMap::find_changes(std::span<const Instance> moving, std::span<const Bounds> mesh_bounds) {
    left_.clear();
    drawn_.clear();
    new_prints_.clear();
    const auto stays = [&](std::size_t i) { return i < moving_.size() && same_place(moving[i], moving_[i]); };
    for (std::size_t i = 0; i < moving.size(); ++i)
        new_prints_.push_back(finite(moving[i].model)
                                  ? print_of(placed(mesh_bounds[moving[i].mesh], moving[i].model))
                                  : Print{});
    for (std::size_t i = 0; i < moving_.size(); ++i) {
        if (i >= moving.size() || !stays(i)) left_.push_back(prints_[i]);
    }
    for (std::size_t i = 0; i < moving.size(); ++i) {
        const bool erased = std::any_of(left_.begin(), left_.end(),
                                        [&](const Print& p) { return overlap(p, new_prints_[i]); });
        if (erased || !stays(i)) drawn_.push_back(moving[i]);
    }
}

ShadowMap::Counts ShadowMap::update(const Casters& casters, fvec3 towards_sun,
                                    std::span<const GpuMesh> meshes, std::span<const Bounds> mesh_bounds,
                                    std::span<const std::uint64_t> revisions, const SmallProgram& program) {
    if (!made_) make_targets();
    const auto key = key_of(casters.fixed, towards_sun, revisions);
    const bool anew = key != fixed_key_;
    if (anew) {
        fit(casters, towards_sun, mesh_bounds);
        moving_.clear();
    }
    find_changes(casters.moving, mesh_bounds);
    if (!anew && left_.empty() && drawn_.empty()) return {};
    prepare_drawing();
    Counts counts;
    if (anew) {
        glBindFramebuffer(GL_FRAMEBUFFER, all_target_.get());
        clear_all();
        glBindFramebuffer(GL_FRAMEBUFFER, fixed_target_.get());
        clear_all();
        counts = draw(casters.fixed, meshes, mesh_bounds, program);
        left_.assign(1, {0, 0, side, side});
        fixed_key_ = key;
    }
    glBindFramebuffer(GL_READ_FRAMEBUFFER, fixed_target_.get());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, all_target_.get());
    for (const auto& p : left_) copy_depth(p.x0, p.y0, p.x1, p.y1);
    glBindFramebuffer(GL_FRAMEBUFFER, all_target_.get());
    const auto moving = draw(drawn_, meshes, mesh_bounds, program);
    moving_.assign(casters.moving.begin(), casters.moving.end());
    std::swap(prints_, new_prints_);
    finish_drawing();
    return {counts.draws + moving.draws, counts.triangles + moving.triangles};
}

ShadowView ShadowMap::bind() const {
    glActiveTexture(GL_TEXTURE0 + shadow_unit);
    glBindTexture(GL_TEXTURE_2D, all_.get());
    glActiveTexture(GL_TEXTURE0);
    const fmat4 to_unit = glm::translate(fmat4(1), fvec3(0.5F)) * glm::scale(fmat4(1), fvec3(0.5F));
    return {to_unit * to_clip_, 1.5F * texel_m_, 1 / float(side)};
}

}  // namespace thaum::render::detail

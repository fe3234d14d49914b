#include "render/detail/targets.h"

#include <algorithm>

#include "core/assert.h"
#include "core/text.h"

namespace thaum::render::detail {
namespace {

constexpr int bloom_share = 4;  // width and height of the bloom are 1 / bloom_share of the picture's
constexpr float bloom_strength = 0.55F;

void bind(GLint unit, const Texture& texture) {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glBindTexture(GL_TEXTURE_2D, texture.get());
    glActiveTexture(GL_TEXTURE0);
}

/// Sets the filter (interpolation between texels) of the texture in the active texture unit.
void filter_bound(GLint how) {
    for (const GLenum filter : {GLenum{GL_TEXTURE_MIN_FILTER}, GLenum{GL_TEXTURE_MAG_FILTER}})
        glTexParameteri(GL_TEXTURE_2D, filter, how);
}

/// Sets the filter (interpolation between texels) of the drawn picture, a texture that programs read.
void filter_picture(GLint how) {
    glActiveTexture(GL_TEXTURE0 + picture_unit);
    filter_bound(how);
    glActiveTexture(GL_TEXTURE0);
}

void fill(const Target& target) {
    glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer.get());
    glViewport(0, 0, target.width, target.height);
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

/// Blurs along one axis, from texture to target.
void blur(const SmallProgram& program, const Texture& from, const Target& to, fvec2 way) {
    glUseProgram(program.program.get());
    glUniform2f(program.parameter, way.x, way.y);
    bind(picture_unit, from);
    fill(to);
}

/// Sets the part of the picture that the view covers, in texture coordinates, `inset` texels from its edges.
void set_part(const SmallProgram& program, const Target& light, const Rect& drawn, float inset = 0) {
    const fvec2 size(static_cast<float>(light.width), static_cast<float>(light.height));
    glUniform4f(program.part, (static_cast<float>(drawn.x) + inset) / size.x,
                (static_cast<float>(drawn.y) + inset) / size.y,
                (static_cast<float>(drawn.width) - 2 * inset) / size.x,
                (static_cast<float>(drawn.height) - 2 * inset) / size.y);
}

/// Returns true if a pixel of the view is one of the window.
bool are_alike(const ViewPlace& view) {
    return view.drawn.width == view.shown.width && view.drawn.height == view.shown.height;
}

void make_bloom(const Target& light, const Rect& drawn, Bloom& bloom, const Programs& programs) {
    const int width = std::max(1, drawn.width / bloom_share),
              height = std::max(1, drawn.height / bloom_share);
    resize(bloom.bright, GL_RGBA16F, false, width, height);
    resize(bloom.blurred, GL_RGBA16F, false, width, height);
    glUseProgram(programs.bright.program.get());
    set_part(programs.bright, light, drawn);
    glUniform2f(programs.bright.parameter, 1 / static_cast<float>(light.width),
                1 / static_cast<float>(light.height));
    bind(picture_unit, light.colour);
    fill(bloom.bright);
    blur(programs.blur, bloom.bright.colour, bloom.blurred, {1 / static_cast<float>(width), 0});
    blur(programs.blur, bloom.blurred.colour, bloom.bright, {0, 1 / static_cast<float>(height)});
}

}  // namespace

void resize(Target& target, GLint format, bool with_depth, int width, int height) {
    if (target.width == width && target.height == height) return;
    target = {make_framebuffer(), make_texture(), make_renderbuffer(), width, height};
    glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer.get());
    glBindTexture(GL_TEXTURE_2D, target.colour.get());
    if (format == GL_RGBA16F)
        glTexImage2D(GL_TEXTURE_2D, 0, format, width, height, 0, GL_RGBA, GL_HALF_FLOAT, nullptr);
    else  // a software rasteriser copies and stretches pictures of this layout fastest
        glTexImage2D(GL_TEXTURE_2D, 0, format, width, height, 0, GL_BGRA, GL_UNSIGNED_INT_8_8_8_8_REV,
                     nullptr);
    filter_bound(GL_LINEAR);
    for (const GLenum wrap : {GLenum{GL_TEXTURE_WRAP_S}, GLenum{GL_TEXTURE_WRAP_T}})
        glTexParameteri(GL_TEXTURE_2D, wrap, GL_CLAMP_TO_EDGE);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, target.colour.get(), 0);
    if (with_depth) {
        glBindRenderbuffer(GL_RENDERBUFFER, target.depth.get());
        // A software rasteriser computes with floats, so it converts nothing here.
        glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT32F, width, height);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, target.depth.get());
    }
    THAUM_ASSERT(glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE,
                 text("no framebuffer of ", width, " x ", height));
}

std::size_t show(const Target& pixels, const ViewPlace& view, const SmallProgram& program,
                 const VertexArray& no_attributes) {
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    glDisable(GL_BLEND);
    glBindVertexArray(no_attributes.get());
    glViewport(view.shown.x, view.shown.y, view.shown.width, view.shown.height);
    glUseProgram(program.program.get());
    // A stretched pixel is a mean of texels. Half a texel from the edge they still belong to this view.
    set_part(program, pixels, view.drawn, are_alike(view) ? 0 : 0.5F);
    bind(picture_unit, pixels.colour);
    glDrawArrays(GL_TRIANGLES, 0, 6);
    return 1;
}

std::size_t compose(const Target& light, const ViewPlace& view, Bloom* bloom, const Programs& programs,
                    const VertexArray& no_attributes) {
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    glDisable(GL_BLEND);
    glBindVertexArray(no_attributes.get());
    if (bloom != nullptr) make_bloom(light, view.drawn, *bloom, programs);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glViewport(view.shown.x, view.shown.y, view.shown.width, view.shown.height);
    glUseProgram(programs.compose.program.get());
    set_part(programs.compose, light, view.drawn);
    glUniform1f(programs.compose.parameter, bloom != nullptr ? bloom_strength : 0);
    bind(picture_unit, light.colour);
    // Where a pixel of the view is one of the window, each needs one texel instead of a mean of four.
    filter_picture(are_alike(view) ? GL_NEAREST : GL_LINEAR);
    // Without bloom the program multiplies this texture by 0, but some texture must be bound.
    bind(bloom_unit, bloom != nullptr ? bloom->bright.colour : light.colour);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    filter_picture(GL_LINEAR);
    return bloom != nullptr ? 4 : 1;
}

}  // namespace thaum::render::detail

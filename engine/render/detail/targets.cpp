#include "render/detail/targets.h"

#include <algorithm>

#include "core/assert.h"
#include "core/text.h"

namespace thaum::render::detail {
namespace {

constexpr int bloom_share = 4;  // of the picture's width and height
constexpr float bloom_strength = 0.55F;

void bind(GLint unit, const Texture& texture) {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glBindTexture(GL_TEXTURE_2D, texture.get());
    glActiveTexture(GL_TEXTURE0);
}

void fill(const Target& target) {
    glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer.get());
    glViewport(0, 0, target.width, target.height);
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

/// One way of the blur, from texture to target.
void blur(const SmallProgram& program, const Texture& from, const Target& to, fvec2 way) {
    glUseProgram(program.program.get());
    glUniform2f(program.parameter, way.x, way.y);
    bind(picture_unit, from);
    fill(to);
}

void make_bloom(const Target& light, Bloom& bloom, const Programs& programs) {
    const int width = std::max(1, light.width / bloom_share),
              height = std::max(1, light.height / bloom_share);
    resize(bloom.bright, GL_RGBA16F, false, width, height);
    resize(bloom.blurred, GL_RGBA16F, false, width, height);
    glUseProgram(programs.bright.program.get());
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
    glTexImage2D(GL_TEXTURE_2D, 0, format, width, height, 0, GL_RGBA,
                 format == GL_RGBA16F ? GL_HALF_FLOAT : GL_UNSIGNED_BYTE, nullptr);
    for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
        glTexParameteri(GL_TEXTURE_2D, filter, GL_LINEAR);
    for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
        glTexParameteri(GL_TEXTURE_2D, wrap, GL_CLAMP_TO_EDGE);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, target.colour.get(), 0);
    if (with_depth) {
        glBindRenderbuffer(GL_RENDERBUFFER, target.depth.get());
        glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, width, height);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, target.depth.get());
    }
    THAUM_ASSERT(glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE,
                 text("no framebuffer of ", width, " x ", height));
}

std::size_t compose(const Target& light, Bloom& bloom, const Programs& programs, bool with_bloom,
                    const VertexArray& no_attributes, int width, int height) {
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    glDisable(GL_BLEND);
    glBindVertexArray(no_attributes.get());
    if (with_bloom) make_bloom(light, bloom, programs);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glViewport(0, 0, width, height);
    glUseProgram(programs.compose.program.get());
    glUniform1f(programs.compose.parameter, with_bloom ? bloom_strength : 0);
    bind(picture_unit, light.colour);
    // Without bloom it is multiplied by 0, but something must be there.
    bind(bloom_unit, with_bloom ? bloom.bright.colour : light.colour);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    return with_bloom ? 4 : 1;
}

}  // namespace thaum::render::detail

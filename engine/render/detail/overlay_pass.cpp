#include "render/detail/overlay_pass.h"

#include <algorithm>

#include "render/detail/gpu_mesh.h"

namespace thaum::render::detail {

OverlayPass::OverlayPass(Font font)
    : font_(std::move(font)), array_(make_vertex_array()), vertices_(make_buffer()), texels_(make_texture()) {
    glBindVertexArray(array_.get());
    glBindBuffer(GL_ARRAY_BUFFER, vertices_.get());
    attribute(0, 2, sizeof(OverlayVertex), offsetof(OverlayVertex, position));
    attribute(1, 2, sizeof(OverlayVertex), offsetof(OverlayVertex, texel));
    glEnableVertexAttribArray(2);
    glVertexAttribPointer(2, 4, GL_UNSIGNED_BYTE, GL_TRUE, sizeof(OverlayVertex),
                          reinterpret_cast<const void*>(offsetof(OverlayVertex, colour)));
    glBindTexture(GL_TEXTURE_2D, texels_.get());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

Expected<OverlayPass> OverlayPass::make() {
    auto font = Font::load();
    if (!font) return font.error();
    return OverlayPass(std::move(*font));
}

void OverlayPass::send_atlas() {
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, texels_.get());
    if (!atlas_.take_changed()) return;
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    if (texels_height_ != atlas_.height()) {
        texels_height_ = atlas_.height();
        glTexImage2D(GL_TEXTURE_2D, 0, GL_R8, Atlas::width, texels_height_, 0, GL_RED, GL_UNSIGNED_BYTE,
                     atlas_.texels().data());
    } else {
        glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, Atlas::width, texels_height_, GL_RED, GL_UNSIGNED_BYTE,
                        atlas_.texels().data());
    }
}

/// Draws the overlay's items in their order: a run of text, a run of other shapes, and so on.
std::size_t OverlayPass::draw_runs(const Programs& programs) const {
    std::size_t draws = 0;
    const auto is_text = [&](const OverlayVertex& v) { return v.texel != atlas_.solid(); };
    for (auto first = built_.begin(); first != built_.end();) {
        const bool text = is_text(*first);
        const auto last =
            std::find_if(first, built_.end(), [&](const OverlayVertex& v) { return is_text(v) != text; });
        glUseProgram((text ? programs.overlay : programs.shape).program.get());
        glDrawArrays(GL_TRIANGLES, static_cast<GLint>(first - built_.begin()),
                     static_cast<GLsizei>(last - first));
        ++draws;
        first = last;
    }
    return draws;
}

std::size_t OverlayPass::draw(const Frame& frame, const Programs& programs) {
    built_.clear();
    atlas_.start_frame();
    build(frame.overlay, font_, atlas_, built_);
    if (built_.empty()) return 0;
    send_atlas();
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glViewport(0, 0, frame.width, frame.height);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    for (const auto* program : {&programs.overlay, &programs.shape}) {
        glUseProgram(program->program.get());
        glUniform2f(program->parameter, 2 / static_cast<float>(frame.width),
                    2 / static_cast<float>(frame.height));
    }
    glBindVertexArray(array_.get());
    fill_buffer(GL_ARRAY_BUFFER, vertices_, built_, GL_STREAM_DRAW);
    return draw_runs(programs);
}

}  // namespace thaum::render::detail

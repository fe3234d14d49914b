// Classes that own OpenGL objects and delete them. The context in which an object was made must be current
// when it is deleted.
#pragma once
#include <epoxy/gl.h>

#include <utility>

namespace thaum::render::detail {

/// Owns one OpenGL object by its name. `Free` is the glDelete... function for one object.
template <auto Free>
class GlName {
public:
    GlName() = default;
    explicit GlName(GLuint name) : name_(name) {}
    GlName(GlName&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
    GlName& operator=(GlName&& other) noexcept {
        std::swap(name_, other.name_);
        return *this;
    }
    ~GlName() {
        if (name_ != 0) Free(name_);
    }
    GLuint get() const { return name_; }

private:
    GLuint name_{};
};

// Functions that delete one object. They are needed because epoxy's own are pointers, which cannot be
// template arguments.
inline void free_buffer(GLuint n) { glDeleteBuffers(1, &n); }
inline void free_vertex_array(GLuint n) { glDeleteVertexArrays(1, &n); }
inline void free_texture(GLuint n) { glDeleteTextures(1, &n); }
inline void free_framebuffer(GLuint n) { glDeleteFramebuffers(1, &n); }
inline void free_renderbuffer(GLuint n) { glDeleteRenderbuffers(1, &n); }
inline void free_shader(GLuint n) { glDeleteShader(n); }
inline void free_program(GLuint n) { glDeleteProgram(n); }

using Buffer = GlName<free_buffer>;
using VertexArray = GlName<free_vertex_array>;
using Texture = GlName<free_texture>;
using Framebuffer = GlName<free_framebuffer>;
using Renderbuffer = GlName<free_renderbuffer>;
using Shader = GlName<free_shader>;
using Program = GlName<free_program>;

template <class Make>
GLuint made(Make make) {
    GLuint name = 0;
    make(1, &name);
    return name;
}

inline Buffer make_buffer() { return Buffer(made(glGenBuffers)); }
inline VertexArray make_vertex_array() { return VertexArray(made(glGenVertexArrays)); }
inline Texture make_texture() { return Texture(made(glGenTextures)); }
inline Framebuffer make_framebuffer() { return Framebuffer(made(glGenFramebuffers)); }
inline Renderbuffer make_renderbuffer() { return Renderbuffer(made(glGenRenderbuffers)); }

/// Binds a texture to a texture unit.
inline void bind(GLint unit, GLenum target, const Texture& texture) {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glBindTexture(target, texture.get());
    glActiveTexture(GL_TEXTURE0);
}

}  // namespace thaum::render::detail

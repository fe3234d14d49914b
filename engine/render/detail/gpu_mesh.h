// Meshes and instances in OpenGL buffers.
#pragma once
#include <cstddef>
#include <vector>

#include "render/detail/batches.h"
#include "render/detail/gl.h"
#include "render/mesh.h"

namespace thaum::render::detail {

struct GpuMesh {
    VertexArray array;
    Buffer vertices, indices;
    /// Number of indices; for a large mesh in patches, those of all patches in full detail.
    GLsizei index_count{};
};

GpuMesh make_mesh();
void fill_mesh(GpuMesh& mesh, const MeshData& data);

/// Draws all instances (placed copies) of a mesh with one call and returns the number of triangles. The
/// shader program must be in use; `instances` is the buffer with all instances of the frame.
std::size_t draw_batch(const GpuMesh& mesh, const Batch& batch, const Buffer& instances);
/// Draws some patches of a large mesh and returns the number of triangles. The shader program must be in use,
/// and its instance set by set_instance. `indices` is the buffer with the visible patches of the frame.
std::size_t draw_patches(const GpuMesh& mesh, IndexRange which, const Buffer& indices);

/// Declares a float attribute of the bound vertex array, `start` bytes into the bound buffer.
void attribute(GLuint index, GLint floats, std::size_t stride, std::size_t start);

template <class T>
void fill_buffer(GLenum target, const Buffer& buffer, const std::vector<T>& data, GLenum usage) {
    glBindBuffer(target, buffer.get());
    glBufferData(target, static_cast<GLsizeiptr>(data.size() * sizeof(T)), data.data(), usage);
}

}  // namespace thaum::render::detail

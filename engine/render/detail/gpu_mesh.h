// Meshes and instances as OpenGL has them.
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
    GLsizei index_count{};  ///< of a patchwork: of all in full detail
};

GpuMesh make_mesh();
void fill_mesh(GpuMesh& mesh, const MeshData& data);

/// One draw call of a whole mesh; the program is in use, and `instances` holds what the batch counts in. Returns the triangles.
std::size_t draw_batch(const GpuMesh& mesh, const Batch& batch, const Buffer& instances);
/// The same of some patches, for a program that has the instance already; `indices` holds Batches::patch_indices.
std::size_t draw_patches(const GpuMesh& mesh, IndexRange which, const Buffer& indices);

/// A float attribute of the array that is bound, `start` bytes into the buffer that is bound.
void attribute(GLuint index, GLint floats, std::size_t stride, std::size_t start);

template <class T>
void fill_buffer(GLenum target, const Buffer& buffer, const std::vector<T>& data, GLenum usage) {
    glBindBuffer(target, buffer.get());
    glBufferData(target, static_cast<GLsizeiptr>(data.size() * sizeof(T)), data.data(), usage);
}

}  // namespace thaum::render::detail

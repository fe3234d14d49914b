#include "render/detail/gpu_mesh.h"

namespace thaum::render::detail {
namespace {

// Numbers of the vertex attributes in the shaders.
constexpr GLuint at_position = 0, at_normal = 1, at_colour = 2, at_model = 3, at_tint = 7;
constexpr GLuint at_baked = 8, at_detail = 9, at_instance_sun = 10;

const void* offset(std::size_t bytes) { return reinterpret_cast<const void*>(bytes); }

}  // namespace

void attribute(GLuint index, GLint floats, std::size_t stride, std::size_t start) {
    glEnableVertexAttribArray(index);
    glVertexAttribPointer(index, floats, GL_FLOAT, GL_FALSE, static_cast<GLsizei>(stride), offset(start));
}

GpuMesh make_mesh() {
    GpuMesh mesh{make_vertex_array(), make_buffer(), make_buffer(), 0};
    glBindVertexArray(mesh.array.get());
    glBindBuffer(GL_ARRAY_BUFFER, mesh.vertices.get());
    attribute(at_position, 3, sizeof(Vertex), offsetof(Vertex, position));
    attribute(at_normal, 3, sizeof(Vertex), offsetof(Vertex, normal));
    attribute(at_colour, 3, sizeof(Vertex), offsetof(Vertex, colour));
    static_assert(offsetof(Vertex, open) == offsetof(Vertex, lamps) + sizeof(fvec3));
    attribute(at_baked, 4, sizeof(Vertex), offsetof(Vertex, lamps));
    static_assert(offsetof(Vertex, far_away) == offsetof(Vertex, sun) + sizeof(float));
    attribute(at_detail, 2, sizeof(Vertex), offsetof(Vertex, sun));
    for (GLuint i = at_model; i <= at_tint; ++i) glVertexAttribDivisor(i, 1);
    glVertexAttribDivisor(at_instance_sun, 1);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, mesh.indices.get());
    return mesh;
}

void fill_mesh(GpuMesh& mesh, const MeshData& data) {
    glBindVertexArray(mesh.array.get());
    fill_buffer(GL_ARRAY_BUFFER, mesh.vertices, data.vertices, GL_STATIC_DRAW);
    fill_buffer(GL_ELEMENT_ARRAY_BUFFER, mesh.indices, data.indices, GL_STATIC_DRAW);
    mesh.index_count = static_cast<GLsizei>(data.indices.size());
}

namespace {

void use_instances(const GpuMesh& mesh, const Batch& batch, const Buffer& instances) {
    glBindVertexArray(mesh.array.get());
    glBindBuffer(GL_ARRAY_BUFFER, instances.get());
    const auto start = batch.first * sizeof(GpuInstance);
    for (GLuint column = 0; column < 4; ++column) {
        attribute(at_model + column, 4, sizeof(GpuInstance), start + column * sizeof(fvec4));
    }
    attribute(at_tint, 4, sizeof(GpuInstance), start + offsetof(GpuInstance, tint_glow));
    attribute(at_instance_sun, 1, sizeof(GpuInstance), start + offsetof(GpuInstance, sun));
}

}  // namespace

std::size_t draw_batch(const GpuMesh& mesh, const Batch& batch, const Buffer& instances) {
    use_instances(mesh, batch, instances);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, mesh.indices.get());
    glDrawElementsInstanced(GL_TRIANGLES, mesh.index_count, GL_UNSIGNED_INT, nullptr,
                            static_cast<GLsizei>(batch.count));
    return batch.count * static_cast<std::size_t>(mesh.index_count) / 3;
}

std::size_t draw_patches(const GpuMesh& mesh, IndexRange which, const Buffer& indices) {
    glBindVertexArray(mesh.array.get());
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices.get());
    glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(which.count), GL_UNSIGNED_INT,
                   offset(which.first * sizeof(std::uint32_t)));
    return which.count / 3;
}

}  // namespace thaum::render::detail

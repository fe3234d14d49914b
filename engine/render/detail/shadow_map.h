// The sun's shadow map: depth as the sun sees the court. What never moves is drawn once into a map of its own; when
// something that moves has moved, the place it was at is copied back from there, and it is drawn again with those that stood
// in that place as well. A picture in which nothing moved costs nothing.
#pragma once
#include <vector>

#include "render/detail/gpu_mesh.h"
#include "render/detail/shaders.h"

namespace thaum::render::detail {

class ShadowMap {
public:
    struct Counts {
        std::size_t draws{}, triangles{};
    };

    /// Brings the map up to date. `revision` changes whenever a mesh does. Without fixed casters all is in the sun.
    Counts update(const Casters& casters, fvec3 towards_sun, std::span<const GpuMesh> meshes,
                  std::span<const Bounds> mesh_bounds, std::uint64_t revision, const SmallProgram& program);
    /// For the shaders of this quality; the map is bound to shadow_unit.
    ShadowView bind() const;

private:
    /// A rectangle of texels.
    struct Print {
        GLint x0{}, y0{}, x1{}, y1{};
    };
    static bool overlap(const Print& a, const Print& b) {
        return a.x0 < b.x1 && b.x0 < a.x1 && a.y0 < b.y1 && b.y0 < a.y1;
    }
    void make_targets();
    void fit(const Casters& casters, fvec3 towards_sun, std::span<const Bounds> mesh_bounds);
    Counts draw(std::span<const Instance> instances, std::span<const GpuMesh> meshes,
                std::span<const Bounds> mesh_bounds, const SmallProgram& program);
    Print print_of(const Bounds& there) const;
    void find_changes(std::span<const Instance> moving, std::span<const Bounds> mesh_bounds);

    Texture fixed_, all_;
    Framebuffer fixed_target_, all_target_;
    Buffer instances_;
    Batches batches_;
    fmat4 to_clip_{1};
    float texel_m_{};
    std::uint64_t fixed_key_{};
    bool made_ = false;
    std::vector<Instance> moving_;  // as drawn last
    std::vector<Print> prints_;     // where, by the same number

    // Of this picture.
    std::vector<Print> left_;        // places to be copied back
    std::vector<Instance> drawn_;    // what is to be drawn
    std::vector<Print> new_prints_;  // of all that moves
};

}  // namespace thaum::render::detail

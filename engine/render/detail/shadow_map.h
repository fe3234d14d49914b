// The sun's shadow map: the depth of the arena seen from the sun.
//
// Fixed casters (objects that cast a shadow) are drawn once into a map of their own. When a moving caster has
// moved, its old place is copied back from that map. Then this caster and all others in the same place are
// drawn again. If nothing moves, the map costs nothing.
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

    /// Updates the shadow map after casters (objects that cast a shadow) have changed or moved. `revisions`
    /// count the changes of each mesh. Without fixed casters everything is in the sun.
    Counts update(const Casters& casters, fvec3 towards_sun, std::span<const GpuMesh> meshes,
                  std::span<const Bounds> mesh_bounds, std::span<const std::uint64_t> revisions,
                  const SmallProgram& program);
    /// Binds the map to shadow_unit and returns how the shaders read it.
    ShadowView bind() const;

private:
    /// The rectangle of the map's texels that the shadow of one caster may cover.
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
    std::vector<Instance> moving_;  // moving objects that cast shadows, at the last drawing
    std::vector<Print> prints_;     // rectangle in the shadow map of each of `moving_`

    // Scratch memory for the current picture.
    std::vector<Print> left_;        // where moving objects have left; fixed shadows are copied back there
    std::vector<Instance> drawn_;    // objects whose shadows are to be drawn
    std::vector<Print> new_prints_;  // rectangles in the shadow map of all moving objects
};

}  // namespace thaum::render::detail

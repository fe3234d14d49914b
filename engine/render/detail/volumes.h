// Volumes as OpenGL has them. What is behind the skin is marched first, into a target of its own and with fewer pixels, since
// it has no edges but those of what stands in it; the skin, drawn with the view, shows it.
#pragma once
#include <cstddef>

#include "render/detail/gpu_mesh.h"
#include "render/detail/shaders.h"
#include "render/detail/targets.h"

namespace thaum::render::detail {

/// One view's volume.
struct SeenVolume {
    const Volume* volume{};        ///< null: there is none, or it is not seen
    bool inside{};                 ///< the eye is
    Rect view{};                   ///< px of the marched target, from the bottom left: where the view is
    Rect part{};                   ///< of it, what is marched
    std::size_t first{}, count{};  ///< batches of what stands in it
};

/// Whether it can be drawn at all: texels as many as cells, all numbers finite, a round of some size.
bool drawable(const Volume& volume);
/// Where the view sees it. `view`: as SeenVolume::view.
SeenVolume seen(const Volume& volume, const Camera& camera, const Sight& sight, const Rect& view);
/// Those of the instances that may stand in it. Pieces of a patchwork never do.
void add_dipped(const Volume& volume, std::span<const Instance> instances,
                std::span<const Bounds> mesh_bounds, std::span<const PatchTable> patches,
                std::vector<Instance>& out);

/// Pixels of a view for each of the marched target, along a side.
int march_share(Quality quality);

class Volumes {
public:
    static Expected<Volumes> load(const std::filesystem::path& shaders);
    VolumeId make();
    /// Makes room for a frame so many marched pixels wide and high.
    void begin(int width, int height, Quality quality);
    /// Sends what is new and makes ready for what stands in one view's volume to be drawn, with `depth_program`, which has the
    /// view's matrix then.
    void begin_depth(const SeenVolume& its, const Sight& sight, const SmallProgram& depth_program);
    /// What is behind the skin in one view, up to the depth that was drawn.
    void march(const ViewScene& view, const SeenVolume& its, const Sight& sight, Quality quality,
               const VertexArray& no_attributes);
    /// Over the view that is drawn; `at` is its place in its target, px from the bottom left.
    void show(const SeenVolume& its, const Sight& sight, const Rect& at, const VertexArray& no_attributes);
    /// Texels and skins sent so far, for tests.
    std::size_t sent() const { return sent_; }

private:
    struct Gpu {
        Texture texels;
        VertexArray array;
        Buffer vertices, indices;
        GLsizei index_count{};
        std::array<int, 3> cells{};
        std::uint64_t version{};
        bool filled = false;
    };
    struct MarchProgram {
        MeshProgram view;
        GLint forward{}, right{}, up{}, zenith{}, horizon{}, foam_colour{}, depth_range{};
        GLint origin{}, inverse_size{}, centre{}, inverse_radii{}, brightness{}, thickness{}, steps{};
    };
    struct SkinProgram {
        Program program;
        GLint view_projection{}, to_picture{};
    };

    static Expected<MarchProgram> load_march(const std::filesystem::path& shaders, bool inside, bool linear);
    static Expected<SkinProgram> load_skin(const std::filesystem::path& shaders, bool inside);
    void send(const Volume& volume);
    static void set_eye(const MarchProgram& program, const ViewScene& view);
    static void set_volume(const MarchProgram& program, const Volume& volume);
    void draw(const SeenVolume& its, const VertexArray& no_attributes) const;

    std::vector<Gpu> all_;
    std::array<std::array<MarchProgram, 2>, 2> march_;  // outside, inside; pixels, light
    std::array<SkinProgram, 2> skin_;                   // outside, inside
    Framebuffer depth_target_;
    Texture depth_;
    Target marched_;
    GLint format_{};  // of it
    std::size_t sent_{};
};

}  // namespace thaum::render::detail

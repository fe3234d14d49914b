// Volumes in OpenGL (render/volume.h). The eye sees a volume through its upper surface, the skin. The part
// behind the skin is computed first by ray marching, into a separate target with fewer pixels. Fewer suffice,
// since its only edges are those of objects in the volume. The skin is drawn with the view and shows the
// result.
#pragma once
#include <cstddef>

#include "render/detail/gpu_mesh.h"
#include "render/detail/shaders.h"
#include "render/detail/targets.h"

namespace thaum::render::detail {

/// A volume as one view sees it.
struct SeenVolume {
    const Volume* volume{};  ///< the volume; null if there is none or it is not visible
    bool inside{};           ///< true: the eye is inside the volume
    /// Place of the view in the target into which volumes are ray-marched, from the bottom left (px).
    Rect view{};
    Rect part{};  ///< part of `view` in which rays are marched through the volume
    /// Batches of the objects that stand in the volume: the first one, and their number.
    std::size_t first{}, count{};
};

/// Returns true if the volume can be drawn: one texel for each cell, all numbers finite, and an ellipsoid of
/// positive size.
bool drawable(const Volume& volume);
/// Finds the part of the volume that the view sees. `view` is the place of the view in the target into which
/// volumes are ray-marched, from the bottom left (px).
SeenVolume seen(const Volume& volume, const Camera& camera, const Sight& sight, const Rect& view);
/// Appends the instances that may be partly inside the volume. A patchwork (a large fixed mesh in patches,
/// such as walls) never counts as inside.
void add_dipped(const Volume& volume, std::span<const Instance> instances,
                std::span<const Bounds> mesh_bounds, std::span<const PatchTable> patches,
                std::vector<Instance>& out);

/// Number of pixels of a view for each pixel that is ray-marched, along a side.
int march_share(Quality quality);

class Volumes {
public:
    static Expected<Volumes> load(const std::filesystem::path& shaders);
    VolumeId make();
    /// Allocates the target into which volumes are ray-marched, for a frame of this size (ray-marched
    /// pixels).
    void begin(int width, int height, Quality quality);
    /// Sends new texels and a new skin (upper surface) of the volume. Then prepares to draw, with
    /// `depth_program`, the depth of the objects in one view's volume, and sets the view's matrix in that
    /// program.
    void begin_depth(const SeenVolume& its, const Sight& sight, const SmallProgram& depth_program);
    /// Marches rays through the part of the volume behind its skin (upper surface) in one view, up to the
    /// depth that was drawn.
    void march(const ViewScene& view, const SeenVolume& its, const Sight& sight, Quality quality,
               const VertexArray& no_attributes);
    /// Draws the skin (upper surface) of the volume over the drawn view. `at` is the view's place in its
    /// target, from the bottom left (px).
    void show(const SeenVolume& its, const Sight& sight, const Rect& at, const VertexArray& no_attributes);
    /// Number of times that texels and skins (upper surfaces) of volumes were sent, for tests.
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
    // Programs by the eye's place and by what they write: [outside, inside][pixels, linear light].
    std::array<std::array<MarchProgram, 2>, 2> march_;
    // Programs for a volume's skin (upper surface), by the eye's place: [outside, inside].
    std::array<SkinProgram, 2> skin_;
    Framebuffer depth_target_;
    Texture depth_;
    Target marched_;
    GLint format_{};  // texture format of `marched_`, the target of the ray marching
    std::size_t sent_{};
};

}  // namespace thaum::render::detail

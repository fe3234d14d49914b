// Scans (volumes of samples, such as CT scans) in OpenGL. Each view's scans are drawn into targets of their
// own, with fewer pixels while something moves, and drawn over the view: first the surfaces, with depth, then
// the translucent scans up to the depth of the surfaces and the scene. A sharp picture is kept while nothing
// changes.
#pragma once
#include <cstddef>
#include <vector>

#include "render/detail/batches.h"
#include "render/detail/gl.h"
#include "render/detail/gpu_scan.h"
#include "render/detail/shaders.h"

namespace thaum::render::detail {

/// A scan that a view sees.
struct SeenScan {
    const Scan* scan{};
    Bounds bounds{};      ///< sphere around the scan's samples (world)
    fmat4 to_samples{1};  ///< maps the world to the scan's samples, in sample distances from the first sample
    Rect part{};          ///< rectangle that the scan may cover, from the bottom left of the view (px)
};

/// Finds the scans that a view of this size (px) sees. Translucent ones are sorted from back to front.
std::vector<SeenScan> seen_scans(std::span<const Scan> scans, const Sight& sight, int width, int height);

/// Bounds and numbers of changes of all meshes, indexed by mesh.
struct MeshStates {
    std::span<const Bounds> bounds;
    std::span<const std::uint64_t> revisions;  ///< number of changes of each mesh
};
/// Hashes of what a view draws besides its scans: objects that touch a scan, and all solid objects.
struct SceneHashes {
    std::uint64_t near{}, all{};
};
SceneHashes hash_scene(const Batches& batches, std::size_t first, std::size_t count, const MeshStates& meshes,
                       std::span<const SeenScan> scans);

/// A view that is complete except for its scans.
struct ScanView {
    const ViewScene* view{};
    const Sight* sight{};
    Rect at{};             ///< rectangle of the view in its target, from the bottom left (px)
    GLuint framebuffer{};  ///< the OpenGL framebuffer into which the view is drawn
    std::size_t number{};  ///< number of the view in its frame
    Quality quality{};
    SceneHashes scene{};
};

struct ScanCounts {
    std::size_t drawn{}, marched{}, bricks_sent{}, draws{};
};

class Scans {
public:
    static Expected<Scans> load(const std::filesystem::path& shaders);
    ScanId make();
    /// Sends samples that changed, and draws the scans of one view.
    ScanCounts draw(const ScanView& view, std::span<const SeenScan> seen, const VertexArray& no_attributes);

private:
    struct MarchProgram {
        MeshProgram view;
        GLint forward{}, right{}, up{}, to_samples{}, to_opaque{}, depth_range{}, start{}, last{}, spacing{};
        GLint nearest{}, leaps{}, step_length{}, level{}, colour{}, painted{}, behind_things{}, sun{};
        GLint linear{};
    };
    struct ShowProgram {
        Program program;
        GLint to_picture{}, inside{}, corner{}, to_opaque{}, depth_range{};
    };
    struct DrawnTarget {
        Framebuffer framebuffer;
        Texture colour, depth;
        int width{}, height{};
        GLint format{};
    };
    /// Textures into which the scans of one view are drawn, and the hashes of the picture that they hold.
    struct ViewTargets {
        DrawnTarget solid, light;
        Texture opaque;
        int width{}, height{};  // size of `opaque` (px)
        std::uint64_t near{}, all{};
        bool sharp = false;
    };
    /// State while the scans of one view are drawn.
    struct Drawing {
        const ScanView& view;
        ViewTargets& targets;
        const VertexArray& no_attributes;
        int share{};  // width of a drawn pixel, in pixels of the view
        Rect part{};  // rectangle that all scans together may cover (px)
        ScanCounts counts{};
    };

    static Expected<MarchProgram> load_march(const std::filesystem::path& shaders, const char* file,
                                             const std::vector<std::string_view>& variant);
    static Expected<ShowProgram> load_show(const std::filesystem::path& shaders, bool solid);
    static void copy_depth(const Drawing& drawing);
    static void fill(Drawing& drawing, const Rect& part, bool solid, GLenum depth_test);
    void march(Drawing& drawing, const SeenScan& its, DrawnTarget& target);
    static void clear(const Drawing& drawing, DrawnTarget& target, bool with_depth);
    void set_scan(const MarchProgram& p, const Drawing& drawing, const SeenScan& its,
                  const DrawnTarget& target) const;
    void show(Drawing& drawing, const DrawnTarget& target, bool solid) const;
    void draw_look(Drawing& drawing, std::span<const SeenScan> seen, ScanLook look, bool again);

    std::vector<GpuScan> all_;
    GLint max_samples_{};  // largest number of samples along an axis that the driver allows
    MarchProgram surface_;
    // Programs of translucent scans: [glowing, lit by sky and sun][with colours by density only, also with
    // colours and materials of its samples].
    std::array<std::array<MarchProgram, 2>, 2> light_;
    ShowProgram show_solid_, show_light_;
    std::vector<ViewTargets> targets_;
    std::vector<std::uint8_t> scratch_;
};

}  // namespace thaum::render::detail

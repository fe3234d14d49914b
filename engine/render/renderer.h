// render/renderer.h: draws a Frame (render/scene.h) with OpenGL 3.3 on the thread that owns the context.
//
// One forward shader has three variants (render/quality.h): sun, hemisphere ambient light, up to 8 point
// lights, fog, filmic tone curve. On a software rasteriser pixels cost most, so all variants except the
// highest compute light at each vertex. All instances of one mesh are one draw call; instances out of view
// are not drawn. The sun's shadows are kept from frame to frame (Casters).
#pragma once
#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/error.h"
#include "render/font.h"
#include "render/image.h"
#include "render/mesh.h"
#include "render/pass_times.h"
#include "render/scene.h"

namespace thaum::render {

/// What the last call of draw has done, counted over all views.
struct DrawStatistics {
    std::size_t draws{};  ///< OpenGL draw calls, including sky and overlay
    std::size_t instances_drawn{};
    /// Instances that were not drawn because they are out of view or not finite.
    std::size_t instances_culled{};
    std::size_t triangles{};     ///< triangles of the drawn instances
    std::size_t shadow_draws{};  ///< draw calls into the shadow map; 0 if no caster has moved
    std::size_t shadow_triangles{};
    std::size_t volumes_drawn{};
    /// Volumes whose texels and skin (upper surface) were sent again because their version changed.
    std::size_t volumes_sent{};
    std::size_t scans_drawn{};  ///< scans in view that show something
    /// Scans whose rays were computed; fewer than those drawn if a sharp picture was kept.
    std::size_t scans_marched{};
    std::size_t scan_bricks_sent{};
    std::size_t meshes_sent{};  ///< meshes of Frame::changes whose triangles were sent
};

/// Draws frames with OpenGL.
class Renderer {
public:
    /// Loads the shaders; `assets` is the folder that holds shaders/. A context must be current, and must
    /// outlive the Renderer. Errors: a faulty shader file (the error has its name and the driver's message),
    /// or no font.
    static Expected<Renderer> create(const std::filesystem::path& assets);
    Renderer(Renderer&&) noexcept;
    Renderer& operator=(Renderer&&) noexcept;
    ~Renderer();

    /// Draws everything once that pictures of this quality need, so that none of them is delayed: drivers
    /// compile a shader at its first use. Takes up to a second at a program's first run. It overwrites the
    /// picture that is not presented yet.
    void warm_up(Quality quality);

    MeshId upload(const MeshData& mesh);
    /// Uploads a mesh with coarser copies (render/detail/simplify.h), which replace
    /// it if it is small on the screen.
    MeshId upload_with_copies(const MeshData& mesh);
    /// Uploads a patchwork (a large fixed mesh in patches, which are left out where they are not seen). Each
    /// view draws one instance of it at most.
    MeshId upload(const Patchwork& patchwork);
    /// Replaces the triangles of a mesh that changes, such as a surface. The new mesh may be empty.
    void replace(MeshId id, const MeshData& mesh);
    /// Reserves a volume (a translucent body, such as a brew). Views supply its texels and its skin (upper
    /// surface) in ViewScene::volume.
    VolumeId make_volume();

    /// Reserves a scan (a body of samples, such as a CT scan). Views supply its samples (ViewScene::scans).
    /// The first picture of each look (such as translucent or surface) takes longer, since drivers compile a
    /// shader at its first use.
    ScanId make_scan();

    /// Draws into the context's framebuffer; the caller presents it. A frame of size zero draws nothing.
    void draw(const Frame& frame);
    /// Statistics of the last frame that was drawn.
    const DrawStatistics& statistics() const;
    /// While on, each draw measures its passes. It then takes longer, since passes wait for each other.
    void measure_passes(bool on);
    /// Times of the passes of the last draw; zeros if they were not measured.
    const PassTimes& pass_times() const;
    /// Name of the device that draws (GL_RENDERER), for first_quality.
    std::string device() const;

    /// Returns the picture of the last draw. Must be called before present(), which may discard the picture.
    Image read_pixels();

    /// Depths (0 to 1) that the last draw left in the target of its views, row by row from below. The window
    /// has no depth.
    std::vector<float> read_depths();

    /// Size of the box that this UTF-8 text fills in the overlay (px).
    fvec2 measure(std::string_view text, float size);

private:
    struct State;
    explicit Renderer(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

}  // namespace thaum::render

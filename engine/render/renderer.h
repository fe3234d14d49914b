// render/renderer.h: draws a Frame (render/scene.h) with OpenGL 3.3 on the thread that owns the context.
//
// One forward shader in three variants (render/quality.h): sun, hemisphere ambient, up to 8 point lights, fog, filmic
// tone curve. On a software rasteriser pixels are what costs, so all but the highest light each vertex. Instances of one
// mesh are one draw call; those out of view are none. The sun's shadows are kept from frame to frame (Casters).
#pragma once
#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>

#include "core/error.h"
#include "render/font.h"
#include "render/image.h"
#include "render/mesh.h"
#include "render/scene.h"

namespace thaum::render {

/// What the last draw did, over all views.
struct DrawStatistics {
    std::size_t draws{};  ///< OpenGL draw calls, sky and overlay included
    std::size_t instances_drawn{};
    std::size_t instances_culled{};  ///< out of view or not finite
    std::size_t triangles{};         ///< of the instances drawn
    std::size_t shadow_draws{};      ///< into the shadow map; 0 where nothing that casts has moved
    std::size_t shadow_triangles{};
    std::size_t volumes_drawn{};
    std::size_t volumes_sent{};  ///< those whose texels and skin were another version's
};

class Renderer {
public:
    /// `assets` is the folder that holds shaders/. A context must be current, and stay until the Renderer is gone.
    /// Takes up to a second: each shader variant is used once, which is when drivers compile. Errors: a shader file (named,
    /// with the driver's line), no font.
    static Expected<Renderer> create(const std::filesystem::path& assets);
    Renderer(Renderer&&) noexcept;
    Renderer& operator=(Renderer&&) noexcept;
    ~Renderer();

    MeshId upload(const MeshData& mesh);
    /// With coarser copies (render/simplify.h) for where it is small.
    MeshId upload_with_copies(const MeshData& mesh);
    /// An instance of it stands in one place for each view.
    MeshId upload(const Patchwork& patchwork);
    /// New triangles for a mesh that changes, such as a surface; may be empty.
    void replace(MeshId id, const MeshData& mesh);
    /// A place for texels and skin, which views hand over (ViewScene::volume).
    VolumeId make_volume();

    /// Draws into the context's framebuffer; the caller presents it. A frame of no size draws nothing.
    void draw(const Frame& frame);
    const DrawStatistics& statistics() const;
    /// What draws, as OpenGL calls it (GL_RENDERER); for first_quality.
    std::string device() const;

    /// What the last draw made; call before present(), which may throw it away.
    Image read_pixels();

    /// Box of a TextItem in px.
    fvec2 measure(std::string_view text, float size);

private:
    struct State;
    explicit Renderer(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

}  // namespace thaum::render

#include "render/detail/warm_up.h"

#include "render/detail/gl.h"

namespace thaum::render::detail {
namespace {

/// Patches in the sun and out of it. The large ones are near the light, the small ones are not.
Patchwork patches_of_every_kind() {
    Patchwork patches;
    for (const float half : {0.5F, 4.0F}) {
        for (const bool sunless : {false, true})
            patches.push_back({.full = box(fvec3(half), fvec3(1)), .sunless = sunless});
    }
    return patches;
}

}  // namespace

void warm_up(Renderer& renderer, Quality quality) {
    const std::array texels{Texel{255, 255, 255, 255}};
    const std::array skin{SkinVertex{.position = {-1, 1, -3}}, SkinVertex{.position = {1, 1, -3}},
                          SkinVertex{.position = {0, 1, -4}}};
    constexpr std::array<std::uint32_t, 3> corners{0, 1, 2};
    Volume volume{.id = renderer.make_volume(),
                  .version = 1,
                  .cells = {1, 1, 1},
                  .texels = texels,
                  .centre = {0, 1, -3},
                  .skin = skin,
                  .skin_indices = corners};
    const MeshId mesh = renderer.upload(box(fvec3(0.5F), fvec3(1)));
    const MeshId patchwork = renderer.upload(patches_of_every_kind());
    const Instance instance{.mesh = mesh, .model = translated({0, 1.7F, -3})};
    const std::array instances{instance, Instance{.mesh = patchwork, .model = instance.model}};
    const PointLight light;
    ViewScene view;
    view.viewport = {0, 0, 8, 8};
    view.instances = instances;
    view.shades = {&instance, 1};
    view.lights = {&light, 1};
    view.volume = &volume;
    Frame frame{.width = 8, .height = 8, .views = {view}};
    frame.casters = {{&instance, 1}, {&instance, 1}};
    frame.overlay.items.emplace_back(RectItem{.low = {0, 0}, .high = {4, 4}});
    frame.overlay.items.push_back(TextItem{.text = "a", .position = {0, 0}, .size = 8});
    frame.quality = quality;
    frame.internal_scale = quality == Quality::medium ? 0.5F : 1.0F;
    // Draws the volume seen from outside and from inside.
    for (const fvec3 centre : {fvec3(0, 1, -3), fvec3(0, 2, 0)}) {
        volume.centre = centre;
        renderer.draw(frame);
    }
    renderer.replace(mesh, {});
    renderer.replace(patchwork, {});
    glFinish();
}

}  // namespace thaum::render::detail

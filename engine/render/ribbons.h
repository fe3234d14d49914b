// render/ribbons.h: streamlines (field/streamline.h) as flat coloured ribbons.
//
//     seeds --trace--> points --ribbon--> one mesh per seed --> instances
//
// Only ribbons whose seed has moved are traced again, so one ribbon can follow a hand while any number of
// others stay. Both sides are drawn. The colour follows the speed and glows, so that ribbons show in the
// dark.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "field/streamline.h"
#include "render/mesh.h"
#include "render/renderer.h"

namespace thaum::render {

/// Colours at 256 speeds from the slowest to the fastest, linear light.
using SpeedColours = std::array<fvec3, 256>;

/// Width and colours of a ribbon.
struct RibbonLook {
    float width = 0.004F;             ///< width of the ribbon (m)
    const SpeedColours* colours{};    ///< colours by speed; null: white
    double slowest = 0, fastest = 1;  ///< speeds of the first and the last colour (m/s)
    /// Share of its own colour that the ribbon emits; 0: lit by the scene only.
    float glow = 0.3F;
};

/// Mesh of one ribbon; without triangles if there are fewer than two points. At both ends the ribbon tapers
/// to a point over a length equal to its width.
MeshData ribbon(std::span<const field::StreamPoint> line, const RibbonLook& look);

/// Ribbons along the streamlines of a field, traced again only where something changed.
class Ribbons {
public:
    /// Traces the ribbons of all seeds (starting points of streamlines) that are new or have moved;
    /// traces all ribbons if `version` differs from that of the previous call. The caller increments
    /// `version` when field, settings or look change. Returns the number of ribbons traced. The context of
    /// the renderer must be current.
    std::size_t update(Renderer& renderer, const field::VectorField& field, std::span<const vec3> seeds,
                       const field::StreamlineSettings& settings, const RibbonLook& look,
                       std::uint64_t version);
    /// The ribbons as instances (placed meshes) for ViewScene::instances, moved by `model` from the frame of
    /// the field. Valid until the next call of a member.
    std::span<const Instance> instances(const fmat4& model = fmat4(1));

private:
    struct One {
        MeshId mesh{};
        vec3 seed{};
    };
    std::vector<One> all_;  // ribbons, one for each mesh that was ever made
    // Number of ribbons with a seed, where the streamline starts; they come first in `all_`.
    std::size_t used_ = 0;
    std::uint64_t version_ = 0;
    float glow_ = 0;
    std::vector<field::StreamPoint> line_;
    std::vector<Instance> instances_;
};

}  // namespace thaum::render

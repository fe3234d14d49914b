// render/ribbons.h: streamlines (field/streamline.h) as flat coloured ribbons.
//
//     seeds --trace--> points --ribbon--> one mesh per seed --> instances
//
// Only ribbons whose seed moved are traced again, so one that a hand drags is live beside any number of
// others. Both sides are drawn. The colour follows the speed and glows, so that ribbons show in the dark.
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

struct RibbonLook {
    float width = 0.004F;             ///< width of the ribbon (m)
    const SpeedColours* colours{};    ///< null: white
    double slowest = 0, fastest = 1;  ///< speeds of the first and the last colour (m/s)
    float glow = 0.3F;                ///< 0: lit by the scene; 1: emits its own colour
};

/// Mesh of one ribbon. No triangles for fewer than two points. The width shrinks to a point over its own
/// length at both ends.
MeshData ribbon(std::span<const field::StreamPoint> line, const RibbonLook& look);

class Ribbons {
public:
    /// Traces the ribbons of all seeds that are new or moved, and all if `version` differs from the call before.
    /// The caller counts it up when field, settings or look change. Returns the number of ribbons traced. The
    /// context of the renderer must be current.
    std::size_t update(Renderer& renderer, const field::VectorField& field, std::span<const vec3> seeds,
                       const field::StreamlineSettings& settings, const RibbonLook& look,
                       std::uint64_t version);
    /// Instances for ViewScene::instances, moved by `model` from the frame of the field. Valid until the next
    /// call of a member.
    std::span<const Instance> instances(const fmat4& model = fmat4(1));

private:
    struct One {
        MeshId mesh{};
        vec3 seed{};
    };
    std::vector<One> all_;  // one per mesh ever made
    std::size_t used_ = 0;  // ribbons with a seed, first in `all_`
    std::uint64_t version_ = 0;
    float glow_ = 0;
    std::vector<field::StreamPoint> line_;
    std::vector<Instance> instances_;
};

}  // namespace thaum::render

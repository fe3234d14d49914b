// haptics/surface/detail/sweep.h: the first surface that a point meets on a straight path.
#pragma once
#include "haptics/surface/detail/walls.h"

namespace thaum::haptics {

/// A straight path of the proxy, to be searched for the first surface on it.
struct Sweep {
    vec3 from{}, step{};
    double length{};  ///< length of the path (m)

    Sweep(vec3 start, vec3 whole) : from(start), step(whole), length(glm::length(whole)) {}
};

struct Hit {
    double at{2};   ///< fraction of the path at which it meets a surface; above 1: it meets none
    double drop{};  ///< component of the path against the normal of the hit surface (m)
    Wall wall{};
};

/// Set of surfaces of a patch, one bit each.
using SurfaceSet = std::uint32_t;
static_assert(surface_capacity <= 32);
constexpr SurfaceSet only(std::uint32_t surface) { return SurfaceSet{1} << surface; }

void sweep_flat(const Scene& scene, const Facet& flat, const Sweep& path, Hit& first);
void sweep_solid(const Scene& scene, std::uint32_t solid, const Sweep& path, Hit& first);

/// First hit of a path on all surfaces except those in `passed_over`.
Hit first_hit(const Scene& scene, const Sweep& path, SurfaceSet passed_over = 0);

/// Finds surfaces that are too far away for a path to meet them. Distances measured at one place serve for
/// all paths near it, which saves time.
class Clearances {
public:
    /// Surfaces that no path meets while it stays within `distance` (m) of a place.
    SurfaceSet beyond(const Scene& scene, vec3 from, double distance);

private:
    vec3 place_{HUGE_VAL};
    /// For each surface, how far a point may move from the place of the last measurement without meeting it
    /// (m).
    std::array<double, surface_capacity> free_{};
    void measure(const Scene& scene, vec3 place);
};

}  // namespace thaum::haptics

// haptics/surface_sweep.h: the first surface that a point meets on a straight path.
#pragma once
#include "haptics/surface_walls.h"

namespace thaum::haptics {

/// A straight path.
struct Sweep {
    vec3 from{}, step{};
    double length{};  ///< m

    Sweep(vec3 start, vec3 whole) : from(start), step(whole), length(glm::length(whole)) {}
};

struct Hit {
    double at{2};   ///< fraction of the path; above 1 where nothing is met
    double drop{};  ///< part of the path that goes against the wall (m)
    Wall wall{};
};

/// Set of surfaces of a patch, a bit each.
using SurfaceSet = std::uint32_t;
static_assert(surface_capacity <= 32);
constexpr SurfaceSet only(std::uint32_t surface) { return SurfaceSet{1} << surface; }

void sweep_flat(const Scene& scene, const Facet& flat, const Sweep& path, Hit& first);
void sweep_solid(const Scene& scene, std::uint32_t solid, const Sweep& path, Hit& first);

/// First hit of all surfaces but those passed over.
Hit first_hit(const Scene& scene, const Sweep& path, SurfaceSet passed_over = 0);

/// Tells which surfaces are too far to be met, from their distances at one place, which serve for the paths near it.
class Clearances {
public:
    /// Surfaces that no path meets which stays within a distance of a place.
    SurfaceSet beyond(const Scene& scene, vec3 from, double distance);

private:
    vec3 place_{HUGE_VAL};
    std::array<double, surface_capacity> free_{};  ///< distances that a point may go from there (m)
    void measure(const Scene& scene, vec3 place);
};

}  // namespace thaum::haptics

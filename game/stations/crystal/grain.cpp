#include "game/stations/crystal/grain.h"

#include "core/assert.h"

namespace thaum::game::inline stations {
namespace {

/// Density after an edit. If the edit leads away from the key (`wanted`: the key is solid at this voxel),
/// only the share `against` of the change remains.
float along_grain(float before, float after, bool wanted, double against) {
    if (after == before || (after > before) == wanted) return after;
    return before + static_cast<float>(against) * (after - before);
}

/// Calls visit(number of the voxel in the crystal, number within the box) for each voxel of the box.
template <class Visit>
void for_each_voxel(const field::VoxelView& crystal, const field::VoxelBox& box, Visit visit) {
    std::size_t number = 0;
    for (int k = box.low[2]; k < box.high[2]; ++k)
        for (int j = box.low[1]; j < box.high[1]; ++j)
            for (int i = box.low[0]; i < box.high[0]; ++i) visit(crystal.at(i, j, k), number++);
}

/// Copies the voxels of a box to a body of their own. Its colours are white, since a trial edit does not read
/// them.
field::Voxels cutout_of(const field::VoxelView& crystal, std::span<const float> density,
                        const field::VoxelBox& box) {
    const auto length = [&](std::size_t axis) { return box.high.at(axis) - box.low.at(axis); };
    auto part = field::make_voxels({length(0), length(1), length(2)}, crystal.spacing);
    for_each_voxel(crystal, box,
                   [&](std::size_t voxel, std::size_t own) { part.density[own] = density[voxel]; });
    return part;
}

/// Middle of a box of voxels (m, crystal's frame).
vec3 middle_of(const field::VoxelBox& box, double spacing) {
    const vec3 low(box.low[0], box.low[1], box.low[2]), high(box.high[0], box.high[1], box.high[2]);
    return 0.5 * spacing * (low + high - static_cast<double>(crystal_side));
}

/// Numbers of voxels after a trial edit: those solid in both crystal and key, and those solid in either.
struct Counts {
    std::size_t both{}, either{};

    explicit Counts(const field::VoxelOverlap& current) : both(current.both), either(current.either) {}
    void note(float before, float after, bool wanted) {
        const bool was = before >= crystal_surface, is = after >= crystal_surface;
        if (was == is) return;
        auto& count = wanted ? both : either;
        is ? ++count : --count;
    }
    /// Compares the overlap with `current`: positive if it is greater, negative if it is less.
    double against(const field::VoxelOverlap& current) const {
        return static_cast<double>(both) * static_cast<double>(current.either) -
               static_cast<double>(current.both) * static_cast<double>(either);
    }
};

}  // namespace

field::Edit carve_crystal(MatchContext& context, CrystalBodies& bodies, Crystal& crystal,
                          const field::Tool& tool, const field::Dab& dab) {
    THAUM_ASSERT(crystal.touched != 0, "an untouched crystal has no voxels to carve");
    auto& body = bodies.list.at(crystal.number);
    const auto view = voxels_of(context.world, bodies, crystal);
    const auto box = field::reach(view, tool, dab);
    body.old.clear();
    for_each_voxel(view, box,
                   [&](std::size_t voxel, std::size_t) { body.old.push_back(view.density[voxel]); });
    const auto edit = field::edit(view, tool, dab);
    for_each_voxel(view, box, [&](std::size_t voxel, std::size_t number) {
        view.density[voxel] = along_grain(body.old[number], view.density[voxel], body.overlap.wants(voxel),
                                          context.data.crystal->against_key);
    });
    count_again(bodies, crystal, view, edit.changed);
    return edit;
}

DabWorth worth_of_dab(const MatchContext& context, const CrystalBodies& bodies, const Crystal& crystal,
                      const field::Tool& tool, const field::Dab& dab) {
    THAUM_ASSERT(crystal.touched != 0, "an untouched crystal has no voxels to try a tool on");
    const auto& overlap = bodies.list.at(crystal.number).overlap;
    const double spacing = spacing_of(crystal);
    const field::VoxelView whole{.count = overlap.count, .spacing = vec3(spacing)};
    const auto box = field::reach(whole, tool, dab);
    if (box.empty()) return DabWorth::nothing;
    const auto density =
        context.world.blob<CrystalDensity>().subspan(crystal.number * crystal_voxels, crystal_voxels);
    auto part = cutout_of(whole, density, box);
    auto here = dab;
    here.place -= middle_of(box, spacing);
    field::edit(part.view(), tool, here);
    Counts slowed{overlap}, plain{overlap};
    for_each_voxel(whole, box, [&](std::size_t voxel, std::size_t own) {
        const bool wanted = overlap.wants(voxel);
        const float before = density[voxel], after = part.density[own];
        slowed.note(before, along_grain(before, after, wanted, context.data.crystal->against_key), wanted);
        plain.note(before, after, wanted);
    });
    if (slowed.against(overlap) > 0) return DabWorth::helps;
    // Without the grain, which weakens changes that lead away from the key, the tool would reduce the
    // overlap. The grain would only slow that down.
    return plain.against(overlap) < 0 ? DabWorth::spoils : DabWorth::nothing;
}

}  // namespace thaum::game::inline stations

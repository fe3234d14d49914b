#include "haptics/volume/volume_feel.h"

#include <algorithm>
#include <cmath>

#include "haptics/volume/level_contact.h"

namespace thaum::haptics {
namespace {

constexpr std::size_t primitives_of_guide = 2;
constexpr std::size_t primitives_of_wall = 2;
// Number of primitives (elementary forces on the proxy) besides guide planes and walls: one for gravity, and
// one for the force S along the gradient.
constexpr std::size_t primitives_of_feel = 2;

double finite_or_zero(double x) { return std::isfinite(x) ? x : 0; }

MaterialFeel material_at(const VolumeFeel& feel, vec3 place, std::uint32_t& index) {
    index = feel.materials == nullptr ? 0 : feel.material(place);
    return feel.materials == nullptr ? MaterialFeel{} : (*feel.materials)[index];
}

double share_of(const field::TransferFunction& function, double x) {
    return std::clamp(finite_or_zero(function(x)), 0.0, 1.0);
}

/// Adds what the opacity gives to the force S along the gradient (N, negative: towards larger densities) and
/// to the drag R (N s/m). `length` is that of the gradient.
void feel_opacity(const OpacityFeel& feel, const field::Scalar& here, double length, VolumeFelt& felt) {
    felt.opacity = share_of(feel.density, here.value) * share_of(feel.gradient, length);
    felt.stiff += feel.attracts ? -feel.stiffness * (1 - felt.opacity) : feel.stiffness * felt.opacity;
    felt.viscosity += feel.retarding * felt.opacity + feel.retarding_always;
}

void feel_shell(const DensityShell& shell, double density, VolumeFelt& felt) {
    if (!(density > shell.low && density <= shell.high)) return;
    const double share = (density - shell.low) / (shell.high - shell.low);
    felt.stiff += shell.stiffness * share;
    felt.viscosity += shell.retarding * share + shell.retarding_always;
}

/// Adds the force S along the gradient as a plane, placed so that the spring from the tip to a proxy on it
/// has just this force. The plane faces against the gradient, or along it if S pulls towards larger
/// densities.
void add_stiffness(double stiff, const Direction& up, const ModeInput& input, PrimitiveSet& set) {
    const double strength = up.length > 0 ? std::min(std::abs(stiff), max_pull) : 0;
    const vec3 way = stiff < 0 ? up.unit : -up.unit;
    add_or_rest(set, {PrimitiveKind::plane, input.tip + strength / input.stiffness * way, way, strength});
}

void add_ambient(const VolumeFeel& feel, PrimitiveSet& set) {
    const Direction down = direction_of(feel.gravity);
    // Without gravity, a point of strength 0 takes the place of the directed force, so that the number of
    // primitives stays the same. A directed force would make the whole set an active source even with
    // strength 0.
    if (down.length > 0)
        add_or_rest(set, {PrimitiveKind::directed, {}, down.unit, std::min(down.length, primitive_limit)});
    else
        add_or_rest(set, {.kind = PrimitiveKind::point});
    for (std::size_t i = 0; i < std::min<std::size_t>(feel.guide_count, max_guides); ++i) {
        const GuidePlane& guide = feel.guides[i];
        add_or_rest(set,
                    {PrimitiveKind::plane, guide.place, guide.normal, std::min(guide.strength, max_pull)});
        add_or_rest(set,
                    {PrimitiveKind::plane, guide.place, -guide.normal, std::min(guide.strength, max_pull)});
    }
}

/// Adds the primitives of a wall (surface of one density): a plane, and a line for friction. Returns whether
/// the wall is near the proxy.
bool add_wall(const VolumeFeel& feel, const DensityWall& wall, const ModeInput& input, PrimitiveSet& set) {
    const LevelSurface surface{
        .field = feel.density, .level = wall.density, .reach = wall.reach, .motion = input.motion};
    const auto strength_of = [&](const LevelContact& found) {
        std::uint32_t index = 0;
        const ContactPlane& first = found.planes[0];
        // The strength depends on the material of the solid just behind the surface.
        const double factor =
            material_at(feel, first.place - 0.5 * wall.reach * first.normal, index).stiffness;
        return std::clamp(finite_or_zero(wall.strength * factor), 0.0,
                          found.behind ? max_pull : primitive_limit);
    };
    const LevelContact contact =
        find_contact(surface, input.proxy, input.next_tip(), input.stiffness, strength_of);
    if (contact.count == 0) {
        for (int i = 0; i < 2; ++i) add_or_rest(set, {.kind = PrimitiveKind::point});
        return false;
    }
    const ContactPlane& first = contact.planes[0];
    const double strength = strength_of(contact);
    const auto friction = [&](const ContactPlane& plane) {
        const double pressed = pressing_force(plane, input.next_tip(), input.pull(), strength);
        return std::clamp(finite_or_zero(wall.friction * pressed), 0.0, primitive_limit);
    };
    const ContactPlane held = holding_plane(contact, held_back(input, first.normal, friction(first)));
    add_or_rest(set, {PrimitiveKind::plane, held.place, held.normal, strength});
    add_or_rest(set, {PrimitiveKind::line, input.proxy, held.normal, friction(held)});
    return true;
}

}  // namespace

std::size_t primitives_of(const VolumeFeel& feel) noexcept {
    return primitives_of_feel + primitives_of_guide * std::min<std::size_t>(feel.guide_count, max_guides) +
           primitives_of_wall * std::min<std::size_t>(feel.wall_count, max_walls_felt);
}

VolumeFelt add_volume_feel(const VolumeFeel& feel, const ModeInput& input, PrimitiveSet& set) noexcept {
    VolumeFelt felt;
    if (set.items().size() + primitives_of(feel) > primitive_capacity) return felt;
    set.set_by_proxy();
    const field::Scalar here = feel.density(input.tip);
    const Direction up = direction_of(here.gradient);
    if (std::isfinite(here.value)) {
        feel_opacity(feel.opacity, here, up.length, felt);
        feel_shell(feel.shell, here.value, felt);
    }
    const MaterialFeel material = material_at(feel, input.tip, felt.material);
    felt.stiff = finite_or_zero(feel.share * felt.stiff * material.stiffness);
    felt.viscosity = std::max(0.0, finite_or_zero(feel.share * felt.viscosity * material.viscosity));
    add_stiffness(felt.stiff, up, input, set);
    add_ambient(feel, set);
    for (std::uint32_t i = 0; i < std::min<std::uint32_t>(feel.wall_count, max_walls_felt); ++i)
        felt.touched |= add_wall(feel, feel.walls[i], input, set) ? 1U << i : 0U;
    return felt;
}

}  // namespace thaum::haptics

#include "haptics/volume/level_contact.h"

#include "haptics/volume/detail/body_search.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

namespace thaum::haptics {
namespace {

/// A search for the surface ends after a Newton step of at most this share of LevelSurface::reach, without
/// another read of the field.
constexpr double short_step = 0.05;

/// Side, direction and distance of the surface from a place, by the field's value and gradient there.
struct Reading {
    double inside{};    ///< the value's distance from the level, > 0 in the solid (field's units)
    vec3 out{};         ///< unit vector out of the solid
    double gradient{};  ///< length of the gradient (1/m); 0: no direction

    bool solid() const { return inside > 0; }
    double depth() const { return inside / gradient; }  ///< depth, estimated by value and slope (m)
};

/// Search for planes in a field that is no box of samples. Its gradient must be exactly that of its value.
class Search {
public:
    Search(const LevelSurface& surface, LevelContact& contact) : surface_(surface), contact_(contact) {}

    Reading read(vec3 place) {
        ++contact_.reads;
        const field::Scalar here = surface_.field(place);
        const double side = surface_.solid_below ? -1 : 1;
        const double length = glm::length(here.gradient);
        if (!std::isfinite(here.value) || !std::isfinite(length)) return {.inside = -HUGE_VAL};
        if (!(length > 1e-150)) return {.inside = side * (here.value - surface_.level)};
        return {side * (here.value - surface_.level), here.gradient * (-side / length), length};
    }

    std::optional<ContactPlane> first(vec3 proxy, vec3 target) {
        const Reading here = read(proxy);
        const auto plane = near(proxy, here);
        return plane || here.solid() ? plane : between(proxy, target);
    }

    std::optional<ContactPlane> next(vec3 proxy, vec3 landing, vec3 /*target*/) {
        const Reading there = read(landing);
        const bool holds = there.solid() && there.gradient > 0 && there.depth() > 1e-3 * surface_.reach;
        if (!holds) return std::nullopt;
        const auto plane = near(landing, there);
        return plane ? plane : between(proxy, landing);
    }

private:
    /// The plane at the surface near a place, found by Newton steps; std::nullopt if the surface is farther
    /// away than LevelSurface::reach.
    std::optional<ContactPlane> near(vec3 place, Reading here) {
        vec3 x = place;
        for (int tries = 0; tries < 4; ++tries) {
            if (!(here.gradient > 0)) return std::nullopt;
            const double step = here.depth();
            if (!(std::abs(step) <= surface_.reach)) return std::nullopt;
            x += step * here.out;
            if (std::abs(step) <= short_step * surface_.reach) return kept(x, place, here);
            here = read(x);
        }
        return std::nullopt;
    }

    /// The plane where the straight way from `from`, which is outside, enters the solid.
    std::optional<ContactPlane> between(vec3 from, vec3 to) {
        const double length = glm::distance(from, to);
        if (!(length > 1e-9) || !std::isfinite(length)) return std::nullopt;
        const int parts = static_cast<int>(std::clamp(std::ceil(length / surface_.reach), 1.0, 4.0));
        vec3 outside = from;
        for (int i = 1; i <= parts; ++i) {
            const vec3 inside = from + (to - from) * (static_cast<double>(i) / parts);
            const Reading there = read(inside);
            if (there.solid()) return bisected(outside, inside);
            outside = inside;
        }
        return std::nullopt;
    }

    /// The plane at x, where a Newton search from `place` has ended; none if x is so far away that it lies on
    /// another part of the surface. Where two faces meet, the gradient at x may be that of the other face.
    /// The way that the search took is a better normal there.
    std::optional<ContactPlane> kept(vec3 x, vec3 place, const Reading& here) const {
        constexpr double near_enough = 1.5, same_face = 0.8;
        const vec3 way = x - place;
        const double length = glm::length(way);
        if (!(length <= near_enough * surface_.reach)) return std::nullopt;
        vec3 normal = here.out;
        if (length > short_step * surface_.reach && std::abs(glm::dot(normal, way)) < same_face * length)
            normal = way / (glm::dot(normal, way) < 0 ? -length : length);
        return ContactPlane{x, normal, here.gradient};
    }

    std::optional<ContactPlane> bisected(vec3 outside, vec3 inside) {
        for (int halvings = 0; halvings < 12; ++halvings) {
            const vec3 middle = 0.5 * (outside + inside);
            const Reading here = read(middle);
            if (here.gradient > 0 && std::abs(here.depth()) <= short_step * surface_.reach)
                return ContactPlane{middle + here.depth() * here.out, here.out, here.gradient};
            (here.solid() ? inside : outside) = middle;
        }
        return std::nullopt;  // the field jumps here and gives no direction
    }

    const LevelSurface& surface_;
    LevelContact& contact_;
};

bool behind(const ContactPlane& plane, vec3 x, double slack) {
    return glm::dot(x - plane.place, plane.normal) < -slack;
}

vec3 onto(const ContactPlane& plane, vec3 x) {
    return x - glm::dot(x - plane.place, plane.normal) * plane.normal;
}

/// The nearest place to x on both planes; the place on the first one if they are parallel.
vec3 onto_both(const ContactPlane& a, const ContactPlane& b, vec3 x) {
    const vec3 on_a = onto(a, x);
    const vec3 slope = b.normal - glm::dot(b.normal, a.normal) * a.normal;
    const double square = glm::dot(slope, slope);
    if (!(square > 1e-12)) return on_a;
    return on_a - glm::dot(on_a - b.place, b.normal) / square * slope;
}

/// The place on all three planes, or x if they have none in common.
vec3 onto_three(std::span<const ContactPlane> p, vec3 x) {
    const double volume = glm::dot(p[0].normal, glm::cross(p[1].normal, p[2].normal));
    if (!(std::abs(volume) > 1e-6)) return x;
    const auto height = [&](const ContactPlane& plane) { return glm::dot(plane.place - x, plane.normal); };
    return x + (height(p[0]) * glm::cross(p[1].normal, p[2].normal) +
                height(p[1]) * glm::cross(p[2].normal, p[0].normal) +
                height(p[2]) * glm::cross(p[0].normal, p[1].normal)) /
                   volume;
}

/// If the place of the first plane lies behind another plane, moves the other plane back until it goes
/// through that place. So the place of the first plane is behind none of the planes, and the proxy can always
/// land there. Planes of a rough field could otherwise leave free only a wedge of space far from the tip.
ContactPlane in_front(ContactPlane plane, const ContactPlane& first) {
    if (behind(plane, first.place, 0)) plane.place = first.place;
    return plane;
}

}  // namespace

vec3 landing_of(const LevelContact& contact, vec3 target) noexcept {
    const auto planes = std::span(contact.planes).first(std::min<std::size_t>(contact.count, 3));
    constexpr double slack = 1e-10;  // depth behind a plane that still counts as on it (m)
    const auto free = [&](vec3 x) {
        return std::ranges::none_of(planes, [&](const ContactPlane& p) { return behind(p, x, slack); });
    };
    if (free(target)) return target;
    vec3 best = target;
    double nearest = HUGE_VAL;
    const auto offer = [&](vec3 x) {
        const double distance = glm::distance(x, target);
        if (!(distance < nearest) || !free(x)) return;
        nearest = distance;
        best = x;
    };
    for (const ContactPlane& plane : planes) offer(onto(plane, target));
    for (std::size_t i = 0; i < planes.size(); ++i) {
        for (std::size_t j = i + 1; j < planes.size(); ++j) offer(onto_both(planes[i], planes[j], target));
    }
    if (planes.size() == 3) offer(onto_three(planes, target));
    // If rounding has excluded all others, the place of the first plane remains: in_front() has moved the
    // planes so that it is behind none.
    if (nearest == HUGE_VAL) offer(planes[0].place);
    return best;
}

ContactPlane holding_plane(const LevelContact& contact, vec3 target) noexcept {
    // Shortest push from the tip whose direction is more than rounding (m).
    constexpr double shortest = 1e-10;
    ContactPlane held = contact.planes[0];
    if (contact.count < 2 || !is_finite(target)) return held;
    const vec3 landing = landing_of(contact, target), push = landing - target;
    const double length = glm::length(push);
    if (!(length > shortest)) return held;
    held.place = landing;
    held.normal = push / length;
    return held;
}

double pressing_force(const ContactPlane& plane, vec3 next_tip, vec3 pull, double strength) noexcept {
    if (!(glm::dot(plane.place - next_tip, plane.normal) > 0)) return 0;
    return std::clamp(glm::dot(plane.normal, pull), 0.0, strength);
}

namespace {

/// Adds the plane that a search finds first, then those that keep the proxy's landing place out of the solid.
template <class AnySearch>
void add_planes(AnySearch search, const LevelSurface& surface, vec3 proxy, vec3 target,
                LevelContact& contact) {
    auto plane = search.first(proxy, target);
    contact.behind = plane && behind(*plane, proxy, short_step * surface.reach);
    while (plane && contact.count < contact.planes.size()) {
        contact.planes[contact.count] = contact.count == 0 ? *plane : in_front(*plane, contact.planes[0]);
        ++contact.count;
        if (contact.count == contact.planes.size() || !is_finite(target)) break;
        plane = search.next(proxy, landing_of(contact, target), target);
    }
}

}  // namespace

LevelContact find_contact(const LevelSurface& surface, vec3 proxy, vec3 target) noexcept {
    LevelContact contact;
    if (!is_finite(proxy) || !(surface.reach > 0)) return contact;
    const field::SampleBox box = field::sample_box_of(surface.field);
    if (box.bounded)
        add_planes(BodySearch(surface, box, contact), surface, proxy, target, contact);
    else
        add_planes(Search(surface, contact), surface, proxy, target, contact);
    return contact;
}

}  // namespace thaum::haptics

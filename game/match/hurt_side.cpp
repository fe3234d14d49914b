#include "game/match/hurt_side.h"

#include <cmath>

namespace thaum::game::inline match {

bool strikes_body(EventKind kind) {
    return !info_of(kind).cause.empty() || kind == EventKind::held_off || kind == EventKind::pushed;
}

std::optional<vec3> way_to_cause(const Simulation& match, const Event& event, std::uint32_t player) {
    constexpr double beside =
        0.15;  // distance from the body's middle beyond which a point counts as on one side (m)
    const auto& world = match.world();
    const auto middle_of = [&](std::uint32_t of) { return world.get<Motion>(wizard_of(world, of)).position; };
    const auto is_beside = [](vec3 way) { return std::hypot(way.x, way.z) > beside; };
    const vec3 centre = middle_of(player);
    vec3 way = info_of(event.kind).placed ? event.place - centre : vec3(0);
    if (!is_beside(way) && event.by < players && event.by != player) way = middle_of(event.by) - centre;
    if (!is_beside(way)) return std::nullopt;
    return way;
}

std::optional<vec3> way_to_source(const Simulation& match, const Event& event, std::uint32_t player) {
    constexpr double on_body =
        0.7;  // maximum horizontal distance of a point on the body from the body's middle (m)
    const auto way = way_to_cause(match, event, player);
    if (!way || event.by >= players || event.by == player) return way;
    if (!info_of(event.kind).placed || std::hypot(way->x, way->z) > on_body) return way;
    auto at_body = event;
    at_body.place = match.world().get<Motion>(wizard_of(match.world(), player)).position;
    return way_to_cause(match, at_body, player);
}

}  // namespace thaum::game::inline match

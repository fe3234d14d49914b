#include "game/arena/placement.h"

#include <algorithm>
#include <cmath>

#include "core/text.h"
#include "game/arena/symmetry.h"

namespace thaum::game::inline arena {
namespace {

/// Depth in a solid that is tolerated, for rounding or contact of bodies at rest (m)
constexpr double slack = 0.03;
constexpr double deepest_drop = 0.5;  ///< largest tolerated fall of a wizard who appears (m)
/// Largest tolerated height of ground above the feet of a wizard who appears (m)
constexpr double step_up = 0.1;
// Radius of a standing wizard, and the heights above the feet between which no part of the wizard may be
// inside of a solid (m).
constexpr double standing_radius = 0.25, lowest_probe = 0.2, highest_probe = 1.5;

/// Number of a table's line in its file, as text: "12".
std::string line_of(const ConfigTable& table, std::string_view key) {
    const auto place = table.place(key);
    return place.substr(place.rfind(':') + 1);
}

/// Half the size of a ramp's mesh, and the horizontal vector `up` along which the ramp rises. The dot product
/// of `up` and an offset from the mesh's middle is -1 at the low edge and 1 at the high edge.
struct Slope {
    vec3 half{0}, up{0};
};

Slope slope_of(const physics::TriangleMesh& mesh) {
    Slope slope;
    for (const auto& v : mesh.vertices) slope.half = glm::max(slope.half, glm::abs(v));
    for (const auto& v : mesh.vertices)
        if (v.y > 0) slope.up += vec3(v.x, 0, v.z) / 2.0;  // halved, because the high edge has two vertices
    slope.up = {slope.up.x / (slope.half.x * slope.half.x), 0, slope.up.z / (slope.half.z * slope.half.z)};
    return slope;
}

/// Height of a solid's top above its middle, at a point of the ground; std::nullopt beside the solid, and for
/// spheres and bowls, on which wizards never appear.
std::optional<double> top_at(const Arena& arena, const Thing& solid, vec3 at) {
    const vec3 d = at - solid.position;
    const auto& size = solid.body.size;
    switch (solid.body.shape) {
        case physics::Shape::box:
            return std::abs(d.x) <= size.x && std::abs(d.z) <= size.z ? std::optional(size.y) : std::nullopt;
        case physics::Shape::cylinder:
            return std::hypot(d.x, d.z) <= size.x ? std::optional(size.y) : std::nullopt;
        case physics::Shape::mesh: break;
        default: return {};
    }
    if (solid.surface == Surface::bowl) return {};
    const auto slope = slope_of(arena.meshes[solid.body.mesh]);
    if (std::abs(d.x) > slope.half.x || std::abs(d.z) > slope.half.z) return {};
    return slope.half.y * glm::dot(slope.up, d);
}

bool is_inside(const Arena& arena, const Thing& solid, vec3 at) {
    const vec3 d = at - solid.position;
    if (solid.body.shape == physics::Shape::sphere) return glm::length(d) < solid.body.size.x - slack;
    const auto top = top_at(arena, solid, at);
    if (!top || d.y > *top - slack) return false;
    const bool mesh = solid.body.shape == physics::Shape::mesh;
    const double half = mesh ? slope_of(arena.meshes[solid.body.mesh]).half.y : solid.body.size.y;
    return d.y > slack - half;
}

/// Sample points within a body, most of them near its surface.
std::vector<vec3> probes_of(const Body& body) {
    constexpr double near_surface = 0.9;
    vec3 half = body.size;
    if (body.shape == physics::Shape::cylinder) half = {body.size.x, body.size.y, body.size.x};
    if (body.shape == physics::Shape::sphere) half = vec3(body.size.x);
    std::vector<vec3> probes{vec3(0)};
    for (const vec3 axis : {vec3(1, 0, 0), vec3(0, 1, 0), vec3(0, 0, 1)})
        for (const double way : {-near_surface, near_surface}) probes.push_back(half * axis * way);
    if (body.shape != physics::Shape::box) return probes;
    for (const double x : {-near_surface, near_surface})
        for (const double y : {-near_surface, near_surface})
            for (const double z : {-near_surface, near_surface}) probes.push_back(half * vec3(x, y, z));
    return probes;
}

std::vector<vec3> probes_of_wizard() {
    std::vector<vec3> probes;
    for (const double y : {lowest_probe, 1.0, highest_probe})
        for (const vec3 side : {vec3(0), vec3(1, 0, 0), vec3(-1, 0, 0), vec3(0, 0, 1), vec3(0, 0, -1)})
            probes.push_back(side * standing_radius + vec3(0, y, 0));
    return probes;
}

class Placement {
public:
    Placement(const ConfigTable& root, const Arena& arena) : arena_(arena) {
        for (const auto& table : root.tables("solid")) {
            const auto twins = read_symmetry(table) == Symmetry::none ? 1 : 2;
            for (int i = 0; i < twins; ++i) lines_.push_back(line_of(table, "shape"));
        }
    }

    /// Reports a body or a wizard, given by sample points, that lies inside of a solid.
    bool check_free(const ConfigTable& table, std::string_view key, vec3 at, std::span<const vec3> probes,
                    std::string_view who) const {
        std::size_t line = 0;
        for (const auto& solid : arena_.things) {
            if (solid.prop) continue;
            const bool inside =
                std::ranges::any_of(probes, [&](vec3 probe) { return is_inside(arena_, solid, at + probe); });
            if (inside) {
                table.report(key,
                             text("'", key, "': ", who, " is inside of the solid '",
                                  surface_names.at(static_cast<std::size_t>(solid.surface)), "' of line ",
                                  line < lines_.size() ? lines_[line] : "?", "; move it out"));
                return false;
            }
            ++line;
        }
        return true;
    }

    /// Reports a place without ground at the feet, where a wizard who appears would fall.
    void check_ground(const ConfigTable& table, std::string_view key, vec3 feet) const {
        double ground = -1e9;
        for (const auto& solid : arena_.things) {
            const auto top = solid.prop ? std::nullopt : top_at(arena_, solid, feet);
            if (top && solid.position.y + *top <= feet.y + step_up)
                ground = std::max(ground, solid.position.y + *top);
        }
        if (ground >= feet.y - deepest_drop) return;
        const auto how = ground < -1e8 ? std::string("has no ground below it")
                                       : text("lies ", feet.y - ground, " m above the ground");
        table.report(key, text("'", key, "' ", how, ", at most ", deepest_drop, " m are allowed"));
    }

    void check_wizard(const ConfigTable& table, std::string_view key, vec3 feet) const {
        static const auto probes = probes_of_wizard();
        if (check_free(table, key, feet, probes, "a wizard here")) check_ground(table, key, feet);
    }

private:
    const Arena& arena_;
    /// Line numbers of the solids in the arena's file, in the order of the arena's static things.
    std::vector<std::string> lines_;
};

}  // namespace

void check_placement(const ConfigTable& root, const Arena& arena) {
    const Placement placement(root, arena);
    auto prop = std::ranges::find_if(arena.things, &Thing::prop);
    for (const auto& table : root.tables("prop")) {
        const auto twins = read_symmetry(table) == Symmetry::none ? 1 : 2;
        for (int i = 0; i < twins && prop != arena.things.end(); ++i, ++prop)
            placement.check_free(table, "position", prop->position, probes_of(prop->body), "the prop");
    }
    auto pad = arena.pads.begin();
    for (const auto& table : root.tables("pad")) {
        const auto twins = read_symmetry(table) == Symmetry::none ? 1 : 2;
        for (int i = 0; i < twins && pad != arena.pads.end(); ++i, ++pad)
            placement.check_wizard(table, "position", pad->feet);
    }
    if (!root.has("range")) return;
    placement.check_wizard(root.table("range").table("player"), "place", arena.practice[0].feet);
    placement.check_wizard(root.table("range").table("dummy"), "place", arena.practice[1].feet);
}

}  // namespace thaum::game::inline arena

#include "field/streamline.h"

#include <algorithm>
#include <cmath>

namespace thaum::field {
namespace {

/// The field at a place, as a direction and a speed.
struct Flow {
    vec3 direction{};
    double speed{};
    /// Angle by which the flowing matter turns about the direction, for each metre along the line (rad/m).
    double twist{};
    bool moves{};
};

struct Tracer {
    const VectorField& field;
    const StreamlineSettings& settings;

    Flow at(vec3 place) const {
        const Vector v = field(place);
        const double speed = glm::length(v.value);
        // This form of the comparison also treats NaN as standing still.
        if (!(speed > settings.min_speed) || !std::isfinite(speed)) return {};
        const vec3 direction = (settings.upstream ? -1.0 : 1.0) * v.value / speed;
        const double turn = glm::dot(curl(v), direction) / (2 * speed);
        return {direction, speed, std::isfinite(turn) ? turn : 0.0, true};
    }

    /// Place after one step of length h from `from`. `moves` becomes false if the field is 0 at any place
    /// that the step reads.
    vec3 stepped(vec3 from, const Flow& there, double h, bool& moves) const {
        const Flow b = at(from + h / 2 * there.direction);
        const Flow c = at(from + h / 2 * b.direction);
        const Flow d = at(from + h * c.direction);
        moves = moves && b.moves && c.moves && d.moves;
        return from + h / 6 * (there.direction + 2.0 * b.direction + 2.0 * c.direction + d.direction);
    }

    struct Step {
        vec3 to{};
        double error{};
        bool moves = true;
    };

    Step doubled(vec3 from, const Flow& there, double h) const {
        Step step;
        const vec3 whole = stepped(from, there, h, step.moves);
        const vec3 half = stepped(from, there, h / 2, step.moves);
        const Flow middle = at(half);
        step.moves = step.moves && middle.moves;
        step.to = stepped(half, middle, h / 2, step.moves);
        step.error = glm::distance(whole, step.to) / 15;
        return step;
    }

    /// Makes one step, and repeats it with shorter lengths until its error is within the tolerance or it has
    /// the shortest length. Updates h to the length for the next step; `done` is the length of this one.
    Step controlled(vec3 from, const Flow& there, double left, double& h, double& done) const {
        while (true) {
            done = std::min(h, left);
            Step step = doubled(from, there, done);
            if (settings.tolerance <= 0) return step;
            const double share = step.moves ? step.error / settings.tolerance : 32.0;
            const double factor = share > 0 ? 0.9 * det::pow(share, -0.2) : 2.0;
            const double next = std::clamp(done * std::clamp(factor, 0.2, 2.0), settings.shortest_step,
                                           settings.longest_step);
            const bool shortest = done <= settings.shortest_step;
            // After a step that was cut short by the end of the line, h may only become shorter: nothing is
            // known of longer steps.
            if (share <= 1 || shortest) {
                if (done == h || next < h) h = next;
                return step;
            }
            h = next;
        }
    }
};

vec3 any_across(vec3 along) {
    const vec3 size = glm::abs(along);
    vec3 axis(0);
    axis[size.x <= size.y && size.x <= size.z ? 0 : (size.y <= size.z ? 1 : 2)] = 1;
    return glm::normalize(glm::cross(along, axis));
}

/// The direction `across` at the next point: made perpendicular to the line's new direction `along`, and
/// turned by `angle` about it.
vec3 carried(vec3 across, vec3 along, double angle) {
    const vec3 flat = across - glm::dot(across, along) * along;
    const double length = glm::length(flat);
    const vec3 unit = length > 1e-9 ? flat / length : any_across(along);
    return det::cos(angle) * unit + det::sin(angle) * glm::cross(along, unit);
}

bool is_within(vec3 place, const StreamlineSettings& settings) {
    for (int axis = 0; axis < 3; ++axis) {
        if (!(place[axis] >= settings.low[axis] && place[axis] <= settings.high[axis])) return false;
    }
    return true;
}

}  // namespace

StreamEnd trace(const VectorField& field, vec3 seed, const StreamlineSettings& settings,
                std::vector<StreamPoint>& out) {
    out.clear();
    const Tracer tracer{field, settings};
    if (!is_within(seed, settings)) return StreamEnd::outside;
    Flow here = tracer.at(seed);
    if (!here.moves) return StreamEnd::still;
    out.push_back({seed, here.direction, any_across(here.direction), here.speed, 0});
    double h = settings.longest_step;
    while (static_cast<int>(out.size()) < settings.max_points) {
        const auto last = out.back();
        const double left = settings.length - last.way;
        if (left <= 1e-12 * settings.length) return StreamEnd::length;
        double done = 0;
        const auto step = tracer.controlled(last.place, here, left, h, done);
        const Flow next = tracer.at(step.to);
        if (!step.moves || !next.moves) return StreamEnd::still;
        if (!is_within(step.to, settings)) return StreamEnd::outside;
        const double angle = done * (here.twist + next.twist) / 2;
        out.push_back({step.to, next.direction, carried(last.across, next.direction, angle), next.speed,
                       last.way + done});
        here = next;
    }
    return StreamEnd::points;
}

}  // namespace thaum::field

#include "gesture/detail/speed_force.h"

#include <algorithm>

#include "gesture/detail/path.h"

namespace thaum::gesture {
namespace {

/// Number of parts of a stroke over each of which force and speed are averaged. A part then has several steps
/// even with a mouse, so that the rounding of its positions to whole counts averages out.
constexpr double speed_parts = 12;
/// Largest `force_beside_speed` of a force that follows speed: the square of a tenth. Strokes in the game's
/// viscous field have 0.01 at most, even with a mouse that jitters, and letters by a pen that feels pressure
/// have 0.4 or more.
constexpr double max_beside_speed = 0.01;

/// Sums over the parts of a stroke, from which follows how well a multiple of the speed fits the force.
class SpeedFit {
public:
    /// Adds a step of this length, duration and mean force to the current part.
    void add(double way, double seconds, double force) {
        if (!(seconds > 0)) return;
        force_ += way * force;
        speed_ += way * way / seconds;
    }
    void end_part() {
        forces_ += force_ * force_;
        speeds_ += speed_ * speed_;
        both_ += force_ * speed_;
        force_ = speed_ = 0;
    }
    std::optional<double> unexplained() const {
        const double squares = forces_ * speeds_;
        if (!(squares > 0)) return {};
        return std::clamp(1 - both_ * both_ / squares, 0.0, 1.0);
    }

private:
    double force_ = 0, speed_ = 0;  // force and speed in the current part, summed along the path
    double forces_ = 0, speeds_ = 0, both_ = 0;
};

}  // namespace

std::optional<double> force_beside_speed(Points stroke) {
    const double part = path_length(stroke) / speed_parts;
    double way = 0, end = part;
    SpeedFit fit;
    for (std::size_t i = 1; i < stroke.size(); ++i) {
        const auto &from = stroke[i - 1], &to = stroke[i];
        const double step = glm::distance(from.at, to.at);
        fit.add(step, to.t - from.t, (from.force + to.force) / 2);
        way += step;
        if (way < end && i + 1 < stroke.size()) continue;
        fit.end_part();
        end = std::max(end, way) + part;
    }
    return fit.unexplained();
}

bool force_follows_speed(std::span<const Gesture> gestures) {
    std::size_t follow = 0, with_force = 0;
    for (const auto& gesture : gestures) {
        for (const auto& stroke : gesture.strokes) {
            const auto beside = force_beside_speed(stroke);
            if (!beside) continue;
            ++with_force;
            follow += *beside <= max_beside_speed ? 1 : 0;
        }
    }
    return 2 * follow > with_force;
}

}  // namespace thaum::gesture

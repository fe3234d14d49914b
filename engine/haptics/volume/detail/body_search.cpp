#include "haptics/volume/detail/body_search.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "haptics/volume/smooth_grid.h"

namespace thaum::haptics {
namespace {

/// Distances from its start at which a search for the surface reads the field first (in distances between
/// samples). After them it reads at every half sample.
constexpr std::array<double, 2> first_looks{0.1, 0.5};
constexpr double look_samples = 0.5;
constexpr int max_looks = 16;
/// Largest distance between the start of a search and the surface that it finds at which the normal read at
/// the start serves for that surface, too (samples). With a larger one, the plane of a thin sheet would
/// change its place from tick to tick. `same_slope_apart` applies where the drawn surface (of the samples in
/// the picture) and the smooth surface (of the smoothed field) lie apart.
constexpr double same_slope = 0.5, same_slope_apart = 0.02;
/// Distance between the drawn surface (of the samples in the picture) and the smooth one (of the smoothed
/// field) at which they count as apart (samples).
constexpr double apart = 0.25;
/// Largest distance between the drawn surface (of the samples in the picture) and the smooth one (of the
/// smoothed field) that comes from the small steps which samples make in a surface (samples). A larger
/// distance means a thin sheet or a cut face.
constexpr double max_search_step = 0.5;
/// Largest distance that is wanted between the drawn surface (of the samples in the picture) and the plane by
/// which it is felt: as a share of the tip's depth, and in samples. Both limits apply.
constexpr double depth_share = 0.3, max_eased = 0.5;
/// Largest distance from the drawn surface of a plane that lags behind because it may move only by
/// LevelSurface::slew in a tick. It is given as shares of the tip's depth: first for a plane that moves out
/// of the body, then for one that sinks into it. `max_late` is in samples along the normal.
constexpr double rising_share = 0.88, sinking_share = 8, max_late = 1;
/// Smallest share of the slew (largest motion of a plane in a tick) by which a plane may always move. The
/// tip's motion against the plane, which changes the force too, takes the rest of the slew.
constexpr double min_slew = 0.25;
/// Depth of the tip behind the surface of the smoothed field up to which the way ahead is examined (samples
/// along the normal). At less depth, a step in the drawn surface on the tip's way may put the tip outside of
/// the body, and the force would end at once.
constexpr double let_go = 0.75;
/// Depth in the drawn body that the tip must keep on its way ahead, as a share of the height of the plane
/// above the tip. The share is larger than a plane needs to sink in time, since the reads ahead may miss the
/// top of a step.
constexpr double depth_ahead = 0.45;
/// Distance between two reads of the field on the tip's way ahead (samples), their largest number, and the
/// shortest way that is examined (samples).
constexpr double look_ahead = 0.25, max_looks_ahead = 32, min_ahead = 0.01;
/// Largest motion of a tip in a tick with which the way ahead is computed (m). With a larger one, the way
/// would be so long that the plane sinks far too early before most steps.
constexpr double max_motion = 5e-5;
/// Distance below the tip at which the field is read (samples along the normal). If that place is outside of
/// the body, the tip is near the back of a thin sheet, and leaves it there.
constexpr double ground_below = 0.5;
/// Distances by which a plane may sink in a tick before the tip reaches a step in the drawn surface, as
/// multiples of LevelSurface::slew, the usual limit of its motion. They are tried from the smallest on.
/// `still_felt` is the share of the tip's depth that the hand must still feel while the plane sinks.
constexpr std::array<double, 3> early{0, 1, 1.5};
constexpr double still_felt = 0.01;
/// Largest distance of the proxy's landing place from the place of the first plane (samples) at which a
/// single step of the samples may explain that the landing place is in the body.
constexpr double beside_samples = 0.25;
/// Depth from which on the place where the proxy would land counts as inside the body, and accuracy with
/// which a place on the surface is found (m).
constexpr double min_depth = 1e-7, accurate = 1e-10;

double look_at(int i) {
    const auto n = static_cast<std::size_t>(i);
    return n < first_looks.size() ? first_looks[n] : look_samples * i;
}

/// A weight that falls from 1 at x <= 0 to 0 at x >= 1, with a continuous slope.
double fading(double x) {
    const double t = std::clamp(x, 0.0, 1.0);
    return 1 - t * t * (3 - 2 * t);
}

/// Part of a straight way that lies in the box of the samples, from and to as shares of the way. Empty if
/// from > to.
struct Part {
    double from{}, to{1};
};

Part part_in_box(vec3 a, vec3 b, vec3 half) {
    Part part;
    for (int axis = 0; axis < 3; ++axis) {
        const double way = b[axis] - a[axis];
        if (way == 0) {
            if (std::abs(a[axis]) > half[axis]) return {1, 0};
            continue;
        }
        const double side = way > 0 ? half[axis] : -half[axis];
        part.from = std::max(part.from, (-side - a[axis]) / way);
        part.to = std::min(part.to, (side - a[axis]) / way);
    }
    return part;
}

/// Distance from a place in the box to the face of the box that lies along a direction (m).
double way_to_end(vec3 place, vec3 along, vec3 half) {
    double length = HUGE_VAL;
    for (int axis = 0; axis < 3; ++axis) {
        if (along[axis] == 0) continue;
        const double side = along[axis] > 0 ? half[axis] : -half[axis];
        length = std::min(length, (side - place[axis]) / along[axis]);
    }
    return std::max(length, 0.0);
}

/// Value at a place (in samples), linear between samples. A sample that is not finite has the value with
/// which the picture shows it.
double shown_value(const field::SampleBox& box, vec3 at) {
    const field::Grid& grid = box.drawn;
    const auto shown = [&](std::ptrdiff_t offset) {
        return grid.with_samples(
            [&](const auto* first) { return double{box.shown(static_cast<float>(first[offset]))}; });
    };
    double sum = 0;
    for (int corner = 0; corner < 8; ++corner) {
        double weight = 1;
        std::ptrdiff_t offset = 0;
        for (int axis = 0; axis < 3; ++axis) {
            const auto n = static_cast<std::size_t>(axis);
            const double x = std::clamp(at[axis], 0.0, grid.count[n] - 1.0);
            const int low = std::min(static_cast<int>(x), grid.count[n] - 2), high = corner >> axis & 1;
            weight *= high == 1 ? x - low : 1 - (x - low);
            offset += (low + high) * grid.stride[n];
        }
        if (weight > 0) sum += weight * shown(offset);
    }
    return sum;
}

/// Share by which the averages count at a place in the samples' frame. It falls to 0 near the border, where
/// the kernel would reach far beyond the averages, unless the samples make such coarse steps that only
/// averages show directions.
double averages_share(const field::SampleBox& box, vec3 at) {
    // Distances from the outermost averages up to which they do not count, and from which on they count fully
    // (in distances between averages).
    constexpr double too_near = 1, whole = 3;
    if (box.coarse_steps) return 1;
    const field::Grid& grid = box.averages;
    const vec3 last(grid.count[0] - 1, grid.count[1] - 1, grid.count[2] - 1);
    const vec3 from_first = (at - grid.origin) / grid.spacing;
    const vec3 inside = glm::min(from_first, last - from_first);
    const double nearest = std::min({inside.x, inside.y, inside.z});
    return fading((whole - nearest) / (whole - too_near));
}

}  // namespace

BodySearch::BodySearch(const LevelSurface& surface, const field::SampleBox& box, LevelContact& contact)
    : surface_(surface),
      box_(box),
      contact_(contact),
      motion_(surface.motion * box.placement.turn),
      half_(box.placement.scale * box.half),
      per_scale_(1 / box.placement.scale) {
    const vec3 spacing = box.placement.scale * box.spacing;
    fine_ = std::min({spacing.x, spacing.y, spacing.z});
    samples_per_metre_ = 1.0 / spacing;
}

// ---- reading ----------------------------------------------------------------------------------------------

vec3 BodySearch::to_box(vec3 place) const {
    return (place - box_.placement.origin) * box_.placement.turn - box_.placement.scale * box_.middle;
}

vec3 BodySearch::to_reader(vec3 place) const {
    return box_.placement.origin + box_.placement.turn * (place + box_.placement.scale * box_.middle);
}

vec3 BodySearch::to_samples(vec3 place) const { return per_scale_ * place + box_.middle; }

bool BodySearch::in_box(vec3 place) const {
    // A place on a face of the box must count as inside although conversion between frames has rounded it.
    const double slack = 1e-9 * fine_;
    return std::abs(place.x) <= half_.x + slack && std::abs(place.y) <= half_.y + slack &&
           std::abs(place.z) <= half_.z + slack;
}

bool BodySearch::is_solid(double inside) const {
    // The picture shows a sample whose value equals the level as solid if larger values are solid.
    return surface_.solid_below ? inside > 0 : inside >= 0;
}

double BodySearch::inside(vec3 place) {
    if (!in_box(place)) return -HUGE_VAL;
    ++contact_.reads;
    double value = 0;
    if (box_.drawn.has_samples()) {
        const vec3 at = samples_per_metre_ * (place + half_);
        value = box_.drawn.linear_value(at.x, at.y, at.z);
        if (!std::isfinite(value)) value = shown_value(box_, at);
    } else {
        value = surface_.field(to_reader(place)).value;
    }
    const double depth = (surface_.solid_below ? -1 : 1) * (value - surface_.level);
    return std::isfinite(depth) ? depth : -HUGE_VAL;
}

std::optional<BodySearch::Slope> BodySearch::slope_of(const field::Scalar& here) const {
    const double length = glm::length(here.gradient);
    if (!(length > 1e-150) || !std::isfinite(length) || !std::isfinite(here.value)) return std::nullopt;
    return Slope{here.gradient, (surface_.solid_below ? -1 : 1) * (here.value - surface_.level) / length};
}

/// Gradient of the field at a place. If the averages of blocks of samples give nearly the same direction and
/// have their surface near the place, their direction is used. For a thin sheet the averages may do neither.
std::optional<BodySearch::Slope> BodySearch::slope_at(vec3 place) {
    // Cosines of the angle between both gradients up to which the averages do not count, and from which on
    // they count fully.
    constexpr double differs = 0.1, agrees = 0.4;
    ++contact_.reads;
    field::Scalar here = surface_.field(to_reader(place));
    here.gradient = here.gradient * box_.placement.turn;
    auto fine = slope_of(here);
    if (!fine || !box_.averages.has_samples()) return fine;
    const double by_place = averages_share(box_, to_samples(place));
    if (by_place == 0) return fine;
    const SmoothGrid averages{.grid = box_.averages, .shown = box_.shown};
    field::Scalar there = averages.ending_level(to_samples(place));
    there.gradient /= box_.placement.scale;
    const auto coarse = slope_of(there);
    if (!coarse) return fine;
    const double length = glm::length(fine->up), other = glm::length(coarse->up);
    const double cosine = glm::dot(fine->up, coarse->up) / (length * other);
    const vec3 wide = box_.placement.scale * box_.averages.spacing;
    const double off = std::abs(coarse->depth) / std::min({wide.x, wide.y, wide.z});
    const double share = by_place * fading((agrees - cosine) / (agrees - differs)) * fading(off - 0.5);
    fine->up = glm::mix(fine->up, length / other * coarse->up, share);
    return fine;
}

/// Turns a direction out of the body towards the normals of near faces of the sample box, since the body ends
/// there. `depth` is the depth of the place behind the surface of the smooth field (m).
vec3 BodySearch::at_box(vec3 out, double depth, vec3 place) const {
    vec3 face(0);
    int nearest = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const double share = fading((half_[axis] - std::abs(place[axis])) / fine_);
        face[axis] = std::copysign(share, place[axis]);
        if (share > std::abs(face[nearest])) nearest = axis;
    }
    if (face[nearest] == 0) return out;
    const vec3 sum = face + fading(depth / fine_) * out;
    const double length = glm::length(sum);
    if (length > 1e-6) return sum / length;
    vec3 alone(0);
    alone[nearest] = std::copysign(1.0, place[nearest]);
    return alone;
}

/// The direction out of the body at a place in the sample box; std::nullopt if neither the field nor a near
/// face of the box gives one.
std::optional<BodySearch::Way> BodySearch::way_out(vec3 place) {
    const auto slope = slope_at(place);
    const double length = slope ? glm::length(slope->up) : 0;
    const vec3 out = length > 0 ? (surface_.solid_below ? 1 : -1) / length * slope->up : vec3(0);
    const double depth = length > 0 ? slope->depth : HUGE_VAL;
    const vec3 turned = at_box(out, depth, place);
    if (turned == vec3(0)) return std::nullopt;
    return Way{turned, length, depth};
}

/// Distance between samples along a direction (m).
double BodySearch::sample_along(vec3 out) const { return glm::length(out / samples_per_metre_); }

// ---- searching --------------------------------------------------------------------------------------------

/// The place where the straight line between the ends of a bracket crosses the surface, by regula falsi. If
/// one end stays in place twice, its value is halved (Illinois method), because the search would otherwise
/// converge slowly.
vec3 BodySearch::crossing(Bracket b, double accuracy) {
    const bool from_solid = is_solid(b.at_from);
    double low = 0, high = 1, at_low = b.at_from, at_high = b.at_to, t = 0;
    const double length = glm::distance(b.from, b.to);
    int last = 0;
    for (int tries = 0; tries < 30 && (high - low) * length > accuracy; ++tries) {
        const double width = at_high - at_low;
        const double share = std::isfinite(width) && width != 0 ? -at_low / width : 0.5;
        t = low + std::clamp(share, 1e-3, 1 - 1e-3) * (high - low);
        if (tries >= 12) t = 0.5 * (low + high);
        const double here = inside(glm::mix(b.from, b.to, t));
        const int side = is_solid(here) == from_solid ? -1 : 1;
        (side < 0 ? low : high) = t;
        (side < 0 ? at_low : at_high) = here;
        if (side == last) (side < 0 ? at_high : at_low) *= 0.5;
        last = side;
        // The straight line through the values at both ends shows how far the place may still be off.
        if (std::abs(here) * (high - low) * length <= accuracy * std::abs(at_high - at_low)) break;
    }
    return glm::mix(b.from, b.to, t);
}

std::optional<BodySearch::Found> BodySearch::found_at(vec3 place) {
    const auto way = way_out(place);
    if (!way) return std::nullopt;
    return Found{place, *way};
}

/// The place that a search from `start` has found, and the direction out of the body there. `way` is that
/// direction at the start.
BodySearch::Found BodySearch::found_at(vec3 place, vec3 start, const Way& way) {
    const double smooth = way.smooth - glm::dot(place - start, way.out);
    const bool near_smooth = std::abs(smooth) <= apart * fine_;
    if (glm::distance(place, start) > (near_smooth ? same_slope : same_slope_apart) * fine_) {
        const auto there = found_at(place);
        if (there && glm::dot(there->way.out, way.out) > 0) return *there;
    }
    return {place, {way.out, way.gradient, smooth}};
}

/// Whether the tip at `target`, if it moves on along the surface, stays deep enough in the body for its plane
/// to sink to it at LevelSurface::slew in a tick. `depth` is the tip's depth, `height` the height of the
/// plane above the tip (m). Also true for a tip at rest, and for one near the back of a sheet, where a free
/// place ahead is no step.
bool BodySearch::stays_in(vec3 target, vec3 out, double depth, double height) {
    const vec3 along = motion_ - glm::dot(motion_, out) * out;
    const double moved = glm::length(along), reach = std::min(moved, max_motion) * height / surface_.slew;
    const double space = look_ahead * fine_, ground = ground_below * sample_along(out);
    if (!(reach > min_ahead * fine_) || !std::isfinite(reach)) return true;
    if (depth < depth_ahead * height) return false;
    const vec3 from = target + depth_ahead * height * out, to = target + reach / moved * along;
    if (!solid(from)) return true;
    const int looks = static_cast<int>(std::ceil(std::min(reach / space, max_looks_ahead)));
    const double part = std::min(1.0, max_looks_ahead * space / reach) / looks;
    for (int i = 1; i <= looks; ++i) {
        const vec3 ahead = glm::mix(from, to, part * i);
        if (!solid(ahead)) return !solid(target - ground * out);
    }
    return true;
}

/// Distance from a place on the drawn surface to the plane by which a tip at `target` feels it, along the
/// direction out of the body (m). The plane lies towards the surface of the smoothed field. It moves by at
/// most LevelSurface::slew from the plane of the last tick, on which the proxy lies.
double BodySearch::eased(const Found& found, vec3 proxy, vec3 target) {
    const auto& [place, way] = found;
    const double depth = std::max(0.0, glm::dot(place - target, way.out)), sample = sample_along(way.out);
    const double height = glm::dot(proxy - place, way.out);
    const double step =
        way.smooth * fading((std::abs(way.smooth) / sample - max_search_step) / max_search_step);
    const double own = glm::dot(motion_, way.out), slew = surface_.slew;
    if (!std::isfinite(depth) || !std::isfinite(step) || !std::isfinite(own)) return 0;
    const double most = std::min(depth_share * depth, max_eased * fine_), late = max_late * sample;
    const double wanted = std::clamp(step, -most, most);
    // The tip's motion along the normal changes the force, too, so it leaves less of the slew to the plane.
    const double up = std::max(slew + std::min(own, 0.0), min_slew * slew);
    const double down = std::max(slew - std::max(own, 0.0), min_slew * slew);
    const double lowest = std::min({height - down, sinking_share * depth, late});
    const double highest = std::max(height + up, -std::min(rising_share * depth, late));
    double result = std::min(std::max(wanted, lowest), highest);
    if (slew < HUGE_VAL && depth + step < let_go * sample) {
        for (const double fall : early) {
            if (stays_in(target, way.out, depth, depth + result)) break;
            result = std::max(std::min(result, height - fall * slew), (still_felt - 1) * depth);
        }
    }
    contact_.late |= result != wanted;
    return result;
}

/// The plane by which a place on the surface is felt, in the frame in which the field is read.
std::optional<ContactPlane> BodySearch::plane_of(const std::optional<Found>& found, vec3 proxy, vec3 target) {
    if (!found) return std::nullopt;
    const auto& [place, way] = *found;
    const vec3 eased_place = place + eased(*found, proxy, target) * way.out;
    return ContactPlane{to_reader(eased_place), box_.placement.turn * way.out, way.gradient};
}

/// The place where a straight way out of the body leaves the body or the sample box; std::nullopt if that is
/// farther away than `limit` (m).
std::optional<BodySearch::Found> BodySearch::leaving(vec3 place, double at_place, const Way& way,
                                                     double limit) {
    const double end = way_to_end(place, way.out, half_);
    Bracket b{place, place, at_place, at_place};
    for (int i = 0; i < max_looks; ++i) {
        const double t = std::min({look_at(i) * fine_, limit, end});
        b.to = place + t * way.out;
        b.at_to = inside(b.to);
        if (!is_solid(b.at_to)) return found_at(crossing(b, accurate), place, way);
        if (t >= end) return found_at(b.to, place, way);
        if (t >= limit) return std::nullopt;
        b.from = b.to;
        b.at_from = b.at_to;
    }
    return std::nullopt;
}

/// The place where a straight way against `way.out` enters the body; std::nullopt if that is farther away
/// than `limit` (m).
std::optional<BodySearch::Found> BodySearch::entering(vec3 place, double at_place, const Way& way,
                                                      double limit) {
    const double end = std::min(limit, way_to_end(place, -way.out, half_));
    Bracket b{place, place, at_place, at_place};
    for (int i = 0; i < max_looks; ++i) {
        const double t = std::min(look_at(i) * fine_, end);
        b.to = place - t * way.out;
        b.at_to = inside(b.to);
        if (is_solid(b.at_to)) return found_at(crossing(b, accurate), place, way);
        if (t >= end) return std::nullopt;
        b.from = b.to;
        b.at_from = b.at_to;
    }
    return std::nullopt;
}

/// The place where a straight way along the gradient of the drawn samples leaves the body. It serves in a
/// crevice of a few samples, where the smooth field may lead deeper into the body.
std::optional<BodySearch::Found> BodySearch::out_of_crevice(vec3 place, double at_place) {
    if (!box_.drawn.has_samples()) return std::nullopt;
    ++contact_.reads;
    const field::Scalar drawn = box_.drawn(to_samples(place));
    const double length = glm::length(drawn.gradient);
    if (!(length > 1e-150) || !std::isfinite(length)) return std::nullopt;
    const double side = surface_.solid_below ? 1 : -1;
    return leaving(place, at_place, {side / length * drawn.gradient, length / box_.placement.scale, HUGE_VAL},
                   surface_.reach);
}

/// The place on the surface of the smoothed field near a place, if the tip is so deep that its plane lies
/// just there (see eased()). This shortcut takes fewer reads of the field than a search.
std::optional<BodySearch::Found> BodySearch::on_smooth(vec3 place, const Way& way, vec3 target) {
    const double most = max_eased * fine_;
    if (!(std::abs(way.smooth) <= std::min(surface_.slew, most))) return std::nullopt;
    const vec3 smooth = place + way.smooth * way.out;
    const double depth = glm::dot(smooth - target, way.out);
    if (!(depth > 0) || !in_box(smooth)) return std::nullopt;
    const double above = std::min(depth_share / (1 - depth_share) * depth, most);
    const double below = std::min(depth_share / (1 + depth_share) * depth, most);
    if (solid(smooth + above * way.out) || !solid(smooth - below * way.out)) return std::nullopt;
    return Found{smooth, {way.out, way.gradient, 0}};
}

/// A place on the surface within LevelSurface::reach of a place; std::nullopt if there is none.
std::optional<BodySearch::Found> BodySearch::near(vec3 place, vec3 target) {
    const vec3 nearest = glm::clamp(place, -half_, half_);
    const double away = glm::distance(place, nearest);
    if (!(away <= surface_.reach)) return std::nullopt;
    const auto way = way_out(nearest);
    if (!way) return std::nullopt;
    if (const auto found = on_smooth(nearest, *way, target)) return found;
    const double here = inside(nearest);
    if (!is_solid(here)) return entering(nearest, here, *way, surface_.reach - away);
    if (away > 0) return found_at(nearest, nearest, *way);
    auto found = leaving(nearest, here, *way, surface_.reach);
    if (!found) found = out_of_crevice(nearest, here);
    // The plane of a fast hand lags, and the proxy with it. It must find the surface again.
    if (!found) found = leaving(nearest, here, *way, surface_.reach + max_late * sample_along(way->out));
    return found;
}

/// The place where the straight way between two places enters the body; the first place lies outside.
std::optional<BodySearch::Found> BodySearch::between(vec3 from, vec3 to) {
    const double length = glm::distance(from, to);
    const Part part = part_in_box(from, to, half_);
    if (!(length > 1e-12) || !std::isfinite(length) || !(part.from <= part.to)) return std::nullopt;
    Bracket b;
    b.from = glm::clamp(glm::mix(from, to, part.from), -half_, half_);
    b.at_from = inside(b.from);
    if (is_solid(b.at_from)) return found_at(b.from);
    const vec3 start = b.from, end = glm::mix(from, to, part.to);
    const double looks = std::ceil(glm::distance(start, end) / (look_samples * fine_));
    const int parts = static_cast<int>(std::clamp(looks, 1.0, static_cast<double>(max_looks)));
    for (int i = 1; i <= parts; ++i) {
        b.to = glm::mix(start, end, static_cast<double>(i) / parts);
        b.at_to = inside(b.to);
        if (is_solid(b.at_to)) return found_at(crossing(b, accurate));
        b.from = b.to;
        b.at_from = b.at_to;
    }
    return std::nullopt;
}

/// Whether the plane at a found place tells where the body is on a proxy's way. A plane is infinite, but the
/// body is not: where the proxy meets the plane far from the found place, the body may not be there, above
/// all beyond a thin edge, and outside of the box it is not. A plane behind the tip must lie near the proxy,
/// on which a magnet acts.
bool BodySearch::is_on_way(const Found& found, vec3 from, vec3 to) {
    if (!is_finite(to)) return true;
    const vec3 out = found.way.out;
    const double above = glm::dot(from - found.place, out), below = glm::dot(found.place - to, out);
    if (!(below > 0)) return glm::distance(from - above * out, found.place) <= fine_;
    const vec3 meets = from + std::max(0.0, above) / (std::max(0.0, above) + below) * (to - from);
    const double apart = glm::distance(meets, found.place);
    const Part in_box = part_in_box(from, to, half_);
    if (in_box.from > in_box.to || apart > fine_) return false;
    return apart <= beside_samples * fine_ || solid(to);
}

std::optional<ContactPlane> BodySearch::first(vec3 proxy, vec3 target) {
    const vec3 from = to_box(proxy), to = to_box(target);
    auto found = near(from, to);
    if ((!found || !is_on_way(*found, from, to)) && !solid(from)) found = between(from, to);
    if (!found) return std::nullopt;
    contact_.depth = glm::dot(found->place - to, found->way.out);
    return plane_of(found, from, to);
}

std::optional<ContactPlane> BodySearch::next(vec3 proxy, vec3 landing, vec3 target) {
    const vec3 place = to_box(landing);
    const vec3 normal = contact_.planes[0].normal * box_.placement.turn;
    if (!solid(place + min_depth * normal)) return std::nullopt;
    // The place where the proxy would land lies in the body. Near the place of the first plane, the reason
    // may be only a step that the samples make in the surface; the first plane smooths such steps out. If the
    // body reaches higher up, it is no step, and needs a plane of its own.
    const vec3 plane_at = to_box(contact_.planes[0].place);
    const bool beside = glm::distance(place, plane_at) <= beside_samples * fine_;
    if (beside && !solid(place + max_late * fine_ * normal)) return std::nullopt;
    const vec3 to = to_box(target);
    auto found = near(place, to);
    if (!found) found = between(to_box(proxy), place);
    const auto plane = plane_of(found, to_box(proxy), to);
    const bool holds = plane && glm::dot(plane->place - landing, plane->normal) > min_depth;
    return holds ? plane : std::nullopt;
}

}  // namespace thaum::haptics

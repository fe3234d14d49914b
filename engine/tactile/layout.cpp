#include "tactile/layout.h"

#include <algorithm>

#include "core/file.h"
#include "core/text.h"

namespace thaum::tactile {
namespace {

/// Farthest coordinate of an actuator (m), and least distance between two (m).
constexpr double farthest = 2.5, min_distance = 0.005;

/// Describes what is wrong with the position of one actuator; empty: nothing.
std::string fault_of(const BodyPoint& place) {
    const vec3 at = place.at;
    if (!is_finite(at) || std::max({std::abs(at.x), std::abs(at.y), std::abs(at.z)}) > farthest)
        return text("must lie within ", farthest, " m of the body's origin");
    switch (place.part) {
        case Part::front: return at.z > 0 ? "" : "is on the front, so z must be above 0";
        case Part::back: return at.z < 0 ? "" : "is on the back, so z must be below 0";
        case Part::shoulder_left:
        case Part::arm_left: return at.x < 0 ? "" : "is on the left, so x must be below 0";
        case Part::shoulder_right:
        case Part::arm_right: return at.x > 0 ? "" : "is on the right, so x must be above 0";
        case Part::whole: break;
    }
    return "";
}

std::string fault_of(const Actuator& actuator) {
    if (!(actuator.lowest_hz > 0) || !(actuator.highest_hz >= actuator.lowest_hz) ||
        !std::isfinite(actuator.highest_hz))
        return "needs a carrier range with 0 < lowest_hz <= highest_hz";
    if (!(actuator.limit >= 0 && actuator.limit <= 1)) return "needs a limit from 0 to 1";
    return fault_of(actuator.place);
}

Actuator read_actuator(const ConfigTable& table, const Actuator& usual, std::size_t number) {
    Actuator a;
    a.place.part = static_cast<Part>(table.choice("part", part_names()));
    a.name = table.string("name", text(part_names()[static_cast<std::size_t>(a.place.part)], " ", number));
    a.place.at = table.vector("at_m", {-farthest, farthest});
    a.lowest_hz = table.number("lowest_hz", {1, 1000}, usual.lowest_hz);
    a.highest_hz = table.number("highest_hz", {1, 1000}, usual.highest_hz);
    a.limit = table.number("limit", {0, 1}, usual.limit);
    return a;
}

}  // namespace

Expected<Layout> make_layout(std::string name, Torso torso, std::vector<Actuator> actuators) {
    if (actuators.empty()) return fail("no actuators: give at least one");
    if (actuators.size() > max_actuators)
        return fail(text(actuators.size(), " actuators: give at most ", max_actuators));
    for (std::size_t i = 0; i < actuators.size(); ++i) {
        if (const auto fault = fault_of(actuators[i]); !fault.empty())
            return fail(text("actuator ", i, " ('", actuators[i].name, "') ", fault));
        for (std::size_t k = 0; k < i; ++k) {
            if (glm::length(actuators[i].place.at - actuators[k].place.at) < min_distance)
                return fail(text("actuators ", k, " and ", i, " are in one place: keep them 5 mm apart"));
        }
    }
    Layout layout;
    layout.name = std::move(name);
    layout.torso = torso;
    layout.actuators = std::move(actuators);
    layout.prepare();
    return layout;
}

void Layout::prepare() {
    for (std::size_t i = 0; i < actuators.size(); ++i) {
        const auto& place = actuators[i].place;
        const auto region = region_of(place.part);
        const auto at = place.at;
        groups_[static_cast<std::size_t>(region)].push_back(static_cast<std::uint8_t>(i));
        charts_[0][i] = region == Region::torso ? torso.chart(at)
                        : region == Region::shoulder_left || region == Region::shoulder_right
                            ? vec2(at.x, at.z)
                            : vec2(at.z, at.y);
        charts_[1][i] = {at.x, 0};
    }
    // On a device without actuators of this region, each actuator stands for its side of the body.
    auto& whole = groups_[static_cast<std::size_t>(Region::whole)];
    if (whole.empty()) {
        for (std::size_t i = 0; i < actuators.size(); ++i) whole.push_back(static_cast<std::uint8_t>(i));
    }
    for (std::size_t r = 0; r < region_count; ++r) {
        const auto region = static_cast<Region>(r);
        double sum = 0;
        for (const auto i : groups_[r]) {
            double nearest = farthest;
            for (const auto k : groups_[r]) {
                const vec2 way = between(region, chart_of(region, i), chart_of(region, k));
                if (i != k) nearest = std::min(nearest, glm::length(way));
            }
            sum += groups_[r].size() > 1 ? nearest : 0.1;
        }
        pitch_[r] =
            std::max(min_distance, groups_[r].empty() ? 0.1 : sum / static_cast<double>(groups_[r].size()));
    }
}

std::span<const std::uint8_t> Layout::group(Region region) const {
    return groups_[static_cast<std::size_t>(region)];
}

vec2 Layout::chart_of(Region region, std::size_t actuator) const {
    return charts_[region == Region::whole ? 1 : 0][actuator];
}

vec2 Layout::between(Region region, vec2 from, vec2 to) const {
    vec2 way = to - from;
    if (region == Region::torso) way.x -= torso.round() * std::floor(way.x / torso.round() + 0.5);
    return way;
}

ChartPlace Layout::chart_place(const BodyPoint& point) const {
    auto region = region_of(point.part);
    if (region != Region::whole && group(region).empty()) region = Region::torso;
    if (group(region).empty()) region = Region::whole;
    switch (region) {
        case Region::torso: return {region, torso.chart(point.at)};
        case Region::shoulder_left:
        case Region::shoulder_right: return {region, {point.at.x, point.at.z}};
        case Region::arm_left:
        case Region::arm_right: return {region, {point.at.z, point.at.y}};
        case Region::whole: break;
    }
    return {region, {point.at.x, 0}};
}

BodyPoint Layout::nearest(const Pose& pose, vec3 point) const {
    const auto distance = [&](const Actuator& a) {
        const vec3 way = posed(pose, a.place.part, a.place.at) - point;
        return glm::dot(way, way);
    };
    const auto& best =
        *std::min_element(actuators.begin(), actuators.end(),
                          [&](const Actuator& a, const Actuator& b) { return distance(a) < distance(b); });
    return {best.place.part, at_rest(pose, best.place.part, point)};
}

BodyPoint Layout::facing(vec3 from, double height) const {
    const vec3 at = torso.facing(from, height);
    return {at.z < 0 ? Part::back : Part::front, at};
}

Expected<Layout> read_layout(const Config& file) {
    const auto root = file.root();
    auto name = root.string("name");
    if (name.empty()) root.report("name", "'name' must not be empty: name the device");
    const auto body = root.table("torso");
    const Torso torso(body.number("half_width_m", {0.05, 0.5}), body.number("half_depth_m", {0.05, 0.5}));
    Actuator usual;
    usual.lowest_hz = root.number("lowest_hz", {1, 1000});
    usual.highest_hz = root.number("highest_hz", {1, 1000});
    usual.limit = root.number("limit", {0, 1}, 1);
    std::vector<Actuator> actuators;
    for (const auto& table : root.tables("actuators"))
        actuators.push_back(read_actuator(table, usual, actuators.size()));
    if (auto checked = file.check(); !checked) return std::move(checked.error());
    auto layout = make_layout(std::move(name), torso, std::move(actuators));
    if (!layout) {
        file.report(layout.error().message);
        return Error(file.check().error());
    }
    return layout;
}

Expected<Layout> load_layout(const std::filesystem::path& path) {
    auto content = read_text_file(path, 1U << 16U);
    if (!content) return std::move(content.error());
    const auto file = Config::parse(*content, path.string(), 1);
    if (!file) return file.error();
    return read_layout(*file);
}

}  // namespace thaum::tactile

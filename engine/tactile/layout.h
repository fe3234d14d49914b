// tactile/layout.h: the actuators of one device, and where they sit on the
// body. Files: assets/tactile/layouts.
//
// An effect never names an actuator. It names a place on the body, and a layout has the actuators near it. So
// every effect plays on every device, from a jacket of 40 motors to the two motors of a pad.
#pragma once
#include <filesystem>
#include <span>
#include <string>

#include "core/config.h"
#include "tactile/body.h"

namespace thaum::tactile {

inline constexpr std::size_t max_actuators = 64;

/// One motor or shaker of a device.
struct Actuator {
    std::string name{};
    BodyPoint place{};
    double lowest_hz{};   ///< lowest carrier frequency that the actuator plays (Hz)
    double highest_hz{};  ///< highest carrier frequency (Hz)
    double limit{1};      ///< largest amplitude that the actuator gets, 0 to 1
};

/// A place on the chart (the flattened skin) of a region that has actuators.
struct ChartPlace {
    Region region{};
    vec2 at{};  ///< position on the chart, the flattened skin (m)
};

/// Actuators of one device, in the order in which the device expects them. Made by `make_layout`.
class Layout {
public:
    std::string name{};
    Torso torso{};
    std::vector<Actuator> actuators{};  ///< the actuators, 1 to max_actuators of them

    /// Place, on the chart (the flattened skin) of a region with actuators, at which a point of the body is
    /// rendered. A part without actuators is rendered on the torso. A device without actuators on the torso
    /// renders only whether the point is to the left or to the right.
    ChartPlace chart_place(const BodyPoint& point) const;
    /// Numbers of the actuators by which effects in a region of the body are felt. Never empty for the region
    /// of a result of `chart_place`.
    std::span<const std::uint8_t> group(Region region) const;
    /// Place of an actuator on the chart (the flattened skin) of a region (m).
    vec2 chart_of(Region region, std::size_t actuator) const;
    /// Mean distance from an actuator of a region to the nearest other (m): the size of one cell.
    double pitch(Region region) const { return pitch_[static_cast<std::size_t>(region)]; }
    /// Difference of two places on the chart (the flattened skin) of a region (m). Round the torso, the
    /// shorter way counts.
    vec2 between(Region region, vec2 from, vec2 to) const;
    /// Point of the body at rest for a point of the posed body (m, body frame). Its part is that of the
    /// nearest actuator.
    BodyPoint nearest(const Pose& pose, vec3 point) const;
    /// Place on the torso, at a height (m), that faces the direction `from`, which points from the body to a
    /// source (body frame).
    BodyPoint facing(vec3 from, double height) const;

private:
    friend Expected<Layout> make_layout(std::string name, Torso torso, std::vector<Actuator> actuators);
    void prepare();

    std::array<std::vector<std::uint8_t>, region_count> groups_{};
    /// Places of each actuator on the flattened skin: on the chart of its own region, then on that of
    /// Region::whole (m).
    std::array<std::array<vec2, max_actuators>, 2> charts_{};
    std::array<double, region_count> pitch_{};
};

/// Checks the actuators. The error names the actuator and the fault: none, too many, two in one place, a
/// part on the wrong side of the body.
Expected<Layout> make_layout(std::string name, Torso torso, std::vector<Actuator> actuators);

/// Reads a layout file. An error names file, line and key.
Expected<Layout> read_layout(const Config& file);
/// Reads a layout from a file of at most 64 KiB.
Expected<Layout> load_layout(const std::filesystem::path& path);

}  // namespace thaum::tactile

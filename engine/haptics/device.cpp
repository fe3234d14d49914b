#include "haptics/device.h"

#include <algorithm>
#include <array>

#include "core/text.h"

namespace thaum::haptics {
namespace {

void report(const ConfigTable& table, const char* key, std::string_view message) {
    table.report(key, text("'", key, "' ", message));
}

void read_freedom(const ConfigTable& table, DeviceSpec& spec) {
    constexpr std::array degrees{0, 3, 6, 7};
    const auto read = [&table, &degrees](const char* key) {
        const auto value = static_cast<int>(table.integer(key, {0, 7}));
        if (std::find(degrees.begin(), degrees.end(), value) == degrees.end())
            report(table, key, "must be 3, 6 or 7; 'actuated' may also be 0 for a device without forces");
        return value;
    };
    spec.sensed = read("sensed");
    spec.actuated = read("actuated");
    if (spec.sensed == 0)
        report(table, "sensed", "must not be 0, because every device measures its position: give 3, 6 or 7");
    if (spec.actuated > spec.sensed) report(table, "actuated", "must not be above 'sensed'");
}

void read_force(const ConfigTable& table, DeviceSpec& spec) {
    spec.peak_force = table.number("peak_n", {0.01, 1000});
    spec.continuous_force = table.number("continuous_n", {0.01, 1000});
    spec.max_stiffness = table.number("max_stiffness_n_per_m", {1, 1e6});
    spec.max_damping = table.number("max_damping_n_s_per_m", {0, 1e4});
    if (spec.continuous_force > spec.peak_force) report(table, "continuous_n", "must not be above 'peak_n'");
}

void read_motion(const ConfigTable& table, DeviceSpec& spec) {
    spec.workspace = table.vector("workspace_m", {0.001, 10});
    spec.position_quantum = table.number("position_quantum_m", {0, 0.01});
    spec.update_rate = table.number("update_rate_hz", {10, 100'000});
    spec.latency = static_cast<int>(table.integer("latency_ticks", {0, max_latency}));
    const double shortest = std::min({spec.workspace.x, spec.workspace.y, spec.workspace.z});
    // Smallest quantum that is accepted (m). Position over quantum is a count of the encoder, which must be
    // exact in the 53 bits of a double.
    constexpr double min_quantum = 1e-9;
    if (spec.position_quantum > 0 && spec.position_quantum < min_quantum)
        report(table, "position_quantum_m", text("must be 0 or at least ", min_quantum));
    if (spec.position_quantum > shortest / 10)
        report(table, "position_quantum_m", "must be at most a tenth of the workspace's shortest edge");
}

void read_mechanism(const ConfigTable& table, DeviceSpec& spec) {
    spec.mass = table.number("mass_kg", {0.01, 100});
    spec.damping = table.number("damping_n_s_per_m", {0, 100});
    spec.coulomb_friction = table.number("coulomb_friction_n", {0, 100});
    if (spec.coulomb_friction >= spec.peak_force)
        report(table, "coulomb_friction_n", "must be below 'peak_n', or friction would hide every force");
}

}  // namespace

Expected<DeviceSpec> read_device(const Config& file) {
    DeviceSpec spec;
    const auto root = file.root();
    spec.name = root.string("name");
    if (spec.name.empty()) report(root, "name", "must not be empty: name the device");
    read_freedom(root.table("degrees_of_freedom"), spec);
    read_force(root.table("force"), spec);
    read_motion(root.table("motion"), spec);
    read_mechanism(root.table("mechanism"), spec);
    if (auto checked = file.check(); !checked) return std::move(checked.error());
    return spec;
}

}  // namespace thaum::haptics

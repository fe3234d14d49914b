// Fuzzes the reader of device files. An accepted file must make a simulated device that keeps its limits.
#include <algorithm>

#include "core/file.h"
#include "fuzz/fuzz.h"
#include "haptics/simulated.h"

namespace thaum::fuzz {
namespace {

std::vector<std::string> shipped_devices(const Places& places) {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(places.assets / "devices"))
        files.push_back(entry.path());
    std::sort(files.begin(), files.end());  // sorted, because the order of a directory listing is undefined
    std::vector<std::string> result;
    for (const auto& file : files) {
        if (auto content = read_text_file(file, 1U << 20U)) result.push_back(std::move(*content));
    }
    return result;
}

bool keeps_its_limits(const haptics::SimulatedDevice& device) {
    auto state = haptics::resting_at({});
    for (int tick = 0; tick < 200; ++tick) {
        const double way = tick % 20 < 10 ? 100 : -100;
        state = haptics::step(device, state, {way, -way, 0}, {0, 1e6 * way, -way});
        if (!is_finite(state.position) || !is_finite(state.velocity) ||
            !is_finite(measured_position(device, state)))
            return false;
        if (glm::length(state.force) > device.peak_force * (1 + 1e-12)) return false;
        if (glm::any(glm::greaterThan(glm::abs(state.position), device.reach))) return false;
    }
    return true;
}

Outcome read_device_file(const std::string& input, const Places&) {
    const auto config = Config::parse(input, "device.toml", 1);
    if (!config) return {.refusal = config.error().message};
    const auto spec = haptics::read_device(*config);
    if (!spec) return {.refusal = spec.error().message};
    for (const auto& hand : {haptics::Hand{}, haptics::no_hand}) {
        if (!keeps_its_limits(haptics::simulated_device(*spec, hand)))
            return {.accepted = true, .fault = "the simulated device leaves its limits"};
    }
    return {.accepted = true};
}

}  // namespace

const Reader device_reader{"device", shipped_devices, mutate_text, read_device_file};

}  // namespace thaum::fuzz

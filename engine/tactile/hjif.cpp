#include "tactile/hjif.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/text.h"

namespace thaum::tactile {
namespace {

using Values = nlohmann::ordered_json;

/// Names of the standard for a part of the body.
Values body_part_target(Part part) {
    switch (part) {
        case Part::front: return {"Chest", "Front"};
        case Part::back: return {"Chest", "Back"};
        case Part::shoulder_left: return {"Upper-arm", "Left", "Top"};
        case Part::shoulder_right: return {"Upper-arm", "Right", "Top"};
        case Part::arm_left: return {"Arm", "Left"};
        case Part::arm_right: return {"Arm", "Right"};
        case Part::whole: break;
    }
    return {"All"};
}

Values keyframe(Tick at, double amplitude, double hz) {
    return {{"relative_position", at},
            {"amplitude_modulation", std::round(amplitude * 1e4) / 1e4},
            {"frequency_modulation", static_cast<int>(std::lround(hz))}};
}

/// One effect for each run of frames in which the actuator is on.
Values effects_of(std::span<const TactileFrame> frames, std::size_t actuator) {
    auto effects = Values::array();
    for (std::size_t f = 0; f < frames.size(); ++f) {
        if (frames[f].amplitude[actuator] == 0) continue;
        const Tick begin = frames[f].tick;
        auto keyframes = Values::array();
        double hz = 0;
        for (; f < frames.size() && frames[f].amplitude[actuator] > 0; ++f) {
            hz = static_cast<double>(frames[f].carrier_hz[actuator]);
            keyframes.push_back(
                keyframe(frames[f].tick - begin, static_cast<double>(frames[f].amplitude[actuator]), hz));
        }
        keyframes.push_back(keyframe(frames[f - 1].tick - begin + frame_ticks, 0, hz));
        effects.push_back({{"effect_type", "Basis"},
                           {"position", begin - frames.front().tick},
                           {"phase", 0.0},
                           {"base_signal", "Sine"},
                           {"keyframes", keyframes}});
    }
    return effects;
}

Values channel_of(const Layout& layout, std::span<const TactileFrame> frames, std::size_t actuator) {
    const auto& a = layout.actuators[actuator];
    const Values band{{"band_type", "VectorialWave"},
                      {"lower_frequency_limit", static_cast<int>(std::floor(a.lowest_hz))},
                      {"upper_frequency_limit", static_cast<int>(std::ceil(a.highest_hz))},
                      {"effects", effects_of(frames, actuator)}};
    return {{"id", actuator},
            {"description", a.name},
            {"gain", 1.0},
            {"mixing_coefficient", 1.0},
            {"body_part_mask", 0},
            {"reference_device_id", 0},
            {"body_part_target", body_part_target(a.place.part)},
            {"bands", Values::array({band})}};
}

}  // namespace

std::string export_hjif(const Layout& layout, std::span<const TactileFrame> frames,
                        std::string_view description, std::string_view date) {
    auto channels = Values::array();
    for (std::size_t i = 0; i < layout.actuators.size(); ++i)
        channels.push_back(channel_of(layout, frames, i));
    const Values perception{{"id", 0},
                            {"avatar_id", 0},
                            {"description", std::string(description)},
                            {"perception_modality", "Vibrotactile"},
                            {"unit_exponent", -3},
                            {"perception_unit_exponent", 0},
                            {"reference_devices", Values::array({{{"id", 0}, {"name", layout.name}}})},
                            {"effect_library", Values::array()},
                            {"channels", channels}};
    const Values root{{"version", "2023"},
                      {"profile", "Main"},
                      {"level", 1},
                      {"date", std::string(date)},
                      {"description", std::string(description)},
                      {"timescale", ticks_per_second},
                      {"avatars", Values::array()},
                      {"perceptions", Values::array({perception})},
                      {"syncs", Values::array()}};
    return root.dump(-1, ' ', false, Values::error_handler_t::replace);
}

}  // namespace thaum::tactile

#include "tactile/hjif.h"

#include <cmath>

#include "core/json.h"

namespace thaum::tactile {
namespace {

/// Names of the standard for a part of the body.
Json body_part_target(Part part) {
    switch (part) {
        case Part::front: return Json::array({"Chest", "Front"});
        case Part::back: return Json::array({"Chest", "Back"});
        case Part::shoulder_left: return Json::array({"Upper-arm", "Left", "Top"});
        case Part::shoulder_right: return Json::array({"Upper-arm", "Right", "Top"});
        case Part::arm_left: return Json::array({"Arm", "Left"});
        case Part::arm_right: return Json::array({"Arm", "Right"});
        case Part::whole: break;
    }
    return Json::array({"All"});
}

Json keyframe(Tick at, double amplitude, double hz) {
    return {{"relative_position", at},
            {"amplitude_modulation", std::round(amplitude * 1e4) / 1e4},
            {"frequency_modulation", static_cast<int>(std::lround(hz))}};
}

/// One effect for each run of frames in which the actuator is on.
Json effects_of(std::span<const TactileFrame> frames, std::size_t actuator) {
    auto effects = Json::array();
    for (std::size_t f = 0; f < frames.size(); ++f) {
        if (frames[f].amplitude[actuator] == 0) continue;
        const Tick begin = frames[f].tick;
        auto keyframes = Json::array();
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

Json channel_of(const Layout& layout, std::span<const TactileFrame> frames, std::size_t actuator) {
    const auto& a = layout.actuators[actuator];
    const Json band{{"band_type", "VectorialWave"},
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
            {"bands", Json::array({band})}};
}

}  // namespace

std::string export_hjif(const Layout& layout, std::span<const TactileFrame> frames,
                        std::string_view description, std::string_view date) {
    auto channels = Json::array();
    for (std::size_t i = 0; i < layout.actuators.size(); ++i)
        channels.push_back(channel_of(layout, frames, i));
    const Json perception{{"id", 0},
                          {"avatar_id", 0},
                          {"description", std::string(description)},
                          {"perception_modality", "Vibrotactile"},
                          {"unit_exponent", -3},
                          {"perception_unit_exponent", 0},
                          {"reference_devices", Json::array({{{"id", 0}, {"name", layout.name}}})},
                          {"effect_library", Json::array()},
                          {"channels", channels}};
    const Json root{{"version", "2023"},
                    {"profile", "Main"},
                    {"level", 1},
                    {"date", std::string(date)},
                    {"description", std::string(description)},
                    {"timescale", ticks_per_second},
                    {"avatars", Json::array()},
                    {"perceptions", Json::array({perception})},
                    {"syncs", Json::array()}};
    return dump(root);
}

}  // namespace thaum::tactile

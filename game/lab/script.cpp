#include "game/lab/script.h"

namespace thaum::game::inline lab {

vec3 place_to_pour(const LabState& lab, const std::optional<vec3>& ladle) {
    return ladle.value_or(vec3(0.3, -0.3, 0) * lab.basin.radius);
}

LabInput scripted_input(const LabScript& script, const LabState& lab) {
    LabInput input{.ladle = ladle_at(script.path, lab.basin, lab.seconds() + lab_dt)};
    for (const auto& pour : script.pours) {
        if (pour.step == lab.steps)
            input.pours.push_back({pour.substance, pour.amount, place_to_pour(lab, input.ladle)});
    }
    return input;
}

}  // namespace thaum::game::inline lab

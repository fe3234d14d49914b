// game/lab/script.h: scripted lab input: a path for the ladle, and the substances poured at given steps.
#pragma once
#include "game/lab/lab.h"
#include "game/lab/stir_path.h"

namespace thaum::game {

struct LabScript {
    struct Pour {
        std::int64_t step{};  ///< step that is computed right after the pour
        std::size_t substance{};
        double amount{};  ///< volume (m^3)
    };
    StirPath path{};
    std::vector<Pour> pours{};
};

/// Input of the next step. Substances are poured at the ladle or, without a ladle, beside the middle.
LabInput scripted_input(const LabScript& script, const LabState& lab);

/// Place where a substance is poured (m, brew).
vec3 place_to_pour(const LabState& lab, const std::optional<vec3>& ladle);

}  // namespace thaum::game

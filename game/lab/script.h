// game/lab/script.h: scripted lab input: a path for the ladle, and the substances poured at given steps.
#pragma once
#include "game/lab/lab.h"
#include "game/lab/stir_path.h"

namespace thaum::game::inline lab {

struct LabScript {
    struct Pour {
        std::int64_t step{};  ///< number of the step just before which the substance is poured
        std::size_t substance{};
        double amount{};  ///< volume poured (m^3)
    };
    StirPath path{};
    std::vector<Pour> pours{};
};

/// Input of the next step. Substances are poured at the ladle, or beside the middle while the ladle is out of
/// the brew.
LabInput scripted_input(const LabScript& script, const LabState& lab);

/// Position at which a substance is poured (m, brew frame).
vec3 place_to_pour(const LabState& lab, const std::optional<vec3>& ladle);

}  // namespace thaum::game::inline lab

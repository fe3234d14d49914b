// game/lab/script.h: what is done in the lab without hands: a path to stir on, and what is poured when.
#pragma once
#include "game/lab/lab.h"
#include "game/lab/stir_path.h"

namespace thaum::game {

struct LabScript {
    struct Pour {
        std::int64_t step{};  ///< before which it is poured
        std::size_t substance{};
        double amount{};  ///< m^3
    };
    StirPath path{};
    std::vector<Pour> pours{};
};

/// Of the step that comes next. What is poured goes in where the ladle is, or beside the middle where there is none.
LabInput scripted_input(const LabScript& script, const LabState& lab);

/// m, where something is poured in.
vec3 place_to_pour(const LabState& lab, const std::optional<vec3>& ladle);

}  // namespace thaum::game

// game/lab/controls.h: what of the lab is changed by keys. One list: keys and the list on the screen go by it.
#pragma once
#include <span>
#include <string>
#include <string_view>

#include "game/lab/lab.h"

namespace thaum::game {

/// What a person at the lab has in hand.
struct LabHands {
    LabSettings settings{};  ///< as they shall be
    std::size_t chosen{};    ///< substance that is poured and changed
    bool arrows = false, streamlines = false;
    bool paused = false;
    bool list = true;  ///< of the keys is shown
};

struct LabControl {
    std::string_view less, more;  ///< names of keys; `less` is empty where one key goes round
    std::string_view label;
    std::string (*shown)(const LabHands&, const CauldronRules&){};
    void (*turn)(LabHands&, const CauldronRules&, int way){};  ///< -1 or 1; what cannot go further stays
};

std::span<const LabControl> lab_controls();

/// True where the key is one of the list's.
bool turn_control(std::string_view key, LabHands& hands, const CauldronRules& rules);

}  // namespace thaum::game

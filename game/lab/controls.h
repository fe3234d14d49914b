// game/lab/controls.h: the keys of the fluid lab, and the settings that they change. One table defines both
// the keys and the list of keys on the screen.
#pragma once
#include <span>
#include <string>
#include <string_view>

#include "game/lab/lab.h"

namespace thaum::game::inline lab {

/// Settings that the person at the lab wants, and what that person has chosen to see.
struct LabHands {
    LabSettings settings{};  ///< settings as wanted; the next step applies them
    std::size_t chosen{};    ///< index of the substance that keys pour and change
    bool arrows = false, streamlines = false;
    bool paused = false;
    bool list = true;  ///< true: the list of keys is shown
};

struct LabControl {
    std::string_view less, more;  ///< names of the keys; `less` is empty if one key cycles through all values
    std::string_view label;
    std::string (*shown)(const LabHands&, const CauldronRules&){};
    /// Changes the setting by one step down (`way` -1) or up (1). A value at its limit stays unchanged.
    void (*turn)(LabHands&, const CauldronRules&, int way){};
};

std::span<const LabControl> lab_controls();

/// Changes the setting that belongs to a key. Returns false if no control has the key.
bool turn_control(std::string_view key, LabHands& hands, const CauldronRules& rules);

}  // namespace thaum::game::inline lab

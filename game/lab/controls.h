// game/lab/controls.h: the lab's keys and the settings they change. One table defines both the keys and the
// list on the screen.
#pragma once
#include <span>
#include <string>
#include <string_view>

#include "game/lab/lab.h"

namespace thaum::game::inline lab {

/// Settings and choices of the person who uses the lab.
struct LabHands {
    LabSettings settings{};  ///< wanted settings; the next step applies them
    std::size_t chosen{};    ///< index of the substance that keys pour and change
    bool arrows = false, streamlines = false;
    bool paused = false;
    bool list = true;  ///< true: the list of keys is shown
};

struct LabControl {
    std::string_view less, more;  ///< names of the keys; `less` is empty if one key cycles through all values
    std::string_view label;
    std::string (*shown)(const LabHands&, const CauldronRules&){};
    /// changes the setting; way -1: less, 1: more; at its limit a value stays unchanged
    void (*turn)(LabHands&, const CauldronRules&, int way){};
};

std::span<const LabControl> lab_controls();

/// Changes the setting of this key. Returns false if no control has the key.
bool turn_control(std::string_view key, LabHands& hands, const CauldronRules& rules);

}  // namespace thaum::game::inline lab

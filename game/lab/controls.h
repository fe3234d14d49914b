// game/lab/controls.h: the lab's keys and the settings they change. One list serves both the keys and the
// list on the screen.
#pragma once
#include <span>
#include <string>
#include <string_view>

#include "game/lab/lab.h"

namespace thaum::game {

/// State of the lab that a person controls.
struct LabHands {
    LabSettings settings{};  ///< wanted settings; the next step applies them
    std::size_t chosen{};    ///< index of the substance that is poured and changed
    bool arrows = false, streamlines = false;
    bool paused = false;
    bool list = true;  ///< true: the list of keys is shown
};

struct LabControl {
    std::string_view less, more;  ///< names of keys; `less` is empty if one key cycles through all values
    std::string_view label;
    std::string (*shown)(const LabHands&, const CauldronRules&){};
    /// way -1: less, 1: more; a value at its limit stays
    void (*turn)(LabHands&, const CauldronRules&, int way){};
};

std::span<const LabControl> lab_controls();

/// Turns the control with this key. Returns false if no control has the key.
bool turn_control(std::string_view key, LabHands& hands, const CauldronRules& rules);

}  // namespace thaum::game

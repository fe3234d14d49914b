// render/detail/pad_places.h: the places of pads in the window's list. A pad that is unplugged and comes back gets its
// place again, in whatever order several pads come back. Pads of one model cannot be told apart: the first one that
// comes back gets the first of their places.
#pragma once
#include <array>
#include <string>
#include <vector>

namespace thaum::render {

struct PluggedPad {
    int id{};  ///< number of the window system, which it gives to another pad once this one is unplugged
    std::string model{};  ///< identification of the model, equal for all pads of a model
};

struct PadPlace {
    int id = -1;          ///< pad in this place; -1: none
    std::string model{};  ///< model of the last pad in this place; empty: there was none
};
using PadPlaces = std::array<PadPlace, 4>;

/// Frees the places of unplugged pads and gives places to new ones: the place that such a pad had, else one that no pad
/// had, else any free place.
void place_pads(PadPlaces& places, const std::vector<PluggedPad>& plugged);

}  // namespace thaum::render

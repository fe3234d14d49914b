// input/detail/pad_places.h: the places of pads in the reader's list. A pad that is unplugged and comes back gets its
// place again, in whatever order several pads come back. Pads of one model cannot be told apart: the first one that
// comes back gets the first of their places.
#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace thaum::input {

struct PluggedPad {
    std::int32_t id{};    ///< SDL's number, which no other pad ever gets, nor this one when it comes back
    std::string model{};  ///< identification of the model, equal for all pads of a model
};

struct PadPlace {
    std::int32_t id = -1;  ///< pad in this place; -1: none
    std::string model{};   ///< model of the last pad in this place; empty: there was none
};
using PadPlaces = std::array<PadPlace, 4>;

/// Frees the places of unplugged pads and gives places to new ones: the place that such a pad had, else one that no pad
/// had, else any free place.
void place_pads(PadPlaces& places, const std::vector<PluggedPad>& plugged);

}  // namespace thaum::input

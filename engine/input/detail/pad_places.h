// input/detail/pad_places.h: the places of pads in PadReader's list. A pad that is unplugged and plugged in
// again gets its old place, in whatever order several pads return. Pads of one model cannot be told apart:
// the first one that comes back gets the first of their places.
#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace thaum::input {

struct PluggedPad {
    /// SDL's instance number: no other pad ever gets it, and this pad gets another one when it is plugged in
    /// again.
    std::int32_t id{};
    std::string model{};  ///< identification of the model, equal for all pads of a model
};

struct PadPlace {
    std::int32_t id = -1;  ///< SDL's number of the pad in this place; -1: none
    std::string model{};   ///< model of the last pad in this place; empty: there never was one
};
using PadPlaces = std::array<PadPlace, 4>;

/// Frees the places of unplugged pads and gives places to new ones: the place that such a pad had, else one
/// that no pad had, else any free place.
void place_pads(PadPlaces& places, const std::vector<PluggedPad>& plugged);

}  // namespace thaum::input

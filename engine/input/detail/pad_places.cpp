#include "input/detail/pad_places.h"

#include <algorithm>

namespace thaum::input {
namespace {

bool is_plugged(const PadPlace& place, const std::vector<PluggedPad>& plugged) {
    return std::any_of(plugged.begin(), plugged.end(),
                       [&](const PluggedPad& pad) { return pad.id == place.id; });
}

/// A free place in the list of pads whose last pad was of this model; null: none.
PadPlace* free_place_of(PadPlaces& places, const std::string& model) {
    const auto found = std::find_if(places.begin(), places.end(), [&](const PadPlace& place) {
        return place.id < 0 && place.model == model;
    });
    return found == places.end() ? nullptr : &*found;
}

}  // namespace

void place_pads(PadPlaces& places, const std::vector<PluggedPad>& plugged) {
    for (auto& place : places) {
        if (!is_plugged(place, plugged)) place.id = -1;
    }
    for (const auto& pad : plugged) {
        const bool placed = std::any_of(places.begin(), places.end(),
                                        [&](const PadPlace& place) { return place.id == pad.id; });
        if (placed) continue;
        auto* place = free_place_of(places, pad.model);
        if (place == nullptr) place = free_place_of(places, {});
        if (place == nullptr) {
            const auto any =
                std::find_if(places.begin(), places.end(), [](const PadPlace& p) { return p.id < 0; });
            if (any != places.end()) place = &*any;
        }
        if (place != nullptr) *place = {pad.id, pad.model};
    }
}

}  // namespace thaum::input

// fluid/detail/split.h: divides a loop over layers, or over other numbered items, among the threads of a team
// (core/team.h).
#pragma once
#include <algorithm>

#include "core/team.h"
#include "fluid/lattice.h"

namespace thaum::fluid {

/// Slices of a range of numbers, such as those of all layers. Without helpers there is one slice, so a loop
/// that is divided must give the same bits however it is divided.
struct Split {
    int count;   ///< number of layers, or of other items over which the loop runs
    int slices;  ///< number of slices of almost equal length

    /// Divides into at most `most` slices. With more slices the threads finish at more nearly the same time,
    /// but taking each slice costs some time.
    Split(const Team& team, int number, int most = 12)
        : count(number), slices(team.has_helpers() ? std::min(number, most) : 1) {}

    Layers operator[](int slice) const { return {count * slice / slices, count * (slice + 1) / slices}; }
};

/// Calls body(layers, seat) for each slice; the seat is the number of the thread in the team (Team::each).
template <class Body>
void each_slice(Team& team, const Split& split, Body&& body) {
    team.each(split.slices, [&](int slice, unsigned seat) { body(split[slice], seat); });
}

/// Calls body(layer, seat) for each layer by itself, as a range of one. Several passes over a layer then
/// find it in the cache.
template <class Body>
void each_single(Team& team, const Split& split, Body&& body) {
    each_slice(team, split, [&](Layers layers, unsigned seat) {
        for (int layer = layers.first; layer < layers.end; ++layer) body(Layers{layer, layer + 1}, seat);
    });
}

}  // namespace thaum::fluid

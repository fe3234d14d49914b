#include "fluid/lattice.h"

namespace thaum::fluid {
namespace {

/// Layers of ghosts across one axis: where a layer is copied from, and by which factor.
struct Mirror {
    int to, from;
    float factor;
};

/// The layers across an axis of n cells.
std::vector<Mirror> mirrors_of(int n, Edge edge, Beyond beyond) {
    std::vector<Mirror> result;
    for (int layer = 1; layer <= ghosts; ++layer) {
        if (edge == Edge::periodic) {
            // Of few cells the same one stands several times in the ghosts.
            const int low = ((-layer) % n + n) % n;
            result.push_back({-layer, low, 1});
            result.push_back({n - 1 + layer, (layer - 1) % n, 1});
            continue;
        }
        const float factor = beyond == Beyond::even ? 1.0F : -1.0F;
        // Mirrored at the wall; of fewer cells than ghosts the last one goes on.
        const int inward = std::min(layer - 1, n - 1);
        if (beyond == Beyond::through_wall) {
            result.push_back({-layer, std::min(layer, n), factor});
            if (layer > 1) result.push_back({n + layer - 1, std::max(n - layer + 1, 0), factor});
        } else {
            result.push_back({-layer, inward, factor});
            result.push_back({n - 1 + layer, n - 1 - inward, factor});
        }
    }
    return result;
}

}  // namespace
}  // namespace thaum::fluid

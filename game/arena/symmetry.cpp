#include "game/arena/symmetry.h"

namespace thaum::game::inline arena {

Symmetry read_symmetry(const ConfigTable& table) {
    const bool mirror = table.boolean("mirror", false);
    const bool turned = table.boolean("turned", false);
    if (mirror && turned) table.report("turned", "'mirror' and 'turned' exclude each other; remove one");
    if (mirror) return Symmetry::mirror;
    return turned ? Symmetry::turned : Symmetry::none;
}

vec3 twin_place(Symmetry symmetry, vec3 place) {
    switch (symmetry) {
        case Symmetry::mirror: return {place.x, place.y, -place.z};
        case Symmetry::turned: return {-place.x, place.y, -place.z};
        case Symmetry::none: break;
    }
    return place;
}

}  // namespace thaum::game::inline arena

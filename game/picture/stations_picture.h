// game/picture/stations_picture.h: one moment of a wizard's work at cauldron, orb and crystals, as plain
// data.
#pragma once
#include <string_view>

#include "game/picture/recipe_picture.h"
#include "game/picture/station_picture.h"

namespace thaum::game::inline picture {

struct StationsPicture {
    std::string_view carries{};  ///< name of the ingredient that the wizard carries; empty: none
    fvec3 carried_colour{};      ///< colour of the ingredient that the wizard carries (linear light)
    IngredientShape carried_shape{};
    RecipePicture recipe;  ///< next step at the cauldron; for a player who stirs or can start to
    bool refilled{};       ///< true while stirring refills the wands
    bool stirs{};          ///< true if the player holds a ladle and stirs
    bool at_rim{};         ///< true if the player can start to stir
    bool misses_rim{};     ///< true if the player presses the button Stir a few steps away from the rim
    ScryingPicture scrying;
    CarvingPicture carving;
    bool work_half{};  ///< true if the wizard holds Azoth, the half of the Great Work that is brewed
    WorkPicture work;

    /// Whether the wizard stirs, scries or carves. The hand then moves no wand.
    bool works() const { return stirs || scrying.scries || carving.carves; }
};

}  // namespace thaum::game::inline picture

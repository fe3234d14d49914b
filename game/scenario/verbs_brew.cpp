// Verbs (functions of scenario scripts) for the cauldron's brew and the players who stir it.
#include "game/components/cauldron.h"
#include "game/scenario/detail/part.h"
#include "game/scenario/detail/verb.h"

namespace thaum::game::inline scenario {
namespace {

namespace arg = arguments;
using arg::fault;

const Cauldron& cauldron_of(const Play& play) {
    if (world_of(play).count<Cauldron>() == 0) fault("this match has no cauldron");
    return world_of(play).single<Cauldron>();
}

/// Adds to the table on Lua's stack the list of ingredients in the brew, such as {"ember", "salt"}.
void set_contents(lua_State* lua, const Play& play, const Cauldron& cauldron) {
    lua_newtable(lua);
    lua_Integer count = 0;
    for (const auto ingredient : cauldron.contents) {
        if (ingredient == no_ingredient) continue;
        const auto& name = ingredient_name(play, ingredient);
        lua_pushlstring(lua, name.data(), name.size());
        lua_rawseti(lua, -2, ++count);
    }
    lua_setfield(lua, -2, "contents");
}

int verb_brew(lua_State* lua, void* context) {
    const auto& play = began(context);
    const auto& cauldron = cauldron_of(play);
    lua_createtable(lua, 0, 11);
    arg::set_number(lua, "speed", cauldron.speed);
    arg::set_number(lua, "mixing", cauldron.mixing);
    arg::set_number(lua, "reached", cauldron.reached);
    arg::set_number(lua, "viscosity", cauldron.viscosity);
    arg::set_number(lua, "density", cauldron.density);
    arg::set_place(lua, "middle", cauldron.middle);
    if (cauldron.owner < players) arg::set_number(lua, "owner", cauldron.owner + 1);
    arg::set_flag(lua, "asleep", cauldron.step_running == 0 && cauldron.surface_asleep != 0);
    set_contents(lua, play, cauldron);
    return 1;
}

int verb_current(lua_State* lua, void* context) {
    const auto& play = began(context);
    const auto place = arg::place(lua, 1, "place", farthest);
    arg::push_place(lua, current_at(play, place));
    return 1;
}

int verb_surface(lua_State* lua, void* context) {
    const auto& play = began(context);
    const auto place = arg::place(lua, 1, "place", farthest);
    cauldron_of(play);
    lua_pushnumber(lua, surface_at(play, place));
    return 1;
}

constexpr VerbName names[] = {
    {"brew", verb_brew},
    {"current", verb_current},
    {"surface", verb_surface},
};

}  // namespace

std::span<const VerbName> brew_verbs() { return names; }

}  // namespace thaum::game::inline scenario

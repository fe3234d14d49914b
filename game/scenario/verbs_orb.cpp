// Verbs (functions of scenario scripts) for wizards who scry, which is to feel the flow inside the orb.
#include "game/components/orb.h"
#include "game/data/orb_rules.h"
#include "game/scenario/detail/part.h"
#include "game/scenario/detail/verb.h"

namespace thaum::game::inline scenario {
namespace {

namespace arg = arguments;

/// Adds to the table on Lua's stack the list of active modes by name, the oldest first.
void set_modes(lua_State* lua, const Play& play, const WornModes& modes) {
    lua_newtable(lua);
    lua_Integer count = 0;
    const auto& known = orb_rules_of(play)->modes;
    for (const auto mode : modes.worn) {
        if (mode >= known.size()) continue;
        const auto& name = known[mode].name;
        lua_pushlstring(lua, name.data(), name.size());
        lua_rawseti(lua, -2, ++count);
    }
    lua_setfield(lua, -2, "modes");
}

/// Verb: state of a wizard's work at the orb; nil if the wizard does not work there.
int verb_scrying(lua_State* lua, void* context) {
    const auto& play = began(context);
    const auto player = arg::player(lua, 1);
    const auto wizard = wizard_entity(play, player);
    const auto* scrying = world_of(play).find<Scrying>(wizard);
    if (scrying == nullptr) {
        lua_pushnil(lua);
        return 1;
    }
    lua_createtable(lua, 0, 7);
    arg::set_place(lua, "place", scrying->place);
    arg::set_place(lua, "force", scrying->force);
    arg::set_number(lua, "distance", scrying->distance);
    arg::set_flag(lua, "near", scrying->near_since != 0);
    arg::set_flag(lua, "drawing", scrying->drawing != 0);
    set_modes(lua, play, part<WornModes>(play, player));
    return 1;
}

/// Verb: the orb's hidden core, the axis of its strongest vortex, in the device frame of a wizard who works
/// at the orb: the point nearest to the orb's middle, and the direction.
int verb_core(lua_State* lua, void* context) {
    const auto& play = began(context);
    const auto core = core_in_hand(play, arg::player(lua, 1));
    if (!core) arg::fault("this wizard does not scry");
    arg::push_place(lua, core->place);
    arg::push_place(lua, core->axis);
    return 2;
}

/// Verb: strength of a haptic mode at a value of its property (N), as the wizard has drawn it, or else as the
/// rules give it. The mode is given by its key.
int verb_curve(lua_State* lua, void* context) {
    const auto& play = began(context);
    const auto player = arg::player(lua, 1);
    const auto* rules = orb_rules_of(play);
    if (rules == nullptr) arg::fault("this match has no orb");
    const auto count = static_cast<double>(rules->modes.size());
    const auto mode = static_cast<std::size_t>(arg::integer(lua, 2, "the mode's key", {1, count})) - 1;
    const double property = arg::number(lua, 3, "the property", {-1e6, 1e6});
    lua_pushnumber(lua, part<WornModes>(play, player).strength[mode](property));
    return 1;
}

constexpr VerbName orb_list[] = {
    {"raw_scrying", verb_scrying},
    {"raw_core", verb_core},
    {"raw_curve", verb_curve},
};

}  // namespace

std::span<const VerbName> orb_verbs() { return orb_list; }

}  // namespace thaum::game::inline scenario

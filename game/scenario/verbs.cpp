// Verbs (functions of scenario scripts) for the match, the hands and the wizards. Those for things and
// reports are in their own files.
#include "game/scenario/verbs.h"

#include <algorithm>
#include <cmath>

#include "game/components/casting.h"
#include "game/components/cauldron.h"
#include "game/components/free_hand.h"
#include "game/components/hand_state.h"
#include "game/data/wand_slots.h"
#include "game/match/haptic_setup.h"
#include "game/match/own_gestures.h"
#include "game/match/player/walk.h"
#include "game/match/simulation.h"
#include "game/scenario/detail/part.h"
#include "game/scenario/detail/prelude.h"
#include "game/scenario/detail/verb.h"
#include "game/scenario/match_options.h"
#include "game/scenario/script_arm.h"

namespace thaum::game::inline scenario {
namespace {

namespace arg = arguments;
using arg::fault;
using arg::Options;
using input::Button;

struct ButtonName {
    std::string_view name;
    Button button;
};
constexpr ButtonName button_names[] = {
    {"fire", Button::fire},
    {"jump", Button::jump},
    {"next_wand", Button::next_wand},
    {"pause", Button::pause},
    {"previous_wand", Button::previous_wand},
    {"trace", Button::trace},
    {"stir", Button::stir},
    {"throw", Button::throw_},
    {"clutch", Button::clutch},
    {"panic", Button::panic},
    {"rejoin", Button::rejoin},
    {"mark", Button::mark},
    {"confirm", Button::confirm},
};

// ---- the match --------------------------------------------------------------------------------------------

/// Name or level of the bot that plays; empty for the script.
std::string read_player(lua_State* lua, int index) {
    constexpr std::string_view bot = "bot ";
    const auto who = arg::string(lua, index, "players");
    if (who == "script") return {};
    if (!who.starts_with(bot) || who.size() == bot.size())
        fault("players: '", who, "' is neither \"script\" nor \"bot NAME\" or \"bot LEVEL\"");
    return who.substr(bot.size());
}

void read_players(lua_State* lua, int index, MatchOptions& wanted) {
    if (!lua_istable(lua, index)) fault("players must be a list of two");
    index = lua_absindex(lua, index);
    for (std::size_t i = 0; i < players; ++i) {
        lua_rawgeti(lua, index, static_cast<lua_Integer>(i) + 1);
        wanted.bot[i] = read_player(lua, -1);
    }
}

void read_overrides(lua_State* lua, int index, MatchOptions& wanted) {
    if (!lua_istable(lua, index)) fault("set must be a list of \"FILE.KEY=VALUE\"");
    index = lua_absindex(lua, index);
    const auto count = std::min<lua_Unsigned>(lua_rawlen(lua, index), 100);
    for (lua_Unsigned i = 1; i <= count; ++i) {
        lua_rawgeti(lua, index, static_cast<lua_Integer>(i));
        wanted.data.overrides.push_back(arg::string(lua, -1, "set"));
        lua_pop(lua, 1);
    }
}

void read_percents(lua_State* lua, int index, const char* name, MatchOptions::Percents& percents) {
    if (!lua_istable(lua, index)) fault(name, " must be a list of percentages");
    index = lua_absindex(lua, index);
    for (std::size_t i = 0; i < players; ++i) {
        lua_rawgeti(lua, index, static_cast<lua_Integer>(i) + 1);
        if (!lua_isnil(lua, -1))
            percents[i] = static_cast<std::uint32_t>(arg::integer(lua, -1, name, {0, 100}));
        lua_pop(lua, 1);
    }
}

/// Reads the shares (%) of the forces that a stirred brew has on the hand, from a table such as {flow = 0,
/// wall = 50}.
void read_modes_of(lua_State* lua, int index,
                   std::array<std::optional<std::uint32_t>, input::fluid_faders>& percents) {
    if (!lua_istable(lua, index)) fault("modes must be a list of tables such as {flow = 0}");
    index = lua_absindex(lua, index);
    for (lua_pushnil(lua); lua_next(lua, index) != 0; lua_pop(lua, 1)) {
        const auto name =
            lua_type(lua, -2) == LUA_TSTRING ? arg::string(lua, -2, "a mode") : std::string("a list");
        const auto found = std::ranges::find(haptics::fluid_modes, name, &haptics::FluidMode::name);
        if (found == haptics::fluid_modes.end()) fault("modes: there is no '", name, "'");
        percents[static_cast<std::size_t>(found - haptics::fluid_modes.begin())] =
            static_cast<std::uint32_t>(arg::integer(lua, -1, name, {0, 100}));
    }
}

void read_modes(lua_State* lua, int index, MatchOptions& wanted) {
    if (!lua_istable(lua, index)) fault("modes must be a list of tables such as {flow = 0}");
    index = lua_absindex(lua, index);
    for (std::size_t i = 0; i < players; ++i) {
        lua_rawgeti(lua, index, static_cast<lua_Integer>(i) + 1);
        if (!lua_isnil(lua, -1)) read_modes_of(lua, -1, wanted.modes[i]);
        lua_pop(lua, 1);
    }
}

void read_flags(lua_State* lua, int index, const char* name, std::array<bool, players>& flags) {
    if (!lua_istable(lua, index)) fault(name, " must be a list of true and false");
    index = lua_absindex(lua, index);
    for (std::size_t i = 0; i < players; ++i) {
        lua_rawgeti(lua, index, static_cast<lua_Integer>(i) + 1);
        flags[i] = lua_toboolean(lua, -1) != 0;
        lua_pop(lua, 1);
    }
}

void read_arms(lua_State* lua, int index, MatchOptions& wanted) {
    read_flags(lua, index, "arms", wanted.arm);
    for (std::size_t i = 0; i < players; ++i) {
        if (wanted.arm[i] && !wanted.bot[i].empty()) fault("player ", i + 1, " is a bot, and holds no arm");
    }
}

/// Reads a list of positions such as {{0, 0}, {1, 2}}.
std::vector<vec3> read_places(lua_State* lua, int index, const std::string& name) {
    constexpr lua_Unsigned max_places = 1000;
    if (!lua_istable(lua, index)) fault("gestures: '", name, "' must be a list of places {x, y}");
    index = lua_absindex(lua, index);
    const auto count = lua_rawlen(lua, index);
    if (count < 2 || count > max_places)
        fault("gestures: '", name, "' must have 2 to ", max_places, " places");
    std::vector<vec3> places(count);
    for (lua_Unsigned i = 0; i < count; ++i) {
        lua_rawgeti(lua, index, static_cast<lua_Integer>(i) + 1);
        if (!lua_istable(lua, -1)) fault("gestures: '", name, "' must be a list of places {x, y}");
        for (int axis = 0; axis < 2; ++axis) {
            lua_rawgeti(lua, -1, axis + 1);
            places[i][axis] = arg::number(lua, -1, name, {-1000, 1000});
            lua_pop(lua, 1);
        }
        lua_pop(lua, 1);
    }
    return places;
}

/// A stroke along positions at constant speed, one second long.
std::vector<gesture::StrokePoint> stroke_along(const std::vector<vec3>& places) {
    constexpr double points = 100;
    double length = 0;
    for (std::size_t i = 1; i < places.size(); ++i) length += glm::distance(places[i - 1], places[i]);
    std::vector<gesture::StrokePoint> stroke;
    double before = 0;
    for (std::size_t i = 1; i < places.size(); ++i) {
        const double way = glm::distance(places[i - 1], places[i]);
        const double steps = std::max(1.0, std::round(points * way / std::max(length, 1e-9)));
        for (double k = 0; k < steps; ++k)
            stroke.push_back({(before + way * k / steps) / std::max(length, 1e-9),
                              glm::mix(places[i - 1], places[i], k / steps), 1});
        before += way;
    }
    stroke.push_back({1, places.back(), 1});
    return stroke;
}

/// Reads recorded gestures of the players: a list of tables such as {circle = {{0, 0}, {1, 2}}}.
void read_gestures(lua_State* lua, int index, MatchOptions& wanted) {
    if (!lua_istable(lua, index)) fault("gestures must be a list of tables, one for each player");
    index = lua_absindex(lua, index);
    for (std::uint32_t player = 0; player < players; ++player) {
        lua_rawgeti(lua, index, static_cast<lua_Integer>(player) + 1);
        if (lua_isnil(lua, -1)) {
            lua_pop(lua, 1);
            continue;
        }
        if (!lua_istable(lua, -1)) fault("gestures: player ", player + 1, " has no table");
        for (lua_pushnil(lua); lua_next(lua, -2) != 0; lua_pop(lua, 1)) {
            if (lua_type(lua, -2) != LUA_TSTRING) fault("gestures: a name is missing");
            gesture::Gesture own{.name = arg::string(lua, -2, "a gesture"), .options = {}, .strokes = {}};
            own.options = {.rotation = 0.3, .planar = true, .gentle_below = 1, .harsh_above = 1.5};
            own.strokes.push_back(stroke_along(read_places(lua, -1, own.name)));
            wanted.profile.push_back(profile_of(own, player));
        }
        lua_pop(lua, 1);
    }
}

int verb_match(lua_State* lua, void* context) {
    auto& play = *static_cast<Play*>(context);
    if (play.match) fault("match{...} stands once in a scenario");
    const Options options(lua, 1, "match",
                          {"arena", "rules", "match", "seed", "set", "players", "forces", "weights", "blows",
                           "modes", "arms", "gestures", "free_casting"});
    MatchOptions wanted;
    if (options.has("arena")) wanted.data.arena = arg::string(lua, -1, "arena");
    if (options.has("rules")) wanted.data.rules = arg::string(lua, -1, "rules");
    if (options.has("match")) wanted.data.match = arg::string(lua, -1, "match");
    if (options.has("seed"))
        wanted.seed = static_cast<std::uint64_t>(arg::integer(lua, -1, "seed", {0, 1e15}));
    if (options.has("set")) read_overrides(lua, -1, wanted);
    if (options.has("players")) read_players(lua, -1, wanted);
    if (options.has("forces")) read_percents(lua, -1, "forces", wanted.force);
    if (options.has("weights")) read_percents(lua, -1, "weights", wanted.weight);
    if (options.has("blows")) read_percents(lua, -1, "blows", wanted.blows);
    if (options.has("modes")) read_modes(lua, -1, wanted);
    if (options.has("arms")) read_arms(lua, -1, wanted);
    if (options.has("free_casting")) read_flags(lua, -1, "free_casting", wanted.casts_freely);
    if (options.has("gestures")) read_gestures(lua, -1, wanted);
    if (const auto made = begin_match(play, wanted); !made) {
        play.match.reset();
        fault(made.error().message);
    }
    return 0;
}

int verb_wait(lua_State* lua, void* context) {
    auto& play = began(context);
    const auto count = arg::integer(lua, 1, "ticks", {0, 1e9});
    play.wait_until = play.match->now() + static_cast<Tick>(count);
    play.waits = true;
    return Sandbox::wait;
}

int verb_now(lua_State* lua, void* context) {
    lua_pushinteger(lua, static_cast<lua_Integer>(began(context).match->now()));
    return 1;
}

int verb_match_state(lua_State* lua, void* context) {
    const auto& match = began(context).match->match();
    lua_pushnumber(lua, seconds(match.played));
    lua_pushboolean(lua, match.paused != 0);
    lua_pushboolean(lua, match.phase != Phase::playing);
    lua_pushstring(lua, match.ending == Ending::kills        ? "kills"
                        : match.ending == Ending::time       ? "time"
                        : match.ending == Ending::great_work ? "great_work"
                        : match.ending == Ending::boil_over  ? "boil_over"
                                                             : "none");
    if (match.winner < players) {
        lua_pushinteger(lua, match.winner + 1);
    } else {
        lua_pushnil(lua);
    }
    lua_pushboolean(lua, match.phase == Phase::over);
    lua_pushinteger(lua, match.round + 1);
    for (const auto won : match.rounds_won) lua_pushinteger(lua, won);
    return 9;
}

int verb_fail(lua_State* lua, void*) { fault(arg::string(lua, 1, "message")); }

// ---- hands ------------------------------------------------------------------------------------------------

Hand& hand_of(Play& play, lua_State* lua) {
    const auto player = arg::player(lua, 1);
    if (!play.bot[player].empty()) fault("player ", player + 1, " is a bot: its hands are its own");
    return play.hands[player];
}

/// Number of the wand that a button "wand_1" to "wand_9" selects; 0 for other buttons.
std::uint8_t wand_of_button(std::string_view name) {
    constexpr std::string_view start = "wand_";
    if (!name.starts_with(start) || name.size() != start.size() + 1) return 0;
    const auto number = static_cast<std::uint8_t>(name.back() - '0');
    return number <= input::max_wands ? number : 0;
}

int verb_button(lua_State* lua, void* context) {
    auto& hand = hand_of(began(context), lua);
    const auto name = arg::string(lua, 2, "a button");
    if (const auto wand = wand_of_button(name); wand != 0) {
        const bool down = lua_toboolean(lua, 3) != 0;
        if (down || hand.wand == wand) hand.wand = down ? wand : std::uint8_t{0};
        return 0;
    }
    const auto found = std::find_if(std::begin(button_names), std::end(button_names),
                                    [&](const auto& b) { return b.name == name; });
    if (found == std::end(button_names)) fault("there is no button '", name, "'");
    const auto bit = static_cast<std::uint32_t>(found->button);
    hand.buttons = lua_toboolean(lua, 3) != 0 ? hand.buttons | bit : hand.buttons & ~bit;
    return 0;
}

int verb_move(lua_State* lua, void* context) {
    auto& hand = hand_of(began(context), lua);
    hand.strafe = static_cast<std::int32_t>(std::lround(127 * arg::number(lua, 2, "strafe", {-1, 1})));
    hand.forward = static_cast<std::int32_t>(std::lround(127 * arg::number(lua, 3, "forward", {-1, 1})));
    return 0;
}

int verb_trigger(lua_State* lua, void* context) {
    auto& hand = hand_of(began(context), lua);
    hand.trigger = static_cast<std::int32_t>(std::lround(255 * arg::number(lua, 2, "how far", {0, 1})));
    return 0;
}

int verb_fader(lua_State* lua, void* context) {
    auto& hand = hand_of(began(context), lua);
    const auto name = arg::string(lua, 2, "a fader");
    const auto& names = fader_names();
    const auto found = std::ranges::find(names, name);
    if (found == names.end()) fault("there is no fader '", name, "'");
    hand.changes.push_back({static_cast<std::uint8_t>(found - names.begin() + 1),
                            static_cast<std::uint8_t>(arg::integer(lua, 3, "the percentage", {0, 100}))});
    return 0;
}

// ---- arms -------------------------------------------------------------------------------------------------

ScriptArm& arm_of(Play& play, std::uint32_t player) {
    if (!play.arms[player]) fault("player ", player + 1, " holds no arm: match{arms = {true, ...}}");
    return *play.arms[player];
}

/// Largest coordinate that a script may give for the place of an arm's tip (m, device frame).
constexpr double arm_reach = 0.3;
/// Longest time for which a script may stop the match (s). After a longer one the match would skip device
/// samples.
constexpr double longest_stall = 0.25;

int verb_reach(lua_State* lua, void* context) {
    auto& arm = arm_of(began(context), arg::player(lua, 1));
    arm.to = arg::place(lua, 2, "place", arm_reach);
    arm.step = lua_isnoneornil(lua, 3) ? 0 : arg::number(lua, 3, "speed", {1e-6, 100}) * tick_seconds;
    return 0;
}

int verb_told(lua_State* lua, void* context) {
    arg::push_place(lua, arm_of(began(context), arg::player(lua, 1)).told);
    return 1;
}

int verb_stall(lua_State* lua, void* context) {
    auto& play = began(context);
    const auto count = arg::integer(lua, 1, "ticks", {0, longest_stall / tick_seconds});
    if (play.behind != 0) fault("stall: the match has not made up for the last one yet");
    stall(play, static_cast<Tick>(count));
    return 0;
}

int verb_look(lua_State* lua, void* context) {
    auto& hand = hand_of(began(context), lua);
    hand.look_right = static_cast<std::int32_t>(arg::integer(lua, 2, "look right", {-1e6, 1e6}));
    hand.look_up = static_cast<std::int32_t>(arg::integer(lua, 3, "look up", {-1e6, 1e6}));
    return 0;
}

int verb_counts_to(lua_State* lua, void* context) {
    const auto& play = began(context);
    const auto player = arg::player(lua, 1);
    const auto counts = counts_to(play, player, arg::place(lua, 2, "target", 2 * farthest));
    lua_pushinteger(lua, counts.right);
    lua_pushinteger(lua, counts.up);
    return 2;
}

int verb_counts_of(lua_State* lua, void* context) {
    const auto& play = began(context);
    const auto step = play.match->setup().devices[arg::player(lua, 1)].look_rad_per_count;
    const double degrees = arg::number(lua, 2, "degrees", {-720, 720});
    lua_pushinteger(lua, std::lround(degrees * radians_per_degree / step));
    return 1;
}

// ---- wizards ----------------------------------------------------------------------------------------------

using ReadWizard = void (*)(lua_State*, const Play&, std::uint32_t player);

struct WizardReader {
    std::string_view name;
    ReadWizard read;
};

vec3 centre(const Play& play, std::uint32_t player) { return part<Motion>(play, player).position; }

/// Pushes the last reading of the player's strokes: gesture, force (N), turns, probability. If no gesture was
/// recognised, its name is missing.
void push_reading(lua_State* lua, const Play& play, std::uint32_t player) {
    const auto& reading = part<LastReading>(play, player);
    lua_createtable(lua, 0, 5);
    arg::set_number(lua, "at", static_cast<double>(reading.at));
    arg::set_number(lua, "force", reading.force);
    arg::set_number(lua, "turns", reading.turns);
    arg::set_number(lua, "probability", reading.probability);
    const auto* gestures = gestures_of(play.match->context(), player);
    const auto name = gestures == nullptr ? std::string_view() : gestures->name(reading.gesture);
    if (reading.at == 0 || name.empty()) return;
    arg::set_text(lua, "gesture", name);
}

/// Pushes the results of free casting (without a button): `cast_at`, and for a near miss `missed_at` (ticks,
/// 0: never), `like` (a gesture), `probability` and `reason`.
void push_free_casting(lua_State* lua, const Play& play, std::uint32_t player) {
    constexpr std::array reasons{"none", "unclear", "too fast", "too small", "too soon"};
    const auto& world = world_of(play);
    const auto wizard = wizard_of(world, player);
    const auto* hand = world.find<FreeHand>(wizard);
    const auto* miss = world.find<NearMiss>(wizard);
    if (hand == nullptr || miss == nullptr)
        fault("player ", player + 1, " does not cast freely: free_casting = {true, ...}");
    lua_createtable(lua, 0, 5);
    arg::set_number(lua, "cast_at", static_cast<double>(hand->cast_at));
    arg::set_number(lua, "missed_at", static_cast<double>(miss->at));
    arg::set_number(lua, "probability", miss->probability);
    const auto* gestures = gestures_of(play.match->context(), player);
    const auto name = miss->at == 0 ? std::string_view() : gestures->name(miss->gesture);
    arg::set_text(lua, "like", name);
    lua_pushstring(lua, reasons.at(static_cast<std::size_t>(miss->reason)));
    lua_setfield(lua, -2, "reason");
}

/// Pushes the potions that act on the player, each with the time left (s), and `work_half`. This tells
/// whether the player holds Azoth, one half of the Great Work, which wins a round.
void push_potions(lua_State* lua, const Play& play, std::uint32_t player) {
    const auto& effects = part<Effects>(play, player);
    const auto played = play.match->match().played;
    lua_newtable(lua);
    for (const auto& recipe : play.data->recipes)
        if (const auto end = end_of(recipe.effects, effects); played < end)
            arg::set_number(lua, recipe.name.c_str(), seconds(end - played));
    arg::set_flag(lua, "work_half", part<WorkHalf>(play, player).held != 0);
}

/// Harm that the wizard's shield can still absorb (HP).
double ward(const Play& play, std::uint32_t player) {
    const auto& health = part<Health>(play, player);
    return play.match->match().played < health.ward_until ? health.ward : 0;
}

bool is_shielded(const Play& play, std::uint32_t player) {
    return play.match->match().played < part<Health>(play, player).shielded_until;
}

double energy(const Play& play, std::uint32_t player) {
    return energy_in_hand(*play.data, part<WandBelt>(play, player));
}

bool is_dead(const Play& play, std::uint32_t player) {
    return world_of(play).has<Dead>(wizard_entity(play, player));
}

bool stirs(const Play& play, std::uint32_t player) {
    return world_of(play).has<Ladle>(wizard_entity(play, player));
}

const Ladle& ladle(const Play& play, std::uint32_t player) {
    if (!stirs(play, player)) fault("wizard ", player + 1, " does not stir");
    return part<Ladle>(play, player);
}

constexpr WizardReader wizard_readers[] = {
    {"position",
     [](lua_State* lua, const Play& p, std::uint32_t i) {
         arg::push_place(lua, centre(p, i) - vec3(0, p.data->wizard.height / 2, 0));
     }},
    {"centre", [](lua_State* lua, const Play& p, std::uint32_t i) { arg::push_place(lua, centre(p, i)); }},
    {"eye", [](lua_State* lua, const Play& p,
               std::uint32_t i) { arg::push_place(lua, eye_of(p.data->wizard, centre(p, i))); }},
    {"velocity", [](lua_State* lua, const Play& p,
                    std::uint32_t i) { arg::push_place(lua, part<Motion>(p, i).velocity); }},
    {"yaw",
     [](lua_State* lua, const Play& p, std::uint32_t i) { lua_pushnumber(lua, part<Gaze>(p, i).yaw); }},
    {"pitch",
     [](lua_State* lua, const Play& p, std::uint32_t i) { lua_pushnumber(lua, part<Gaze>(p, i).pitch); }},
    {"health",
     [](lua_State* lua, const Play& p, std::uint32_t i) { lua_pushnumber(lua, part<Health>(p, i).points); }},
    {"energy", [](lua_State* lua, const Play& p, std::uint32_t i) { lua_pushnumber(lua, energy(p, i)); }},
    {"shots", [](lua_State* lua, const Play& p,
                 std::uint32_t i) { lua_pushinteger(lua, part<WandBelt>(p, i).fired); }},
    {"readiness",
     [](lua_State* lua, const Play& p, std::uint32_t i) { lua_pushnumber(lua, readiness(p, i)); }},
    // The device in its own frame (x right, y up, z to the user): tip position (m), output force (N), and
    // reason for a reduced force.
    {"hand", [](lua_State* lua, const Play& p,
                std::uint32_t i) { arg::push_place(lua, part<HandState>(p, i).device.position); }},
    {"force", [](lua_State* lua, const Play& p,
                 std::uint32_t i) { arg::push_place(lua, part<HandState>(p, i).servo.safety.output); }},
    // Largest energy that passive sources, forces which must create no energy, have created so far (J): the
    // energy that they gave to the hand beyond what hand and world gave to them.
    {"created",
     [](lua_State* lua, const Play& p, std::uint32_t i) {
         lua_pushnumber(lua, part<HandState>(p, i).servo.energy.most_created);
     }},
    {"force_cause",
     [](lua_State* lua, const Play& p, std::uint32_t i) {
         lua_pushstring(lua, haptics::safety_cause_names[part<HandState>(p, i).servo.safety.cause].data());
     }},
    {"kills",
     [](lua_State* lua, const Play& p, std::uint32_t i) { lua_pushinteger(lua, part<Score>(p, i).kills); }},
    {"deaths",
     [](lua_State* lua, const Play& p, std::uint32_t i) { lua_pushinteger(lua, part<Score>(p, i).deaths); }},
    {"dead", [](lua_State* lua, const Play& p, std::uint32_t i) { lua_pushboolean(lua, is_dead(p, i)); }},
    {"stirs", [](lua_State* lua, const Play& p, std::uint32_t i) { lua_pushboolean(lua, stirs(p, i)); }},
    // The ladle of a player who stirs: position (m), velocity (m/s), and force on the brew (N).
    {"ladle",
     [](lua_State* lua, const Play& p, std::uint32_t i) { arg::push_place(lua, ladle(p, i).place); }},
    {"ladle_velocity",
     [](lua_State* lua, const Play& p, std::uint32_t i) { arg::push_place(lua, ladle(p, i).velocity); }},
    {"ladle_force",
     [](lua_State* lua, const Play& p, std::uint32_t i) { arg::push_place(lua, ladle(p, i).force); }},
    {"grounded", [](lua_State* lua, const Play& p,
                    std::uint32_t i) { lua_pushboolean(lua, part<Stance>(p, i).grounded != 0); }},
    {"focus",
     [](lua_State* lua, const Play& p, std::uint32_t i) { lua_pushnumber(lua, part<Focus>(p, i).points); }},
    {"ward", [](lua_State* lua, const Play& p, std::uint32_t i) { lua_pushnumber(lua, ward(p, i)); }},
    {"reading", push_reading},
    {"free_casting", push_free_casting},
    {"potions", push_potions},
    {"shielded",
     [](lua_State* lua, const Play& p, std::uint32_t i) { lua_pushboolean(lua, is_shielded(p, i)); }},
};

int verb_read_wizard(lua_State* lua, void* context) {
    const auto& play = began(context);
    const auto player = arg::player(lua, 1);
    const auto name = arg::string(lua, 2, "what to read");
    for (const auto& reader : wizard_readers) {
        if (reader.name == name) return reader.read(lua, play, player), 1;
    }
    fault("a wizard has no '", name, "'");
}

int verb_place_wizard(lua_State* lua, void* context) {
    auto& play = began(context);
    const auto player = arg::player(lua, 1);
    const auto feet = arg::place(lua, 2, "place", farthest);
    if (is_dead(play, player)) fault("wizard ", player + 1, " is dead");
    scene_is_set(play);
    const auto wizard = wizard_entity(play, player);
    auto& world = play.match->world_to_change();
    world.get<Motion>(wizard) = standing_at(play.data->wizard, feet);
    world.get<Stance>(wizard) = {};
    play.match->physics().set_state(wizard.index, std::as_const(world).get<Motion>(wizard));
    return 0;
}

int verb_face(lua_State* lua, void* context) {
    auto& play = began(context);
    const auto player = arg::player(lua, 1);
    const double limit = play.data->wizard.pitch_limit / radians_per_degree;
    const Gaze gaze{arg::number(lua, 2, "yaw", {-180, 180}) * radians_per_degree,
                    arg::number(lua, 3, "pitch", {-limit, limit}) * radians_per_degree};
    scene_is_set(play);
    play.match->world_to_change().get<Gaze>(wizard_entity(play, player)) = gaze;
    return 0;
}

constexpr VerbName match_verbs[] = {
    {"match", verb_match},
    {"raw_wait", verb_wait},
    {"now", verb_now},
    {"raw_match", verb_match_state},
    {"fail", verb_fail},
    {"raw_button", verb_button},
    {"raw_trigger", verb_trigger},
    {"raw_fader", verb_fader},
    {"raw_move", verb_move},
    {"raw_look", verb_look},
    {"raw_reach", verb_reach},
    {"raw_told", verb_told},
    {"raw_stall", verb_stall},
    {"raw_counts_to", verb_counts_to},
    {"raw_counts_of", verb_counts_of},
    {"raw_read", verb_read_wizard},
    {"raw_place", verb_place_wizard},
    {"raw_face", verb_face},
};

}  // namespace

Expected<void> add_verbs(Sandbox& sandbox, Play& play) {
    for (const auto list : {std::span<const VerbName>(match_verbs), thing_verbs(), report_verbs(),
                            brew_verbs(), casting_verbs(), crystal_verbs(), orb_verbs(), sense_verbs()}) {
        for (const auto& [name, verb] : list) sandbox.add(name, verb, &play);
    }
    return sandbox.run_prelude(prelude);
}

}  // namespace thaum::game::inline scenario

#include "game/scenario/verbs.h"

#include <algorithm>
#include <set>

#include "ecs/diff.h"
#include "game/arena/spawn.h"
#include "game/player/walk.h"
#include "game/scenario/detail/arguments.h"
#include "game/scenario/detail/prelude.h"

namespace thaum::game {
namespace {

namespace arg = arguments;
using arg::fault;
using arg::Options;
using input::Button;

// What the physics can bear, whatever a script asks for.
constexpr double farthest = 500;  ///< m
constexpr double fastest = 200;   ///< m/s
constexpr std::size_t most_things = 48;
constexpr std::size_t most_states = 64;
constexpr std::size_t most_pictures = 16;
constexpr std::size_t most_traces = 8;
constexpr std::size_t most_sought = 64;

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
    {"wand_1", Button::wand_1},
    {"wand_2", Button::wand_2},
    {"wand_3", Button::wand_3},
    {"wand_4", Button::wand_4},
    {"wand_5", Button::wand_5},
    {"mark", Button::mark},
    {"confirm", Button::confirm},
};

Play& began(void* context) {
    auto& play = *static_cast<Play*>(context);
    if (!play.match) fault("there is no match yet: match{...} comes first");
    return play;
}

const ecs::World& world_of(const Play& play) { return play.match->world(); }

template <class C>
const C& part(const Play& play, std::uint32_t player) {
    return world_of(play).get<C>(wizard_entity(play, player));
}

// ---- the match ---------------------------------------------------------------------------------------------------------

int read_player(lua_State* lua, int index) {
    const auto who = arg::string(lua, index, "players");
    if (who == "script") return 0;
    const std::string_view level =
        who.starts_with("bot ") ? std::string_view(who).substr(4) : std::string_view();
    if (level.size() != 1 || level[0] < '1' || level[0] > '9') {
        fault("players: '", who, "' is neither \"script\" nor \"bot LEVEL\"");
    }
    return level[0] - '0';
}

void read_players(lua_State* lua, int index, MatchWish& wish) {
    if (!lua_istable(lua, index)) fault("players must be a list of two");
    index = lua_absindex(lua, index);
    for (std::size_t i = 0; i < players; ++i) {
        lua_rawgeti(lua, index, static_cast<lua_Integer>(i + 1));
        wish.bot_level[i] = read_player(lua, -1);
    }
}

void read_overrides(lua_State* lua, int index, MatchWish& wish) {
    if (!lua_istable(lua, index)) fault("set must be a list of \"FILE.KEY=VALUE\"");
    index = lua_absindex(lua, index);
    const auto count = std::min<lua_Unsigned>(lua_rawlen(lua, index), 100);
    for (lua_Unsigned i = 1; i <= count; ++i) {
        lua_rawgeti(lua, index, static_cast<lua_Integer>(i));
        wish.data.overrides.push_back(arg::string(lua, -1, "set"));
        lua_pop(lua, 1);
    }
}

int verb_match(lua_State* lua, void* context) {
    auto& play = *static_cast<Play*>(context);
    if (play.match) fault("match{...} stands once in a scenario");
    const Options options(lua, 1, "match", {"arena", "rules", "seed", "set", "players"});
    MatchWish wish;
    if (options.has("arena")) wish.data.arena = arg::string(lua, -1, "arena");
    if (options.has("rules")) wish.data.rules = arg::string(lua, -1, "rules");
    if (options.has("seed")) wish.seed = static_cast<std::uint64_t>(arg::integer(lua, -1, "seed", {0, 1e15}));
    if (options.has("set")) read_overrides(lua, -1, wish);
    if (options.has("players")) read_players(lua, -1, wish);
    if (const auto made = begin_match(play, wish); !made) {
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
    lua_pushboolean(lua, match.phase == Phase::over);
    lua_pushstring(lua, match.ending == Ending::kills  ? "kills"
                        : match.ending == Ending::time ? "time"
                                                       : "none");
    if (match.winner < players) {
        lua_pushinteger(lua, match.winner + 1);
    } else {
        lua_pushnil(lua);
    }
    return 5;
}

int verb_fail(lua_State* lua, void*) { fault(arg::string(lua, 1, "message")); }

// ---- hands -------------------------------------------------------------------------------------------------------------

Hand& hand_of(Play& play, lua_State* lua) {
    const auto player = arg::player(lua, 1);
    if (play.bot_level[player] != 0) fault("player ", player + 1, " is a bot: its hands are its own");
    return play.hands[player];
}

int verb_button(lua_State* lua, void* context) {
    auto& hand = hand_of(began(context), lua);
    const auto name = arg::string(lua, 2, "a button");
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

// ---- wizards -----------------------------------------------------------------------------------------------------------

using ReadWizard = void (*)(lua_State*, const Play&, std::uint32_t player);

struct WizardReader {
    std::string_view name;
    ReadWizard read;
};

vec3 centre(const Play& play, std::uint32_t player) { return part<Motion>(play, player).position; }

bool is_shielded(const Play& play, std::uint32_t player) {
    return play.match->match().played < part<Health>(play, player).shielded_until;
}

double energy(const Play& play, std::uint32_t player) {
    const auto& belt = part<WandBelt>(play, player);
    return belt.energy[belt.selected];
}

bool is_dead(const Play& play, std::uint32_t player) {
    return world_of(play).has<Dead>(wizard_entity(play, player));
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
    {"kills",
     [](lua_State* lua, const Play& p, std::uint32_t i) { lua_pushinteger(lua, part<Score>(p, i).kills); }},
    {"deaths",
     [](lua_State* lua, const Play& p, std::uint32_t i) { lua_pushinteger(lua, part<Score>(p, i).deaths); }},
    {"dead", [](lua_State* lua, const Play& p, std::uint32_t i) { lua_pushboolean(lua, is_dead(p, i)); }},
    {"grounded", [](lua_State* lua, const Play& p,
                    std::uint32_t i) { lua_pushboolean(lua, part<Stance>(p, i).grounded != 0); }},
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

// ---- things ------------------------------------------------------------------------------------------------------------

constexpr Range extent{0.02, 5};

void read_shape(lua_State* lua, const Options& options, physics::BodyDesc& body) {
    options.need("kind");
    const auto kind = arg::string(lua, -1, "kind");
    if (kind == "box") {
        body.shape = physics::Shape::box;
        options.need("size");
        body.size = arg::place(lua, -1, "size", extent.high) * 0.5;
        if (glm::min(body.size.x, glm::min(body.size.y, body.size.z)) < extent.low / 2) {
            fault("size: each must be at least ", extent.low);
        }
        return;
    }
    if (kind != "sphere" && kind != "cylinder") fault("kind '", kind, "' is none of box, sphere, cylinder");
    options.need("radius");
    body.size = {arg::number(lua, -1, "radius", extent), 0, 0};
    body.shape = physics::Shape::sphere;
    if (kind == "sphere") return;
    options.need("height");
    body.size.y = arg::number(lua, -1, "height", extent) / 2;
    body.shape = physics::Shape::cylinder;
}

Surface read_surface(lua_State* lua) {
    const auto name = arg::string(lua, -1, "surface");
    const auto found = std::find(surface_names.begin(), surface_names.end(), name);
    if (found == surface_names.end()) fault("there is no surface '", name, "'");
    return static_cast<Surface>(found - surface_names.begin());
}

Thing read_thing(lua_State* lua, const Options& options) {
    Thing thing;
    thing.prop = true;
    thing.surface = Surface::crate;
    read_shape(lua, options, thing.body);
    options.need("mass");
    thing.body.mass = arg::number(lua, -1, "mass", {0.01, 10000});
    options.need("at");
    thing.position = arg::place(lua, -1, "at", farthest);
    thing.body.friction = options.has("friction") ? arg::number(lua, -1, "friction", {0, 2}) : 0.8;
    thing.body.restitution = options.has("restitution") ? arg::number(lua, -1, "restitution", {0, 1}) : 0.1;
    thing.body.layer = layer::prop;
    if (thing.body.shape != physics::Shape::box) thing.body.rolling_friction = 0.01;
    if (options.has("surface")) thing.surface = read_surface(lua);
    return thing;
}

int verb_spawn(lua_State* lua, void* context) {
    auto& play = began(context);
    const Options options(
        lua, 1, "spawn",
        {"kind", "size", "radius", "height", "mass", "at", "velocity", "surface", "friction", "restitution"});
    if (play.things.size() == most_things) fault("there are ", most_things, " things already");
    const auto thing = read_thing(lua, options);
    const vec3 velocity = options.has("velocity") ? arg::place(lua, -1, "velocity", fastest) : vec3(0);
    scene_is_set(play);
    const auto entity = spawn_thing(play.match->world_to_change(), thing);
    play.match->physics().set_velocity(entity.index, velocity);
    play.match->world_to_change().get<Motion>(entity).velocity = velocity;
    play.things.push_back({entity, thing.body.mass});
    lua_pushinteger(lua, static_cast<lua_Integer>(play.things.size()));
    return 1;
}

const SpawnedThing& thing_of(const Play& play, lua_State* lua) {
    const auto number = arg::integer(lua, 1, "a thing", {1, static_cast<double>(play.things.size())});
    return play.things[static_cast<std::size_t>(number - 1)];
}

const SpawnedThing& living_thing(const Play& play, lua_State* lua) {
    const auto& thing = thing_of(play, lua);
    if (!world_of(play).alive(thing.entity)) fault("that thing is gone");
    return thing;
}

int verb_thing_there(lua_State* lua, void* context) {
    const auto& play = began(context);
    lua_pushboolean(lua, world_of(play).alive(thing_of(play, lua).entity));
    return 1;
}

int verb_thing_position(lua_State* lua, void* context) {
    const auto& play = began(context);
    arg::push_place(lua, world_of(play).get<Motion>(living_thing(play, lua).entity).position);
    return 1;
}

int verb_thing_velocity(lua_State* lua, void* context) {
    const auto& play = began(context);
    arg::push_place(lua, world_of(play).get<Motion>(living_thing(play, lua).entity).velocity);
    return 1;
}

int verb_place_thing(lua_State* lua, void* context) {
    auto& play = began(context);
    const auto entity = living_thing(play, lua).entity;
    Motion motion;
    motion.position = arg::place(lua, 2, "place", farthest);
    if (!lua_isnoneornil(lua, 3)) motion.velocity = arg::place(lua, 3, "velocity", fastest);
    scene_is_set(play);
    play.match->world_to_change().get<Motion>(entity) = motion;
    play.match->physics().set_state(entity.index, motion);
    return 0;
}

int verb_push_thing(lua_State* lua, void* context) {
    auto& play = began(context);
    const auto& thing = living_thing(play, lua);
    const vec3 impulse = arg::place(lua, 2, "impulse", 1e6);
    if (glm::length(impulse) > fastest * thing.mass)
        fault("that impulse makes it faster than ", fastest, " m/s");
    scene_is_set(play);
    play.match->physics().apply_central_impulse(thing.entity.index, impulse);
    return 0;
}

int verb_clear_props(lua_State*, void* context) {
    auto& play = began(context);
    scene_is_set(play);
    auto& world = play.match->world_to_change();
    std::vector<ecs::Entity> props;
    world.view<Prop>().each([&](ecs::Entity e) { props.push_back(e); });
    for (const auto e : props) world.destroy(e);
    return 0;
}

// ---- events ------------------------------------------------------------------------------------------------------------

struct EventWish {
    std::optional<EventKind> kind;
    std::optional<std::uint32_t> subject, by;

    bool fits(const Event& e) const {
        return (!kind || e.kind == *kind) && (!subject || e.subject == *subject) && (!by || e.by == *by);
    }
};

EventKind read_kind(lua_State* lua, int index) {
    const auto name = arg::string(lua, index, "kind");
    const auto found = std::find(event_names.begin(), event_names.end(), name);
    if (found == event_names.end()) fault("there is no event '", name, "'");
    return static_cast<EventKind>(found - event_names.begin());
}

EventWish read_event_wish(lua_State* lua) {
    EventWish wish;
    if (lua_isnoneornil(lua, 1)) return wish;
    if (lua_type(lua, 1) == LUA_TSTRING) {
        wish.kind = read_kind(lua, 1);
        return wish;
    }
    const Options options(lua, 1, "events", {"kind", "subject", "by", "within"});
    if (options.has("kind")) wish.kind = read_kind(lua, -1);
    if (options.has("subject")) wish.subject = arg::player(lua, -1);
    if (options.has("by")) wish.by = arg::player(lua, -1);
    return wish;
}

void set_player(lua_State* lua, const char* key, std::uint32_t player) {
    if (player >= players) return;
    lua_pushinteger(lua, player + 1);
    lua_setfield(lua, -2, key);
}

void push_event(lua_State* lua, const Event& event) {
    lua_createtable(lua, 0, 7);
    lua_pushnumber(lua, seconds(event.tick));
    lua_setfield(lua, -2, "time");
    const auto name = event_names[static_cast<std::size_t>(event.kind)];
    lua_pushlstring(lua, name.data(), name.size());
    lua_setfield(lua, -2, "kind");
    lua_pushnumber(lua, event.amount);
    lua_setfield(lua, -2, "amount");
    lua_pushinteger(lua, event.detail);
    lua_setfield(lua, -2, "detail");
    arg::push_place(lua, event.place);
    lua_setfield(lua, -2, "place");
    set_player(lua, "subject", event.subject);
    set_player(lua, "by", event.by);
}

int verb_events(lua_State* lua, void* context) {
    const auto& play = began(context);
    const auto wish = read_event_wish(lua);
    lua_newtable(lua);
    lua_Integer count = 0;
    for (const auto& event : play.events) {
        if (!wish.fits(event)) continue;
        push_event(lua, event);
        lua_rawseti(lua, -2, ++count);
    }
    return 1;
}

int verb_next_event(lua_State* lua, void* context) {
    auto& play = began(context);
    const auto wish = read_event_wish(lua);
    for (auto i = play.events_expected; i < play.events.size(); ++i) {
        if (!wish.fits(play.events[i])) continue;
        play.events_expected = i + 1;
        push_event(lua, play.events[i]);
        return 1;
    }
    return 0;
}

// ---- states ------------------------------------------------------------------------------------------------------------

int verb_state(lua_State* lua, void* context) {
    auto& play = began(context);
    if (play.states.size() == most_states) fault("there are ", most_states, " states already");
    play.match->save(play.states.emplace_back());
    lua_pushinteger(lua, static_cast<lua_Integer>(play.states.size()));
    return 1;
}

const Bytes& state_at(const Play& play, lua_State* lua, int index) {
    const auto number = arg::integer(lua, index, "a state", {1, static_cast<double>(play.states.size())});
    return play.states[static_cast<std::size_t>(number - 1)];
}

void set_text(lua_State* lua, const char* key, const std::string& value) {
    lua_pushlstring(lua, value.data(), value.size());
    lua_setfield(lua, -2, key);
}

void push_difference(lua_State* lua, const ecs::Difference& d) {
    lua_createtable(lua, 0, 5);
    set_text(lua, "component", d.component);
    set_text(lua, "field", d.field);
    set_text(lua, "before", d.a);
    set_text(lua, "after", d.b);
    lua_pushinteger(lua, d.entity);
    lua_setfield(lua, -2, "entity");
}

int verb_changes(lua_State* lua, void* context) {
    const auto& play = began(context);
    const auto& before = state_at(play, lua, 1);
    Bytes now;
    if (lua_isnoneornil(lua, 2)) play.match->save(now);
    const auto& after = lua_isnoneornil(lua, 2) ? now : state_at(play, lua, 2);
    const auto found = ecs::diff(before, after, 1000);
    if (!found) fault(found.error().message);
    lua_newtable(lua);
    lua_Integer count = 0;
    for (const auto& d : *found) {
        push_difference(lua, d);
        lua_rawseti(lua, -2, ++count);
    }
    return 1;
}

// ---- files -------------------------------------------------------------------------------------------------------------

int verb_trace(lua_State* lua, void* context) {
    auto& play = began(context);
    Trace trace;
    trace.name = arg::plain_name(lua, 1, "name");
    if (!lua_istable(lua, 2)) fault("columns must be a list");
    if (play.traces.size() == most_traces) fault("there are ", most_traces, " traces already");
    trace.csv = "time_s";
    const auto count = std::min<lua_Unsigned>(lua_rawlen(lua, 2), 64);
    for (lua_Unsigned i = 1; i <= count; ++i) {
        lua_rawgeti(lua, 2, static_cast<lua_Integer>(i));
        const auto added = add_column(play, arg::string(lua, -1, "a column"), trace);
        if (!added) fault(added.error().message);
        lua_pop(lua, 1);
    }
    trace.csv += '\n';
    play.traces.push_back(std::move(trace));
    return 0;
}

/// The text by which the runner knows that only the picture function was missing.
constexpr std::string_view no_pictures = "no picture function here: this scenario needs one that draws";

std::filesystem::path picture_file(const Play& play, lua_State* lua, const Options& options) {
    if (!options.has("name") || !play.keeps_files || play.options->out.empty()) return {};
    return play.options->out / text(play.name, ".", arg::plain_name(lua, -1, "name"), ".png");
}

int verb_picture(lua_State* lua, void* context) {
    auto& play = began(context);
    const Options options(lua, 1, "picture", {"split", "name"});
    auto split = Split::side_by_side;
    if (options.has("split")) {
        const auto name = arg::string(lua, -1, "split");
        if (name != "side_by_side" && name != "top_bottom")
            fault("split '", name, "': side_by_side or top_bottom");
        if (name == "top_bottom") split = Split::top_bottom;
    }
    if (play.pictures.size() == most_pictures) fault("there are ", most_pictures, " pictures already");
    if (!play.options->take_picture) {
        play.no_picture = true;
        fault(no_pictures);
    }
    const auto file = picture_file(play, lua, options);
    auto pixels = play.options->take_picture(*play.match, split, file);
    if (!pixels) fault("picture: ", pixels.error().message);
    if (!file.empty()) play.files.push_back(file.filename().string());
    const auto bytes = static_cast<std::size_t>(pixels->width) * static_cast<std::size_t>(pixels->height) * 3;
    if (pixels->width <= 0 || pixels->height <= 0 || pixels->rgb.size() != bytes)
        fault("picture: it is empty");
    lua_pushinteger(lua, static_cast<lua_Integer>(play.pictures.size() + 1));
    lua_pushinteger(lua, pixels->width);
    lua_pushinteger(lua, pixels->height);
    play.pictures.push_back(std::move(*pixels));
    return 3;
}

/// A part of a picture, in pixels; never empty.
struct Area {
    const Pixels& pixels;
    int x0, y0, x1, y1;

    template <class Visit>
    void each(Visit visit) const {
        for (int y = y0; y < y1; ++y) {
            for (int x = x0; x < x1; ++x)
                visit(&pixels.rgb[static_cast<std::size_t>(3 * (y * pixels.width + x))]);
        }
    }
};

int pixel_at(double share, int size) { return std::clamp(static_cast<int>(share * size), 0, size - 1); }

Area read_area(const Play& play, lua_State* lua) {
    const auto number = arg::integer(lua, 1, "a picture", {1, static_cast<double>(play.pictures.size())});
    const auto& pixels = play.pictures[static_cast<std::size_t>(number - 1)];
    const Range share{0, 1};
    const int x0 = pixel_at(arg::number(lua, 2, "x0", share), pixels.width);
    const int y0 = pixel_at(arg::number(lua, 3, "y0", share), pixels.height);
    const int x1 = pixel_at(arg::number(lua, 4, "x1", share), pixels.width);
    const int y1 = pixel_at(arg::number(lua, 5, "y1", share), pixels.height);
    if (x1 < x0 || y1 < y0) fault("an area of a picture goes from its upper left to its lower right corner");
    return {pixels, x0, y0, x1 + 1, y1 + 1};
}

int verb_picture_mean(lua_State* lua, void* context) {
    const auto area = read_area(began(context), lua);
    std::array<double, 3> sum{};
    area.each([&](const std::uint8_t* rgb) {
        for (std::size_t i = 0; i < 3; ++i) sum[i] += rgb[i];
    });
    const double count = static_cast<double>(area.x1 - area.x0) * (area.y1 - area.y0);
    for (const double channel : sum) lua_pushnumber(lua, channel / count);
    return 3;
}

int verb_picture_colours(lua_State* lua, void* context) {
    const auto area = read_area(began(context), lua);
    std::set<std::uint32_t> colours;
    area.each([&](const std::uint8_t* rgb) { colours.insert(rgb[0] | (rgb[1] * 256U) | (rgb[2] * 65536U)); });
    lua_pushinteger(lua, static_cast<lua_Integer>(colours.size()));
    return 1;
}

// ---- checks ------------------------------------------------------------------------------------------------------------

void need_replayable(const Play& play, std::string_view verb) {
    if (play.scene_set)
        fault(verb, ": this scenario has set the scene itself, so its input alone does not lead here");
    if (play.match->now() == 0) fault(verb, ": nothing has been played yet");
}

std::uint64_t read_seed(lua_State* lua, const Options& options) {
    return options.has("seed") ? static_cast<std::uint64_t>(arg::integer(lua, -1, "seed", {0, 1e15})) : 1;
}

int verb_check_seek(lua_State* lua, void* context) {
    const auto& play = began(context);
    need_replayable(play, "check_seek");
    const Options options(lua, 1, "check_seek", {"ticks", "count", "seed"});
    const auto now = static_cast<double>(play.match->now());
    const Range most{0, static_cast<double>(most_sought)};
    std::vector<Tick> ticks;
    if (options.has("ticks")) {
        if (!lua_istable(lua, -1)) fault("ticks must be a list");
        const int list = lua_gettop(lua);
        const auto count = std::min<lua_Unsigned>(lua_rawlen(lua, list), most_sought);
        for (lua_Unsigned i = 1; i <= count; ++i) {
            lua_rawgeti(lua, list, static_cast<lua_Integer>(i));
            ticks.push_back(static_cast<Tick>(arg::integer(lua, -1, "a tick", {0, now})));
            lua_pop(lua, 1);
        }
    }
    auto random = random_stream(read_seed(lua, options), 0);
    const auto count = options.has("count") ? arg::integer(lua, -1, "count", most) : 0;
    for (std::int64_t i = 0; i < count; ++i) ticks.push_back(random.below(play.match->now() + 1));
    if (const auto found = check_seek(play, ticks); !found.empty()) fault(found);
    return 0;
}

int verb_check_late(lua_State* lua, void* context) {
    const auto& play = began(context);
    need_replayable(play, "check_late");
    const Options options(lua, 1, "check_late", {"seed"});
    if (const auto found = check_late(play, read_seed(lua, options)); !found.empty()) fault(found);
    return 0;
}

struct VerbName {
    const char* name;
    Sandbox::Verb verb;
};

/// Those that begin with raw_ are taken by the prelude, and gone when a script begins.
constexpr VerbName verbs[] = {
    {"match", verb_match},
    {"raw_wait", verb_wait},
    {"now", verb_now},
    {"raw_match", verb_match_state},
    {"fail", verb_fail},
    {"raw_button", verb_button},
    {"raw_move", verb_move},
    {"raw_look", verb_look},
    {"raw_counts_to", verb_counts_to},
    {"raw_counts_of", verb_counts_of},
    {"raw_read", verb_read_wizard},
    {"raw_place", verb_place_wizard},
    {"raw_face", verb_face},
    {"raw_spawn", verb_spawn},
    {"raw_thing_there", verb_thing_there},
    {"raw_thing_position", verb_thing_position},
    {"raw_thing_velocity", verb_thing_velocity},
    {"raw_thing_place", verb_place_thing},
    {"raw_thing_push", verb_push_thing},
    {"clear_props", verb_clear_props},
    {"events", verb_events},
    {"raw_next_event", verb_next_event},
    {"state", verb_state},
    {"changes", verb_changes},
    {"trace", verb_trace},
    {"raw_picture", verb_picture},
    {"raw_picture_mean", verb_picture_mean},
    {"raw_picture_colours", verb_picture_colours},
    {"check_seek", verb_check_seek},
    {"check_late", verb_check_late},
};

}  // namespace

Expected<void> add_verbs(Sandbox& sandbox, Play& play) {
    for (const auto& [name, verb] : verbs) sandbox.add(name, verb, &play);
    return sandbox.run_prelude(prelude);
}

}  // namespace thaum::game

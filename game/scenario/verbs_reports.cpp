// Verbs (functions of scenario scripts) that report on the match: events, states, traces, pictures, and
// checks of its input.
#include <algorithm>
#include <set>

#include "core/random.h"
#include "ecs/diff.h"
#include "game/components/body.h"
#include "game/components/fog.h"
#include "game/components/power_up.h"
#include "game/data/brew_words.h"
#include "game/scenario/detail/part.h"
#include "game/scenario/detail/verb.h"

namespace thaum::game::inline scenario {
namespace {

namespace arg = arguments;
using arg::fault;
using arg::Options;

constexpr std::size_t max_states = 64;
constexpr std::size_t max_pictures = 16;
constexpr std::size_t max_traces = 8;
constexpr std::size_t max_sought = 64;

// ---- events -----------------------------------------------------------------------------------------------

struct EventFilter {
    std::optional<EventKind> kind;
    std::optional<std::uint32_t> subject, by;

    bool fits(const Event& e) const {
        return (!kind || e.kind == *kind) && (!subject || e.subject == *subject) && (!by || e.by == *by);
    }
};

EventFilter read_event_filter(lua_State* lua) {
    EventFilter filter;
    if (lua_isnoneornil(lua, 1)) return filter;
    if (lua_type(lua, 1) == LUA_TSTRING) {
        filter.kind = read_kind(lua, 1);
        return filter;
    }
    const Options options(lua, 1, "events", {"kind", "subject", "by", "within"});
    if (options.has("kind")) filter.kind = read_kind(lua, -1);
    if (options.has("subject")) filter.subject = arg::player(lua, -1);
    if (options.has("by")) filter.by = arg::player(lua, -1);
    return filter;
}

void set_player(lua_State* lua, const char* key, std::uint32_t player) {
    if (player >= players) return;
    lua_pushinteger(lua, player + 1);
    lua_setfield(lua, -2, key);
}

/// Adds to the table on Lua's stack the names of a revealed recipe's ingredients in their order, as a list.
void set_ingredients(lua_State* lua, const Play& play, const Event& event) {
    const auto words = brew_words_of(*play.data);
    lua_newtable(lua);
    lua_Integer count = 0;
    for (const auto name : names_of_order(words, event.detail)) {
        lua_pushlstring(lua, name.data(), name.size());
        lua_rawseti(lua, -2, ++count);
    }
    lua_setfield(lua, -2, "ingredients");
}

void push_event(lua_State* lua, const Play& play, const Event& event) {
    lua_createtable(lua, 0, 9);
    const auto with = with_of(play, event);
    arg::set_text(lua, "with", with);
    arg::set_number(lua, "time", seconds(event.tick));
    const auto name = name_of(event.kind);
    arg::set_text(lua, "kind", name);
    arg::set_number(lua, "amount", event.amount);
    lua_pushinteger(lua, event.detail);
    lua_setfield(lua, -2, "detail");
    arg::set_place(lua, "place", event.place);
    set_player(lua, "subject", event.subject);
    set_player(lua, "by", event.by);
    if (event.kind == EventKind::recipe_told) set_ingredients(lua, play, event);
}

int verb_events(lua_State* lua, void* context) {
    const auto& play = began(context);
    const auto filter = read_event_filter(lua);
    lua_newtable(lua);
    lua_Integer count = 0;
    for (const auto& event : play.events) {
        if (!filter.fits(event)) continue;
        push_event(lua, play, event);
        lua_rawseti(lua, -2, ++count);
    }
    return 1;
}

int verb_next_event(lua_State* lua, void* context) {
    auto& play = began(context);
    const auto filter = read_event_filter(lua);
    for (auto i = play.events_expected; i < play.events.size(); ++i) {
        if (!filter.fits(play.events[i])) continue;
        play.events_expected = i + 1;
        push_event(lua, play, play.events[i]);
        return 1;
    }
    return 0;
}

int verb_power_ups(lua_State* lua, void* context) {
    const auto& play = began(context);
    const auto played = played_in(play);
    lua_newtable(lua);
    world_of(play).view<const PowerUp, const Motion>().each([&](const PowerUp& p, const Motion& motion) {
        lua_createtable(lua, 0, 4);
        const auto name = power_up_names[static_cast<std::size_t>(p.kind)];
        arg::set_text(lua, "kind", name);
        arg::set_place(lua, "place", motion.position);
        lua_pushboolean(lua, played >= p.back_at);
        lua_setfield(lua, -2, "there");
        arg::set_number(lua, "back_in", played >= p.back_at ? 0.0 : seconds(p.back_at - played));
        lua_rawseti(lua, -2, p.number + 1);
    });
    return 1;
}

int verb_fogs(lua_State* lua, void* context) {
    const auto& play = began(context);
    const auto played = played_in(play);
    lua_newtable(lua);
    lua_Integer count = 0;
    world_of(play).view<const Fog, const Motion>().each([&](const Fog& fog, const Motion& motion) {
        lua_createtable(lua, 0, 4);
        arg::set_place(lua, "place", motion.position);
        arg::set_number(lua, "radius", fog.radius);
        arg::set_number(lua, "left", fog.until > played ? seconds(fog.until - played) : 0.0);
        set_player(lua, "player", fog.player);
        lua_rawseti(lua, -2, ++count);
    });
    return 1;
}

int verb_missiles(lua_State* lua, void* context) {
    const auto& play = began(context);
    lua_newtable(lua);
    lua_Integer count = 0;
    for (const auto& missile : missiles_of(play)) {
        lua_createtable(lua, 0, 4);
        arg::set_place(lua, "position", missile.position);
        arg::set_place(lua, "velocity", missile.velocity);
        set_player(lua, "player", missile.player);
        arg::set_number(lua, "size", missile.size);
        lua_rawseti(lua, -2, ++count);
    }
    return 1;
}

int verb_deeds(lua_State* lua, void* context) {
    const auto& play = began(context);
    const auto player = arg::player(lua, 1);
    const auto name = arg::string(lua, 2, "cause");
    const auto all = causes();
    const auto found = std::find(all.begin(), all.end(), name);
    if (found == all.end()) fault("nothing hurts by '", name, "'");
    const auto& match_stats =
        world_of(play).single<EventLog>().match_stats[player][static_cast<std::size_t>(found - all.begin())];
    lua_createtable(lua, 0, 5);
    const auto set = [&](const char* key, double value) {
        lua_pushnumber(lua, value);
        lua_setfield(lua, -2, key);
    };
    set("shots", match_stats.shots);
    set("hits", match_stats.hits);
    set("kills", match_stats.kills);
    set("own_deaths", match_stats.own_deaths);
    set("damage", match_stats.damage);
    return 1;
}

// ---- states -----------------------------------------------------------------------------------------------

int verb_state(lua_State* lua, void* context) {
    auto& play = began(context);
    if (play.states.size() == max_states) fault("there are ", max_states, " states already");
    save_state(play, play.states.emplace_back());
    lua_pushinteger(lua, static_cast<lua_Integer>(play.states.size()));
    return 1;
}

const Bytes& state_at(const Play& play, lua_State* lua, int index) {
    const auto number = arg::integer(lua, index, "a state", {1, static_cast<double>(play.states.size())});
    return play.states[static_cast<std::size_t>(number - 1)];
}

void push_difference(lua_State* lua, const ecs::Difference& d) {
    lua_createtable(lua, 0, 5);
    arg::set_text(lua, "component", d.component);
    arg::set_text(lua, "field", d.field);
    arg::set_text(lua, "before", d.a);
    arg::set_text(lua, "after", d.b);
    if (d.entity == ecs::none) return;  // state outside of all entities: no field `entity`
    lua_pushinteger(lua, d.entity);
    lua_setfield(lua, -2, "entity");
}

int verb_changes(lua_State* lua, void* context) {
    const auto& play = began(context);
    const auto& before = state_at(play, lua, 1);
    Bytes current;
    if (lua_isnoneornil(lua, 2)) save_state(play, current);
    const auto& after = lua_isnoneornil(lua, 2) ? current : state_at(play, lua, 2);
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

// ---- files ------------------------------------------------------------------------------------------------

int verb_trace(lua_State* lua, void* context) {
    auto& play = began(context);
    Trace trace;
    trace.name = arg::plain_name(lua, 1, "name");
    if (!lua_istable(lua, 2)) fault("columns must be a list");
    if (play.traces.size() == max_traces) fault("there are ", max_traces, " traces already");
    trace.csv = "time_s";
    const auto count = std::min<lua_Unsigned>(lua_rawlen(lua, 2), 64);
    for (lua_Unsigned i = 1; i <= count; ++i) {
        lua_rawgeti(lua, 2, static_cast<lua_Integer>(i));
        const auto column = arg::string(lua, -1, "a column");
        const auto added = add_column(play, column, trace);
        if (!added) fault(added.error().message);
        if (!play.felt && column.find(".force_") != std::string::npos) begin_force_trace(play);
        lua_pop(lua, 1);
    }
    trace.csv += '\n';
    play.traces.push_back(std::move(trace));
    return 0;
}

/// Message by which the runner recognises that only a picture function was missing.
constexpr std::string_view no_pictures = "no picture function here: this scenario needs one that draws";

int verb_on_screen(lua_State* lua, void* context) {
    auto& play = began(context);
    const auto words = arg::string(lua, 1, "words");
    if (!play.options->read_screen) {
        play.no_picture = true;
        fault(no_pictures);
    }
    const auto all = play.options->read_screen(*play.match);
    const auto has = [&](const std::string& line) { return line.find(words) != std::string::npos; };
    lua_pushboolean(lua, std::any_of(all.begin(), all.end(), has));
    return 1;
}

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
    if (play.pictures.size() == max_pictures) fault("there are ", max_pictures, " pictures already");
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
    lua_pushinteger(lua, static_cast<lua_Integer>(play.pictures.size()) + 1);
    lua_pushinteger(lua, pixels->width);
    lua_pushinteger(lua, pixels->height);
    play.pictures.push_back(std::move(*pixels));
    return 3;
}

/// A part of a picture in pixels. It is never empty.
struct Area {
    const Pixels& pixels;
    int x0, y0, x1, y1;

    template <class Visit>
    void each(Visit visit) const {
        for (int y = y0; y < y1; ++y) {
            for (int x = x0; x < x1; ++x)
                visit(&pixels.rgb[3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(pixels.width) +
                                       static_cast<std::size_t>(x))]);
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

// ---- checks -----------------------------------------------------------------------------------------------

void need_replayable(const Play& play, std::string_view verb) {
    if (play.scene_set)
        fault(verb, ": this scenario has set the scene itself, so its input alone does not lead here");
    if (now_of(play) == 0) fault(verb, ": nothing has been played yet");
}

std::uint64_t read_seed(lua_State* lua, const Options& options) {
    return options.has("seed") ? static_cast<std::uint64_t>(arg::integer(lua, -1, "seed", {0, 1e15})) : 1;
}

int verb_check_seek(lua_State* lua, void* context) {
    const auto& play = began(context);
    need_replayable(play, "check_seek");
    const Options options(lua, 1, "check_seek", {"ticks", "count", "seed"});
    const auto now = static_cast<double>(now_of(play));
    const Range most{0, static_cast<double>(max_sought)};
    std::vector<Tick> ticks;
    if (options.has("ticks")) {
        if (!lua_istable(lua, -1)) fault("ticks must be a list");
        const int list = lua_gettop(lua);
        const auto count = std::min<lua_Unsigned>(lua_rawlen(lua, list), max_sought);
        for (lua_Unsigned i = 1; i <= count; ++i) {
            lua_rawgeti(lua, list, static_cast<lua_Integer>(i));
            ticks.push_back(static_cast<Tick>(arg::integer(lua, -1, "a tick", {0, now})));
            lua_pop(lua, 1);
        }
    }
    auto random = random_stream(read_seed(lua, options), 0);
    const auto count = options.has("count") ? arg::integer(lua, -1, "count", most) : 0;
    for (std::int64_t i = 0; i < count; ++i) ticks.push_back(random.below(now_of(play) + 1));
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

int verb_check_threads(lua_State* lua, void* context) {
    const auto& play = began(context);
    need_replayable(play, "check_threads");
    const auto workers = arg::integer(lua, 1, "threads", {0, 16});
    if (const auto found = check_threads(play, static_cast<unsigned>(workers)); !found.empty()) fault(found);
    return 0;
}

constexpr VerbName report_list[] = {
    {"events", verb_events},
    {"raw_next_event", verb_next_event},
    {"power_ups", verb_power_ups},
    {"fogs", verb_fogs},
    {"missiles", verb_missiles},
    {"deeds", verb_deeds},
    {"state", verb_state},
    {"changes", verb_changes},
    {"trace", verb_trace},
    {"on_screen", verb_on_screen},
    {"raw_picture", verb_picture},
    {"raw_picture_mean", verb_picture_mean},
    {"raw_picture_colours", verb_picture_colours},
    {"check_seek", verb_check_seek},
    {"check_late", verb_check_late},
    {"check_threads", verb_check_threads},
};

}  // namespace

std::span<const VerbName> report_verbs() { return report_list; }

}  // namespace thaum::game::inline scenario

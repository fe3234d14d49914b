// Verbs (functions of scenario scripts) for what players hear and feel: the cells of a jacket, captions, and
// the mixed sound.
#include <algorithm>
#include <cmath>

#include "audio/analysis.h"
#include "audio/sound.h"
#include "game/scenario/detail/verb.h"
#include "game/scenario/play_senses.h"
#include "game/senses/sound/heard.h"
#include "tactile/frame.h"
#include "tactile/layout.h"
#include "tactile/mixer.h"

namespace thaum::game::inline scenario {
namespace {

namespace arg = arguments;
using arg::fault;
using arg::Options;

constexpr std::size_t max_layouts = 4;

PlaySenses& sensed(void* context) {
    auto& play = began(context);
    if (!play.senses) fault("nobody hears or feels yet: senses{...} comes first");
    return *play.senses;
}

std::vector<std::string> read_layouts(lua_State* lua) {
    if (!lua_istable(lua, -1)) fault("layouts must be a list of names");
    const int list = lua_gettop(lua);
    std::vector<std::string> names;
    const auto count = lua_rawlen(lua, list);
    if (count > max_layouts) fault("there can be ", max_layouts, " layouts");
    for (lua_Unsigned i = 1; i <= count; ++i) {
        lua_rawgeti(lua, list, static_cast<lua_Integer>(i));
        names.push_back(arg::plain_name(lua, -1, "a layout"));
        lua_pop(lua, 1);
    }
    return names;
}

int verb_senses(lua_State* lua, void* context) {
    auto& play = began(context);
    const Options options(lua, 1, "senses", {"layouts", "sound"});
    std::vector<std::string> layouts;
    if (options.has("layouts")) layouts = read_layouts(lua);
    const bool mixed = options.has("sound") && lua_toboolean(lua, -1) != 0;
    auto senses = PlaySenses::create(play.options->assets, presentation_of(play), layouts, mixed);
    if (!senses) fault(senses.error().message);
    play.senses = std::move(*senses);
    play.senses->follow(*play.match);
    return 0;
}

/// Number of the layout named by the second argument; by default that of the body's figure in the view.
std::size_t read_layout(lua_State* lua, const PlaySenses& senses) {
    if (lua_isnoneornil(lua, 2)) return 0;
    const auto name = arg::string(lua, 2, "a layout");
    const auto number = senses.layout(name);
    if (!number) fault("senses{layouts = ...} has no '", name, "'");
    return *number;
}

/// body(n [, layout [, age]]): the cells of a layout. `age`: time since the connection to the device was lost
/// (s).
int verb_body(lua_State* lua, void* context) {
    const auto& senses = sensed(context);
    const auto player = arg::player(lua, 1);
    const auto number = read_layout(lua, senses);
    const double age = lua_isnoneornil(lua, 3) ? 0 : arg::number(lua, 3, "age", {0, 100});
    const auto& newest = senses.felt(player, number);
    const auto frame = tactile::frame_at(newest, newest.tick + ticks(age));
    const auto& actuators = senses.layout(number).actuators;
    lua_createtable(lua, static_cast<int>(actuators.size()), 0);
    for (std::size_t i = 0; i < actuators.size(); ++i) {
        lua_createtable(lua, 0, 3);
        arg::set_place(lua, "at", actuators[i].place.at);
        arg::set_number(lua, "felt", i < frame.count ? static_cast<double>(frame.amplitude.at(i)) : 0);
        arg::set_number(lua, "hz", i < frame.count ? static_cast<double>(frame.carrier_hz.at(i)) : 0);
        lua_rawseti(lua, -2, static_cast<lua_Integer>(i) + 1);
    }
    return 1;
}

int verb_body_counts(lua_State* lua, void* context) {
    const auto& senses = sensed(context);
    const auto player = arg::player(lua, 1);
    const auto& counts = senses.counts(player, read_layout(lua, senses));
    lua_createtable(lua, 0, 3);
    arg::set_number(lua, "offered", static_cast<double>(counts.offered));
    arg::set_number(lua, "started", static_cast<double>(counts.started));
    arg::set_number(lua, "merged", static_cast<double>(counts.merged));
    return 1;
}

int verb_heard(lua_State* lua, void* context) {
    const auto& senses = sensed(context);
    const auto lines = senses.lines(arg::player(lua, 1));
    lua_createtable(lua, static_cast<int>(lines.size()), 0);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        lua_createtable(lua, 0, 4);
        arg::set_text(lua, "line", words_of(lines[i]));
        arg::set_text(lua, "words", lines[i].words);
        arg::set_text(lua, "side", heard_from_words.at(static_cast<std::size_t>(lines[i].from)));
        arg::set_flag(lua, "important", lines[i].important);
        lua_rawseti(lua, -2, static_cast<lua_Integer>(i) + 1);
    }
    return 1;
}

// ---- sound ------------------------------------------------------------------------------------------------

PlaySenses& mixing(void* context) {
    auto& senses = sensed(context);
    if (!senses.mixes()) fault("the sound is not mixed: senses{sound = true}");
    return senses;
}

/// Pushes {db = , bands = {...}}: level of the loudest 50 ms, and the mean power of each band (dB).
void push_sound(lua_State* lua, const std::vector<float>& samples) {
    constexpr std::size_t column = 1024;  // length of a column of the spectrogram (samples)
    const auto spectrogram =
        audio::spectrogram_of(samples, samples.size() / column + 1, audio::signature_bands);
    lua_createtable(lua, 0, 2);
    arg::set_number(lua, "db", audio::loudest_db(samples));
    lua_createtable(lua, static_cast<int>(audio::signature_bands), 0);
    for (std::size_t row = 0; row < spectrogram.rows; ++row) {
        double sum = 0;
        for (std::size_t i = 0; i < spectrogram.columns; ++i) sum += spectrogram.at(i, row);
        const double mean = sum / static_cast<double>(spectrogram.columns);
        lua_pushnumber(lua, 10 * std::log10(std::max(mean, 1e-20)));
        lua_rawseti(lua, -2, static_cast<lua_Integer>(row) + 1);
    }
    lua_setfield(lua, -2, "bands");
}

int verb_sound(lua_State* lua, void* context) {
    push_sound(lua, mixing(context).take_mixed());
    return 1;
}

int verb_sounds(lua_State* lua, void* context) {
    const auto& sounds = sensed(context).bank().sounds;
    lua_createtable(lua, static_cast<int>(sounds.size()), 0);
    for (std::size_t i = 0; i < sounds.size(); ++i) {
        lua_pushlstring(lua, sounds[i].name.data(), sounds[i].name.size());
        lua_rawseti(lua, -2, static_cast<lua_Integer>(i) + 1);
    }
    return 1;
}

/// loopback(name): the sound as loudspeakers play it, with the name of the known sound that it resembles
/// most.
int verb_loopback(lua_State* lua, void* context) {
    auto& senses = mixing(context);
    const auto& bank = senses.bank();
    const auto name = arg::string(lua, 1, "a sound");
    const auto number = bank.find(name);
    if (!number) fault("there is no sound '", name, "'");
    const auto heard = senses.play_alone(*number);
    push_sound(lua, heard);
    arg::set_text(lua, "like", bank.sounds[senses.nearest(heard)].name);
    return 1;
}

// ---- events by hand, and checks ---------------------------------------------------------------------------

/// Verb: records an event that did not happen, so that it is heard and felt. The verb changes the match by
/// itself (sets the scene), so no log is kept.
int verb_happen(lua_State* lua, void* context) {
    auto& play = began(context);
    const Options options(lua, 1, "happen", {"kind", "subject", "by", "amount", "at"});
    Event event{.tick = played_in(play)};
    options.need("kind");
    event.kind = read_kind(lua, -1);
    if (options.has("subject")) event.subject = arg::player(lua, -1);
    if (options.has("by")) event.by = arg::player(lua, -1);
    if (options.has("amount")) event.amount = arg::number(lua, -1, "amount", {0, 1000});
    if (options.has("at")) event.place = arg::place(lua, -1, "at", farthest);
    scene_is_set(play);
    record_by_hand(play, event);
    return 0;
}

int verb_event_rows(lua_State* lua, void* context) {
    const auto rows = sensed_kinds_of(began(context));
    lua_newtable(lua);
    lua_Integer count = 0;
    for (const auto& row : rows) {
        lua_createtable(lua, 0, 3);
        arg::set_text(lua, "kind", row.kind);
        arg::set_text(lua, "sound", row.sound);
        arg::set_text(lua, "tactile", row.tactile);
        lua_rawseti(lua, -2, ++count);
    }
    return 1;
}

int verb_check_senses(lua_State* lua, void* context) {
    const auto& play = began(context);
    if (play.scene_set) fault("check_senses: this scenario has set the scene itself");
    const Options options(lua, 1, "check_senses", {"quit", "layouts"});
    const auto quit = options.has("quit") ? ticks(arg::number(lua, -1, "quit", {0, 600})) : ~Tick{0};
    std::vector<std::string> layouts;
    if (options.has("layouts")) layouts = read_layouts(lua);
    if (const auto found = check_senses(play, layouts, quit); !found.empty()) fault(found);
    return 0;
}

constexpr VerbName sense_list[] = {
    {"senses", verb_senses},
    {"body", verb_body},
    {"body_counts", verb_body_counts},
    {"heard", verb_heard},
    {"sound", verb_sound},
    {"sounds", verb_sounds},
    {"loopback", verb_loopback},
    {"happen", verb_happen},
    {"event_rows", verb_event_rows},
    {"check_senses", verb_check_senses},
};

}  // namespace

std::span<const VerbName> sense_verbs() { return sense_list; }

}  // namespace thaum::game::inline scenario

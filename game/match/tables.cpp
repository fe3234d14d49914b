#include "game/match/tables.h"

#include "core/table.h"
#include "core/text.h"
#include "game/components/hand_state.h"
#include "game/components/power_up.h"
#include "game/context/arms.h"
#include "game/data/brew_words.h"
#include "game/data/wand_slots.h"
#include "game/match/haptic_setup.h"

namespace thaum::game::inline match {
namespace {

/// Time in seconds. A single division rounds only once, so 9 ticks are 0.009 and not 0.009000000000000001.
double in_seconds(Tick tick) { return static_cast<double>(tick) / static_cast<double>(ticks_per_second); }

std::string name_of_ingredient(const MatchData& data, std::uint32_t number) {
    const bool known = data.cauldron && number < data.cauldron->ingredients.size();
    return known ? data.cauldron->ingredients[number].name : "";
}

std::string name_of_mode(const MatchData& data, std::uint32_t number) {
    const bool known = data.orb && number < data.orb->modes.size();
    return known ? data.orb->modes[number].name : "";
}

std::string name_of_gesture(const MatchContext& context, std::uint32_t player, std::uint32_t number) {
    const auto* gestures = player < players ? gestures_of(context, player) : nullptr;
    return gestures == nullptr ? std::string() : std::string(gestures->name(number));
}

/// Text of a revealed recipe: "azoth: moss, salt, mist".
std::string words_of_recipe(const MatchData& data, std::uint32_t detail) {
    const auto words = brew_words_of(data);
    return text(words.potion(detail & 0xFFU), ": ", words_of_order(words, detail));
}

struct Row {
    Tick tick{}, played{};
    std::string_view kind{};
    std::uint32_t who = no_player, whom = no_player;
    std::string with{};
    double amount{};
    std::string_view unit{};
    const vec3* place = nullptr;
    std::string_view note{};
};

std::string player_name(std::uint32_t player) { return player < players ? text(player + 1) : std::string(); }

void append(const Row& row, std::string& out) {
    append_text(out, text(row.tick, ",", in_seconds(row.tick), ",", in_seconds(row.played), ","));
    append_cell(out, row.kind);
    append_text(out, text(",", player_name(row.who), ",", player_name(row.whom), ","));
    append_cell(out, row.with);
    append_text(out, row.unit.empty() ? std::string(",,") : text(",", row.amount, ",", row.unit));
    append_text(out, row.place != nullptr ? text(",", row.place->x, ",", row.place->y, ",", row.place->z, ",")
                                          : std::string(",,,,"));
    append_cell(out, row.note);
    out += '\n';
}

std::string wand_of(const Simulation& match, std::uint32_t player) {
    if (player >= players) return {};
    const auto wizard = wizard_of(match.world(), player);
    const auto* wand = wand_in_hand(match.data(), match.world().get<WandBelt>(wizard));
    return wand != nullptr ? wand->name : std::string();
}

std::string name_of_kind(std::uint32_t kind) {
    const auto name = name_of(static_cast<EventKind>(kind));
    return name.empty() ? text("kind ", kind) : std::string(name);
}

std::string_view name_of_ending(std::uint32_t ending) {
    switch (static_cast<Ending>(ending)) {
        case Ending::kills: return "kills";
        case Ending::time: return "time";
        case Ending::great_work: return "great_work";
        case Ending::boil_over: return "boil_over";
        case Ending::none: break;
    }
    return "";
}

std::string tool_name(const MatchData& data, std::uint32_t number) {
    return data.crystal && number < data.crystal->tools.size() ? data.crystal->tools[number].name
                                                               : std::string();
}

std::string with_what(EventWith with, const Event& event, const Simulation& match) {
    switch (with) {
        case EventWith::nothing: break;
        case EventWith::wand_in_hand: return wand_of(match, event.by);
        case EventWith::own_name: return std::string(name_of(event.kind));
        case EventWith::cause: return name_of_kind(event.detail);
        case EventWith::pad: return text("pad ", event.detail);
        case EventWith::ending: return std::string(name_of_ending(event.detail));
        case EventWith::power_up:
            return event.detail < power_up_names.size() ? std::string(power_up_names[event.detail]) : "";
        case EventWith::ingredient: return name_of_ingredient(match.data(), event.detail);
        case EventWith::spell: return std::string(name_of_spell(match.data().spells, event.detail));
        case EventWith::gesture: return name_of_gesture(match.context(), event.by, event.detail);
        case EventWith::potion: return std::string(brew_words_of(match.data()).potion(event.detail));
        case EventWith::fault: return std::string(name_of_fault(static_cast<BrewFault>(event.detail)));
        case EventWith::tool: return tool_name(match.data(), event.detail);
        case EventWith::recipe: return words_of_recipe(match.data(), event.detail);
        case EventWith::mode: return name_of_mode(match.data(), event.detail);
        case EventWith::round: return text("round ", event.detail);
    }
    return {};
}

void append_event(const Event& event, const Simulation& match, std::string& out) {
    const auto& info = info_of(event.kind);
    append({.tick = match.now(),
            .played = event.tick,
            .kind = info.name,
            .who = event.by,
            .whom = info.has_subject ? event.subject : no_player,
            .with = with_what(info.with, event, match),
            .amount = event.amount,
            .unit = info.unit,
            .place = info.placed ? &event.place : nullptr},
           out);
}

std::string_view name_of(input::LogEnding ending) {
    switch (ending) {
        case input::LogEnding::clean: return "clean";
        case input::LogEnding::cut_off: return "cut_off";
        case input::LogEnding::damaged: return "damaged";
    }
    return "";
}

void append_numbers(std::string& out, std::initializer_list<double> numbers) {
    for (const double number : numbers) append_text(out, text(",", number));
}

void append_player(const Simulation& match, std::uint32_t player, std::string& out) {
    const auto& world = match.world();
    const auto wizard = wizard_of(world, player);
    const auto& motion = world.get<Motion>(wizard);
    const auto& gaze = world.get<Gaze>(wizard);
    const auto& belt = world.get<WandBelt>(wizard);
    append_numbers(out, {motion.position.x, motion.position.y, motion.position.z, motion.velocity.x,
                         motion.velocity.y, motion.velocity.z, gaze.yaw, gaze.pitch});
    out += world.has<Dead>(wizard) ? ",1" : ",0";
    append_numbers(out, {world.get<Health>(wizard).points});
    out += ',';
    append_cell(out, wand_of(match, player));
    for (const auto& wand : match.data().wands) append_numbers(out, {belt.energy[wand.stats.energy_slot]});
}

}  // namespace

std::string with_of(const Event& event, const Simulation& match) {
    return with_what(info_of(event.kind).with, event, match);
}

std::string EventTable::header() {
    return "tick,time_s,played_s,kind,who,whom,with,amount,unit,x_m,y_m,z_m,note\n";
}

void EventTable::marks_up_to(Tick tick, const Playback& playback, std::string& out) {
    const auto& marks = playback.log().marks();
    for (; marks_ < marks.size() && marks[marks_].tick <= tick; ++marks_) {
        const auto& mark = marks[marks_];
        if (mark.kind != input::MarkKind::user) continue;
        append({.tick = mark.tick,
                .played = playback.match().match().played,
                .kind = "mark",
                .with = text(mark.number)},
               out);
    }
}

void EventTable::follow_faders(const Playback& playback, std::string& out) {
    const auto& match = playback.match();
    const auto& devices = playback.log().header().devices;
    for (std::size_t i = 0; i < devices.size(); ++i) {
        const auto& change = playback.frame().devices[i].change;
        if (change.fader == 0 || !is_valid(change) || !devices[i].moves_faders) continue;
        append({.tick = match.now(),
                .played = match.match().played,
                .kind = "fader",
                .who = devices[i].player,
                .with = fader_names().at(change.fader - 1U),
                .amount = static_cast<double>(change.percent),
                .unit = "percent"},
               out);
    }
}

void EventTable::follow_devices(const Playback& playback, std::string& out) {
    const auto& match = playback.match();
    const auto& devices = playback.log().header().devices;
    for (std::size_t i = 0; i < devices.size(); ++i) {
        const bool away = playback.frame().devices[i].away;
        if (away == away_[i]) continue;
        away_[i] = away;
        append({.tick = match.now(),
                .played = match.match().played,
                .kind = away ? "left" : "joined",
                .who = devices[i].player,
                .with = devices[i].name},
               out);
    }
}

void EventTable::follow(const Playback& playback, std::string& out) {
    const auto& match = playback.match();
    const auto& state = match.match();
    const auto now = match.now();
    for (const auto& device : playback.frame().devices) {
        if (device.skips == 0) continue;
        append({.tick = now,
                .played = state.played,
                .kind = "skip",
                .amount = static_cast<double>(device.skips),
                .unit = "ticks"},
               out);
    }
    follow_devices(playback, out);
    follow_faders(playback, out);
    const auto lost =
        match.events().each_new(seen_, [&](const Event& event) { append_event(event, match, out); });
    if (lost > 0) {
        append({.tick = now,
                .played = state.played,
                .kind = "lost",
                .amount = static_cast<double>(lost),
                .unit = "events"},
               out);
    }
    if ((state.paused != 0) != paused_) {
        paused_ = !paused_;
        append({.tick = now,
                .played = state.played,
                .kind = paused_ ? "pause" : "resume",
                .who = state.paused_by},
               out);
    }
    marks_up_to(now, playback, out);
}

void EventTable::finish(const Playback& playback, std::string& out) {
    const auto& match = playback.match();
    append({.tick = match.now(),
            .played = match.match().played,
            .kind = "end",
            .with = std::string(name_of(playback.log().ending())),
            .note = result_line(match)},
           out);
}

std::string state_header(const Simulation& match) {
    std::string out = "tick,time_s,played_s,paused";
    for (std::uint32_t player = 1; player <= players; ++player) {
        for (const auto* column : {"x_m", "y_m", "z_m", "vx_m_s", "vy_m_s", "vz_m_s", "yaw_rad", "pitch_rad",
                                   "dead", "health_hp", "wand"})
            append_text(out, text(",p", player, "_", column));
        for (const auto& wand : match.data().wands)
            append_text(out, text(",p", player, "_energy_", wand.name));
    }
    return out + "\n";
}

void append_state(const Simulation& match, std::string& out) {
    const auto& state = match.match();
    append_text(out, text(match.now(), ",", in_seconds(match.now()), ",", in_seconds(state.played), ",",
                          state.paused != 0 ? 1 : 0));
    for (std::uint32_t player = 0; player < players; ++player) append_player(match, player, out);
    out += '\n';
}

std::string forces_header() {
    std::string out = "tick,time_s";
    for (std::uint32_t player = 1; player <= players; ++player) {
        for (const auto* column : {"x_m",       "y_m",     "z_m",     "fx_n", "fy_n", "fz_n",      "cause",
                                   "created_j", "given_j", "px_n",    "py_n", "pz_n", "k_n_per_m", "ax_m",
                                   "ay_m",      "az_m",    "touches", "sx_m", "sy_m", "sz_m",      "arm"})
            append_text(out, text(",p", player, "_", column));
    }
    return out + "\n";
}

void append_forces(const Simulation& match, std::string& out) {
    append_text(out, text(match.now(), ",", in_seconds(match.now())));
    for (std::uint32_t player = 0; player < players; ++player) {
        const auto& world = match.world();
        const auto& hand_state = world.get<HandState>(wizard_of(world, player));
        const vec3 at = hand_state.device.position, force = hand_state.servo.safety.output;
        append_numbers(out, {at.x, at.y, at.z, force.x, force.y, force.z});
        append_text(out, text(",", haptics::safety_cause_names[hand_state.servo.safety.cause]));
        const auto& observer = hand_state.servo.energy;
        const vec3 passive = observer.forces[observer.newest].passive;
        const auto& tether = hand_state.tether;
        const vec3 anchor = tether.stiffness > 0 ? tether.anchor : vec3(0);
        const auto& surface = hand_state.servo.surface;
        const bool touches = surface.contacts != 0;
        const vec3 point = touches ? surface.proxy - hand_state.servo.contact_offset : vec3(0);
        append_numbers(out, {observer.created, observer.active_work, passive.x, passive.y, passive.z,
                             tether.stiffness, anchor.x, anchor.y, anchor.z, touches ? 1.0 : 0.0, point.x,
                             point.y, point.z, plays_by_arm(match.world(), player) ? 1.0 : 0.0});
    }
    out += '\n';
}

}  // namespace thaum::game::inline match

#include "game/scenario/play.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include "core/file.h"
#include "core/text.h"
#include "game/bots/bot_file.h"
#include "game/components/hand_state.h"
#include "game/components/station.h"
#include "game/data/wand_slots.h"
#include "game/match/hand/arm_system.h"
#include "game/match/own_gestures.h"
#include "game/match/tables.h"
#include "game/scenario/detail/part.h"
#include "game/scenario/match_options.h"
#include "game/scenario/play_senses.h"
#include "game/scenario/script_arm.h"
#include "game/stations/orb/orb.h"

namespace thaum::game::inline scenario {
namespace {

/// Largest turn of a scripted player's view per tick: 400 degrees a second, as fast as a quick player.
constexpr std::int32_t max_counts = 8;
constexpr std::size_t max_trace_bytes = 64U << 20U;

input::DeviceSpec script_device(std::uint32_t player) {
    return {.player = player, .kind = input::DeviceKind::script, .name = "script", .moves_faders = true};
}

std::string player_name(const std::string& bot) { return bot.empty() ? "script" : text("bot ", bot); }

void note_fault(Play& play, const Error& fault) {
    if (play.write_fault.empty()) play.write_fault = fault.message;
}

void open_log(Play& play) {
    if (!play.keeps_files || play.options->out.empty()) return;
    play.log_path = play.options->out / (play.name + ".thaumlog");
    if (const auto removed = input::remove_log(play.log_path); !removed)
        return note_fault(play, removed.error());
    std::vector<std::string> names;
    for (const auto& bot : play.bot) names.push_back(player_name(bot));
    auto log = input::LogWriter::create(play.log_path, log_header(*play.data, play.match->setup(), names),
                                        input::WhenBehind::wait);
    if (!log) return note_fault(play, log.error());
    play.log = std::make_unique<input::LogWriter>(std::move(*log));
}

/// Returns the part of a turn (mouse counts) that fits in one tick, and subtracts it from `left`.
std::int32_t part_of(std::int32_t& left) {
    const auto part = std::clamp(left, -max_counts, max_counts);
    left -= part;
    return part;
}

input::InputFrame frame_of(Play& play) {
    namespace hand = input::hand;
    input::InputFrame frame;
    for (std::size_t player = 0; player < players; ++player) {
        if (!play.bot[player].empty()) continue;
        auto& from = play.hands[player];
        auto& sample = frame.devices[player];
        sample.counts[hand::look_right] = part_of(from.look_right) + std::exchange(from.drawn_right, 0);
        sample.counts[hand::look_up] = part_of(from.look_up) + std::exchange(from.drawn_up, 0);
        sample.counts[hand::turn_right] = from.stick_right;
        sample.counts[hand::turn_up] = from.stick_up;
        sample.counts[hand::strafe] = from.strafe;
        sample.counts[hand::forward] = from.forward;
        sample.counts[hand::trigger] =
            (from.buttons & static_cast<std::uint32_t>(input::Button::fire)) != 0 ? from.trigger : 0;
        sample.buttons = from.buttons;
        sample.wand = from.wand;
        if (from.changes.empty()) continue;
        sample.change = from.changes.front();
        from.changes.erase(from.changes.begin());
    }
    if (play.bots) play.bots->sample(*play.match, frame);
    take_samples(play.arms, frame);
    return frame;
}

/// Copies new events, since the journal holds only those of the last seconds.
void collect_events(Play& play) {
    play.match->events().each_new(play.events_seen, [&](const Event& e) { play.events.push_back(e); });
}

void keep_keyframe(Play& play) {
    if (play.scene_set || play.match->now() % keyframe_interval != 0) return;
    play.keyframes.push_back({play.match->now(), {}});
    play.match->save(play.keyframes.back().world);
}

void note_forces(Play& play) {
    if (!play.felt) return;
    std::array<vec3, players> forces;
    for (std::uint32_t player = 0; player < players; ++player)
        forces[player] = part<HandState>(play, player).servo.safety.output;
    play.felt->record.add(play.match->now(), forces);
    if (!play.keeps_files || play.options->out.empty() || play.felt->csv.size() > max_trace_bytes) return;
    append_forces(*play.match, play.felt->csv);
}

/// Passes the match's newest haptic models, from which an arm computes its force, to the simulated arms.
void publish_orders(const Simulation& match, ScriptArms& arms) {
    for (std::uint32_t player = 0; player < players; ++player) {
        const auto& arm = arms[player];
        if (arm && fill_order(match.world(), match.haptic_setup(), player, arm->servo.order()))
            arm->servo.publish();
    }
}

}  // namespace

Play::Play() = default;
Play::~Play() = default;

Expected<void> begin_match(Play& play, const MatchOptions& wanted) {
    auto data = load_match_data(play.options->assets, wanted.data);
    if (!data) return data.error();
    play.data = std::make_shared<const MatchData>(std::move(*data));
    play.bot = wanted.bot;
    MatchSetup setup{.seed = wanted.seed, .devices = {}};
    for (std::uint32_t player = 0; player < players; ++player) {
        const auto& bot = wanted.bot[player];
        setup.devices.push_back(bot.empty() ? script_device(player) : bot_device(player, bot));
        if (wanted.force[player]) setup.devices.back().set_force_percent(*wanted.force[player]);
        setup.devices.back().set_carried_percent(wanted.weight[player].value_or(100),
                                                 wanted.blows[player].value_or(100));
        setup.devices.back().casts_freely = wanted.casts_freely[player];
        for (std::size_t mode = 0; mode < input::fluid_faders; ++mode)
            setup.devices.back().set_fluid_percent(mode, wanted.modes[player][mode].value_or(100));
    }
    for (std::uint32_t player = 0; player < players; ++player) {
        if (!wanted.arm[player]) continue;
        play.arms[player] = std::make_unique<ScriptArm>();
        play.arms[player]->device = static_cast<std::uint32_t>(setup.devices.size());
        setup.devices.push_back({.player = player, .kind = input::DeviceKind::arm, .name = "script"});
    }
    if (auto used = use_profile(*play.data, wanted.profile, setup); !used) return used;
    play.match = std::make_unique<Simulation>(play.data, setup);
    for (std::uint32_t player = 0; player < players; ++player) {
        if (wanted.bot[player].empty()) continue;
        const auto skill = load_bot_skill(play.options->assets, wanted.bot[player]);
        if (!skill) return skill.error();
        if (!play.bots) play.bots = std::make_unique<Bots>();
        play.bots->add(*play.match, player, player, *skill, wanted.seed);
    }
    play.match->save(play.begun);
    open_log(play);
    return {};
}

void tick(Play& play) {
    auto& match = *play.match;
    keep_keyframe(play);
    if (play.options->spoil) play.options->spoil(match, play.run);
    if (play.behind == 0) {
        step_arms(play.arms);
    } else {
        --play.behind;
    }
    const auto frame = frame_of(play);
    tick_and_record(match, frame, play.log.get());
    publish_orders(match, play.arms);
    play.frames.push_back(frame);
    collect_events(play);
    if (match.now() % hash_interval == 0) play.hashes.push_back(match.state_hash());
    if (play.save_at == match.now()) match.save(play.saved);
    for (auto& trace : play.traces) trace_now(play, trace);
    note_forces(play);
    if (play.senses) play.senses->follow(match);
}

void stall(Play& play, Tick ticks) {
    for (Tick t = 0; t < ticks; ++t) step_arms(play.arms);
    play.behind += ticks;
}

void scene_is_set(Play& play) {
    if (play.scene_set) return;
    play.scene_set = true;
    if (!play.log) return;
    play.log.reset();
    std::error_code ignored;
    std::filesystem::remove(play.log_path, ignored);
}

namespace {

void put_table(Play& play, const std::string& file, std::string_view csv) {
    if (const auto written = write_text_file(play.options->out / file, csv); written)
        play.files.push_back(file);
    else
        note_fault(play, written.error());
}

}  // namespace

void end_match(Play& play) {
    if (play.log) {
        if (const auto closed = close_log(*play.log, *play.match); closed)
            play.files.push_back(play.log_path.filename().string());
        else
            note_fault(play, closed.error());
        play.log.reset();
    }
    if (!play.keeps_files || play.options->out.empty()) return;
    for (const auto& trace : play.traces)
        put_table(play, text(play.name, ".", trace.name, ".csv"), trace.csv);
    if (play.felt) put_table(play, play.name + ".forces.csv", play.felt->csv);
}

// ---- what runner and verbs read ---------------------------------------------------------------------------

Tick now_of(const Play& play) { return play.match->now(); }
Tick played_in(const Play& play) { return play.match->match().played; }
std::uint64_t state_hash_of(const Play& play) { return play.match->state_hash(); }
void save_state(const Play& play, Bytes& out) { play.match->save(out); }

std::optional<std::string> force_trace_of(Play& play) {
    if (!play.felt) return std::nullopt;
    return play.felt->record.file(rules_version);
}

std::uint64_t differing_forces(const Play& play) { return differing_forces(play.arms); }

const ecs::World& world_of(const Play& play) { return std::as_const(*play.match).world(); }
ecs::World& world_to_change(Play& play) { return play.match->world_to_change(); }
physics::Physics& physics_of(Play& play) { return play.match->physics(); }
const Presentation& presentation_of(const Play& play) { return *play.data->presentation; }
const OrbRules* orb_rules_of(const Play& play) { return play.data->orb ? &*play.data->orb : nullptr; }

std::string with_of(const Play& play, const Event& event) { return with_of(event, *play.match); }

void record_by_hand(Play& play, const Event& event) { record(play.match->context_to_change(), event); }

std::vector<FlyingMissile> missiles_of(const Play& play) {
    std::vector<FlyingMissile> all;
    for (const auto& wand : play.data->wands)
        wand.rules->show(world_of(play), [&](const Missile& missile) {
            all.push_back({missile.position, missile.velocity, missile.player, missile.size});
        });
    return all;
}

std::vector<SensedKind> sensed_kinds_of(const Play& play) {
    const auto& rows = play.data->presentation->events;
    std::vector<SensedKind> named;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const auto name = name_of(static_cast<EventKind>(i));
        if (!name.empty() && !(rows[i].sound.empty() && rows[i].tactile.empty()))
            named.push_back({name, rows[i].sound, rows[i].tactile});
    }
    return named;
}

vec3 current_at(const Play& play, vec3 place) {
    return current_at(world_of(play), play.match->brew(), place, played_in(play));
}

double surface_at(const Play& play, vec3 place) {
    return surface_at(play.match->brew(), world_of(play).single<Cauldron>(), place);
}

const std::string& ingredient_name(const Play& play, std::size_t ingredient) {
    return play.data->cauldron->ingredients[ingredient].name;
}

std::optional<CoreInHand> core_in_hand(const Play& play, std::uint32_t player) {
    const auto* station = world_of(play).find<AtStation>(wizard_entity(play, player));
    if (station == nullptr || station->kind != StationKind::orb) return std::nullopt;
    const auto& orb = world_of(play).single<Orb>();
    const auto core = core_of(orb);
    const auto frame = probe_frame(*play.data->orb, orb, station->yaw);
    return CoreInHand{frame.to_device(core.middle), glm::conjugate(frame.turn) * core.axis};
}

double readiness(const Play& play, std::uint32_t player) {
    const auto* wand = wand_in_hand(*play.data, part<WandBelt>(play, player));
    if (wand == nullptr) return 0;
    return wand->rules->readiness(play.match->world(), wizard_entity(play, player)).value_or(0);
}

ecs::Entity wizard_entity(const Play& play, std::uint32_t player) {
    return wizard_of(play.match->world(), player);
}

LookCounts counts_to(const Play& play, std::uint32_t player, vec3 target) {
    const auto& world = play.match->world();
    const auto wizard = wizard_entity(play, player);
    const auto& gaze = world.get<Gaze>(wizard);
    const vec3 to = target - eye_of(play.data->wizard, world.get<Motion>(wizard).position);
    const double yaw = det::atan2(-to.x, -to.z) - gaze.yaw;
    const double limit = play.data->wizard.pitch_limit;
    const double pitch =
        std::clamp(det::atan2(to.y, std::sqrt(to.x * to.x + to.z * to.z)), -limit, limit) - gaze.pitch;
    const double turn = yaw > pi ? yaw - 2 * pi : yaw < -pi ? yaw + 2 * pi : yaw;
    const double step = play.match->setup().devices[player].look_rad_per_count;
    return {static_cast<std::int32_t>(std::lround(-turn / step)),
            static_cast<std::int32_t>(std::lround(pitch / step))};
}

// ---- traces -----------------------------------------------------------------------------------------------

namespace {

using Reader = double (*)(const Play&, std::uint32_t);

struct Column {
    std::string_view name, header;
    Reader of_wizard, of_thing;  ///< functions that read the column; null: there is no such column
};

/// Motion of a thing, or a motion at rest if the thing no longer exists.
Motion thing_motion(const Play& play, std::uint32_t number) {
    const auto* found = play.match->world().find<Motion>(play.things[number].entity);
    return found == nullptr ? Motion{} : *found;
}

constexpr Column columns[] = {
    {"x", "x_m", [](const Play& p, std::uint32_t i) { return part<Motion>(p, i).position.x; },
     [](const Play& p, std::uint32_t i) { return thing_motion(p, i).position.x; }},
    {"y", "y_m", [](const Play& p, std::uint32_t i) { return part<Motion>(p, i).position.y; },
     [](const Play& p, std::uint32_t i) { return thing_motion(p, i).position.y; }},
    {"z", "z_m", [](const Play& p, std::uint32_t i) { return part<Motion>(p, i).position.z; },
     [](const Play& p, std::uint32_t i) { return thing_motion(p, i).position.z; }},
    {"vx", "vx_m_s", [](const Play& p, std::uint32_t i) { return part<Motion>(p, i).velocity.x; },
     [](const Play& p, std::uint32_t i) { return thing_motion(p, i).velocity.x; }},
    {"vy", "vy_m_s", [](const Play& p, std::uint32_t i) { return part<Motion>(p, i).velocity.y; },
     [](const Play& p, std::uint32_t i) { return thing_motion(p, i).velocity.y; }},
    {"vz", "vz_m_s", [](const Play& p, std::uint32_t i) { return part<Motion>(p, i).velocity.z; },
     [](const Play& p, std::uint32_t i) { return thing_motion(p, i).velocity.z; }},
    {"speed", "speed_m_s",
     [](const Play& p, std::uint32_t i) { return glm::length(part<Motion>(p, i).velocity); },
     [](const Play& p, std::uint32_t i) { return glm::length(thing_motion(p, i).velocity); }},
    {"yaw", "yaw_rad", [](const Play& p, std::uint32_t i) { return part<Gaze>(p, i).yaw; }, nullptr},
    {"pitch", "pitch_rad", [](const Play& p, std::uint32_t i) { return part<Gaze>(p, i).pitch; }, nullptr},
    {"health", "health_hp", [](const Play& p, std::uint32_t i) { return part<Health>(p, i).points; },
     nullptr},
    {"energy", "energy",
     [](const Play& p, std::uint32_t i) { return energy_in_hand(*p.data, part<WandBelt>(p, i)); }, nullptr},
    {"hand_x", "hand_x_m",
     [](const Play& p, std::uint32_t i) { return part<HandState>(p, i).device.position.x; }, nullptr},
    {"hand_y", "hand_y_m",
     [](const Play& p, std::uint32_t i) { return part<HandState>(p, i).device.position.y; }, nullptr},
    {"hand_z", "hand_z_m",
     [](const Play& p, std::uint32_t i) { return part<HandState>(p, i).device.position.z; }, nullptr},
    {"force_x", "force_x_n",
     [](const Play& p, std::uint32_t i) { return part<HandState>(p, i).servo.safety.output.x; }, nullptr},
    {"force_y", "force_y_n",
     [](const Play& p, std::uint32_t i) { return part<HandState>(p, i).servo.safety.output.y; }, nullptr},
    {"force_z", "force_z_n",
     [](const Play& p, std::uint32_t i) { return part<HandState>(p, i).servo.safety.output.z; }, nullptr},
    {"readiness", "readiness", [](const Play& p, std::uint32_t i) { return readiness(p, i); }, nullptr},
    {"shots", "shots",
     [](const Play& p, std::uint32_t i) { return static_cast<double>(part<WandBelt>(p, i).fired); }, nullptr},
};

/// Reads a column's subject: "1.x" is player 0, "t3.x" is the third thing.
bool read_subject(const Play& play, std::string_view subject, bool& thing, std::uint32_t& number) {
    thing = subject.starts_with("t");
    if (thing) subject.remove_prefix(1);
    const auto end = std::from_chars(subject.data(), subject.data() + subject.size(), number);
    if (end.ec != std::errc{} || end.ptr != subject.data() + subject.size()) return false;
    const auto count = thing ? play.things.size() : players;
    return number >= 1 && number-- <= count;
}

}  // namespace

void begin_force_trace(Play& play) { play.felt.emplace(FeltForces{{}, forces_header()}); }

Expected<void> add_column(const Play& play, const std::string& column, Trace& trace) {
    const auto point = column.find('.');
    bool thing = false;
    std::uint32_t number = 0;
    const std::string_view whole = column;
    if (point != std::string::npos && read_subject(play, whole.substr(0, point), thing, number)) {
        for (const auto& known : columns) {
            const auto reader = thing ? known.of_thing : known.of_wizard;
            if (known.name != whole.substr(point + 1) || reader == nullptr) continue;
            trace.readers.push_back(reader);
            trace.subjects.push_back(number);
            trace.csv += text(",", thing ? "thing_" : "wizard_", number + 1, "_", known.header);
            return {};
        }
    }
    return fail(
        text("'", column, "' is no column of a trace: such as '1.x', '2.health' or, of a thing, 't1.speed'"));
}

void trace_now(const Play& play, Trace& trace) {
    if (!play.keeps_files || trace.csv.size() > max_trace_bytes) return;
    append_text(trace.csv, fixed(seconds(play.match->match().played), 3));
    for (std::size_t i = 0; i < trace.readers.size(); ++i) {
        trace.csv += ',';
        append_text(trace.csv, trace.readers[i](play, trace.subjects[i]));
    }
    trace.csv += '\n';
}

}  // namespace thaum::game::inline scenario

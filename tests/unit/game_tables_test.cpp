// Compares the tables of a replay with the match that was recorded.
#include "game/match/tables.h"

#include <unistd.h>

#include <charconv>
#include <map>

#include "core/file.h"
#include "core/text.h"
#include "game/match/header_text.h"
#include "unit/game_duel.h"

namespace thaum::game::test {
namespace {

using Rows = std::vector<std::vector<std::string>>;

/// Parses CSV strictly by RFC 4180. Every row must have as many fields as the first.
Rows parse_csv(std::string_view csv) {
    Rows rows{{""}};
    bool quoted = false;
    for (std::size_t i = 0; i < csv.size(); ++i) {
        const char c = csv[i];
        auto& field = rows.back().back();
        if (quoted && c == '"' && i + 1 < csv.size() && csv[i + 1] == '"') {
            field += csv[++i];
        } else if (c == '"') {
            quoted = !quoted;
        } else if (!quoted && c == ',') {
            rows.back().emplace_back();
        } else if (!quoted && c == '\n') {
            rows.push_back({""});
        } else {
            field += c;
        }
    }
    EXPECT_FALSE(quoted);
    EXPECT_EQ(rows.back(), std::vector<std::string>{""}) << "the last row ends with LF";
    rows.pop_back();
    for (const auto& row : rows) EXPECT_EQ(row.size(), rows[0].size());
    return rows;
}

double number(const std::string& field) {
    double value = 0;
    const auto read = std::from_chars(field.data(), field.data() + field.size(), value);
    EXPECT_TRUE(read.ec == std::errc{} && read.ptr == field.data() + field.size()) << field;
    return value;
}

/// Access to a CSV table by the names of its columns.
class Csv {
public:
    explicit Csv(const std::string& csv) : rows_(parse_csv(csv)) {}
    std::size_t size() const { return rows_.size() - 1; }
    const std::string& at(std::size_t row, std::string_view column) const {
        const auto found = std::find(rows_[0].begin(), rows_[0].end(), column);
        EXPECT_NE(found, rows_[0].end()) << column;
        return rows_[row + 1][static_cast<std::size_t>(found - rows_[0].begin())];
    }
    double value(std::size_t row, const std::string& column) const { return number(at(row, column)); }

private:
    Rows rows_;
};

struct Seen {
    Tick tick;
    Event event;
};

struct Moment {
    vec3 position, velocity;
    double yaw, pitch, health, energy;
    bool dead;
};

Moment moment_of(const Simulation& match, std::uint32_t player) {
    const auto& world = match.world();
    const auto e = wizard_of(world, player);
    const auto& motion = world.get<Motion>(e);
    return {motion.position,
            motion.velocity,
            world.get<Gaze>(e).yaw,
            world.get<Gaze>(e).pitch,
            world.get<Health>(e).points,
            world.get<WandBelt>(e).energy[0],
            world.has<Dead>(e)};
}

constexpr Tick recorded_ticks = 12'000;
constexpr Tick state_every = 500;

/// A recorded duel with a pause, skipped samples, two marks (ticks that a player has marked) and a lost
/// device: its log, and what happened in the match.
class TableRecording {
public:
    TableRecording() {
        auto duel =
            make_bot_duel(assets(), duel_data({"bolt.shot.damage=40"}), {"level_1", "level_1"}, 2).value();
        auto& match = *duel.match;
        auto log =
            input::LogWriter::create(file_, log_header(match.data(), match.setup(), {"bot 1", "bot 1"}),
                                     input::WhenBehind::wait)
                .value();
        note_state(match);
        std::uint64_t events = 0;
        for (Tick t = 0; t < recorded_ticks; ++t) {
            auto frame = duel.next_frame();
            if (t == 4000 || t == 4600) frame.devices[1].press(input::Button::pause);
            if (t == 7000) frame.devices[0].skips = 300;
            frame.devices[1].away = t >= 8000 && t < 8003;
            frame.devices[0].away = t >= 8002;
            tick_and_record(match, frame, &log);
            if (t == 5000) log.mark(1), log.mark(2);
            match.events().each_new(events, [&](const Event& event) {
                seen.push_back({match.now(), event});
            });
            note_state(match);
        }
        EXPECT_TRUE(log.close("a \"close\" end, of \x1b[31m sorts").has_value());
        result = result_line(match);
    }
    Playback play() const { return Playback::open(file_, assets()).value(); }

    std::string result;
    std::vector<Seen> seen;
    std::map<Tick, std::array<Moment, players>> states;

private:
    void note_state(const Simulation& match) {
        if (match.now() % state_every == 0) states[match.now()] = {moment_of(match, 0), moment_of(match, 1)};
    }
    const TemporaryFolder folder_;
    const std::filesystem::path file_ = folder_.path() / "tables.thaumlog";
};

const TableRecording& table_recording() {
    static const TableRecording match;
    return match;
}

struct Tables {
    std::string events, state;
};

Tables tables_of(Playback playback) {
    Tables tables{EventTable::header(), state_header(playback.match())};
    EventTable events;
    do {
        events.follow(playback, tables.events);
        if (playback.match().now() % state_every == 0) append_state(playback.match(), tables.state);
    } while (playback.step());
    events.finish(playback, tables.events);
    return tables;
}

TEST(GameTables, EveryEventOfTheMatchIsThereWithItsBits) {
    const Csv csv(tables_of(table_recording().play()).events);
    std::size_t row = 0, placed = 0, deaths = 0;
    for (const auto& [tick, event] : table_recording().seen) {
        while (csv.at(row, "kind") == "pause" || csv.at(row, "kind") == "resume" ||
               csv.at(row, "kind") == "skip" || csv.at(row, "kind") == "mark" ||
               csv.at(row, "kind") == "left" || csv.at(row, "kind") == "joined")
            ++row;
        ASSERT_EQ(csv.at(row, "kind"), name_of(event.kind)) << row;
        EXPECT_EQ(csv.at(row, "tick"), text(tick));
        EXPECT_EQ(csv.value(row, "time_s"), static_cast<double>(tick) / 1000);
        EXPECT_EQ(csv.value(row, "played_s"), static_cast<double>(event.tick) / 1000);
        const auto who = event.by < players ? text(event.by + 1) : std::string();
        if (event.kind != EventKind::round_end) {
            EXPECT_EQ(csv.at(row, "who"), who);
        }
        if (event.kind == hit_kind("bolt_hit")) {
            EXPECT_EQ(csv.at(row, "whom"), text(event.subject + 1));
            EXPECT_EQ(csv.value(row, "amount"), event.amount);
            EXPECT_EQ(csv.at(row, "unit"), "hp");
        }
        if (event.kind == EventKind::death) {
            ++deaths;
            EXPECT_EQ(csv.at(row, "with"), name_of(static_cast<EventKind>(event.detail)));
        }
        if (!csv.at(row, "x_m").empty()) {
            ++placed;
            EXPECT_EQ(csv.value(row, "x_m"), event.place.x);
            EXPECT_EQ(csv.value(row, "y_m"), event.place.y);
            EXPECT_EQ(csv.value(row, "z_m"), event.place.z);
        }
        ++row;
    }
    EXPECT_EQ(row + 1, csv.size()) << "only the end is left";
    EXPECT_GT(placed, 20U);
    EXPECT_GT(deaths, 0U);
}

TEST(GameTables, PausesSkipsDevicesMarksAndTheEndAreRows) {
    const Csv csv(tables_of(table_recording().play()).events);
    std::vector<std::string> lines;
    for (std::size_t row = 0; row < csv.size(); ++row) {
        const auto& kind = csv.at(row, "kind");
        if (kind != "pause" && kind != "resume" && kind != "skip" && kind != "mark" && kind != "left" &&
            kind != "joined" && kind != "end")
            continue;
        lines.push_back(text(csv.at(row, "tick"), " ", kind, " ", csv.at(row, "who"), " ",
                             csv.at(row, "with"), " ", csv.at(row, "amount"), csv.at(row, "unit"),
                             csv.at(row, "note")));
    }
    const std::vector<std::string> expected{"4001 pause 2  ",
                                            "4601 resume   ",
                                            "5001 mark  1 ",
                                            "5001 mark  2 ",
                                            "7001 skip   300ticks",
                                            "8001 left 2 bot level_1 ",
                                            "8003 left 1 bot level_1 ",
                                            "8004 joined 2 bot level_1 ",
                                            "12000 end  clean " + table_recording().result};
    EXPECT_EQ(lines, expected);
}

TEST(GameTables, TheStateHasTheBitsThatTheMatchHad) {
    const Csv csv(tables_of(table_recording().play()).state);
    ASSERT_EQ(csv.size(), table_recording().states.size());
    std::size_t row = 0;
    for (const auto& state : table_recording().states) {
        const Tick tick = state.first;
        EXPECT_EQ(csv.at(row, "tick"), text(tick));
        EXPECT_EQ(csv.at(row, "paused"), tick > 4000 && tick <= 4600 ? "1" : "0");
        for (std::size_t p = 0; p < players; ++p) {
            const auto& m = state.second[p];
            const auto is = [&](const char* column, double value) {
                EXPECT_EQ(csv.value(row, text("p", p + 1, "_", column)), value) << tick << column;
            };
            is("x_m", m.position.x), is("y_m", m.position.y), is("z_m", m.position.z);
            is("vx_m_s", m.velocity.x), is("vy_m_s", m.velocity.y), is("vz_m_s", m.velocity.z);
            is("yaw_rad", m.yaw), is("pitch_rad", m.pitch), is("health_hp", m.health);
            is("energy_bolt", m.energy), is("dead", m.dead ? 1 : 0);
        }
        ++row;
    }
}

TEST(GameTables, EveryRunGivesTheSameBytes) {
    const auto first = tables_of(table_recording().play());
    const auto second = tables_of(table_recording().play());
    EXPECT_EQ(first.events, second.events);
    EXPECT_EQ(first.state, second.state);
}

TEST(GameTables, TheHeaderInWordsNamesSettingsAndProfileData) {
    const TemporaryFolder folder;
    const auto file = folder.path() / "header.thaumlog";
    input::DeviceSpec pad{
        .player = 1, .kind = input::DeviceKind::pad, .name = "pad\x1b[2J 1", .invert_y = true};
    pad.set_force_percent(40);
    pad.set_carried_percent(90, 100);
    pad.set_fluid_percent(2, 5);
    pad.box_um = {1, 2, 3};
    auto header = log_header(*duel_data(), {7, {pad}}, {"human", "bot\n1"});
    header.profile = {{"gesture", "circle", 1, Bytes(12)}};
    header.names = {"", "Bot\x1b[2J 1"};
    EXPECT_TRUE(input::LogWriter::create(file, header)->close("a draw").has_value());
    const auto lines = header_text(input::LogReader::open(file).value());
    constexpr const char* device_line =
        "\ndevice 1: pad 'pad\\x1b[2J 1' of player 2, look_rad_per_count 0.00087, turn_rad_per_s 3.5, "
        "invert_y, force 40 %, weight reduced by 10 %, fluid source 3 reduced by 95 %, box 1 x 2 x 3 um\n";
    for (const auto* line :
         {"log: format 2, 0 ticks, 0 hashes, 0 marks; closed with the result: a draw\n", "\nseed: 7\n",
          "\nplayer 2: bot\\x0a1\n", "\nname of player 2: Bot\\x1b[2J 1\n", device_line,
          "\nkind: event 5 death\n", "\nprofile data: gesture 'circle' of player 2, 12 bytes\n"})
        EXPECT_NE(lines.find(line), std::string::npos) << line << "is not in\n" << lines;
    EXPECT_EQ(lines.find("name of player 1"), std::string::npos);
}

}  // namespace
}  // namespace thaum::game::test

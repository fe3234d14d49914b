// thaum doctor: the parts of this machine that the game uses, which of them are missing, and how to get them.
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>

#include "audio/mixer.h"
#include "audio/sound_device.h"
#include "audio/synth.h"
#include "core/clock.h"
#include "core/file.h"
#include "core/json.h"
#include "core/one_line.h"
#include "core/processor.h"
#include "core/tell_user.h"
#include "core/text.h"
#include "game/app/command.h"
#include "game/app/content.h"
#include "game/command_line/arguments.h"
#include "game/hud/still.h"
#include "game/jackets/jacket.h"
#include "game/live/pad_setup.h"
#include "game/live/shared.h"
#include "game/settings/own_pads.h"
#include "game/settings/settings.h"
#include "haptics/safety.h"
#include "input/locked_sticks.h"
#include "input/pads.h"
#include "physics/bullet_maths.h"
#include "render/context.h"
#include "render/display.h"

namespace thaum::game::inline app {
namespace {

constexpr std::string_view doctor_help =
    R"(usage: thaum doctor [--json FILE]

Checks this machine and reports what is missing: processor, data files, OpenGL,
display, sound, the hands' devices, pads and their permissions, jackets, the
accuracy of a 1 kHz clock, and the folders of settings and logs. If there is a
display, a match is shown for three seconds to measure the delay from a movement
to its picture. Force feedback arms are listed with the numbers by which --hands
arm:0 names them. Each is used for two seconds without force, to measure how
evenly its ticks come and the delay from a pose to its force. Hold the arms still.

  --json FILE   the findings as JSON, replacing an older file; - for stdout

Exit code 0: a match can be played here; 1: a needed part is missing.
)";

constexpr std::size_t max_of_name_shown = 100;

enum class State { good, note, missing };

struct Finding {
    std::string what;
    State state{};
    std::string detail;
    std::string advice;  ///< what the user can do about the finding; empty: nothing
    /// Measured values, as pairs of name and value. The name ends with the unit.
    std::vector<std::pair<std::string, double>> metrics{};
};

using Data = std::shared_ptr<const MatchData>;

std::string first_value(const char* file, std::string_view key) {
    std::ifstream in(file);
    for (std::string line; std::getline(in, line);) {
        if (!line.starts_with(key)) continue;
        const auto colon = line.find(':');
        return colon == std::string::npos ? "" : line.substr(colon + 2);
    }
    return "unknown";
}

Finding processor() {
    const auto missing = missing_of_x86_64_v3();
    return {"processor", State::good,
            text(first_value("/proc/cpuinfo", "model name"), ", ", sysconf(_SC_NPROCESSORS_ONLN), " cores, ",
                 missing.length == 0 ? "x86-64-v3" : text("older than x86-64-v3, lacks", missing.text)),
            ""};
}

Finding mathematics() {
    const auto foreign = physics::foreign_maths();
    if (!foreign.empty())
        return {"mathematics", State::missing, text("Bullet calls the machine's own: ", foreign.front()),
                "link the program with all of thaum_physics"};
    return {"mathematics", State::good,
            text("ours, for Bullet too; probe ", hex(physics::maths_probe()), " (logs carry it)"), ""};
}

/// Report on the data files. If a fault lies in a file that the match does not read, the match can be played
/// all the same.
Finding data_files(const std::filesystem::path& assets, const Expected<Data>& data) {
    const auto report = check_content(assets);
    const auto files = text(assets.string(), ", ", report.files, " files");
    if (report.faults.empty()) return {"data files", State::good, text(files, ", no fault"), ""};
    return {"data files", data ? State::note : State::missing, short_words(report),
            text("correct them: ", files)};
}

Finding hands(const Expected<Data>& data) {
    if (!data) return {"hands", State::note, "not known without data files", ""};
    const auto& device = (*data)->device;
    const double cap = haptics::safety_limits(device, (*data)->haptic_rules.share).cap;
    return {"hands", State::good,
            text("each holds a simulated ", device.name, " of ", fixed(device.peak_force, 1), " N; at most ",
                 fixed(cap, 2), " N reach the hand"),
            ""};
}

/// A real arm that is measured outside of a match and without a force.
struct MeasuredArm {
    std::size_t number{};
    input::ArmServo servo{};
    Expected<std::unique_ptr<input::OpenArm>> arm{};
    Expected<void> started{};
};

Finding finding_of(const MeasuredArm& measured) {
    const std::string what = "arm", which = text("arm:", measured.number);
    if (!measured.arm)
        return {what, State::note, text(which, " could not be used"), measured.arm.error().message};
    if (!measured.started)
        return {what, State::missing, text(which, " does not start"), measured.started.error().message};
    const auto& arm = **measured.arm;
    const auto times = arm.times();
    const auto status = arm.status();
    const auto& facts = arm.facts();
    const bool good = status.state == input::ArmPresence::present;
    return {what, good ? State::good : State::missing,
            text(which, " is ", input::name_of(facts), " of ", fixed(facts.spec.peak_force, 1),
                 " N, measures ", facts.spec.sensed, " degrees of freedom, pushes in ", facts.spec.actuated,
                 facts.spec.actuated <= 3 ? " (no torques)" : "", ", library ", facts.driver, ": ",
                 told(times), arm.preferred() ? "" : "; its thread has no priority"),
            good && !arm.preferred() ? "allow real-time priority: a line '@GROUP - rtprio 60' in "
                                       "/etc/security/limits.d, then log in again"
                                     : status.text,
            metrics_of(times)};
}

/// Reports on the drivers of real arms and on each arm. All arms run at the same time, as the arms of two
/// players do in a match.
void add_arms(std::vector<Finding>& findings) {
    constexpr std::int64_t measured_ns = 2'000'000'000;
    for (const auto& kind : input::arm_drivers())
        findings.push_back({"arm driver", State::good,
                            text(kind.name, ": ", kind.about,
                                 kind.at_hang == input::AtHang::keeps_force
                                     ? "; its arms keep their force while the library hangs"
                                     : ""),
                            ""});
    std::vector<std::unique_ptr<MeasuredArm>> arms;
    const auto places = input::arm_places();
    for (std::size_t i = 0; i < places.size(); ++i) {
        auto& measured = *arms.emplace_back(std::make_unique<MeasuredArm>());
        measured.number = i;
        measured.arm = input::open_arm(places[i]);
        if (measured.arm) measured.started = (*measured.arm)->start(measured.servo.tick());
    }
    if (std::any_of(arms.begin(), arms.end(), [](const auto& a) { return a->arm && a->started; }))
        sleep_until_ns(monotonic_ns() + measured_ns);
    for (const auto& measured : arms) findings.push_back(finding_of(*measured));
}

Finding opengl(const std::filesystem::path& assets, const Expected<Data>& data) {
    if (!data) return {"OpenGL", State::note, "not tried without data files", ""};
    const auto still = Still::create(**data, assets, {320, 180});
    if (still) return {"OpenGL", State::good, "3.3 core, pictures in memory work", ""};
    return {"OpenGL", State::missing, still.error().message, "apt-get install libgl1-mesa-dri"};
}

/// Report on the input delay: plays a short match in a window with a mouse that moves by itself. If the
/// machine is so busy that no movement reached a picture, plays a longer one.
Finding input_to_picture(const std::filesystem::path& assets, const Expected<Data>& data) {
    const std::string what = "input delay";
    if (!data || !render::display_there())
        return {what, State::note, "not measured without data files and display", ""};
    LiveReport report;
    LivePlan plan{.data = *data, .assets = assets, .probe = true, .report = &report};
    plan.seats = {live::Seat{.kind = SeatKind::keyboard_mouse},
                  live::Seat{.kind = SeatKind::bot, .bot = "1"}};
    for (const double duration : {3.0, 60.0}) {
        plan.seconds = duration;
        if (const auto played = run_live(plan); !played) {
            refuse(played.error());
            return {what, State::note, "not measured: no window", ""};
        }
        if (report.inputs != 0) break;
    }
    if (report.inputs == 0) return {what, State::note, "not measured: no movement reached a picture", ""};
    return {what,
            State::good,
            text(fixed(report.input_ms_median, 0), " ms in the middle, ", fixed(report.input_ms_p99, 0),
                 " ms at 99 % of ", report.inputs,
                 " movements, from their arrival in this program to the picture handed over; the delays of "
                 "mouse and display come on top"),
            "",
            {{"input_to_picture_ms_median", report.input_ms_median},
             {"input_to_picture_ms_p99", report.input_ms_p99},
             {"inputs", static_cast<double>(report.inputs)}}};
}

Finding display() {
    if (const auto there = render::display_for_windows(); !there.empty())
        return {"display", State::good, there, ""};
    if (const auto other = render::display_not_spoken(); !other.empty())
        return {"display", State::note, text(other, " alone, but this GLFW opens windows on X11 only"),
                "start XWayland, which most desktops have, so that DISPLAY is set"};
    return {"display", State::note, "none: thaum plays a duel of bots off-screen",
            "start it in a desktop session"};
}

/// Report on sounds and loudspeakers. The game can be played without them, in silence, so they never count as
/// missing.
Finding sound(const std::filesystem::path& assets) {
    const auto bank = audio::load_sounds(assets / "sounds");
    if (!bank) return {"sound", State::note, bank.error().message, "the game is silent until this is mended"};
    if (!bank->faulty.empty())
        return {"sound", State::note, bank->faulty[0].fault.message,
                "that sound is silent until this is mended"};
    // The mixer is created only because it initialises OpenAL, as in the game.
    const auto mixer = audio::Mixer::create(*bank, {});
    if (!mixer) return {"sound", State::note, mixer.error().message, "the game is silent"};
    const auto device = audio::openal_device();
    if (const auto opened = device->open(); !opened)
        return {"sound", State::note, opened.error().message, "the game is silent until there is one"};
    device->close();
    return {"sound", State::good, text(bank->sounds.size(), " sounds, and a device that plays them"), ""};
}

/// Result of opening a player's jacket. The jacket stays silent, and nothing is recorded.
Finding jacket_of_player(const Settings& settings, std::uint32_t player,
                         const std::filesystem::path& assets) {
    const auto& own = settings.players.at(player);
    const auto jacket = parse_jacket(own.jacket).value_or(Jacket{});
    const auto output = jacket_output(jacket, player);
    const auto whose = text("player ", player + 1, ": ", output->name());
    if (!own.jacket_layout.empty()) {
        if (const auto layout = load_own_layout(own.jacket_layout, jacket, assets); !layout)
            return {"jacket", State::note, text(whose, ": ", layout.error().message),
                    "it has its usual layout"};
    }
    const auto checked = jacket.maker->check(jacket, *output);
    return {"jacket", checked.usable ? State::good : State::note, text(whose, checked.words), checked.advice};
}

/// Reports on the jackets that the settings file names, and on other jackets that are plugged in.
void add_jackets(std::vector<Finding>& findings, const std::filesystem::path& assets) {
    std::error_code ignored;
    const auto file = settings_file();
    const auto read = std::filesystem::exists(file, ignored) ? load_settings(file, assets) : Settings{};
    for (std::uint32_t p = 0; read && p < players; ++p)
        if (!read->players.at(p).jacket.empty()) findings.push_back(jacket_of_player(*read, p, assets));
    for (const auto& maker : jacket_makers()) {
        if (maker.find == nullptr) continue;
        for (const auto& found : maker.find())
            findings.push_back({std::string(found.what), State::good, found.words, ""});
    }
}

/// Reports pads, joysticks that SDL does not know, and devices that this user has no right to read.
void add_pads(std::vector<Finding>& findings) {
    const auto named = [](const std::string& name, const std::string& path) {
        return text(printable(name, max_of_name_shown), " (", path, ")");
    };
    const auto before = findings.size();
    auto own = load_own_pads(own_pads_file(settings_file()));
    for (const auto& fault : own.faults)
        findings.push_back({"pad", State::missing, in_one_line(fault),
                            "correct this file of the pads that were set up, or delete what is faulty"});
    input::PadReader reader(std::move(own.mappings));
    const auto pads = reader.poll();
    if (!reader.fault().empty())
        findings.push_back({"pad", State::missing, reader.fault(), "reinstall libsdl2-2.0-0"});
    for (const auto& pad : pads)
        if (pad.present)
            findings.push_back({"pad", State::good, text(named(pad.name, pad.path), " plays"), ""});
    for (const auto& name : reader.left_over())
        findings.push_back({"pad", State::note,
                            text(printable(name, max_of_name_shown), " cannot play: only ", pads.size(),
                                 " pads can be used at once"),
                            ""});
    for (const auto& stick : reader.sticks())
        findings.push_back({"pad", State::note,
                            text(named(stick.name, stick.path), " is a joystick that is not known"),
                            "start thaum and choose 'Set up' on the page Controls, or put a line for it into "
                            "SDL_GAMECONTROLLERCONFIG"});
    for (const auto& stick : input::locked_sticks())
        findings.push_back({"pad", State::missing, text(named(stick.name, stick.path), " may not be read"),
                            std::string(how_to_unlock)});
    if (findings.size() == before)
        findings.push_back({"pad", State::note, "none plugged in: player 2 has the keypad", ""});
}

/// Delays of `count` wake-ups of this thread at 1 kHz (us), sorted.
std::vector<double> wake_up_delays(int count) {
    std::vector<double> late;
    auto due = monotonic_ns();
    for (int i = 0; i < count; ++i) {
        due += 1'000'000;
        sleep_until_ns(due);
        late.push_back(static_cast<double>(monotonic_ns() - due) / 1e3);
    }
    std::sort(late.begin(), late.end());
    return late;
}

Finding tick_clock() {
    const auto late = wake_up_delays(2000);
    const auto at = [&](double share) {
        return fixed(late[static_cast<std::size_t>(share * static_cast<double>(late.size() - 1))], 0);
    };
    return {
        "1 kHz clock", State::good,
        text("late by ", at(0.5), " us in the middle, ", at(0.99), " us at 99 %, ", at(1), " us at worst"),
        ""};
}

Finding folder(const std::string& what, const std::filesystem::path& path, const char* variable) {
    if (path.empty())
        return {what, State::missing, "there is no home folder", text("set HOME, or ", variable)};
    auto existing = path;
    std::error_code ignored;
    while (!existing.empty() && !std::filesystem::exists(existing, ignored))
        existing = existing.parent_path();
    const bool writable = ::access(existing.c_str(), W_OK) == 0;
    return {what, writable ? State::good : State::missing,
            text(path.string(), writable ? "" : " cannot be written"),
            writable ? "" : text("make it writable, or set ", variable)};
}

/// Report on the settings file: tests whether a match can use it. A missing file is good, because the first
/// match writes one.
Finding settings(const std::filesystem::path& assets) {
    const auto file = settings_file();
    auto found = folder("settings", file.parent_path(), "XDG_CONFIG_HOME");
    std::error_code ignored;
    if (found.state != State::good || !std::filesystem::exists(file, ignored)) return found;
    if (const auto read = load_settings(file, assets); !read)
        return {"settings", State::note, text(read.error().message, "; defaults replace wrong values"),
                "correct the file, or move it away: then a new one is written"};
    found.detail = file.string();
    return found;
}

Expected<Data> shared_match_data(const std::filesystem::path& assets) {
    auto loaded = load_match_data(assets, {});
    if (!loaded) return loaded.error();
    return std::make_shared<const MatchData>(std::move(*loaded));
}

std::vector<Finding> examine() {
    const auto assets = find_assets();
    const auto data = shared_match_data(assets);
    std::vector<Finding> findings{processor(),  mathematics(),        data_files(assets, data),
                                  hands(data),  opengl(assets, data), display(),
                                  sound(assets)};
    add_pads(findings);
    add_jackets(findings, assets);
    add_arms(findings);
    findings.push_back(tick_clock());
    findings.push_back(input_to_picture(assets, data));
    findings.push_back(settings(assets));
    findings.push_back(folder("match logs", matches_folder(), "XDG_DATA_HOME"));
    return findings;
}

std::string_view word(State state) {
    return state == State::good ? "good" : state == State::note ? "note" : "MISSING";
}

/// JSON object of a finding. Its keys are in alphabetical order, as in the whole report.
Json json_of(const Finding& f) {
    Json json{{"advice", f.advice}, {"detail", f.detail}};
    std::map<std::string_view, double> sorted;
    for (const auto& [name, value] : f.metrics) sorted[name] = value;
    Json metrics;
    for (const auto& [name, value] : sorted) metrics.set(name, value);
    if (!sorted.empty()) json.set("metrics", metrics);
    json.set("state", word(f.state));
    json.set("what", f.what);
    return json;
}

std::string as_json(const std::vector<Finding>& findings) {
    auto list = Json::array();
    for (const auto& f : findings) list.push_back(json_of(f));
    const Json report{{"findings", list}, {"thaum", THAUM_VERSION}};
    return dump(report, 2) + "\n";
}

void print(const std::vector<Finding>& findings) {
    for (const auto& f : findings) {
        std::printf("%-8s %-12s ", std::string(word(f.state)).c_str(), f.what.c_str());
        print_line(f.detail);
        if (!f.advice.empty()) print_line(text("                      -> ", f.advice));
    }
}

int run_doctor(const std::vector<std::string>& words) {
    static constexpr Option options[] = {output("--json")};
    const auto arguments = Arguments::parse(words, options);
    if (!arguments) return refuse(arguments.error());
    if (!arguments->plain().empty()) return refuse({text("doctor takes no '", arguments->plain()[0], "'")});
    const auto json = arguments->value("--json");
    if (const auto free = json && json != "-" ? check_output(*json) : Expected<void>(); !free)
        return refuse(free.error());
    const auto findings = examine();
    if (json == "-") {
        std::printf("%s", as_json(findings).c_str());
    } else {
        print(findings);
        if (json) {
            if (const auto written = write_text_file(*json, as_json(findings)); !written)
                return refuse(written.error());
        }
    }
    const bool missing = std::any_of(findings.begin(), findings.end(),
                                     [](const auto& f) { return f.state == State::missing; });
    return missing ? does_not_hold : done;
}

const CommandRegistration registration_of_doctor({.name = "doctor", .help = doctor_help, .run = run_doctor});

}  // namespace

}  // namespace thaum::game::inline app

// thaum check: reports all faults of all data files.
#include <cstdio>

#include "core/file.h"
#include "core/json.h"
#include "core/tell_user.h"
#include "core/text.h"
#include "game/app/command.h"
#include "game/app/content.h"
#include "game/command_line/arguments.h"
#include "game/data/match_data.h"
#include "game/hud/still.h"

namespace thaum::game::inline app {
namespace {

constexpr std::string_view check_help =
    R"(usage: thaum check [FOLDER] [--json FILE]

Reads all data files of a folder as the game does, and lists every fault: arenas,
rules, bots, wands, spells, potions, gestures, devices, sounds, shaders, what is
felt on the body, lessons and settings. A line has the file, its line, the key,
what is wrong, and what is allowed there. Names in the files are compared with
the files: a sound that an event names and that is not there is a fault, and so
is a file that nothing reads or names. A note is on what can be played and is
probably not meant, such as an ingredient of which an arena has no niche.

  FOLDER        the folder of data files; without it: the one that the game uses
  --json FILE   the faults as JSON, replacing an older file; - for stdout

Exit code 0: no fault; 1: there are faults; 2: wrong usage.
)";

/// Compiles the shaders if this machine has OpenGL, and reports their faults. A missing OpenGL is no fault of
/// the data files; `thaum doctor` reports it.
void add_shaders(const std::filesystem::path& assets, ContentReport& report) {
    const auto data = load_match_data(assets, {});
    if (!data) return;
    const auto still = Still::create(*data, assets, {64, 64});
    const auto folder = (assets / "shaders").string();
    if (!still && still.error().message.find(folder) != std::string::npos)
        report.faults.push_back(still.error().message);
}

std::string as_json(const std::filesystem::path& assets, const ContentReport& report) {
    auto list = Json::array();
    for (const auto& fault : report.faults) list.push_back(fault);
    const Json json{{"faults", list},
                    {"files", static_cast<std::uint64_t>(report.files)},
                    {"folder", assets.string()},
                    {"notes", report.notes},
                    {"thaum", THAUM_VERSION}};
    return dump(json, 2) + "\n";
}

void print(const std::filesystem::path& assets, const ContentReport& report) {
    for (const auto& fault : report.faults) print_line(fault);
    for (const auto& note : report.notes) print_line(text("note: ", note));
    const auto count = report.faults.size();
    print_line(text(assets.string(), ": ", report.files, " files, ",
                    count == 0 ? "no fault" : text(count, count == 1 ? " fault" : " faults")));
}

int run_check(const std::vector<std::string>& words) {
    static constexpr Option options[] = {output("--json")};
    const auto arguments = Arguments::parse(words, options);
    if (!arguments) return refuse(arguments.error());
    if (arguments->plain().size() > 1)
        return refuse({text("check takes one folder, not also '", arguments->plain()[1], "'")});
    const std::filesystem::path assets =
        arguments->plain().empty() ? find_assets() : std::filesystem::path(arguments->plain()[0]);
    const auto json = arguments->value("--json");
    if (const auto free = json && json != "-" ? check_output(*json) : Expected<void>(); !free)
        return refuse(free.error());
    std::error_code unknown;
    if (!arguments->plain().empty() && !std::filesystem::is_directory(assets, unknown))
        return refuse({text(assets.string(), ": there is no such folder")});
    auto report = check_content(assets);
    add_shaders(assets, report);
    if (json == "-") {
        std::printf("%s", as_json(assets, report).c_str());
    } else {
        print(assets, report);
        if (json) {
            if (const auto written = write_text_file(*json, as_json(assets, report)); !written)
                return refuse(written.error());
        }
    }
    return report.faults.empty() ? done : does_not_hold;
}

const CommandRegistration registration_of_check({.name = "check", .help = check_help, .run = run_check});

}  // namespace

}  // namespace thaum::game::inline app

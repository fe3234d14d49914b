#include "structure/rules.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string_view>

namespace thaum::structure {
namespace {

namespace fs = std::filesystem;

/// Floor (level) of each part (top folder of the engine or program) of the tree. A part may include itself
/// and parts on lower floors.
const std::map<std::string, int, std::less<>> floors = {
    {"core", 0},    {"ecs", 1},     {"field", 1}, {"physics", 2}, {"fluid", 2}, {"haptics", 2},  {"audio", 2},
    {"tactile", 2}, {"gesture", 2}, {"input", 2}, {"render", 2},  {"game", 3},  {"examples", 3},
};

/// Floor of each room of the game; a room is a folder with its subfolders. A room may include itself and
/// rooms on lower floors.
const std::map<std::string, int, std::less<>> game_floors = {
    {"components", 0},                      // components, which are plain data of entities
    {"arena", 1},                           // shape of the arena
    {"data", 2},                            // contents of data files, and texts made from them
    {"brew", 3},          {"context", 3},   // fluid of the cauldron; data that all systems share
    {"stations", 4},      {"wands", 4},     // cauldron, crystal and orb; wands
    {"spells", 4},        {"effects", 4},   // spells; kinds of effect on wizards
    {"casting", 5},                         // strokes that are drawn and read
    {"match", 6},                           // players, hands, order of the systems, logs, results
    {"senses", 7},        {"bots", 7},      // what is heard and felt of a match; opponents
    {"jackets", 7},                         // drivers of tactile jackets
    {"picture", 8},       {"scenario", 8},  // plain data for drawing; Lua scenarios
    {"settings", 8},       // the settings file, and folders of players' feel profiles and gestures
    {"scene", 9},          // meshes of the arena, wizards, brew, crystals and orb
    {"hud", 10},           // texts, cards and menus over the scene
    {"range", 11},         // the practice range: dummy, lessons, gesture wall
    {"menu", 12},          // start screen, pause and pages of settings
    {"live", 13},          // a match in real time: windows, devices, threads, sound
    {"command_line", 13},  // parsing of a command's arguments, and exit codes
    {"lab", 14},           // labs: the cauldron's fluid alone, and scans to feel and carve
    {"app", 15},           // the program and its commands
};

/// Includes that are allowed between parts of the tree on the same floor (level): from, to.
const std::set<std::pair<std::string, std::string>> level_includes = {{"input", "haptics"},
                                                                      {"input", "tactile"}};

/// Parts that take and return plain data. They must not include the ECS.
const std::set<std::string, std::less<>> numerical = {"field", "fluid", "haptics", "tactile", "gesture"};

/// Folders of the engine with reference solvers and checks, each a library of its own. Commands, benchmarks
/// and tests may include them; other parts of a program may not.
const std::set<std::string, std::less<>> folders_apart = {"fluid/classic", "gesture/trials", "haptics/audit",
                                                          "render/audit"};

std::string read(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// Returns true for folders that are not part of the repository, such as build output.
bool is_foreign_folder(const std::string& name) {
    return name == ".git" || name == "build" || name.starts_with("build-") || name == "out" ||
           name == ".cache";
}

/// Regular files of a tree, sorted, without build output.
std::vector<fs::path> files_under(const fs::path& folder) {
    std::vector<fs::path> result;
    if (!fs::exists(folder)) return result;
    for (auto it = fs::recursive_directory_iterator(folder); it != fs::recursive_directory_iterator(); ++it) {
        if (it.depth() == 0 && is_foreign_folder(it->path().filename().string())) {
            it.disable_recursion_pending();
        } else if (it->is_regular_file()) {
            result.push_back(it->path());
        }
    }
    std::sort(result.begin(), result.end());
    return result;
}

bool is_source(const fs::path& path) {
    static const std::set<std::string, std::less<>> endings = {".h", ".cpp", ".inl", ".c", ".hpp"};
    return endings.contains(path.extension().string());
}

std::string relative_to(const fs::path& root, const fs::path& path) {
    return path.lexically_normal().lexically_relative(root.lexically_normal()).generic_string();
}

std::string at_line(const std::string& file, std::size_t line, const std::string& what) {
    return file + ":" + std::to_string(line) + ": " + what;
}

std::vector<std::string> folders_of(const std::string& path) {
    std::vector<std::string> result;
    std::istringstream in(path);
    for (std::string part; std::getline(in, part, '/');) result.push_back(part);
    return result;
}

// ---- which part may include which -------------------------------------------------------------------------

/// Position of a file in the tree: for example ("ecs", "ecs") or ("game", "game/components").
struct Place {
    std::string part;    ///< key of `floors`; empty for files outside engine/ and game/
    std::string folder;  ///< folder whose detail/ the file may include
    bool in_detail = false;
    std::string apart{};  ///< folder of `folders_apart` that holds the file; empty: none
};

Place place_of(const std::string& path) {
    const auto folders = folders_of(path);
    if (folders.size() < 2) return {};
    const bool in_detail = std::find(folders.begin(), folders.end(), "detail") != folders.end();
    if (folders[0] == "game") return {"game", folders.size() > 2 ? "game/" + folders[1] : "game", in_detail};
    if (folders[0] != "engine") return {};
    const auto inner = folders[1] + "/" + folders[2 < folders.size() ? 2 : 1];
    return {folders[1], folders[1], in_detail, folders_apart.contains(inner) ? inner : ""};
}

/// File that an include refers to, relative to the root; empty for a system header.
std::string included_file(const fs::path& root, const fs::path& from, const std::string& name, bool quoted) {
    for (const auto& base : {from.parent_path(), root / "engine", root}) {
        if (fs::exists(base / name)) return relative_to(root, base / name);
    }
    const auto first = folders_of(name).front();
    if (first == "game") return name;
    if (floors.contains(first)) return "engine/" + name;
    return quoted ? "engine/" + name : "";
}

/// Name of the folder in game/; empty for files elsewhere.
std::string game_folder_of(const Place& place) {
    const std::string_view game = "game/";
    return place.folder.starts_with(game) ? place.folder.substr(game.size()) : "";
}

/// Fault of an include between two folders of the game; empty: none.
std::string game_folder_fault(const std::string& from, const std::string& to) {
    if (from == to) return "";
    if (!game_floors.contains(to) || !game_floors.contains(from))
        return "is not a folder in game_floors (rules.cpp)";
    return game_floors.at(to) < game_floors.at(from) ? "" : "only lower floors may be included";
}

/// Fault of an include; empty: none.
std::string include_fault(const Place& from, const Place& to) {
    if (to.in_detail && from.folder != to.folder) return "only its own folder may include detail/";
    if (!to.apart.empty() && from.apart != to.apart && from.folder != "game/app")
        return "a baseline or an audit is only for commands, benchmarks and tests";
    if (from.part == "game" && to.part == "game")
        return game_folder_fault(game_folder_of(from), game_folder_of(to));
    if (from.part == to.part) return "";
    if (!floors.contains(to.part) || !floors.contains(from.part))
        return "is not a part in floors (rules.cpp)";
    if (to.part == "ecs" && numerical.contains(from.part)) return "this part must not include the ECS";
    if (level_includes.contains({from.part, to.part})) return "";
    return floors.at(to.part) < floors.at(from.part) ? "" : "only lower floors may be included";
}

void check_includes(const fs::path& root, const fs::path& file, Faults& faults) {
    static const std::regex include(R"re(^\s*#\s*include\s*(["<])([^">]+)[">])re");
    const auto name = relative_to(root, file);
    const auto from = place_of(name);
    std::istringstream lines(read(file));
    std::size_t number = 0;
    for (std::string line; std::getline(lines, line);) {
        ++number;
        std::smatch match;
        if (!std::regex_search(line, match, include)) continue;
        const auto target = included_file(root, file, match[2], match[1] == "\"");
        if (target.empty()) continue;
        const auto to = place_of(target);
        const auto fault = include_fault(from, to);
        if (fault.empty()) continue;
        std::string arrow = from.folder;
        arrow.append(" -> ").append(target).append(": ").append(fault);
        faults.push_back(at_line(name, number, arrow));
    }
}

/// Headers of the engine that a file includes, relative to the root.
std::set<std::string> engine_headers_of(const fs::path& root, const fs::path& file) {
    std::set<std::string> result;
    std::istringstream lines(read(file));
    for (std::string line; std::getline(lines, line);) {
        const std::string_view opening = "#include \"";
        if (!line.starts_with(opening)) continue;
        const auto name = line.substr(opening.size(), line.find('"', opening.size()) - opening.size());
        const auto target = included_file(root, file, name, true);
        if (target.starts_with("engine/")) result.insert(target);
    }
    return result;
}

// ---- files must not contain paths of one machine ----------------------------------------------------------

bool is_word(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.' || c == '}' || c == '-';
}

/// Position of `path` in the text. A match that is only the end of a longer path does not count.
std::size_t find_path(const std::string& text, const std::string& path) {
    auto at = text.find(path);
    while (at != std::string::npos && at > 0 && is_word(text[at - 1])) at = text.find(path, at + 1);
    return at;
}

// ---- which files may open other files ---------------------------------------------------------------------

/// Files that may open other files directly, each with the reason.
const std::map<std::string, std::string_view, std::less<>> may_open = {
    {"engine/core/file.cpp", "opens placeholders of closed streams"},
    {"engine/core/file_reader.cpp", "the reader of all others"},
    {"engine/core/file_writer.cpp", "the writer of all others"},
    {"engine/core/write_rule.cpp", "looks whether a file is a recording"},
    {"engine/input/log_reader.cpp", "reads pieces of a recording, and declares it"},
    {"engine/input/log_writer.cpp", "makes new files only"},
    {"engine/input/locked_sticks.cpp", "tries whether devices may be opened"},
    {"engine/input/rumble.cpp", "opens devices"},
    {"engine/render/priority.cpp", "reads what the system says of threads"},
    {"game/app/commands/doctor.cpp", "reads what the system says of devices"},
    {"tools/bench/report.cpp", "reads what the system says of the processor"},
    {"tools/bench/soak.cpp", "reads what the system says of memory"},
    {"tools/suite/mutant_switch.h", "is no part of the program"},
};

/// Files that may read what belongs to the program: settings, profiles and recorded gestures.
const std::set<std::string, std::less<>> may_read_own = {
    "engine/core/file.cpp",           "engine/core/file.h",
    "game/settings/settings.cpp",     "game/settings/settings_edit.cpp",
    "game/settings/feel_profile.cpp", "game/settings/own_gestures.cpp",
    "game/settings/own_pads.cpp",
};

/// Files that may read environment variables directly.
const std::set<std::string, std::less<>> may_read_environment = {"engine/core/environment.cpp",
                                                                 "tools/suite/mutant_switch.h"};

/// Text by which code that opens a file is recognised, such as a function's name with its bracket.
constexpr std::array<std::string_view, 16> openers = {
    "::open(",     "::openat(",    "::creat(",   "fopen(",     "freopen(", "fdopen(",
    "popen(",      "mkstemp(",     "ifstream",   "ofstream",   "fstream",  "luaL_loadfil",
    "luaL_dofile", "FT_New_Face(", "stbi_load(", "parse_file("};

bool opens_a_file(std::string_view code) {
    return std::ranges::any_of(openers, [&](std::string_view opener) {
        const auto at = code.find(opener);
        const auto is_letter = [](char c) {
            return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
        };
        return at != std::string_view::npos && (at == 0 || !is_letter(code[at - 1]));
    });
}

void check_opens(const std::string& name, const std::string& text, Faults& faults) {
    std::istringstream lines(text);
    std::string line;
    for (std::size_t number = 1; std::getline(lines, line); ++number) {
        const auto code = line.substr(0, line.find("//"));
        if (code.starts_with("#include")) continue;
        if (!may_open.contains(name) && opens_a_file(code))
            faults.push_back(at_line(name, number,
                                     "opens a file itself; use core/file.h, which declares what is read, "
                                     "or list the file in tests/structure/rules.cpp"));
        const bool reads_own = code.find("read_own_text_file") != std::string::npos ||
                               code.find("FileReader::Owner::program") != std::string::npos;
        if (!may_read_own.contains(name) && reads_own)
            faults.push_back(at_line(name, number,
                                     "reads a file as the program's own, so that an output may replace it; "
                                     "use read_text_file, or list the file in tests/structure/rules.cpp"));
        if (!may_read_environment.contains(name) && code.find("getenv(") != std::string::npos)
            faults.push_back(at_line(name, number,
                                     "reads the environment itself; use core/environment.h, for which an "
                                     "empty variable is not set"));
    }
}

// ---- lengths of files and comments ------------------------------------------------------------------------

constexpr std::size_t max_file_lines = 600, max_comment_line = 110;

std::vector<fs::path> own_sources(const fs::path& root) {
    std::vector<fs::path> result;
    for (const auto* top : {"engine", "game", "tools", "tests"}) {
        for (const auto& file : files_under(root / top)) {
            if (is_source(file)) result.push_back(file);
        }
    }
    return result;
}

std::string too_long(const std::string& what, std::size_t lines, std::size_t most) {
    return what + " has " + std::to_string(lines) + " lines, more than " + std::to_string(most) +
           "; split it where its subject changes";
}

}  // namespace

Faults upward_includes(const fs::path& root) {
    Faults faults;
    for (const auto* top : {"engine", "game"}) {
        for (const auto& file : files_under(root / top)) {
            if (is_source(file)) check_includes(root, file, faults);
        }
    }
    return faults;
}

Faults machine_paths(const fs::path& root) {
    // The strings are assembled here, so that this source file does not contain them.
    std::vector<std::string> forbidden = {std::string("/ho") + "me/", std::string("/ro") + "ot/"};
    const auto here = fs::canonical(root).generic_string();
    // The path of this tree is only forbidden if it has several folders, because a single folder name may be
    // any word.
    if (folders_of(here).size() > 2) forbidden.push_back(here);
    Faults faults;
    for (const auto& file : files_under(root)) {
        const auto text = read(file);
        for (const auto& path : forbidden) {
            const auto at = find_path(text, path);
            if (at == std::string::npos) continue;
            const auto line = std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n');
            faults.push_back(at_line(relative_to(root, file), static_cast<std::size_t>(line) + 1,
                                     "names a folder of one machine; write a relative path: " + path));
        }
    }
    return faults;
}

Faults unbuilt_tests(const fs::path& root) {
    std::string cmake;
    const auto files = files_under(root / "tests");
    for (const auto& file : files) {
        if (file.extension() == ".cmake" || file.filename() == "CMakeLists.txt") cmake += read(file);
    }
    Faults faults;
    for (const auto& file : files) {
        if (file.extension() != ".cpp") continue;
        const auto name = relative_to(root / "tests", file);
        if (cmake.find(name) == std::string::npos) {
            faults.push_back(at_line("tests/" + name, 1,
                                     "is in no CMake file of tests/, so it never runs; add it to one"));
        }
    }
    return faults;
}

Faults headers_without_title(const fs::path& root) {
    Faults faults;
    for (const auto& file : files_under(root / "engine")) {
        const auto name = relative_to(root / "engine", file);
        if (file.extension() != ".h" || place_of("engine/" + name).in_detail) continue;
        if (!read(file).starts_with("// " + name + ": ")) {
            faults.push_back(at_line("engine/" + name, 1, "must open with \"// " + name + ": purpose\""));
        }
    }
    return faults;
}

Faults internal_headers(const fs::path& root) {
    std::map<std::string, std::set<std::string>> includes;
    for (const auto& file : own_sources(root))
        includes[relative_to(root, file)] = engine_headers_of(root, file);
    // A header that a file of another folder includes is public, and so are the headers that it includes.
    std::set<std::string> open;
    std::vector<std::string> next;
    const auto reach = [&](const std::string& header) {
        if (open.insert(header).second) next.push_back(header);
    };
    for (const auto& [file, headers] : includes)
        for (const auto& header : headers)
            if (place_of(file).folder != place_of(header).folder) reach(header);
    while (!next.empty()) {
        const auto header = next.back();
        next.pop_back();
        for (const auto& included : includes[header]) reach(included);
    }
    Faults faults;
    for (const auto& [file, headers] : includes) {
        if (!file.starts_with("engine/") || !file.ends_with(".h") || place_of(file).in_detail) continue;
        if (!open.contains(file))
            faults.push_back(at_line(file, 1, "only its own folder includes it; move it to detail/"));
    }
    return faults;
}

Faults opens_around_the_rule(const fs::path& root) {
    Faults faults;
    for (const auto& file : own_sources(root)) {
        const auto name = relative_to(root, file);
        if (!name.starts_with("tests/")) check_opens(name, read(file), faults);
    }
    return faults;
}

Faults long_files(const fs::path& root) {
    Faults faults;
    for (const auto& file : own_sources(root)) {
        const auto text = read(file);
        const auto lines = static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
        if (lines > max_file_lines)
            faults.push_back(
                at_line(relative_to(root, file), 1, too_long("the file", lines, max_file_lines)));
    }
    return faults;
}

Faults long_comments(const fs::path& root) {
    // Longer lines are allowed for tables, drawings and code in comments, which are indented.
    static const std::regex comment(R"(^\s*///?\s?\s?[^\s|/])");
    Faults faults;
    for (const auto& file : own_sources(root)) {
        std::istringstream lines(read(file));
        std::size_t number = 0;
        for (std::string line; std::getline(lines, line);) {
            ++number;
            if (line.size() > max_comment_line && std::regex_search(line, comment))
                faults.push_back(at_line(
                    relative_to(root, file), number,
                    "the comment is longer than " + std::to_string(max_comment_line) + " characters"));
        }
    }
    return faults;
}

Faults wrong_namespaces(const fs::path& root) {
    static const std::regex opened(R"(^namespace thaum::(\w+)(::inline (\w+))?)");
    Faults faults;
    for (const auto& file : files_under(root / "game")) {
        if (!is_source(file)) continue;
        const auto name = relative_to(root, file);
        const auto room = std::next(fs::path(name).begin())->string();
        std::istringstream lines(read(file));
        bool own = false, any = false;
        for (std::string line; std::getline(lines, line);) {
            std::smatch found;
            if (!std::regex_search(line, found, opened) || found[1] != "game") continue;
            any = true;
            own = own || found[3] == room;
        }
        if (any && !own)
            faults.push_back(at_line(name, 1, "names stand in namespace thaum::game::inline " + room));
    }
    return faults;
}

}  // namespace thaum::structure

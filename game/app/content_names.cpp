#include "game/app/content_names.h"

#include <algorithm>
#include <array>
#include <map>
#include <string_view>

#include "core/left_behind.h"
#include "core/near_name.h"
#include "core/one_line.h"
#include "core/text.h"
#include "game/data/match_data.h"
#include "game/data/spell.h"

namespace thaum::game::inline app {
namespace {

using Names = std::vector<std::string_view>;

constexpr std::size_t longest_shown = 200;
/// Folders whose files are chosen by name, in the menu and on the command line.
constexpr std::array<std::string_view, 4> chosen_folders{"arenas", "bots", "mutators", "rules"};

/// Rule for the files that a folder may hold.
struct FolderRule {
    Names endings;                     ///< allowed endings of the folder's files
    std::vector<std::string> names{};  ///< allowed names without ending; empty: any name
    std::string_view what{};           ///< noun for a file of this folder, for messages
};

template <class Kinds>
std::vector<std::string> names_of(const Kinds& kinds) {
    std::vector<std::string> names;
    for (const auto& kind : kinds) names.emplace_back(kind.name);
    return names;
}

/// Rules for all folders by their path within the folder of data files; "" is that folder itself.
std::map<std::string, FolderRule> folder_rules() {
    const Names data{".toml"};
    return {{"",
             {data,
              {"apprentice", "casting", "cauldron", "crystal", "events", "haptics", "materials", "orb",
               "range", "settings"},
              "file of rules"}},
            {"arenas", {data}},
            {"bots", {data}},
            {"carving", {data}},
            {"devices", {data}},
            {"gestures", {data}},
            {"mutators", {data}},
            {"pictures", {{".png"}}},
            {"potions", {data}},
            {"rules", {data}},
            {"scenarios", {{".lua"}}},
            {"shaders", {{".vert", ".frag", ".glsl"}}},
            {"sounds", {{".toml", ".md"}}},
            {"spells", {data}},
            {"tactile", {data, {"sound"}, "file about the body"}},
            {"tactile/effects", {{".toml", ".tact"}}},
            {"tactile/layouts", {data}},
            {"wands", {data}},
            {"wizards", {data, {"wizard"}, "wizard"}}};
}

Names views_of(const std::vector<std::string>& names) { return {names.begin(), names.end()}; }

std::string listed(const Names& names) {
    std::string all;
    for (const auto name : names) all += text(all.empty() ? "" : ", ", name);
    return all;
}

class Walk {
public:
    explicit Walk(const std::filesystem::path& assets) : assets_(assets), rules_(folder_rules()) {}

    KnownFiles walk() {
        look_into(assets_, "");
        std::sort(found_.faults.begin(), found_.faults.end());
        std::sort(found_.read.begin(), found_.read.end());
        return std::move(found_);
    }

private:
    std::string shown(const std::string& name) const {
        return printable(shown_path(assets_, name), longest_shown);
    }

    void look_into(const std::filesystem::path& folder, const std::string& name) {
        std::error_code error;
        std::filesystem::directory_iterator it(folder, error);
        for (const std::filesystem::directory_iterator end; !error && it != end; it.increment(error))
            look_at(it->path(), name);
        if (error)
            found_.faults.push_back(text(shown(name), ": the folder cannot be read: ", error.message()));
    }

    void look_at(const std::filesystem::path& path, const std::string& folder) {
        const auto file = path.filename().string();
        if (is_left_behind(file)) return;
        const auto name = folder.empty() ? file : text(folder, "/", file);
        std::error_code unknown;
        if (!std::filesystem::is_directory(path, unknown)) return check_file(path, folder, name);
        if (rules_.contains(name)) return look_into(path, name);
        Names folders;
        for (const auto& [known, rule] : rules_) folders.push_back(known);
        found_.faults.push_back(
            text(shown(name), ": nothing reads this folder", did_you_mean(name, folders)));
    }

    void check_file(const std::filesystem::path& path, const std::string& folder, const std::string& name) {
        const auto& rule = rules_.at(folder);
        const auto ending = path.extension().string(), stem = path.stem().string();
        if (std::ranges::find(rule.endings, ending) == rule.endings.end()) {
            found_.faults.push_back(text(shown(name), ": nothing reads this file: files here end with ",
                                         listed(rule.endings), did_you_mean(ending, rule.endings)));
            return;
        }
        if (rule.names.empty() || std::ranges::find(rule.names, stem) != rule.names.end()) {
            ++found_.files;
            if (ending == ".toml") found_.read.push_back(name);
            if (std::ranges::find(chosen_folders, folder) != chosen_folders.end())
                check_chosen_name(name, stem);
            return;
        }
        const auto names = views_of(rule.names);
        found_.faults.push_back(text(shown(name), ": nothing reads this file: there is no ", rule.what, " '",
                                     printable(stem, 64), "', only ", listed(names),
                                     did_you_mean(stem, names)));
    }

    /// Reports a name of an arena, match or the like with characters that cannot be used in the menu and on
    /// the command line.
    void check_chosen_name(const std::string& name, const std::string& stem) {
        constexpr std::string_view allowed = "abcdefghijklmnopqrstuvwxyz0123456789_";
        if (stem.find_first_not_of(allowed) != stem.npos)
            found_.faults.push_back(
                text(shown(name), ": the name of a data file may have a-z, 0-9 and _, at most 64 of them"));
    }

    const std::filesystem::path& assets_;
    std::map<std::string, FolderRule> rules_;
    KnownFiles found_;
};

}  // namespace

KnownFiles check_file_names(const std::filesystem::path& assets) { return Walk(assets).walk(); }

}  // namespace thaum::game::inline app

// game/data/data_loader.h: reads the data files of one match, keeps the hash of each file's values, and
// applies overrides. Used by read_match_data alone.
#pragma once
#include <algorithm>
#include <filesystem>
#include <iterator>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/config.h"
#include "core/error.h"
#include "core/text.h"
#include "game/data/match_data.h"
#include "game/data/mutator.h"

namespace thaum::game::inline data {

/// Reads data files into a MatchData. All faults that it meets are collected in `error`.
class DataLoader {
public:
    DataLoader(const std::filesystem::path& assets, MatchData& data, std::vector<Override> overrides)
        : assets_(assets), data_(data), overrides_(std::move(overrides)), used_(overrides_.size(), false) {
        for (const auto& one : overrides_) data_.overrides.push_back(one.value);
    }

    /// Reads a file with read(Config) and returns its value, or a default value if there is no such file. All
    /// faults are added to `error`. `decides`: the file can change a match, so the hash of its values is
    /// stored.
    template <class Read>
    auto load(const std::string& name, Read read, bool decides = true)
        -> decltype(read(std::declval<const Config&>())) {
        using Value = decltype(read(std::declval<const Config&>()));
        auto config = open(name, decides);
        if (!config) {
            keep(name, config.error());
            return Value{};
        }
        auto value = read(*config);
        if (const auto checked = config->check(); !checked) keep(name, checked.error());
        return value;
    }

    /// Names of all data files of a folder, without .toml, sorted. Files with unsuitable names are reported.
    /// If the choice names its files (DataChoice::files), the folder's other files are ignored.
    std::vector<std::string> names_in(const std::string& folder);

    /// Names of all files of a folder in which each kind of the program has a file of its own name. Those
    /// come first, in the order of their names, and stand here even if they are missing, unless the choice
    /// leaves them out. A program without kinds, which plays no match, reads none.
    template <class Kind>
    std::vector<std::string> names_of_kinds(const std::vector<Kind>& kinds, const std::string& folder) {
        std::vector<std::string> names;
        if (kinds.empty()) return names;
        for (const auto& kind : kinds)
            if (is_chosen(text(folder, "/", kind.name, ".toml"))) names.emplace_back(kind.name);
        const auto own = names;
        std::ranges::copy_if(names_in(folder), std::back_inserter(names),
                             [&](const auto& name) { return std::ranges::find(own, name) == own.end(); });
        return names;
    }

    /// Whether the choice of the match allows this file to be read; see DataChoice::files.
    bool is_chosen(const std::string& name) const;

    /// Whether the file of this name was read without a fault.
    bool is_sound(const std::string& name) const {
        return std::find(faulty_.begin(), faulty_.end(), name) == faulty_.end();
    }

    /// Checks a file against other files, once those were read: `report` reports errors at lines of `file`.
    /// Does nothing without the file.
    template <class Report>
    void check_across(const std::optional<Config>& file, Report report) {
        if (!file) return;
        report(file->root());
        if (const auto checked = file->check(); !checked) refuse(checked.error());
    }

    /// Reports overrides that belong to none of the files that were read.
    void check_overrides();

    const std::filesystem::path& assets() const { return assets_; }

    /// Adds an error that belongs to no single file, or that the reader of a file returns.
    void refuse(const Error& fault);

    /// Name of a file in messages: "assets/orb.toml".
    std::string shown(const std::string& name) const { return shown_path(assets_, name); }

    std::optional<Error> error;

private:
    void keep(const std::string& name, const Error& fault);
    Expected<Config> open(const std::string& name, bool decides);

    const std::filesystem::path& assets_;
    MatchData& data_;
    std::vector<Override> overrides_;
    std::vector<bool> used_;           ///< for each override, whether a file has the name that it begins with
    std::vector<std::string> faulty_;  ///< names of files with a fault
};

}  // namespace thaum::game::inline data

#include "game/data/data_loader.h"

#include <array>

#include "core/file.h"
#include "core/one_line.h"
#include "core/text.h"
#include "game/data/file_names.h"

namespace thaum::game::inline data {
namespace {

/// Top-level tables of data files that no match reads: how events and things are shown, and the places of
/// practice. Their values are not hashed.
constexpr std::array<std::string_view, 4> unhashed_tables{"event", "look", "range", "sound"};

/// An override in messages, with the place where it is written.
std::string told(const Override& one) {
    return one.place.empty() ? text("--set ", one.value) : text(one.place, ": '", one.value, "'");
}

}  // namespace

std::vector<std::string> DataLoader::names_in(const std::string& folder) {
    std::vector<std::string> names;
    const auto files = files_in(assets_ / folder, ".toml");
    if (!files) {
        refuse(files.error());
        return names;
    }
    for (const auto& file : *files) {
        const auto name = file.stem().string();
        if (!is_chosen(text(folder, "/", name, ".toml"))) continue;
        if (plain_name(name))
            names.push_back(name);
        else
            refuse({text(shown(folder), "/", printable(name, 64),
                         ".toml: the name of a data file may have a-z, 0-9 and _, at most 64 of them")});
    }
    return names;
}

bool DataLoader::is_chosen(const std::string& name) const {
    const auto& chosen = data_.choice.files;
    return !chosen || std::find(chosen->begin(), chosen->end(), name) != chosen->end();
}

void DataLoader::check_overrides() {
    for (std::size_t i = 0; i < used_.size(); ++i) {
        if (used_[i]) continue;
        refuse(
            {text(told(overrides_[i]),
                  ": must be FILE.KEY=VALUE with a data file of this match, such as bolt.shot.damage=12")});
    }
}

void DataLoader::refuse(const Error& fault) { add_faults(error, fault); }

void DataLoader::keep(const std::string& name, const Error& fault) {
    faulty_.push_back(name);
    refuse(fault);
}

Expected<Config> DataLoader::open(const std::string& name, bool decides) {
    auto config = read_data_file(assets_, name);
    if (!config) return config;
    if (decides) data_.files.push_back({name, config->value_hash(unhashed_tables)});
    const auto stem = std::filesystem::path(name).stem().string() + ".";
    for (std::size_t i = 0; i < overrides_.size(); ++i) {
        const std::string_view entry = overrides_[i].value;
        const auto equals = entry.find('=');
        if (equals == std::string_view::npos || !entry.starts_with(stem)) continue;
        used_[i] = true;
        const auto replaced =
            config->replace(entry.substr(stem.size(), equals - stem.size()), entry.substr(equals + 1));
        if (replaced) continue;
        if (overrides_[i].place.empty()) return replaced.error();
        return Error{text(told(overrides_[i]), ": ", replaced.error().message)};
    }
    return config;
}

}  // namespace thaum::game::inline data

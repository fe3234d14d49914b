#include "game/data/mutator.h"

#include <algorithm>

#include "core/config.h"
#include "core/parse.h"
#include "core/text.h"
#include "game/data/file_names.h"
#include "game/data/match_data.h"

namespace thaum::game::inline data {
namespace {

/// The part of an override before its value: "bolt.shot.damage".
std::string_view key_of(const Override& one) {
    return std::string_view(one.value).substr(0, one.value.find('='));
}
std::string_view value_of(const Override& one) {
    return std::string_view(one.value).substr(std::min(one.value.find('=') + 1, one.value.size()));
}

/// Whether two overrides give the same value: 1 and 1.0 are the same.
bool is_same_value(const Override& a, const Override& b) {
    constexpr double huge = 1e300;
    const auto first = parse_number(value_of(a), "", -huge, huge),
               second = parse_number(value_of(b), "", -huge, huge);
    return first && second ? *first == *second : value_of(a) == value_of(b);
}

Override read_override(const ConfigTable& table) {
    Override one{table.string("set"), table.place("set")};
    const auto dot = one.value.find('.'), equals = one.value.find('=');
    if (dot == 0 || equals == one.value.npos || dot == one.value.npos || dot > equals || dot + 1 == equals)
        table.report("set",
                     text("'set' is '", one.value, "', must be FILE.KEY=VALUE, such as bolt.shot.damage=12"));
    return one;
}

Expected<Mutator> load_mutator(const std::filesystem::path& assets, const std::string& name) {
    const auto file = read_data_file(assets, text("mutators/", name, ".toml"));
    if (!file) return file.error();
    const auto root = file->root();
    Mutator mutator{
        .name = name, .shown = root.string("name"), .words = root.string("words"), .overrides = {}};
    if (mutator.shown.empty()) root.report("name", "'name' must be a text in quotes, not empty");
    for (const auto& table : root.tables("override")) {
        auto one = read_override(table);
        for (const auto& before : mutator.overrides)
            if (key_of(before) == key_of(one))
                table.report("set", text("'set' sets '", key_of(one), "' a second time"));
        mutator.overrides.push_back(std::move(one));
    }
    if (mutator.overrides.empty()) root.report("", "a mutator has at least one [[override]]");
    if (const auto checked = file->check(); !checked) return checked.error();
    return mutator;
}

/// Adds the overrides of a mutator, unless they contradict those of another one.
Expected<void> add_overrides(const Mutator& mutator, std::vector<Override>& all) {
    for (const auto& one : mutator.overrides) {
        const auto same =
            std::ranges::find_if(all, [&](const Override& other) { return key_of(other) == key_of(one); });
        if (same != all.end() && !is_same_value(*same, one))
            return fail(text(one.place, ": the mutator '", mutator.name, "' sets '", key_of(one), "' to ",
                             value_of(one), ", and ", same->place, " sets it to ", value_of(*same),
                             "; choose one of the two mutators"));
        all.push_back(one);
    }
    return {};
}

}  // namespace

std::vector<ListedMutator> list_mutators(const std::filesystem::path& assets) {
    std::vector<ListedMutator> all;
    for (const auto& name : stems_in(assets / "mutators")) all.push_back({name, load_mutator(assets, name)});
    return all;
}

Expected<std::vector<Override>> overrides_of(const std::filesystem::path& assets, const DataChoice& choice) {
    std::vector<Override> all;
    const auto& names = choice.mutators;
    const auto known = names.empty() ? std::vector<std::string>() : stems_in(assets / "mutators");
    for (auto name = names.begin(); name != names.end(); ++name) {
        if (const auto there = check_name(known, *name, "mutator"); !there) return there.error();
        if (std::find(names.begin(), name, *name) != name)
            return fail(text("the mutator '", *name, "' is chosen twice"));
        const auto mutator = load_mutator(assets, *name);
        if (!mutator) return mutator.error();
        if (const auto added = add_overrides(*mutator, all); !added) return added.error();
    }
    for (const auto& value : choice.overrides) all.push_back({.value = value});
    return all;
}

}  // namespace thaum::game::inline data

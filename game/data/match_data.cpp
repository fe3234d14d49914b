#include "game/data/match_data.h"

#include <algorithm>
#include <cstdlib>
#include <span>

#include "core/file.h"
#include "core/text.h"
#include "game/components/potions.h"
#include "gesture/gesture_file.h"

namespace thaum::game {
namespace {

constexpr std::size_t max_data_file = 1U << 20U;
/// Top-level tables of data files that no match reads, so their values are not hashed: how events and things
/// are shown, and the places of practice.
constexpr std::array<std::string_view, 4> unhashed_tables{"event", "look", "range", "sound"};

/// Reads data files, stores the hash of each file's values, and applies overrides.
class Loader {
public:
    Loader(const std::filesystem::path& assets, MatchData& data)
        : assets_(assets), data_(data), used_(data.choice.overrides.size(), false) {}

    /// Reads a file with read(Config) and returns its value. The first error is kept in `error`. `decides`:
    /// the file can change a match, so the hash of its values is stored.
    template <class Read>
    auto load(const std::string& name, Read read, bool decides = true)
        -> decltype(read(std::declval<const Config&>())) {
        using Value = decltype(read(std::declval<const Config&>()));
        if (error) return Value{};
        auto config = open(name, decides);
        if (!config) return keep(std::move(config.error())), Value{};
        auto value = read(*config);
        if (auto checked = config->check(); !checked) keep(std::move(checked.error()));
        return value;
    }

    /// Checks one file against another. `report` reports an error at a line of `file`.
    template <class Report>
    void check_across(const std::optional<Config>& file, Report report) {
        if (error || !file) return;
        report(file->root());
        if (auto checked = file->check(); !checked) keep(std::move(checked.error()));
    }

    void check_overrides() {
        for (std::size_t i = 0; i < used_.size() && !error; ++i) {
            if (!used_[i]) {
                keep({text(
                    "--set ", data_.choice.overrides[i],
                    ": must be FILE.KEY=VALUE with a data file of this match, such as bolt.shot.damage=12")});
            }
        }
    }

    const std::filesystem::path& assets() const { return assets_; }

    /// Keeps an error that is in no single file.
    void refuse(std::string message) { keep(Error{std::move(message)}); }

    std::optional<Error> error;

private:
    void keep(Error e) {
        if (!error) error = std::move(e);
    }

    /// Name of the folder of all data files, for messages: "assets".
    std::filesystem::path folder_name() const {
        return assets_.has_filename() ? assets_.filename() : assets_.parent_path().filename();
    }

    Expected<Config> open(const std::string& name, bool decides) {
        const auto source = read_text_file(assets_ / name, max_data_file);
        if (!source) return source.error();
        auto config = Config::parse(*source, (folder_name() / name).string(), 1);
        if (!config) return config;
        if (decides) data_.files.push_back({name, config->value_hash(unhashed_tables)});
        const auto stem = std::filesystem::path(name).stem().string() + ".";
        for (std::size_t i = 0; i < data_.choice.overrides.size(); ++i) {
            const std::string_view entry = data_.choice.overrides[i];
            const auto equals = entry.find('=');
            if (equals == std::string_view::npos || !entry.starts_with(stem)) continue;
            used_[i] = true;
            const auto replaced =
                config->replace(entry.substr(stem.size(), equals - stem.size()), entry.substr(equals + 1));
            if (!replaced) return replaced.error();
        }
        return config;
    }

    const std::filesystem::path& assets_;
    MatchData& data_;
    std::vector<bool> used_;
};

bool plain_name(std::string_view name) {
    return !name.empty() && name.size() <= 64 && std::all_of(name.begin(), name.end(), [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_';
    });
}

constexpr std::array<std::string_view, 2> rule_sets{"thaum", "classic"};
constexpr std::array<std::string_view, 2> match_lengths{"quick", "standard"};

Expected<void> check_name(const std::array<std::string_view, 2>& known, std::string_view name,
                          std::string_view what) {
    if (std::find(known.begin(), known.end(), name) != known.end()) return {};
    return fail(text("there is no ", what, " '", name, "', only ", known[0], " and ", known[1]));
}

/// Gives a wand that shares another wand's energy the same cap. `files` are the files of the wands.
void share_energies(MatchData& data, const std::vector<std::optional<Config>>& files, Loader& loader) {
    for (std::size_t i = 0; i < data.wands.size(); ++i) {
        auto& wand = data.wands[i];
        if (wand.stats.energy_slot == wand.stats.slot) continue;
        const auto lender = std::find_if(data.wands.begin(), data.wands.end(), [&](const auto& w) {
            return w.stats.slot == wand.stats.energy_slot && w.stats.energy_slot == w.stats.slot;
        });
        if (lender != data.wands.end()) {
            wand.stats.energy_cap = lender->stats.energy_cap;
            continue;
        }
        loader.check_across(files[i], [&](const ConfigTable& root) {
            root.table("energy").report("of_slot",
                                        text("energy.of_slot: no wand of slot ", wand.stats.energy_slot + 1,
                                             " has energy of its own"));
        });
    }
}

void refuse_taken_slot(const std::vector<LoadedWand>& before, const LoadedWand& wand, const Config& file) {
    for (const auto& other : before) {
        if (other.stats.slot != wand.stats.slot) continue;
        file.root().report("slot",
                           text("'slot' is ", wand.stats.slot + 1, ", where ", other.kind->name, " is"));
    }
}

void check_niches(const ConfigTable& arena, const std::vector<Ingredient>& known) {
    for (const auto& niche : arena.tables("niche")) {
        const auto name = niche.string("ingredient");
        if (std::none_of(known.begin(), known.end(), [&](const Ingredient& i) { return i.name == name; }))
            niche.report("ingredient", text("niche: cauldron.toml has no ingredient '", name, "'"));
    }
}

/// Reports a bowl in which the solver makes no brew, for instance because it would need too many cells.
void check_bowl(const ConfigTable& arena, const MatchData& data) {
    const auto brew = check_brew(*data.cauldron, basin_of(data.arena.bowl->size, data.cauldron->filled));
    if (brew) return;
    for (const auto& solid : arena.tables("solid"))
        if (solid.string("shape") == "bowl")
            return solid.report("shape", text("the bowl holds no brew: ", brew.error().message));
}

/// Loads the device that haptics.toml names from its own file.
void load_device(MatchData& data, const std::optional<Config>& haptics, Loader& loader) {
    const auto name = data.haptic_rules.device;
    if (!plain_name(name)) {
        return loader.check_across(haptics, [&](const ConfigTable& root) {
            root.report("device", text("device '", name, "' is no name of a device (a-z, 0-9, _)"));
        });
    }
    const auto file = text("devices/", name, ".toml");
    std::error_code ignored;
    if (!std::filesystem::exists(loader.assets() / file, ignored)) {
        return loader.check_across(haptics, [&](const ConfigTable& root) {
            root.report("device", text("device '", name, "': there is no ", file));
        });
    }
    auto device = loader.load(file, haptics::read_device);
    if (device) data.device = std::move(*device);
    if (!device && !loader.error) loader.error = device.error();
}

/// Wraps a reader so that the file is kept, for errors that only another file reveals.
template <class Read>
auto noting(std::optional<Config>& kept, Read read) {
    return [&kept, read](const Config& file) {
        kept = file;
        return read(file);
    };
}

/// A copy of what is known so far of how the match is shown.
std::shared_ptr<Presentation> begun_presentation(const MatchData& data) {
    return data.presentation ? std::make_shared<Presentation>(*data.presentation)
                             : std::make_shared<Presentation>();
}

/// Loads all wands of this program, and how they and all events are shown.
void load_wands(MatchData& data, Loader& loader) {
    std::vector<std::optional<Config>> files;
    std::vector<WandSounds> sounds;
    auto shown = begun_presentation(data);
    shown->events = loader.load("events.toml", read_event_rows, false);
    shown->events.resize(event_kinds().kinds.size());  // empty after an error
    for (const auto& kind : wand_kinds()) {
        const auto read = [&](const Config& file) {
            auto wand = read_wand(kind, file);
            read_hit_rows(file.root(), kind.hits, shown->events);
            sounds.push_back(read_wand_sounds(file.root()));
            refuse_taken_slot(data.wands, wand, file);
            return wand;
        };
        data.wands.push_back(
            loader.load(text("wands/", kind.name, ".toml"), noting(files.emplace_back(), read)));
    }
    if (!loader.error) share_energies(data, files, loader);
    for (std::size_t i = 0; i < data.wands.size(); ++i) {
        const auto& wand = data.wands[i];
        shown->wands.push_back({.name = std::string(wand_kinds()[i].name),
                                .slot = wand.stats.slot,
                                .look = wand.look,
                                .sounds = i < sounds.size() ? sounds[i] : WandSounds(),
                                .energy_cap = wand.stats.energy_cap,
                                .energy_cost = wand.stats.energy_cost});
    }
    data.presentation = std::move(shown);
}

/// Names of all files of a folder that end with .toml, without that ending, sorted.
std::vector<std::string> files_in(const std::filesystem::path& folder) {
    std::vector<std::string> names;
    std::error_code ignored;
    for (const auto& entry : std::filesystem::directory_iterator(folder, ignored)) {
        const auto& path = entry.path();
        if (path.extension() == ".toml" && plain_name(path.stem().string()))
            names.push_back(path.stem().string());
    }
    std::sort(names.begin(), names.end());
    return names;
}

void load_gestures(MatchData& data, Loader& loader) {
    std::vector<gesture::Gesture> gestures;
    std::vector<std::string> files;
    for (const auto& name : files_in(loader.assets() / "gestures")) {
        const auto file = text("gestures/", name, ".toml");
        auto read = loader.load(file, [](const Config& config) {
            return std::optional<Expected<gesture::Gesture>>(gesture::read_gesture(config));
        });
        if (loader.error) return;
        if (!*read) {
            loader.error = read->error();
            return;
        }
        const auto same = std::find_if(gestures.begin(), gestures.end(),
                                       [&](const auto& other) { return other.name == (*read)->name; });
        if (same != gestures.end()) {
            const auto& first = files.at(static_cast<std::size_t>(same - gestures.begin()));
            loader.error = Error{text(first, " and ", file, ": both have the name '", same->name,
                                      "'; change one, or delete a file")};
            return;
        }
        gestures.push_back(std::move(**read));
        files.push_back(file);
    }
    if (const auto fault = fault_of(gestures)) {
        loader.error = Error{text("gestures: ", *fault)};
        return;
    }
    data.gestures = std::make_shared<GestureSet>(std::move(gestures));
}

/// Refuses a spell whose gesture does not exist or belongs to another spell, or whose slot is taken.
void check_spell(const MatchData& data, const LoadedSpell& spell, const Config& file) {
    const auto& gesture = spell.stats.gesture;
    if (!data.gestures->number(gesture))
        file.root().report("gesture",
                           text("'gesture' is '", gesture, "', but there is no gestures/", gesture, ".toml"));
    for (const auto& other : data.spells) {
        if (other.stats.gesture == gesture)
            file.root().report("gesture",
                               text("'gesture' is '", gesture, "', which casts ", other.kind->name));
        if (other.stats.slot == spell.stats.slot)
            file.root().report("slot",
                               text("'slot' is ", spell.stats.slot + 1, ", where ", other.kind->name, " is"));
    }
}

/// Loads gestures and spells, if the rule set has them.
void load_spells(MatchData& data, Loader& loader) {
    if (!data.rules.spells) return;
    load_gestures(data, loader);
    data.casting = loader.load("casting.toml",
                               [](const Config& file) { return std::optional(read_casting_rules(file)); });
    auto shown = begun_presentation(data);
    for (const auto& kind : spell_kinds()) {
        if (loader.error) return;
        data.spells.push_back(loader.load(text("spells/", kind.name, ".toml"), [&](const Config& file) {
            auto spell = read_spell(kind, file);
            check_spell(data, spell, file);
            auto& shown_spell = shown->spells.emplace_back(read_spell_presentation(kind.name, file.root()));
            shown_spell.shown = spell.stats.shown;
            shown_spell.gesture = spell.stats.gesture;
            shown_spell.slot = spell.stats.slot;
            shown_spell.focus = spell.stats.focus;
            return spell;
        }));
    }
    data.presentation = std::move(shown);
}

/// Reports recipes that ask for the same ingredients: nobody could tell which one a brew follows.
void check_different(const std::vector<Recipe>& recipes, const std::optional<Config>& file, Loader& loader) {
    const auto& last = recipes.back();
    const auto like_last = [&](const Recipe& other) {
        return std::equal(other.ingredients.begin(), other.ingredients.end(), last.ingredients.begin(),
                          last.ingredients.end(), [](const RecipeIngredient& a, const RecipeIngredient& b) {
                              return a.ingredient == b.ingredient;
                          });
    };
    const auto same = std::find_if(recipes.begin(), recipes.end() - 1, like_last);
    if (same == recipes.end() - 1) return;
    loader.check_across(file, [&](const ConfigTable& root) {
        root.report("ingredient", text("the ingredients are those of ", same->name));
    });
}

/// Loads all recipes of assets/potions.
void load_recipes(MatchData& data, Loader& loader) {
    const auto names = files_in(loader.assets() / "potions");
    if (names.size() > most_potions)
        return loader.refuse(text("assets/potions: more than ", most_potions, " potions"));
    std::vector<std::string> gestures;
    for (const auto& one : data.gestures->gestures()) gestures.push_back(one.name);
    for (const auto& name : names) {
        std::optional<Config> kept;
        const auto read = [&](const Config& file) {
            kept = file;
            return read_recipe(file, name, {data.cauldron->ingredients, gestures});
        };
        data.recipes.push_back(loader.load(text("potions/", name, ".toml"), read));
        if (!loader.error) check_different(data.recipes, kept, loader);
    }
}

/// Loads the rules of the orb, if arena and rule set have one.
void load_orb(MatchData& data, Loader& loader) {
    if (!data.rules.cauldron || !data.rules.spells || orb_of(data.arena) == nullptr) return;
    data.orb =
        loader.load("orb.toml", [](const Config& file) { return std::optional(read_orb_rules(file)); });
}

/// Names ingredients and potions for those who show the match.
void name_brew(MatchData& data) {
    auto shown = std::make_shared<Presentation>(*data.presentation);
    shown->brew = brew_words_of(data);
    data.presentation = std::move(shown);
}

bool has_crystal(const Arena& arena) {
    return std::any_of(arena.things.begin(), arena.things.end(),
                       [](const Thing& thing) { return is_crystal(thing.surface, thing.body.shape); });
}

/// Loads the rules of crystals and the tools that they name.
void load_crystal(MatchData& data, Loader& loader) {
    std::optional<Config> file;
    auto rules = loader.load("crystal.toml", noting(file, read_crystal_rules));
    const auto materials = loader.load(
        "materials.toml", [](const Config& read) { return std::optional(field::read_materials(read)); },
        false);
    if (!loader.error && !*materials) loader.error = materials->error();
    for (std::size_t i = 0; i < rules.tool_names.size() && !loader.error; ++i) {
        const auto& name = rules.tool_names[i];
        const auto path = text("carving/", name, ".toml");
        std::error_code ignored;
        if (!plain_name(name) || !std::filesystem::exists(loader.assets() / path, ignored)) {
            loader.check_across(file, [&](const ConfigTable& root) {
                root.tables("tool")[i].report("name", text("tool '", name, "': there is no ", path));
            });
            return;
        }
        auto tool = loader.load(
            path, [&](const Config& read) { return std::optional(field::read_tool(read, **materials)); });
        if (!loader.error && !*tool) loader.error = tool->error();
        if (!loader.error) rules.tools.push_back(std::move(**tool));
    }
    loader.check_across(file, [&](const ConfigTable& root) { check_crystal_tools(root, rules); });
    data.crystal = std::move(rules);
}

/// Removes from the data what the rule set switches off, so that no system reads the rule set's name.
void apply_rule_set(MatchData& data) {
    if (!data.rules.spawn_shield) data.round.spawn_shield = 0;
    if (data.rules.energy_regain) return;
    for (auto& wand : data.wands) wand.stats.energy_regain = 0;
}

}  // namespace

const LoadedWand* wand_in_slot(const MatchData& data, std::uint32_t slot) {
    const auto found = std::find_if(data.wands.begin(), data.wands.end(),
                                    [&](const auto& w) { return w.stats.slot == slot; });
    return found == data.wands.end() ? nullptr : &*found;
}

Expected<MatchData> load_match_data(const std::filesystem::path& assets, const DataChoice& choice) {
    if (!plain_name(choice.arena))
        return fail(text("'", choice.arena, "' is no name of an arena (a-z, 0-9, _)"));
    if (auto known = check_name(rule_sets, choice.rules, "rule set"); !known) return known.error();
    if (auto known = check_name(match_lengths, choice.match, "match"); !known) return known.error();
    if (const auto& fault = event_kinds().fault; !fault.empty()) return fail(fault);
    MatchData data;
    data.choice = choice;
    Loader loader(assets, data);
    std::optional<Config> arena_file, haptics_file;
    const auto read_whole_arena = [&](const Config& file) {
        data.look = read_arena_look(file);
        return read_arena(file);
    };
    data.arena = loader.load("arenas/" + choice.arena + ".toml", noting(arena_file, read_whole_arena));
    data.rules = loader.load("rules/" + choice.rules + ".toml", read_rule_set);
    data.round = loader.load("rules/" + choice.match + ".toml", read_round_rules);
    data.wizard = loader.load("wizards/wizard.toml", read_wizard_rules);
    data.haptic_rules = loader.load("haptics.toml", noting(haptics_file, read_haptic_rules));
    if (!loader.error) load_device(data, haptics_file, loader);
    if (data.rules.cauldron && data.arena.bowl) {
        data.cauldron = loader.load("cauldron.toml", read_cauldron_rules);
        loader.check_across(arena_file, [&](const ConfigTable& root) {
            check_niches(root, data.cauldron->ingredients);
            check_bowl(root, data);
        });
    }
    if (data.rules.cauldron && has_crystal(data.arena)) load_crystal(data, loader);
    load_orb(data, loader);
    load_wands(data, loader);
    load_spells(data, loader);
    if (data.cauldron && data.gestures) load_recipes(data, loader);
    name_brew(data);
    loader.check_overrides();
    if (loader.error) return *loader.error;
    apply_rule_set(data);
    return data;
}

std::filesystem::path find_assets() {
    if (const char* given = std::getenv("THAUM_ASSETS")) return given;
    std::error_code ignored;
    const auto program = std::filesystem::read_symlink("/proc/self/exe", ignored).parent_path();
    // The program is build/PRESET/game/thaum in a build tree. An installed program is PREFIX/games/thaum or
    // PREFIX/bin/thaum.
    for (const auto* way :
         {"assets", "../assets", "../../../assets", "../share/thaum/assets", "../share/games/thaum"}) {
        auto candidate = (program / way).lexically_normal();
        if (std::filesystem::exists(candidate / "arenas", ignored)) return candidate;
    }
    return "assets";
}

}  // namespace thaum::game

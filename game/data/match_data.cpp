#include "game/data/match_data.h"

#include <algorithm>
#include <span>

#include "core/environment.h"
#include "core/file.h"
#include "core/near_name.h"
#include "core/one_line.h"
#include "core/text.h"
#include "game/components/potions.h"
#include "game/data/data_loader.h"
#include "game/data/file_names.h"
#include "game/data/mutator.h"
#include "game/data/name_finder.h"
#include "game/data/rule_files.h"
#include "gesture/gesture_file.h"

namespace thaum::game::inline data {
namespace {

/// Refuses a folder without any data files, because otherwise each file would be reported as missing.
Expected<void> check_folder(const std::filesystem::path& assets) {
    const auto whose = environment_value("THAUM_ASSETS")
                           ? std::string("set THAUM_ASSETS to the folder with the data files, or unset it")
                           : std::string("start thaum from its folder, or set THAUM_ASSETS");
    std::error_code error;
    const auto state = std::filesystem::status(assets, error);
    if (!std::filesystem::exists(state))
        return fail(text("there is no folder ", assets.string(), " of data files: ", whose));
    if (!std::filesystem::is_directory(state)) return fail(text(assets.string(), " is no folder: ", whose));
    if (const auto arenas = files_in(assets / "arenas", ".toml"); !arenas)
        return fail(text(arenas.error().message, ": ", whose));
    return {};
}

Expected<void> check_arena_name(const std::filesystem::path& assets, const std::string& name) {
    if (!plain_name(name)) return fail(text("'", name, "' is no name of an arena (a-z, 0-9, _)"));
    return check_name(stems_in(assets / "arenas"), name, "arena");
}

/// If a wand uses the energy of another wand, gives both the same cap. `files` are the files of the wands.
void share_energies(MatchData& data, const std::vector<std::optional<Config>>& files, DataLoader& loader) {
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
        file.root().report("slot", text("'slot' is ", wand.stats.slot + 1, ", where ", other.name, " is"));
    }
}

void check_niches(const ConfigTable& arena, const std::vector<Ingredient>& known) {
    for (const auto& niche : arena.tables("niche")) {
        const auto name = niche.string("ingredient");
        if (std::none_of(known.begin(), known.end(), [&](const Ingredient& i) { return i.name == name; }))
            niche.report("ingredient", text("niche: cauldron.toml has no ingredient '", name, "'",
                                            did_you_mean(name, known, &Ingredient::name)));
    }
}

/// Reports a bowl for which no brew can be made, for instance because the solver would need too many cells.
void check_bowl(const ConfigTable& arena, const MatchData& data) {
    const auto brew = check_brew(*data.cauldron, basin_of(data.arena.bowl->size, data.cauldron->filled));
    if (brew) return;
    for (const auto& solid : arena.tables("solid"))
        if (solid.string("shape") == "bowl")
            return solid.report("shape", text("the bowl holds no brew: ", brew.error().message));
}

/// Loads the rules of the cauldron. `arena`: the arena's file, whose bowl and niches (places of ingredients)
/// the rules must suit.
void load_cauldron(MatchData& data, const std::optional<Config>& arena, DataLoader& loader) {
    data.cauldron = loader.load("cauldron.toml", read_cauldron_rules);
    if (!loader.is_sound("cauldron.toml")) return;
    loader.check_across(arena, [&](const ConfigTable& root) {
        check_niches(root, data.cauldron->ingredients);
        check_bowl(root, data);
    });
}

/// Loads the simulated device named in haptics.toml from the device's own file.
void load_device(MatchData& data, const std::optional<Config>& haptics, DataLoader& loader) {
    const auto name = data.haptic_rules.device;
    const auto file = text("devices/", name, ".toml");
    std::error_code ignored;
    const auto refuse = [&](std::string_view what) {
        const auto folder = loader.assets() / "devices";
        const auto bare = bare_name(name);
        const bool is_meant = bare != name && std::filesystem::exists(folder / text(bare, ".toml"), ignored);
        const auto meant = is_meant ? text("; did you mean '", bare, "'?") : near_file(bare, folder, ".toml");
        loader.check_across(haptics, [&](const ConfigTable& root) {
            root.report("device", text("device '", name, "'", what, meant));
        });
    };
    if (!plain_name(name)) return refuse(" is no name of a device (a-z, 0-9, _)");
    if (!std::filesystem::exists(loader.assets() / file, ignored))
        return refuse(text(": there is no ", file));
    auto device = loader.load(file, haptics::read_device);
    if (device)
        data.device = std::move(*device);
    else if (loader.is_sound(file))
        loader.refuse(device.error());
}

/// Wraps a reader of a file so that the file is kept in `kept`, for errors that appear only when another file
/// is read.
template <class Read>
auto noting(std::optional<Config>& kept, Read read) {
    return [&kept, read](const Config& file) {
        kept = file;
        return read(file);
    };
}

/// A copy of the presentation (how the match is shown) as far as it is known. The caller adds its part to it.
std::shared_ptr<Presentation> begun_presentation(const MatchData& data) {
    return data.presentation ? std::make_shared<Presentation>(*data.presentation)
                             : std::make_shared<Presentation>();
}

/// Loads all wands, and how they and all events are shown.
void load_wands(MatchData& data, DataLoader& loader) {
    std::vector<std::optional<Config>> files;
    std::vector<WandSounds> sounds;
    auto shown = begun_presentation(data);
    shown->events = loader.load("events.toml", read_event_rows, false);
    // Makes room for all kinds of event: if events.toml has an error, the list is empty.
    shown->events.resize(event_kinds().kinds.size());
    const auto names = loader.names_of_kinds(wand_kinds(), "wands");
    for (const auto& name : names) {
        const auto read = [&](const Config& file) {
            auto wand = read_wand(name, file);
            if (wand.kind == nullptr) return wand;
            read_hit_rows(file.root(), wand.kind->name == name, wand.kind->hits, shown->events);
            sounds.push_back(read_wand_sounds(file.root()));
            refuse_taken_slot(data.wands, wand, file);
            return wand;
        };
        const auto path = text("wands/", name, ".toml");
        auto wand = loader.load(path, noting(files.emplace_back(), read));
        if (loader.is_sound(path)) {
            data.wands.push_back(std::move(wand));
        } else {
            files.pop_back();
            sounds.resize(data.wands.size());
        }
    }
    if (data.wands.size() == names.size()) share_energies(data, files, loader);
    for (std::size_t i = 0; i < data.wands.size(); ++i) {
        const auto& wand = data.wands[i];
        shown->wands.push_back({.name = wand.name,
                                .slot = wand.stats.slot,
                                .look = wand.look,
                                .sounds = i < sounds.size() ? sounds[i] : WandSounds(),
                                .energy_cap = wand.stats.energy_cap,
                                .energy_cost = wand.stats.energy_cost});
    }
    data.presentation = std::move(shown);
}

void load_gestures(MatchData& data, DataLoader& loader) {
    std::vector<gesture::Gesture> gestures;
    std::vector<std::string> files;
    const auto names = loader.names_in("gestures");
    for (const auto& name : names) {
        const auto file = text("gestures/", name, ".toml");
        auto read = loader.load(file, [](const Config& config) {
            return std::optional<Expected<gesture::Gesture>>(gesture::read_gesture(config));
        });
        if (!read) continue;
        if (!*read) {
            if (loader.is_sound(file)) loader.refuse(read->error());
            continue;
        }
        if (!loader.is_sound(file)) continue;
        const auto same = std::find_if(gestures.begin(), gestures.end(),
                                       [&](const auto& other) { return other.name == (*read)->name; });
        if (same != gestures.end()) {
            const auto& first = files.at(static_cast<std::size_t>(same - gestures.begin()));
            loader.refuse({text(loader.shown(file), ": has the name '", same->name, "', as ",
                                loader.shown(first), " has; change one, or delete a file")});
            continue;
        }
        gestures.push_back(std::move(**read));
        files.push_back(file);
    }
    // If a gesture file has a fault, the match gets no gestures. Otherwise spells and recipes would wrongly
    // seem to name gestures that do not exist.
    if (gestures.size() < names.size()) return;
    if (const auto fault = fault_of(gestures)) {
        loader.refuse({text(loader.shown("gestures"), ": ", *fault)});
        return;
    }
    data.gestures = std::make_shared<GestureSet>(std::move(gestures));
}

/// Reports a spell whose gesture does not exist or belongs to another spell, or whose wand key is taken.
void check_spell(const MatchData& data, const LoadedSpell& spell, const Config& file) {
    const auto& gesture = spell.stats.gesture;
    if (data.gestures && !data.gestures->number(gesture))
        file.root().report("gesture",
                           text("'gesture' is '", gesture, "', but no file of gestures has this name",
                                did_you_mean(gesture, data.gestures->gestures(), &gesture::Gesture::name)));
    for (const auto& other : data.spells) {
        if (other.stats.gesture == gesture)
            file.root().report("gesture", text("'gesture' is '", gesture, "', which casts ", other.name));
        if (other.stats.slot == spell.stats.slot)
            file.root().report("slot",
                               text("'slot' is ", spell.stats.slot + 1, ", where ", other.name, " is"));
    }
}

/// Loads gestures and spells, if the rule set has them.
void load_spells(MatchData& data, DataLoader& loader) {
    if (!data.rules.spells) return;
    load_gestures(data, loader);
    data.casting = loader.load("casting.toml",
                               [](const Config& file) { return std::optional(read_casting_rules(file)); });
    auto shown = begun_presentation(data);
    for (const auto& name : loader.names_of_kinds(spell_kinds(), "spells")) {
        const auto path = text("spells/", name, ".toml");
        auto loaded = loader.load(path, [&](const Config& file) {
            auto spell = read_spell(name, static_cast<std::uint32_t>(data.spells.size()), file);
            if (spell.kind == nullptr) return std::optional(std::move(spell));
            check_spell(data, spell, file);
            auto& shown_spell = shown->spells.emplace_back(read_spell_presentation(name, file.root()));
            shown_spell.shown = spell.stats.shown;
            shown_spell.gesture = spell.stats.gesture;
            shown_spell.slot = spell.stats.slot;
            shown_spell.focus = spell.stats.focus;
            return std::optional(std::move(spell));
        });
        if (loader.is_sound(path)) data.spells.push_back(std::move(*loaded));
    }
    data.presentation = std::move(shown);
}

/// Reports recipes with the same ingredients, because nothing would tell which of them a brew follows.
void check_different(const std::vector<Recipe>& recipes, const std::optional<Config>& file,
                     DataLoader& loader) {
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
void load_recipes(MatchData& data, DataLoader& loader) {
    const auto names = loader.names_in("potions");
    if (names.size() > max_potions)
        return loader.refuse({text(loader.shown("potions"), ": more than ", max_potions, " potions")});
    std::vector<std::string> gestures;
    for (const auto& one : data.gestures->gestures()) gestures.push_back(one.name);
    for (const auto& name : names) {
        std::optional<Config> kept;
        const auto read = [&](const Config& file) {
            kept = file;
            return read_recipe(file, name, {data.cauldron->ingredients, gestures});
        };
        const auto path = text("potions/", name, ".toml");
        auto recipe = loader.load(path, read);
        if (!loader.is_sound(path)) continue;
        data.recipes.push_back(std::move(recipe));
        check_different(data.recipes, kept, loader);
    }
}

/// Loads the rules of the orb, if arena and rule set have one.
void load_orb(MatchData& data, DataLoader& loader) {
    if (!data.rules.cauldron || !data.rules.spells || orb_of(data.arena) == nullptr) return;
    data.orb =
        loader.load("orb.toml", [](const Config& file) { return std::optional(read_orb_rules(file)); });
}

/// Stores the names of ingredients and potions in the presentation, for code that shows the match.
void name_brew(MatchData& data) {
    auto shown = std::make_shared<Presentation>(*data.presentation);
    shown->brew = brew_words_of(data);
    data.presentation = std::move(shown);
}

bool has_crystal(const Arena& arena) {
    return std::any_of(arena.things.begin(), arena.things.end(),
                       [](const Thing& thing) { return is_crystal(thing.surface, thing.body.shape); });
}

/// Loads the tool of entry `i` in crystal.toml. `file`: crystal.toml.
void load_crystal_tool(CrystalRules& rules, std::size_t i, const field::Materials& materials,
                       const std::optional<Config>& file, DataLoader& loader) {
    const auto& name = rules.tool_names[i];
    const auto path = text("carving/", name, ".toml");
    std::error_code ignored;
    if (!plain_name(name) || !std::filesystem::exists(loader.assets() / path, ignored)) {
        return loader.check_across(file, [&](const ConfigTable& root) {
            root.tables("tool")[i].report("name",
                                          text("tool '", name, "': there is no ", path,
                                               near_file(name, loader.assets() / "carving", ".toml")));
        });
    }
    auto tool = loader.load(
        path, [&](const Config& read) { return std::optional(field::read_tool(read, materials)); });
    if (!tool) return;
    if (*tool)
        rules.tools.push_back(std::move(**tool));
    else if (loader.is_sound(path))
        loader.refuse(tool->error());
}

/// Loads the rules of crystals and the tools that they name.
void load_crystal(MatchData& data, DataLoader& loader) {
    std::optional<Config> file;
    auto rules = loader.load("crystal.toml", noting(file, read_crystal_rules));
    const auto materials = loader.load(
        "materials.toml", [](const Config& read) { return std::optional(field::read_materials(read)); });
    if (!materials || !*materials) {
        if (materials && loader.is_sound("materials.toml")) loader.refuse(materials->error());
        return;
    }
    if (!loader.is_sound("crystal.toml")) return;
    for (std::size_t i = 0; i < rules.tool_names.size(); ++i)
        load_crystal_tool(rules, i, **materials, file, loader);
    if (rules.tools.size() == rules.tool_names.size())
        loader.check_across(file, [&](const ConfigTable& root) { check_crystal_tools(root, rules); });
    data.crystal = std::move(rules);
}

/// Removes data that the rule set switches off, so that the systems of the match need not look at the rule
/// set.
void apply_rule_set(MatchData& data) {
    if (!data.rules.spawn_shield) data.round.spawn_shield = 0;
    data.round.boil_over.health = std::min(data.round.boil_over.health, data.wizard.health);
    if (!data.rules.surges) {
        data.round.surges.clear();
        data.round.boil_over = {};
    }
    if (data.rules.energy_regain) return;
    for (auto& wand : data.wands) wand.stats.energy_regain = 0;
}

}  // namespace

std::string shown_path(const std::filesystem::path& assets, std::string_view name) {
    const auto folder = assets.has_filename() ? assets.filename() : assets.parent_path().filename();
    return (folder / name).string();
}

namespace {

/// Refuses names for which there is no data.
Expected<void> check_choice(const std::filesystem::path& assets, const DataChoice& choice) {
    if (auto there = check_folder(assets); !there) return there.error();
    if (auto known = check_arena_name(assets, choice.arena); !known) return known.error();
    if (!is_unreadable_rule_file(assets, choice.rules)) {
        if (auto known = check_name(rule_sets(assets), choice.rules, "rule set"); !known)
            return known.error();
    }
    if (auto known = check_name(match_lengths(assets), choice.match, "match"); !known) return known.error();
    if (const auto& fault = event_kinds().fault; !fault.empty()) return fail(fault);
    return {};
}

}  // namespace

MatchReading read_match_data(const std::filesystem::path& assets, const DataChoice& choice) {
    MatchReading reading;
    auto& data = reading.data;
    data.choice = choice;
    data.presentation = std::make_shared<Presentation>();
    if (const auto known = check_choice(assets, choice); !known) {
        reading.error = known.error();
        return reading;
    }
    auto overrides = overrides_of(assets, choice);
    if (!overrides) {
        reading.error = overrides.error();
        return reading;
    }
    DataLoader loader(assets, data, std::move(*overrides));
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
    if (loader.is_sound("haptics.toml")) load_device(data, haptics_file, loader);
    if (data.rules.cauldron && data.arena.bowl) load_cauldron(data, arena_file, loader);
    if (data.rules.cauldron && has_crystal(data.arena)) load_crystal(data, loader);
    load_orb(data, loader);
    load_wands(data, loader);
    load_spells(data, loader);
    if (data.gestures && loader.is_sound("cauldron.toml") && data.cauldron) load_recipes(data, loader);
    loader.check_overrides();
    if (const auto numbered = number_effects(data); !numbered) loader.refuse(numbered.error());
    reading.error = std::move(loader.error);
    if (reading.error) return reading;
    name_brew(data);
    apply_rule_set(data);
    return reading;
}

const LoadedSpell* spell_of(const MatchData& data, std::string_view gesture) {
    const auto found = std::ranges::find_if(
        data.spells, [&](const LoadedSpell& spell) { return spell.stats.gesture == gesture; });
    return found == data.spells.end() ? nullptr : &*found;
}

Expected<MatchData> load_match_data(const std::filesystem::path& assets, const DataChoice& choice) {
    auto reading = read_match_data(assets, choice);
    if (reading.error) return std::move(*reading.error);
    return std::move(reading.data);
}

std::filesystem::path shipped_assets() {
    std::error_code ignored;
    const auto program = std::filesystem::read_symlink("/proc/self/exe", ignored).parent_path();
    // In a build tree the program is build/PRESET/game/thaum. An installed program is PREFIX/games/thaum or
    // PREFIX/bin/thaum.
    for (const auto* way :
         {"assets", "../assets", "../../../assets", "../share/thaum/assets", "../share/games/thaum"}) {
        auto candidate = (program / way).lexically_normal();
        if (std::filesystem::exists(candidate / "arenas", ignored)) return candidate;
    }
    return "assets";
}

std::filesystem::path find_assets() {
    const auto given = environment_value("THAUM_ASSETS");
    return given ? std::filesystem::path(*given) : shipped_assets();
}

}  // namespace thaum::game::inline data

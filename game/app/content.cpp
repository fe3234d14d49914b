#include "game/app/content.h"

#include <algorithm>
#include <set>
#include <span>

#include "audio/synth.h"
#include "core/config.h"
#include "core/file.h"
#include "core/invisible.h"
#include "core/near_name.h"
#include "core/one_line.h"
#include "core/text.h"
#include "core/utf8.h"
#include "field/carving_tools.h"
#include "field/materials.h"
#include "game/app/content_names.h"
#include "game/app/content_use.h"
#include "game/bots/bot_file.h"
#include "game/data/file_names.h"
#include "game/data/mutator.h"
#include "game/data/name_finder.h"
#include "game/data/rule_files.h"
#include "game/live/body.h"
#include "game/live/menu_choices.h"
#include "game/live/sound.h"
#include "game/range/apprentice.h"
#include "game/range/range.h"
#include "game/senses/sound/sound_names.h"
#include "game/senses/tactile/match_effects.h"
#include "game/settings/settings.h"
#include "gesture/gesture_file.h"
#include "haptics/device.h"

namespace thaum::game::inline app {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t max_bytes = 1U << 20U;

/// The part of a line before its comment. A comment begins at the start of the line or after a blank.
std::string_view without_comment(std::string_view line) {
    return line.starts_with('#') ? std::string_view() : line.substr(0, line.find(" #"));
}

/// Names of the sounds or effects that some data file or the program uses.
using UsedNames = std::set<std::string, std::less<>>;

class Check {
public:
    explicit Check(const fs::path& assets) : assets_(assets) {}

    ContentReport run() {
        const auto known = check_file_names(assets_);
        read_matches(known.faults);
        if (!has_data_)
            // Without the folder there is nothing more to check.
            return {.files = known.files, .faults = std::move(faults_)};
        read_practice();
        read_tools();
        read_single_files();
        const bool whole = faults_.empty();
        compare_sounds(whole);
        compare_effects(whole);
        read_layouts();
        if (whole) {
            find_unused_gestures();
            find_unusable_data();
        }
        for (const auto& fault : known.faults) add(fault);
        for (const auto& file : known.read) find_invisible(file);
        return {.files = known.files, .faults = std::move(faults_), .notes = std::move(notes_)};
    }

private:
    /// Adds a line to the faults, with the path of the folder written in its short form.
    void add(std::string line) {
        const auto folder = assets_.string() + "/";
        if (line.starts_with(folder)) line = shown_path(assets_, line.substr(folder.size()));
        // A fault in one file appears again in the check of each file that refers to it, with that file's
        // name in front. Such a repetition ends with a line that is in the report already.
        const auto is_told = [&](const std::string& other) { return line.ends_with(other); };
        if (std::ranges::none_of(faults_, is_told)) faults_.push_back(std::move(line));
    }
    void add(const Error& error) {
        for (auto& line : lines_of(error)) add(std::move(line));
    }
    template <class T>
    void add_fault_of(const Expected<T>& read) {
        if (!read) add(read.error());
    }

    /// Loads each arena with the usual rule set and match length. Loads the first arena also with every other
    /// rule set and every other length. `faults_of_names`: faults in arenas' names, which are not reported a
    /// second time.
    void read_matches(std::span<const std::string> faults_of_names) {
        std::vector<DataChoice> choices;
        for (const auto& arena : files_in(assets_ / "arenas", ".toml").value_or({})) {
            const auto shown = shown_path(assets_, text("arenas/", arena.filename().string(), ":"));
            const auto is_of_it = [&](const std::string& fault) { return fault.starts_with(shown); };
            if (std::ranges::none_of(faults_of_names, is_of_it))
                choices.push_back({.arena = arena.stem().string()});
        }
        if (choices.empty()) choices.emplace_back();
        const auto first = choices[0];
        for (const auto& rules : rule_sets(assets_))
            if (rules != first.rules)
                choices.push_back({.arena = first.arena, .rules = rules, .match = first.match});
        for (const auto& match : match_lengths(assets_))
            if (match != first.match)
                choices.push_back({.arena = first.arena, .rules = first.rules, .match = match});
        for (const auto& mutator : list_mutators(assets_)) {
            add_fault_of(mutator.file);
            if (!mutator.file) continue;
            choices.push_back(first);
            choices.back().mutators = {mutator.name};
        }
        for (const auto& choice : choices) {
            auto reading = read_match_data(assets_, choice);
            if (reading.error) add(*reading.error);
            has_data_ = has_data_ || !reading.data.files.empty();
            // A mutator may well make something useless, so its readings are not searched for that.
            if (choice.mutators.empty()) readings_.push_back(std::move(reading.data));
        }
        for (const auto& arena : arena_choices(assets_))
            if (!arena.fault.empty()) add(arena.fault);
    }

    void read_practice() {
        const auto bots = list_bots(assets_);
        for (const auto& bot : bots) add_fault_of(bot.file);
        if (bots.empty()) add_fault_of(strongest_bot(assets_));
        add_fault_of(load_range(assets_, readings_[0].choice));
        add_fault_of(load_lessons(assets_));
    }

    /// Reads a data file in version 1 of the file format. An error is added to the report.
    std::optional<Config> config_of(const std::string& name) {
        const auto words = read_text_file(assets_ / name, max_bytes);
        if (!words) return add(words.error()), std::nullopt;
        auto config = Config::parse(*words, shown_path(assets_, name), 1);
        if (!config) return add(config.error()), std::nullopt;
        return std::move(*config);
    }

    /// The TOML files of a folder. An error is added to the report.
    std::vector<fs::path> toml_in(const std::string& folder) {
        auto files = files_in(assets_ / folder, ".toml");
        add_fault_of(files);
        return files ? std::move(*files) : std::vector<fs::path>();
    }

    /// Reads the data files of tools and devices that only the lab (the viewer of scans and flows) uses, and
    /// no match.
    void read_tools() {
        for (const auto& file : toml_in("devices")) {
            const auto config = config_of(text("devices/", file.filename().string()));
            if (config) add_fault_of(haptics::read_device(*config));
        }
        const auto config = config_of("materials.toml");
        if (!config) return;
        const auto materials = field::read_materials(*config);
        add_fault_of(materials);
        if (!materials) return;
        for (const auto& file : toml_in("carving")) add_fault_of(field::load_tool(file, *materials));
    }

    void read_single_files() {
        add_fault_of(load_felt_bands(assets_ / "tactile" / "sound.toml"));
        const auto words = read_text_file(assets_ / "settings.toml", max_bytes);
        if (!words) return add(words.error());
        const auto settings = read_settings(*words, shown_path(assets_, "settings.toml"));
        add_fault_of(settings);
        if (settings && settings->fault) add(*settings->fault);
        if (settings) check_last_choice(settings->settings.last);
    }

    /// Checks the last choice in the settings file. The start screen begins with the arena and match that it
    /// names, or with the first ones if it names none.
    void check_last_choice(const LastChoice& last) {
        check_choice("arena", last.arena, stems_in(assets_ / "arenas"));
        check_choice("match", last.match, match_lengths(assets_));
        for (const auto& mutator : last.mutators)
            check_choice("mutator", mutator, stems_in(assets_ / "mutators"));
        check_choice("bot", last.bot, stems_in(assets_ / "bots"));
    }

    void check_choice(std::string_view key, std::string_view name, const std::vector<std::string>& known) {
        if (std::ranges::find(known, name) != known.end()) return;
        std::string all;
        for (const auto& one : known) all += text(all.empty() ? "" : ", ", one);
        const auto words = text("there is no ", key, " '", printable(name, 64), "'; there are: ", all,
                                did_you_mean(name, known));
        add_missing({{.file = "settings.toml", .table = "", .key = std::string(key), .words = words}}, "");
    }

    void read_layouts() {
        for (const auto& file : toml_in("tactile/layouts")) add_fault_of(tactile::load_layout(file));
        const auto body = LiveBody::load(assets_);
        add_fault_of(body);
        if (!body) return;
        for (const auto& fault : body->faults) add(fault);
    }

    /// Place of a name in a file: "assets/wands/bolt.toml:12: 'sound'".
    std::string place_of(const MissingName& missing) {
        auto shown = shown_path(assets_, missing.file);
        const auto words = read_text_file(assets_ / missing.file, max_bytes);
        const auto config = words ? Config::parse(*words, shown, 1) : Expected<Config>(words.error());
        if (!config) return shown;
        auto table = config->root();
        for (std::string_view remaining = missing.table; !remaining.empty();) {
            const auto dot = std::min(remaining.find('.'), remaining.size());
            table = table.table(remaining.substr(0, dot));
            remaining.remove_prefix(std::min(dot + 1, remaining.size()));
        }
        return text(table.place(missing.key), ": '", missing.key, "'");
    }

    /// Reports names for which a file is missing. `folder` is where the file should be if no data file names
    /// it, but the program itself needs it.
    void add_missing(const std::vector<MissingName>& all, std::string_view folder) {
        for (const auto& missing : all)
            add(missing.file.empty()
                    ? text(shown_path(assets_, folder), ": ", missing.words, "; the program needs it")
                    : text(place_of(missing), ": ", missing.words));
    }

    /// Reports sounds that are named but missing. If all other files are right (`whole`), also reports sounds
    /// that nothing uses.
    void compare_sounds(bool whole) {
        const auto bank = audio::load_sounds(assets_ / "sounds", audio::WithSamples::no);
        if (!bank) return add(bank.error());
        for (const auto& sound : bank->faulty) add(sound.fault);
        UsedNames used;
        for (const auto name : menu_sound_names) {
            used.emplace(name);
            if (!name.empty() && !bank->find(name) && !is_left_out(*bank, name))
                add_missing({{.file = "",
                              .table = "",
                              .key = "",
                              .words = text("there is no sound '", name, "', sounds/", name, ".toml")}},
                            "sounds");
        }
        for (const auto& reading : readings_) {
            const auto sounds = match_sounds(*bank, *reading.presentation);
            add_missing(sounds.missing, "sounds");
            for (const auto number : numbers_of(sounds))
                if (number) used.insert(bank->sounds[*number].name);
        }
        for (const auto& sound : bank->sounds)
            if (whole && !used.contains(sound.name)) add_unused("sounds", sound.name, "event, wand or spell");
    }

    static std::vector<SoundNumber> numbers_of(const MatchSounds& sounds) {
        std::vector<SoundNumber> all(sounds.cues.begin(), sounds.cues.end());
        all.insert(all.end(), sounds.events.begin(), sounds.events.end());
        all.insert(all.end(), sounds.power_ups.begin(), sounds.power_ups.end());
        all.insert(all.end(), sounds.spells.begin(), sounds.spells.end());
        for (const auto& wand : sounds.wands)
            all.insert(all.end(), {wand.fire, wand.burst, wand.take, wand.ready, wand.hold});
        return all;
    }

    void compare_effects(bool whole) {
        const auto bank = tactile::load_effects(assets_ / "tactile" / "effects");
        if (!bank) return add(bank.error());
        for (const auto& effect : bank->faulty) add(effect.fault);
        UsedNames used;
        for (const auto& reading : readings_) {
            const auto effects = match_effects(*bank, *reading.presentation);
            add_missing(effects.missing, "tactile/effects");
            for (const auto number : numbers_of(effects))
                if (number) used.insert(bank->effects[*number].name);
        }
        if (!whole || !bank->faulty.empty()) return;
        for (const auto& effect : bank->effects)
            if (!used.contains(effect.name)) add_unused("tactile/effects", effect.name, "event or spell");
        find_unused_clips(*bank);
    }

    static std::vector<EffectNumber> numbers_of(const MatchEffects& effects) {
        std::vector<EffectNumber> all(effects.events.begin(), effects.events.end());
        all.insert(all.end(), effects.spells.begin(), effects.spells.end());
        all.insert(all.end(), effects.sounds.begin(), effects.sounds.end());
        all.insert(all.end(), {effects.recoil, effects.stir, effects.heartbeat, effects.great_work,
                               effects.walk_left, effects.walk_right});
        return all;
    }

    void find_unused_clips(const tactile::EffectBank& bank) {
        for (const auto& file : files_in(assets_ / "tactile" / "effects", ".tact").value_or({})) {
            const auto name = file.filename().string();
            if (std::ranges::none_of(bank.effects, [&](const auto& e) { return e.clip_file == name; }))
                add(text(file.string(), ": nothing uses this file: no effect names it as its clip"));
        }
    }

    void find_unusable_data() {
        const auto found = find_unusable(readings_);
        add_missing(found.faults, "");
        for (const auto& note : found.notes) notes_.push_back(text(place_of(note), ": ", note.words));
        const auto gestures = files_in(assets_ / "gestures", ".toml").value_or({});
        for (const auto& file : gestures) note_name_of_gesture(file);
    }

    /// Notes a gesture whose key `name` differs from the name of its file. Spells and recipes use the key, so
    /// a person who uses the file's name there would not find the gesture.
    void note_name_of_gesture(const fs::path& file) {
        const auto name = text("gestures/", file.filename().string());
        const auto gesture = gesture::load_gesture(file);
        if (!gesture || gesture->name == file.stem().string()) return;
        notes_.push_back(text(place_of({.file = name, .table = "", .key = "name", .words = ""}), " is '",
                              printable(gesture->name, 64),
                              "', and the file has another name; spells and potions use '",
                              printable(gesture->name, 64), "'"));
    }

    /// Reports invisible characters, which make two names differ that look the same. Comments may have them,
    /// and texts for the screen may have no-break spaces.
    void find_invisible(const std::string& file) {
        auto words = read_text_file(assets_ / file, max_bytes).value_or("");
        auto remaining = without_byte_order_mark(words);
        for (std::size_t line = 1; !remaining.empty(); ++line) {
            const auto end = std::min(remaining.find('\n'), remaining.size());
            const auto found = hidden_character(without_comment(remaining.substr(0, end)));
            remaining.remove_prefix(std::min(end + 1, remaining.size()));
            const auto place = text(shown_path(assets_, file), ":", line, ": ");
            const auto is_told = [&](const std::string& fault) {
                return fault.starts_with(place) && fault.find("invisible character") != fault.npos;
            };
            if (!found.empty() && std::ranges::none_of(faults_, is_told))
                faults_.push_back(text(place, "the line has ", found, ": delete it"));
        }
    }

    void find_unused_gestures() {
        UsedNames used;
        for (const auto& reading : readings_) {
            for (const auto& spell : reading.spells) used.insert(spell.stats.gesture);
            for (const auto& recipe : reading.recipes)
                for (const auto& stroke : recipe.strokes) used.insert(stroke.gesture);
        }
        const auto found =
            std::ranges::find_if(readings_, [](const auto& reading) { return reading.gestures != nullptr; });
        if (found == readings_.end()) return;
        for (const auto& gesture : found->gestures->gestures())
            if (!used.contains(gesture.name))
                add(text(shown_path(assets_, "gestures"), ": nothing uses the gesture '", gesture.name,
                         "': no spell and no potion names it"));
    }

    void add_unused(std::string_view folder, std::string_view name, std::string_view who) {
        add(text(shown_path(assets_, text(folder, "/", name, ".toml")), ": nothing uses this file: no ", who,
                 " names '", name, "'"));
    }

    const fs::path& assets_;
    std::vector<std::string> faults_, notes_;
    std::vector<MatchData> readings_;
    bool has_data_ = false;
};

}  // namespace

ContentReport check_content(const fs::path& assets) { return Check(assets).run(); }

std::string short_words(const ContentReport& report) {
    if (report.faults.empty()) return "";
    const auto more = report.faults.size() - 1;
    return text(report.faults[0], more == 0 ? "; all: thaum check" : text("; ", more, " more: thaum check"));
}

}  // namespace thaum::game::inline app

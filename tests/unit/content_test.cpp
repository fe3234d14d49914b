// Tests with common mistakes in data files. The message about each mistake must name the file, the line, what
// is allowed, and, for a misspelt word, the similar word that is known. Before the command `thaum check`
// existed, the program was tried with 117 mistakes: its messages named the file of 83 mistakes, the line of
// 78, and what to do for 26. The tests take 4 s.
#include "game/app/content.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <charconv>
#include <fstream>

#include "core/file.h"
#include "core/text.h"
#include "game/data/match_data.h"
#include "unit/copied_assets.h"

namespace thaum::game {
namespace {

namespace fs = std::filesystem;

/// One edit of one file, and what the message must contain.
struct Mistake {
    std::string file;
    std::string
        from;  ///< text to be replaced; empty: the edit is a new file, or is added at the end of the file
    std::string to;
    std::vector<std::string> says{};
    bool has_line = true;  ///< true: the message names a line within three lines of the edit
};

class Content : public testing::Test {
protected:
    /// Writes a data file, even one that exists. The program's own writers refuse to replace such a file.
    static void put(const fs::path& path, const std::string& words) {
        std::ofstream(path, std::ios::binary) << words;
    }

    std::string text_of(const std::string& file) const {
        return read_text_file(assets_ / file, 1U << 20U).value_or("");
    }

    /// Makes the mistake. Returns the line of the edit.
    std::size_t make(const Mistake& mistake) {
        const auto path = assets_ / mistake.file;
        const auto before = fs::exists(path) ? text_of(mistake.file) : std::string();
        const auto at = mistake.from.empty() ? before.size() : before.find(mistake.from);
        EXPECT_NE(at, std::string::npos) << mistake.file << " has no " << mistake.from;
        if (at == std::string::npos) return 0;
        auto after = before;
        after.replace(at, mistake.from.size(), mistake.to);
        fs::create_directories(path.parent_path());
        put(path, after);
        const auto end = before.begin() + static_cast<std::ptrdiff_t>(at);
        return 1 + static_cast<std::size_t>(std::count(before.begin(), end, '\n'));
    }

    /// Restores the file as it is shipped.
    void mend(const Mistake& mistake) {
        const auto shipped = fs::path(THAUM_SOURCE_DIR "/assets") / mistake.file;
        if (fs::exists(shipped))
            put(assets_ / mistake.file, read_text_file(shipped, 1U << 20U).value());
        else
            fs::remove(assets_ / mistake.file);
    }

    /// Makes all mistakes at once. Returns how many of them the one report mentions.
    std::size_t answered(const std::vector<Mistake>& mistakes);

    const CopiedAssets copied_;
    const fs::path assets_ = copied_.path;
};

/// Line in a message that begins with "FILE:LINE:"; 0: it names none.
std::size_t line_in(std::string_view answer, const std::string& file) {
    std::size_t line = 0;
    if (answer.size() > file.size() + 1)
        std::from_chars(answer.data() + file.size() + 1, answer.data() + answer.size(), line);
    return line;
}

bool answers_it(const std::string& answer, const Mistake& mistake, std::size_t line) {
    const auto file = text("assets/", mistake.file);
    const auto folder = text("assets/", fs::path(mistake.file).parent_path().string(), ":");
    if (!answer.starts_with(file) && !answer.starts_with(folder)) return false;
    const auto named = line_in(answer, file);
    if (mistake.has_line && (named == 0 || named + 3 < line || named > line + 3)) return false;
    return std::ranges::all_of(mistake.says,
                               [&](const auto& part) { return answer.find(part) != answer.npos; });
}

const std::string quick = "rules/quick.toml", bolt = "wands/bolt.toml", lob = "wands/lob.toml",
                  push = "spells/push.toml", haste = "potions/haste.toml", bot = "bots/level_0.toml",
                  court = "arenas/boiling_court.toml", touch_file = "devices/touch.toml",
                  brew = "cauldron.toml", hit = "tactile/effects/bolt_hit.toml", stir = "sounds/stir.toml",
                  paint = "carving/paint.toml", events = "events.toml", pad = "tactile/layouts/pad.toml",
                  wizard = "wizards/wizard.toml", settings = "settings.toml", lessons = "apprentice.toml",
                  v = "gestures/v.toml";

/// Mistakes in how numbers, and lines with a key, are written.
std::vector<Mistake> slips_of_numbers() {
    return {
        {quick, "seconds = 240 ", "seconds = 240,5 ", {"240.5"}},
        {quick, "seconds = 240 ", "seconds = 240, ", {"leave out the ','"}},
        {quick, "seconds = 240 ", "seconds = 240 s ", {"no unit"}},
        {quick, "seconds = 240 ", "seconds : 240 ", {"'=' in place of ':'"}},
        {quick, "seconds = 240 ", "seconds ", {"="}},
        {quick, "seconds = 240 ", "seconds = ", {"after '='"}},
        {quick, "seconds = 240 ", "seconds = .5 ", {"before and after its point"}},
        {quick, "seconds = 240 ", "seconds = 5. ", {"before and after its point"}},
        {quick, "kills = 3 ", "kills = 03 ", {"zero"}},
        {quick, "kills = 3 ", "kills = three ", {"'three' is no number"}},
        {quick, "kills = 3 ", "kills = 3\nkills = 4 ", {"twice", "first in line 3"}},
        {quick, "kills = 3 ", "kills = 3;", {"';'"}},
        {quick, "kills = 3 ", "// many\nkills = 3 ", {"comment begins with '#'"}},
        {quick, "kills = 3 ", "ki lls = 3 ", {"no blanks"}},
        {quick, "version = 1\n", "version = 1\r\n\r", {"line feed"}},
        {quick, "version = 1", "version = 2", {"only version 1"}},
        {quick, "version = 1\n", "", {"'version' is missing", "version = 1"}},
        {quick, "version", "verison", {"unknown key 'verison'", "'version'"}},
    };
}

/// Mistakes in how texts, lists and tables are written.
std::vector<Mistake> slips_of_texts_and_tables() {
    return {
        {court, "name = \"Boiling Court\"", "name = Boiling Court", {"in quotes"}},
        {court, "name = \"Boiling Court\"", "name = “Boiling Court”", {"straight quotes"}},
        {court, "name = \"Boiling Court\"", "name = \"Boiling Court", {"not closed"}},
        {court, "centre = [0, -3, 0]", "centre = [0 -3 0]", {"commas"}},
        {court, "centre = [0, -3, 0]", "centre = [0, -3, 0", {"']' is missing"}},
        {court, "mirror = true\n\n[[solid]]  # west", "mirror = yes\n\n[[solid]]  # west", {"true or false"}},
        {court,
         "mirror = true\n\n[[solid]]  # west",
         "mirror = True\n\n[[solid]]  # west",
         {"true or false"}},
        {court, "[look.sun]", "[look.sun", {"a table is [name]"}},
        {bolt, "[shot]", "[shot]\n[shot]", {"twice"}},
        {bolt, "[shot]", "[[shot]]", {"'shot' must be a table"}},
        {bolt,
         "slot = 1\n[energy]",
         "[energy]\nslot = 1",
         {"'slot' is missing", "'energy.slot': move it"},
         false},
        {court, "surface = \"floor\"", "surface = \"flo\u00ador\"", {"U+00AD (soft hyphen)"}},
        {stir, "[[parts]]  # lapping", "[parts]  # lapping", {"each entry of a list begins with [[parts]]"}},
        {lob, "[[look.", "[look.", {"a table is [name]"}},
    };
}

/// Misspelt keys and tables, and missing ones.
std::vector<Mistake> wrong_names() {
    return {
        {quick, "kills = 3", "kils = 3", {"unknown key 'kils'", "'kills'"}},
        {quick, "kills = 3", "Kills = 3", {"'kills'"}},
        {quick, "interval_s", "interval-s", {"'interval_s'"}},
        {quick, "rounds = 1 ", "rounds = 1\ncolour = 3 ", {"unknown key 'colour'"}},
        {quick, "kills = 3", "# kills = 3", {"'kills' is missing", "whole number"}, false},
        {bolt, "[shot]", "[schot]", {"unknown key 'schot'", "'shot'"}},
        {bolt, "[shot]\n", "", {"unknown key"}, false},
        {bolt, "damage = 6", "damge = 6", {"'damage'"}},
        {bolt, "[event.bolt_hit]", "[event.bolt_hitt]", {"'bolt_hit'"}},
        {bolt, "[look] ", "[loock] ", {"look"}, false},
        {push, "[things]", "[thing]", {"'things'"}},
        {haste, "[[ingredient]]", "[[ingredients]]", {"ingredient"}},
        {haste, "factor = 1.3", "facter = 1.3", {"'factor'"}},
        {bot, "reaction_s", "reaction", {"'reaction"}},
        {court, "[[prop]]  # table", "[[props]]  # table", {"'prop'"}},
        {court, "position = [-12.5, 0.05, 4.6]", "postion = [-12.5, 0.05, 4.6]", {"'position'"}},
        {court, "centre = [0, -3, 0]", "center = [0, -3, 0]", {"'centre'"}},
        {touch_file, "[force]", "[forces]", {"'force'"}},
        {touch_file, "peak_n = 3.3", "peek_n = 3.3", {"'force.peek_n'", "'peak_n'"}},
        {touch_file, "[mechanism]\n", "", {"mechanism"}, false},
        {stir, "seconds = 1.5", "second = 1.5", {"'seconds'"}},
        {hit, "priority", "prority", {"'priority'"}},
        {paint, "radius = 3", "radious = 3", {"'radius'"}},
        {events, "[object_hit]", "[object_hitt]", {"'object_hit'"}},
        {settings, "fullscreen", "fulscreen", {"'fullscreen'"}},
        {wizard, "[walk]", "[wlak]", {"'walk'"}},
        {pad, "lowest_hz", "lowset_hz", {"'lowest_hz'"}},
    };
}

/// Values of a wrong kind or out of range, and words that are not allowed.
std::vector<Mistake> wrong_values() {
    return {
        {quick, "kills = 3", "kills = \"3\"", {"'kills'", "whole number from", "without quotes"}},
        {quick, "kills = 3", "kills = 3.5", {"whole number from"}},
        {quick, "kills = 3", "kills = -3", {"must be from"}},
        {quick, "kills = 3", "kills = 1000000000000", {"must be from"}},
        {quick, "seconds = 240", "seconds = nan", {"must be"}},
        {quick, "seconds = 240", "seconds = true", {"a number from"}},
        {quick, "seconds = 240", "seconds = 1e-300", {"from 1 to 36000"}},
        {"rules/thaum.toml", "cauldron = true", "cauldron = \"true\"", {"true or false"}},
        {"rules/thaum.toml", "cauldron = true", "cauldron = 1", {"true or false"}},
        {"rules/thaum.toml", "cauldron = true", "cauldron = tru", {"thaum.toml"}},
        {bolt, "damage = 6", "damage = \"6,5\"", {"6.5"}},
        {bolt, "sound = \"hit_wizard\"", "sound = 3", {"text in quotes"}},
        {bolt, "colour = \"#8A5E3A\"", "colour = \"#8A5E3\"", {"#RRGGBB"}},
        {bolt, "shape = \"rod\"", "shape = \"rood\"", {"rod, ball", "did you mean 'rod'"}},
        {bolt, "slot = 1", "slot = 99", {"from 1 to"}},
        {bolt, "mark = \"hit\"", "mark = \"hitt\"", {"'hit'"}},
        {court, "surface = \"floor\"", "surface = \"flor\"", {"did you mean 'floor'"}},
        {court, "shape = \"box\"", "shape = \"bx\"", {"box, cylinder"}},
        {court, "centre = [0, -3, 0]", "centre = [0, -3]", {"three numbers"}},
        {court, "centre = [0, -3, 0]", "centre = \"0, -3, 0\"", {"three numbers"}},
        {court, "mass = 40", "mass = 0", {"from 1 to 200"}},
        {court, "kind = \"vial\"", "kind = \"vail\"", {"did you mean 'vial'"}},
        {touch_file, "position_quantum_m = 5.5e-5", "position_quantum_m = 1e-11", {"at least 1e-09"}},
        {touch_file, "position_quantum_m = 5.5e-5", "position_quantum_m = 5e-324", {"at least"}},
        {stir, "filter = \"band\"", "filter = \"bnad\"", {"low, band, high", "'band'"}},
        {hit, "purpose = \"impact\"", "purpose = \"impakt\"", {"'impact'"}},
        {haste, "kind = \"pace\"", "kind = \"pase\"", {"did you mean 'pace'"}},
        {haste, "turn = \"clockwise\"", "turn = \"clokwise\"", {"'clockwise'"}},
        {settings, "fov_deg = 90", "fov_deg = 900", {"60 to 130"}},
        {bot, "lead = 0", "lead = -1", {"from 0 to 2"}},
    };
}

/// Names of files that do not exist, and names and numbers that are used twice.
std::vector<Mistake> wrong_references() {
    return {
        {brew, "solver = \"thaum\"", "solver = \"taum\"", {"'thaum'"}},
        {lessons, "arena = \"boiling_court\"", "arena = \"boiling_curt\"", {"'boiling_court'"}},
        {bolt, "sound = \"hit_wizard\"", "sound = \"hit_wizzard\"", {"'hit_wizzard'", "'hit_wizard'"}},
        {bolt, "fire = \"bolt_shot\"", "fire = \"bolt_shoot\"", {"'bolt_shot'"}},
        {bolt, "tactile = \"bolt_hit\"", "tactile = \"bolt_hitt\"", {"'bolt_hit'"}},
        {push, "gesture = \"v\"", "gesture = \"stair\"", {"no file of gestures", "'star'"}},
        {"spells/shield.toml", "gesture = \"circle\"", "gesture = \"v\"", {"casts push"}},
        {"spells/shield.toml", "slot = 1", "slot = 2", {"'slot' is 2, where push is"}},
        {push, "sound = \"cast_push\"", "sound = \"cast_posh\"", {"'cast_push'"}},
        {haste, "name = \"ember\"", "name = \"embers\"", {"did you mean 'ember'"}},
        {haste, "gesture = \"circle\"", "gesture = \"circel\"", {"did you mean 'circle'"}},
        {court, "ingredient = \"salt\"", "ingredient = \"sallt\"", {"'salt'"}},
        {"haptics.toml", "device = \"touch\"", "device = \"tuch\"", {"'touch'"}},
        {"crystal.toml", "name = \"melt\"", "name = \"malt\"", {"'melt'"}},
        {bolt, "slot = 1", "slot = 2", {"'slot' is 2"}, false},
    };
}

/// Files that nothing reads, duplicates, and places where nothing can stand.
std::vector<Mistake> wrong_files_and_places() {
    return {
        {"wands/rocket.toml", "", "version = 1", {"'kind' is 'rocket'", "blast, bolt"}, false},
        {"arenas/the_well.toml", "[[niche]]", "[niche]", {"each entry of a list begins with [[niche]]"}},
        {"wands/bollt.toml", "", "version = 1", {"'bolt'"}, false},
        {"spells/heal.toml", "", "version = 1", {"'kind' is 'heal'", "push"}, false},
        {"bots/My Bot.toml", "", "version = 1", {"a-z, 0-9 and _"}, false},
        {"sound/bang.toml", "", "version = 1", {"did you mean 'sounds'"}, false},
        {"arenas/mine.tml", "", "version = 1", {"'.toml'"}, false},
        {"potions/My Potion.toml", "", "version = 1", {"a-z, 0-9 and _"}, false},
        {"materal.toml", "", "version = 1", {"'materials'"}, false},
        {"arenas/twin.toml", "", "version = 1\nname = \"Boiling Court\"\n", {"boiling_court"}},
        {court,
         "position = [10, 0.4, 4.5]",
         "position = [7, 0.75, 3.5]",
         {"'position'", "inside of the solid 'stone'"}},
        {court, "position = [-15, 0, 15]", "position = [0, 0, 9]", {"m above the ground"}},
        {court, "position = [-15, 0, 15]", "position = [16, 0, 0]", {"inside of the solid"}},
        {court, "position = [-15, 0, 15]", "position = [-25, 0, 15]", {"outside of the arena's ground"}},
        {court,
         "[[solid]]  # plinth of",
         "[[solid]]\nshape = \"bowl\"\nsurface = \"bowl\"\ncentre = [9, 0.55, 0]\nradius = 1.5\nheight = "
         "1.1\n"
         "thickness = 0.15\n[[solid]]  # plinth of",
         {"second bowl"}},
        {lessons, "arena = \"boiling_court\"", "arena = \"boiling court\"", {"arena"}},
    };
}

/// Values that can be read but never have an effect.
std::vector<Mistake> useless_values() {
    return {
        {push, "focus = 20", "focus = 500", {"'focus': is 500", "at most 100", "never be cast"}},
        {bolt, "cost = 1.5", "cost = 150", {"'cost': is 150", "at most 60", "never be used"}},
        {"wands/swing.toml", "cost = 1 ", "cost = 90 ", {"at most 80"}},
        {"spells/shield.toml",
         "shown = \"Shield\"",
         "shown = \"Push\"",
         {"spells/push.toml", "tell them apart"}},
        {settings,
         "arena = \"boiling_court\"",
         "arena = \"boiling_cort\"",
         {"no arena", "did you mean 'boiling_court'"}},
        {settings, "match = \"quick\"", "match = \"qick\"", {"no match", "did you mean 'quick'"}},
        {court, "name = \"Boiling Court\"", "name = \"Boil\u200bing Court\"", {"U+200B (zero-width space)"}},
        {v, "name = \"v\"", "name = \"v\u00ad\"", {"U+00AD (soft hyphen)"}},
        {settings, "bot = \"level_0\"", "bot = \"levle_0\"", {"no bot", "did you mean 'level_0'"}},
        {"rules/My Rules.toml", "", "version = 1", {"a-z, 0-9 and _"}, false},
        {brew, "name = \"salt\"", "name = \"ember\"", {"two ingredients 'ember'"}},
        {"haptics.toml", "device = \"touch\"", "device = \"Touch\"", {"did you mean 'touch'?"}},
        {"haptics.toml", "device = \"touch\"", "device = \"touch.toml\"", {"did you mean 'touch'?"}},
        {bolt, "fire = \"bolt_shot\"", "fire = \"sounds/bolt_shot.toml\"", {"did you mean 'bolt_shot'?"}},
        {events, "feed = \"{by}", "feed = \"{bi}", {"'{bi}' is none of them"}},
        {lessons, "hold {fire}:", "hold {fier}:", {"'{fier}' is none of them", "did you mean 'fire'?"}},
        {"tactile/effects/death.toml", "death.tact", "deth.tact", {"'file'", "did you mean 'death'?"}, false},
    };
}

std::size_t Content::answered(const std::vector<Mistake>& mistakes) {
    std::vector<std::size_t> lines;
    for (const auto& mistake : mistakes) lines.push_back(make(mistake));
    const auto faults = check_content(assets_).faults;
    std::string said;
    for (const auto& fault : faults) said += text("\n    ", fault);
    std::size_t good = 0;
    for (std::size_t i = 0; i < mistakes.size(); ++i) {
        const auto& mistake = mistakes[i];
        const bool is_good = std::ranges::any_of(
            faults, [&](const auto& fault) { return answers_it(fault, mistake, lines[i]); });
        EXPECT_TRUE(is_good) << mistake.file << ":" << lines[i] << ": '" << mistake.from << "' -> '"
                             << mistake.to << "'" << said;
        good += is_good ? 1 : 0;
        mend(mistake);
    }
    return good;
}

/// Groups of mistakes that can be made at once, because each is in a file of its own.
std::vector<std::vector<Mistake>> sets_of(const std::vector<Mistake>& mistakes) {
    std::vector<std::vector<Mistake>> sets;
    for (const auto& mistake : mistakes) {
        const auto has_file = [&](const std::vector<Mistake>& set) {
            return std::ranges::find(set, mistake.file, &Mistake::file) != set.end();
        };
        const auto free = std::ranges::find_if_not(sets, has_file);
        (free == sets.end() ? sets.emplace_back() : *free).push_back(mistake);
    }
    return sets;
}

/// Files that systems and editors leave behind, and files in which people explain others, are no faults.
TEST_F(Content, FilesThatSystemsLeaveAreNoFaults) {
    const auto files = check_content(assets_).files;
    for (const auto* name : {"desktop.ini", "Thumbs.db", ".DS_Store", ".directory", "arenas/README.md",
                             "wands/bolt.toml.bak", "wands/bolt.toml~", "wands/.bolt.toml.swp",
                             "potions/._haste.toml", "sounds/#stir.toml#", "__MACOSX/bolt.toml"}) {
        fs::create_directories((assets_ / name).parent_path());
        put(assets_ / name, "leftover");
    }
    const auto report = check_content(assets_);
    EXPECT_EQ(report.faults, std::vector<std::string>());
    EXPECT_EQ(report.files, files);
}

TEST_F(Content, TheShippedFilesHaveNoFault) {
    const auto report = check_content(assets_);
    EXPECT_EQ(report.faults, std::vector<std::string>());
    EXPECT_GT(report.files, 150U);
    EXPECT_EQ(short_words(report), "");
    for (const auto* foreign : {"notes.odt", "wands/sketch.png"})
        std::ofstream(assets_ / foreign) << "of another program";
    const auto with_foreign = check_content(assets_);
    EXPECT_EQ(with_foreign.files, report.files) << "what nothing reads is no data file";
    EXPECT_EQ(with_foreign.faults.size(), 2U);
}

/// These values are playable, so the check notes them but does not count them as faults.
TEST_F(Content, WhatIsProbablyNotMeantIsNoted) {
    const auto note_after = [&](const Mistake& mistake) {
        make(mistake);
        const auto report = check_content(assets_);
        EXPECT_EQ(report.faults, std::vector<std::string>());
        mend(mistake);
        return report.notes.empty() ? "" : report.notes[0];
    };
    const std::string well = "arenas/the_well.toml";
    EXPECT_TRUE(check_content(assets_).notes.empty());
    EXPECT_EQ(
        note_after({well, "ingredient = \"salt\"\nposition = [6.5, 0, 6.8]\nturned = true",
                    "ingredient = \"salt\"\nposition = [6.5, 0, 6.8]"}),
        "assets/arenas/the_well.toml:242: 'niche': 1 niche of 'salt', which azoth needs, and 2 of others");
    EXPECT_NE(
        note_after({well, "surface = \"crystal\"", "surface = \"stone\""}).find("which the Great Work needs"),
        std::string::npos);
    fs::rename(assets_ / "gestures/v.toml", assets_ / "gestures/wedge.toml");
    const auto report = check_content(assets_);
    EXPECT_EQ(report.faults, std::vector<std::string>());
    ASSERT_EQ(report.notes.size(), 1U);
    EXPECT_EQ(report.notes[0],
              "assets/gestures/wedge.toml:2: 'name' is 'v', and the file has another name; spells and "
              "potions use 'v'");
}

/// Mistakes that show within one file. Those of different files are made together, and one report must name
/// them all.
TEST_F(Content, MistakesWithinAFileAreAnswered) {
    std::vector<Mistake> mistakes;
    for (const auto& some : {slips_of_numbers(), slips_of_texts_and_tables(), wrong_names(), wrong_values()})
        mistakes.insert(mistakes.end(), some.begin(), some.end());
    std::size_t good = 0;
    for (const auto& set : sets_of(mistakes)) good += answered(set);
    EXPECT_GE(mistakes.size(), 80U);
    EXPECT_EQ(good, mistakes.size());
}

TEST_F(Content, MistakesBetweenFilesAreAnswered) {
    auto mistakes = wrong_references();
    for (const auto& more : {wrong_files_and_places(), useless_values()})
        mistakes.insert(mistakes.end(), more.begin(), more.end());
    std::size_t good = 0;
    for (const auto& mistake : mistakes) good += answered({mistake});
    EXPECT_GE(mistakes.size(), 25U);
    EXPECT_EQ(good, mistakes.size());
}

}  // namespace
}  // namespace thaum::game

// game/data/presentation.h: how a match is shown to people. It never changes the match, so its data is not
// among the hashed files of a log.
//
// Each kind of event has one row. The rows of the rules' events are in assets/events.toml. A wand's own file
// has the rows of its hits:
//
//     [event.bolt_hit]
//     mark = "hit"      # what the HUD shows: none, hit, fall, warning, gift
//     caption = ""      # words of the mark
//     feed = ""         # line in the feed of all players
//     feed_alone = ""   # line in the feed if no other player caused the event
//     feed_fall = ""    # line in the feed if a mere fall caused the event; default: feed_alone
//     sound = ""        # name of a sound of assets/sounds; may contain {power_up}
//     tactile = ""      # name of an effect on the body (assets/tactile/effects)
//
// Words may contain {by}, {whom}, {cause}, {power_up}, {amount}, {gain}, {spell}, {potion}, {effect},
// {fault}, {recipe} and {ingredient}; the caption of a gift also controls (game/data/control_words.h). A
// sound or an effect "{spell}" is that of the spell's own file (game/data/spell.h).
#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/config.h"
#include "game/data/brew_words.h"
#include "game/data/event_kinds.h"
#include "game/data/wand_look.h"

namespace thaum::game::inline data {

/// Mark of an event on the HUD of the players concerned.
enum class HudMark : std::uint8_t {
    none,
    hit,      ///< arc towards the source for the victim, cross at the crosshair for the player who hit
    fall,     ///< arc below the crosshair for the victim
    warning,  ///< caption below the crosshair for a moment
    gift      ///< caption low in the view for two seconds
};

/// Names in braces that the text of an event may contain.
enum class EventWord : std::uint8_t {
    by,
    whom,
    cause,
    power_up,
    amount,
    gain,
    spell,
    potion,
    effect,
    fault,
    recipe,
    ingredient
};

/// A piece of plain text, and the name in braces that follows it.
struct WordsPiece {
    std::string plain;
    std::optional<EventWord> word{};
};
/// Splits a text at its names in braces. Braces without a known name stay plain text.
std::vector<WordsPiece> pieces_of(std::string_view pattern);

/// How one kind of event is shown.
struct EventRow {
    HudMark mark{};
    std::string caption, feed, feed_alone, feed_fall;
    std::string sound, tactile;
};

/// Rows of all kinds of event, indexed by EventKind.
using EventRows = std::vector<EventRow>;

/// Names of a wand's sounds (assets/sounds), from the table `sound` of its data file. Empty: no sound.
struct WandSounds {
    std::string fire;   ///< sound of a shot or a throw
    std::string burst;  ///< sound of the burst of a shot
    /// Sound when the wand takes hold of a thing, or its rope of an anchor (a point for ropes)
    std::string take;
    std::string ready;  ///< sound that lasts while the wand is charged or drawn; its pitch rises
    std::string
        hold;  ///< sound that lasts while the wand holds a thing or a rope; louder and lower with the force
};
WandSounds read_wand_sounds(const ConfigTable& wand);

/// How one wand is shown and heard.
struct WandPresentation {
    std::string name;
    std::uint32_t slot{};
    WandLook look;
    WandSounds sounds;
    double energy_cap{}, energy_cost{};  ///< energy of a full wand, and minimum energy of one use
};

/// Placeholder for the name of the sound or effect of the spell concerned.
inline constexpr std::string_view of_spell = "{spell}";

/// Sign that a spell shows in the world while it acts.
enum class SpellSign : std::uint8_t {
    none,
    shell,  ///< a shell around the caster while the shield lasts
    beads,  ///< beads of light that follow the thing flying back to the caster
    dust    ///< dust in front of the caster
};
inline constexpr std::array<std::string_view, 4> spell_signs{"none", "shell", "beads", "dust"};

/// How one spell is shown, heard and felt.
struct SpellPresentation {
    std::string name;     ///< name of the file assets/spells/NAME.toml
    std::string sound;    ///< name of a sound of assets/sounds; empty: none
    std::string tactile;  ///< name of an effect on the caster's body; empty: none
    SpellSign sign{};     ///< key `sign` of the table `look`; default: "none"
    /// Colour of an unfinished stroke that will probably cast this spell, as sRGB 0xRRGGBB: key `colour` of
    /// the table `look`.
    std::uint32_t colour = 0xFFFFFF;
    std::string shown{};    ///< name on the screen
    std::string gesture{};  ///< name of the gesture that casts it
    /// Wand key that casts the spell while the button Trace is held, 0 to wand_slots - 1.
    std::uint32_t slot{};
    double focus{};  ///< focus (what spells cost) that a gentle cast takes
};
/// Reads what is seen, heard and felt, from the tables `look` and `event` of the spell's data file.
SpellPresentation read_spell_presentation(std::string_view name, const ConfigTable& spell);

/// How a match is shown.
struct Presentation {
    EventRows events;
    /// Looks and sounds of spells, indexed by the spell's number; empty if the match has no spells.
    std::vector<SpellPresentation> spells;
    std::vector<WandPresentation> wands;  ///< looks and sounds of wands, in the order of MatchData::wands
    BrewWords brew;
};

/// Sign of a spell by its number; none for a number without a spell.
SpellSign sign_of(const Presentation& shown, std::uint32_t spell);

/// A name of a sound or effect that has no file.
struct MissingName {
    /// Data file that contains the name, such as "wands/bolt.toml"; empty: the name is in the program.
    std::string file;
    std::string table;  ///< table of the data file, such as "event.bolt_hit"
    std::string key;
    std::string words;  ///< the message: what is missing, and the name that was probably meant
};

/// One line on a missing name.
std::string line_of(const MissingName& missing);

/// Data file that defines how a kind of event is shown: events.toml, or the file of the wand whose hit it is.
std::string file_of_event(EventKind kind);

/// Table that defines how a kind of event is shown: "bolt_hit", or "event.bolt_hit" in a wand's file.
std::string table_of_event(EventKind kind);

/// Reads how events of the rules (those that no wand brings) are shown, from assets/events.toml, which has a
/// row for each kind. Reports unknown names and missing rows.
EventRows read_event_rows(const Config& file);

/// Reads how a wand's hits are shown, a row for each kind, from the table `event` of the wand's data file.
/// Reports unknown names and missing rows. `is_own_file`: the file has the name of the wand's kind. Other
/// files of the kind may not have rows.
void read_hit_rows(const ConfigTable& wand, bool is_own_file, const std::vector<HitKind>& hits,
                   EventRows& rows);

/// Row of a kind; an empty row for a number without a kind.
const EventRow& row_of(const EventRows& rows, EventKind kind);

}  // namespace thaum::game::inline data

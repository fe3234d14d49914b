// game/data/event_kinds.h: all kinds of event of this program: those of EventKind, those that a source
// registers (EventRegistration), and the hits that wands bring (WandKind::hits). Each kind has one
// row, which says what its fields mean.
//
// Numbers of kinds are part of saved states, so they do not depend on the order in which the linker registers
// kinds. A kind with fixed numbers keeps them. All others are numbered after the largest fixed number, in the
// order of their names.
#pragma once
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/error.h"
#include "game/components/match.h"

namespace thaum::game::inline data {

/// Contents of the column `with` in a table of a match's events: a further thing that the event is about.
enum class EventWith : std::uint8_t {
    nothing,
    wand_in_hand,
    own_name,  ///< the event's own name
    cause,     ///< Event::detail is the EventKind of a hit
    pad,
    ending,
    power_up,
    round,
    ingredient,
    spell,    ///< Event::detail is the number of a spell
    gesture,  ///< Event::detail is the number of a gesture
    potion,
    fault,  ///< Event::detail is a BrewFault
    mode,   ///< Event::detail is the number of a haptic mode of the orb
    /// Event::detail is a recipe, with an order of its ingredients that was drawn by lot, encoded as for
    /// EventKind::recipe_told
    recipe,
    tool  ///< Event::detail is the number of a carving tool
};

/// Meaning of the fields of one kind of event.
struct EventKindInfo {
    std::string_view name{};   ///< name in tables, scenarios and data files; empty: no event has this number
    std::string_view cause{};  ///< cause of harm, such as "bolt"; empty: the event takes no health
    EventWith with{};
    std::string_view unit{};  ///< unit of `amount`; empty: the event has no amount
    bool placed{};            ///< true: the event has a position
    bool has_subject{};       ///< true: the event happens to `subject`, a player shown in the column `whom`
    /// Index of the cause of harm in causes(); max_causes: the event does no harm
    std::size_t cause_number{max_causes};
};

/// Numbers that older saved states already contain.
struct FixedNumbers {
    std::uint32_t kind{};   ///< number of the kind (EventKind)
    std::uint32_t cause{};  ///< number of the cause, an index in causes()
};

/// A kind of hit that a wand defines. Its events take health.
struct HitKind {
    std::string_view name;  ///< name of the event, such as "bolt_hit"
    /// Name of the cause of harm for people, such as "bolt"; several hits may share one.
    std::string_view cause;
    /// Numbers used in older saved states; std::nullopt for a newer wand.
    std::optional<FixedNumbers> fixed{};
};

/// Registration of a kind of event by the source that records it, so that no other source names the kind. A
/// row in assets/events.toml says how it is shown.
class EventRegistration {
public:
    /// Registers the kind when the program starts. The program chooses its numbers, so `info.cause_number` is
    /// ignored.
    explicit EventRegistration(const EventKindInfo& info);
    EventKind kind() const;

private:
    std::string_view name_;
};

/// All kinds of event and causes of harm, with their numbers.
struct EventKinds {
    std::vector<EventKindInfo> kinds;  ///< all kinds of event, indexed by EventKind
    /// Names of the causes of harm, indexed by number; an unused number has an empty name.
    std::vector<std::string_view> causes;
    std::vector<HitKind> hits;  ///< hits of all wands, those with fixed numbers first, then by name
    std::string fault;          ///< why the hits cannot be numbered; empty if they can
};

/// Numbers the kinds of EventKind together with these hits and other kinds.
EventKinds number_event_kinds(std::span<const HitKind> hits, std::span<const EventKindInfo> others = {});

/// The kinds of this program: those of EventKind, all registered ones, and the hits of all registered wands.
const EventKinds& event_kinds();

/// Data on a kind of event; for a number without a kind, the data on EventKind::none.
const EventKindInfo& info_of(EventKind kind);
/// Name of a kind; empty for a number without a kind.
std::string_view name_of(EventKind kind);
/// The kind with this name; std::nullopt if there is none.
std::optional<EventKind> event_kind(std::string_view name);
/// The kind of a hit that a wand has registered under this name.
EventKind hit_kind(std::string_view name);

/// Names of the causes of harm, by number.
std::span<const std::string_view> causes();
/// Number of the cause of harm of a kind of event; max_causes if the kind takes no health.
std::size_t cause_of(EventKind kind);

}  // namespace thaum::game::inline data

#include "game/data/event_kinds.h"

#include <algorithm>

#include "core/assert.h"
#include "core/registry.h"
#include "core/text.h"
#include "game/data/wand.h"

namespace thaum::game::inline data {
namespace {

/// One kind of event that the rules define.
struct RuleKind {
    EventKind kind;
    EventKindInfo info;
};

constexpr EventKindInfo hit_info(std::string_view name, std::string_view cause, std::size_t number) {
    return {name, cause, EventWith::own_name, "hp", true, true, number};
}

const RuleKind rule_kinds[] = {
    {EventKind::none, {.name = "none"}},
    {EventKind::shot, {.name = "shot", .with = EventWith::wand_in_hand, .placed = true}},
    {EventKind::object_hit, hit_info("object_hit", "blow", 3)},
    {EventKind::fall, hit_info("fall", "fall", 4)},
    {EventKind::death, {.name = "death", .with = EventWith::cause, .placed = true, .has_subject = true}},
    {EventKind::spawn, {.name = "spawn", .with = EventWith::pad, .placed = true, .has_subject = true}},
    {EventKind::dry, {.name = "dry", .with = EventWith::wand_in_hand}},
    {EventKind::round_end, {.name = "round_end", .with = EventWith::ending, .has_subject = true}},
    {EventKind::power_up,
     {.name = "power_up",
      .with = EventWith::power_up,
      .unit = "points",
      .placed = true,
      .has_subject = true}},
    {EventKind::round_begin, {.name = "round_begin", .with = EventWith::round}},
    {EventKind::burst, {.name = "burst", .with = EventWith::cause, .unit = "m", .placed = true}},
    {EventKind::ingredient,
     {.name = "ingredient", .with = EventWith::ingredient, .placed = true, .has_subject = true}},
    {EventKind::dropped, {.name = "dropped", .with = EventWith::ingredient, .unit = "m3", .placed = true}},
    {EventKind::wrested, {.name = "wrested", .unit = "J", .placed = true}},
    {EventKind::boiled_over, {.name = "boiled_over", .placed = true}},
    {EventKind::spoilt, hit_info("spoilt", "brew", 5)},
    {EventKind::boon, {.name = "boon", .unit = "hp", .placed = true, .has_subject = true}},
    {EventKind::cast, {.name = "cast", .with = EventWith::spell, .unit = "x", .placed = true}},
    {EventKind::unread,
     {.name = "unread", .with = EventWith::gesture, .unit = "probability", .placed = true}},
    {EventKind::unfocused, {.name = "unfocused", .with = EventWith::spell, .unit = "focus", .placed = true}},
    {EventKind::fizzled, {.name = "fizzled", .with = EventWith::spell, .placed = true}},
    {EventKind::held_off,
     {.name = "held_off", .with = EventWith::cause, .unit = "hp", .placed = true, .has_subject = true}},
    {EventKind::pushed, {.name = "pushed", .unit = "m/s", .placed = true, .has_subject = true}},
    {EventKind::potion,
     {.name = "potion", .with = EventWith::potion, .unit = "s", .placed = true, .has_subject = true}},
    {EventKind::potion_over,
     {.name = "potion_over", .with = EventWith::potion, .placed = true, .has_subject = true}},
    {EventKind::brew_step, {.name = "brew_step", .placed = true}},
    {EventKind::brew_fault, {.name = "brew_fault", .with = EventWith::fault, .placed = true}},
    {EventKind::poison, hit_info("poison", "venom", 6)},
    {EventKind::recipe_told, {.name = "recipe_told", .with = EventWith::recipe, .has_subject = true}},
    {EventKind::work_half, {.name = "work_half", .placed = true, .has_subject = true}},
    {EventKind::work_lost, {.name = "work_lost", .placed = true, .has_subject = true}},
    {EventKind::put_away,
     {.name = "put_away", .with = EventWith::ingredient, .placed = true, .has_subject = true}},
    {EventKind::hands_full,
     {.name = "hands_full", .with = EventWith::ingredient, .placed = true, .has_subject = true}},
    {EventKind::caught, {.name = "caught", .unit = "kg", .placed = true, .has_subject = true}},
    {EventKind::chipped, {.name = "chipped", .unit = "voxels", .placed = true, .has_subject = true}},
    {EventKind::lens, {.name = "lens", .placed = true, .has_subject = true}},
    {EventKind::lens_lost, {.name = "lens_lost", .placed = true, .has_subject = true}},
    {EventKind::work_begun, {.name = "work_begun", .unit = "s", .placed = true, .has_subject = true}},
    {EventKind::work_broken, {.name = "work_broken", .placed = true, .has_subject = true}},
    {EventKind::work_done, {.name = "work_done", .placed = true, .has_subject = true}},
    {EventKind::blunt, {.name = "blunt", .placed = true, .has_subject = true}},
    {EventKind::tool_taken,
     {.name = "tool_taken", .with = EventWith::tool, .placed = true, .has_subject = true}},
    {EventKind::core_near, {.name = "core_near", .placed = true, .has_subject = true}},
    {EventKind::core_lost, {.name = "core_lost", .placed = true, .has_subject = true}},
    {EventKind::scried, {.name = "scried", .unit = "hp", .placed = true, .has_subject = true}},
    {EventKind::unscried, {.name = "unscried", .placed = true, .has_subject = true}},
    {EventKind::mode_worn,
     {.name = "mode_worn", .with = EventWith::mode, .unit = "worn", .placed = true, .has_subject = true}},
};

constexpr std::uint32_t max_kinds = 256;

/// Stores what is known of a kind of event under its number, or a fault if that number or its name is in use.
void set_row(EventKinds& all, std::uint32_t number, const EventKindInfo& info) {
    const auto same = [&](const EventKindInfo& other) { return other.name == info.name; };
    if (info.name.empty() || number >= max_kinds) {
        all.fault = text("event '", info.name, "': it needs a name and a number below ", max_kinds);
    } else if (std::any_of(all.kinds.begin(), all.kinds.end(), same)) {
        all.fault = text("event '", info.name, "' is registered twice: give one of them another name");
    } else {
        if (number >= all.kinds.size()) all.kinds.resize(number + 1, EventKindInfo{});
        auto& row = all.kinds[number];
        if (!row.name.empty())
            all.fault = text("events '", row.name, "' and '", info.name, "' both have the number ", number);
        row = info;
    }
}

/// Returns the number of the cause of harm (such as "bolt") of a kind of event. That is the fixed number, or
/// else the number that this cause already has, or else the next free one.
std::size_t cause_number(EventKinds& all, const EventKindInfo& kind,
                         const std::optional<FixedNumbers>& fixed) {
    const auto known = std::find(all.causes.begin(), all.causes.end(), kind.cause);
    const auto number = fixed                       ? fixed->cause
                        : known != all.causes.end() ? static_cast<std::size_t>(known - all.causes.begin())
                                                    : all.causes.size();
    if (kind.cause.empty() || number >= max_causes) {
        all.fault = text("event '", kind.name, "': its cause needs a name, and there are at most ",
                         max_causes, " causes");
        return max_causes;
    }
    if (number >= all.causes.size()) all.causes.resize(number + 1);
    if (!all.causes[number].empty() && all.causes[number] != kind.cause)
        all.fault =
            text("causes '", all.causes[number], "' and '", kind.cause, "' both have the number ", number);
    all.causes[number] = kind.cause;
    return number;
}

/// A kind of event that has no fixed number yet. `is_hit`: true if it must have a cause of harm, as every hit
/// must.
struct FreeKind {
    EventKindInfo info;
    bool is_hit{};
};

/// Gives these kinds the numbers after the largest one in use, in the order of their names.
void number_by_name(EventKinds& all, std::vector<FreeKind> kinds) {
    std::ranges::sort(kinds, {}, [](const FreeKind& kind) { return kind.info.name; });
    for (auto& [info, is_hit] : kinds) {
        info.cause_number = is_hit || !info.cause.empty() ? cause_number(all, info, {}) : max_causes;
        set_row(all, static_cast<std::uint32_t>(all.kinds.size()), info);
    }
}

EventKinds kinds_of_this_program() {
    std::vector<HitKind> hits;
    for (const auto& wand : wand_kinds()) hits.insert(hits.end(), wand.hits.begin(), wand.hits.end());
    return number_event_kinds(hits, registry_of<EventKindInfo>().all());
}

}  // namespace

EventRegistration::EventRegistration(const EventKindInfo& info) : name_(info.name) {
    registry_of<EventKindInfo>().add(info);
}

EventKind EventRegistration::kind() const { return event_kind(name_).value(); }

EventKinds number_event_kinds(std::span<const HitKind> hits, std::span<const EventKindInfo> others) {
    EventKinds all;
    for (const auto& [kind, info] : rule_kinds) {
        set_row(all, static_cast<std::uint32_t>(kind), info);
        if (info.cause.empty()) continue;
        if (info.cause_number >= all.causes.size()) all.causes.resize(info.cause_number + 1);
        all.causes[info.cause_number] = info.cause;
    }
    auto& sorted = all.hits;
    sorted.assign(hits.begin(), hits.end());
    std::sort(sorted.begin(), sorted.end(), [](const HitKind& a, const HitKind& b) {
        if (a.fixed.has_value() != b.fixed.has_value()) return a.fixed.has_value();
        return a.name < b.name;
    });
    std::vector<FreeKind> unnumbered;
    for (const auto& hit : sorted) {
        auto info = hit_info(hit.name, hit.cause, max_causes);
        if (hit.fixed) {
            info.cause_number = cause_number(all, info, hit.fixed);
            set_row(all, hit.fixed->kind, info);
        } else {
            unnumbered.push_back({info, true});
        }
    }
    for (const auto& info : others) unnumbered.push_back({info, false});
    number_by_name(all, std::move(unnumbered));
    return all;
}

const EventKinds& event_kinds() {
    // Wands and events register before `main`, so the first call finds all of them.
    static const EventKinds all = kinds_of_this_program();
    return all;
}

const EventKindInfo& info_of(EventKind kind) {
    const auto& kinds = event_kinds().kinds;
    const auto number = static_cast<std::size_t>(kind);
    return kinds[number < kinds.size() ? number : 0];
}

std::string_view name_of(EventKind kind) {
    const auto& kinds = event_kinds().kinds;
    const auto number = static_cast<std::size_t>(kind);
    return number < kinds.size() ? kinds[number].name : std::string_view();
}

std::optional<EventKind> event_kind(std::string_view name) {
    const auto& kinds = event_kinds().kinds;
    for (std::size_t i = 0; i < kinds.size() && !name.empty(); ++i) {
        if (kinds[i].name == name) return static_cast<EventKind>(i);
    }
    return {};
}

EventKind hit_kind(std::string_view name) {
    const auto kind = event_kind(name);
    THAUM_ASSERT(kind, text("hit '", name, "' must be among WandKind::hits of its wand"));
    return *kind;
}

std::span<const std::string_view> causes() { return event_kinds().causes; }

std::size_t cause_of(EventKind kind) { return info_of(kind).cause_number; }

}  // namespace thaum::game::inline data

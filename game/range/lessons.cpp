// Reads the lessons of the Apprentice (game/range/apprentice.h).
#include <algorithm>
#include <iterator>
#include <sstream>

#include "core/file.h"
#include "core/near_name.h"
#include "core/text.h"
#include "core/utf8.h"
#include "game/bots/standing_room.h"
#include "game/data/control_words.h"
#include "game/data/shown_words.h"
#include "game/range/apprentice.h"

namespace thaum::game::inline range {
namespace {

constexpr auto lessons_file = "apprentice.toml";
constexpr double farthest = 500;  ///< largest coordinate that the file may contain (m)
constexpr double longest = 600;   ///< longest time that the file may contain (s)

/// A condition of a lesson whose value in the file is one number.
struct NumberCondition {
    std::string_view key;
    ConditionKind kind;
    double least, most, unit;
};
constexpr NumberCondition number_conditions[] = {
    {"moved_m", ConditionKind::moved, 0.1, farthest, 1},
    {"turned_deg", ConditionKind::turned, 1, 36000, radians_per_degree},
    {"readiness", ConditionKind::readiness, 0.01, 1, 1},
    {"lifted_s", ConditionKind::lifted, 0.01, longest, 1},
    {"guarded_s", ConditionKind::guarded, 0.01, longest, 1},
    {"hung_s", ConditionKind::hung, 0.01, longest, 1},
    {"carried_s", ConditionKind::carried, 0.01, longest, 1},
    {"stirred_m", ConditionKind::stirred, 0.01, farthest, 1},
};

/// A key of the file that is only allowed beside the key of a certain condition, and that key.
struct Companion {
    std::string_view key, of;
};
constexpr Companion companions[] = {{"count", "event"}, {"within_m", "near"}, {"wand", "readiness"}};

std::vector<std::string_view> wand_names() {
    std::vector<std::string_view> names;
    for (const auto& wand : wand_kinds()) names.push_back(wand.name);
    std::sort(names.begin(), names.end());  // sorted, because the linker decides the order of wands
    return names;
}

bool is_condition(std::string_view key) {
    return key == "event" || key == "near" ||
           std::any_of(std::begin(number_conditions), std::end(number_conditions),
                       [&](const auto& c) { return c.key == key; });
}

/// Reports keys of the file that are no condition, and keys without the condition that they belong to.
void check_keys(const ConfigTable& table) {
    std::string all;
    for (const auto& condition : number_conditions) all += text(condition.key, ", ");
    for (const auto& key : table.keys()) {
        if (is_condition(key) || key == "soon_s") continue;
        const auto* companion = std::find_if(std::begin(companions), std::end(companions),
                                             [&](const auto& c) { return c.key == key; });
        if (companion == std::end(companions))
            table.report(key,
                         text("unknown goal '", key, "': must be one of ", all, "event, near",
                              did_you_mean(key, number_conditions, [](const auto& c) { return c.key; })));
        else if (!table.has(companion->of))
            table.report(key, text("'", key, "' needs '", companion->of, "' beside it"));
    }
}

/// Named places of the file, and the arena in which they must lie.
struct Places {
    ConfigTable table;
    /// places of the arena where a wizard can stand; std::nullopt: places are not checked
    std::optional<StandingRoom> room{};
};

std::optional<LessonPlace> read_place(const Places& places, const ConfigTable& table, std::string_view key) {
    if (!table.has(key)) return {};
    const auto name = table.string(key);
    if (!places.table.has(name)) {
        table.report(key, text("'", key, "': no place '", name, "' in the table [place]",
                               did_you_mean(name, places.table.keys())));
        return {};
    }
    const auto place = places.table.table(name);
    const vec3 feet = place.vector("position", {-farthest, farthest});
    if (const auto fault = places.room ? places.room->fault_at(feet) : std::string_view(); !fault.empty())
        place.report("position", text("the place '", name, "' ", fault,
                                      ": choose a free place on the ground of the arena"));
    return LessonPlace{.feet = feet,
                       .yaw = place.number("yaw_deg", {-180, 180}, 0) * radians_per_degree,
                       .pitch = place.number("pitch_deg", {-80, 80}, 0) * radians_per_degree};
}

Condition read_event(const ConfigTable& table) {
    const auto name = table.string("event");
    const auto kind = event_kind(name);
    if (!kind || *kind == EventKind::none)
        table.report("event", text("unknown event '", name, "'",
                                   did_you_mean(name, event_kinds().kinds, &EventKindInfo::name)));
    return {.kind = ConditionKind::event,
            .amount = static_cast<double>(table.integer("count", {1, 1000}, 1)),
            .event = kind.value_or(EventKind::none)};
}

Deed read_deed(const Places& places, const ConfigTable& table) {
    Deed deed;
    check_keys(table);
    for (const auto& number : number_conditions) {
        if (!table.has(number.key)) continue;
        deed.conditions.push_back(
            {.kind = number.kind,
             .amount = table.number(number.key, {number.least, number.most}) * number.unit});
        if (number.kind != ConditionKind::readiness) continue;
        const auto wands = wand_names();
        deed.conditions.back().wand = wands[table.choice("wand", wands)];
    }
    if (table.has("event")) deed.conditions.push_back(read_event(table));
    if (table.has("near")) {
        const auto place = read_place(places, table, "near").value_or(LessonPlace{});
        deed.conditions.push_back({.kind = ConditionKind::near,
                                   .amount = table.number("within_m", {0.1, farthest}),
                                   .place = place.feet});
    }
    if (table.has("soon_s")) deed.soon = ticks(table.number("soon_s", {0.1, longest}));
    if (deed.conditions.empty()) table.report("", "a deed needs a condition, such as moved_m = 5");
    return deed;
}

/// Reports texts that no one can read: empty ones, or with characters that cannot be shown.
void check_words(const ConfigTable& table, std::string_view key, const std::string& words) {
    if (words.find_first_not_of(' ') == std::string::npos)
        table.report(key, text("'", key, "' is empty: write some words"));
    if (const auto shown = check_shown(words); !shown)
        table.report(key, text("'", key, "': ", shown.error().message));
}

std::string read_name(const ConfigTable& table) {
    auto name = table.string("name");
    check_words(table, "name", name);
    if (const auto length = decode_utf8(name).size(); length > longest_lesson_name)
        table.report("name", text("'name' has ", length, " characters: at most ", longest_lesson_name));
    return name;
}

std::string read_text(const ConfigTable& table, std::string_view key) {
    auto words = read_control_words(table, key, wand_names());
    check_words(table, key, words);
    std::istringstream in(words);
    const std::vector<std::string> all(std::istream_iterator<std::string>(in), {});
    if (all.size() > max_lesson_words)
        table.report(key, text("'", key, "' has ", all.size(), " words: at most ", max_lesson_words));
    for (const auto& word : all) {
        if (const auto length = decode_utf8(word).size(); length > longest_lesson_word)
            table.report(key, text("'", key, "' has a word of ", length, " characters: at most ",
                                   longest_lesson_word));
    }
    return words;
}

LessonStep read_step(const Places& places, const ConfigTable& table) {
    LessonStep step;
    step.name = read_name(table);
    step.words = read_text(table, "text");
    step.hint = read_text(table, "hint");
    step.player = read_place(places, table, "player");
    step.dummy = read_place(places, table, "dummy");
    step.dummy_kind =
        static_cast<DummyKind>(table.choice("dummy_does", {dummy_names.begin(), dummy_names.end()}, 0));
    step.dummy_waits = ticks(table.number("dummy_waits_s", {0, longest}, 0));
    for (const auto& deed : table.tables("goal")) step.deeds.push_back(read_deed(places, deed));
    if (step.deeds.size() > max_deeds)
        table.report("goal", text("'goal' has ", step.deeds.size(), " deeds: at most ", max_deeds));
    if (step.deeds.empty()) table.report("goal", "a step needs a goal: a list with at least one deed");
    return step;
}

/// Reads the places of the file, with the arena if its data can be read.
Places places_of(const ConfigTable& root, const std::string& arena, const std::filesystem::path& assets) {
    Places places{.table = root.table("place")};
    if (assets.empty()) return places;
    auto room = StandingRoom::load(assets, arena);
    if (room)
        places.room = std::move(*room);
    else
        root.report("arena", text("'arena': ", room.error().message));
    return places;
}

void read_steps(const ConfigTable& root, const Places& places, std::vector<LessonStep>& steps) {
    const auto tables = root.tables("step");
    if (tables.empty()) root.report("", "the course needs at least one [[step]]");
    if (tables.size() > max_lessons)
        root.report("step", text("the course has ", tables.size(), " steps: at most ", max_lessons));
    for (const auto& table : tables) {
        auto step = read_step(places, table);
        const auto same = [&](const LessonStep& other) { return other.name == step.name; };
        if (std::any_of(steps.begin(), steps.end(), same))
            table.report("name", text("a second step has the name '", step.name, "': give it another one"));
        steps.push_back(std::move(step));
    }
}

}  // namespace

Expected<Lessons> parse_lessons(std::string_view toml, std::string name,
                                const std::filesystem::path& assets) {
    const auto file = Config::parse(toml, std::move(name), 1);
    if (!file) return file.error();
    const auto root = file->root();
    Lessons lessons{.arena = root.string("arena"),
                    .end = read_text(root, "end"),
                    .healing = root.number("heals_hp_per_s", {0, 1000}, 0),
                    .steps = {}};
    read_steps(root, places_of(root, lessons.arena, assets), lessons.steps);
    if (const auto checked = file->check(); !checked) return checked.error();
    return lessons;
}

Expected<Lessons> load_lessons(const std::filesystem::path& assets) {
    const auto source = read_text_file(assets / lessons_file, 1U << 16U);
    if (!source) return source.error();
    return parse_lessons(*source, shown_path(assets, lessons_file), assets);
}

}  // namespace thaum::game::inline range

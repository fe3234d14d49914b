// game/range/apprentice.h: the Apprentice, a course of lessons on the range. Its steps are data
// (assets/apprentice.toml); a new step is a new table there.
//
// The goal of a step is a list of deeds, done in their order. A deed has one or more conditions. A condition that is
// met stays met, and the deed is done when all are. Conditions are read from the World and from the EventJournal once
// a gameplay tick, and nothing here changes a match.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "game/range/dummy.h"

namespace thaum::game {

inline constexpr std::uint32_t practising = 0, dummys = 1;  ///< numbers of the range's two players

/// Quantities and deeds of the practising player that a condition can measure.
enum class ConditionKind : std::uint8_t {
    moved,      ///< way along the ground (m)
    turned,     ///< turns of the view (rad)
    event,      ///< number of events of a kind by the player
    near,       ///< distance from a place along the ground (m); met within it
    readiness,  ///< charge or draw of a wand, 0 to 1
    lifted,     ///< time for which a wand has held a thing (s)
    guarded,    ///< time for which a held thing has stood between the dummy and the player (s)
    hung,       ///< time on a rope (s)
    carried,    ///< time with an ingredient in the hand (s)
    stirred,    ///< way of the ladle through the brew, without the drift of a ladle at rest (m)
};

struct Condition {
    ConditionKind kind{};
    double amount{};     ///< amount with which the condition is met, in the unit of its kind
    EventKind event{};   ///< kind of the events
    vec3 place{};        ///< middle of the place on the ground (m, world)
    std::string wand{};  ///< name of the wand
};

struct Deed {
    std::vector<Condition> conditions;
    /// Time since the deed before, after which the step begins again; std::nullopt: none.
    std::optional<Tick> soon{};
};

/// A place to stand.
struct LessonPlace {
    vec3 feet{};            ///< position on the ground (m, world)
    double yaw{}, pitch{};  ///< direction of view (rad)
};

/// One step of the course. Its words may name controls (game/data/control_words.h).
struct LessonStep {
    std::string name, words, hint;
    std::vector<Deed> deeds;
    /// Places at the step's begin; std::nullopt: a wizard stays where it is.
    std::optional<LessonPlace> player{}, dummy{};
    DummyKind dummy_kind{};
    /// Time for which the dummy stands still, from the begin of the step and from each placing of the player.
    Tick dummy_waits{};
};

struct Lessons {
    std::string arena;  ///< name of the arena, whose places the steps name
    std::string end;    ///< words after the last step
    double healing{};   ///< health that the player regains in a second (HP)
    std::vector<LessonStep> steps;
};

/// Largest numbers of words of a step's text, and of characters of such a word and of a step's name.
inline constexpr std::size_t most_lesson_words = 12, longest_lesson_word = 24, longest_lesson_name = 24;
/// Largest numbers of steps of a course and of deeds of a step.
inline constexpr std::size_t most_lessons = 50, most_deeds = 16;

/// Reads assets/apprentice.toml. The error names file, line and key.
Expected<Lessons> load_lessons(const std::filesystem::path& assets);
/// Parses lessons; messages call the file `name`. Without `assets`, places are not checked against the arena.
Expected<Lessons> parse_lessons(std::string_view toml, std::string name,
                                const std::filesystem::path& assets = {});

/// Progress of one player through the course.
class Apprentice {
public:
    explicit Apprentice(Lessons lessons) : lessons_(std::move(lessons)) {}

    /// Looks at the match. Call it after every tick.
    void follow(const Simulation& match);
    /// Goes on to the next step, and begins the present one again. After the last step neither does anything.
    void skip();
    void repeat();

    const Lessons& lessons() const { return lessons_; }
    /// Index of the present step; the number of steps after the last one.
    std::size_t at() const { return at_; }
    bool is_over() const { return at_ == lessons_.steps.size(); }
    /// Whether the present step is done. The next one begins soon after.
    bool is_done() const { return done_; }
    /// Done share of the present step, 0 to 1.
    double share() const;
    /// Done share of the present step in per cent, rounded down, and at most 99 until the step is done.
    int percent() const;
    /// Behaviour of the dummy at this moment of the course.
    DummyKind dummy_kind() const;
    /// Players whose places must be set now: at the begin of a step, after a return to life, and after a fall.
    /// Forgets them.
    std::array<bool, players> take_placings() { return std::exchange(to_place_, {}); }

private:
    void begin(std::size_t step);
    void measure(const Simulation& match);
    void measure_events(const Simulation& match);
    void advance(Tick now);
    const Deed& deed() const { return lessons_.steps[at_].deeds[deed_]; }

    Lessons lessons_;
    std::size_t at_ = 0, deed_ = 0;  ///< present step, and present deed of its goal
    std::vector<double> reached_{};  ///< largest amount so far of each condition of the present deed
    bool begins_ = true;             ///< true: the step has not seen a tick yet
    bool done_ = false;
    Tick since_ = 0;             ///< when the present deed began, or the step was done (ticks of play)
    Tick placed_ = 0, now_ = 0;  ///< when the player was placed, and the last look (ticks of play)
    std::array<bool, players> to_place_{true, true};
    std::uint64_t seen_events_ = 0;  ///< number of events that were looked at
    vec3 last_place_{};              ///< the player's place at the last look (m, world)
    double last_yaw_{}, last_pitch_{};
};

}  // namespace thaum::game

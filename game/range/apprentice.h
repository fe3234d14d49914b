// game/range/apprentice.h: the Apprentice, a series of lessons on the practice range. Its steps are data
// (assets/apprentice.toml); a new step is a new table there.
//
// The goal of a step is a list of deeds (things that the player must do), one after the other. A deed has one
// or more conditions. A condition that was met once stays met, and the deed is done when all are met.
// Conditions are read from the World and from the EventJournal once a gameplay tick, and nothing here changes
// a match.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "game/range/dummy.h"

namespace thaum::game::inline range {

/// Player numbers of the learner and of the dummy.
inline constexpr std::uint32_t practising = 0, dummys = 1;

/// Quantities and actions of the practising player that a condition can measure.
enum class ConditionKind : std::uint8_t {
    moved,      ///< distance that the player has moved along the ground (m)
    turned,     ///< angle by which the player has turned the view (rad)
    event,      ///< number of events of one kind caused by the player
    near,       ///< distance along the ground within which the player must come to a place (m)
    readiness,  ///< charge or draw of a wand, 0 (none) to 1 (full)
    lifted,     ///< time for which a wand has held a thing (s)
    guarded,    ///< time for which a held thing has stood between the dummy and the player (s)
    hung,       ///< time for which the wizard has hung on a rope (s)
    carried,    ///< time for which the player has carried an ingredient (s)
    stirred,    ///< distance of the ladle through the brew, without the drift of a ladle at rest (m)
};

struct Condition {
    ConditionKind kind{};
    double amount{};     ///< amount at which the condition is met, in the unit of its kind
    EventKind event{};   ///< for the kind `event`: kind of the events that are counted
    vec3 place{};        ///< for the kind `near`: middle of the place on the ground (m, world)
    std::string wand{};  ///< for the kind `readiness`: name of the wand whose charge or draw is measured
};

struct Deed {
    std::vector<Condition> conditions;
    /// Time limit since the deed before (a thing to be done), after which the step starts again (ticks);
    /// std::nullopt: none.
    std::optional<Tick> soon{};
};

/// A place where a wizard is put at the beginning of a step.
struct LessonPlace {
    vec3 feet{};            ///< position on the ground (m, world)
    double yaw{}, pitch{};  ///< direction in which the wizard looks (rad)
};

/// One step of the lessons. In its text, names of controls may stand in braces (game/data/control_words.h).
struct LessonStep {
    std::string name, words, hint;
    std::vector<Deed> deeds;
    /// Places of player and dummy at the beginning of the step; std::nullopt: the wizard is not moved.
    std::optional<LessonPlace> player{}, dummy{};
    DummyKind dummy_kind{};
    /// Time for which the dummy stands still (ticks), from the beginning of the step and from each time that
    /// the player is put in place.
    Tick dummy_waits{};
};

struct Lessons {
    std::string arena;  ///< name of the arena in which the steps' places are
    std::string end;    ///< text that is shown after the last step
    double healing{};   ///< health that the player regains per second (HP/s)
    std::vector<LessonStep> steps;
};

/// Maximum number of words in a step's text, and of characters in such a word and in a step's name.
inline constexpr std::size_t max_lesson_words = 12, longest_lesson_word = 24, longest_lesson_name = 24;
/// Maximum number of steps of all lessons, and of deeds (things to be done) in one step.
inline constexpr std::size_t max_lessons = 50, max_deeds = 16;

/// Reads assets/apprentice.toml. The error names file, line and key.
Expected<Lessons> load_lessons(const std::filesystem::path& assets);
/// Parses lessons. `name`: file name in messages. Without `assets`, places are not checked against the arena.
Expected<Lessons> parse_lessons(std::string_view toml, std::string name,
                                const std::filesystem::path& assets = {});

/// Progress of one player through the lessons.
class Apprentice {
public:
    explicit Apprentice(Lessons lessons) : lessons_(std::move(lessons)) {}

    /// Tests the conditions of the present step against the match. Call this after every tick.
    void follow(const Simulation& match);
    /// skip() advances to the next step; repeat() starts the present step again. After the
    /// last step neither does anything.
    void skip();
    void repeat();

    const Lessons& lessons() const { return lessons_; }
    /// Index of the present step; after the last step, the number of steps.
    std::size_t at() const { return at_; }
    bool is_over() const { return at_ == lessons_.steps.size(); }
    /// Whether the present step is completed. The next one begins soon after.
    bool is_done() const { return done_; }
    /// Completed share of the present step, 0 to 1.
    double share() const;
    /// Completed share of the present step (%), rounded down, and at most 99 until the step is completed.
    int percent() const;
    /// Behaviour that the present step asks of the dummy.
    DummyKind dummy_kind() const;
    /// Returns the players who must be put in place now: at the beginning of a step, after a return to life,
    /// and after a fall. Each request is returned once.
    std::array<bool, players> take_placings() { return std::exchange(to_place_, {}); }

private:
    void begin(std::size_t step);
    void measure(const Simulation& match);
    void measure_events(const Simulation& match);
    void advance(Tick now);
    const Deed& deed() const { return lessons_.steps[at_].deeds[deed_]; }

    Lessons lessons_;
    std::size_t at_ = 0, deed_ = 0;  ///< index of the present step, and in its goal that of the present deed
                                     ///< (thing to be done)
    std::vector<double> reached_{};  ///< for each condition of the present deed (thing to be done), its
                                     ///< largest value so far
    bool begins_ = true;             ///< true until the first tick of the present step
    bool done_ = false;
    Tick since_ = 0;  ///< when the present deed (thing to be done) began or the step was completed (ticks of
                      ///< play)
    /// When the player was last put in place, and when the match was last read (ticks of play)
    Tick placed_ = 0, now_ = 0;
    std::array<bool, players> to_place_{true, true};
    std::uint64_t seen_events_ = 0;  ///< number of the match's events that have been read
    vec3 last_place_{};              ///< the player's position when the match was last read (m, world)
    double last_yaw_{}, last_pitch_{};
};

}  // namespace thaum::game::inline range

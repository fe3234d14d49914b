#include "game/range/practice.h"

#include <chrono>
#include <cmath>
#include <limits>

#include "core/text.h"
#include "core/threads.h"

namespace thaum::game::inline range {
namespace {

constexpr auto look_period = std::chrono::milliseconds(200);
constexpr Tick welcome_shown = ticks(8.0), reading_shown = ticks(4.0);
constexpr Tick until_next_reading = std::numeric_limits<Tick>::max() / 2;

/// The score as text that fits on one line of the screen: "12 of 64 hit, 72 HP, 1 kill".
std::string short_words_of(const RangeScore& score) {
    return text(score.hits, " of ", score.shots, " hit, ", std::llround(score.damage), " HP, ", score.kills,
                score.kills == 1 ? " kill" : " kills");
}

}  // namespace

DataWatcher::DataWatcher(RangeFiles files) : files_(std::move(files)) {
    // If this thread cannot be started, data files are read only once, and practice goes on.
    if (auto started = start_thread([this] { watch(); })) thread_ = std::move(*started);
}

DataWatcher::~DataWatcher() {
    {
        const std::lock_guard lock(mutex_);
        stop_ = true;
    }
    stopped_.notify_one();
}

void DataWatcher::watch() {
    std::unique_lock lock(mutex_);
    while (!stopped_.wait_for(lock, look_period, [this] { return stop_; })) {
        auto reload = files_.look();
        if (!reload) continue;
        reloads_.to_fill() = std::move(*reload);
        reloads_.publish();
    }
}

const Reload* DataWatcher::take() { return reloads_.take() ? &reloads_.newest() : nullptr; }

Practice::Practice(const RangeData& data, const std::vector<input::DeviceSpec>& devices, DummyKind kind,
                   std::uint64_t seed, std::optional<Lessons> lessons,
                   std::vector<input::ProfileData> profile)
    : data_(data),
      range_(make_range(data, devices.front(), kind, seed, {devices.begin() + 1, devices.end()},
                        std::move(profile))) {
    if (lessons) {
        apprentice_.emplace(std::move(*lessons));
        // Lessons test skills: a learner should not have to wait for energy, nor die by the brew.
        set_changes({.endless_energy = true, .harmless_brew = true});
        return;
    }
    say("The range: nothing is recorded, and data files that change are read at once", welcome_shown);
}

void Practice::say(std::string words, Tick how_long) {
    caption_ = {.words = std::move(words), .fault = how_long == until_next_reading};
    caption_until_ = match().match().played + how_long;
}

void Practice::tell_found(std::uint32_t percent) {
    fire_anew_ = true;  // the press that chose the force fires no shot
    say(text("your largest force is now ", percent, " % of what the device can do"), reading_shown);
}

void Practice::set_dummy(DummyKind kind) {
    if (kind == range_.dummy.kind()) return;
    range_.dummy.become(kind);
    scorer_.reset(match());
}

bool Practice::set_changes(const RangeChanges& changes) {
    if (changes == changes_) return false;
    changes_ = changes;
    range_.adopt(changed(data_, changes_));
    return true;
}

void Practice::adopt(const Reload& reload) {
    say(reload.line, reload.data ? reading_shown : until_next_reading);
    if (!reload.data) return;
    data_ = *reload.data;
    range_.adopt(changed(data_, changes_));
    scorer_.reset(match());
}

/// Moves a wizard to its place in the present step of the lessons. If the step has no place for it, only
/// empties its hands and restores full health.
void Practice::place(std::uint32_t player) {
    const auto& step = apprentice_->lessons().steps[apprentice_->at()];
    const auto& place = player == practising ? step.player : step.dummy;
    if (player == practising) fire_anew_ = true;
    if (place)
        place_wizard(match(), player, *place);
    else
        refresh_wizard(match(), player);
}

void Practice::hold_fire_back(input::InputFrame& frame) {
    if (fire_anew_) fire_anew_ = take_fire(match().setup().devices, practising, frame);
}

/// Restores some of the learner's health each gameplay tick.
void Practice::heal() {
    if (match().match().paused != 0 || match().match().played % gameplay_period != 0) return;
    const double gain = apprentice_->lessons().healing * gameplay_dt;
    heal_wizard(match(), practising, gain);
}

void Practice::follow_lessons() {
    if (!apprentice_) return;
    apprentice_->follow(match());
    if (apprentice_->is_over()) return;
    const auto placings = apprentice_->take_placings();
    for (std::uint32_t player = 0; player < players; ++player)
        if (placings[player]) place(player);
    set_dummy(apprentice_->dummy_kind());
    heal();
}

void Practice::follow_gestures() {
    if (apprentice_) return;
    wall_.follow(match());
    match().leave_strokes_unread(practising, wall_.records());
}

void Practice::draw_gesture(std::uint32_t number) {
    const auto& set = match().data().gestures;
    if (set && number < set->gestures().size()) wall_.record(set->gestures()[number].name);
}

void Practice::use_gestures(OwnGestures own) {
    if (own.verdict == Verdict::refused) return wall_.draw_again(std::move(own.words));
    if (own.verdict == Verdict::kept) wall_.record({});
    if (auto used = range_.use_gestures(std::move(own.profile)); !used) own.words = {used.error().message};
    wall_.say(match(), std::move(own.words));
}

std::string Practice::step_words() const {
    const auto& steps = apprentice_->lessons().steps;
    const auto at = apprentice_->at();
    if (apprentice_->is_over()) return text(steps.size(), " of ", steps.size(), ": done");
    return text(at + 1, " of ", steps.size(), ": ", steps[at].name);
}

std::string Practice::last_words() {
    if (!apprentice_) return text("range: ", score());
    return text("apprentice: ", apprentice_->is_over() ? "" : "left at ", step_words());
}

void Practice::show_lesson(PracticePicture& picture) {
    const auto& lessons = apprentice_->lessons();
    picture.score = step_words();
    picture.below = "{pause}: skip or leave";
    if (apprentice_->is_over()) {
        picture.below = "{pause}: leave or begin again";
        picture.lesson = lessons.end;
        return;
    }
    if (apprentice_->is_done()) {
        picture.score += ", done";
        picture.lesson = "Done!";
        return;
    }
    const auto& step = lessons.steps[apprentice_->at()];
    picture.score += text(", ", apprentice_->percent(), " %");
    picture.lesson = step.words;
    picture.hint = step.hint;
}

void Practice::show(Picture& picture) {
    const auto& dummy = picture.wizards[dummys];
    const auto health = dummy.vitals.dead ? std::string("comes back")
                                          : text(std::lround(std::ceil(dummy.vitals.health)), " HP");
    picture.practice.on = true;
    picture.practice.score = short_words_of(scorer_.score(match()));
    picture.practice.below =
        text(dummy_names[static_cast<std::size_t>(range_.dummy.kind())], " dummy: ", health);
    if (apprentice_)
        show_lesson(picture.practice);
    else
        wall_.show(match(), picture.practice.wall);
    if (force_trial_.runs())
        picture.caption = {.words = force_trial_.words()};
    else if (force_sample_.runs())
        picture.caption = {.words = std::string(force_sample_.words())};
    else if (match().match().played < caption_until_)
        picture.caption = caption_;
    else
        picture.caption = {};
}

}  // namespace thaum::game::inline range

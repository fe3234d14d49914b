// A player who knows only what is on the screen goes from the first start through the Apprentice (the guided
// lessons) to a won round against the bot of level 0. The test takes the place of the window, its clock, the
// render thread and the simulation thread: it passes events to the session as the window does, and plays the
// match that the session starts.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <functional>

#include "game/bots/bot_file.h"
#include "game/range/practice.h"
#include "unit/live_session_rig.h"
#include "unit/screen_player.h"

namespace thaum::game {
namespace {

using game::practising;
using screen::look_period;

/// A match of the session, or the practice range.
struct Play {
    std::unique_ptr<game::Simulation> own{};
    std::optional<Practice> practice{};
    game::Bots bots{};

    game::Simulation& match() { return practice ? practice->match() : *own; }
};

class ScreenPlayer : public LiveSessionTest {
protected:
    static constexpr Tick longest = ticks(480.0);

    ScreenPlayer() {
        plan_.start_screen = true;
        plan_.first_start = true;
        session_.emplace(shared_, plan_);
    }

    // Lets one look of the player pass: shows it the screen, and passes its input to the session.
    void look(const game::Simulation* match) {
        session_->publish_screen();
        const screen::Shown shown{shared_.pictures.newest(), screen(), uses_, match, rig::window};
        give(player_.act(screen::look_at(shown)));
        all_ticks_ += look_period;
        now_ += static_cast<std::int64_t>(look_period) * rig::ms;
    }
    void publish(Play& play, int countdown);
    void tick(Play& play);

    // Passes events to the session as the window would report them.
    void give(const screen::Hands& hands);
    void press(const std::string& control, bool down);

    // The parts of the test, in order.
    void pass_start_screen();
    Play begin_match();
    void count_down(Play& play);
    void play_until(Play& play, const std::function<bool()>& ends);
    void do_apprentice();
    void reach_duel();
    /// Prints the number of ticks that the last part took.
    void part(const std::string& name) {
        const auto took = all_ticks_ - std::exchange(told_ticks_, all_ticks_);
        std::printf("%s: %llu ticks\n", name.c_str(), static_cast<unsigned long long>(took));
    }

    screen::Player player_;
    bool hides_lessons_ = false;
    std::set<std::string> held_{};
    game::PromptUses uses_{};
    Tick all_ticks_ = 0, told_ticks_ = 0;
};

// Events for the session, as a window sends them ------------------------------------------------------------

void ScreenPlayer::press(const std::string& control, bool down) {
    constexpr std::array<std::string_view, 3> buttons{"Left mouse", "Right mouse", "Middle mouse"};
    for (std::size_t i = 0; i < buttons.size(); ++i)
        if (control == buttons[i])
            return session_->mouse_button(static_cast<int>(i), down, rig::window, now_);
    std::string name;
    for (const char c : control) name += c == ' ' ? '_' : static_cast<char>(std::tolower(c));
    const auto code = key_code_of(name);
    ASSERT_TRUE(code) << "the screen names a control that is no key: " << control;
    session_->key(*code, down, now_);
}

void ScreenPlayer::give(const screen::Hands& hands) {
    for (const auto& control : held_)
        if (hands.held.count(control) == 0) press(control, false);
    for (const auto& control : hands.held)
        if (held_.count(control) == 0) press(control, true);
    held_ = hands.held;
    if (hands.mouse != fvec2(0))
        session_->mouse_move(static_cast<double>(hands.mouse.x), static_cast<double>(hands.mouse.y), now_);
    if (!hands.click) return;
    session_->cursor(*hands.click, rig::window);
    for (const bool down : {true, false}) session_->mouse_button(0, down, rig::window, now_);
}

// The match, as its thread plays it -------------------------------------------------------------------------

/// Publishes the newest picture as the simulation thread does.
void ScreenPlayer::publish(Play& play, int countdown) {
    const auto before = shared_.pictures.newest();
    auto& picture = shared_.pictures.to_fill();
    game::take_picture(play.match(), picture);
    picture.countdown = countdown;
    picture.practice = {};
    picture.caption = {};
    if (play.practice) play.practice->show(picture);
    if (hides_lessons_) picture.practice.lesson.clear();
    game::count_uses(before, picture, uses_);
    shared_.pictures.publish();
    shared_.pictures.take();
}

Play ScreenPlayer::begin_match() {
    Play play;
    session_->take_seats({});
    if (auto files = session_->next().take_range()) {
        play.practice.emplace(files->data(), std::vector{shared_.seats[practising].spec},
                              game::DummyKind::still, plan_.seed, session_->next().take_lessons());
    } else {
        std::vector<input::DeviceSpec> devices;
        for (const auto& seat : shared_.seats) devices.push_back(seat.spec);
        play.own = std::make_unique<game::Simulation>(session_->next().data(),
                                                      game::MatchSetup{plan_.seed, std::move(devices)});
        const auto skill = game::load_bot_skill(plan_.assets, shared_.seats[1].seat.bot).value();
        play.bots.add(*play.own, 1, 1, skill, plan_.seed);
    }
    shared_.progress.state = PlayState::playing;
    shared_.requests.end = false;
    session_->begin_match({});
    held_.clear();
    return play;
}

/// Plays one tick as the simulation thread does, and handles the session's requests for a pause.
void ScreenPlayer::tick(Play& play) {
    auto& match = play.match();
    input::InputFrame frame;
    play.bots.sample(match, frame);
    if (play.practice) frame.devices[game::dummys] = play.practice->dummy_sample();
    frame.devices[practising] = shared_.seats[practising].hands->take();
    if (play.practice) play.practice->hold_fire_back(frame);
    const auto paused = shared_.progress.state == PlayState::paused;
    for (auto* request : {&requests().pause, &requests().go_on}) {
        if (*request >= game::players) continue;
        if (paused == (request == &requests().pause))
            *request = game::no_player;
        else if (match.now() % 2 == 0)
            frame.devices[practising].press(input::Button::pause);
    }
    match.tick(frame);
    if (play.practice) play.practice->follow_lessons();
    const auto& current = match.match();
    shared_.progress.paused_by = current.paused_by;
    shared_.progress.state = current.phase != game::Phase::playing ? PlayState::over
                             : current.paused != 0                 ? PlayState::paused
                                                                   : PlayState::playing;
}

void ScreenPlayer::play_until(Play& play, const std::function<bool()>& ends) {
    while (!ends() && all_ticks_ < longest) {
        publish(play, 0);
        look(&play.match());
        session_->step_match({}, now_);
        for (Tick t = 0; t < look_period; ++t) tick(play);
    }
}

void ScreenPlayer::count_down(Play& play) {
    const auto end = all_ticks_ + ticks(static_cast<double>(defaults_.countdown_s));
    while (all_ticks_ < end) {
        publish(play, static_cast<int>((end - all_ticks_ + ticks(1.0) - 1) / ticks(1.0)));
        look(&play.match());
        session_->step_match({}, now_);
        shared_.seats[practising].hands->take();  // drops the input of the time before the match
    }
}

void ScreenPlayer::pass_start_screen() {
    session_->open_start_screen(now_);
    shared_.pictures.take();
    do {
        look(nullptr);
    } while (!session_->step_start_screen({}, now_) && all_ticks_ < longest);
}

// From the first start to a won round -----------------------------------------------------------------------

/// Plays the guided lessons until the player leaves them.
void ScreenPlayer::do_apprentice() {
    auto play = begin_match();
    auto& course = *play.practice->apprentice();
    std::size_t step = 0;
    play_until(play, [&] {
        if (course.at() != step) part(course.lessons().steps.at(step++).name);
        return requests().end.load();
    });
    EXPECT_TRUE(course.is_over()) << "stuck at: " << play.practice->step_words();
    EXPECT_TRUE(player_.has_done_lessons());
    part("way out of the Apprentice");
}

/// Plays from the first start until a match against the bot begins.
void ScreenPlayer::reach_duel() {
    pass_start_screen();
    ASSERT_TRUE(session_->next().is_apprentice()) << "the first start leads to the Apprentice";
    part("start screen");
    const auto began = all_ticks_;
    do_apprentice();
    EXPECT_LE(all_ticks_ - began, ticks(180.0)) << "the menu says: 3 min";
    pass_start_screen();
    part("start screen again");
    EXPECT_FALSE(session_->next().is_practice());
    EXPECT_EQ(player_.bot(), "Novice");
}

TEST_F(ScreenPlayer, WinsARoundByWhatIsOnTheScreenFromTheFirstStartOn) {
    reach_duel();
    auto play = begin_match();
    EXPECT_EQ(shared_.seats[game::dummys].seat.bot, "level_0");
    count_down(play);
    play_until(play, [&] { return !player_.result().empty(); });
    part("duel");
    EXPECT_TRUE(player_.result().starts_with(player_.name() + " wins")) << player_.result();
    EXPECT_EQ(play.match().match().winner, practising);
    std::printf("all: %llu ticks\n", static_cast<unsigned long long>(all_ticks_));
    EXPECT_LE(all_ticks_, longest);
}

TEST_F(ScreenPlayer, ReadsOtherControlsAndMenusWithoutAMouse) {
    using input::Action;
    constexpr std::pair<Action, const char*> others[] = {
        {Action::move_forward, "i"}, {Action::move_left, "j"}, {Action::move_back, "k"},
        {Action::move_right, "l"},   {Action::fire, "g"},      {Action::stir, "space"},
        {Action::wand_1, "6"},       {Action::wand_2, "7"},    {Action::wand_3, "8"},
        {Action::wand_4, "9"},       {Action::wand_5, "0"},    {Action::pause, "f2"}};
    for (const auto& [action, name] : others)
        assign(plan_.settings, {0, static_cast<std::size_t>(action)},
               {input::Control::Source::key, rig::key(name), 0});
    session_.emplace(shared_, plan_);
    player_ = screen::Player(screen::MenuHand::keys);
    reach_duel();
    EXPECT_EQ(player_.learnt().walk, (std::vector<std::string>{"I", "J", "K", "L"}));
    EXPECT_EQ(player_.learnt().fire, "G");
    EXPECT_EQ(player_.learnt().wands.at("Swing"), "0");
}

TEST_F(ScreenPlayer, DoesNoStepWhereTheScreenDoesNotSayWhatToDo) {
    pass_start_screen();
    hides_lessons_ = true;
    auto play = begin_match();
    const auto end = all_ticks_ + ticks(20.0);
    play_until(play, [&] { return all_ticks_ >= end; });
    EXPECT_EQ(play.practice->apprentice()->at(), 0U);
    EXPECT_FALSE(play.practice->apprentice()->is_done());
}

}  // namespace
}  // namespace thaum::game

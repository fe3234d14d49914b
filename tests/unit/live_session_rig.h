// unit/live_session_rig.h: the main thread's part of a live session (a played match with its menus), without
// window, threads and clock. The test acts as the simulation thread: it sets the match's state and reads the
// requests to the match.
#pragma once
#include <gtest/gtest.h>

#include "game/live/session.h"
#include "unit/live_rig.h"

namespace thaum::game {

inline std::shared_ptr<const game::MatchData> shipped_data() {
    static const auto data = [] {
        return std::make_shared<const game::MatchData>(
            game::load_match_data(THAUM_SOURCE_DIR "/assets", {}).value());
    }();
    return data;
}

class LiveSessionTest : public testing::Test {
protected:
    LiveSessionTest() {
        plan_.data = shipped_data();
        plan_.assets = THAUM_SOURCE_DIR "/assets";
        plan_.seats = {rig::mouse_seat, rig::first_pad_seat};
        shared_.ready = true;
    }

    /// Begins a match with the players' devices as the command line or the start screen gives them, with one
    /// pad plugged in.
    void begin(const Pads& pads = {rig::pad_with()}) {
        session_.emplace(shared_, plan_);
        session_->take_seats(pads);
        session_->begin_match(pads);
        pads_ = pads;
    }
    /// Begins the practice range for the player with the mouse.
    void begin_range() {
        plan_.practice = game::DummyKind::still;
        plan_.seats = {rig::mouse_seat, live::Seat{.kind = SeatKind::dummy}};
        session_.emplace(shared_, plan_);
        ASSERT_TRUE(session_->next().open_range());
        session_->take_seats({});
        session_->begin_match({});
    }
    void step(std::int64_t after_ms = 4) {
        now_ += after_ms * rig::ms;
        session_->step_match(pads_, now_);
        session_->publish_screen();
    }
    void press(int key) {
        session_->key(key, true, now_);
        session_->key(key, false, now_);
    }
    void press(std::string_view name) { press(rig::key(name)); }
    /// Chooses a row of the menu by its label.
    void choose(std::string_view label) {
        const auto& menu = session_->menu();
        const auto rows = menu.picture().rows.size();
        for (std::size_t i = 0; i <= rows && menu.picture().rows.at(menu.picture().cursor).label != label;
             ++i)
            press("down");
        ASSERT_EQ(menu.picture().rows.at(menu.picture().cursor).label, label);
    }
    /// Chooses a row and presses enter there.
    void enter(std::string_view label) {
        choose(label);
        press("enter");
    }
    void pause(std::uint32_t player) {
        shared_.progress.paused_by = player;
        shared_.progress.state = PlayState::paused;
        step();
    }
    void go_on() {
        shared_.progress.state = PlayState::playing;
        step();
    }
    const Screen& screen() {
        shared_.screen.take();
        return shared_.screen.newest();
    }
    auto& requests() { return shared_.requests; }
    /// Takes the oldest request that waits for the match. Returns whether it is of this kind.
    template <class T>
    bool asked_range() {
        const auto request = requests().take();
        return request && request->as<T>();
    }
    input::DeviceSample sample(std::uint32_t player) { return rig::taken(shared_.seats, player); }

    LivePlan plan_;
    /// Makes the motors of a pad that has a device file; a test may replace it.
    LiveTactile::MakeOutput make_motors_ = [](const input::PadState&) { return nullptr; };
    LiveShared shared_{[this](const input::PadState& pad) { return make_motors_(pad); }};
    std::optional<LiveSession> session_;
    Pads pads_{};
    std::int64_t now_ = 1000 * rig::ms;
    const Settings defaults_{};
};

}  // namespace thaum::game

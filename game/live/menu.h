// game/live/menu.h: the menu of a live session. It turns keys, mouse and pads into menu events, and repeats a
// direction that is held. It holds the present settings and saves their changes. It depends on neither the
// window nor the match: the session passes events and times (ns, monotonic clock), and carries out requests.
#pragma once
#include <utility>

#include "game/live/pause.h"
#include "game/live/seats.h"
#include "game/live/sound.h"

namespace thaum::game::inline live {

class LiveMenu {
public:
    static constexpr std::int64_t repeat_after_ns = 400'000'000, repeat_every_ns = 110'000'000;

    /// `state` has the settings and choices to begin with. `settings_file` receives changed settings; empty:
    /// changes last for this run only.
    LiveMenu(MenuState state, MenuContext context, std::filesystem::path settings_file);

    const MenuState& state() const { return state_; }
    const MenuContext& context() const { return context_; }
    const Settings& settings() const { return state_.settings; }
    MenuPicture picture() const { return picture_of(state_, context_); }
    bool is_open() const { return !state_.pages.empty(); }
    /// Whether the start screen or a page below it is open.
    bool on_start_screen() const { return is_open() && state_.pages.front().page == page_name::start; }
    /// Whether the mixer's page is shown, where players set what they feel.
    bool on_mixer() const { return is_open() && state_.pages.back().page == page_name::mixer; }
    /// Whether the next key or button becomes a binding.
    bool waits_for_control() const { return state_.waiting.has_value(); }
    /// Whether a name is being typed.
    bool takes_text() const { return state_.typing.has_value(); }
    /// Whether all keys go to the menu, because they become a binding or a name.
    bool takes_all_keys() const { return waits_for_control() || takes_text(); }

    void open(std::string_view page);
    void close();

    // The next functions pass on events while a menu is open.
    void key(int key, bool pressed, std::int64_t now_ns);
    /// One character of typed text.
    void character(char32_t character);
    void mouse_button(int button, bool pressed, render::Size window);
    /// Tells the menu where the mouse's cursor is. `position`: from the window's top left (px).
    void cursor(fvec2 position, render::Size window);
    void wheel(double steps);
    /// Tells the menu the state of the pad with number `place`, at present and at the last look (`before`).
    void pad(int place, const input::PadState& before, const input::PadState& current, std::int64_t now_ns);
    /// Whether the pad has a seat on the start screen.
    bool has_seat(int place) const;
    /// Repeats a direction that is held, if the repetition is due.
    void repeat(std::int64_t now_ns);
    /// Ends the repetition of a held direction. Call it when the window has lost the focus: the release will
    /// not be reported.
    void release() { held_ = {}; }

    /// Returns what the menu last asked of the session, such as to start a match, and forgets it. While such
    /// a request waits, further events of devices have no effect.
    MenuRequest take_request() { return std::exchange(request_, MenuRequest::none); }
    /// Returns the effect on the body that a player wants to try on the mixer's page (the page for the
    /// strengths of all that is felt), and forgets it.
    std::optional<BodyTrialWish> take_trial() { return std::exchange(trial_, {}); }
    /// Returns the sound that the menu makes for the last event, and forgets it.
    MenuSound take_sound() { return std::exchange(sound_, MenuSound::none); }
    /// Whether settings have changed since the last call.
    bool take_settings_change() { return std::exchange(settings_changed_, false); }

    /// Whether the page of a joystick's set-up is shown.
    bool sets_up_pad() const { return is_open() && state_.pages.back().page == page_name::pad_setup; }

    // The next functions tell the menu what is new.
    /// Tells the menu the names of joysticks that are not known as pads, the names of pads that were set up
    /// by hand, and a line for each joystick that cannot be used.
    void tell_sticks(std::vector<std::string> unknown, std::vector<std::string> own,
                     std::vector<std::string> faults);
    /// Shows the question for one control in the set-up of a joystick. `needed`: the control cannot be
    /// skipped.
    void ask_for_control(std::string question, bool needed) {
        context_.pad_question = std::move(question);
        context_.pad_needs_control = needed;
    }
    /// Leaves the page of a joystick's set-up.
    void end_pad_setup(std::string note);
    /// Updates the pads' names. A pad that was unplugged gives up its seat.
    void name_pads(const Pads& pads);
    /// State of the loudspeakers, for the page of the sounds.
    void tell_sound(std::string state) { context_.sound = std::move(state); }
    /// State of a player's jacket, for the mixer's page (strengths of all that is felt); empty: none.
    void tell_jacket(std::size_t player, std::string state) {
        context_.jackets.at(player) = std::move(state);
    }
    /// Kinds of effect on the body (purposes) that exist. Each has a fader on the mixer's page of the menu.
    void tell_purposes(std::vector<tactile::Purpose> purposes) { context_.body = std::move(purposes); }
    /// Name and state of the arm at an index of MenuContext::arms.
    void name_arm(std::size_t index, const std::string& name) { context_.arms.at(index) = name; }
    /// Tells the menu whether the match that begins is on the practice range, and whether it is the
    /// Apprentice (the tutorial there). From then on the start screen does not offer the Apprentice as on a
    /// first start.
    void set_practice(bool practice, bool apprentice) {
        context_.practice = practice;
        context_.apprentice = apprentice;
        context_.first_start = false;
    }
    /// Gestures that the player on the practice range can record anew; null: none.
    void set_gestures(const GestureSet* gestures);
    /// Number plus 1 of the gesture that the player on the practice range records anew now; 0: none.
    void set_drawn_gesture(std::uint32_t number) { context_.drawn_gesture = number; }
    /// Words of the start screen on faulty data files; ignored if there are words on a faulty settings file
    /// already.
    void add_start_fault(std::string words) {
        if (context_.start_fault.empty()) context_.start_fault = std::move(words);
    }
    void set_pause(PauseWords words);
    void set_note(std::string note) { state_.note = std::move(note); }
    /// Sets the largest force that a player has found by feel (% of the device's peak), as the row on the
    /// mixer's page (strengths of all that is felt) does.
    void set_own_force(std::size_t player, std::uint32_t percent);
    void choose_arena(std::size_t arena) { state_.arena = arena; }
    // The next functions make changes by keys of the session. The changes last for this run only.
    void toggle_fullscreen() { state_.settings.fullscreen = !state_.settings.fullscreen; }
    void turn_split();

private:
    /// A direction that is held on a key, d-pad or stick, and its next repetition.
    struct Held {
        std::optional<MenuEvent> event{};
        int key = -1, pad = -1;  ///< key code or pad number of the direction; -1: none
        std::int64_t next_ns = 0;
    };

    void step(const MenuEvent& event);
    void save_profile(FeelProfile profile);
    void keep_changes(const Settings& before);
    void give_control(const Device& device, const input::Control& control);
    void name_key(int key, std::int64_t now_ns);
    void point_by_pad(const Device& device, const input::PadState& before, const input::PadState& current,
                      std::int64_t now_ns);
    bool on_start_page() const {
        return !state_.pages.empty() && state_.pages.back().page == page_name::start;
    }
    bool joined_just_now(const Device& device, const input::PadState& before);
    std::optional<MenuPlace> place_of_mouse(render::Size window) const;

    MenuState state_;
    MenuContext context_;
    std::filesystem::path settings_file_;
    Held held_{};
    std::optional<fvec2> mouse_{};  ///< last position of the mouse while a menu was open (px)
    MenuRequest request_{};
    std::array<bool, 4> joining_{};  ///< pads of which a button is still held since the press that joined
    bool settings_changed_ = false;
    std::optional<BodyTrialWish> trial_{};
    /// folder of the players' saved strengths of what is felt; empty: these last for this run only
    std::filesystem::path profiles_folder_{};
    MenuSound sound_{};
};

}  // namespace thaum::game::inline live

#include "game/live/session.h"

#include <algorithm>
#include <cstdio>
#include <utility>

#include "core/tell_user.h"
#include "core/text.h"
#include "game/live/menu_choices.h"
#include "game/match/record.h"
#include "game/settings/control_names.h"
#include "game/settings/own_gestures.h"
#include "game/settings/own_pads.h"
#include "game/settings/recorded_names.h"

namespace thaum::game::inline live {

namespace {

constexpr double pad_poll_s = 0.004, menu_poll_s = 0.016, focus_poll_s = 0.05, idle_poll_s = 0.25;

LiveMenu make_menu(const LivePlan& plan) {
    auto context = find_menu_context(plan);
    MenuState state;
    state.settings = plan.settings;
    state.dummy = static_cast<std::size_t>(plan.practice.value_or(DummyKind::still));
    state.bot = index_of(context.bots, plan.settings.last.bot);
    state.rules = index_of(context.rules, plan.data->choice.match);
    state.mutators = plan.data->choice.mutators;
    state.arena = index_of(context.arenas, plan.data->choice.arena);
    return {std::move(state), std::move(context), plan.settings_file};
}

Insight after(Insight insight) {
    switch (insight) {
        case Insight::none: return Insight::forces;
        case Insight::forces: return Insight::frame_times;
        case Insight::frame_times: break;
    }
    return Insight::none;
}

}  // namespace

LiveSession::LiveSession(LiveShared& shared, const LivePlan& plan)
    : shared_(shared),
      plan_(plan),
      next_(plan.assets, plan.data),
      menu_(make_menu(plan)),
      hands_(shared.seats),
      setup_(own_pads_file(plan.settings_file)) {
    shared.requests.dummy = plan.practice.value_or(DummyKind::still);
    if (plan.replay != nullptr) {
        shared.replay.speed = plan.replay->speed;
        if (plan.replay->start > 0) shared.replay.target = plan.replay->start;
        viewer_.emplace(plan.replay->index, plan.replay->playback.log().ticks(), shared.replay,
                        recorded_names(plan.replay->playback.log().header()));
    }
    shared_.tactile.apply(menu_.settings());
    if (shared_.body) {
        trial_.emplace(*shared_.body, shared_.tactile);
        menu_.tell_purposes(shared_.body->purposes());
    }
    publish_screen();
}

// Events of the window --------------------------------------------------------------------------------------

/// Calls f with the collector of every person's input, then stores the time of the input. In this order, the
/// tick that takes the time also has the input.
template <class F>
void LiveSession::give_hands(std::int64_t now_ns, F&& f) {
    hands_.each(f);
    std::int64_t none = 0;
    shared_.input_came_ns.compare_exchange_strong(none, now_ns);
}

void LiveSession::key(int key, bool pressed, std::int64_t now_ns) {
    if (pressed && session_key(key)) return;
    if (viewer_) return pressed ? replay_key(key) : void();
    if (pressed && !menu_.takes_all_keys()) {
        if (const auto news = hands_.take_half(key, menu_.settings())) return report(*news);
    }
    if (menu_.is_open()) return menu_.key(key, pressed, now_ns);
    if (pressed) match_key(key, now_ns);
    give_hands(now_ns, [&](auto& hands) { hands.key(key, pressed); });
}

void LiveSession::character(char32_t character) {
    if (menu_.is_open()) menu_.character(character);
}

void LiveSession::mouse_button(int button, bool pressed, render::Size window, std::int64_t now_ns) {
    if (viewer_) return viewer_->mouse_button(button, pressed, window, menu_.settings().text_scale);
    if (menu_.is_open()) return menu_.mouse_button(button, pressed, window);
    give_hands(now_ns, [&](auto& hands) { hands.mouse_button(button, pressed); });
}

void LiveSession::mouse_move(double right, double down, std::int64_t now_ns) {
    if (!menu_.is_open()) give_hands(now_ns, [&](auto& hands) { hands.mouse_move(right, down); });
}

void LiveSession::cursor(fvec2 position, render::Size window) {
    if (viewer_) return viewer_->cursor(position, window, menu_.settings().text_scale);
    if (menu_.is_open()) menu_.cursor(position, window);
}

void LiveSession::wheel(double steps, std::int64_t now_ns) {
    if (menu_.is_open()) return menu_.wheel(steps);
    give_hands(now_ns, [&](auto& hands) { hands.wheel(steps); });
}

void LiveSession::focus(bool focused, std::int64_t now_ns) {
    focus_.changed(focused, now_ns);
    menu_.release();
    if (!focused) hands_.release();
}

// Keys of the session ---------------------------------------------------------------------------------------

/// Handles keys that act at any time. Returns whether the key was one of them.
bool LiveSession::session_key(int key) {
    const auto is = [&](SessionKey k) { return is_bound(menu_.settings().of(k), key); };
    if (menu_.takes_all_keys()) return false;
    const bool split = is(SessionKey::split), fullscreen = is(SessionKey::fullscreen),
               mark = is(SessionKey::mark), forces = is(SessionKey::forces);
    if (split) menu_.turn_split();
    if (fullscreen) menu_.toggle_fullscreen();
    if (mark) shared_.requests.ask(PressMark{});
    if (forces) insight_ = after(insight_);
    return split || fullscreen || mark || forces;
}

void LiveSession::replay_key(int key) {
    const auto& settings = menu_.settings();
    const bool leaves =
        is_bound(settings.of(SessionKey::leave), key) || is_bound(settings.of(SessionKey::pause), key);
    if (leaves)
        shared_.stop = true;
    else
        viewer_->key(key);
}

void LiveSession::match_key(int key, std::int64_t now_ns) {
    const auto& settings = menu_.settings();
    const bool pause = is_bound(settings.of(SessionKey::pause), key);
    const auto state = shared_.progress.state.load();
    if (state == PlayState::over) key_after_round(key, now_ns);
    if (state == PlayState::playing && pause && !hands_.pauses(key, settings))
        shared_.requests.pause = first_person(shared_.seats).value_or(0);
}

void LiveSession::key_after_round(int key, std::int64_t now_ns) {
    const auto& settings = menu_.settings();
    if (is_bound(settings.of(SessionKey::again), key)) shared_.requests.rematch = true;
    const bool leaves =
        is_bound(settings.of(SessionKey::leave), key) || is_bound(settings.of(SessionKey::pause), key);
    if (leaves && round_end_.may_leave(now_ns)) leave_match();
}

/// Leaves the match: to the start screen, or out of the program if the session began without one.
void LiveSession::leave_match() { (plan_.start_screen ? shared_.requests.end : shared_.stop) = true; }

// A match ---------------------------------------------------------------------------------------------------

void LiveSession::take_seats(const Pads& pads) {
    menu_.set_practice(next_.is_practice(), next_.is_apprentice());
    menu_.set_gestures(next_.data()->gestures.get());
    if (plan_.replay != nullptr) return;  // a replay has no players at the devices
    const auto seats = plan_.start_screen ? joined_seats(menu_.state(), menu_.context(), next_.is_practice())
                                          : planned_seats(plan_.seats, pads);
    shared_.seats = game::take_seats(menu_.settings(), seats);
    want_faders(menu_.settings(), shared_.seats);
    bind_arms(shared_.arms, shared_.seats, plan_.start_screen);
    load_profile();
}

/// Reads the gestures that the persons among the players have recorded. A fault is printed, and the shipped
/// gesture is used.
void LiveSession::load_profile() {
    profile_.clear();
    std::vector<std::string> faults;
    for (std::uint32_t p = 0; p < players; ++p) {
        if (!shared_.seats[p].hands) continue;
        const auto folder = own_gestures_folder(plan_.settings_file, menu_.settings(), p);
        for (auto& own : load_own_gestures(folder, *next_.data(), p, faults))
            profile_.push_back(std::move(own));
    }
    for (const auto& fault : faults) tell_user(fault);
}

input::LogHeader LiveSession::log_header(std::uint64_t seed) const {
    std::vector<std::string> kinds;
    for (const auto& seat : shared_.seats)
        kinds.push_back(seat.seat.kind == SeatKind::bot ? text("bot ", seat.seat.bot) : "human");
    MatchSetup setup{.seed = seed, .devices = devices_of(shared_.seats, shared_.arms)};
    // load_profile has left out gestures that do not suit the match's data, so this does not fail.
    (void)use_profile(*next_.data(), profile_, setup);
    auto header = game::log_header(*next_.data(), setup, std::move(kinds));
    record_names(names(), header);
    return header;
}

void LiveSession::begin_match(const Pads& pads) {
    menu_.close();
    round_end_ = {};
    paused_by_focus_ = false;
    pads_ = pads;
    report(hands_.begin_match(menu_.settings(), pads));
    share_motors();
}

void LiveSession::step_match(const std::optional<Pads>& pads, std::int64_t now_ns) {
    pause_without_focus(now_ns);
    if (pads) look_at_pads(*pads, now_ns);
    wait_for_lost_pads();
    follow_arms(shared_.arms);
    name_arms();
    follow_match(now_ns);
    if (const auto found = shared_.progress.found_force.exchange(0); found != 0)
        menu_.set_own_force(practising, found);
    take_drawn_gesture();
    menu_.set_drawn_gesture(shared_.progress.drawn_number);
    menu_.repeat(now_ns);
    apply_settings();
    play_trial(now_ns);
    carry_out_request();
}

/// Pauses when the window has lost the focus for long. A session that measures its own timing plays on.
void LiveSession::pause_without_focus(std::int64_t now_ns) {
    const auto person = first_person(shared_.seats);
    if (plan_.probe || !person || !shared_.ready || !focus_.lasts(now_ns)) return;
    focus_.handled();
    paused_by_focus_ = shared_.progress.state == PlayState::playing;
    shared_.requests.pause = *person;
}

/// Pauses while a player has no device. A pad may also be pulled out between
/// two rounds, which cannot be paused.
void LiveSession::wait_for_lost_pads() {
    const auto lost = hands_.first_lost();
    if (lost && shared_.progress.state.load() == PlayState::playing) shared_.requests.pause = *lost;
}

void LiveSession::look_at_pads(const Pads& plugged, std::int64_t now_ns) {
    const auto pads = setup_.without_stick(plugged);
    const auto before = std::exchange(pads_, pads);
    const auto news = hands_.look(pads, menu_.settings(), menu_.is_open());
    report(news);
    share_motors();
    if (round_end_.may_leave(now_ns) && leaves_by_pad(before, pads)) leave_match();
    // All presses since the last look count as simultaneous. Pads without a seat come first, so that a start
    // by another pad does not leave their players out.
    std::array<bool, std::tuple_size_v<Pads>> seated{};
    for (std::size_t i = 0; i < pads.size(); ++i) seated[i] = menu_.has_seat(static_cast<int>(i));
    for (const bool turn : {false, true}) {
        for (std::size_t i = 0; i < pads.size(); ++i) {
            if (seated[i] == turn && !news.used[i] && menu_.is_open())
                menu_.pad(static_cast<int>(i), before[i], pads[i], now_ns);
        }
    }
}

void LiveSession::report(const HandNews& news) {
    if (news.lost) shared_.requests.pause = *news.lost;
    if (news.all_back) shared_.requests.go_on = *news.all_back;
    for (std::uint32_t p = 0; p < players; ++p) shared_.pad_lost[p] = hands_.is_lost(p);
}

/// Gives each player the motors of the pad that the player uses now.
void LiveSession::share_motors() {
    for (std::uint32_t p = 0; p < players; ++p) {
        const auto& seat = shared_.seats[p];
        const auto place = static_cast<std::size_t>(seat.seat.pad);
        const bool uses_pad =
            has_pad(seat) && hands_.device_of(p) == input::DeviceKind::pad && place < pads_.size();
        shared_.tactile.use_pad(p, uses_pad ? &pads_[place] : nullptr);
    }
}

/// Gives players who have joined with a pad its motors, so that they can feel effects on the mixer's page,
/// the menu's page for the strengths of all that is felt.
void LiveSession::share_motors_of_start_screen() {
    for (std::uint32_t p = 0; p < players; ++p) {
        const auto& device = menu_.state().seats[p];
        const bool pad = device && device->kind == input::DeviceKind::pad;
        shared_.tactile.use_pad(p, pad ? &pads_.at(static_cast<std::size_t>(device->pad)) : nullptr);
    }
}

/// Whether a player has just pressed button B on a pad, which leaves the match after the round, like Esc.
bool LiveSession::leaves_by_pad(const Pads& before, const Pads& pads) const {
    constexpr auto b = 1U << static_cast<unsigned>(input::PadButton::b);
    return std::any_of(shared_.seats.begin(), shared_.seats.end(), [&](const TakenSeat& seat) {
        const auto place = static_cast<std::size_t>(seat.seat.pad);
        return has_pad(seat) && place < pads.size() &&
               (pads[place].buttons & ~before[place].buttons & b) != 0;
    });
}

void LiveSession::name_arms() {
    for (std::size_t i = 0; i < shared_.arms.size(); ++i) menu_.name_arm(i, shared_.arms[i]->notice.label);
}

/// Opens the menu while the match is paused, and closes it when the match goes on.
void LiveSession::follow_match(std::int64_t now_ns) {
    const auto state = shared_.progress.state.load();
    round_end_.follow(state, now_ns);
    if (plan_.replay != nullptr) return;
    if (state != PlayState::paused) {
        if (!menu_.is_open()) return;
        menu_.close();
        paused_by_focus_ = false;
        return;
    }
    if (!menu_.is_open()) {
        hands_.release();
        menu_.open(page_name::pause);
    }
    menu_.set_pause(pause_words(pause_facts()));
}

/// Reasons of the pause, for its text.
PauseFacts LiveSession::pause_facts() const {
    PauseFacts facts{
        .paused_by = shared_.progress.paused_by, .focus_lost = paused_by_focus_, .names = names()};
    for (std::uint32_t p = 0; p < players; ++p) {
        if (hands_.is_lost(p)) facts.lost_pad[p] = shared_.seats[p].seat.pad;
        facts.plugged_again[p] = hands_.is_plugged_again(p);
    }
    facts.heir_of_half = hands_.heir_of_half().value_or(no_player);
    if (hands_.half_is_free()) {
        facts.key_for_half = control_names(menu_.settings(), input::DeviceKind::keyboard_half).fire;
    }
    return facts;
}

/// Applies changed settings to the input of the players, and the menu's choices to the practice range.
void LiveSession::apply_settings() {
    shared_.requests.dummy = static_cast<DummyKind>(menu_.state().dummy);
    shared_.requests.range = menu_.state().range;
    const auto sound = menu_.take_sound();
    if (shared_.sound != nullptr) shared_.sound->play(sound);
    if (menu_.is_open())
        menu_.tell_sound(shared_.sound != nullptr ? shared_.sound->status()
                                                  : "no sound: the terminal says which file is wrong");
    for (std::uint32_t p = 0; menu_.on_mixer() && p < players; ++p)
        menu_.tell_jacket(p, shared_.tactile.jacket_state(p));
    if (!menu_.take_settings_change()) return;
    hands_.rebind(menu_.settings());
    want_faders(menu_.settings(), shared_.seats);
    if (shared_.sound != nullptr) shared_.sound->apply(menu_.settings());
    shared_.tactile.apply(menu_.settings());
}

/// Folder of the gestures that the player on the practice range has recorded.
std::filesystem::path LiveSession::folder_of_gestures() const {
    return own_gestures_folder(plan_.settings_file, menu_.settings(), practising);
}

/// Checks and saves a gesture that the player on the practice range has drawn, and lets practice go on with
/// it.
void LiveSession::take_drawn_gesture() {
    const auto drawn = shared_.progress.drawn_gesture.take();
    if (!drawn) return;
    std::vector<std::string> words{text("saved: this is your ", capitalised(drawn->name), " from now on")};
    const auto fits = check_own_gesture(*drawn, *next_.data(), profile_, practising);
    if (!fits) {
        words = {text("not saved, since ", fits.error().message)};
    } else if (const auto saved = save_own_gesture(folder_of_gestures(), *drawn); saved) {
        load_profile();
    } else {
        words = {text("only until you leave: ", saved.error().message)};
        profile_ = with_own_gesture(std::move(profile_), *drawn, practising);
    }
    print_line(text("gesture wall: ", words.front()));
    std::fflush(stdout);
    const auto verdict = fits ? Verdict::kept : Verdict::refused;
    shared_.requests.own_gestures.put({profile_, std::move(words), verdict});
}

/// Forgets the player's own strokes for the gesture that the menu has chosen.
void LiveSession::forget_gesture() {
    const auto& names = menu_.context().gestures;
    if (names.empty()) return;
    const auto& name = names[menu_.state().gesture % names.size()];
    const bool had = forget_own_gesture(folder_of_gestures(), name);
    load_profile();
    shared_.requests.own_gestures.put(
        {profile_,
         {text(had ? "the game's " : "you have no own ", capitalised(name), had ? " counts again" : "")}});
}

/// Plays the effect that somebody wants to feel on the mixer's page, the page for the strengths of all that
/// is felt.
void LiveSession::play_trial(std::int64_t now_ns) {
    if (!trial_) return;
    if (const auto wish = menu_.take_trial()) {
        const auto player = static_cast<std::uint32_t>(wish->player);
        trial_->start(player, wish->purpose, menu_.settings().players[player].body, now_ns);
    }
    trial_->step(now_ns);
}

void LiveSession::carry_out_request() {
    auto& requests = shared_.requests;
    const auto request = menu_.take_request();
    if (setup_.carry_out(request, menu_)) return;
    switch (request) {
        case MenuRequest::restart: return restart();
        case MenuRequest::leave:
        case MenuRequest::quit: return leave_match();
        case MenuRequest::take_half:
            if (const auto news = hands_.take_half(menu_.settings())) report(*news);
            return;
        case MenuRequest::go_on: break;
        case MenuRequest::ask_match: requests.ask(menu_.state().match_request); break;
        case MenuRequest::forget_gesture: forget_gesture(); break;
        case MenuRequest::none:
        case MenuRequest::start:
        case MenuRequest::range:
        case MenuRequest::set_up_pad:
        case MenuRequest::skip_control:
        case MenuRequest::forget_pad:
        case MenuRequest::apprentice: return;  // handled by the start screen, or carried out already
    }
    report(hands_.take_plugged_pads(menu_.settings()));
    // A pad may have been unplugged since the menu asked; the match then stays paused.
    if (!hands_.first_lost()) requests.go_on = first_person(shared_.seats).value_or(0);
}

/// Ends the match, after which another one begins with the same players. The practice range reads its files
/// again; while one of them is faulty, the match goes on.
void LiveSession::restart() {
    const auto& context = menu_.context();
    if (context.apprentice ? !succeeds(next_.open_apprentice())
                           : context.practice && !succeeds(next_.open_range()))
        return;
    restarts_ = true;
    shared_.requests.end = true;
}

bool LiveSession::captures_cursor() const {
    return hands_.any_mouse() && !plan_.probe && shared_.progress.state.load() == PlayState::playing;
}

double LiveSession::patience_s() const {
    if (hands_.any_pad() || plan_.probe) return pad_poll_s;  // pads send no events, so they must be polled
    if (trial_ && trial_->runs()) return seconds(tactile::frame_ticks) / 2;
    if (menu_.is_open()) return menu_poll_s;
    return focus_.pending() ? focus_poll_s : idle_poll_s;
}

// The screen ------------------------------------------------------------------------------------------------

namespace {

/// Views that are shown: the views of all persons, or of the bots if no person plays.
Watch watched(const TakenSeats& seats) {
    const bool first = seats[0].hands != nullptr, second = seats[1].hands != nullptr;
    if (first == second) return Watch::both;
    return first ? Watch::first : Watch::second;
}

}  // namespace

/// Returns the players' names for the screen: those that they gave themselves, a bot's name against a person,
/// and "Dummy" on the practice range. A replay has the names in its log. Empty: the name of the team.
PlayerNames LiveSession::names() const {
    if (viewer_) return viewer_->names();
    const auto& seats = shared_.seats;
    PlayerNames names;
    for (std::size_t p = 0; p < players; ++p) {
        const auto& seat = seats[p].seat;
        const bool against_person = seats[1 - p].hands != nullptr;
        if (seats[p].hands != nullptr)
            names[p] = menu_.settings().players[p].name;
        else if (against_person)
            names[p] = seat.kind == SeatKind::dummy ? std::string("Dummy")
                                                    : label_of(menu_.context().bots, seat.bot);
    }
    return names;
}

Screen LiveSession::screen() const {
    const auto& settings = menu_.settings();
    Screen screen{.hud = {.split = settings.split,
                          .watch = viewer_ ? viewer_->watch() : watched(shared_.seats),
                          .fov = settings.fov,
                          .text_scale = settings.text_scale,
                          .bloom = settings.bloom,
                          .can_play_again = plan_.replay == nullptr,
                          .has_menu = plan_.start_screen,
                          .forces = insight_ == Insight::forces,
                          .menu = menu_.is_open(),
                          .names = names(),
                          .captions = {settings.players[0].captions, settings.players[1].captions},
                          .heard = {settings.players[0].heard, settings.players[1].heard},
                          .figure = {settings.players[0].figure, settings.players[1].figure},
                          .prompts = {settings.players[0].prompts, settings.players[1].prompts},
                          .replay = viewer_ ? std::optional(viewer_->bar()) : std::nullopt},
                  .quality = settings.quality,
                  .menu = menu_.picture(),
                  .arena_scene = menu_.on_start_screen(),
                  .frames_per_second = settings.frames_per_second,
                  .frame_times = insight_ == Insight::frame_times};
    if (menu_.on_mixer()) screen.menu.figure = trial_ ? trial_->figure() : BodyTrial::Figure{};
    auto& messages = screen.hud.device_messages;
    each_held_arm(shared_.arms,
                  [&](const LiveArm& arm, std::size_t) { messages[arm.player] = arm.notice.fault; });
    for (std::uint32_t p = 0; p < players; ++p)
        if (shared_.seats[p].hands) screen.hud.controls[p] = control_names(settings, hands_.device_of(p));
    // A replay names the wands by the keys that select them with keyboard and mouse.
    for (auto& controls : screen.hud.controls)
        if (viewer_) controls.wands = control_names(settings, input::DeviceKind::keyboard_mouse).wands;
    for (std::uint32_t p = 0; p < players; ++p)
        if (hands_.is_lost(p))
            messages[p] = hands_.is_plugged_again(p) ? text("pad is back: ", press_to_rejoin)
                                                     : text("pad lost: ", how_to_rejoin);
    return screen;
}

void LiveSession::publish_screen() {
    auto current = screen();
    if (published_ == current) return;
    shared_.screen.to_fill() = current;
    shared_.screen.publish();
    published_ = std::move(current);
}

// The start screen ------------------------------------------------------------------------------------------

void LiveSession::open_start_screen(std::int64_t now_ns) {
    hands_.leave_seats();
    if (!began_ns_) began_ns_ = now_ns;
    show_arena();
    menu_.open(page_name::start);
}

bool LiveSession::step_start_screen(const Pads& pads, std::int64_t now_ns) {
    look_at_pads(pads, now_ns);
    menu_.name_pads(pads);
    if (auto words = shared_.data_fault.take()) menu_.add_start_fault(std::move(*words));
    follow_arms(shared_.arms);
    name_arms();
    menu_.repeat(now_ns);
    apply_settings();
    share_motors_of_start_screen();
    play_trial(now_ns);
    follow_arena();
    const auto request = menu_.take_request();
    if (setup_.carry_out(request, menu_)) return false;
    if (request == MenuRequest::start && succeeds(load_chosen())) return true;
    if (request == MenuRequest::range && succeeds(next_.open_range())) return true;
    if (request == MenuRequest::apprentice && succeeds(next_.open_apprentice())) return true;
    if (request == MenuRequest::quit || out_of_time(now_ns)) shared_.stop = true;
    return false;
}

/// Shows an error on the screen. Returns whether there was none.
bool LiveSession::succeeds(const Expected<void>& result) {
    if (!result) menu_.set_note(result.error().message);
    return result.has_value();
}

Expected<void> LiveSession::load_chosen() {
    const auto& context = menu_.context();
    const auto& chosen = menu_.state();
    return next_.choose(context.rules[chosen.rules].name, context.arenas[chosen.arena].name, chosen.mutators);
}

/// Loads and shows the arena that the menu has chosen. If its file is faulty, the menu returns to the arena
/// that is shown.
void LiveSession::follow_arena() {
    const auto& arenas = menu_.context().arenas;
    const auto& shown = next_.data()->choice.arena;
    const auto& chosen = arenas[menu_.state().arena];
    // A file with a known fault is not loaded. Its row in the menu shows the fault.
    if (chosen.name == shown || !chosen.fault.empty()) return;
    if (succeeds(load_chosen())) return show_arena();
    menu_.choose_arena(index_of(arenas, shown));
}

/// Publishes the arena and a picture of it as it is before a match.
void LiveSession::show_arena() {
    shared_.scene.to_fill() = next_.data();
    shared_.scene.publish();
    std::vector<input::DeviceSpec> devices(players);
    for (std::uint32_t p = 0; p < players; ++p) devices[p].player = p;
    const Simulation match(next_.data(), {1, std::move(devices)});
    take_picture(match, shared_.pictures.to_fill());
    shared_.pictures.publish();
}

bool LiveSession::out_of_time(std::int64_t now_ns) const {
    return plan_.seconds && now_ns > *began_ns_ + static_cast<std::int64_t>(*plan_.seconds * 1e9);
}

}  // namespace thaum::game::inline live

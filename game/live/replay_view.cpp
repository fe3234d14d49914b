#include "game/live/replay_view.h"

#include <algorithm>
#include <array>

#include "core/text.h"
#include "game/data/teams.h"
#include "game/settings/settings.h"

namespace thaum::game::inline live {
namespace {

constexpr std::array speeds{slowest_replay, 0.5, 1.0, 2.0, 4.0, 8.0, fastest_replay};

struct ReplayKey {
    std::string_view name;
    ReplayDeed deed;
};
constexpr ReplayKey keys[] = {
    {"space", ReplayDeed::pause},
    {"left", ReplayDeed::back},
    {"right", ReplayDeed::forward},
    {"down", ReplayDeed::slower},
    {"up", ReplayDeed::faster},
    {"home", ReplayDeed::begin},
    {"end", ReplayDeed::end},
    {"page_up", ReplayDeed::previous_kill},
    {"page_down", ReplayDeed::next_kill},
    {"comma", ReplayDeed::step_back},
    {"period", ReplayDeed::step},
    {"v", ReplayDeed::eyes},
};

Tick less(Tick at, Tick by) { return at - std::min(at, by); }

double faster(double speed) {
    const auto next = std::upper_bound(speeds.begin(), speeds.end(), speed);
    return next == speeds.end() ? speed : *next;
}

double slower(double speed) {
    const auto next = std::lower_bound(speeds.begin(), speeds.end(), speed);
    return next == speeds.begin() ? speed : *std::prev(next);
}

Tick next_kill(Tick at, std::span<const Kill> kills) {
    for (const auto& kill : kills)
        if (less(kill.at, before_kill) > at) return less(kill.at, before_kill);
    return at;
}

Tick previous_kill(Tick at, std::span<const Kill> kills) {
    Tick found = at;
    for (const auto& kill : kills)
        if (less(kill.at, before_kill) + same_kill < at) found = less(kill.at, before_kill);
    return found;
}

Watch next_watch(Watch watch) {
    switch (watch) {
        case Watch::both: return Watch::first;
        case Watch::first: return Watch::second;
        case Watch::second: break;
    }
    return Watch::both;
}

std::string eyes_of(Watch watch, const PlayerNames& names) {
    if (watch == Watch::both) return "both views";
    return text(name_of(names, watch == Watch::first ? 0 : 1), "'s eyes");
}

void pause_or_go_on(ReplayView& view, Tick length) {
    view.paused = view.at < length && !view.paused;
    if (view.at >= length) view.at = 0;
}

}  // namespace

std::optional<ReplayDeed> replay_deed_of(int key) {
    const auto name = key_name_of(key);
    for (const auto& one : keys)
        if (one.name == name) return one.deed;
    return {};
}

std::string replay_keys() {
    const auto sign = [](std::string_view key) {
        return render::key_sign(render::key_code(key).value_or(-1));
    };
    return text("Space: pause   Left, Right: ", replay_jump / ticks_per_second,
                " s   Up, Down: speed   Home, End   Page Up, Down: kill   ", sign("Comma"), " ",
                sign("Period"), " : step   ", sign("V"), ": eyes   Esc: leave");
}

ReplayView after(ReplayView view, ReplayDeed deed, Tick length, std::span<const Kill> kills) {
    const auto step_to = [&](Tick at) {
        view.at = std::min(at, length);
        view.paused = true;
    };
    switch (deed) {
        case ReplayDeed::pause: pause_or_go_on(view, length); break;
        case ReplayDeed::back: view.at = less(view.at, replay_jump); break;
        case ReplayDeed::forward: view.at = std::min(view.at + replay_jump, length); break;
        case ReplayDeed::slower: view.speed = slower(view.speed); break;
        case ReplayDeed::faster: view.speed = faster(view.speed); break;
        case ReplayDeed::begin: view.at = 0; break;
        case ReplayDeed::end: view.at = length; break;
        case ReplayDeed::previous_kill: view.at = previous_kill(view.at, kills); break;
        case ReplayDeed::next_kill: view.at = next_kill(view.at, kills); break;
        case ReplayDeed::step: step_to(view.at + replay_step); break;
        case ReplayDeed::step_back: step_to(less(view.at, replay_step)); break;
        case ReplayDeed::eyes: view.watch = next_watch(view.watch); break;
    }
    return view;
}

// The viewer ------------------------------------------------------------------------------------------------

ReplayViewer::ReplayViewer(const ReplayIndex& index, Tick length, ReplayRequests& requests, PlayerNames names)
    : index_(index), length_(length), requests_(requests), names_(std::move(names)) {}

void ReplayViewer::key(int key) {
    const auto deed = replay_deed_of(key);
    if (!deed) return;
    const auto target = requests_.target.load();
    const ReplayView before{.at = target == ReplayRequests::nowhere ? requests_.now.load() : target,
                            .speed = requests_.speed,
                            .paused = requests_.paused,
                            .watch = watch_};
    const auto view = after(before, *deed, length_, index_.kills());
    watch_ = view.watch;
    requests_.speed = view.speed;
    requests_.paused = view.paused;
    if (view.at != before.at) requests_.target = view.at;
}

void ReplayViewer::mouse_button(int button, bool pressed, render::Size window, double text_scale) {
    if (button != 0) return;
    drags_ = pressed && cursor_.y >= lay_out_replay_bar(text_scale, window).band.low.y;
    if (drags_) go_to_cursor(window, text_scale);
}

void ReplayViewer::cursor(fvec2 place, render::Size window, double text_scale) {
    cursor_ = place;
    if (drags_) go_to_cursor(window, text_scale);
}

void ReplayViewer::go_to_cursor(render::Size window, double text_scale) {
    requests_.target = tick_at(lay_out_replay_bar(text_scale, window), cursor_.x, length_);
}

ReplayBar ReplayViewer::bar() const {
    const auto target = requests_.target.load();
    return {.length = length_,
            .indexed = index_.complete() ? length_ : index_.reached(),
            .target = target == ReplayRequests::nowhere ? std::nullopt : std::optional(target),
            .speed = requests_.speed,
            .paused = requests_.paused,
            .eyes = eyes_of(watch_, names_),
            .keys = replay_keys(),
            .kills = index_.kills()};
}

}  // namespace thaum::game::inline live

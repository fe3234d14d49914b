#include "unit/screen_player.h"

#include <algorithm>
#include <cmath>
#include <regex>
#include <sstream>

namespace thaum::game::screen {
namespace {

constexpr double words_per_second = 4;  ///< reading speed of the player
/// Motion of the mouse for each pixel of the aim's error, and largest motion between two looks (counts).
constexpr float counts_per_pixel = 0.8F, fastest = 60;

int looks_of(double seconds) { return static_cast<int>(seconds * 1000 / look_period); }

bool has(const std::string& words, std::string_view part) { return words.find(part) != std::string::npos; }

int looks_to_read(const std::string& words) {
    const auto count = 1 + std::count(words.begin(), words.end(), ' ');
    return looks_of(static_cast<double>(count) / words_per_second);
}

/// The part of the words that the pattern's only group matches; empty: no match.
std::string matched(const std::string& words, const char* pattern) {
    std::smatch found;
    return std::regex_search(words, found, std::regex(pattern)) ? found[1].str() : std::string();
}

const Sight* nearest(const Screen& seen, std::string_view what) {
    const Sight* best = nullptr;
    for (const auto& sight : seen.sights)
        if (sight.what == what && (best == nullptr || sight.high > best->high)) best = &sight;
    return best;
}

/// Among those objects of a kind that look about as near as the nearest one, the highest in the window.
const Sight* topmost(const Screen& seen, std::string_view what) {
    constexpr float about = 0.5F;
    const auto* near = nearest(seen, what);
    if (near == nullptr) return nullptr;
    const auto* best = near;
    for (const auto& sight : seen.sights)
        if (sight.what == what && sight.high > about * near->high && sight.place.y < best->place.y)
            best = &sight;
    return best;
}

}  // namespace

// Skills of a person with mouse and keyboard ----------------------------------------------------------------

bool Player::aim(const Screen& seen, fvec2 place, float within, Hands& hands) const {
    const fvec2 off = place - seen.crosshair;
    hands.mouse = glm::clamp(counts_per_pixel * off, fvec2(-fastest), fvec2(fastest));
    return glm::length(off) <= within;
}

void Player::level(const Screen& seen, Hands& hands) const {
    hands.mouse.y =
        std::clamp(counts_per_pixel * (seen.horizon - seen.crosshair.y), -fastest / 2, fastest / 2);
}

/// Holds a control down, if the player has learnt it.
void Player::hold(const std::string& control, Hands& hands) const {
    if (!control.empty()) hands.held.insert(control);
}

void Player::walk(std::size_t way, Hands& hands) const {
    if (way < learnt_.walk.size()) hands.held.insert(learnt_.walk[way]);
}

/// Walks to a place on the ground, and steps aside if something is in the way.
void Player::walk_to(const Screen& seen, fvec2 place, Hands& hands) const {
    aim(seen, {place.x, seen.crosshair.y}, 0, hands);
    level(seen, hands);
    walk(0, hands);
    constexpr std::size_t middle = glance_columns / 2;
    const auto& ahead = seen.glance[glance_rows / 2 + 1];
    constexpr float near = 1.6F;
    if (ahead[middle].far > near || ahead[middle].what == "floor") return;
    walk(ahead[middle - 2].far > ahead[middle + 2].far ? 1 : 3, hands);
}

bool Player::take(const Screen& seen, const std::string& wand, Hands& hands) const {
    if (has(seen.words_of(Part::strip), wand)) return true;
    const auto key = learnt_.wands.find(wand);
    if (key != learnt_.wands.end() && tap(4)) hold(key->second, hands);
    return false;
}

// A look at the screen, and menus ---------------------------------------------------------------------------

Hands Player::act(const Screen& seen) {
    Hands hands;
    ++looks_;
    if (seen.has_words(Part::name)) name_ = seen.words_of(Part::name);
    if (seen.has_words(Part::result)) result_ = seen.words_of(Part::result);
    if (!seen.shows_view)
        use_menu(seen, hands);
    else if (seen.has_words(Part::lesson))
        follow_lesson(seen, hands);
    else if (!seen.has_words(Part::result))
        fight(seen, hands);
    if (!learnt_.mouse) hands.mouse = fvec2(0);
    return hands;
}

/// Reads a menu, chooses a row, and checks the result at the next look.
void Player::use_menu(const Screen& seen, Hands& hands) {
    const auto words = seen.words_of(Part::menu);
    if (words != words_) {
        words_ = words;
        pause_ = looks_of(1.5);
        confirm_ = matched(words, "(?:start|join|confirm): (\\w+)");
    }
    if (--pause_ > 0) return;
    pause_ = looks_of(1);
    const auto* row = wanted_row(seen);
    if (row == nullptr) return;
    if (menu_hand_ == MenuHand::mouse)
        hands.click = row->place + fvec2(2, 0);
    else
        hold(row->chosen ? confirm_ : key_towards(seen, *row), hands);
}

/// The menu row to choose next: into the Apprentice (the guided lessons), out of it, or to a duel against the
/// bot. The words of the start screen name the bot.
const Words* Player::wanted_row(const Screen& seen) {
    const auto row = [&](std::string_view begin) -> const Words* {
        for (const auto& line : seen.words)
            if (line.text.starts_with(begin)) return &line;
        return nullptr;
    };
    if (const auto* leave = row("Leave the Apprentice")) return leave;
    if (!done_lessons_) return row("Apprentice");
    if (auto bot = matched(words_, "or bot: (\\w+)"); !bot.empty()) bot_ = std::move(bot);
    if (const auto* start = row("Start against the bot")) return start;
    return row("Duel");
}

/// The key that moves the choice towards another row. The menu's hint names one key for up and one for down.
std::string Player::key_towards(const Screen& seen, const Words& row) {
    std::smatch keys;
    if (!std::regex_search(words_, keys, std::regex("choose: arrows, (\\w) and (\\w)"))) return {};
    const auto chosen =
        std::find_if(seen.words.begin(), seen.words.end(), [](const Words& line) { return line.chosen; });
    return chosen != seen.words.end() && row.place.y < chosen->place.y ? keys[1].str() : keys[2].str();
}

// What the player does in lessons ---------------------------------------------------------------------------

/// Learns the controls that a text names in brackets.
void Player::read(const std::string& words) {
    if (const auto keys = matched(words, "Walk with \\[([^\\]]+)\\]"); !keys.empty()) {
        learnt_.walk.clear();
        std::istringstream all(keys);
        for (std::string key; all >> key;) learnt_.walk.push_back(key);
    }
    const auto learn = [&](std::string& into, const char* pattern) {
        if (const auto control = matched(words, pattern); !control.empty()) into = control;
    };
    if (matched(words, "look around with \\[([^\\]]+)\\]") == "Mouse") learnt_.mouse = true;
    learn(learnt_.drop, "drop with \\[([^\\]]+)\\]");
    learn(learnt_.stir, "Hold \\[([^\\]]+)\\] at the cauldron");
    if (!has(words, "cauldron") && !has(words, "draw a circle"))
        learn(learnt_.fire, "[Hh]old \\[([^\\]]+)\\]");
    std::smatch found;
    if (std::regex_search(words, found, std::regex("[Tt]ake (\\w+) with \\[([^\\]]+)\\]")))
        learnt_.wands[wand_ = found[1].str()] = found[2].str();
}

void Player::follow_lesson(const Screen& seen, Hands& hands) {
    const auto words = seen.words_of(Part::lesson);
    if (words != words_) {
        words_ = words;
        looks_ = 0;
        above_ = 0;
        hung_ = firing_ = 0;
        let_go_ = false;
        pause_ = looks_to_read(words);
        read(words);
    }
    if (--pause_ > 0) return;
    if (has(words, "Well done")) {
        done_lessons_ = true;
        if (tap(4)) hold(matched(words, "\\[([^\\]]+)\\], then leave"), hands);
        return;
    }
    do_lesson(seen, hands);
}

/// Holds the control that the text names, draws a circle within a second, releases the control, and waits for
/// the message about the stroke.
void Player::draw_circle(Hands& hands) const {
    constexpr int begin = 10, length = 62, all = 160;  // begin, length and period of a circle (looks)
    constexpr float radius = 350;                      // radius of the circle (counts of the mouse)
    const int look = static_cast<int>(looks_) % all;
    if (look >= begin + length + 3) return;
    hold(matched(words_, "Hold \\[([^\\]]+)\\]"), hands);
    if (look < begin || look >= begin + length) return;
    const auto at = [&](int k) {
        const float angle = 2 * static_cast<float>(pi) * static_cast<float>(k - begin) / length;
        return radius * fvec2(std::sin(angle), -std::cos(angle));
    };
    hands.mouse = at(look + 1) - at(look);
}

/// Does what the text of the lesson says.
void Player::do_lesson(const Screen& seen, Hands& hands) {
    const auto says = [&](std::string_view part) { return has(words_, part); };
    if (says("Done!")) return;
    if (says("look around")) return look_about(seen, hands);
    if (says("crate")) return lift(seen, hands);
    if (says("anchor")) return swing(seen, hands);
    if (says("at the cauldron")) return brew(seen, hands);
    if (says("ingredient")) return fetch(seen, hands);
    if (says("draw a circle")) return draw_circle(hands);
    if (says("release")) return ready_and_shoot(seen, hands);
    if (says("dummy")) return shoot(seen, hands);
}

void Player::look_about(const Screen& seen, Hands& hands) {
    walk(tap(looks_of(1.2)) ? 0 : 2, hands);
    level(seen, hands);
    hands.mouse.x = 12;
}

void Player::shoot(const Screen& seen, Hands& hands) {
    if (!take(seen, wand_, hands)) return;
    const auto* foe = nearest(seen, "wizard");
    if (foe == nullptr) return search(seen, hands);
    if (aim(seen, foe->place, 0.4F * foe->high, hands)) hold(learnt_.fire, hands);
}

/// Holds the fire button until the ring that shows the wand's charge is full, aims, and releases. A shot that
/// flies in an arc is aimed by the end of the arc.
void Player::ready_and_shoot(const Screen& seen, Hands& hands) {
    if (!take(seen, wand_, hands)) return;
    const auto* foe = nearest(seen, "wizard");
    if (foe == nullptr) return search(seen, hands);
    const bool draws = has(words_, "draw");
    if (draws && seen.arc_end) {
        const float low = seen.arc_end->y - foe->place.y;
        above_ = std::clamp(above_ + 0.05F * low, -foe->high, 4 * foe->high);
    }
    const float within = 0.25F * foe->high;
    const bool aims = aim(seen, foe->place - fvec2(0, above_), within, hands);
    const bool meets = !draws || (seen.arc_end && glm::distance(*seen.arc_end, foe->place) < within);
    const bool ready = seen.ring >= (draws ? 0.8F : 0.97F);
    firing_ = aims && meets && ready ? -looks_of(0.2) : firing_ + 1;
    if (firing_ > 0) hold(learnt_.fire, hands);
}

/// Lifts a crate and holds it between the player and the dummy.
void Player::lift(const Screen& seen, Hands& hands) {
    if (!take(seen, wand_, hands)) return;
    if (seen.holds) {
        hold(learnt_.fire, hands);
        firing_ = 0;
        if (const auto* foe = nearest(seen, "wizard")) aim(seen, foe->place, 0, hands);
        return;
    }
    const auto* crate = topmost(seen, "crate");
    if (crate == nullptr) return search(seen, hands);
    const bool aims = aim(seen, crate->place, 0.4F * crate->high, hands);
    firing_ = aims && seen.mark == game::TargetKind::take ? firing_ + 1 : 0;
    if (firing_ > 0 && firing_ < looks_of(0.5)) hold(learnt_.fire, hands);
}

/// Hangs by the wand's rope from an anchor (a point in the arena), swings forward, and releases the rope
/// where the ground beyond is near.
void Player::swing(const Screen& seen, Hands& hands) {
    if (!take(seen, wand_, hands)) return;
    if (seen.holds && !let_go_) {
        ++hung_;
        hold(learnt_.fire, hands);
        walk(0, hands);
        level(seen, hands);
        const auto& below = seen.glance[glance_rows - 1][glance_columns / 2];
        let_go_ = hung_ > looks_of(1.5) && below.what == "floor";
        return;
    }
    if (hung_ > 0) {  // the player is in the air, or has landed
        walk(0, hands);
        if (++hung_ < looks_of(4)) return;
        hung_ = 0;
        let_go_ = false;
        return;
    }
    const auto* anchor = nearest(seen, "anchor");
    if (anchor == nullptr) {
        hands.mouse.y = -20;
        return;
    }
    aim(seen, anchor->place, 0, hands);
    if (seen.mark == game::TargetKind::hook) hold(learnt_.fire, hands);
}

void Player::fetch(const Screen& seen, Hands& hands) {
    const auto* ingredient = nearest(seen, "ingredient");
    if (ingredient == nullptr) return search(seen, hands);
    walk_to(seen, ingredient->place, hands);
}

void Player::brew(const Screen& seen, Hands& hands) {
    const auto words = seen.words_of(Part::messages);
    const bool drops = has(words, "Drop"), mixes = has(words, "mixed");
    if (!drops && !mixes && !has(words, "Stir") && !has(words, "Pure brew")) {
        const auto* cauldron = nearest(seen, "cauldron");
        if (cauldron == nullptr) return search(seen, hands);
        return walk_to(seen, cauldron->place, hands);
    }
    hold(learnt_.stir, hands);
    if (!mixes && tap(8)) hold(learnt_.drop, hands);
    constexpr float reach = 42, looks_per_circle = 69;
    const float angle = 6.2831853F * static_cast<float>(looks_) / looks_per_circle;
    hands.mouse = reach * fvec2(std::cos(angle), std::sin(angle));
}

// What the player does in a duel ----------------------------------------------------------------------------

/// The wand for fighting: the first one that needs no charging, or the next one if its energy is low.
std::string Player::best_wand(const Screen& seen) const {
    constexpr float low = 0.05F;
    return !seen.energy.empty() && seen.energy[0] > low ? "Bolt" : "Blast";
}

/// Turns until the foe is in view, and walks on where the ground is open.
void Player::search(const Screen& seen, Hands& hands) {
    ++lost_;
    level(seen, hands);
    constexpr float turn = 25;
    if (seen.hurt_from && std::abs(*seen.hurt_from) > 0.3F) {
        hands.mouse.x = *seen.hurt_from > 0 ? fastest : -fastest;
        return;
    }
    const int whole_turn = looks_of(4.7);
    if (lost_ % (2 * whole_turn) < whole_turn) {
        hands.mouse.x = turn;
        return;
    }
    constexpr std::size_t middle = glance_columns / 2;
    const auto& far = seen.glance[glance_rows / 2 + 1][middle];
    const auto& near = seen.glance[glance_rows - 1][middle];
    const bool open = near.what == "floor" && far.what == "floor" && far.far > 3;
    if (open)
        walk(0, hands);
    else
        hands.mouse.x = turn;
}

void Player::fight(const Screen& seen, Hands& hands) {
    words_.clear();
    if (seen.dead) return;
    const auto* foe = nearest(seen, "wizard");
    if (foe == nullptr) return search(seen, hands);
    lost_ = 0;
    const auto wand = best_wand(seen);
    if (!take(seen, wand, hands)) return;
    const bool aims = aim(seen, foe->place, 0.4F * foe->high, hands);
    // Heights of a foe in the window (px): when the foe is near enough to be hit, and when the player need
    // not come nearer.
    constexpr float in_range = 80, near = 120;
    const bool charges = wand != "Bolt";
    const bool fires = charges ? !(aims && seen.ring > 0.7F) : aims && foe->high > in_range;
    if (fires) hold(learnt_.fire, hands);
    const auto& below = seen.glance[glance_rows - 1][glance_columns / 2];
    if (foe->high < near && below.what == "floor") walk(0, hands);
}

}  // namespace thaum::game::screen

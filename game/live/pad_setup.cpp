#include "game/live/pad_setup.h"

#include <algorithm>
#include <cstdio>
#include <utility>

#include "core/one_line.h"
#include "core/tell_user.h"
#include "core/text.h"
#include "game/settings/own_pads.h"

namespace thaum::game::inline live {
namespace {

constexpr std::size_t max_of_name_shown = 28;  // longest part of a name that fits a row of the menu

std::string shown(const std::string& name) { return printable(name, max_of_name_shown); }

/// The question for the control that is asked for now: "3 of 20: press X, the leftmost of the four".
std::string question_of(const input::PadAssignment& assignment) {
    return text(assignment.number() + 1, " of ", input::PadAssignment::count(), ": ", assignment.asks());
}

/// Whether a player with a pad can turn left and right by controls other than the right stick.
bool turns_without_right_stick(const Settings& settings) {
    const auto& bindings = settings.bindings_of(input::DeviceKind::pad);
    const auto other = [](const input::Control& control) {
        const bool axis = control.source == input::Control::Source::pad_axis;
        const bool right_stick = axis && (control.code == static_cast<int>(input::PadAxis::right_x) ||
                                          control.code == static_cast<int>(input::PadAxis::right_y));
        return !right_stick;
    };
    return std::ranges::any_of(bindings.of(input::Action::turn_left), other) &&
           std::ranges::any_of(bindings.of(input::Action::turn_right), other);
}

}  // namespace

std::vector<std::string> faults_of(const IdleSticks& sticks) {
    auto faults = sticks.faults;
    for (const auto& stick : sticks.locked)
        faults.push_back(text("pad '", shown(stick.name), "' may not be read (", stick.path,
                              "): 'thaum doctor' says how to allow it"));
    if (const auto count = sticks.left_over.size(); count > 0)
        faults.push_back(text("only ", std::tuple_size_v<Pads>, " pads can be used at once: '",
                              shown(sticks.left_over.front()), "'",
                              count > 1 ? text(" and ", count - 1, " more") : "", " cannot play"));
    for (const auto& name : sticks.without_right_stick)
        faults.push_back(
            text("pad '", shown(name),
                 "' has no right stick: give \"Turn left\" and the like other controls (Controls, Pad)"));
    for (const auto& stick : sticks.unknown)
        faults.push_back(text("joystick '", shown(stick.name),
                              "' is not known: 'Set up' on the page Controls asks for its buttons"));
    return faults;
}

/// The joystick with this number in the menu; null: it was unplugged.
const input::Stick* PadSetup::stick_of(std::size_t number) const {
    const auto unknown = sticks_.unknown.size();
    if (number < unknown) return &sticks_.unknown[number];
    return number - unknown < sticks_.own.size() ? &sticks_.own[number - unknown] : nullptr;
}

/// The joystick that is being set up; null: it was unplugged.
const input::Stick* PadSetup::present_stick() const {
    for (const auto* list : {&sticks_.unknown, &sticks_.own})
        for (const auto& stick : *list)
            if (stick.guid == model_ && stick.path == path_) return &stick;
    return nullptr;
}

bool PadSetup::carry_out(MenuRequest request, const LiveMenu& menu) {
    const auto* stick = stick_of(menu.state().stick);
    switch (request) {
        case MenuRequest::skip_control:
            if (assignment_) assignment_->skip();
            return true;
        case MenuRequest::set_up_pad:
            if (stick == nullptr) return true;
            assignment_.emplace(*stick);
            asked_.clear();
            model_ = stick->guid;
            path_ = stick->path;
            return true;
        case MenuRequest::forget_pad:
            if (stick != nullptr) due_ = PadChange{.model = stick->guid};
            return true;
        default: return false;
    }
}

std::optional<PadChange> PadSetup::follow(IdleSticks sticks, LiveMenu& menu) {
    sticks_ = std::move(sticks);
    if (turns_without_right_stick(menu.settings())) sticks_.without_right_stick.clear();
    tell_faults(menu);
    if (due_) return std::exchange(due_, {});
    if (!menu.sets_up_pad()) assignment_.reset();
    if (!assignment_) return {};
    const auto* stick = present_stick();
    if (stick == nullptr) {
        assignment_.reset();
        menu.end_pad_setup("the joystick is gone, and nothing was kept");
        return {};
    }
    assignment_->follow(stick->state);
    if (!assignment_->is_done()) {
        ask(menu);
        return {};
    }
    PadChange change{.model = model_, .mapping = assignment_->mapping()};
    skipped_ = assignment_->skipped();
    assignment_.reset();
    return change;
}

Pads PadSetup::without_stick(Pads pads) const {
    for (auto& pad : pads) {
        if (!assignment_ || !pad.present || pad.path != path_) continue;
        pad.axes = {};
        pad.buttons = 0;
    }
    return pads;
}

/// Asks for the next control on the screen, and in the terminal for those who do not see the screen.
void PadSetup::ask(LiveMenu& menu) {
    auto question =
        assignment_->asks().empty() ? std::string("let go of the joystick") : question_of(*assignment_);
    if (question == asked_) return;
    print_line(text("set up: ", question));
    std::fflush(stdout);
    asked_ = question;
    menu.ask_for_control(std::move(question), assignment_->needs_answer());
}

void PadSetup::tell_faults(LiveMenu& menu) {
    auto faults = faults_of(sticks_);
    for (const auto& fault : faults)
        if (told_.insert(fault).second) tell_user(fault);
    const auto names_of = [](const std::vector<input::Stick>& sticks) {
        std::vector<std::string> names;
        for (const auto& stick : sticks) names.push_back(shown(stick.name));
        return names;
    };
    menu.tell_sticks(names_of(sticks_.unknown), names_of(sticks_.own), std::move(faults));
}

std::string PadSetup::words_of_end(const PadChange& change) const {
    if (change.mapping.empty()) return "its set-up is forgotten";
    return skipped_.empty() ? std::string("it plays as a pad now")
                            : text("it plays as a pad now, without ", skipped_);
}

void PadSetup::end(const PadChange& change, const Expected<void>& taken, LiveMenu& menu) {
    if (!taken) return menu.end_pad_setup(taken.error().message);
    const auto saved =
        change.mapping.empty() ? forget_own_pad(file_, change.model) : save_own_pad(file_, change.mapping);
    menu.end_pad_setup(saved ? words_of_end(change)
                             : text(words_of_end(change), ", for this run only: ", saved.error().message));
}

}  // namespace thaum::game::inline live

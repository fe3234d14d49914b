#include "game/live/pad_setup.h"

#include <algorithm>
#include <cstdio>

#include "core/one_line.h"
#include "core/tell_user.h"
#include "core/text.h"
#include "game/settings/own_pads.h"

namespace thaum::app {
namespace {

constexpr std::size_t most_of_name_shown = 40;

std::string shown(const std::string& name) { return printable(name, most_of_name_shown); }

/// The question of an assignment: "3 of 20: press X, the leftmost of the four".
std::string question_of(const input::PadAssignment& assignment) {
    return text(assignment.number() + 1, " of ", input::PadAssignment::count(), ": ", assignment.asks());
}

}  // namespace

std::vector<std::string> faults_of(const IdleSticks& sticks) {
    std::vector<std::string> faults;
    if (!sticks.fault.empty()) faults.push_back(sticks.fault);
    for (const auto& stick : sticks.locked)
        faults.push_back(text("pad '", shown(stick.name), "' may not be read (", stick.path,
                              "): 'thaum doctor' says how to allow it"));
    for (const auto& stick : sticks.unknown)
        faults.push_back(text("joystick '", shown(stick.name),
                              "' is not known: 'Set up' on the page Controls asks for its buttons"));
    return faults;
}

bool PadSetup::carry_out(MenuRequest request, const LiveMenu& menu) {
    if (request == MenuRequest::skip_control && assignment_) assignment_->skip();
    if (request == MenuRequest::set_up_pad && menu.state().stick < sticks_.unknown.size()) {
        const auto& stick = sticks_.unknown[menu.state().stick];
        assignment_.emplace(stick);
        asked_.clear();
        model_ = stick.guid;
    }
    return request == MenuRequest::skip_control || request == MenuRequest::set_up_pad;
}

std::optional<std::string> PadSetup::follow(IdleSticks sticks, LiveMenu& menu) {
    const bool changed = faults_of(sticks) != faults_of(sticks_);
    sticks_ = std::move(sticks);
    if (changed) tell_faults(menu);
    if (!menu.sets_up_pad()) assignment_.reset();
    if (!assignment_) return {};
    const auto& unknown = sticks_.unknown;
    const auto stick =
        std::find_if(unknown.begin(), unknown.end(), [&](const auto& s) { return s.guid == model_; });
    if (stick == unknown.end()) {
        menu.end_pad_setup("the joystick is gone");
        return {};
    }
    assignment_->follow(stick->state);
    if (!assignment_->asks().empty()) {
        ask(question_of(*assignment_), menu);
        return {};
    }
    const auto mapping = assignment_->mapping();
    assignment_.reset();
    if (mapping) return *mapping;
    menu.end_pad_setup(mapping.error().message);
    return {};
}

/// Asks on the screen, and in the terminal for those who do not see it.
void PadSetup::ask(std::string question, LiveMenu& menu) {
    if (question == asked_) return;
    std::printf("set up: %s\n", question.c_str());
    std::fflush(stdout);
    asked_ = question;
    menu.ask_for_control(std::move(question));
}

void PadSetup::tell_faults(LiveMenu& menu) {
    const auto faults = faults_of(sticks_);
    for (const auto& fault : faults)
        if (told_.insert(fault).second) tell_user(fault);
    std::vector<std::string> names;
    for (const auto& stick : sticks_.unknown) names.push_back(shown(stick.name));
    menu.tell_sticks(std::move(names), faults);
}

void PadSetup::end(const std::string& mapping, const Expected<void>& taken, LiveMenu& menu) const {
    if (!taken) return menu.end_pad_setup(taken.error().message);
    const auto saved = save_own_pad(file_, mapping);
    menu.end_pad_setup(saved ? std::string("it plays as a pad now")
                             : text("it plays as a pad, for this run only: ", saved.error().message));
}

}  // namespace thaum::app

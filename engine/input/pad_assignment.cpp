#include "input/pad_assignment.h"

#include <algorithm>
#include <cstdlib>

#include "core/text.h"

namespace thaum::input {
namespace {

struct Question {
    std::string_view field;  ///< name of the control in mappings, the lines of SDL's gamecontrollerdb.txt
    std::string_view name;   ///< name of the control for people
    std::string_view words;
    bool stick = false;   ///< true: an axis of a stick, which the user must move to its positive side
    bool needed = false;  ///< true: a duel cannot be played without this control
};
constexpr std::array questions{
    Question{"a", "A", "press A, the lowest of the four buttons on the right", false, true},
    Question{"b", "B", "press B, the rightmost of the four"},
    Question{"x", "X", "press X, the leftmost of the four"},
    Question{"y", "Y", "press Y, the highest of the four"},
    Question{"leftx", "left stick", "push the left stick to the right", true, true},
    Question{"lefty", "left stick", "push the left stick down, towards you", true, true},
    Question{"rightx", "right stick", "push the right stick to the right", true, true},
    Question{"righty", "right stick", "push the right stick down, towards you", true, true},
    Question{"righttrigger", "RT", "press RT, the right trigger, to its end", false, true},
    Question{"lefttrigger", "LT", "press LT, the left trigger, to its end"},
    Question{"rightshoulder", "RB", "press RB, the button above the right trigger"},
    Question{"leftshoulder", "LB", "press LB, the button above the left trigger"},
    Question{"start", "Start", "press Start", false, true},
    Question{"back", "Back", "press Back"},
    Question{"leftstick", "left stick's press", "press the left stick in"},
    Question{"rightstick", "right stick's press", "press the right stick in"},
    Question{"dpup", "cross up", "press the cross up"},
    Question{"dpright", "cross right", "press the cross to the right"},
    Question{"dpdown", "cross down", "press the cross down"},
    Question{"dpleft", "cross left", "press the cross to the left"},
};

constexpr int axis_end = 32767;
constexpr int moved = axis_end / 2;         ///< an axis this far from its rest position counts as moved
constexpr int back_at_rest = axis_end / 4;  ///< an axis this near to its rest position counts as released
/// An axis whose rest position is farther out than this can only move one way.
constexpr int rests_at_end = axis_end / 2;

/// Name of a model of joysticks, without characters that a line of SDL's gamecontrollerdb.txt cannot contain.
std::string name_in_mapping(std::string name) {
    std::erase_if(name, [](char c) { return c == ',' || static_cast<unsigned char>(c) < ' '; });
    return name.empty() ? "Joystick" : name;
}

}  // namespace

PadAssignment::PadAssignment(const Stick& stick)
    : guid_(stick.guid), name_(name_in_mapping(stick.name)), rest_(stick.state) {}

std::string_view PadAssignment::asks() const {
    return number_ < questions.size() ? questions.at(number_).words : std::string_view();
}

std::size_t PadAssignment::count() { return questions.size(); }

bool PadAssignment::is_at_rest(const StickState& current) const {
    for (std::size_t i = 0; i < current.axes.size() && i < rest_.axes.size(); ++i)
        if (std::abs(current.axes[i] - rest_.axes[i]) > back_at_rest) return false;
    return current.buttons == rest_.buttons && current.hats == rest_.hats;
}

/// The part of an axis that has moved, in the form of a mapping: "a2", "a2~" if inverted, or one side, such
/// as "+a2".
std::optional<std::string> PadAssignment::moved_axis(std::size_t axis, int value) const {
    const int rest = rest_.axes[axis], way = value - rest;
    if (std::abs(way) < moved) return {};
    const auto whole = text("a", axis), side = text(way > 0 ? "+" : "-", whole);
    if (taken_.contains(whole) || taken_.contains(whole + "~") || taken_.contains(side)) return {};
    const bool one_way = std::abs(rest) > rests_at_end, stick = questions.at(number_).stick;
    if (one_way && stick) return {};  // a trigger cannot be used as a stick
    if (one_way || stick) return way > 0 ? whole : whole + "~";
    return side;
}

/// The part of the joystick (button, axis or hat) that is being moved and that was not assigned before, in
/// the form of a mapping.
std::optional<std::string> PadAssignment::moved_part(const StickState& current) const {
    const bool stick = questions.at(number_).stick;
    for (std::size_t i = 0; !stick && i < current.buttons.size() && i < rest_.buttons.size(); ++i) {
        auto part = text("b", i);
        if (current.buttons[i] && !rest_.buttons[i] && !taken_.contains(part)) return part;
    }
    for (std::size_t i = 0; !stick && i < current.hats.size(); ++i) {
        auto part = text("h", i, ".", static_cast<int>(current.hats[i]));
        const bool one_way = (current.hats[i] & (current.hats[i] - 1U)) == 0;
        if (current.hats[i] != 0 && one_way && !taken_.contains(part)) return part;
    }
    for (std::size_t i = 0; i < current.axes.size() && i < rest_.axes.size(); ++i)
        if (auto part = moved_axis(i, current.axes[i])) return part;
    return {};
}

bool PadAssignment::follow(const StickState& current) {
    if (let_go_first_ && !is_at_rest(current)) return false;
    let_go_first_ = false;
    if (asks().empty()) return false;
    const auto part = moved_part(current);
    if (!part) return false;
    answers_ += text(questions.at(number_).field, ":", *part, ",");
    taken_.insert(*part);
    let_go_first_ = true;
    ++number_;
    return true;
}

bool PadAssignment::needs_answer() const {
    return number_ < questions.size() && questions.at(number_).needed;
}

void PadAssignment::skip() {
    if (asks().empty() || needs_answer()) return;
    skipped_ += text(skipped_.empty() ? "" : ", ", questions.at(number_).name);
    ++number_;
}

std::string PadAssignment::mapping() const {
    return text(guid_, ",", name_, ",", answers_, "platform:Linux,");
}

}  // namespace thaum::input

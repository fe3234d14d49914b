// Tests of setting up a joystick that SDL does not know: which part is assigned to which control, and the
// resulting mapping. The expected mappings are written by hand in SDL's form.
#include "input/pad_assignment.h"

#include <gtest/gtest.h>

#include "input/pad_mapping.h"

namespace thaum::input {
namespace {

constexpr std::int16_t low = -32768, high = 32767;

/// A joystick with four buttons, a hat, and seven axes, of which two are triggers.
class PadAssignmentTest : public testing::Test {
protected:
    PadAssignmentTest() {
        stick_.state.buttons.resize(4);
        stick_.state.axes = {0, 100, 0, 0, low, low, 0};
        stick_.state.hats = {0};
        assignment_.emplace(stick_);
    }
    /// Moves parts to a state and back to rest. Returns whether the question was answered.
    bool answer(const StickState& state) {
        const bool answered = assignment_->follow(state);
        assignment_->follow(stick_.state);
        return answered;
    }
    bool button(std::size_t number) {
        auto state = stick_.state;
        state.buttons.at(number) = true;
        return answer(state);
    }
    bool axis(std::size_t number, std::int16_t value) {
        auto state = stick_.state;
        state.axes.at(number) = value;
        return answer(state);
    }
    bool hat(std::uint8_t value) {
        auto state = stick_.state;
        state.hats.at(0) = value;
        return answer(state);
    }
    void skip(int count) {
        for (int i = 0; i < count; ++i) assignment_->skip();
    }
    std::string mapping() const { return assignment_->mapping(); }

    Stick stick_{
        .name = "Stick, of wood", .path = "/dev/input/event3", .guid = "03000000aabb00001122000001000000"};
    std::optional<PadAssignment> assignment_;
};

TEST_F(PadAssignmentTest, EachKindOfPartAnswers) {
    EXPECT_TRUE(button(2));
    skip(3);
    EXPECT_TRUE(axis(0, high)) << "left stick to the right";
    EXPECT_TRUE(axis(1, low)) << "left stick down, on an axis that grows upwards";
    EXPECT_TRUE(axis(2, high)) << "right stick to the right";
    EXPECT_TRUE(axis(6, high)) << "right stick down";
    EXPECT_TRUE(axis(5, high)) << "right trigger";
    EXPECT_TRUE(axis(3, low)) << "left trigger, on half of an axis";
    skip(2);
    EXPECT_TRUE(button(0)) << "Start";
    skip(3);
    EXPECT_TRUE(hat(1));
    EXPECT_TRUE(hat(2));
    EXPECT_TRUE(axis(3, high)) << "cross down, on half of an axis";
    EXPECT_TRUE(axis(4, high));
    EXPECT_EQ(assignment_->asks(), "");
    EXPECT_TRUE(assignment_->is_done());
    EXPECT_EQ(mapping(),
              "03000000aabb00001122000001000000,Stick of wood,a:b2,leftx:a0,lefty:a1~,rightx:a2,righty:a6,"
              "righttrigger:a5,lefttrigger:-a3,start:b0,dpup:h0.1,dpright:h0.2,dpdown:+a3,dpleft:a4,"
              "platform:Linux,");
    EXPECT_EQ(assignment_->skipped(), "B, X, Y, RB, LB, Back, left stick's press, right stick's press");
}

TEST_F(PadAssignmentTest, WhatADuelNeedsCannotBeLeftOut) {
    std::vector<std::size_t> needed;
    const auto answer_as_needed = [&] {
        if (needed.size() == 1) return axis(0, high);
        if (needed.size() == 2) return axis(1, high);
        if (needed.size() == 3) return axis(2, high);
        return needed.size() == 4 ? axis(3, high) : button(needed.size() - 5 + 1);
    };
    while (!assignment_->asks().empty()) {
        const auto before = assignment_->number();
        assignment_->skip();
        if (assignment_->number() != before) continue;
        EXPECT_TRUE(assignment_->needs_answer());
        ASSERT_TRUE(needed.empty() ? button(0) : answer_as_needed()) << before;
        needed.push_back(before);
    }
    EXPECT_EQ(needed, (std::vector<std::size_t>{0, 4, 5, 6, 7, 8, 12})) << "A, both sticks, RT and Start";
}

TEST_F(PadAssignmentTest, TheLastAnswerMustBeLetGoOf) {
    auto held = stick_.state;
    button(2);
    skip(3);
    for (const std::size_t a : {0U, 1U, 2U, 3U, 5U}) axis(a, high);
    skip(3);
    button(0);
    skip(6);
    EXPECT_FALSE(assignment_->is_done());
    held.hats[0] = 8;
    EXPECT_TRUE(assignment_->follow(held)) << "cross left";
    EXPECT_EQ(assignment_->asks(), "");
    EXPECT_FALSE(assignment_->is_done()) << "it would act in the menu at once";
    assignment_->follow(stick_.state);
    EXPECT_TRUE(assignment_->is_done());
}

TEST_F(PadAssignmentTest, OnePressAnswersOneQuestion) {
    auto held = stick_.state;
    held.buttons[0] = true;
    EXPECT_TRUE(assignment_->follow(held));
    held.buttons[1] = true;
    EXPECT_FALSE(assignment_->follow(held)) << "the first button is still held";
    EXPECT_EQ(assignment_->number(), 1U);
    assignment_->follow(stick_.state);
    EXPECT_FALSE(button(0)) << "it is A already";
    EXPECT_TRUE(button(1));
}

TEST_F(PadAssignmentTest, OnlyAWholeAxisAnswersForAStick) {
    button(3);
    skip(3);
    EXPECT_FALSE(button(0));
    EXPECT_FALSE(hat(2));
    EXPECT_FALSE(axis(4, high)) << "a trigger";
    EXPECT_FALSE(axis(0, high / 3)) << "not pushed far enough";
    EXPECT_TRUE(axis(0, high));
    EXPECT_FALSE(axis(0, high)) << "it is the stick's other direction already";
    EXPECT_FALSE(axis(0, low));
    EXPECT_TRUE(axis(1, high));
}

TEST_F(PadAssignmentTest, AJoystickThatLostItsPartsAnswersNothing) {
    EXPECT_FALSE(assignment_->follow({}));
    EXPECT_EQ(assignment_->number(), 0U);
}

TEST_F(PadAssignmentTest, AModelWithoutANameGetsOne) {
    stick_.name = ",\n";
    assignment_.emplace(stick_);
    button(3);
    EXPECT_EQ(mapping(), "03000000aabb00001122000001000000,Joystick,a:b3,platform:Linux,");
}

TEST(PadMappingTest, TheSameControlsAreFoundInWhatSdlMakesOfALine) {
    const std::string_view line = "0a000000aabb00001122000001000000, Stick ,a:b3,leftx:a0,platform:Linux,";
    EXPECT_EQ(model_of_mapping(line), "0a000000aabb00001122000001000000");
    EXPECT_TRUE(same_pad_controls(line, "0a00cd12aabb00001122000001000000,Stick,a:b3,leftx:a0,crc:12cd"));
    EXPECT_FALSE(same_pad_controls(line, "0a000000aabb00001122000001000000,Stick,a:b3,leftx:a1,"));
    EXPECT_FALSE(same_pad_controls(line, "0a000000aabb00001122000001000000,Other,a:b3,leftx:a0,"));
    EXPECT_FALSE(same_pad_controls(line, ""));
}

}  // namespace
}  // namespace thaum::input

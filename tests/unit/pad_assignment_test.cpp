// Tests of the set-up of a joystick that SDL does not know: which part answers which question, and the mapping that comes
// of it. The expected mappings are written by hand in SDL's form.
#include "input/pad_assignment.h"

#include <gtest/gtest.h>

namespace thaum::input {
namespace {

constexpr std::int16_t low = -32768, high = 32767;

/// A joystick with four buttons, six axes of which the last two are triggers, and a hat.
class PadAssignmentTest : public testing::Test {
protected:
    PadAssignmentTest() {
        stick_.state.buttons.resize(4);
        stick_.state.axes = {0, 100, 0, 0, low, low};
        stick_.state.hats = {0};
        assignment_.emplace(stick_);
    }
    /// Moves to a state and back to rest. Returns whether the question was answered.
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
    std::string mapping() const { return assignment_->mapping().value_or("none"); }

    Stick stick_{
        .name = "Stick, of wood", .path = "/dev/input/event3", .guid = "03000000aabb00001122000001000000"};
    std::optional<PadAssignment> assignment_;
};

TEST_F(PadAssignmentTest, EachKindOfPartAnswers) {
    EXPECT_TRUE(button(2));
    skip(3);
    EXPECT_TRUE(axis(0, high)) << "left stick to the right";
    EXPECT_TRUE(axis(1, low)) << "left stick down, on an axis that grows upwards";
    skip(2);
    EXPECT_TRUE(axis(5, high)) << "right trigger";
    EXPECT_TRUE(axis(3, low)) << "left trigger, on half of an axis";
    skip(6);
    EXPECT_TRUE(hat(1));
    EXPECT_TRUE(hat(2));
    EXPECT_TRUE(axis(2, high)) << "cross down, on half of an axis";
    EXPECT_TRUE(axis(2, low));
    EXPECT_EQ(assignment_->asks(), "");
    EXPECT_EQ(mapping(),
              "03000000aabb00001122000001000000,Stick of wood,a:b2,leftx:a0,lefty:a1~,righttrigger:a5,"
              "lefttrigger:-a3,dpup:h0.1,dpright:h0.2,dpdown:+a2,dpleft:-a2,platform:Linux,");
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
    skip(4);
    EXPECT_FALSE(button(0));
    EXPECT_FALSE(hat(2));
    EXPECT_FALSE(axis(4, high)) << "a trigger";
    EXPECT_FALSE(axis(0, high / 3)) << "not pushed far enough";
    EXPECT_TRUE(axis(0, high));
    EXPECT_FALSE(axis(0, high)) << "it is the stick's other direction already";
    EXPECT_FALSE(axis(0, low));
    EXPECT_TRUE(axis(1, high));
}

TEST_F(PadAssignmentTest, NothingAssignedIsNoMapping) {
    EXPECT_FALSE(assignment_->follow({})) << "a joystick that lost its parts";
    skip(static_cast<int>(PadAssignment::count()));
    EXPECT_EQ(assignment_->asks(), "");
    skip(1);
    EXPECT_FALSE(button(0));
    EXPECT_FALSE(assignment_->mapping());
}

TEST_F(PadAssignmentTest, AModelWithoutANameGetsOne) {
    stick_.name = ",\n";
    assignment_.emplace(stick_);
    button(3);
    EXPECT_EQ(mapping(), "03000000aabb00001122000001000000,Joystick,a:b3,platform:Linux,");
}

}  // namespace
}  // namespace thaum::input

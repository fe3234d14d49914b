// unit/wall_player.h: a player who draws on the gesture wall of the range.
#pragma once
#include <cmath>

#include "game/range/practice.h"

namespace thaum::game {

/// A player who draws gestures on the range's gesture wall with the mouse.
struct WallPlayer {
    Practice& practice;

    void play(int ticks, std::uint32_t buttons = 0, vec2 (*counts)(int) = nullptr) {
        for (int t = 0; t < ticks; ++t) {
            input::InputFrame frame;
            frame.devices[game::dummys] = practice.dummy_sample();
            auto& hand = frame.devices[game::practising];
            hand.buttons = buttons;
            const vec2 move = counts == nullptr ? vec2(0) : counts(t);
            hand.counts[input::hand::look_right] = static_cast<int>(move.x);
            hand.counts[input::hand::look_up] = static_cast<int>(move.y);
            practice.match().tick(frame);
            practice.follow_gestures();
        }
    }
    void draw(int ticks, vec2 (*counts)(int)) {
        play(ticks, input::bit(input::Button::trace), counts);
        play(50);
    }
};

/// Motion of the mouse for a circle of 6 cm in 1.5 s, slow at its beginning and end as hands draw it.
inline vec2 circle_on_wall(int t) {
    const auto place = [](int at) {
        const double u = at / 1500.0, angle = 2 * pi * u * u * u * (10 + u * (6 * u - 15));
        return vec2(std::round(300 * std::sin(angle)), std::round(300 * std::cos(angle)));
    };
    return place(t + 1) - place(t);
}

inline vec2 triangle_on_wall(int t) {
    const int side = t / 267;
    return side == 0 ? vec2(3, 5) : side == 1 ? vec2(3, -5) : vec2(-6, 0);
}

}  // namespace thaum::game

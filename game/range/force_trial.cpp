#include "game/range/force_trial.h"

#include "core/text.h"
#include "game/context/hand_forces.h"

namespace thaum::game::inline range {

using input::Button;

bool take_fire(const std::vector<input::DeviceSpec>& devices, std::uint32_t player,
               input::InputFrame& frame) {
    bool down = false;
    for (std::size_t i = 0; i < devices.size(); ++i) {
        auto& sample = frame.devices.at(i);
        if (devices[i].player != player || !sample.down(Button::fire)) continue;
        down = true;
        sample.buttons &= ~input::bit(Button::fire);
        sample.counts[input::hand::trigger] = 0;
    }
    return down;
}

std::optional<std::uint32_t> ForceTrial::step(Simulation& match, std::uint32_t player,
                                              input::InputFrame& frame) {
    if (!runs_ || match.match().paused != 0) return {};
    const bool down = take_fire(match.setup().devices, player, frame);
    const bool pressed = down && !held_;
    held_ = down;
    if (pressed && percent_ > 0) {
        runs_ = false;
        return percent_;
    }
    // The player has not pressed fire up to the strongest kick, so nothing changes.
    if (percent_ == 100 && age_ % between_kicks == 0) {
        runs_ = false;
        return {};
    }
    // The player's own limit of the force is set to 100 %, so that it does not weaken the kicks.
    if (age_ == 0) frame.devices.at(0).change = {static_cast<std::uint8_t>(input::HandFader::force), 100};
    if (age_ > 0 && age_ % between_kicks == 0) {
        percent_ += percent_per_kick;
        const auto wizard = wizard_of(match.world(), player);
        kick_at_peak(match.context_to_change(), wizard, percent_ / 100.0, kick_length);
    }
    ++age_;
    return {};
}

std::string ForceTrial::words() const {
    if (percent_ == 0) return "kicks will grow: press fire when one is as strong as you want";
    return text("kick of ", percent_, " %: press fire if it is as strong as you want");
}

}  // namespace thaum::game::inline range

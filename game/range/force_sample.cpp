#include "game/range/force_sample.h"

#include <algorithm>

#include "game/context/hand_forces.h"

namespace thaum::game::inline range {
namespace {

using input::HandFader;

constexpr Tick length = ticks(1.5);
// Forces with which a player tries a strength setting, for a device with a peak force of 3.3 N. Recoil and
// weight are those of the wands.
constexpr double bolt_recoil = 1.2;     // peak force of a kick (N)
constexpr double blow = 2;              // peak force of a blow (N)
constexpr double weight_per_kg = 0.01;  // felt weight (N/kg)
constexpr Tick recoil_length = 15, blow_length = 20, between_recoils = 125, recoils = 4;
constexpr double mass = 30;        // mass whose weight is felt (kg)
constexpr Tick weight_rise = 200;  // ticks in which the weight fades in, and also out

/// Share of the full weight that is felt at this time after the beginning: it fades in, stays, and fades out.
double weight_at(Tick age) {
    const Tick to_end = length - std::min(age, length);
    return std::min(1.0, static_cast<double>(std::min(age, to_end)) / weight_rise);
}

}  // namespace

bool ForceSample::exists_for(HandFader fader) {
    return fader == HandFader::recoil || fader == HandFader::blows || fader == HandFader::weight;
}

void ForceSample::begin(HandFader fader) {
    fader_ = fader;
    left_ = exists_for(fader) ? length : 0;
}

void ForceSample::step(Simulation& match, std::uint32_t player) {
    if (left_ == 0 || match.match().paused != 0) return;
    const Tick age = length - left_--;
    auto& context = match.context_to_change();
    const auto wizard = wizard_of(match.world(), player);
    const auto& setup = match.haptic_setup();
    if (fader_ == HandFader::recoil && age % between_recoils == 0 && age < recoils * between_recoils)
        recoil(context, wizard, bolt_recoil, recoil_length);
    if (fader_ == HandFader::blows && age == 0)
        kick(context, wizard, vec3(0, 0, setup.blows[player] * blow), blow_length);
    if (fader_ == HandFader::weight)
        set_steady_force(context, wizard,
                         vec3(0, -weight_per_kg * mass * setup.weight[player] * weight_at(age), 0));
    if (fader_ == HandFader::weight && left_ == 0) set_steady_force(context, wizard, {});
}

std::string_view ForceSample::words() const {
    switch (fader_) {
        case HandFader::recoil: return "four shots of the bolt";
        case HandFader::blows: return "a blow on a carried thing";
        default: return "the weight of 30 kg";
    }
}

}  // namespace thaum::game::inline range

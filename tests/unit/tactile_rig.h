// unit/tactile_rig.h: the shipped layouts and effects, and small helpers for the tests of tactile output.
#pragma once
#include <gtest/gtest.h>

#include <filesystem>
#include <memory>
#include <string>

#include "core/file.h"
#include "core/hash.h"
#include "core/random.h"
#include "tactile/mixer.h"

namespace thaum::tactile {

inline const std::filesystem::path tactile_assets =
    std::filesystem::path(THAUM_SOURCE_DIR) / "assets/tactile";
inline constexpr const char* layout_names[] = {"abstract_4x5", "x40",      "x16",    "pad",
                                               "speakers",     "shakers8", "sleeves"};

inline Layout shipped_layout(const std::string& name) {
    return load_layout(tactile_assets / "layouts" / (name + ".toml")).value();
}

inline EffectBank shipped_effects() {
    auto bank = load_effects(tactile_assets / "effects");
    EXPECT_TRUE(bank.has_value() && bank->faulty.empty()) << (bank ? "" : bank.error().message);
    return bank ? *bank : EffectBank{};
}

/// An effect of full strength around one place. The envelope has attack, hold and decay (ms).
inline Effect plain_effect(std::string name, Envelope envelope) {
    Effect effect;
    effect.name = std::move(name);
    effect.weakest = 0;
    effect.strongest = 1e-3;
    effect.wavelength = 12e-3;
    effect.stiffness = 5000;
    effect.envelope = envelope;
    effect.priority = 5;
    return effect;
}

/// A mixer with its layout and effects, and the frames that it makes.
struct TactileRig {
    explicit TactileRig(const std::string& layout_name, const MixerSettings& settings = {})
        : TactileRig(shipped_layout(layout_name), shipped_effects(), settings) {}
    TactileRig(Layout l, EffectBank b, const MixerSettings& settings = {})
        : layout(std::move(l)),
          bank(std::move(b)),
          mixer(std::make_unique<TactileMixer>(layout, bank, settings)) {}
    TactileRig(const TactileRig&) = delete;
    TactileRig& operator=(const TactileRig&) = delete;

    std::uint32_t effect(std::string_view name) const {
        const auto number = bank.find(name);
        EXPECT_TRUE(number.has_value()) << name;
        return number.value_or(0);
    }
    void start(std::string_view name, const Where& where, double strength = 1) {
        mixer->start(effect(name), where, strength, now);
    }
    const TactileFrame& frame() {
        const auto& made = mixer->mix(now);
        now += frame_ticks;
        return made;
    }
    /// Largest amplitude of each actuator over the next `frames` frames.
    std::vector<double> peaks(int frames) {
        std::vector<double> result(layout.actuators.size());
        for (int f = 0; f < frames; ++f) {
            const auto& made = frame();
            for (std::size_t i = 0; i < result.size(); ++i)
                result[i] = std::max(result[i], static_cast<double>(made.amplitude[i]));
        }
        return result;
    }

    Layout layout;
    EffectBank bank;
    std::unique_ptr<TactileMixer> mixer;
    Tick now = 1000;
};

inline double energy_of(const TactileFrame& frame) {
    double sum = 0;
    for (const float a : frame.amplitude) sum += static_cast<double>(a) * a;
    return sum;
}

}  // namespace thaum::tactile

#include "game/settings/faders.h"

#include <algorithm>
#include <cmath>

#include "core/text.h"

namespace thaum::game::inline settings {
namespace {

constexpr int fader_steps = 20;

struct FaderWords {
    std::string_view label, told;
};
constexpr std::array<FaderWords, haptics::fluid_modes.size()> fader_words{{
    {"Viscosity", "A thick brew holds the hand back."},
    {"Flow", "The current carries the hand along."},
    {"Resistance", "The current pushes the hand that goes against it."},
    {"Surface", "The skin holds the ladle up until it breaks through."},
    {"Wall", "The bowl pushes back."},
    {"Inertia", "The ladle has a mass of its own."},
    {"Recoil", "An ingredient that is dropped in gives a kick."},
}};

std::string names_of(const auto& chosen) {
    std::string words;
    for (std::size_t i = 0; i < haptics::fluid_modes.size(); ++i) {
        if (chosen(i)) words += text(words.empty() ? "" : ", ", haptics::fluid_modes[i].name);
    }
    return words;
}

std::string_view bare(std::string_view s) {
    const auto first = s.find_first_not_of(' ');
    if (first == std::string_view::npos) return {};
    return s.substr(first, s.find_last_not_of(' ') - first + 1);
}

void read_off(const ConfigTable& table, Faders& faders) {
    if (!table.has("off")) return;
    const auto words = table.string("off", off_words(faders));
    auto changed = faders;
    for (auto& fader : changed) fader.on = true;
    for (std::string_view remaining = words; !remaining.empty();) {
        const auto comma = std::min(remaining.find(','), remaining.size());
        const auto name = bare(remaining.substr(0, comma));
        remaining.remove_prefix(std::min(comma + 1, remaining.size()));
        const auto found = std::ranges::find(haptics::fluid_modes, name, &haptics::FluidMode::name);
        if (found == haptics::fluid_modes.end()) {
            table.report("off",
                         text("'off': '", name, "' is not one of ", names_of([](auto) { return true; })));
            return;
        }
        changed[static_cast<std::size_t>(found - haptics::fluid_modes.begin())].on = false;
    }
    faders = changed;
}

}  // namespace

std::string_view label_of_fader(std::size_t source) { return fader_words[source].label; }
std::string_view effect_of_fader(std::size_t source) { return fader_words[source].told; }

std::string percent_words(double share) { return text(std::round(1000 * share) / 10, " %"); }

double moved_share(double share, int steps, int in_all) {
    const auto current = static_cast<int>(std::lround(in_all * share));
    return static_cast<double>(std::clamp(current + steps, 0, in_all)) / in_all;
}

std::string shown(const Fader& fader) {
    const auto percent = percent_words(fader.share);
    return fader.on ? percent : text("off (", percent, ")");
}

void change(Fader& fader, int steps) { fader.share = moved_share(fader.share, steps, fader_steps); }

Faders read_faders(const ConfigTable& table, Faders faders) {
    for (std::size_t i = 0; i < faders.size(); ++i)
        faders[i].share = table.number(haptics::fluid_modes[i].name, {0, 1}, faders[i].share);
    read_off(table, faders);
    return faders;
}

std::string off_words(const Faders& faders) {
    return names_of([&](std::size_t i) { return !faders[i].on; });
}

void ask_for(const Faders& faders, input::DeviceSpec& device) {
    for (std::size_t i = 0; i < faders.size(); ++i) {
        const double share = faders[i].on ? faders[i].share : 0;
        device.set_fluid_percent(i, static_cast<std::uint32_t>(std::lround(100 * share)));
    }
}

}  // namespace thaum::game::inline settings

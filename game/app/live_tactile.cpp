#include "game/app/live_tactile.h"

#include <algorithm>
#include <cstdio>

namespace thaum::app {

LiveTactile::LiveTactile(MakeOutput make) : make_(std::move(make)) { apply(Settings{}); }

void LiveTactile::apply(const Settings& settings) {
    for (std::size_t p = 0; p < seats_.size(); ++p)
        seats_.at(p).gain = static_cast<float>(settings.players.at(p).rumble);
}

void LiveTactile::use_pad(std::uint32_t player, const render::PadState* pad) {
    auto& seat = seats_.at(player);
    if (pad == nullptr || !pad->present || pad->guid.empty()) {
        if (!seat.pad) return;
        seat.plays = false;
        seat.pad.reset();
        return seat.own->use(nullptr);
    }
    // Compared piece by piece, because this happens 250 times a second.
    const bool same = seat.pad && seat.pad->equal_one == pad->equal_one && seat.pad->guid == pad->guid &&
                      seat.pad->name == pad->system_name;
    if (same) return;
    seat.pad = {.guid = pad->guid, .name = pad->system_name, .equal_one = pad->equal_one};
    if (seat.own == nullptr) {
        seat.own = std::make_unique<input::TactilePlayer>();
        seat.player = seat.own.get();
    }
    seat.own->use(make_(*seat.pad));
    seat.plays = true;
}

void LiveTactile::tell_status() {
    for (std::size_t p = 0; p < seats_.size(); ++p) {
        auto& seat = seats_.at(p);
        if (seat.own == nullptr) continue;
        auto status = seat.own->status();
        // A player without a pad is no news, and no more is the pad that comes back.
        if (status.empty() || status == seat.told) continue;
        // That all is well is worth a line only after it was not.
        if (!seat.told.empty() || seat.own->report().times_opened == 0)
            std::fprintf(stderr, "player %zu: %s\n", p + 1, status.c_str());
        seat.told = std::move(status);
    }
}

input::TactileReport LiveTactile::report(std::uint32_t player) const {
    const auto& own = seats_.at(player).own;
    return own == nullptr ? input::TactileReport{} : own->report();
}

bool LiveTactile::feels(std::uint32_t player) const {
    const auto& seat = seats_.at(player);
    return seat.plays && seat.player.load()->is_open();
}

void LiveTactile::feel(std::uint32_t player, const tactile::TactileFrame& frame) {
    auto& seat = seats_.at(player);
    if (!seat.plays) return;
    auto scaled = frame;
    const float gain = seat.gain;
    for (auto& amplitude : scaled.amplitude) amplitude *= gain;
    seat.player.load()->feel(scaled);
}

}  // namespace thaum::app

#include "game/live/tactile.h"

#include <algorithm>

#include "core/text.h"

namespace thaum::game::inline live {

LiveTactile::LiveTactile(MakeOutput make, MakeJacket make_jacket)
    : make_(std::move(make)), make_jacket_(std::move(make_jacket)) {
    apply(Settings{});
}

void LiveTactile::apply(const Settings& settings) {
    for (std::uint32_t p = 0; p < seats_.size(); ++p) {
        auto& seat = seats_.at(p);
        seat.gain = static_cast<float>(settings.players.at(p).rumble);
        const auto& body = settings.players.at(p).body.values;
        for (std::size_t i = 0; i < body.size(); ++i) seat.faders.at(i) = body.at(i);
        seat.sound = settings.players.at(p).jacket_sound;
        seat.sound_of = settings.players.at(p).jacket_sound_of;
        seat.figure = settings.players.at(p).figure;
        use_jacket(p, settings.players.at(p).jacket);
    }
}

void LiveTactile::use_pad(std::uint32_t player, const input::PadState* pad) {
    auto& seat = seats_.at(player);
    const bool none = pad == nullptr || !pad->present;
    if (seat.pad == (none ? std::string_view() : pad->path)) return;
    seat.pad = none ? std::string() : pad->path;
    seat.motors.use(seat.pad.empty() ? nullptr : make_(*pad));
}

void LiveTactile::use_jacket(std::uint32_t player, const std::string& words) {
    auto& seat = seats_.at(player);
    if (seat.jacket_words == words) return;
    seat.jacket_words = words;
    const auto jacket = parse_jacket(words).value_or(Jacket{});
    // While the next jacket is being connected there is no layout, so that no frame of the former layout
    // reaches it.
    seat.layout = &no_layout;
    seat.jacket.use(make_jacket_(jacket, player));
    seat.layout = seat.own_motors > 0 && jacket ? &own_layout : &jacket.layout();
}

void LiveTactile::use_own_layout(std::uint32_t player, std::size_t motors) {
    seats_.at(player).own_motors = motors;
}

std::size_t LiveTactile::motors_of_seat(const Seat& seat) {
    const auto* layout = seat.layout.load();
    return layout == &own_layout ? seat.own_motors : layout->motors;
}

void LiveTactile::Socket::use(std::unique_ptr<input::TactileOutput> output) {
    if (output == nullptr && own == nullptr) return;
    if (output == nullptr) plays = false;
    if (own == nullptr) {
        own = std::make_unique<input::TactilePlayer>();
        player = own.get();
    }
    const bool any = output != nullptr;
    own->use(std::move(output));
    plays = any;
}

void LiveTactile::Socket::tell_status(std::size_t number) {
    // A player who never had such an output (motors or a jacket) has no state to print.
    if (own != nullptr) told.tell(text("player ", number, ": "), *own);
}

input::TactileReport LiveTactile::Socket::report() const {
    return own == nullptr ? input::TactileReport{} : own->report();
}

void LiveTactile::tell_status() {
    for (std::size_t p = 0; p < seats_.size(); ++p) {
        seats_.at(p).motors.tell_status(p + 1);
        seats_.at(p).jacket.tell_status(p + 1);
    }
}

std::string LiveTactile::jacket_state(std::uint32_t player) const {
    const auto& jacket = seats_.at(player).jacket;
    const auto status = jacket.plays ? jacket.own->status() : std::string();
    return status.empty() ? status : text(status, ".");
}

input::TactileReport LiveTactile::report(std::uint32_t player) const {
    return seats_.at(player).motors.report();
}

input::TactileReport LiveTactile::jacket_report(std::uint32_t player) const {
    return seats_.at(player).jacket.report();
}

bool LiveTactile::feels(std::uint32_t player) const { return seats_.at(player).motors.is_open(); }

tactile::Faders LiveTactile::faders(std::uint32_t player) const {
    tactile::Faders faders;
    const auto& values = seats_.at(player).faders;
    for (std::size_t i = 0; i < values.size(); ++i) faders.values.at(i) = values.at(i);
    return faders;
}

namespace {

tactile::TactileFrame scaled(tactile::TactileFrame frame, float gain) {
    for (auto& amplitude : frame.amplitude) amplitude *= gain;
    return frame;
}

}  // namespace

void LiveTactile::feel(std::uint32_t player, const tactile::TactileFrame& frame) {
    auto& seat = seats_.at(player);
    if (seat.motors.plays) seat.motors.player.load()->feel(scaled(frame, seat.gain));
}

void LiveTactile::try_out(std::uint32_t player, const tactile::TactileFrame& frame) {
    auto& seat = seats_.at(player);
    if (seat.motors.plays) seat.motors.player.load()->try_out(scaled(frame, seat.gain));
}

void LiveTactile::try_out_jacket(std::uint32_t player, const tactile::TactileFrame& frame) {
    auto& seat = seats_.at(player);
    if (seat.jacket.plays && frame.count == motors_of_seat(seat)) seat.jacket.player.load()->try_out(frame);
}

std::string_view LiveTactile::jacket_layout(std::uint32_t player) const {
    const auto& seat = seats_.at(player);
    return seat.jacket.is_open() ? seat.layout.load()->name : std::string_view();
}

FeltSoundWish LiveTactile::felt_sound(std::uint32_t player) const {
    const auto& seat = seats_.at(player);
    return {seat.sound, seat.sound_of};
}

void LiveTactile::feel_jacket(std::uint32_t player, const tactile::TactileFrame& frame) {
    auto& seat = seats_.at(player);
    if (seat.jacket.plays && frame.count == motors_of_seat(seat)) seat.jacket.player.load()->feel(frame);
}

}  // namespace thaum::game::inline live

// game/live/seats.h: seats, the places of the players in a match. The command line or the start screen
// chooses the device of each seat. Taking a seat makes the DeviceSpec for the log's header, and the collector
// of the player's input.
#pragma once
#include "game/live/fader_input.h"
#include "game/live/live.h"
#include "game/menu/menu.h"
#include "input/collector.h"

namespace thaum::game::inline live {

using input::Pads;

using Seats = std::array<Seat, players>;

/// One player's seat with its devices.
struct TakenSeat {
    Seat seat;
    input::DeviceSpec spec;
    std::unique_ptr<input::HandsCollector> hands;  ///< collector of the player's input; null for a bot
    std::unique_ptr<FaderInput> faders;  ///< changes of the forces' strengths as input; null for a bot
};
using TakenSeats = std::array<TakenSeat, players>;

/// Seats (places of players) of the command line. Each pad goes to the first seat that wants one.
Seats planned_seats(Seats seats, const Pads& pads);
/// Seats of the start screen. A bot takes an empty seat, and in practice a dummy takes the second one.
Seats joined_seats(const MenuState& menu, const MenuContext& context, bool practice);

TakenSeats take_seats(const Settings& settings, const Seats& seats);
/// Passes changed strengths of the forces (faders) from the settings on to the match that runs.
void want_faders(const Settings& settings, const TakenSeats& seats);

/// Whether a person plays this seat with a pad.
bool has_pad(const TakenSeat& seat);
/// The first player who is a person.
std::optional<std::uint32_t> first_person(const TakenSeats& seats);

}  // namespace thaum::game::inline live

// game/scenario/verbs.h: what a scenario can say. It acts through the players' own commands and reads what a player could
// see; times are seconds of the match, places metres ({x, y, z} or {x = , y = , z = }), players 1 and 2.
//
//     match{arena = , rules = "thaum" | "classic", match = "quick" | "standard", seed = , set = {"quick.kills=1"},
//           players = {"script", "bot 1"}, forces = {100, 0}, weights = {50, 100}, blows = {0, 100},
//           modes = {{flow = 0, wall = 50}, {}}, arms = {true, false}}
//                               first, and once; forces: % of what the devices can; weights, blows: % of what is felt of a
//                               carried thing; modes: likewise of a brew that is stirred, by haptics::fluid_modes; arms: whose
//                               hand holds a real one, which the script moves
//     wizard(n)                 hold(button), release(button), press(button [, seconds]), move(strafe, forward) in -1..1,
//                               stop(), look(right, up) in degrees, aim(place | wizard | thing), trigger(share): how far fire is
//                               pulled while it is held, in 0..1: through the device
//                               position() (feet), centre(), eye(), velocity(), yaw(), pitch() in rad, health(), energy(),
//                               shots(), readiness() of the wand in hand in 0..1, kills(), deaths(), dead(), grounded(), shielded()
//                               reach(place [, speed]): the arm's tip goes there, in m of its frame and m/s, or jumps;
//                               told(): N, by the arm's own thread in its last tick
//                               place(feet), face(yaw, pitch) in degrees: set the scene
//     wait(seconds), tick([n]), time(), now() in ticks, wait_until(condition, seconds), pause(n)
//     stall(seconds)            the match stands still, arms go on; in the ticks that follow it makes up for it
//     expect(condition, message), expect_near(value, wanted, tolerance, message), fail(message)
//     events(kind | {kind = , subject = , by = }), expect_event{kind = , subject = , by = , within = seconds}
//     spawn{kind = "box" | "sphere" | "cylinder", size = {x, y, z} | radius = , height = , mass = , at = , velocity = ,
//           surface = , friction = , restitution = }: a thing, with position(), velocity(), place(at [, velocity]),
//                               push(impulse) in N s, there(); clear_props(): set the scene
//     round_over() -> over, "kills" | "time", winner; match_over() -> over, {rounds won}; round_number()
//     power_ups()               a list of {kind = "vial" | "heart" | "spark", place = , there = , back_in = seconds}
//     missiles()                a list of {position = , velocity = , player = , size = }
//     deeds(n, cause)           {shots = , hits = , kills = , own_deaths = , damage = } of player n by "bolt", "blast", "lob",
//                               "blow" or "fall"
//     state(), changes(before [, after])     what differs: a list of {component, entity, field, before, after}
//     trace(name, columns)      a CSV line each tick: "1.x", "2.health", "t1.speed" (of the first thing spawned)
//     picture{split = "side_by_side" | "top_bottom", name = }   colour(x, y), mean(x0, y0, x1, y1), colours(x0, y0, x1, y1):
//                               of the picture's width and height, from the top left corner, in 0..1
//     on_screen(words)          whether they stand over the views
//     check_seek{ticks = {...} | count = , seed = }, check_late{seed = }, check_threads(count)
//     distance(a, b), length(v), log(...)
//
// Verbs that set the scene are no player's deeds: what follows cannot be replayed from its input, so such a scenario leaves
// no log and cannot check_seek, check_late or check_threads.
#pragma once
#include "game/scenario/play.h"
#include "game/scenario/sandbox.h"

namespace thaum::game {

/// The play must outlive the sandbox.
Expected<void> add_verbs(Sandbox& sandbox, Play& play);

}  // namespace thaum::game

// game/scenario/verbs.h: the verbs of scenarios, which are the functions that a script can call. A scenario
// acts through the players' own commands and reads what a player could see. Times are seconds of the match.
// Places are metres, as {x, y, z} or {x = , y = , z = }. Players are 1 and 2.
//
//     match{arena = , rules = "thaum" | "classic", match = "quick" | "standard", seed = ,
//           set = {"quick.kills=1"}, players = {"script", "bot 1"}, forces = {100, 0},
//           weights = {50, 100}, blows = {0, 100}, modes = {{flow = 0, wall = 50}, {}}, arms = {true, false},
//           free_casting = {true, false}}
//                         comes first, and once.
//                         forces: share of the device's force (%)
//                         weights, blows: share of a carried thing's weight and blows on the hand (%)
//                         modes: shares of a stirred brew's forces, by haptics::fluid_modes (%)
//                         arms: true gives the player a simulated arm of a real device, moved by the script
//                         free_casting: true lets the player cast without a button
//     wizard(n)           the wizard of player n, with these functions:
//       hold(button), release(button), press(button [, seconds])
//       move(strafe, forward) in -1..1, stop()
//       stick(right, up)  deflection of the stick that turns the view, in -1..1, until it is changed
//       chord(slot [, harsh])
//                         presses a wand's key while Trace is held; harsh: fire as well
//       trace_over(points)
//                         draws a list of {t = , x = , y = } with Trace held (s, m)
//       free_casting()    what was cast or almost cast without a button: {cast_at = , missed_at = , like = ,
//                         probability = , reason = }
//       reading()         the last reading of a stroke: {gesture = (nil: none), probability = , force = ,
//                         turns = , at = }
//       look(right, up) in degrees, aim(place | wizard | thing)
//       trigger(share)    pull of the device's trigger while fire is held, in 0..1
//       position() (feet), centre(), eye(), velocity(), yaw(), pitch() in rad, health(), energy(), shots(),
//       readiness() of the wand in hand in 0..1, kills(), deaths(), dead(), grounded(), shielded(),
//       focus(), ward() (harm that the wizard's shield can absorb)
//       cast(shape [, how])
//                         draws "circle", "v", "s", "star" or a list of places with Trace held;
//                         how: {size = width in m, seconds, times = turns in one stroke}
//       reach(place [, speed])
//                         moves the arm's tip (m, m/s, arm's frame); without a speed the tip jumps
//       scry(keys ...)    holds Stir at the orb and turns on the haptic modes of these keys
//       steer(place, speed)
//                         at the orb or a crystal: moves the hand for a tick towards a place (m, m/s, device
//                         frame); returns the distance that is left
//       hand_to(place, speed [, condition])
//                         steers until the hand is there or the condition holds
//       scrying()         nil, or {place = , force = , distance = from the hidden core, near = , drawing = ,
//                         modes = names}
//       core()            place of the hidden core nearest to the orb's middle, and its direction (device
//                         frame)
//       curve(key, property)
//                         strength that a haptic mode has at a value of its property (N)
//       told()            force computed by the arm's own thread in its last tick (N)
//       place(feet), face(yaw, pitch) in degrees: set the scene
//     wait(seconds), tick([n]), time(), now() in ticks, wait_until(condition, seconds), pause(n)
//     stall(seconds)      stops the match while arms go on; the match catches up in the ticks that follow
//     expect(condition, message), expect_near(value, wanted, tolerance, message), fail(message)
//     events(kind | {kind = , subject = , by = }), expect_event{kind = , subject = , by = , within = seconds}
//                         what happened, as {kind = , time = , with = , subject = , by = , amount = ,
//                         detail = , place = }; "recipe_told" also has ingredients = names in their order
//     spawn{kind = "box" | "sphere" | "cylinder", size = {x, y, z} | radius = , height = , mass = , at = ,
//           velocity = , surface = , friction = , restitution = }
//                         sets the scene: adds a thing with position(), velocity(), place(at [, velocity]),
//                         push(impulse) in N s, and there(), which is false once it is gone
//     clear_props()       sets the scene: removes the loose things
//     round_over() -> over, "kills" | "time", winner; match_over() -> over, {rounds won}; round_number()
//     power_ups()         a list of {kind = "vial" | "heart" | "spark", place = , there = ,
//                         back_in = seconds}
//     fogs()              a list of {place = , radius = , left = seconds, player = }
//     generated_stroke(figure, user, number, effort)
//                         a list of {t = , x = , y = } by a generated user (gesture/generated_users.h)
//     missiles()          a list of {position = , velocity = , player = , size = }
//     deeds(n, cause)     {shots = , hits = , kills = , own_deaths = , damage = } of player n; cause: "bolt",
//                         "blast", "lob", "blow" or "fall"
//     state(), changes(before [, after])
//                         differences as a list of {component, entity, field, before, after}
//     trace(name, columns)
//                         writes a CSV line each tick; columns: "1.x", "2.health"; "t1.speed" is the first
//                         thing's
//     picture{split = "side_by_side" | "top_bottom", name = }
//     colour(x, y), mean(x0, y0, x1, y1), colours(x0, y0, x1, y1)
//                         colours of the picture; coordinates are 0..1 from the top left corner
//     on_screen(words)    true if the words are shown over the views
//     check_seek{ticks = {...} | count = , seed = }, check_late{seed = }, check_threads(count)
//     senses{layouts = {"x40", "pad"}, sound = true}
//                         begins to hear and feel the match, on the figure of the view and on layouts of
//                         assets/tactile/layouts; sound: also mixes what is heard, as loudspeakers play it
//     body(n [, layout [, age]])
//                         cells of a layout (default: "abstract_4x5", the figure) as a list of {at = ,
//                         felt = in 0..1, hz = }; at: body frame, x right, y up, z front (m); age: time since
//                         the link to the device died (s), for what the device still plays then
//     body_counts(n [, layout])
//                         {offered = , started = , merged = }: effects since the beginning
//     heard(n)            lines in words as a list of {line = , words = , side = , important = }, the oldest
//                         first
//     sound()             what was mixed since the last call: {db = of the loudest 50 ms, bands = {dB of 24
//                         bands}}
//     sounds(), loopback(name)
//                         names of all sounds; one of them alone as it is mixed: {db = , bands = , like =
//                         the name of the sound that it resembles most}
//     event_rows()        kinds of event with a sound or an effect, as a list of {kind = , sound = ,
//                         tactile = }
//     happen{kind = , subject = , by = , amount = , at = }
//                         sets the scene: records an event that did not happen, to be heard and felt
//     check_senses{layouts = , quit = seconds}
//                         plays the same frames again, with and without hearing and feeling; quit: time after
//                         which hearing and feeling are ended
//     distance(a, b), length(v), plus(a, b [, share]), dot(a, b), unit(v), log(...)
//
// Verbs that set the scene are not actions of a player, so the input alone cannot replay the match. A
// scenario that uses them leaves no log and cannot use check_seek, check_late, check_threads or check_senses.
#pragma once
#include "game/scenario/sandbox.h"

namespace thaum::game::inline scenario {

struct Play;

/// Adds all verbs to the sandbox. `play` must outlive the sandbox.
Expected<void> add_verbs(Sandbox& sandbox, Play& play);

}  // namespace thaum::game::inline scenario

// Menu page: the pause of a match, of the practice range and of the lessons there (the Apprentice).
#include "core/text.h"
#include "game/menu/page.h"

namespace thaum::game::inline menu {
namespace {

void go_on(const RowPress& press) { press.state.request = MenuRequest::go_on; }

std::string_view help_of_go_on(const MenuContext& context) {
    if (!context.missing.empty()) return "Plays on once every player has a device.";
    if (context.apprentice || context.practice) return "Closes this menu and plays on for everybody.";
    return "Plays on for everybody. Hold Stir at the cauldron, at the orb below the violet light, or at a "
           "crystal below a blue light.";
}

void add_go_on_rows(const MenuContext& context, Rows& rows) {
    rows.push_back({.look = {.label = "Go on",
                             .help = std::string(help_of_go_on(context)),
                             .dim = !context.missing.empty()},
                    .confirm = go_on});
    if (context.half_for.empty()) return;
    rows.push_back(
        {.look = {.label = text("Keypad and arrows for ", context.half_for),
                  .help = "Gives this player half of the keyboard until a button of a pad is pressed."},
         .confirm = [](const RowPress& press) { press.state.request = MenuRequest::take_half; }});
}

// The range and the Apprentice ------------------------------------------------------------------------------

void add_range_rows(const MenuState& s, Rows& rows) {
    rows.push_back(
        {.look = {.label = "Dummy",
                  .help = "Lets the dummy stand still, walk to and fro, or shoot back.",
                  .value = std::string(dummy_names[s.dummy]),
                  .longest_value = longest({dummy_names.begin(), dummy_names.end()}),
                  .adjustable = true},
         .turn = [](const RowPress& press, int way) { turn(press.state.dummy, dummy_names, way); }});
    rows.push_back({.look = {.label = "Energy of the wands",
                             .help = "Keeps every wand full, or lets shots use it up as in a match.",
                             .value = s.range.endless_energy ? "endless" : "as in a match",
                             .longest_value = "as in a match",
                             .adjustable = true},
                    .turn = [](const RowPress& press, int) {
                        auto& endless = press.state.range.endless_energy;
                        endless = !endless;
                    }});
    rows.push_back({.look = {.label = "Effects of the brew",
                             .help = "Lets the brew slow, lift and scald wizards, or leave them alone.",
                             .value = s.range.harmless_brew ? "off" : "as in a match",
                             .longest_value = "as in a match",
                             .adjustable = true},
                    .turn = [](const RowPress& press, int) {
                        auto& harmless = press.state.range.harmless_brew;
                        harmless = !harmless;
                    }});
}

/// Lets the next pause open at this row, since players often draw or forget a gesture several times.
void come_back_here(MenuState& s) { s.pause_row = s.pages.back().cursor; }

void draw_gesture(const RowPress& press) {
    come_back_here(press.state);
    ask_match(press.state, DrawGesture{static_cast<std::uint32_t>(press.state.gesture)});
}

void stop_drawing(const RowPress& press) {
    come_back_here(press.state);
    ask_match(press.state, StopDrawing{});
}

void forget_gesture(const RowPress& press) {
    come_back_here(press.state);
    press.state.request = MenuRequest::forget_gesture;
}

void add_gesture_rows(const MenuState& s, const MenuContext& context, Rows& rows) {
    if (context.gestures.empty()) return;
    std::vector<std::string> names;
    for (const auto& gesture : context.gestures) names.push_back(capitalised(gesture));
    const auto& name = names[s.gesture % names.size()];
    if (context.drawn_gesture > 0 && context.drawn_gesture <= names.size())
        rows.push_back({.look = {.label = text("Give up drawing ", names[context.drawn_gesture - 1]),
                                 .help = "Ends the drawing of an own gesture. Nothing is saved."},
                        .confirm = stop_drawing});
    else
        rows.push_back(
            {.look = {.label = "Own gesture",
                      .help =
                          "Left and right choose a gesture. A press lets you draw it your way, three times.",
                      .value = name,
                      .longest_value = longest({names.begin(), names.end()}),
                      .adjustable = true},
             .confirm = draw_gesture,
             .turn = [](const RowPress& press, int way) {
                 turn(press.state.gesture, press.context.gestures, way);
             }});
    rows.push_back(
        {.look = {.label = text("Usual ", name, " again"),
                  .help = "Forgets your own strokes for this gesture, so that the game's count again."},
         .confirm = forget_gesture});
}

void add_lesson_rows(Rows& rows) {
    rows.push_back(
        {.look = {.label = "Skip this step", .help = "Goes on to the next step of the Apprentice."},
         .confirm = [](const RowPress& press) { ask_match(press.state, SkipStep{}); }});
    rows.push_back(
        {.look = {.label = "Repeat this step", .help = "Begins this step of the Apprentice again."},
         .confirm = [](const RowPress& press) { ask_match(press.state, RepeatStep{}); }});
}

// The page --------------------------------------------------------------------------------------------------

void add_pause_rows(const MenuState& s, const MenuContext& context, Rows& rows) {
    add_go_on_rows(context, rows);
    if (context.apprentice)
        add_lesson_rows(rows);
    else if (context.practice) {
        add_range_rows(s, rows);
        add_gesture_rows(s, context, rows);
    }
    add_page_rows(rows);
    rows.push_back(
        {.look = {.label = label_of_restart(context),
                  .help = context.practice ? "Puts the arena and the score back to their beginning."
                                           : "Gives up this match and begins another with the same players."},
         .confirm = [](const RowPress& press) { press.state.request = MenuRequest::restart; }});
    const auto leave =
        context.practice ? text("Leave the ", name_of_play(context)) : std::string("End this match");
    rows.push_back(
        {.look = {.label = context.ends_match ? leave : std::string("Quit"),
                  .help = context.ends_match ? "Returns to the start screen." : "Ends the program."},
         .confirm = [](const RowPress& press) { press.state.request = MenuRequest::leave; }});
}

std::string pause_hint(const MenuState&, const MenuContext& context, const Row&) {
    return text("choose: arrows, W and S, mouse or pad    confirm: Enter, A, click",
                context.missing.empty() ? "    go on: Esc, Start" : "");
}

const PageRegistration pause_page{{
    .name = page_name::pause,
    .title = [](const MenuState& s, const MenuContext&) { return s.head; },
    .add_rows = add_pause_rows,
    .line = [](const MenuState& s, const MenuContext&, const Row&) { return s.line; },
    .hint = pause_hint,
    .fault = pad_fault,
    .leave = [](MenuState& s, const Device&, const Rows&) { s.request = MenuRequest::go_on; },
    .back_row = false,
}};

}  // namespace
}  // namespace thaum::game::inline menu

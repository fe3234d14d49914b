// Menu page: the start screen, where players take seats, choose a match and begin it.
#include <algorithm>

#include "core/text.h"
#include "game/menu/page.h"

namespace thaum::game::inline menu {
namespace {

using input::DeviceKind;

// Seats and the match ---------------------------------------------------------------------------------------

/// Fault of a file that was chosen for the match; empty: all chosen files can be played. The practice range
/// has no bot.
std::string fault_of_choice(const MenuState& s, const MenuContext& context, MenuRequest request) {
    for (const auto* chosen : {&context.rules[s.rules], &context.arenas[s.arena]})
        if (!chosen->fault.empty()) return chosen->fault;
    return request == MenuRequest::start && joined(s) < players ? context.bots[s.bot].fault : std::string();
}

/// Requests a match, unless a file that was chosen for it is broken.
void start(MenuState& s, MenuRequest request, const MenuContext& context) {
    s.note = fault_of_choice(s, context, request);
    if (s.note.empty()) s.request = request;
}

/// Lets a device join with its first press, and starts the match with its second one.
void join_or_start(MenuState& s, const MenuContext& context, const Device& device) {
    if (seat_of(s, device))
        start(s, MenuRequest::start, context);
    else
        join(s, device);
}

/// Requests the practice range, or the lessons there (the Apprentice), for one player; the place of the other
/// player stays empty.
void practise(const RowPress& press, MenuRequest request) {
    press.state.seats = {press.device};
    start(press.state, request, press.context);
}

void leave_start(MenuState& s, const Device& device, const Rows& rows) {
    if (const auto seat = seat_of(s, device)) {
        s.seats[*seat].reset();
    } else if (device.kind == DeviceKind::pad) {
        join(s, device);  // the button lets its pad join, as every other button of a pad does
    } else {
        s.pages.back().cursor = s.pages.back().middle = rows.size() - 1;  // moves to Quit, the last row
        s.chooser = device;
    }
}

// Choices among data files ----------------------------------------------------------------------------------

std::string longest_label(const std::vector<MenuContext::Named>& list) {
    std::vector<std::string_view> labels;
    for (const auto& one : list) labels.emplace_back(one.label);
    return longest(labels);
}

/// The row of a choice among data files. A broken file says what is wrong with it, and cannot be played.
MenuRow choice_row(std::string label, const std::string& help, const std::vector<MenuContext::Named>& list,
                   std::size_t chosen) {
    const auto& one = list[chosen];
    return {.label = std::move(label),
            .help = !one.fault.empty()   ? one.fault
                    : !one.words.empty() ? one.words
                                         : help,
            .value = one.label,
            .longest_value = longest_label(list),
            .adjustable = true,
            .dim = !one.fault.empty()};
}

// The functions below choose among data files. A choice is kept in the settings for the next start of the
// program, unless its file is broken.

void turn_bot(const RowPress& press, int way) {
    auto& s = press.state;
    turn(s.bot, press.context.bots, way);
    const auto& chosen = press.context.bots[s.bot];
    if (chosen.fault.empty()) s.settings.last.bot = chosen.name;
}

void turn_rules(const RowPress& press, int way) {
    auto& s = press.state;
    turn(s.rules, press.context.rules, way);
    const auto& chosen = press.context.rules[s.rules];
    if (chosen.fault.empty()) s.settings.last.match = chosen.name;
}

void turn_arena(const RowPress& press, int way) {
    auto& s = press.state;
    turn(s.arena, press.context.arenas, way);
    const auto& chosen = press.context.arenas[s.arena];
    if (chosen.fault.empty()) s.settings.last.arena = chosen.name;
}

/// A row that opens the page of mutators, and says which are on.
Row mutators_row(const MenuState& s, const MenuContext& context) {
    std::string on;
    for (const auto& one : context.mutators)
        if (std::ranges::find(s.mutators, one.name) != s.mutators.end())
            on += text(on.empty() ? "" : ", ", one.label);
    return link_to("mutators", text("Mutators: ", on.empty() ? "none" : on),
                   "Changes the rules of the next duel: each is on or off.");
}

void add_choice_rows(const MenuState& s, const MenuContext& context, Rows& rows) {
    auto bot = choice_row("Bot", "Sets who plays if nobody joins.", context.bots, s.bot);
    bot.adjustable = context.bots.size() > 1;
    bot.dim = bot.dim || joined(s) == players;
    rows.push_back({.look = std::move(bot), .turn = turn_bot});
    if (context.rules.size() > 1)
        rows.push_back({.look = choice_row("Match", "Sets how many kills win, and how long a round lasts.",
                                           context.rules, s.rules),
                        .turn = turn_rules});
    if (context.arenas.size() > 1)
        rows.push_back(
            {.look = choice_row("Arena", "Sets the place of the duel, which is shown behind this menu.",
                                context.arenas, s.arena),
             .turn = turn_arena});
    if (!context.mutators.empty()) rows.push_back(mutators_row(s, context));
}

// Rows ------------------------------------------------------------------------------------------------------

std::string duel_label(const MenuState& s) {
    switch (joined(s)) {
        case 0: return "Duel: press any button to join";
        case 1: return "Start against the bot";
        default: return "Start the duel";
    }
}

Row apprentice_row() {
    return {.look = {.label = "Apprentice (3 min)",
                     .help = "Teaches one player everything, step by step. Leave it at any time."},
            .confirm = [](const RowPress& press) { practise(press, MenuRequest::apprentice); },
            .for_one = true};
}

void add_start_rows(const MenuState& s, const MenuContext& context, Rows& rows) {
    if (context.first_start) rows.push_back(apprentice_row());
    rows.push_back(
        {.look = {.label = duel_label(s),
                  .help = "The first press of a device joins, and the next one starts."},
         .confirm = [](const RowPress& press) { join_or_start(press.state, press.context, press.device); }});
    add_choice_rows(s, context, rows);
    if (!context.first_start) rows.push_back(apprentice_row());
    rows.push_back({.look = {.label = "Range: practise on a dummy",
                             .help = "Plays alone, without an end and without a recording."},
                    .confirm = [](const RowPress& press) { practise(press, MenuRequest::range); },
                    .for_one = true});
    add_page_rows(rows);
    rows.push_back({.look = {.label = "Quit", .help = "Ends the program."},
                    .confirm = [](const RowPress& press) { press.state.request = MenuRequest::quit; }});
}

// Words -----------------------------------------------------------------------------------------------------

std::string start_line(const MenuState& s, const MenuContext&, const Row& row) {
    if (starts_at_once(s, row)) return "press Enter or A to start, or any other key to join";
    switch (joined(s)) {
        case 0: return "press to join";
        case 1: return "press again to start, or a second player joins";
        default: return "press again to start";
    }
}

std::string start_hint(const MenuState& s, const MenuContext&, const Row& row) {
    if (starts_at_once(s, row))
        return "choose: arrows, W and S    start: Enter, A, click, keypad 0    "
               "join: any other key or button";
    return "choose: arrows, W and S    join: Enter, click, any pad button, keypad 0    "
           "give up a seat: Esc, B, keypad *";
}

std::string start_fault(const MenuContext& context) {
    return context.start_fault.empty() ? pad_fault(context) : context.start_fault;
}

const PageRegistration start_page{{
    .name = page_name::start,
    .title = [](const MenuState&, const MenuContext&) { return std::string("Thaum"); },
    .add_rows = add_start_rows,
    .line = start_line,
    .hint = start_hint,
    .fault = start_fault,
    .leave = leave_start,
    .other = join_or_start,
    .seats = true,
    .back_row = false,
}};

}  // namespace
}  // namespace thaum::game::inline menu

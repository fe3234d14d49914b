#include "game/stations/cauldron/potions.h"

#include <algorithm>
#include <cmath>

#include "game/context/effects.h"
#include "game/stations/cauldron/brewing.h"

namespace thaum::game::inline stations {
namespace {

/// Time after the beginning of a round at which players are shown the order of ingredients in recipes that
/// have a random one.
constexpr Tick told_after = ticks(1.0);

void note_step(MatchContext& context, const Cauldron& cauldron, std::uint32_t player, Tick tick) {
    record(context, {.tick = tick,
                     .kind = EventKind::brew_step,
                     .subject = player,
                     .by = player,
                     .detail = cauldron.strokes_done,
                     .place = cauldron.middle});
}

void note_fault(MatchContext& context, const Cauldron& cauldron, std::uint32_t player, BrewFault fault,
                Tick tick) {
    record(context, {.tick = tick,
                     .kind = EventKind::brew_fault,
                     .subject = player,
                     .by = player,
                     .detail = static_cast<std::uint32_t>(fault),
                     .place = cauldron.middle});
}

/// Makes a potion impossible until the cauldron is filled again.
void spoil_recipe(MatchContext& context, Cauldron& cauldron, std::uint32_t player, BrewFault fault,
                  Tick tick) {
    cauldron.fault = fault;
    note_fault(context, cauldron, player, fault, tick);
}

bool begins_with(const RecipeOrder& order, const Contents& contents, std::size_t count) {
    if (order.count < count) return false;
    for (std::size_t i = 0; i < count; ++i)
        if (order.steps[i].ingredient != contents[i]) return false;
    return true;
}

// ---- ingredients ------------------------------------------------------------------------------------------

/// Fault of dropping an ingredient into a brew that already has ingredients; none if it is the next one of a
/// recipe.
BrewFault fault_of_drop(const MatchContext& context, const Cauldron& cauldron, std::uint32_t player,
                        std::uint32_t ingredient) {
    const auto open = recipes_open_to(context.data, context.world, cauldron, player);
    const auto before = ingredients_in(cauldron);
    auto fault = BrewFault::order;
    for (std::size_t i = 0; i < open.count; ++i) {
        const auto order = order_of(context.data.recipes[open.numbers[i]], context.world, player);
        if (before >= order.count || order.steps[before].ingredient != ingredient) continue;
        if (before == 0) return BrewFault::none;
        const auto& window = order.steps[before - 1];
        if (cauldron.reached >= window.least && cauldron.reached <= window.most) return BrewFault::none;
        fault = cauldron.reached < window.least ? BrewFault::early : BrewFault::late;
    }
    return fault;
}

// ---- strokes ----------------------------------------------------------------------------------------------

/// The recipe whose ingredients are all in the brew, so that strokes are next; null if there is none.
const Recipe* finished_mix(const MatchContext& context, const Cauldron& cauldron, std::uint32_t player) {
    const auto open = recipes_open_to(context.data, context.world, cauldron, player);
    for (std::size_t i = 0; i < open.count; ++i) {
        const auto& recipe = context.data.recipes[open.numbers[i]];
        if (order_of(recipe, context.world, player).count == ingredients_in(cauldron)) return &recipe;
    }
    return nullptr;
}

/// Fault of a stroke that comes from the brew and not from the drawing, such as another owner of the brew;
/// none if a recipe waits for a stroke.
BrewFault fault_of_brew(const Cauldron& cauldron, const Recipe* recipe, std::uint32_t player) {
    if (cauldron.begun == 0) return BrewFault::unfinished;
    if (cauldron.owner != player) return BrewFault::foreign;
    if (cauldron.fault != BrewFault::none) return BrewFault::off;
    return recipe == nullptr ? BrewFault::unfinished : BrewFault::none;
}

BrewFault fault_of_moment(const Cauldron& cauldron, double begun_at, const RecipeIngredient& window) {
    if (cauldron.strokes_done > 0) return BrewFault::none;
    if (cauldron.reached < window.least) return BrewFault::soon;
    return begun_at > window.most ? BrewFault::late : BrewFault::none;
}

/// Name of a player's gesture by its number; empty for an unknown number.
std::string_view gesture_name(const MatchContext& context, std::uint32_t player, std::uint32_t number) {
    const auto* gestures = gestures_of(context, player);
    return gestures == nullptr ? std::string_view() : gestures->name(number);
}

/// Fault in the drawing of a stroke: its gesture, sense of rotation or force. `gesture`: name of the
/// recognised gesture.
BrewFault fault_of_stroke(const RecipeStroke& wanted, std::string_view gesture,
                          const StrokeReading& reading) {
    if (gesture != wanted.gesture) return BrewFault::gesture;
    if (wanted.sense == CircleSense::clockwise && reading.turns < 0) return BrewFault::sense;
    if (wanted.sense == CircleSense::counterclockwise && reading.turns > 0) return BrewFault::sense;
    if (reading.force < wanted.min_force) return BrewFault::gentle;
    return reading.force > wanted.max_force ? BrewFault::hard : BrewFault::none;
}

/// How often a stroke counts: once, or once for each whole circle, at most as often as the recipe still
/// requires this gesture.
std::uint32_t counts_for(const Recipe& recipe, std::uint32_t done, const StrokeReading& reading) {
    constexpr double nearly = 0.25;  // a circle with at most this share missing counts as whole
    const auto whole =
        static_cast<std::uint32_t>(std::clamp(std::floor(std::abs(reading.turns) + nearly), 1.0, 100.0));
    const auto* wanted = next_stroke(recipe, done);
    std::uint32_t count = 0;
    while (count < whole && next_stroke(recipe, done + count) == wanted) ++count;
    return count;
}

// ---- success ----------------------------------------------------------------------------------------------

/// Lets the wizard drink the potion, which also changes the brew.
void succeed(MatchContext& context, Cauldron& cauldron, ecs::Entity wizard, const Recipe& recipe, Tick tick) {
    const auto number = static_cast<std::uint32_t>(&recipe - context.data.recipes.data());
    const auto player = std::as_const(context.world).get<Wizard>(wizard).player;
    forget_filling(cauldron);
    cauldron.spoilt = 1;
    cauldron.potion = number;
    cauldron.potion_until = tick + recipe.fluid.lasts;
    record(context, {.tick = tick,
                     .kind = EventKind::potion,
                     .subject = player,
                     .by = player,
                     .detail = number,
                     .amount = seconds(longest_of(recipe.effects)),
                     .place = cauldron.middle});
    begin_effects(context, wizard, recipe.effects, {.tick = tick, .place = cauldron.middle});
}

// ---- random orders ----------------------------------------------------------------------------------------

/// Event::detail of a recipe whose order is revealed: the recipe's number, then those of its ingredients, 8
/// bits each.
std::uint32_t packed_recipe(std::uint32_t number, const RecipeOrder& order) {
    std::uint32_t packed = number;
    for (std::size_t i = 0; i < order.steps.size(); ++i) {
        const std::uint32_t ingredient = i < order.count ? order.steps[i].ingredient : 0xFFU;
        packed |= (ingredient & 0xFFU) << (8 * (i + 1));
    }
    return packed;
}

void tell_orders(MatchContext& context, Tick tick) {
    const auto& match = std::as_const(context.world).single<Match>();
    const auto age = tick - match.round_began;
    if (age < told_after || age >= told_after + gameplay_period) return;
    for (std::uint32_t player = 0; player < players; ++player) tell_order(context, player, tick);
}

using Order = std::array<std::uint32_t, max_recipe_ingredients>;

Order shuffled(Random& random) {
    Order order{};
    for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
    for (std::size_t i = order.size() - 1; i > 0; --i) std::swap(order[i], order[random.below(i + 1)]);
    return order;
}

}  // namespace

RecipeOrder order_of(const Recipe& recipe, const ecs::World& world, std::uint32_t player) {
    RecipeOrder order;
    const auto add = [&](std::size_t place) {
        if (place < recipe.ingredients.size()) order.steps[order.count++] = recipe.ingredients[place];
    };
    const bool drawn = recipe.drawn && player < players && world.count<DrawnOrders>() > 0;
    if (drawn) {
        for (const auto place : world.single<DrawnOrders>().order[player]) add(place);
    } else {
        for (std::size_t place = 0; place < max_recipe_ingredients; ++place) add(place);
    }
    return order;
}

RecipeList recipes_open_to(const MatchData& data, const ecs::World& world, const Cauldron& cauldron,
                           std::uint32_t player) {
    RecipeList list;
    if (cauldron.fault != BrewFault::none) return list;
    const auto contents = contents_to_come(cauldron);
    const auto count = ingredients_in(cauldron);
    for (std::uint32_t i = 0; i < data.recipes.size(); ++i)
        if (begins_with(order_of(data.recipes[i], world, player), contents, count))
            list.numbers[list.count++] = i;
    return list;
}

Contents contents_to_come(const Cauldron& cauldron) {
    Contents contents = cauldron.contents;
    if (cauldron.spoilt != 0) contents.fill(no_ingredient);
    for (std::uint32_t i = 0; i < cauldron.next.count; ++i) {
        const auto ingredient = cauldron.next.list[i].ingredient;
        if (ingredient == no_ingredient) continue;
        if (const auto substance = substance_for(contents, ingredient)) contents[*substance] = ingredient;
    }
    return contents;
}

std::size_t ingredients_in(const Cauldron& cauldron) {
    const auto contents = contents_to_come(cauldron);
    return static_cast<std::size_t>(std::count_if(contents.begin(), contents.end(),
                                                  [](std::uint32_t one) { return one != no_ingredient; }));
}

Tick spoils_at(const MatchData& data, const Cauldron& cauldron) {
    const auto& rules = *data.cauldron;
    const bool useless = cauldron.fault != BrewFault::none;
    return cauldron.begun + (useless ? rules.useless_spoils_after : rules.spoils_after) + cauldron.more_time;
}

void drop_for_recipe(MatchContext& context, Cauldron& cauldron, std::uint32_t player,
                     std::uint32_t ingredient, Tick tick) {
    cauldron.potion = no_potion;
    if (cauldron.fault != BrewFault::none || context.data.recipes.empty()) return;
    const auto fault = fault_of_drop(context, cauldron, player, ingredient);
    if (fault != BrewFault::none) return spoil_recipe(context, cauldron, player, fault, tick);
    const auto before = ingredients_in(cauldron);
    const auto open = recipes_open_to(context.data, context.world, cauldron, player);
    for (std::size_t i = 0; i < open.count && before > 0; ++i) {
        const auto& recipe = context.data.recipes[open.numbers[i]];
        const auto order = order_of(recipe, context.world, player);
        if (order.count > before && order.steps[before].ingredient == ingredient)
            cauldron.more_time = std::max(cauldron.more_time, before * recipe.more_time);
    }
    cauldron.reached = 0;
    note_step(context, cauldron, player, tick);
}

void refuse_fourth(MatchContext& context, const Cauldron& cauldron, std::uint32_t player, Tick tick) {
    note_fault(context, cauldron, player, BrewFault::full, tick);
}

void brew_by_stroke(MatchContext& context, ecs::Entity wizard, const BrewStroke& stroke, Tick tick) {
    auto& world = context.world;
    const auto& reading = stroke.reading;
    if (reading.gesture == no_gesture || world.count<Cauldron>() == 0) return;
    auto& cauldron = world.single<Cauldron>();
    const auto player = std::as_const(world).get<Wizard>(wizard).player;
    const auto* recipe = finished_mix(context, cauldron, player);
    if (const auto fault = fault_of_brew(cauldron, recipe, player); fault != BrewFault::none)
        return note_fault(context, cauldron, player, fault, tick);
    const auto order = order_of(*recipe, std::as_const(world), player);
    const auto moment = fault_of_moment(cauldron, stroke.begun_at, order.steps[order.count - 1]);
    if (moment == BrewFault::late) return spoil_recipe(context, cauldron, player, moment, tick);
    const auto* next = next_stroke(*recipe, cauldron.strokes_done);
    // Edited data files may require fewer strokes than the wizard has already drawn.
    if (next == nullptr) return succeed(context, cauldron, wizard, *recipe, tick);
    const auto fault = moment != BrewFault::none
                           ? moment
                           : fault_of_stroke(*next, gesture_name(context, player, reading.gesture), reading);
    if (fault != BrewFault::none) return note_fault(context, cauldron, player, fault, tick);
    cauldron.strokes_done += counts_for(*recipe, cauldron.strokes_done, reading);
    note_step(context, cauldron, player, tick);
    if (next_stroke(*recipe, cauldron.strokes_done) == nullptr)
        succeed(context, cauldron, wizard, *recipe, tick);
}

ecs::Mask brew_by_stroke_reads(const ecs::World& world) {
    auto reads = effect_reads(world);
    reads |= world.mask<Wizard, DrawnOrders>();
    return reads;
}

ecs::Mask brew_by_stroke_writes(const MatchContext& context) {
    auto writes = context.world.mask<Cauldron, Effects, EventLog, resource::Journal>();
    for (const auto& recipe : context.data.recipes) writes |= effect_writes(context.world, recipe.effects);
    return writes;
}

void tell_order(MatchContext& context, std::uint32_t player, Tick tick) {
    for (std::uint32_t i = 0; i < context.data.recipes.size(); ++i) {
        const auto& recipe = context.data.recipes[i];
        if (!recipe.drawn) continue;
        record(context, {.tick = tick,
                         .kind = EventKind::recipe_told,
                         .subject = player,
                         .by = player,
                         .detail = packed_recipe(i, order_of(recipe, std::as_const(context.world), player))});
    }
}

void draw_orders(MatchContext& context, std::uint64_t seed) {
    if (!context.data.cauldron) return;
    constexpr std::uint64_t stream = 2;
    auto random = random_stream(seed, stream);
    DrawnOrders drawn;
    drawn.order[0] = shuffled(random);
    do drawn.order[1] = shuffled(random);
    while (drawn.order[1] == drawn.order[0]);
    context.world.create(drawn);
}

void forget_filling(Cauldron& cauldron) {
    cauldron.begun = 0;
    cauldron.owner = no_player;
    cauldron.mixed_since = 0;
    cauldron.boon_given = 0;
    cauldron.more_time = 0;
    cauldron.strokes_done = 0;
    cauldron.reached = 0;
    cauldron.fault = BrewFault::none;
}

void change_brew(const MatchData& data, Cauldron& cauldron, Tick tick) {
    if (cauldron.potion == no_potion) return;
    // Edited data files may no longer have the recipe.
    if (tick >= cauldron.potion_until || cauldron.potion >= data.recipes.size()) {
        cauldron.potion = no_potion;
        return;
    }
    const auto& fluid = data.recipes[cauldron.potion].fluid;
    const double lack = std::max(std::abs(fluid.swirl), fluid.rise) - cauldron.speed;
    if (!(lack > 0)) return;
    const auto& rules = *data.cauldron;
    constexpr double gain = 0.1;                   // share of the speed still missing that one push adds
    constexpr std::uint32_t pusher = 0xFFFF'0000;  // source (Stroke::by) of the first push by a potion
    const double radius = 1.5 * rules.ladle.radius, out = data.arena.bowl->size.radius / 2;
    const double push = gain * lack * rules.density * fluid.density * fluid::pushed_volume(radius);
    const vec3 rise{0, fluid.rise > 0 ? push : 0, 0};
    if (fluid.rise > 0)
        add_stroke(cauldron, {.place = {0, -out, 0}, .impulse = rise, .radius = radius, .by = pusher});
    if (fluid.swirl == 0) return;
    const double round = fluid.swirl > 0 ? push : -push;
    for (std::uint32_t i = 0; i < 4; ++i) {
        // Clockwise, seen from above: the push at (x, z) has the direction (-z, x).
        const vec2 at = i < 2 ? vec2(i == 0 ? 1 : -1, 0) : vec2(0, i == 2 ? 1 : -1);
        add_stroke(cauldron, {.place = {out * at.x, -radius, out * at.y},
                              .impulse = {-round * at.y, 0, round * at.x},
                              .radius = radius,
                              .by = pusher + 1 + i});
    }
}

void add_drawn_orders_system(MatchContext& context, ecs::Schedule& schedule) {
    if (context.data.orb) return;
    const auto& world = context.world;
    schedule.add({.name = "drawn recipes",
                  .period = gameplay_period,
                  .reads = world.mask<Match, DrawnOrders>(),
                  .writes = world.mask<EventLog, resource::Journal>(),
                  .needs = world.mask<DrawnOrders>(),
                  .run = [&context](ecs::World&, Tick tick) { tell_orders(context, tick); }});
}

}  // namespace thaum::game::inline stations

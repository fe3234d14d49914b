#include "game/bots/bot.h"

#include <algorithm>
#include <cmath>

#include "core/file.h"
#include "core/text.h"
#include "ecs/snapshot.h"
#include "game/bots/nav.h"

// Every gameplay tick a bot looks, chooses an aim and a way, and spreads its turn over the ticks until the next look.
namespace thaum::game {
namespace {

using input::Button;
namespace hand = input::hand;

constexpr double rad_per_count = 0.001;  ///< of a bot's mouse
constexpr std::size_t memory = 128;      ///< glimpses; at 8 ms one second
constexpr double reached = 1.2;          ///< m from a goal
constexpr double stuck_speed = 0.4;      ///< m/s
constexpr Tick forget_after = ticks(4.0);

/// What the eye saw at one look.
struct Glimpse {
    vec3 chest{};  ///< of the foe, m
    std::uint64_t seen{};
    static constexpr auto fields() {
        return std::tuple(field("chest", &Glimpse::chest), field("seen", &Glimpse::seen));
    }
};

/// Who it is and how good.
struct Seat {
    std::uint64_t device{};
    std::uint32_t player{};
    std::uint32_t level{};
    Tick reaction{};
    double aim_error{}, turn_speed{}, view_cos{};
    Tick burst{}, rest{};
    double keep{};
    static constexpr std::string_view name = "Seat";
    static constexpr auto fields() {
        return std::tuple(field("device", &Seat::device), field("player", &Seat::player),
                          field("level", &Seat::level), field("reaction", &Seat::reaction),
                          field("aim_error", &Seat::aim_error), field("turn_speed", &Seat::turn_speed),
                          field("view_cos", &Seat::view_cos), field("burst", &Seat::burst),
                          field("rest", &Seat::rest), field("keep", &Seat::keep));
    }
};

struct Eyes {
    std::uint64_t looks{};
    std::array<Glimpse, memory> glimpses{};
    static constexpr std::string_view name = "Eyes";
    static constexpr auto fields() {
        return std::tuple(field("looks", &Eyes::looks), field("glimpses", &Eyes::glimpses));
    }
};

struct Mind {
    Random random;
    vec3 foe{};                        ///< where it believes the foe's chest to be, m
    Tick foe_seen_at{};                ///< 0: never
    double error_right{}, error_up{};  ///< rad, how far its aim is off just now
    vec3 goal{};                       ///< m
    Tick goal_until{};
    Tick fire_from{}, fire_until{};
    Tick strafe_until{};
    std::int32_t strafe{};
    std::int32_t wishes_to_move{};
    Tick slow_since{};  ///< when it began to be slower than it wished
    Tick dodge_until{};
    std::int32_t right_left{}, up_left{};  ///< counts still to be given before the next look
    std::int32_t move_strafe{}, move_forward{};
    std::uint32_t buttons{};
    std::uint32_t spare{};
    static constexpr std::string_view name = "Mind";
    static constexpr auto fields() {
        return std::tuple(field("random", &Mind::random), field("foe", &Mind::foe),
                          field("foe_seen_at", &Mind::foe_seen_at), field("error_right", &Mind::error_right),
                          field("error_up", &Mind::error_up), field("goal", &Mind::goal),
                          field("goal_until", &Mind::goal_until), field("fire_from", &Mind::fire_from),
                          field("fire_until", &Mind::fire_until), field("strafe_until", &Mind::strafe_until),
                          field("strafe", &Mind::strafe), field("wishes_to_move", &Mind::wishes_to_move),
                          field("slow_since", &Mind::slow_since), field("dodge_until", &Mind::dodge_until),
                          field("right_left", &Mind::right_left), field("up_left", &Mind::up_left),
                          field("move_strafe", &Mind::move_strafe),
                          field("move_forward", &Mind::move_forward), field("buttons", &Mind::buttons),
                          field("spare", &Mind::spare));
    }
};

/// The bot's own wizard, as it knows itself.
struct Self {
    vec3 centre{}, eye{}, velocity{};
    double yaw{}, pitch{};
    std::uint32_t key{};
    bool alive = false;
};

Self self_of(const Simulation& match, std::uint32_t player) {
    const auto& world = match.world();
    const auto wizard = wizard_of(world, player);
    const auto& motion = world.get<Motion>(wizard);
    const auto& gaze = world.get<Gaze>(wizard);
    return {motion.position,
            eye_of(match.data().wizard, motion.position),
            motion.velocity,
            gaze.yaw,
            gaze.pitch,
            wizard.index,
            !world.has<Dead>(wizard)};
}

/// A number with mean 0 and standard deviation 1 (the sum of twelve uniform ones).
double normal(Random& random) {
    double sum = -6;
    for (int i = 0; i < 12; ++i) sum += random.uniform();
    return sum;
}

Glimpse look(const Simulation& match, const Self& self, const Seat& seat) {
    const auto& world = match.world();
    const auto foe = wizard_of(world, 1 - seat.player);
    if (world.has<Dead>(foe)) return {};
    const vec3 chest = world.get<Motion>(foe).position + vec3(0, 0.2, 0);
    const vec3 to = chest - self.eye;
    const double distance = glm::length(to);
    const vec3 ahead = look_rotation(self.yaw, self.pitch) * vec3(0, 0, -1);
    if (distance < 1e-6 || glm::dot(to / distance, ahead) < seat.view_cos) return {};
    const auto hit = match.physics().ray(self.eye, chest, physics::all_layers, self.key);
    if (hit && hit->key != foe.index) return {};
    return {chest, 1};
}

/// What it sees, a reaction time ago.
void perceive(const Simulation& match, const Self& self, const Seat& seat, Eyes& eyes, Mind& mind,
              Tick tick) {
    eyes.glimpses[eyes.looks % memory] = look(match, self, seat);
    const auto delay = std::min<std::uint64_t>(seat.reaction / gameplay_period, memory - 1);
    if (eyes.looks >= delay) {
        const auto& then = eyes.glimpses[(eyes.looks - delay) % memory];
        if (then.seen != 0) {
            mind.foe = then.chest;
            mind.foe_seen_at = tick;
        }
    }
    ++eyes.looks;
}

/// The aim wanders slowly, with the skill's standard deviation.
void wander_aim(const Seat& seat, Mind& mind) {
    constexpr double keep = 0.98;
    const double fresh = std::sqrt(1 - keep * keep);
    mind.error_right = keep * mind.error_right + fresh * seat.aim_error * normal(mind.random);
    mind.error_up = keep * mind.error_up + fresh * 0.5 * seat.aim_error * normal(mind.random);
}

double angle_between(double from, double to) {
    double d = std::fmod(to - from, 2 * pi);
    if (d > pi) d -= 2 * pi;
    if (d < -pi) d += 2 * pi;
    return d;
}

struct Aim {
    double yaw{}, pitch{};
};

Aim aim_at(vec3 eye, vec3 target) {
    const vec3 d = target - eye;
    return {det::atan2(-d.x, -d.z), det::atan2(d.y, std::sqrt(d.x * d.x + d.z * d.z))};
}

/// Counts for the next ticks; at most what the wrist can do in a gameplay tick.
void turn_towards(const Self& self, const Seat& seat, Aim aim, Mind& mind) {
    const double limit = seat.turn_speed * gameplay_dt;
    const double left = std::clamp(0.25 * angle_between(self.yaw, aim.yaw), -limit, limit);
    const double up = std::clamp(0.25 * (aim.pitch - self.pitch), -limit, limit);
    mind.right_left = static_cast<std::int32_t>(std::lround(-left / rad_per_count));
    mind.up_left = static_cast<std::int32_t>(std::lround(up / rad_per_count));
}

void choose_fire(const Self& self, const Seat& seat, Aim wanted, Mind& mind, Tick tick) {
    mind.buttons &= ~static_cast<std::uint32_t>(Button::fire);
    const bool fresh = mind.foe_seen_at != 0 && tick - mind.foe_seen_at <= ticks(0.3);
    const bool aimed = std::abs(angle_between(self.yaw, wanted.yaw)) < 0.15;
    if (fresh && aimed && tick >= mind.fire_until + seat.rest) {
        mind.fire_from = tick;
        mind.fire_until = tick + seat.burst;
    }
    if (fresh && tick >= mind.fire_from && tick < mind.fire_until) {
        mind.buttons |= static_cast<std::uint32_t>(Button::fire);
    }
}

/// A walkable place anywhere in the court.
vec3 random_place(const WalkGrid& grid, Random& random) {
    for (int tries = 0; tries < 50; ++tries) {
        const int cell = static_cast<int>(random.below(WalkGrid::side * WalkGrid::side));
        if (grid.walkable(cell)) return WalkGrid::centre_of(cell);
    }
    return {0, 0, 15};
}

void set_move(const Self& self, vec3 direction, Mind& mind) {
    const vec3 local = glm::conjugate(rotation({0, 1, 0}, self.yaw)) * vec3(direction.x, 0, direction.z);
    const double length = glm::length(local);
    if (length < 1e-6) {
        mind.move_strafe = mind.move_forward = 0;
        return;
    }
    mind.move_strafe = static_cast<std::int32_t>(std::lround(127 * local.x / length));
    mind.move_forward = static_cast<std::int32_t>(std::lround(-127 * local.z / length));
}

/// Something stands in the way: after a while jump and go sideways.
void unstick(const Self& self, Mind& mind, Tick tick) {
    mind.buttons &= ~static_cast<std::uint32_t>(Button::jump);
    const bool slow = glm::length(vec2(self.velocity.x, self.velocity.z)) < stuck_speed;
    if (!slow || mind.wishes_to_move == 0) mind.slow_since = tick;
    if (tick - mind.slow_since < ticks(0.4)) return;
    mind.slow_since = tick;
    mind.dodge_until = tick + ticks(0.5);
    mind.strafe = mind.random.below(2) == 0 ? -127 : 127;
    mind.buttons |= static_cast<std::uint32_t>(Button::jump);
}

/// In sight: keep the distance and sidestep. Out of sight: where the foe was, then anywhere.
vec3 choose_way(const Self& self, const Seat& seat, const WalkGrid& grid, Mind& mind, WalkGrid::Ways& ways,
                Tick tick) {
    const bool knows = mind.foe_seen_at != 0 && tick - mind.foe_seen_at < forget_after;
    const vec3 to_foe = vec3(mind.foe.x - self.centre.x, 0, mind.foe.z - self.centre.z);
    const double distance = glm::length(to_foe);
    if (knows && tick - mind.foe_seen_at < ticks(0.5) && distance > 1e-6) {
        if (tick >= mind.strafe_until) {
            mind.strafe = static_cast<std::int32_t>(mind.random.below(3)) - 1;
            mind.strafe_until = tick + ticks(mind.random.uniform(0.4, 1.2));
        }
        const vec3 ahead = to_foe / distance;
        const vec3 right = glm::cross(ahead, vec3(0, 1, 0));
        const double closer = distance > 1.3 * seat.keep ? 1.0 : distance < 0.6 * seat.keep ? -1.0 : 0.0;
        const vec3 way = ahead * closer + right * static_cast<double>(std::clamp(mind.strafe, -1, 1));
        const double length = glm::length(way);
        if (length < 1e-6) return {0, 0, 0};
        const bool safe = grid.straight(self.centre, self.centre + way / length * 1.2);  // never over an edge
        return safe ? way : vec3(0, 0, 0);
    }
    const bool there =
        glm::distance(vec2(mind.goal.x, mind.goal.z), vec2(self.centre.x, self.centre.z)) < reached;
    if (there || tick >= mind.goal_until) {
        mind.goal = knows ? mind.foe : random_place(grid, mind.random);
        mind.goal_until = tick + ticks(8.0);
        if (knows) mind.foe_seen_at = tick - std::min(tick, forget_after);  // looked for once
    }
    const int goal = WalkGrid::cell_at(mind.goal);
    if (ways.goal != goal) grid.find_ways(goal, ways);
    const int cell = WalkGrid::cell_at(self.centre);
    const int next = grid.next(cell, ways);
    if (next == cell) {
        mind.goal_until = tick;  // there, or no way to it
        return {0, 0, 0};
    }
    return WalkGrid::centre_of(next) - vec3(self.centre.x, 0, self.centre.z);
}

void think(const Simulation& match, const Seat& seat, Eyes& eyes, Mind& mind, const WalkGrid& grid,
           WalkGrid::Ways& ways) {
    const Tick tick = match.match().played;
    const auto self = self_of(match, seat.player);
    if (!self.alive || match.match().phase != Phase::playing) {
        mind.right_left = mind.up_left = mind.move_strafe = mind.move_forward = 0;
        mind.buttons = 0;
        mind.foe_seen_at = 0;
        return;
    }
    perceive(match, self, seat, eyes, mind, tick);
    wander_aim(seat, mind);
    const vec3 way = choose_way(self, seat, grid, mind, ways, tick);
    const bool watches = mind.foe_seen_at != 0 && tick - mind.foe_seen_at < ticks(1.5);
    auto aim = watches ? aim_at(self.eye, mind.foe) : aim_at(self.eye, self.eye + way);
    if (!watches) aim.pitch = 0;
    const auto wanted = aim;
    aim.yaw += mind.error_right;
    aim.pitch += mind.error_up;
    if (watches || glm::length(way) > 0) turn_towards(self, seat, aim, mind);
    choose_fire(self, seat, wanted, mind, tick);
    set_move(self, way, mind);
    mind.wishes_to_move = glm::length(way) > 0 ? 1 : 0;
    unstick(self, mind, tick);
    if (tick < mind.dodge_until) mind.move_strafe = mind.strafe > 0 ? 127 : -127;
}

/// The part of the planned turn that belongs to this tick.
std::int32_t share(std::int32_t& left, Tick ticks_left) {
    const auto part = left / static_cast<std::int32_t>(ticks_left);
    left -= part;
    return part;
}

}  // namespace

Expected<BotSkill> load_bot_skill(const std::filesystem::path& assets, int level) {
    const auto name = text("bots/level_", level, ".toml");
    const auto path = assets / name;
    std::error_code ignored;
    if (!std::filesystem::exists(path, ignored))
        return fail(text("there is no bot of level ", level, " (", path.string(), ")"));
    const auto source = read_text_file(path, 1U << 16U);
    if (!source) return tl::unexpected(source.error());
    const auto file = Config::parse(*source, name, 1);
    if (!file) return tl::unexpected(file.error());
    const auto root = file->root();
    BotSkill skill;
    skill.level = static_cast<std::uint32_t>(level);
    skill.reaction = ticks(root.number("reaction_s", {0, seconds((memory - 1) * gameplay_period)}));
    skill.aim_error = root.number("aim_error_deg", {0, 90}) * radians_per_degree;
    skill.turn_speed = root.number("turn_deg_per_s", {1, 3600}) * radians_per_degree;
    skill.view_cos = det::cos(root.number("view_deg", {1, 360}) / 2 * radians_per_degree);
    skill.burst = ticks(root.number("burst_s", {0.01, 60}));
    skill.rest = ticks(root.number("rest_s", {0, 60}));
    skill.keep = root.number("keep_m", {0, 40});
    if (const auto checked = file->check(); !checked) return tl::unexpected(checked.error());
    return skill;
}

input::DeviceSpec bot_device(std::uint32_t player, int level) {
    return {.player = player,
            .kind = input::DeviceKind::bot,
            .name = text("bot ", level),
            .look_rad_per_count = rad_per_count};
}

struct Bots::Inside {
    ecs::World minds;
    std::unique_ptr<WalkGrid> grid;
    std::vector<WalkGrid::Ways> ways;  // a cache: the ways to a goal, by the bot's entity number

    Inside() {
        minds.declare<Seat>();
        minds.declare<Eyes>();
        minds.declare<Mind>();
    }
};

Bots::Bots() : inside_(std::make_unique<Inside>()) {}
Bots::~Bots() = default;
Bots::Bots(Bots&&) noexcept = default;
Bots& Bots::operator=(Bots&&) noexcept = default;

void Bots::add(const Simulation& match, std::size_t device, std::uint32_t player, const BotSkill& skill,
               std::uint64_t seed) {
    auto& in = *inside_;
    if (!in.grid) in.grid = std::make_unique<WalkGrid>(match.physics());
    const Seat seat{.device = device,
                    .player = player,
                    .level = skill.level,
                    .reaction = skill.reaction,
                    .aim_error = skill.aim_error,
                    .turn_speed = skill.turn_speed,
                    .view_cos = skill.view_cos,
                    .burst = skill.burst,
                    .rest = skill.rest,
                    .keep = skill.keep};
    in.minds.create(seat, Eyes{}, Mind{.random = random_stream(seed, 100 + player)});
    in.ways.emplace_back();
    in.grid->find_ways(0, in.ways.back());  // so that no memory is asked for during the match
}

bool Bots::empty() const { return inside_->minds.size() == 0; }

void Bots::sample(const Simulation& match, input::InputFrame& frame) {
    if (match.match().paused != 0) return;
    const Tick phase = match.match().played % gameplay_period;
    auto& in = *inside_;
    in.minds.view<const Seat, Eyes, Mind>().each(
        [&](ecs::Entity e, const Seat& seat, Eyes& eyes, Mind& mind) {
            if (phase == 0) think(match, seat, eyes, mind, *in.grid, in.ways[e.index]);
            auto& sample = frame.devices[seat.device];
            sample = {};
            sample.counts[hand::look_right] = share(mind.right_left, gameplay_period - phase);
            sample.counts[hand::look_up] = share(mind.up_left, gameplay_period - phase);
            sample.counts[hand::strafe] = mind.move_strafe;
            sample.counts[hand::forward] = mind.move_forward;
            sample.buttons = mind.buttons;
        });
}

void Bots::save(Bytes& out) const { ecs::save(inside_->minds, out); }

Expected<void> Bots::restore(std::span<const std::byte> snapshot) {
    return ecs::restore(inside_->minds, snapshot);
}

}  // namespace thaum::game

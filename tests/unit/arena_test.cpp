// Tests of arenas: the faults in their files, fairness to both sides, paths for bots, and that a new arena
// needs no code.
#include "game/arena/arena.h"

#include "core/file.h"
#include "core/text.h"
#include "game/bots/nav.h"
#include "game/bots/swinging.h"
#include "unit/copied_assets.h"
#include "unit/game_duel.h"
#include "unit/message_of.h"

namespace thaum::game::test {
namespace {

std::shared_ptr<const MatchData> arena_data(const std::string& arena, const std::filesystem::path& folder,
                                            std::vector<std::string> overrides = {}) {
    return std::make_shared<const MatchData>(
        load_match_data(folder, {.arena = arena, .overrides = std::move(overrides)}).value());
}

std::string shown(vec3 v) { return text(v.x, " ", v.y, " ", v.z); }

/// A copy of the data folder with the test's own arena in it.
std::filesystem::path assets_with_yard() {
    static const CopiedAssets copied;
    static const bool added = std::filesystem::copy_file(THAUM_SOURCE_DIR "/tests/arenas/yard.toml",
                                                         copied.path / "arenas/yard.toml");
    EXPECT_TRUE(added);
    return copied.path;
}

// Files of arenas -------------------------------------------------------------------------------------------

constexpr std::string_view min_arena = R"(version = 1
name = "Least"
[[solid]]
shape = "box"
surface = "floor"
centre = [0, -0.5, 0]
size = [10, 1, 8]
[[pad]]
position = [-3, 0, 3]
facing = [0, 0, 0]
player = 0
turned_player = 1
turned = true
)";

/// The first fault in an arena's file; empty: none.
std::string fault_of(std::string_view source) {
    const auto file = Config::parse(source, "least.toml", 1);
    if (!file) return file.error().message;
    read_arena(*file);
    read_arena_look(*file);
    return message_of(file->check());
}

/// The first fault in the smallest valid file of an arena, after more entries were added at its end.
std::string fault_with(std::string_view more) { return fault_of(text(min_arena, more)); }

Arena arena_with(std::string_view more) {
    const auto file = Config::parse(text(min_arena, more), "least.toml", 1).value();
    auto arena = read_arena(file);
    EXPECT_TRUE(file.check()) << file.check().error().message;
    return arena;
}

TEST(ArenaFile, FaultsNameTheLineAndTheRemedy) {
    EXPECT_EQ(fault_with(""), "");
    const auto faulty = [](std::string_view more, std::string_view words) {
        const auto fault = fault_with(more);
        EXPECT_EQ(fault.find("least.toml:"), 0U) << fault;
        EXPECT_NE(fault.find(words), std::string::npos) << fault;
    };
    faulty("[[anchor]]\nposition = [1, 3, 1]\nmirror = true\nturned = true\n",
           "least.toml:17: 'mirror' and 'turned' exclude each other");
    faulty("[[anchor]]\nposition = [1, 3, 4.5]\n",
           "least.toml:15: 'position' lies outside of the arena's ground, x from -5 to 5, z from -4 to 4");
    faulty("[[pad]]\nposition = [6, 0, 0]\nfacing = [0, 0, 0]\n", "'position' lies outside");
    faulty("[[niche]]\nposition = [6, 0, 0]\ningredient = \"salt\"\n", "'position' lies outside");
    faulty("[[power_up]]\nkind = \"vial\"\nposition = [0, 0, -4.1]\n", "'position' lies outside");
    faulty("[range.player]\nplace = [0, 0, 9]\nyaw_deg = 0\n", "'place' lies outside");
    EXPECT_EQ(fault_with("[range.player]\nplace = [0, 0, 1]\nyaw_deg = 0\n"),
              "least.toml:14: table 'range.dummy' is missing");
    faulty(
        "[[solid]]\nshape = \"ramp\"\nsurface = \"floor\"\ncentre = [0, 1, 0]\nsize = [2, 2, 2]\nrises = "
        "\"up\"\n",
        "rises");
    faulty("[look.sun]\ntowards = [1, 0, 0]\n", "least.toml:15: 'towards': the height (y)");
    faulty("[[look.banner]]\nwall = \"west side\"\nalong = 0\nheight = 3\nteam = 0\n", "wall");
    faulty("[look.sky]\nmoon = 3\n", "moon");
    faulty("[[pad]]\nposition = [0, 0, 0]\nfacing = [0, 0, 0]\nmirrored_player = 1\nturned = true\n",
           "mirrored_player");
    const auto bowl = [](double height, double thickness) {
        return text(
            "[[solid]]\nshape = \"bowl\"\nsurface = \"bowl\"\ncentre = [0, 0.5, 0]\nradius = 1.5\nheight = ",
            height, "\nthickness = ", thickness, "\n");
    };
    EXPECT_EQ(fault_with(bowl(0.75, 0.15)), "");
    faulty(bowl(0.74, 0.15), "least.toml:20: 'thickness' is 0.15, and must be at most 0.2 times the height");
    faulty(bowl(40, 0.61), "0.4 times the radius");
    EXPECT_EQ(fault_with(bowl(0.75, 0.15) + bowl(0.75, 0.15)),
              "least.toml:22: a second bowl: only one can be the cauldron");
    const std::string wall =
        "[[solid]]\nshape = \"box\"\nsurface = \"wall\"\ncentre = [2, 1, 2]\nsize = [1, 2, 1]\n";
    faulty(wall +
               "[[prop]]\nshape = \"sphere\"\nsurface = \"ball\"\nposition = [2, 1, 2]\nradius = 0.2\nmass = "
               "5\n",
           "least.toml:22: 'position': the prop is inside of the solid 'wall' of line 15; move it out");
    EXPECT_EQ(fault_with(wall + "[[prop]]\nshape = \"sphere\"\nsurface = \"ball\"\nposition = [2, 2.2, 2]\n"
                                "radius = 0.2\nmass = 5\n"),
              "")
        << "it lies on the wall";
    faulty("[[pad]]\nposition = [1, 3, 1]\nfacing = [0, 0, 0]\n",
           "least.toml:15: 'position' lies 3 m above the ground");
    faulty(wall + "[[pad]]\nposition = [2, 0, 2]\nfacing = [0, 0, 0]\n",
           "a wizard here is inside of the solid");
    const auto bare = Config::parse("version = 1\nname = \"Bare\"\n", "bare.toml", 1).value();
    read_arena(bare);
    EXPECT_EQ(bare.check().error().message,
              "bare.toml:1: an arena needs at least one solid with the surface 'floor'");
}

TEST(ArenaFile, ANameIsOneShortLineThatATerminalCanShow) {
    const auto fault = [](std::string_view name) {
        std::string source(min_arena);
        const auto at = source.find('"', source.find("name = "));
        source.replace(at, source.find('"', at + 1) + 1 - at, text('"', name, '"'));
        return fault_of(source);
    };
    EXPECT_EQ(fault("The Königshof"), "");
    for (const std::string name : {"", "a\\nb", "a\\u001b[31m", "a\\u202eb", "a\\u0000b"})
        EXPECT_NE(fault(name).find("'name' must be a line of 1 to 64 bytes"), std::string::npos)
            << name << ": " << fault(name);
    EXPECT_NE(fault(std::string(65, 'x')).find("'name' must"), std::string::npos);
}

TEST(ArenaFile, ABowlThatTheSolverCannotFillIsRefused) {
    const auto folder = assets_with_yard();
    auto source = read_text_file(folder / "arenas/the_well.toml", 1U << 20U).value();
    constexpr std::string_view bowl = "radius = 1.5\nheight = 1.1\nthickness = 0.15";
    const auto at = source.find(bowl);
    ASSERT_NE(at, std::string::npos);
    source.replace(at, bowl.size(), "radius = 0.03\nheight = 40\nthickness = 0.012");
    ASSERT_TRUE(write_text_file(folder / "arenas/slim.toml", source));
    const auto message = message_of(load_match_data(folder, {.arena = "slim"}));
    EXPECT_NE(message.find("slim.toml:"), std::string::npos) << message;
    EXPECT_NE(message.find("the bowl holds no brew: "), std::string::npos) << message;
}

TEST(ArenaFile, ATwinIsTheMirrorImageOrTurned) {
    const auto arena = arena_with(R"([[anchor]]
position = [1, 3, 2]
turned = true
[[anchor]]
position = [1, 3, 2]
mirror = true
)");
    const std::vector<vec3> anchors{{1, 3, 2}, {-1, 3, -2}, {1, 3, 2}, {1, 3, -2}};
    EXPECT_EQ(arena.anchors, anchors);
    ASSERT_EQ(arena.pads.size(), 2U);
    EXPECT_EQ(arena.pads[1].feet, vec3(3, 0, -3));
    EXPECT_EQ(arena.pads[1].player, 1U);
    EXPECT_NEAR(std::abs(arena.pads[1].yaw - arena.pads[0].yaw), pi, 1e-12) << "they face each other";
    EXPECT_EQ(arena.practice[0].feet, vec3(-3, 0, 3)) << "without [range] one practises from the pads";
    EXPECT_EQ(arena.practice[1].feet, vec3(3, 0, -3));
}

/// Height of a ramp's slope above a point, which is given relative to the ramp's middle (m).
double slope_at(const physics::TriangleMesh& mesh, vec2 at) {
    vec3 half(0), high(0);
    for (const auto& v : mesh.vertices) half = glm::max(half, glm::abs(v));
    for (const auto& v : mesh.vertices) {
        if (v.y > 0) high += v / 2.0;  // the sum of two halves is the middle of the upper edge
    }
    return half.y * (high.x * at.x / (half.x * half.x) + high.z * at.y / (half.z * half.z));
}

/// Volume of a closed mesh; negative if its triangles are clockwise from outside.
double volume_of(const physics::TriangleMesh& mesh) {
    double volume = 0;
    for (const auto& t : mesh.triangles)
        volume += glm::dot(mesh.vertices[t[0]], glm::cross(mesh.vertices[t[1]], mesh.vertices[t[2]])) / 6;
    return volume;
}

TEST(ArenaFile, ARampRisesWhereItsNameSaysAndItsTwinWhereItMust) {
    // Directions (x, z) in which a ramp may rise: east, west, north, south, as in rise_names.
    const std::array<vec2, 4> ways{vec2(1, 0), {-1, 0}, {0, -1}, {0, 1}};
    for (std::size_t rise = 0; rise < rise_names.size(); ++rise) {
        const auto mesh = ramp({2, 3, 4}, static_cast<Rise>(rise));
        EXPECT_NEAR(volume_of(mesh), 2 * 3 * 4 / 2.0, 1e-12) << rise_names[rise];
        EXPECT_GT(slope_at(mesh, ways[rise]), 0.5) << rise_names[rise];
        for (const std::string symmetry : {"mirror", "turned"}) {
            const auto arena = arena_with(
                text("[[solid]]\nshape = \"ramp\"\nsurface = \"floor\"\ncentre = [1.5, 1, 1]\nsize = "
                     "[2, 3, 4]\nrises = \"",
                     rise_names[rise], "\"\n", symmetry, " = true\n"));
            const auto& first = arena.things[1];
            const auto& twin = arena.things[2];
            const vec2 flip(symmetry == "turned" ? -1 : 1, -1);
            EXPECT_EQ(twin.position, first.position * vec3(flip.x, 1, flip.y));
            for (const vec2 at : {vec2(0.3, 0.1), {-0.4, 0.7}, {0.5, -0.6}}) {
                EXPECT_NEAR(slope_at(arena.meshes[first.body.mesh], at),
                            slope_at(arena.meshes[twin.body.mesh], at * flip), 1e-12)
                    << rise_names[rise] << " " << symmetry;
            }
        }
    }
}

TEST(ArenaFile, TheHashLeavesOutWhatNoMatchReads) {
    const auto folder = assets_with_yard();
    const auto file = folder / "arenas/hashed.toml";
    const auto source = read_text_file(folder / "arenas/the_well.toml", 1U << 20U).value();
    const auto hash_with = [&](std::string_view from, std::string_view to) {
        auto changed = source;
        const auto at = changed.find(from);
        EXPECT_NE(at, std::string::npos) << from;
        EXPECT_TRUE(write_text_file(file, changed.replace(at, from.size(), to)));
        const auto data = arena_data("hashed", folder);
        return data->files.front().hash;
    };
    const auto as_shipped = hash_with("", "");
    EXPECT_EQ(as_shipped, hash_with("colour = \"#FFDCA8\"", "colour = \"#102030\""));
    EXPECT_EQ(as_shipped, hash_with("place = [2.5, 0, 6.5]", "place = [2.5, 0, 6]"));
    EXPECT_NE(as_shipped, hash_with("mass = 40", "mass = 41"));
    std::filesystem::remove(file);
}

// Fairness of arenas to both players ------------------------------------------------------------------------

vec3 half_turned(vec3 p) { return {-p.x, p.y, -p.z}; }

TEST(TheWell, IsTheSameForBothPlayers) {
    const auto data = arena_data("the_well", assets());
    const auto& arena = data->arena;
    const auto has_twin = [](const auto& list, const auto& one, auto same) {
        return std::any_of(list.begin(), list.end(), [&](const auto& other) { return same(one, other); });
    };
    for (const auto& thing : arena.things) {
        EXPECT_TRUE(has_twin(arena.things, thing, [&](const Thing& a, const Thing& b) {
            const bool alike = a.surface == b.surface && a.body.shape == b.body.shape &&
                               a.body.size == b.body.size && a.body.mass == b.body.mass &&
                               glm::distance(half_turned(a.position), b.position) < 1e-12;
            if (!alike || a.body.shape != physics::Shape::mesh || a.surface == Surface::bowl) return alike;
            return std::abs(slope_at(arena.meshes[a.body.mesh], {0.3, 0.4}) -
                            slope_at(arena.meshes[b.body.mesh], {-0.3, -0.4})) < 1e-12;
        })) << shown(thing.position);
    }
    for (const vec3 anchor : arena.anchors)
        EXPECT_TRUE(has_twin(arena.anchors, anchor, [](vec3 a, vec3 b) { return half_turned(a) == b; }));
    for (const auto& up : arena.power_ups) {
        EXPECT_TRUE(has_twin(arena.power_ups, up, [](const PowerUpPlace& a, const PowerUpPlace& b) {
            return a.kind == b.kind && half_turned(a.position) == b.position;
        }));
    }
    for (const auto& niche : arena.niches) {
        EXPECT_TRUE(has_twin(arena.niches, niche, [](const NichePlace& a, const NichePlace& b) {
            return a.ingredient == b.ingredient && half_turned(a.position) == b.position;
        }));
    }
    for (const auto& pad : arena.pads) {
        EXPECT_TRUE(has_twin(arena.pads, pad, [](const Pad& a, const Pad& b) {
            const bool swapped = a.player >= players ? b.player == a.player : b.player == 1 - a.player;
            return swapped && half_turned(a.feet) == b.feet;
        }));
    }
}

// Paths for bots --------------------------------------------------------------------------------------------

/// Checks that bots can walk from both starts to every power-up, to every niche (where ingredients lie) and
/// to the cauldron's rim.
void expect_ways_everywhere(const std::shared_ptr<const MatchData>& data) {
    const Simulation match(data, {1, {bot_device(0, "level_1"), bot_device(1, "level_1")}});
    const auto& arena = data->arena;
    const WalkGrid grid(match.physics(), ground_bounds(arena));
    std::vector<vec3> goals;
    for (const auto& up : arena.power_ups) goals.push_back(up.position);
    for (const auto& niche : arena.niches) goals.push_back(niche.position);
    const double rim = arena.bowl->size.radius + 0.75;
    for (const vec3 way : {vec3(1, 0, 0), vec3(-1, 0, 0), vec3(0, 0, 1), vec3(0, 0, -1)})
        goals.push_back(arena.bowl->centre + rim * way);
    WalkGrid::Ways ways;
    for (const auto& start : arena.pads) {
        grid.find_ways(grid.cell_at(start.feet), ways);
        EXPECT_NEAR(grid.height(grid.cell_at(start.feet)), start.feet.y, 0.01) << "a pad on the ground";
        for (const vec3 goal : goals) {
            EXPECT_NE(ways.steps[static_cast<std::size_t>(grid.cell_at(goal))], WalkGrid::unreachable)
                << arena.name << ": no way from " << shown(start.feet) << " to " << shown(goal);
        }
    }
}

TEST(ArenaWays, LeadFromEveryPadToEveryThingWorthAWalk) {
    expect_ways_everywhere(arena_data("boiling_court", assets()));
    expect_ways_everywhere(arena_data("the_well", assets()));
    expect_ways_everywhere(arena_data("yard", assets_with_yard()));
}

TEST(ArenaWays, AreEquallyLongForBothPlayersOfTheWell) {
    const auto data = arena_data("the_well", assets());
    const Simulation match(data, {1, {bot_device(0, "level_1"), bot_device(1, "level_1")}});
    const WalkGrid grid(match.physics(), ground_bounds(data->arena));
    std::array<WalkGrid::Ways, players> ways;
    for (const auto& pad : data->arena.pads) {
        if (pad.player < players) grid.find_ways(grid.cell_at(pad.feet), ways[pad.player]);
    }
    for (int cell = 0; cell < grid.cells(); ++cell) {
        const int twin = grid.cell_at(half_turned(grid.centre_of(cell)));
        EXPECT_NEAR(grid.height(cell), grid.height(twin), 1e-6) << cell;
        EXPECT_EQ(ways[0].steps[static_cast<std::size_t>(cell)],
                  ways[1].steps[static_cast<std::size_t>(twin)])
            << cell;
    }
}

TEST(ArenaWays, ABlockLeadsNowhereAndBesideItIsAWay) {
    const auto data = arena_data("the_well", assets());
    const Simulation match(data, {1, {bot_device(0, "level_1"), bot_device(1, "level_1")}});
    const WalkGrid grid(match.physics(), ground_bounds(data->arena));
    const vec3 beside_the_bowl{0.96, 0, -1.9};
    const int cell = grid.cell_at(beside_the_bowl);
    EXPECT_FALSE(grid.in_large_region(cell));
    const int way = grid.nearest_way(cell, beside_the_bowl);
    EXPECT_TRUE(grid.in_large_region(way));
    EXPECT_LT(glm::distance(grid.centre_of(way), beside_the_bowl), 1);
    EXPECT_NEAR(grid.height(way), 0, 0.01);
    const int parapet = grid.cell_at({-9.5, 4, 8.3});
    EXPECT_FALSE(grid.in_large_region(parapet));
    EXPECT_NEAR(grid.height(grid.nearest_way(parapet, {-9.5, 4, 8.4})), 3, 0.01) << "not down into the well";
    EXPECT_TRUE(grid.in_large_region(grid.cell_at({-9, 3, 10.5})));
}

TEST(ArenaWays, TheGridHasTheSizeOfTheGround) {
    const auto data = arena_data("yard", assets_with_yard());
    const Simulation match(data, {1, {bot_device(0, "level_1"), bot_device(1, "level_1")}});
    const WalkGrid grid(match.physics(), ground_bounds(data->arena));
    EXPECT_EQ(grid.cells(), 14 * 26);
    EXPECT_TRUE(grid.covers({30.5, 0, -29.5}));
    EXPECT_FALSE(grid.covers({29.5, 0, -20}));
    EXPECT_EQ(grid.cell_at({0, 0, 0}), grid.cell_at({30.2, 0, -4.2})) << "clamped to the nearest cell";
    for (const vec3 place : {vec3(30.5, 0, -29.5), vec3(43.5, 0, -4.5), vec3(36.5, 0, -12.5)})
        EXPECT_EQ(grid.centre_of(grid.cell_at(place)), place);
    EXPECT_NEAR(grid.height(grid.cell_at({37, 0, -6})), 2, 0.01) << "the deck";
    EXPECT_NEAR(grid.height(grid.cell_at({37, 0, -15})), 0, 0.01) << "the yard";
}

TEST(ArenaWays, ABotInTheWellSwingsOverTheGapOfItsGallery) {
    const auto data = arena_data("the_well", assets());
    const Simulation match(data, {1, {bot_device(0, "level_1"), bot_device(1, "level_1")}});
    const WalkGrid grid(match.physics(), ground_bounds(data->arena));
    const auto crossings = find_crossings(match, grid);
    ASSERT_EQ(crossings.size(), 4U) << "the anchors over the two gaps, both ways";
    for (const auto& c : crossings) {
        EXPECT_NEAR(c.from.y, 3, 0.01);
        EXPECT_FALSE(grid.straight(c.from, c.to));
    }
}

// Matches in each arena -------------------------------------------------------------------------------------

struct MatchReport {
    int kills{};
    double longest_rest{};            ///< longest time for which a living bot moved less than 1 m (s)
    std::array<double, 2> heights{};  ///< lowest and highest height of a living bot's feet (m, world)
    Ending ending{};
};

/// Plays one round to its end and records where the bots are.
MatchReport play_round(const std::filesystem::path& folder, std::shared_ptr<const MatchData> data,
                       const std::string& bot, std::uint64_t seed) {
    auto duel = make_bot_duel(folder, std::move(data), {bot, bot}, seed).value();
    MatchReport report{.heights = {1e9, -1e9}};
    std::array<vec3, players> rested{};
    std::array<Tick, players> since{};
    const auto& match = *duel.match;
    while (match.match().phase == Phase::playing) {
        duel.run(100);
        for (std::uint32_t p = 0; p < players; ++p) {
            const auto wizard = wizard_of(match.world(), p);
            const auto at = match.world().get<Motion>(wizard).position;
            const bool dead = match.world().has<Dead>(wizard);
            if (dead || glm::distance(at, rested[p]) > 1) rested[p] = at, since[p] = match.now();
            report.longest_rest = std::max(report.longest_rest, seconds(match.now() - since[p]));
            if (dead) continue;
            const double feet = at.y - match.data().wizard.height / 2;
            report.heights = {std::min(report.heights[0], feet), std::max(report.heights[1], feet)};
        }
    }
    report.ending = match.match().ending;
    match.world().view<const Score>().each([&](const Score& score) { report.kills += score.deaths; });
    return report;
}

void expect_a_lively_round(const MatchReport& report, double upper_level) {
    EXPECT_GE(report.kills, 1);
    EXPECT_LT(report.longest_rest, 20) << "nobody is stuck";
    EXPECT_GT(report.heights[0], -0.2) << "nobody falls out of the arena";
    EXPECT_LT(report.heights[0], 0.2) << "somebody was on the lower level";
    EXPECT_GT(report.heights[1], upper_level - 0.2) << "somebody was on the upper level";
}

TEST(ArenaMatch, BotsOfEveryLevelPlayTheWellToTheEnd) {
    // Rounds last up to 240 s, because the easiest bots need more than 120 s for a kill in a fifth of the
    // rounds.
    const auto data = arena_data("the_well", assets(), {"quick.kills=1", "quick.seconds=240"});
    for (const auto* bot : {"level_1", "level_2", "level_3"}) {
        SCOPED_TRACE(bot);
        expect_a_lively_round(play_round(assets(), data, bot, 21), 3);
    }
}

TEST(ArenaMatch, AnArenaThatOnlyATestHasIsPlayed) {
    const auto folder = assets_with_yard();
    const auto report = play_round(folder, arena_data("yard", folder, {"quick.seconds=60"}), "level_3", 4);
    expect_a_lively_round(report, 2);
}

TEST(ArenaMatch, ALogOfTheWellPlaysAgainToTheSameHashes) {
    auto duel = make_bot_duel(assets(), arena_data("the_well", assets()), {"level_2", "level_3"}, 9).value();
    duel.run(ticks(5.0));
    auto again = make_bot_duel(assets(), arena_data("the_well", assets()), {"level_2", "level_3"}, 9).value();
    again.run(ticks(5.0));
    EXPECT_EQ(duel.match->state_hash(), again.match->state_hash());
    EXPECT_EQ(duel.match->force_hash(), again.match->force_hash());
}

}  // namespace
}  // namespace thaum::game::test

// Compares haptic modes (rules that turn a field into forces) with analytic fields.
#include <gtest/gtest.h>

#include <algorithm>

#include "field/analytic.h"
#include "haptics/modes.h"
#include "tests/scenes/scanned_volumes.h"

namespace thaum::haptics {
namespace {

using bench::TouchedModes;
using field::field_of;
using field::Scalar;
using field::Vector;

ModeUse use_of(std::string_view name, const field::AnyField& field, field::TransferFunction strength) {
    ModeUse use{find_mode(name), field, {}};
    use.settings.strength = strength;
    return use;
}

template <class Source>
field::AnyField scalar_field(const Source& source) {
    return any_field(field_of<Scalar>(source));
}
template <class Source>
field::AnyField vector_field(const Source& source) {
    return any_field(field_of<Vector>(source));
}

/// Haptic primitives (points, lines and planes that hold the proxy, and forces) that one mode adds for an
/// input.
PrimitiveSet set_of(const ModeUse& use, const ModeInput& input) {
    PrimitiveSet set;
    EXPECT_EQ(add_modes(std::span(&use, 1), input, set), 0U);
    return set;
}

// ---- modes in vortices ------------------------------------------------------------------------------------

const field::RankineVortex vortex{
    .middle = {0.01, 0, -0.02}, .axis = glm::normalize(vec3(1, 2, 3)), .radius = 0.03, .speed = 0.6};

/// Unit vector from a position straight towards the vortex's axis.
vec3 inward(vec3 place) {
    const vec3 off = vortex.middle - place;
    return glm::normalize(off - glm::dot(off, vortex.axis) * vortex.axis);
}

/// Positions within the vortex's core, but not on its axis.
std::vector<vec3> places_in_core() {
    std::vector<vec3> places;
    const vec3 a = perpendicular_to(vortex.axis), b = glm::cross(vortex.axis, a);
    for (int i = 0; i < 12; ++i) {
        const double turn = 0.5 * i, out = 0.002 * (i + 1);
        places.push_back(vortex.middle + out * (det::cos(turn) * a + det::sin(turn) * b) +
                         0.004 * i * vortex.axis);
    }
    return places;
}

TEST(HapticModes, TheVortexCorePullsStraightToTheAxis) {
    for (const vec3 place : places_in_core()) {
        const auto set =
            set_of(use_of("vortex_core", vector_field(vortex), field::constant(2)), {.proxy = place});
        ASSERT_EQ(set.items().size(), 1U);
        EXPECT_EQ(set.items()[0].kind, PrimitiveKind::directed);
        EXPECT_LE(glm::distance(set.items()[0].direction, inward(place)), 1e-12);
        EXPECT_EQ(set.items()[0].strength, 2);
    }
}

TEST(HapticModes, AVortexTubeIsFreeInwardAndAlongAndHoldsOutward) {
    const vec3 start = places_in_core()[5], in = inward(start);
    TouchedModes hand{{use_of("vortex_tube", vector_field(vortex), field::constant(5))}};
    for (const auto& [way, held] : {std::pair{in, false}, {vortex.axis, false}, {-in, true}}) {
        hand.start(start);
        vec3 force(0);
        for (int tick = 1; tick <= 50; ++tick) force = hand.move(start + 2e-5 * tick * way);
        EXPECT_NEAR(glm::dot(force, -way), held ? 300 * 50 * 2e-5 : 0, 1e-9);
        EXPECT_LE(glm::length(force - glm::dot(force, way) * way), 1e-9);
    }
}

TEST(HapticModes, AFlowWithoutCurlHasNoTubes) {
    const vec3 outside = vortex.middle + 1.5 * vortex.radius * perpendicular_to(vortex.axis);
    for (const auto* name : {"vortex_tube", "vortex_core", "snap_core"}) {
        const auto set =
            set_of(use_of(name, vector_field(vortex), field::window(0, 1, 0, 5)), {.proxy = outside});
        ASSERT_EQ(set.items().size(), 1U) << name;
        EXPECT_LE(set.items()[0].strength, 1e-12) << name;
    }
}

TEST(HapticModes, ABeltramiFlowHasNoTubesBecauseItsCurlRunsAlongIt) {
    const field::BeltramiFlow flow{.strength = {1, 0.7, 0.4}, .wave = 60};
    for (int i = 0; i < 50; ++i) {
        const vec3 place = 0.05 * bench::even_direction(i, 50);
        for (const auto* name : {"vortex_tube", "vortex_core"}) {
            const auto set =
                set_of(use_of(name, vector_field(flow), field::window(0, 1, 0, 5)), {.proxy = place});
            EXPECT_LE(set.items()[0].strength, 1e-11) << name;
        }
    }
}

TEST(HapticModes, SnappingToACoreIsExactInACoreThatTurnsLikeASolid) {
    for (const vec3 place : places_in_core()) {
        auto use = use_of("snap_core", vector_field(vortex), field::constant(2));
        use.settings.reach = 0.05;
        const Primitive line = set_of(use, {.proxy = place}).items()[0];
        const vec3 off = line.position - vortex.middle;
        EXPECT_EQ(line.kind, PrimitiveKind::line);
        EXPECT_LE(glm::length(off - glm::dot(off, vortex.axis) * vortex.axis), 1e-12);
        EXPECT_LE(glm::length(glm::cross(line.direction, vortex.axis)), 1e-12);
        use.settings.reach = 1e-4;  // shorter than the distance between proxy and axis, so nothing snaps
        EXPECT_EQ(set_of(use, {.proxy = place}).items()[0].strength, 0);
    }
}

// ---- modes that push or resist ----------------------------------------------------------------------------

TEST(HapticModes, GradientAndForcePushWithTheMappedStrength) {
    const field::Plane slope{.through = {}, .normal = glm::normalize(vec3(1, -2, 2))};
    const auto up =
        set_of(use_of("gradient", scalar_field(slope), field::window(0, 2, 0, 4)), {.proxy = {1, 2, 3}});
    EXPECT_LE(glm::distance(up.items()[0].direction, -slope.normal), 1e-12);
    EXPECT_NEAR(up.items()[0].strength, 2, 1e-12);  // expected for a gradient of length 1
    // A negative strength reverses the force.
    const auto down =
        set_of(use_of("gradient", scalar_field(slope), field::constant(-3)), {.proxy = {1, 2, 3}});
    EXPECT_LE(glm::distance(down.items()[0].direction, slope.normal), 1e-12);
    EXPECT_EQ(down.items()[0].strength, 3);

    const vec3 place = places_in_core()[3], flow = vortex(place).value;
    const auto along =
        set_of(use_of("force", vector_field(vortex), field::window(0, 1, 0, 2)), {.proxy = place});
    EXPECT_LE(glm::distance(along.items()[0].direction, glm::normalize(flow)), 1e-12);
    EXPECT_NEAR(along.items()[0].strength, 2 * glm::length(flow), 1e-12);
}

TEST(HapticModes, FollowHoldsAcrossTheFlowUpToItsStrengthAndFreesAlongIt) {
    const auto uniform = [](vec3) { return Vector{{0, 0, 2}, {}}; };
    TouchedModes hand{{use_of("follow", vector_field(uniform), field::constant(0.5))}};
    hand.start(vec3(0));
    EXPECT_LE(glm::length(hand.move({0, 0, 0.01})), 1e-12);
    const vec3 across = hand.move({0.001, 0, 0.01});
    EXPECT_LE(glm::distance(across, vec3(-0.3, 0, 0)), 1e-12);
    for (int i = 0; i < 20; ++i) hand.move({0.01, 0, 0.01});
    EXPECT_NEAR(glm::length(hand.move({0.02, 0, 0.01})), 0.5, 1e-12);
}

TEST(HapticModes, ViscosityHoldsTheProxyBackWithTheMappedStrength) {
    const field::Sphere ball{.middle = {}, .radius = 0.05};
    TouchedModes hand{{use_of("viscosity", scalar_field(ball), field::window(0, 0.05, 0, 1))}};
    hand.start({0.02, 0, 0});
    vec3 force(0);
    for (int tick = 0; tick < 200; ++tick) force = hand.move({0.02, 1e-4 * tick, 0});
    // The proxy lags behind the tip; the strength is computed from the depth of the proxy in the last tick.
    EXPECT_NEAR(force.y, -ball(hand.proxy - vec3(0, 1e-4, 0)).value / 0.05, 1e-4);
    EXPECT_NEAR(force.x, 0, 1e-12);
}

TEST(HapticModes, ASurfaceHoldsWithFrictionInProportionToItsPush) {
    const field::Plane ground{.through = {}, .normal = {0, -1, 0}};  // a field whose values increase upwards
    auto use = use_of("surface", scalar_field(ground), field::constant(5));
    use.settings.friction = field::constant(0.4);
    TouchedModes hand{{use}};
    hand.start(vec3(0));
    for (int tick = 0; tick <= 50; ++tick) hand.move({0, -1e-4 * tick, 0});
    // The tip is 5 mm deep (1.5 N). The proxy sticks as long as the tangential force is below 0.6 N.
    EXPECT_LE(glm::distance(hand.move({0.001, -0.005, 0}), vec3(-0.3, 1.5, 0)), 1e-9);
    for (int tick = 0; tick < 100; ++tick) hand.move({0.001 + 1e-4 * tick, -0.005, 0});
    EXPECT_LE(glm::distance(hand.move({0.011, -0.005, 0}), vec3(-0.6, 1.5, 0)), 1e-9);
    // A push above the strength of the mode breaks through the surface. The friction then follows from the
    // mode's strength, not from the push.
    for (int tick = 0; tick < 300; ++tick) hand.move({0.011 + 1e-4 * tick, -0.005 - 1e-4 * tick, 0});
    const vec3 through = hand.move({0.041, -0.035, 0});
    EXPECT_NEAR(through.y, 5, 1e-6);
    EXPECT_NEAR(-through.x, 2, 1e-6);
}

TEST(HapticModes, SnapToGridHoldsAtTheNearestPoint) {
    const field::Plane slope{};
    auto use = use_of("snap_grid", scalar_field(slope), field::constant(0.5));
    use.settings.pitch = 0.01;
    use.settings.reach = 0.004;
    TouchedModes hand{{use}};
    hand.start({0.0205, -0.0105, 0.0003});
    hand.move({0.0205, -0.0105, 0.0003});
    EXPECT_LE(glm::distance(hand.proxy, vec3(0.02, -0.01, 0)), 1e-12);
    hand.start({0.025, -0.01, 0});  // the hand is farther from the grid point than the reach
    EXPECT_LE(glm::length(hand.move({0.025, -0.01, 0})), 1e-12);
}

TEST(HapticModes, TheGridTurnsAndMovesWithItsVolume) {
    const field::Plane slope{};
    field::PlacedField placed;
    const double c = std::cos(0.6), s = std::sin(0.6);
    const field::Placement at{
        .origin = {0.003, 0.002, -0.001}, .turn = {{c, 0, -s}, {0, 1, 0}, {s, 0, c}}, .scale = 1.5};
    field::place(placed, scalar_field(slope), at);
    auto use = use_of("snap_grid", placed.field, field::constant(0.5));
    use.settings.pitch = 0.01;
    use.settings.reach = 0.004;
    TouchedModes hand{{use}};
    const vec3 point = at.origin + at.turn * vec3(0.02, -0.01, 0);
    hand.start(point + vec3(0.0005, -0.0005, 0.0003));
    hand.move(point + vec3(0.0005, -0.0005, 0.0003));
    EXPECT_LE(glm::distance(hand.proxy, point), 1e-12);
}

// ---- combinations and faults of modes ---------------------------------------------------------------------

TEST(HapticModes, EveryModeReadsOneKindOfFieldAndIsListedByName) {
    const auto all = modes();
    EXPECT_GE(all.size(), 10U);
    EXPECT_TRUE(std::ranges::is_sorted(all, {}, &Mode::name));
    EXPECT_EQ(modes_for(FieldKind::scalar).size() + modes_for(FieldKind::vector).size(), all.size());
    EXPECT_EQ(find_mode("no such mode"), nullptr);
    std::size_t places = 0;
    for (const Mode& mode : all) {
        EXPECT_FALSE(mode.about.empty() || mode.property.empty()) << mode.name;
        EXPECT_EQ(find_mode(mode.name), &mode);
        places += mode.primitives;
    }
    EXPECT_LE(places, primitive_capacity);  // all primitives of all modes fit together
}

TEST(HapticModes, EveryFieldIsOfferedEveryModeDirectlyOrThroughAFilter) {
    for (const FieldKind kind : {FieldKind::scalar, FieldKind::vector}) {
        const auto offers = mode_offers(kind);
        for (const Mode& mode : modes()) {
            const auto found = std::ranges::find(offers, &mode, &ModeOffer::mode);
            ASSERT_NE(found, offers.end()) << mode.name;
            EXPECT_EQ(found->through.has_value(), mode.reads != kind) << mode.name;
        }
        for (const ModeOffer& offer : offers) {
            if (!offer.through) continue;
            const field::Filter filter{*offer.through};
            const auto vector = field::checked_filters(std::span(&filter, 1), kind == FieldKind::vector);
            ASSERT_TRUE(vector) << offer.mode->name;
            EXPECT_EQ(*vector, offer.mode->reads == FieldKind::vector) << offer.mode->name;
        }
    }
}

TEST(HapticModes, AModeFeelsAFieldThroughAFilter) {
    // The speed of a vortex is felt as a viscosity, and the gradient of a ball's depth guides the hand like a
    // flow.
    field::FilteredField speed, slope;
    const field::Filter magnitude{field::FilterKind::magnitude}, gradient{field::FilterKind::gradient};
    const field::Plane plane{.through = {}, .normal = glm::normalize(vec3(2, 1, -2))};
    ASSERT_TRUE(field::set_filters(speed, {.field = vector_field(vortex)}, std::span(&magnitude, 1)));
    ASSERT_TRUE(field::set_filters(slope, {.field = scalar_field(plane)}, std::span(&gradient, 1)));
    const vec3 place = places_in_core()[4];
    const Mode& viscosity = *find_mode("viscosity");
    const auto slow =
        set_of(use_of("viscosity", field_for(viscosity, speed), field::window(0, 1, 0, 2)), {.proxy = place});
    EXPECT_NEAR(slow.items()[0].strength, 2 * glm::length(vortex(place).value), 1e-12);
    const Mode& follow = *find_mode("follow");
    const auto line =
        set_of(use_of("follow", field_for(follow, slope), field::constant(1)), {.proxy = place});
    EXPECT_LE(glm::distance(line.items()[0].direction, -plane.normal), 1e-9);
}

TEST(HapticModes, ModesAddUpToTheSumOfTheirForces) {
    const field::Plane slope{.through = {}, .normal = {0, -1, 0}};
    const auto wind = [](vec3) { return Vector{{1, 0, 0}, {}}; };
    TouchedModes hand{{use_of("gradient", scalar_field(slope), field::constant(0.2)),
                       use_of("force", vector_field(wind), field::constant(0.7))}};
    hand.start(vec3(0));
    EXPECT_LE(glm::distance(hand.move(vec3(0)), vec3(0.7, 0.2, 0)), 1e-12);
}

TEST(HapticModes, AModeWithoutRoomOrForAnotherKindOfFieldIsLeftOut) {
    const field::Plane slope{};
    std::vector<ModeUse> uses(10, use_of("surface", scalar_field(slope), field::constant(1)));
    uses.push_back(use_of("force", scalar_field(slope), field::constant(1)));
    uses.push_back({});
    PrimitiveSet set;
    EXPECT_EQ(add_modes(uses, {}, set), 4U);
    EXPECT_EQ(set.items().size(), primitive_capacity);
}

TEST(HapticModes, FieldsWithoutDirectionAndFaultyFieldsGiveNoForce) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN(), inf = HUGE_VAL;
    static const std::array<Scalar, 6> scalars{Scalar{1, vec3(0)}, {nan, vec3(nan)},  {inf, {1, 0, 0}},
                                               {nan, {1, 0, 0}},   {-inf, vec3(inf)}, {0, vec3(0)}};
    for (std::size_t i = 0; i < scalars.size(); ++i) {
        const auto scalar = [i](vec3) { return scalars[i]; };
        const auto vector = [i](vec3) {
            return Vector{scalars[i].gradient, {scalars[i].gradient, vec3(0), scalars[i].gradient}};
        };
        for (const Mode& mode : modes()) {
            // The modes viscosity and snap_grid need no direction.
            if (mode.name == "viscosity" || mode.name == "snap_grid") continue;
            const bool is_scalar = mode.reads == FieldKind::scalar;
            const auto use = use_of(mode.name, is_scalar ? scalar_field(scalar) : vector_field(vector),
                                    field::constant(3));
            const auto set = set_of(use, {.proxy = {0.001, 0, 0}});
            EXPECT_EQ(set.items().size(), mode.primitives) << mode.name << " " << i;
            // In cases 2 and 3 the vector has the length 1, so there may be a force.
            const bool good = (i == 2 || i == 3) && !is_scalar;
            for (const Primitive& p : set.items()) {
                EXPECT_TRUE(good || p.strength == 0) << mode.name << " " << i;
            }
        }
    }
}

TEST(HapticModes, AStrengthThatIsNotFiniteIsNone) {
    const field::Plane slope{};
    for (const double strength : {HUGE_VAL, -HUGE_VAL, std::numeric_limits<double>::quiet_NaN()}) {
        field::TransferFunction function;
        function.count = 1;
        function.points[0] = {0, strength};
        for (const Mode* mode : modes_for(FieldKind::scalar)) {
            const auto set = set_of(use_of(mode->name, scalar_field(slope), function), {});
            for (const Primitive& p : set.items()) EXPECT_EQ(p.strength, 0) << mode->name;
        }
    }
}

}  // namespace
}  // namespace thaum::haptics

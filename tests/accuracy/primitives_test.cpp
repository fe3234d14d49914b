// Compares the proxy of small sets of haptic primitives with closed forms. Also tests which input is refused.
#include "haptics/primitives/balance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace thaum::haptics {
namespace {

constexpr double k = 300;        // stiffness of the spring (N/m)
constexpr double close = 1e-15;  // tolerance of positions (m)

PrimitiveSet set_of(const std::vector<Primitive>& list) { return checked(list).value(); }
Primitive point(vec3 p, double s) { return {PrimitiveKind::point, p, {}, s}; }
Primitive line(vec3 p, vec3 q, double s) { return {PrimitiveKind::line, p, q, s}; }
Primitive plane(vec3 p, vec3 q, double s) { return {PrimitiveKind::plane, p, q, s}; }
Primitive directed(vec3 q, double s) { return {PrimitiveKind::directed, {}, q, s}; }

void expect_at(const Balance& found, vec3 proxy, vec3 centre) {
    EXPECT_LT(glm::length(found.proxy - proxy), close);
    EXPECT_LT(glm::length(found.force - k * (proxy - centre)), 1e-12);
    EXPECT_LE(found.residual, 1e-12);
}

TEST(Primitives, NoneLeaveTheProxyAtTheCentre) {
    expect_at(balance({}, {{1, 2, 3}, k}), {1, 2, 3}, {1, 2, 3});
    const auto nothing = set_of({point({0, 0, 0}, 0), line({0, 0, 0}, {1, 0, 0}, 0), directed({0, 1, 0}, 0)});
    expect_at(balance(nothing, {{1, 2, 3}, k}), {1, 2, 3}, {1, 2, 3});
}

TEST(Primitives, ADirectedForceShiftsTheProxy) {
    expect_at(balance(set_of({directed({0, 1, 0}, 3)}), {{}, k}), {0, 0.01, 0}, {});
}

TEST(Primitives, APointHoldsWithinStrengthOverStiffness) {
    // The point holds the proxy if the probe is within 0.01 m.
    const auto set = set_of({point({0.1, 0, 0}, 3)});
    for (const double d : {0.0, 1e-12, 0.005, 0.0099}) {
        expect_at(balance(set, {{0.1 + d, 0, 0}, k}), {0.1, 0, 0}, {0.1 + d, 0, 0});
    }
    expect_at(balance(set, {{0.1, 0.011, 0}, k}), {0.1, 0.001, 0}, {0.1, 0.011, 0});
    expect_at(balance(set, {{0.1, 0, -5}, k}), {0.1, 0, -4.99}, {0.1, 0, -5});
}

TEST(Primitives, ALineHoldsAcrossAndLeavesFreeAlong) {
    const auto set = set_of({line({0, 0.1, 0}, {0, 0, 1}, 3)});
    expect_at(balance(set, {{0.003, 0.104, 7}, k}), {0, 0.1, 7}, {0.003, 0.104, 7});
    expect_at(balance(set, {{0, 0.12, 7}, k}), {0, 0.11, 7}, {0, 0.12, 7});
}

TEST(Primitives, APlaneIsAWallThatYields) {
    const auto set = set_of({plane({0, 0.1, 0}, {0, 1, 0}, 3)});
    expect_at(balance(set, {{5, 0.2, 1}, k}), {5, 0.2, 1}, {5, 0.2, 1});  // above the plane there is no force
    // A probe that is pushed against the plane: the plane holds the proxy.
    expect_at(balance(set, {{5, 0.095, 1}, k}), {5, 0.1, 1}, {5, 0.095, 1});
    // A probe that is pushed through the plane: the plane exerts its full strength.
    expect_at(balance(set, {{5, 0.08, 1}, k}), {5, 0.09, 1}, {5, 0.08, 1});
}

TEST(Primitives, TwoPlanesHoldInTheirEdge) {
    const auto set = set_of({plane({}, {1, 0, 0}, 3), plane({}, {0, 1, 0}, 2)});
    expect_at(balance(set, {{-0.005, -0.004, 0.3}, k}), {0, 0, 0.3}, {-0.005, -0.004, 0.3});
    const Balance oblique =
        balance(set_of({plane({}, {1, 0, 0}, 3), plane({}, {0.6, 0.8, 0}, 3)}), {{-0.004, -0.004, 1}, k});
    // The planes' forces s1 (along x) and s2 (oblique) balance the spring: 0.8 s2 = 1.2 N, and s1 + 0.6 s2 =
    // 1.2 N.
    expect_at(oblique, {0, 0, 1}, {-0.004, -0.004, 1});
    EXPECT_LT(glm::length(oblique.primitive[1] - vec3(0.9, 1.2, 0)), 1e-12);
    EXPECT_LT(glm::length(oblique.primitive[0] - vec3(0.3, 0, 0)), 1e-12);
}

TEST(Primitives, ThreePlanesHoldInTheirCorner) {
    const vec3 corner(0.1, 0.2, 0.3);
    const auto set =
        set_of({plane(corner, {1, 0, 0}, 3), plane(corner, {0, 1, 0}, 3), plane(corner, {0, 0, 1}, 3)});
    const vec3 centre = corner - vec3(0.004, 0.006, 0.009);
    const Balance found = balance(set, {centre, k});
    expect_at(found, corner, centre);
    EXPECT_LT(glm::length(found.primitive[2] - vec3(0, 0, 2.7)), 1e-12);
}

TEST(Primitives, APlaneHoldsBesideAPointThatPullsThroughIt) {
    // The plane can exert 3 N, which is enough against the point's 2 N and the spring's 0.3 N.
    const auto set = set_of({plane({}, {0, 1, 0}, 3), point({0, -0.5, 0}, 2)});
    expect_at(balance(set, {{0, -0.001, 0}, k}), {}, {0, -0.001, 0});
}

TEST(Primitives, APointOnAPlaneAndOnALineAddsUp) {
    const auto set = set_of({plane({}, {0, 1, 0}, 1), point({}, 1), line({}, {0, 0, 1}, 1)});
    // The spring pulls with 2.7 N. Plane, point and line together can hold 3 N.
    expect_at(balance(set, {{0, -0.009, 0}, k}), {}, {0, -0.009, 0});
    // The spring pulls with 3.3 N, more than the 3 N that plane, point and line together can hold.
    expect_at(balance(set, {{0, -0.011, 0}, k}), {0, -0.001, 0}, {0, -0.011, 0});
    // The spring pulls with 1.8 N in the direction in which the plane gives no force. Point and line alone
    // can hold 2 N.
    expect_at(balance(set, {{0, 0.006, 0}, k}), {}, {0, 0.006, 0});
}

TEST(Primitives, CoincidentAndOppositeOnesAreOne) {
    const auto twice = set_of({point({}, 1), point({}, 2)});
    expect_at(balance(twice, {{0.0099, 0, 0}, k}), {}, {0.0099, 0, 0});
    expect_at(balance(twice, {{0.011, 0, 0}, k}), {0.001, 0, 0}, {0.011, 0, 0});
    // Two planes that hold the proxy from both sides.
    const auto slab = set_of({plane({}, {0, 1, 0}, 3), plane({}, {0, -1, 0}, 3)});
    expect_at(balance(slab, {{1, 0.009, 1}, k}), {1, 0, 1}, {1, 0.009, 1});
    expect_at(balance(slab, {{1, -0.012, 1}, k}), {1, -0.002, 1}, {1, -0.012, 1});
}

TEST(Primitives, ATensionRingFindsFermatsPoint) {
    // Three strong points and a negligible spring: the proxy is where the points are seen 120 degrees apart.
    const double h = std::sqrt(3.0) / 2;
    const auto set = set_of({point({1, 0, 0}, 1), point({-0.5, h, 0}, 1), point({-0.5, -h, 0}, 1)});
    const Balance found = balance(set, {{}, 1e-3});
    EXPECT_LT(glm::length(found.proxy), 1e-12);
}

TEST(Primitives, OnTheEdgeOfCaptureTheProxyIsExact) {
    const auto set = set_of({point({0.1, 0, 0}, 3)});
    for (const double beyond : {-1e-9, -1e-12, -1e-15, 0.0, 1e-15, 1e-12, 1e-9}) {
        const Balance found = balance(set, {{0.11 + beyond, 0, 0}, k});
        EXPECT_NEAR(found.proxy.x, 0.1 + std::max(0.0, beyond), 1e-16 + 1e-15);
        EXPECT_LE(found.residual, 1e-12);
    }
}

TEST(Primitives, ADamperIsAShiftedStifferSpring) {
    const ProxyCoupling coupling{.stiffness = 300, .damping = 2};
    const vec3 probe(0.1, 0.2, 0.3), velocity(0.01, -0.3, 0), before(0.1, 0.19, 0.31);
    const Spring spring = effective_spring(coupling, probe, velocity, before, 1e-3);
    EXPECT_NEAR(spring.stiffness, 2300, 1e-9);
    for (const vec3 x : {vec3(0.1, 0.2, 0.3), vec3(0.12, 0.15, 0.28)}) {
        const vec3 force = 300.0 * (probe - x) + 2.0 * (velocity - (x - before) / 1e-3);
        EXPECT_LT(glm::length(spring.stiffness * (spring.centre - x) - force), 1e-10);
    }
    EXPECT_EQ(effective_spring(coupling, {1, 1, 1}, {}, {1, 1, 1}, 1e-3).centre, vec3(1, 1, 1));
}

// ---- primitives that are refused --------------------------------------------------------------------------

TEST(Primitives, WhatHasAFaultIsRefusedByNameAndLeavesTheSet) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    constexpr double infinity = std::numeric_limits<double>::infinity();
    using Fault = PrimitiveFault;
    const auto fault = [](const Primitive& p) {
        PrimitiveSet set;
        const auto result = set.add(p);
        EXPECT_TRUE(set.items().empty() || result == Fault::none);
        return result;
    };
    EXPECT_EQ(fault(point({nan, 0, 0}, 1)), Fault::not_finite);
    EXPECT_EQ(fault(point({}, infinity)), Fault::not_finite);
    EXPECT_EQ(fault(point({}, nan)), Fault::not_finite);
    EXPECT_EQ(fault(line({}, {nan, 0, 0}, 1)), Fault::not_finite);
    EXPECT_EQ(fault(point({}, -1e-300)), Fault::negative);
    EXPECT_EQ(fault(line({}, {}, 1)), Fault::not_unit);
    EXPECT_EQ(fault(plane({}, {0, 1.1, 0}, 1)), Fault::not_unit);
    EXPECT_EQ(fault(point({0, 2e6, 0}, 1)), Fault::out_of_range);
    EXPECT_EQ(fault(point({}, 2e6)), Fault::out_of_range);
    // A point has no direction, so NaN is allowed there.
    EXPECT_EQ(fault({PrimitiveKind::point, {}, {nan, nan, nan}, 1}), Fault::none);
    EXPECT_EQ(fault({PrimitiveKind::directed, {nan, 0, 0}, {1, 0, 0}, 1}),
              Fault::none);  // a directed force has no position, so NaN is allowed there
    EXPECT_EQ(fault(plane({}, {0, 1 + 1e-9, 0}, 1)), Fault::none);
}

TEST(Primitives, ADirectionIsMadeUnit) {
    PrimitiveSet set;
    set.add(directed({0, 1 + 9e-7, 0}, 1));
    EXPECT_EQ(set.items()[0].direction, vec3(0, 1, 0));
}

TEST(Primitives, AListIsTakenWholeOrNot) {
    std::vector<Primitive> list(16, point({}, 1));
    EXPECT_EQ(checked(list)->items().size(), 16U);
    list.push_back(point({}, 1));
    EXPECT_NE(checked(list).error().message.find("primitive 16: the set is full"), std::string::npos);
    list = {point({}, 1), point({}, -1)};
    EXPECT_EQ(checked(list).error().message, "primitive 1: strength is negative: give 0 or more");
}

TEST(Primitives, ASpringOutOfRangeGivesNoForce) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    const auto set = set_of({point({}, 1)});
    for (const Spring& spring :
         {Spring{{nan, 0, 0}, k}, Spring{{}, nan}, Spring{{}, 0}, Spring{{}, -1}, Spring{{0, 1e7, 0}, k}}) {
        const Balance found = balance(set, spring);
        EXPECT_EQ(found.residual, std::numeric_limits<double>::infinity());
        EXPECT_EQ(found.force, vec3(0));
    }
}

}  // namespace
}  // namespace thaum::haptics

// Tests the accuracy of the proxy that balances a spring against random and degenerate sets of haptic
// primitives: by an independent residual, by the properties of a proximal map, and by brute-force search.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "accuracy/primitives_judge.h"
#include "haptics/primitives/balance.h"
#include "tests/scenes/primitive_sets.h"
#include "unit/allocations.h"

namespace thaum::haptics {
namespace {

using sets::Case;
using sets::Scale;

/// Accuracy of a position within the set of primitives (m): far above rounding errors, far below an encoder's
/// resolution.
double touching(const Scale& scale) { return 1e-13 * (scale.size + scale.strength / scale.stiffness); }

struct Worst {
    double residual = 0;
    double fault = 0;
    void add(const Case& c, const Scale& scale) {
        const Balance found = balance(c.set, c.spring);
        residual = std::max(residual, found.residual);
        fault = std::max(fault, sets::fault(c.set, c.spring, found, touching(scale)));
    }
};

TEST(PrimitivesRandom, AHundredThousandSetsBalanceWithinANanonewton) {
    Random random{1};
    const Scale scale;
    Worst worst;
    for (int i = 0; i < 100'000; ++i) worst.add(sets::random_case(random, 1 + random.below(8), scale), scale);
    EXPECT_LE(worst.residual, 1e-9);
    EXPECT_LE(worst.fault, 1e-9);
}

TEST(PrimitivesRandom, SixteenPrimitivesBalance) {
    Random random{2};
    const Scale scale;
    Worst worst;
    for (int i = 0; i < 5'000; ++i) worst.add(sets::random_case(random, 16, scale), scale);
    EXPECT_LE(worst.residual, 1e-9);
    EXPECT_LE(worst.fault, 1e-9);
}

/// Expects balance for one of the few sets of primitives, a few in a million, on which the solver's check of
/// optimality once failed. The spring has 300 N/m.
void expect_balanced(std::initializer_list<Primitive> primitives, vec3 centre) {
    PrimitiveSet set;
    for (const Primitive& p : primitives) ASSERT_EQ(set.add(p), PrimitiveFault::none);
    const Spring spring{centre, 300};
    const Balance found = balance(set, spring);
    EXPECT_LE(found.residual, 1e-12);
    EXPECT_LE(sets::fault(set, spring, found, touching({})), 1e-9);
    EXPECT_LT(found.steps, 60);
}

TEST(PrimitivesRandom, LinesThatCrossBalance) {
    using enum PrimitiveKind;
    // Two crossing lines, each given by a point and a direction. The proxy becomes inaccurate if a solver
    // describes a line by normals that are nearly parallel to the line.
    expect_balanced({{line,
                      {0.0047499410918187346, 0.0041211621887245718, -0.0086053205396185457},
                      {-0.70721573916907943, -0.026820298561281, -0.70648890285454324},
                      1.5423277031913551},
                     {line,
                      {0.0011053190151131109, 0.0039829443199379854, -0.01224619688000724},
                      {0.97665022477503138, 0.057702544857714554, -0.2069414283410265},
                      2.9956764385774504}},
                    {0.0047499410918187346, 0.0041211621887245718, -0.0086053205396185457});
}

TEST(PrimitivesRandom, LinesThroughTheOriginBalance) {
    using enum PrimitiveKind;
    // Lines through the world's origin, where coordinates are near zero and give no scale for rounding. One
    // line exerts its full strength.
    expect_balanced({{plane,
                      {0.0070340789584497259, 0.0025576690495779089, 0.0064541416609062057},
                      {-0.76690165594063398, -0.074891806346451789, -0.63737984550633475},
                      2.4456087765021346},
                     {directed,
                      {0.0024785146631532509, -0.0090250077076467778, -0.0038315470058384628},
                      {-0.76690165594063398, -0.074891806346451789, -0.63737984550633475},
                      0.29316082664550747},
                     {point,
                      {0.0070340789584497259, 0.0025576690495779089, 0.0064541416609062057},
                      {-0.76690165594063398, -0.074891806346451789, -0.63737984550633475},
                      2.4815562315560191},
                     {point,
                      {0.0070340789584497259, 0.0025576690495779089, 0.0064541416609062057},
                      {0.76690165594063398, 0.074891806346451789, 0.63737984550633475},
                      2.5956603611435831},
                     {line, {0, 0, 0}, {1, 0, 0}, 2.25},
                     {line,
                      {0, 0, 0},
                      {0.050659922789109156, 0.096343031965928819, 0.99405814337724407},
                      1.1347032230390051}},
                    {-0.0075218255406441165, -0.0064005220934359496, -0.0076340353066698041});
}

TEST(PrimitivesRandom, APlaneBesideALineThatNearlyMeetsAnotherBalances) {
    using enum PrimitiveKind;
    // A plane holds the proxy 2e-10 m from a line that crosses another one 5e-8 m away.
    expect_balanced({{point,
                      {0.00075195538097018184, -0.0044505912991240756, -0.0094732851300347431},
                      {-0.62989638736790288, -0.66705492178264425, -0.39782945153220517},
                      2.1162141427361876},
                     {line,
                      {0.00075195538097018184, -0.0044505912991240756, -0.0094732851300347431},
                      {0.62989638736790288, 0.66705492178264425, 0.39782945153220517},
                      1.8090435142208612},
                     {directed,
                      {0.0076050064786270253, 0.009251180969485167, -0.0052999765569810963},
                      {0.62989638736790288, 0.66705492178264425, 0.39782945153220517},
                      2.0825026003573308},
                     {line,
                      {0.0059746671823202001, 0.0010802161193792298, -0.0061747290292068387},
                      {0.70115796082588244, -0.70978667018246933, 0.067678628840815283},
                      0.059290622190118492},
                     {plane,
                      {0.0059746671823202001, 0.0010802161193792298, -0.0061747290292068387},
                      {0.70115796082588244, -0.70978667018246933, 0.067678628840815283},
                      2.9579278758076408},
                     {directed,
                      {0.0090920101469053934, 0.010825905218625188, -0.0043608159813036864},
                      {0.68596831228361255, 0.69468834492182518, 0.21646149304794937},
                      0.02765492799316982},
                     {line,
                      {-0.0092684621410081738, 0.0014687888345560408, -0.0074865603151230212},
                      {1, 0, 0},
                      1.1154701145515611}},
                    {0.0060898509456604804, -0.0021128578716546323, 0.0013748109511689988});
}

double f(const PrimitiveSet& set, const Spring& spring, vec3 x) {
    const vec3 d = x - spring.centre;
    double result = spring.stiffness / 2 * glm::dot(d, d);
    for (const Primitive& p : set.items()) {
        const vec3 m = x - p.position;
        const double along = glm::dot(m, p.direction);
        switch (p.kind) {
            case PrimitiveKind::directed: result -= p.strength * glm::dot(x, p.direction); break;
            case PrimitiveKind::point: result += p.strength * glm::length(m); break;
            case PrimitiveKind::line: result += p.strength * glm::length(m - along * p.direction); break;
            case PrimitiveKind::plane: result += p.strength * std::max(0.0, -along); break;
        }
    }
    return result;
}

/// Finds the minimum of the energy without the solver: tries steps in every direction, and halves the step
/// when none leads to a lower value.
vec3 brute_minimum(const PrimitiveSet& set, const Spring& spring, double size, Random& random) {
    vec3 x = spring.centre;
    double best = f(set, spring, x);
    for (double step = size; step > 1e-9 * size; step *= 0.7) {
        for (int i = 0; i < 60; ++i) {
            const vec3 there = x + step * sets::random_direction(random);
            const double value = f(set, spring, there);
            if (value < best) best = value, x = there;
        }
    }
    return x;
}

TEST(PrimitivesRandom, NoSearchFindsALowerPlace) {
    Random random{3};
    const Scale scale;
    for (int i = 0; i < 100; ++i) {
        const Case c = sets::random_case(random, 1 + random.below(8), scale);
        const Balance found = balance(c.set, c.spring);
        const vec3 brute = brute_minimum(c.set, c.spring, scale.size, random);
        const double ours = f(c.set, c.spring, found.proxy);
        const double theirs = f(c.set, c.spring, brute);
        ASSERT_LE(ours, theirs + 1e-15) << i;
        // Strong convexity: |x - minimum|^2 <= 2 (f(x) - f(minimum)) / k.
        ASSERT_LE(glm::length(brute - found.proxy), std::sqrt(2 * (theirs - ours + 1e-15) / scale.stiffness))
            << i;
    }
}

TEST(PrimitivesRandom, ItIsFirmlyNonExpansive) {
    Random random{4};
    const Scale scale;
    for (int i = 0; i < 20'000; ++i) {
        Case c = sets::random_case(random, 1 + random.below(8), scale);
        const vec3 c1 = c.spring.centre;
        const vec3 c2 =
            c1 + scale.size * std::pow(10.0, random.uniform(-6, 0)) * sets::random_direction(random);
        const vec3 x1 = balance(c.set, c.spring).proxy;
        c.spring.centre = c2;
        const vec3 x2 = balance(c.set, c.spring).proxy;
        // For proxies x and spring centres c: |x1 - x2|^2 <= (x1 - x2).(c1 - c2), which implies |x1 - x2| <=
        // |c1 - c2|.
        const double rounding = 1e-14 * scale.size;
        ASSERT_LE(glm::dot(x1 - x2, x1 - x2), glm::dot(x1 - x2, c1 - c2) + rounding * glm::length(c1 - c2))
            << i;
    }
}

TEST(PrimitivesRandom, ATurnedSetHasATurnedProxy) {
    Random random{5};
    const Scale scale;
    for (int i = 0; i < 5'000; ++i) {
        const Case c = sets::random_case(random, 1 + random.below(8), scale);
        const quat turn = rotation(sets::random_direction(random), random.uniform(0, 6));
        PrimitiveSet turned;
        for (Primitive p : c.set.items()) {
            p.position = turn * p.position;
            p.direction = turn * p.direction;
            turned.add(p);
        }
        const Balance a = balance(c.set, c.spring);
        const Balance b = balance(turned, {turn * c.spring.centre, c.spring.stiffness});
        ASSERT_LT(glm::length(turn * a.proxy - b.proxy), 1e-12) << i;
        ASSERT_LT(glm::length(turn * a.force - b.force), 1e-9) << i;
    }
}

TEST(PrimitivesRandom, TheOrderDoesNotMatterBeyondRounding) {
    Random random{6};
    const Scale scale;
    for (int i = 0; i < 5'000; ++i) {
        const Case c = sets::random_case(random, 8, scale);
        PrimitiveSet reversed;
        for (std::size_t j = 8; j-- > 0;) reversed.add(c.set.items()[j]);
        ASSERT_LT(glm::length(balance(c.set, c.spring).force - balance(reversed, c.spring).force), 1e-9) << i;
    }
}

TEST(PrimitivesRandom, ItDependsOnNothingButItsArguments) {
    Random random{7};
    const Case c = sets::random_case(random, 8, {});
    const Balance first = balance(c.set, c.spring);
    for (int i = 0; i < 100; ++i) balance(sets::random_case(random, 8, {}).set, c.spring);
    const Balance second = balance(c.set, c.spring);
    EXPECT_EQ(first.proxy, second.proxy);
    EXPECT_EQ(first.force, second.force);
}

TEST(PrimitivesRandom, ScalesFromTinyToHuge) {
    Random random{8};
    for (const double stiffness : {1e-3, 1.0, 1e3, 1e6}) {
        for (const double strength : {1e-6, 1.0, 1e3}) {
            for (const double size : {1e-9, 1e-3, 1.0, 1e3}) {
                const double ratio = strength / stiffness / size;
                // If forces stretch the spring by more than 1e8 times the set's size, more sets stay
                // unsolved: see TheResidualIsTrueEverywhere.
                if (ratio > 1e8) continue;
                const Scale scale{strength, size, stiffness};
                Worst worst;
                int unsolved = 0;
                for (int i = 0; i < 300; ++i) {
                    const Case c = sets::random_case(random, 1 + random.below(8), scale);
                    if (balance(c.set, c.spring).residual <= 1e-9)
                        worst.add(c, scale);
                    else
                        ++unsolved;
                }
                EXPECT_LE(unsolved, ratio > 1e4 ? 1 : 0) << stiffness << ' ' << strength << ' ' << size;
                EXPECT_LE(worst.fault, 1e-9 + 1e-13 * stiffness * size)
                    << stiffness << ' ' << strength << ' ' << size;
            }
        }
    }
}

TEST(PrimitivesRandom, TheResidualIsTrueEverywhere) {
    Random random{10};
    const auto between = [&random](double low, double high) {
        return std::pow(10, random.uniform(std::log10(low), std::log10(high)));
    };
    int solved = 0;
    constexpr int count = 20'000;
    for (int i = 0; i < count; ++i) {
        // Strength / stiffness, the distance by which a force stretches the spring, is up to 1e21 times the
        // size of the set.
        const Scale scale{between(1e-6, 1e6), between(1e-9, 1e5), between(1e-6, 1e9)};
        const Case c = sets::random_case(random, 1 + random.below(16), scale);
        const Balance found = balance(c.set, c.spring);
        const double proven = sets::proven_bound(c.set, c.spring, found);
        ASSERT_LE(proven, found.residual * (1 + 1e-9) + sets::bound_rounding(c.set, c.spring, found))
            << i << ": strength " << scale.strength << ", size " << scale.size << ", stiffness "
            << scale.stiffness;
        ASSERT_TRUE(is_finite(found.proxy));
        if (found.residual <= std::max(1e-9, 1e-12 * scale.strength)) ++solved;
    }
    EXPECT_GT(solved, 0.98 * count);
}

TEST(PrimitivesRandom, StrengthsThatDwarfTheSetAreBalancedAllTheSame) {
    // With such strengths, the proxy would be moved away by 1e9 times the size of the set. Seen from there,
    // its kinks (places where a force jumps) are indistinguishable.
    const Scale scale{1e3, 1e-6, 1};
    Random random{11};
    for (int i = 0; i < 20'000; ++i) {
        const Case c = sets::random_case(random, 1 + random.below(8), scale);
        const Balance found = balance(c.set, c.spring);
        if (found.residual > 1e-9) continue;
        ASSERT_LE(sets::fault(c.set, c.spring, found, 1e-14 * (glm::length(found.proxy) + scale.size)), 1e-9)
            << i;
    }
}

/// A set of random primitives, one of which has a negligible strength.
PrimitiveSet set_with_a_speck(Random& random, double speck) {
    PrimitiveSet set;
    const std::size_t count = 1 + random.below(8), at = random.below(count + 1);
    for (std::size_t i = 0; i <= count; ++i) {
        Primitive p = sets::random_primitive(random, {});
        if (i == at) p.strength = speck;
        set.add(p);
    }
    return set;
}

TEST(PrimitivesRandom, AStrengthNextToNothingSpoilsNoSet) {
    for (const double speck : {1e-10, 1e-160, 1e-290, 1e-300, 9e-301, 1e-308, 1e-312, 1e-320, 5e-324}) {
        Random random{12};
        for (int i = 0; i < 2'000; ++i) {
            const PrimitiveSet set = set_with_a_speck(random, speck);
            const Spring spring{sets::random_position(random, 0.01), 300};
            const Balance found = balance(set, spring);
            ASSERT_LE(found.residual, 1e-9) << speck << ", set " << i;
            ASSERT_LE(sets::fault(set, spring, found, touching({})), 1e-9) << speck << ", set " << i;
        }
    }
}

TEST(PrimitivesRandom, LinesThatAreNearlyParallelGiveTheBestForceAndATrueResidual) {
    // Lines at so small an angle (rad) have kinks only 1e-14 m apart. There the directions of forces change
    // completely within a few rounding steps of a position, and some sets stay unsolved.
    for (const double angle : {1e-8, 1e-9, 1e-10, 1e-11, 1e-12, 1e-13, 1e-14}) {
        Random random{13};
        for (int i = 0; i < 3'000; ++i) {
            const vec3 through = sets::random_position(random, 0.01), along = sets::random_direction(random);
            PrimitiveSet set;
            for (std::size_t line = 0; line < 2 + random.below(2); ++line)
                set.add({PrimitiveKind::line, through + angle * sets::random_position(random, 0.01),
                         glm::normalize(along + angle * sets::random_direction(random)),
                         random.uniform(0.1, 3)});
            if (random.below(2) == 0)
                set.add(
                    {PrimitiveKind::point, sets::random_position(random, 0.01), {}, random.uniform(0.1, 3)});
            const Spring spring{through + sets::random_position(random, 0.01), 300};
            const Balance found = balance(set, spring);
            ASSERT_LE(found.residual, 1e-3) << angle << ", set " << i;
            const double rounding = sets::bound_rounding(set, spring, found);
            ASSERT_LE(sets::proven_bound(set, spring, found), found.residual + rounding)
                << angle << ", set " << i;
            const vec3 pull = spring.stiffness * (found.proxy - spring.centre);
            ASSERT_LE(glm::length(pull - found.force), found.residual + 1e-12) << angle << ", set " << i;
        }
    }
}

TEST(PrimitivesRandom, TheStepBudgetHolds) {
    // If strength / stiffness (how far a force stretches the spring) is huge, some sets stay unsolved and use
    // up all steps.
    Random random{5};
    Scale scale;
    int most = 0;
    for (const double stiffness : {300.0, 1e-3, 1e-6}) {
        scale.stiffness = stiffness;
        scale.size = stiffness < 1 ? 1e-9 : 0.01;
        for (int i = 0; i < 5'000; ++i) {
            const Case c = sets::random_case(random, 1 + random.below(16), scale);
            const Balance found = balance(c.set, c.spring);
            most = std::max(most, found.steps);
        }
    }
    // When the budget of steps is used up, the solver may still make 12 passes over the forces, which count
    // as one step each.
    EXPECT_LE(most, balance_step_budget + 13);
    EXPECT_GT(most, 100);
}

TEST(PrimitivesRandom, NothingIsAllocated) {
    Random random{9};
    const auto before = test::allocations();
    for (int i = 0; i < 1'000; ++i) {
        const Case c = sets::random_case(random, 1 + random.below(16), {});
        (void)balance(c.set, c.spring);
    }
    EXPECT_EQ(test::allocations(), before);
}

}  // namespace
}  // namespace thaum::haptics

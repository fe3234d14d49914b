// Benchmark of the proxy of haptic primitives (engine/haptics/primitives/balance.h): run time and remaining
// sum of forces.
//
// "exact" is the shipped method. "iterative" is the usual method, which minimises the length of the sum in
// eq. 8 of paper 001 (Lundin and others 2007) numerically: damped steps along the sum, halved if the length
// does not fall, at most 200. "gauss_seidel" is the method of physics engines: 20 rounds in which each
// primitive in turn takes the force, within its strength, that puts the proxy on its kink (the point, line or
// plane where its force jumps).
#include <algorithm>
#include <array>
#include <functional>

#include "core/hash.h"
#include "core/text.h"
#include "haptics/primitives/balance.h"
#include "tests/scenes/primitive_sets.h"
#include "tools/bench/allocations.h"
#include "tools/bench/areas.h"
#include "tools/bench/measure.h"

namespace thaum::bench {
namespace {

using haptics::Balance;
using haptics::Primitive;
using haptics::PrimitiveKind;
using haptics::PrimitiveSet;
using haptics::Spring;

/// Displacement to x from the kink (the point, line or plane where the force of the primitive jumps) (m).
vec3 from_kink(const Primitive& p, vec3 x) {
    const vec3 m = x - p.position;
    const vec3 along = glm::dot(m, p.direction) * p.direction;
    if (p.kind == PrimitiveKind::point) return m;
    return p.kind == PrimitiveKind::line ? m - along : along;
}

/// The force nearest to `force` that the primitive can exert while the proxy, the point that it acts on, is
/// on its kink, where its force jumps (N).
vec3 within_strength(const Primitive& p, vec3 force) {
    if (p.kind == PrimitiveKind::plane)
        return std::clamp(glm::dot(force, p.direction), 0.0, p.strength) * p.direction;
    return limited(force, p.strength);
}

/// Force of a primitive by eqs. 4 to 7 of paper 001 (Lundin and others 2007); zero on the kink, where the
/// force jumps.
vec3 force_at(const Primitive& p, vec3 x) {
    if (p.kind == PrimitiveKind::directed) return p.strength * p.direction;
    const vec3 m = from_kink(p, x);
    if (p.kind == PrimitiveKind::plane)
        return glm::dot(m, p.direction) < 0 ? p.strength * p.direction : vec3(0);
    const double distance = glm::length(m);
    return distance > 0 ? m * (-p.strength / distance) : vec3(0);
}

/// Length of the sum of all forces, plus the largest difference between a primitive's force as the method
/// returns it and the same force computed again from the proxy (N). Both are zero if the proxy is in balance,
/// and only then.
double residual(const PrimitiveSet& set, const Spring& spring, const Balance& found) {
    vec3 sum = spring.stiffness * (spring.centre - found.proxy);
    double worst = 0;
    std::size_t i = 0;
    for (const Primitive& p : set.items()) {
        const vec3 force = found.primitive[i++];
        sum += force;
        if (p.kind == PrimitiveKind::directed) continue;
        const vec3 again = within_strength(p, force - spring.stiffness * from_kink(p, found.proxy));
        worst = std::max(worst, glm::length(again - force));
    }
    return glm::length(sum) + worst;
}

vec3 sum_at(const PrimitiveSet& set, const Spring& spring, vec3 x) {
    vec3 sum = spring.stiffness * (spring.centre - x);
    for (const Primitive& p : set.items()) sum += force_at(p, x);
    return sum;
}

Balance iterative(const PrimitiveSet& set, const Spring& spring) {
    Balance result{.proxy = spring.centre};
    vec3 sum = sum_at(set, spring, result.proxy);
    double part = 1 / spring.stiffness;
    for (; result.steps < 200 && glm::dot(sum, sum) > 1e-18; ++result.steps) {
        const vec3 there = result.proxy + part * sum;
        const vec3 next = sum_at(set, spring, there);
        if (glm::dot(next, next) < glm::dot(sum, sum)) {
            result.proxy = there;
            sum = next;
            part = std::min(part * 1.5, 1 / spring.stiffness);
        } else {
            part *= 0.5;
        }
    }
    std::size_t i = 0;
    for (const Primitive& p : set.items()) result.primitive[i++] = force_at(p, result.proxy);
    return result;
}

Balance gauss_seidel(const PrimitiveSet& set, const Spring& spring) {
    Balance result{.proxy = spring.centre};
    for (result.steps = 0; result.steps < 20; ++result.steps) {
        std::size_t i = 0;
        for (const Primitive& p : set.items()) {
            vec3& force = result.primitive[i++];
            const vec3 before = force;
            force = p.kind == PrimitiveKind::directed
                        ? p.strength * p.direction
                        : within_strength(p, force - spring.stiffness * from_kink(p, result.proxy));
            result.proxy += (force - before) / spring.stiffness;
        }
    }
    return result;
}

using Solve = Balance (*)(const PrimitiveSet&, const Spring&);

struct Method {
    const char* name;
    Solve solve;
    bool ships = false;
};

constexpr std::array methods{
    Method{"exact", [](const PrimitiveSet& s, const Spring& k) { return balance(s, k); }, true},
    Method{"iterative", iterative}, Method{"gauss_seidel", gauss_seidel}};
constexpr std::array<std::size_t, 5> counts{1, 2, 4, 8, 16};

/// Statistics of many random sets of haptic primitives, simple sources of force such as planes and points.
struct Tally {
    double residual{};     ///< worst residual, the sum of forces that is left (N)
    double own{};          ///< worst residual (remaining sum of forces) as reported by the method itself (N)
    double force_error{};  ///< worst error of the force at the hand, compared with the method "exact" (N)
    double above{};        ///< share of sets with a residual (remaining sum of forces) above 1e-9 N
    double steps{};        ///< mean number of steps that the method takes for a set
    double max_steps{};
    double allocations{};
    std::uint64_t hash{};
};

Tally tally_of(const Method& method, std::size_t count, std::size_t sets) {
    Random random = random_stream(1, count);
    Tally result;
    for (std::size_t i = 0; i < sets; ++i) {
        const auto one = haptics::sets::random_case(random, count, {});
        const auto before = allocation_count();
        const Balance found = method.solve(one.set, one.spring);
        result.allocations += static_cast<double>(allocation_count() - before);
        const double left = residual(one.set, one.spring, found);
        result.residual = std::max(result.residual, left);
        result.own = std::max(result.own, found.residual);
        if (left > 1e-9) result.above += 1 / static_cast<double>(sets);
        if (!method.ships) {
            const vec3 off = found.proxy - balance(one.set, one.spring).proxy;
            result.force_error = std::max(result.force_error, one.spring.stiffness * glm::length(off));
        }
        result.steps += found.steps / static_cast<double>(sets);
        result.max_steps = std::max(result.max_steps, static_cast<double>(found.steps));
        result.hash = hash_combine(result.hash, hash_value(found.proxy));
    }
    return result;
}

constexpr std::size_t batch = 64;

/// A fixed list of sets of haptic primitives, which a method solves one after another.
struct Stock {
    Solve solve;
    std::vector<haptics::sets::Case> cases;
    std::size_t next = 0;
    void run() {
        for (std::size_t i = 0; i < batch; ++i) {
            const auto& one = cases[next];
            do_not_optimise(solve(one.set, one.spring).proxy);
            next = next + 1 == cases.size() ? 0 : next + 1;
        }
    }
};

Stock stock_of(const Method& method, std::size_t count) {
    Random random = random_stream(2, count);
    Stock stock{method.solve, {}};
    for (std::size_t i = 0; i < 64 * batch; ++i)
        stock.cases.push_back(haptics::sets::random_case(random, count, {}));
    return stock;
}

Row primitives_row(const Method& method, std::size_t count, const Tally& tally,
                   std::vector<double> samples_us) {
    for (double& us : samples_us) us /= batch;
    return {.area = "primitives",
            .name = method.name,
            .setting = {{"primitives", static_cast<std::int64_t>(count)}},
            .time_us = times(samples_us),
            .error = ErrorMeasure{"residual_n", tally.residual},
            .is_default = method.ships,
            .metrics = {{"own_residual_n", tally.own},
                        {"force_error_n", tally.force_error},
                        {"share_above_1e-9_n", tally.above},
                        {"steps", tally.steps},
                        {"most_steps", tally.max_steps},
                        {"allocations", tally.allocations}},
            .hash = hex(tally.hash)};
}

}  // namespace

void primitives(const Options& options, Report& report) {
    std::vector<Stock> stocks;
    for (const Method& method : methods) {
        for (const auto count : counts) stocks.push_back(stock_of(method, count));
    }
    std::vector<Contestant> contestants;
    for (Stock& stock : stocks) contestants.push_back({{}, [&stock] { stock.run(); }});
    const auto samples = measure(contestants, {.seconds = options.quick ? 2.0 : 10.0});
    std::size_t i = 0;
    for (const Method& method : methods) {
        // The other methods already fail in the first thousand sets, so a million would only take longer.
        const std::size_t sets = options.quick ? 10'000 : method.ships ? 1'000'000 : 50'000;
        for (const auto count : counts)
            report.rows.push_back(primitives_row(method, count, tally_of(method, count, sets), samples[i++]));
    }
}

}  // namespace thaum::bench

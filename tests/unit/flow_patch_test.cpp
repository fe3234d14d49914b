// Tests of the piece of a flow that is copied into a haptic model: what is copied from the fields, and how it
// is read.
#include "haptics/flow_patch.h"

#include <gtest/gtest.h>

#include <utility>

#include "core/random.h"
#include "fluid/fields.h"
#include "fluid/fluid.h"

namespace thaum::haptics {
namespace {

constexpr double without_value = std::numeric_limits<double>::quiet_NaN();

fluid::Fluid wild_fluid() {
    auto made = fluid::make_fluid(
        {.cells = {12, 10, 14}, .h = 0.125, .substances = std::vector<fluid::Substance>(2)});
    Random random{7};
    const auto fill = [&random](fluid::Samples& samples, double low) {
        for (float& s : samples) s = static_cast<float>(random.uniform(low, 1));
    };
    for (auto& component : made->state.velocity) fill(component, -1);
    for (auto& substance : made->state.substances) fill(substance, 0);
    return std::move(*made);
}

FlowSource source_of(const fluid::Fluid& fluid) {
    FlowSource source{
        .velocity = fluid::face_grid(fluid.lattice, fluid.state.velocity), .viscosity = 0.5, .density = 20};
    source.substances[0] = {fluid::cell_grid(fluid.lattice, fluid.state.substances[0]), 3, 10};
    source.substances[2] = {fluid::cell_grid(fluid.lattice, fluid.state.substances[1]), 0.25, -5};
    return source;
}

vec3 place_in(Random& random, double low, double high) {
    return {random.uniform(low, high), random.uniform(low, high), random.uniform(low, high)};
}

TEST(FlowPatch, NodesEqualTheFieldsOfTheFluid) {
    const auto fluid = wild_fluid();
    const auto source = source_of(fluid);
    auto velocity = source.velocity;
    auto first = source.substances[0].amount, second = source.substances[2].amount;
    first.kernel = second.kernel = field::Kernel::linear;
    for (auto& grid : velocity.component) grid.kernel = field::Kernel::linear;
    Random random{1};
    for (int run = 0; run < 200; ++run) {
        const vec3 middle = place_in(random, -0.5, 2.5);  // the range also includes places outside the box
        const FlowPatch patch = patch_of(source, middle);
        ASSERT_EQ(patch.spacing, 0.125);
        for (int n = 0; n < 64; ++n) {
            const vec3 place = patch.origin + patch.spacing * vec3(n % 4, n / 4 % 4, n / 16);
            const FlowSample read = flow_at(patch, place);
            EXPECT_LE(glm::length(read.velocity - velocity(place).value), 2e-7);
            EXPECT_NEAR(read.viscosity, 0.5 + 3 * first(place).value + 0.25 * second(place).value, 1e-6);
            EXPECT_NEAR(read.density, 20 + 10 * first(place).value - 5 * second(place).value, 4e-6);
        }
        const vec3 from_low = (middle - patch.origin) / patch.spacing;
        for (int axis = 0; axis < 3; ++axis) {
            EXPECT_GE(from_low[axis], 1 - 1e-9);
            EXPECT_LE(from_low[axis], 2 + 1e-9);
        }
    }
}

TEST(FlowPatch, ALinearFlowIsExactAndAFlowAtRestIsTheSameFromEachPatch) {
    // Sampled by the fluid and again by the patch, a linear field is still the same linear field.
    auto fluid = wild_fluid();
    const auto flow = [](vec3 p) { return vec3(1 + p.y, 2 * p.x - p.z, 0.5 - 3 * p.y); };
    fluid::set_velocity(fluid, flow);
    const FlowSource source{.velocity = fluid::face_grid(fluid.lattice, fluid.state.velocity), .density = 1};
    Random random{2};
    for (int run = 0; run < 500; ++run) {
        const vec3 middle = place_in(random, 0.5, 0.7), off = place_in(random, -0.12, 0.12);
        const FlowPatch patch = patch_of(source, middle);
        const FlowSample read = flow_at(patch, middle + off);
        EXPECT_LE(glm::length(read.velocity - flow(middle + off)), 2e-6);
        EXPECT_NEAR(read.density, 1, 1e-12);
    }
    const auto wild = wild_fluid();
    const auto wild_source = source_of(wild);
    for (int run = 0; run < 500; ++run) {
        const vec3 middle = place_in(random, 0.5, 0.7), off = place_in(random, -0.06, 0.06);
        const vec3 place = middle + off;
        const vec3 a = flow_at(patch_of(wild_source, middle), place).velocity;
        const vec3 b = flow_at(patch_of(wild_source, middle + off * 1.9), place).velocity;
        EXPECT_LE(glm::length(a - b), 5e-7);
    }
}

TEST(FlowPatch, ContinuesBeyondItsNodesAndIsEmptyWithoutAFluid) {
    const auto fluid = wild_fluid();
    const FlowPatch patch = patch_of(source_of(fluid), {0.6, 0.6, 0.6});
    for (const double far : {0.0, 1.0, 1e9, 1e300}) {
        const vec3 corner = patch.origin - vec3(far, 0, far);
        EXPECT_EQ(flow_at(patch, corner).velocity, vec3(patch.nodes[0].velocity)) << far;
        const vec3 top = patch.origin + vec3(3 * patch.spacing + far);
        EXPECT_LE(glm::length(flow_at(patch, top).velocity - vec3(patch.nodes[63].velocity)), 1e-6) << far;
    }
    for (const vec3 place : {vec3(without_value, 0, 0), vec3(0, HUGE_VAL, 0)}) {
        EXPECT_EQ(flow_at(patch, place).velocity, vec3(0));
        EXPECT_EQ(patch_of(source_of(fluid), place).spacing, 0);
    }
    EXPECT_EQ(flow_at({}, {}).density, 0);
    EXPECT_EQ(patch_of({}, {}).spacing, 0);
    EXPECT_EQ(patch_of(source_of(fluid), vec3(1e300)).spacing, 0.125);
    // The substance's density is so far below zero that the mixture's would be negative, too. The patch must
    // not contain a negative density.
    auto source = source_of(fluid);
    source.substances[2].density = -1e9;
    for (const FlowNode& node : patch_of(source, vec3(0.6)).nodes) EXPECT_GE(node.density, 0);
}

}  // namespace
}  // namespace thaum::haptics

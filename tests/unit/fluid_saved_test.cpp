// Tests of saved fluids: a restored fluid continues with the same bits; a damaged file is refused with a
// message that names the fault.
#include <gtest/gtest.h>

#include <functional>

#include "core/hash.h"
#include "core/random.h"
#include "core/text.h"
#include "fluid/saved.h"
#include "unit/message_of.h"

namespace thaum::fluid {
namespace {

constexpr double dt = 0.016;
const NamedShape ball{"ball", {0.5, 0.5, 0.5, 0.46}};

Expected<std::function<double(vec3)>> solid_of(const NamedShape& shape) {
    if (shape.name != "ball" || shape.numbers.size() != 4) return fail("its shape is unknown");
    const vec3 centre(shape.numbers[0], shape.numbers[1], shape.numbers[2]);
    return
        [centre, radius = shape.numbers[3]](vec3 p) { return glm::length(p - centre) < radius ? 0.0 : 1.0; };
}

struct Case {
    const char* name;
    Settings settings;
    NamedShape shape{};
};

Settings settings_of(int n) {
    Settings s;
    s.cells = {n, n, n};
    s.h = 1.0 / n;
    s.viscosity = 1e-4;
    s.substances = {
        {.viscosity = 0.01, .weight = 0.5}, {.weight = -0.3, .diffusion = 1e-3}, {.viscosity = 1}};
    return s;
}

std::vector<Case> cases() {
    Case bowl{"bowl", settings_of(16), ball};
    bowl.settings.solid = *solid_of(ball);
    Case box{"box with a lid", settings_of(15)};
    box.settings.edges = {Edge::no_slip, Edge::no_slip, Edge::free_slip};
    box.settings.lid = 0.5;
    Case periodic{"periodic, not cubic", settings_of(12)};
    periodic.settings.edges = {Edge::periodic, Edge::periodic, Edge::periodic};
    periodic.settings.cells = {12, 17, 9};
    periodic.settings.order = 2;
    Case classic{"classic", settings_of(12)};
    classic.settings.solver = Solver::classic;
    return {bowl, box, periodic, classic};
}

struct Brew {
    Fluid fluid;
    SpringSurface surface;
    SpringSurfaceScratch scratch{};
};

Brew brew_of(const Case& c) {
    auto fluid = make_fluid(c.settings).value();
    const auto surface = checked({.nodes = 9, .rim = Rim::free});
    return {std::move(fluid), make_spring_surface(*surface)};
}

/// Moves a ladle in circles, pours in a substance at intervals, and lets a probe break through the surface.
void stir(Brew& brew, int from, int to) {
    for (int i = from; i < to; ++i) {
        const double turn = 0.3 * i;
        const vec3 place(0.5 + 0.2 * det::cos(turn), 0.5, 0.5 + 0.2 * det::sin(turn));
        push(brew.fluid, {place, 0.15, 0.01 * vec3(-det::sin(turn), 0.1, det::cos(turn))});
        if (i % 3 == 0) pour(brew.fluid, static_cast<std::size_t>(i / 3) % 3, place, 0.1, 0.01);
        const std::array probes{SurfaceProbe{{0.2, 0.1}, i % 7 < 4 ? -0.4 : 0.1, 0.1}};
        advance(brew.surface, brew.scratch, probes, dt);
        advance(brew.fluid, dt);
    }
}

Brew brewed(const Case& c, int steps) {
    Brew brew = brew_of(c);
    stir(brew, 0, steps);
    return brew;
}

std::string refusal(std::span<const std::byte> bytes) { return message_of(restore(bytes, solid_of)); }

TEST(FluidSaved, ARestoredFluidContinuesWithTheSameBits) {
    for (const Case& c : cases()) {
        SCOPED_TRACE(c.name);
        Brew through = brewed(c, 6);
        // A push queued for the next step is part of the state.
        push(through.fluid, {vec3(0.4), 0.2, vec3(0.01, 0, 0)});
        auto saved = restore(save(through.fluid, through.surface, c.shape), solid_of).value();
        EXPECT_EQ(saved.shape, c.shape);
        Brew again{std::move(saved.fluid), std::move(saved.surface)};
        if (c.settings.solver == Solver::thaum) {
            // This comparison includes the ghost cells, the samples outside the walls.
            EXPECT_EQ(again.fluid.state.velocity, through.fluid.state.velocity);
        }
        EXPECT_EQ(save(again.fluid, again.surface, c.shape), save(through.fluid, through.surface, c.shape));
        stir(through, 6, 16);
        stir(again, 6, 16);
        EXPECT_GT(energy(through.fluid), 0);
        EXPECT_EQ(save(again.fluid, again.surface, c.shape), save(through.fluid, through.surface, c.shape));
    }
}

TEST(FluidSaved, SleepAndDataOfTheCallerAreRestored) {
    const Case c = cases()[0];
    const Brew still = brew_of(c);
    const Bytes caller_data{std::byte{3}, std::byte{1}};
    const auto saved = restore(save(still.fluid, still.surface, c.shape, caller_data), solid_of).value();
    EXPECT_TRUE(saved.fluid.state.asleep);
    EXPECT_EQ(saved.surface.asleep, 1U);
    EXPECT_EQ(saved.caller_data, caller_data);
}

TEST(FluidSaved, CutOffOrDamagedFilesAreRefused) {
    Case c{"small", settings_of(6), ball};
    c.settings.solid = *solid_of(ball);
    const Brew brew = brewed(c, 3);
    const Bytes file = save(brew.fluid, brew.surface, c.shape);
    ASSERT_EQ(refusal(file), "");
    for (std::size_t length = 0; length < file.size(); ++length)
        ASSERT_NE(refusal(std::span(file).first(length)).find("cut off"), std::string::npos) << length;
    Random random = random_stream(1, 0);
    for (std::size_t i = 0; i < 1100; ++i) {
        // Damages each byte of the header, then random bytes.
        Bytes spoilt = file;
        spoilt[i < 100 ? i : random.below(file.size())] ^= static_cast<std::byte>(1 + random.below(255));
        ASSERT_NE(refusal(spoilt), "") << i;
    }
    Bytes longer = file;
    longer.push_back(std::byte{});
    EXPECT_EQ(refusal(longer), "saved fluid: more bytes follow its end; use another copy");
    for (const std::uint32_t version : {saved_version - 1, saved_version + 1}) {
        Bytes other = file;
        other[8] = static_cast<std::byte>(version);
        EXPECT_EQ(refusal(other),
                  text("saved fluid: it has version ", version, ", but this program reads version ",
                       saved_version, "; load it with the program that saved it"));
    }
    // A file with one byte too many, but with correct length and checksum.
    Bytes wider(file.begin(), file.end() - 8);
    wider.push_back(std::byte{});
    const auto length = static_cast<std::uint64_t>(wider.size() - 20);
    std::memcpy(wider.data() + 12, &length, sizeof length);
    ByteWriter(wider).put(hash_bytes(wider));
    EXPECT_EQ(refusal(wider), "saved fluid: unexpected bytes follow the surface");
    EXPECT_EQ(refusal(std::as_bytes(std::span("a text file of some length"))),
              "saved fluid: the file does not begin like one; choose another file");
}

/// Error message for a file with a correct checksum and one invalid value.
std::string refusal_of(const std::function<void(Brew&, NamedShape&)>& spoil) {
    Case c{"small", settings_of(6), ball};
    c.settings.solid = *solid_of(ball);
    Brew brew = brewed(c, 3);
    spoil(brew, c.shape);
    return refusal(save(brew.fluid, brew.surface, c.shape));
}

TEST(FluidSaved, InvalidContentsAreNamed) {
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    const auto expect = [](const std::string& words, const std::function<void(Brew&, NamedShape&)>& spoil) {
        EXPECT_NE(refusal_of(spoil).find(words), std::string::npos) << refusal_of(spoil);
    };
    const auto middle = [](Brew& b) { return static_cast<std::size_t>(b.fluid.lattice.at(3, 3, 3)); };
    expect("velocity along y: a value is not finite",
           [&](Brew& b, NamedShape&) { b.fluid.state.velocity[1][middle(b)] = nan; });
    expect("push along z: a value is not finite",
           [&](Brew& b, NamedShape&) { b.fluid.state.push[2][middle(b)] = nan; });
    expect("pressure: a value", [&](Brew& b, NamedShape&) { b.fluid.state.pressure[middle(b)] = 1e30F; });
    expect("last projection: a value",
           [&](Brew& b, NamedShape&) { b.fluid.state.projected[middle(b)] = 1e30F; });
    expect("substance 2: a value",
           [&](Brew& b, NamedShape&) { b.fluid.state.substances[1][middle(b)] = -1; });
    expect("cells must be 1 to 256", [](Brew& b, NamedShape&) { b.fluid.settings.cells = {6, 0, 6}; });
    expect("cells must be 1 to 256", [](Brew& b, NamedShape&) { b.fluid.settings.cells[2] = 1'000'000; });
    expect("fewer samples than its grid", [](Brew& b, NamedShape&) {
        b.fluid.settings.cells = {256, 256, 256};
    });
    expect("4 substances", [](Brew& b, NamedShape&) { b.fluid.settings.substances.resize(4); });
    expect("viscosity must be", [](Brew& b, NamedShape&) { b.fluid.settings.viscosity = -1; });
    expect("number of its solver",
           [](Brew& b, NamedShape&) { b.fluid.settings.solver = static_cast<Solver>(7); });
    expect("number of an edge",
           [](Brew& b, NamedShape&) { b.fluid.settings.edges[1] = static_cast<Edge>(3); });
    expect("number of the rim", [](Brew& b, NamedShape&) { b.surface.settings.rim = static_cast<Rim>(2); });
    expect("tension", [](Brew& b, NamedShape&) { b.surface.settings.tension = -1; });
    expect("a flag", [](Brew& b, NamedShape&) { b.surface.inside[3] = 2; });
    expect("a node", [](Brew& b, NamedShape&) {
        b.surface.height[surface_node_index(b.surface.settings, 4, 4)] = double(nan);
    });
    expect("its shape is unknown", [](Brew&, NamedShape& shape) { shape.name = "vase"; });
    expect("its shape is unknown", [](Brew&, NamedShape& shape) { shape.numbers.clear(); });
    expect("the name of its shape", [](Brew&, NamedShape& shape) { shape.name = "a\nb"; });
    expect("its shape has 17 numbers", [](Brew&, NamedShape& shape) { shape.numbers.resize(17); });
    EXPECT_EQ(refusal_of([](Brew&, NamedShape&) {}), "");
}

}  // namespace
}  // namespace thaum::fluid

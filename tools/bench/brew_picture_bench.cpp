// Benchmarks pictures of the brew, the fluid in the cauldron: the same picture of the arena alternately with
// and without the brew, seen from where the wizards start and from the cauldron's rim. Also the time to make
// the brew's texels and the mesh of its surface.
#include "core/text.h"
#include "game/scene/brew_look.h"
#include "render/audit/perceptual.h"
#include "tools/bench/areas.h"
#include "tools/bench/drawn_duel.h"
#include "tools/bench/match_scene.h"
#include "tools/bench/measure.h"

namespace thaum::bench {
namespace {

using render::Quality;

constexpr double step = 0.016;  // step of the fluid (s)
constexpr std::array places{"start", "beside"};

struct BrewScene {
    std::unique_ptr<DrawnDuel> drawn;
    std::array<game::Picture, places.size()> pictures;
    game::CauldronRules rules;
    game::Brew brew;
    game::BrewPicture taken;
    game::BrewLook look;

    /// Refreshes the brew's look as after a new fluid step.
    void show() {
        ++taken.state;
        game::show_brew(taken, {}, look);
    }

    void draw(std::size_t place, Quality quality, bool with_brew) {
        const auto& arena_scene = drawn->arena_scene;
        auto& memory = drawn->memory;
        game::make_frame(arena_scene, pictures[place], {.quality = quality}, window, memory);
        // Removes the painted surface of an empty bowl, which would hide the simulated brew.
        for (std::size_t i = 0; i < memory.frame.views.size(); ++i) {
            auto& instances = memory.instances[i];
            std::erase_if(instances, [&](const render::Instance& instance) {
                return instance.mesh == arena_scene.bubble ||
                       (arena_scene.painted_brew && instance.mesh == *arena_scene.painted_brew);
            });
            memory.frame.views[i].instances = instances;
            memory.frame.views[i].volume = with_brew ? &look.volume : nullptr;
        }
        if (with_brew) show();
        drawn->draw(memory.frame);
    }
};

/// Drops two substances into the brew and stirs for 3 s with a push that moves in a circle.
Expected<void> stir(BrewScene& scene) {
    auto& brew = scene.brew;
    for (const std::uint32_t ingredient : {0U, 1U}) {
        const vec3 at(ingredient == 0 ? -0.5 : 0.5, -0.25, 0.1);
        if (!game::drop(brew, scene.rules, ingredient, at, 0.4, 0.15))
            return fail("the brew took no ingredient; check assets/cauldron.toml");
    }
    for (int i = 0; i < 180; ++i) {
        const double angle = 2 * pi * step * i;
        const vec3 at = 0.6 * vec3(std::cos(angle), -0.4, std::sin(angle));
        fluid::push(brew.fluid, {at - brew.corner, 0.25, 0.03 * vec3(-std::sin(angle), 0, std::cos(angle))});
        fluid::advance(brew.fluid, step);
        const fluid::SurfaceProbe probe{{at.x, at.z}, i % 40 < 20 ? -0.03 : 0.1, 0.1};
        fluid::advance(brew.surface, brew.scratch, {&probe, 1}, step);
    }
    return {};
}

/// Places both wizards 2.2 m from the middle, looking at it.
void stand_beside(game::Picture& picture) {
    for (std::size_t p = 0; p < picture.wizards.size(); ++p) {
        auto& w = picture.wizards[p];
        const vec3 at(p == 0 ? -2.0 : 2.0, 0, p == 0 ? 0.9 : -0.9);
        w.vitals.eye += at - vec3(w.vitals.centre.x, 0, w.vitals.centre.z);
        w.vitals.centre = {at.x, w.vitals.centre.y, at.z};
        w.vitals.yaw = std::atan2(at.x, at.z);
        w.vitals.pitch = -0.4;
    }
}

Expected<std::unique_ptr<BrewScene>> brew_scene() {
    auto drawn = DrawnDuel::create();
    if (!drawn) return drawn.error();
    const auto& match = *(*drawn)->duel.match;
    if (!match.data().cauldron) return fail("the match has no cauldron");
    const auto& rules = *match.data().cauldron;
    const auto place = game::brew_place(*match.data().arena.bowl, rules);
    auto brew = game::make_brew(rules, place.basin);
    if (!brew) return brew.error();
    auto scene =
        std::unique_ptr<BrewScene>(new BrewScene{std::move(*drawn), {}, rules, std::move(*brew), {}, {}});
    scene->look = game::make_brew_look(*scene->drawn->renderer, place);
    for (auto& picture : scene->pictures) {
        picture = game::make_picture();
        game::take_picture(match, picture);
    }
    stand_beside(scene->pictures[1]);
    if (auto stirred = stir(*scene); !stirred) return stirred.error();
    game::take_brew(scene->brew, rules, 1, scene->taken);
    return scene;
}

void making(BrewScene& scene, const Options& options, Report& report) {
    const std::array contestants{Contestant{.setup = {}, .run = [&] { scene.show(); }}};
    const auto samples = measure(contestants, {.seconds = options.quick ? 0.5 : 2.0});
    const auto& cells = scene.brew.fluid.lattice.cells;
    report.rows.push_back({.area = "render",
                           .name = "brew_texels",
                           .setting = {{"cells", std::int64_t{cells[0]} * cells[1] * cells[2]},
                                       {"sheet", std::string("awake")}},
                           .time_us = times(samples[0]),
                           .is_default = true,
                           .metrics = {{"skin_vertices", static_cast<double>(scene.look.skin.size())}}});
}

void drawing(BrewScene& scene, const Options& options, Report& report) {
    std::vector<Contestant> contestants;
    for (std::size_t place = 0; place < places.size(); ++place) {
        for (std::size_t q = 0; q < render::qualities; ++q) {
            for (const bool with_brew : {false, true})
                contestants.push_back({.setup = {}, .run = [&scene, place, q, with_brew] {
                                           scene.draw(place, static_cast<Quality>(q), with_brew);
                                       }});
        }
    }
    const auto samples = measure(contestants, {.seconds = options.quick ? 8.0 : 40.0, .least = 11});
    const auto first = render::first_quality(scene.drawn->renderer->device());
    for (std::size_t i = 0; i < samples.size(); i += 2) {
        const auto place = i / 2 / render::qualities;
        const auto quality = static_cast<Quality>(i / 2 % render::qualities);
        scene.draw(place, Quality::high, true);
        const auto best = scene.drawn->renderer->read_pixels();
        scene.draw(place, quality, true);
        report.rows.push_back(
            {.area = "render",
             .name = text("brew_", places[place]),
             .setting = {{"quality", std::string(render::quality_names[static_cast<std::size_t>(quality)])},
                         {"device", scene.drawn->renderer->device()}},
             .time_us = times(samples[i + 1]),
             .error = ErrorMeasure{"mean_delta_e_to_high",
                                   render::distance(scene.drawn->renderer->read_pixels(), best).mean},
             .is_default = quality == first,
             .metrics = {{"to_without", ratio(samples[i + 1], samples[i])},
                         {"without_us", median(samples[i])}}});
    }
}

}  // namespace

void brew_pictures(const Options& options, Report& report) {
    auto made = brew_scene();
    if (!there(made, "render")) return;
    making(**made, options, report);
    drawing(**made, options, report);
}

}  // namespace thaum::bench

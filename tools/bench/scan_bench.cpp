// Benchmarks pictures of a scan of 128^3 samples at 512 x 512 pixels: while the view moves, while the scan is
// carved, and while the scan is out of view. Each time is reported with the perceptual distance from a
// picture with one ray for each pixel and tiny steps.
#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "core/text.h"
#include "game/data/match_data.h"
#include "render/audit/perceptual.h"
#include "render/context.h"
#include "render/renderer.h"
#include "tools/bench/areas.h"
#include "tools/bench/match_scene.h"
#include "tools/bench/measure.h"

namespace thaum::bench {
namespace {

using render::ScanDetail;

constexpr int side = 128;          // samples along each side of the scan
constexpr int picture_side = 512;  // width and height of the picture (px)
constexpr int bricks = side / render::scan_brick;
constexpr int carve_radius = 6;    // radius of a carved ball (samples)
constexpr std::size_t spots = 64;  // number of places that are carved

/// Density of an ellipsoid: 1 inside, 0 outside, with a soft edge one and a half samples wide.
float inside(fvec3 at, fvec3 centre, fvec3 radii) {
    const fvec3 from = at - centre;
    const float share = glm::length(from / radii);
    const float distance = (share - 1) * glm::length(from) / std::max(share, 1e-3F);
    return glm::smoothstep(0.75F, -0.75F, distance);
}

/// A head of soft tissue around a skull with eyes, nose and a brain.
std::vector<std::uint16_t> head() {
    std::vector<std::uint16_t> out;
    out.reserve(std::size_t{side} * side * side);
    for (int z = 0; z < side; ++z) {
        for (int y = 0; y < side; ++y) {
            for (int x = 0; x < side; ++x) {
                const fvec3 at = fvec3(static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)) -
                                 0.5F * (side - 1);
                const float left = std::abs(at.x);
                float d = 0.35F * inside(at, fvec3(0), {50, 60, 54});
                d = glm::mix(d, 0.9F, inside(at, fvec3(0, 3, 0), {43, 52, 47}));
                d = glm::mix(d, 0.4F, inside(at, fvec3(0, 5, -2), {38, 46, 41}));
                d = glm::mix(d, 0.3F, inside({left, at.y, at.z}, {17, 4, 44}, {11, 10, 16}));
                d = glm::mix(d, 0.1F, inside(at, {0, -14, 46}, {5, 9, 10}));
                out.push_back(static_cast<std::uint16_t>(65535 * d));
            }
        }
    }
    return out;
}

/// Transfer function with transparent soft tissue over opaque bone.
render::ScanTable tissue() {
    render::ScanTable table{};
    for (std::size_t i = 0; i < table.size(); ++i) {
        const float d = static_cast<float>(i) / 255;
        if (d > 0.2F) table[i] = {{0.8F, 0.4F, 0.3F}, 0.03F};
        if (d > 0.55F) table[i] = {{1, 0.95F, 0.8F}, std::min(1.6F * (d - 0.5F), 0.9F)};
    }
    return table;
}

/// Index in an array with `n` elements along a side, x contiguous.
std::size_t index_of(int x, int y, int z, std::size_t n) {
    return (static_cast<std::size_t>(z) * n + static_cast<std::size_t>(y)) * n + static_cast<std::size_t>(x);
}

struct ScanScene {
    render::Offscreen context;
    std::optional<render::Renderer> renderer;  // declared after `context`, so that it is destroyed first
    std::vector<std::uint16_t> whole = head(), samples = whole;
    std::vector<std::uint32_t> versions =
        std::vector<std::uint32_t>(std::size_t{bricks} * bricks * bricks, 1);
    render::ScanTable table = tissue();
    render::Scan scan{};
    float angle = 0.4F;
    std::size_t edits = 0;

    static Expected<std::unique_ptr<ScanScene>> create();
    void look_like(std::string_view look);
    render::Frame frame(ScanDetail detail) const;
    void draw(ScanDetail detail) {
        renderer->draw(frame(detail));
        do_not_optimise(renderer->read_pixels().rgb.data());
    }
    void carve();
};

Expected<std::unique_ptr<ScanScene>> ScanScene::create() {
    auto context = render::Offscreen::create(picture_side, picture_side);
    if (!context) return context.error();
    context->make_current();
    auto renderer = render::Renderer::create(game::find_assets());
    if (!renderer) return renderer.error();
    auto scene = std::unique_ptr<ScanScene>(new ScanScene{std::move(*context), std::move(*renderer)});
    scene->scan = {.id = scene->renderer->make_scan(),
                   .version = 1,
                   .count = {side, side, side},
                   .samples = std::span<const std::uint16_t>(scene->samples),
                   .high = 65535,
                   .brick_versions = scene->versions,
                   .spacing = fvec3(0.002F),
                   .table = &scene->table};
    return scene;
}

void ScanScene::look_like(std::string_view look) {
    scan.look = look == "surface" ? render::ScanLook::surface : render::ScanLook::translucent;
    scan.lit = look == "lit";
    scan.level = 0.6F;
    scan.unit = 0.002F;
    scan.colour = {0.8F, 0.75F, 0.6F};
}

render::Frame ScanScene::frame(ScanDetail detail) const {
    render::ViewScene view;
    view.camera.fov_y = 0.7F;
    view.camera.orientation = glm::angleAxis(angle, fvec3(0, 1, 0)) * glm::angleAxis(-0.2F, fvec3(1, 0, 0));
    view.camera.position = view.camera.orientation * fvec3(0, 0, 0.4F);
    view.viewport = {0, 0, picture_side, picture_side};
    view.scans = {&scan, 1};
    view.scan_detail = detail;
    return {.width = picture_side,
            .height = picture_side,
            .views = {view},
            .quality = render::first_quality(renderer->device())};
}

/// Removes a ball from the skull, and restores it at the next call.
void ScanScene::carve() {
    const bool heals = edits % 2 == 1;
    const float turn = 2.4F * static_cast<float>(edits / 2 % spots);  // multiples of the golden angle (rad)
    const float height = -0.8F + 1.6F * static_cast<float>(edits / 2 % spots) / spots;
    const float around = std::sqrt(1 - height * height);
    const fvec3 centre = 0.5F * (side - 1) +
                         fvec3(43 * around * std::cos(turn), 3 + 52 * height, 47 * around * std::sin(turn));
    const glm::ivec3 low(centre - float{carve_radius}), high(centre + float{carve_radius});
    for (int z = low.z; z <= high.z; ++z) {
        for (int y = low.y; y <= high.y; ++y) {
            for (int x = low.x; x <= high.x; ++x) {
                const auto i = index_of(x, y, z, side);
                if (glm::distance(fvec3(glm::ivec3(x, y, z)), centre) < carve_radius)
                    samples[i] = heals ? whole[i] : std::uint16_t{0};
            }
        }
    }
    const auto from = low / render::scan_brick, to = high / render::scan_brick;
    for (int z = from.z; z <= to.z; ++z) {
        for (int y = from.y; y <= to.y; ++y) {
            for (int x = from.x; x <= to.x; ++x) ++versions[index_of(x, y, z, bricks)];
        }
    }
    ++scan.version;
    ++edits;
}

struct Errors {
    double quick{}, sharp{};
};

/// Distances from a picture with one ray for each pixel and steps of an eighth of a sample.
Errors errors_of(ScanScene& scene) {
    const auto picture = [&](ScanDetail detail) {
        scene.draw(detail);
        return scene.renderer->read_pixels();
    };
    const auto quick = picture(ScanDetail::quick), sharp = picture(ScanDetail::sharp);
    const float step = scene.scan.step;
    scene.scan.step = 0.125F;
    const auto best = picture(ScanDetail::sharp);
    scene.scan.step = step;
    return {render::distance(quick, best).mean, render::distance(sharp, best).mean};
}

struct ScanRow {
    const char* doing;
    ScanDetail detail;
};

Row row_of(ScanScene& scene, const char* look, const ScanRow& which, const std::vector<double>& samples,
           const Errors& errors) {
    const bool quick = which.detail == ScanDetail::quick;
    return {.area = "render",
            .name = "volume",
            .setting = {{"look", std::string(look)},
                        {"doing", std::string(which.doing)},
                        {"detail", std::string(quick ? "quick" : "sharp")},
                        {"device", scene.renderer->device()}},
            .time_us = times(samples),
            .error = ErrorMeasure{"mean_delta_e_to_tiny_steps", quick ? errors.quick : errors.sharp},
            .is_default = quick,
            .metrics = {{"pictures_per_s", 1e6 / median(samples)}}};
}

/// Times one look (surface, translucent or lit) in quick and sharp detail while it turns, and while it is
/// carved.
void draw_look(ScanScene& scene, const char* look, const Options& options, Report& report) {
    scene.look_like(look);
    const auto turn = [&] { scene.angle += 0.02F; };
    const auto carve = [&] { scene.carve(); };
    const auto quick = [&] { scene.draw(ScanDetail::quick); };
    const auto sharp = [&] { scene.draw(ScanDetail::sharp); };
    const std::array contestants{Contestant{.setup = turn, .run = quick},
                                 Contestant{.setup = turn, .run = sharp},
                                 Contestant{.setup = carve, .run = quick}};
    constexpr std::array rows{ScanRow{"moving", ScanDetail::quick}, ScanRow{"moving", ScanDetail::sharp},
                              ScanRow{"carving", ScanDetail::quick}};
    const Plan plan{.seconds = options.quick ? 1.0 : 12.0, .least = options.quick ? std::size_t{3} : 11};
    const auto samples = measure(contestants, plan);
    const auto errors = errors_of(scene);
    for (std::size_t i = 0; i < rows.size(); ++i)
        report.rows.push_back(row_of(scene, look, rows.at(i), samples[i], errors));
}

}  // namespace

void scan_pictures(const Options& options, Report& report) {
    auto scene = ScanScene::create();
    if (!there(scene, "render/volume")) return;
    for (const auto* look : {"surface", "translucent", "lit"}) draw_look(**scene, look, options, report);
}

void skip_scan(const Options& options, Report& report) {
    auto made = ScanScene::create();
    if (!there(made, "skip/unseen volume")) return;
    auto& scene = **made;
    scene.look_like("translucent");
    scene.draw(ScanDetail::quick);
    // The camera looks away from the scan, which is carved nevertheless.
    auto seen = scene.frame(ScanDetail::quick);
    auto& camera = seen.views[0].camera;
    camera.orientation = glm::angleAxis(3.14F, fvec3(0, 1, 0)) * camera.orientation;
    auto without = seen;
    without.views[0].scans = {};
    const auto draw = [&](const render::Frame& frame) {
        scene.renderer->draw(frame);
        do_not_optimise(scene.renderer->read_pixels().rgb.data());
    };
    const std::array contestants{Contestant{.setup = [&] { scene.carve(); }, .run = [&] { draw(seen); }},
                                 Contestant{.setup = {}, .run = [&] { draw(without); }}};
    const auto samples = measure(contestants, {.seconds = options.quick ? 0.5 : 3.0});
    draw(seen);
    const auto& s = scene.renderer->statistics();
    const auto work = static_cast<double>(s.scans_drawn + s.scans_marched + s.scan_bricks_sent);
    report.rows.push_back(
        {.area = "skip",
         .name = "unseen volume",
         .setting = {{"state", std::string("unseen")}},
         .metrics = {{"rays_and_bricks", work}, {"time_to_without", ratio(samples[0], samples[1])}}});
    if (work > 0) report.faults.push_back("skip unseen volume: a scan out of view is drawn or sent");
}

}  // namespace thaum::bench

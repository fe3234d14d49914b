// Benchmarks pictures of the duel at each quality with their perceptual distance from the best quality, and
// the time of ticks while another thread draws, alternating with ticks alone.
#include <atomic>
#include <chrono>
#include <mutex>
#include <thread>

#include "core/text.h"
#include "render/audit/perceptual.h"
#include "render/priority.h"
#include "tools/bench/areas.h"
#include "tools/bench/drawn_duel.h"
#include "tools/bench/match_scene.h"
#include "tools/bench/measure.h"

namespace thaum::bench {
namespace {

using render::Quality;

// Ticks (of 1 ms) between two pictures; long enough for objects to move.
constexpr Tick between_pictures = 16;

struct RenderScene {
    std::unique_ptr<DrawnDuel> drawn;
    game::Picture picture = game::make_picture();

    void advance() {
        drawn->duel.run(between_pictures);
        game::take_picture(*drawn->duel.match, picture);
    }
    void draw(const game::Picture& what, Quality quality) {
        drawn->draw(game::make_frame(drawn->arena_scene, what, {.quality = quality}, window, drawn->memory));
    }
    render::Renderer& renderer() { return *drawn->renderer; }
};

render::Image picture_at(RenderScene& scene, Quality quality) {
    scene.draw(scene.picture, quality);
    return scene.renderer().read_pixels();
}

/// Adds the median time of each pass over some pictures. Each pass waits for the one before, so together they
/// take longer than a picture whose passes overlap.
void add_passes(RenderScene& scene, Quality quality, Row& row) {
    constexpr int pictures = 9;
    std::array<std::vector<double>, render::passes> ms;
    scene.renderer().measure_passes(true);
    for (int i = 0; i < pictures; ++i) {
        scene.advance();
        scene.draw(scene.picture, quality);
        for (std::size_t p = 0; p < ms.size(); ++p) ms[p].push_back(scene.renderer().pass_times().ms[p]);
    }
    scene.renderer().measure_passes(false);
    for (std::size_t p = 0; p < ms.size(); ++p)
        row.metrics.emplace_back(text("pass_", render::pass_names[p], "_ms"), median(ms[p]));
}

Row row_of(RenderScene& scene, Quality quality, const std::vector<double>& samples,
           const render::Image& best) {
    const auto name = render::quality_names[static_cast<std::size_t>(quality)];
    const auto image = picture_at(scene, quality);
    // The shadow map of fixed objects is up to date by now. The next frame includes moving objects, as in a
    // running match.
    scene.advance();
    scene.draw(scene.picture, quality);
    const auto s = scene.renderer().statistics();
    constexpr double views = 2;
    return {.area = "render",
            .name = "duel",
            .setting = {{"quality", std::string(name)},
                        {"width", std::int64_t{window.width}},
                        {"height", std::int64_t{window.height}},
                        {"device", scene.renderer().device()}},
            .time_us = times(samples),
            .error = ErrorMeasure{"mean_delta_e_to_high", render::distance(image, best).mean},
            .is_default = quality == render::first_quality(scene.renderer().device()),
            .metrics = {{"triangles_per_view", static_cast<double>(s.triangles) / views},
                        {"draws_per_view", static_cast<double>(s.draws) / views},
                        {"instances_per_view", static_cast<double>(s.instances_drawn) / views},
                        {"culled_per_view", static_cast<double>(s.instances_culled) / views},
                        {"shadow_draws", static_cast<double>(s.shadow_draws)},
                        {"shadow_triangles", static_cast<double>(s.shadow_triangles)}}};
}

// ---- ticks while another thread draws ---------------------------------------------------------------------

/// Draws the newest picture on a thread of its own while drawing is switched on, as during a match on the
/// screen.
class Drawer {
public:
    Drawer(RenderScene& scene, Quality quality)
        : scene_(scene), quality_(quality), newest_(scene.picture), thread_([this] { run(); }) {}
    Drawer(const Drawer&) = delete;
    Drawer& operator=(const Drawer&) = delete;
    ~Drawer() {
        may_ = false;
        over_ = true;
    }
    /// Switches drawing on or off, and returns when the thread has done so.
    void set_drawing(bool drawing) {
        may_ = drawing;
        while (draws_ != drawing) std::this_thread::yield();
    }
    void hand_over(const game::Picture& picture) {
        const std::scoped_lock lock(mutex_);
        newest_ = picture;
    }
    int drawn() const { return drawn_; }

private:
    void run() {
        scene_.drawn->context.make_current();
        render::draw_behind_others();
        while (!over_) {
            draws_ = may_.load();
            if (draws_) {
                draw();
            } else {
                std::this_thread::sleep_for(std::chrono::milliseconds(1));
            }
        }
        scene_.drawn->context.release_current();
    }
    void draw() {
        {
            const std::scoped_lock lock(mutex_);
            own_ = newest_;
        }
        scene_.draw(own_, quality_);
        ++drawn_;
    }

    RenderScene& scene_;
    Quality quality_;
    game::Picture newest_, own_ = game::make_picture();
    std::mutex mutex_;
    std::atomic<bool> may_ = false, draws_ = false, over_ = false;
    std::atomic<int> drawn_ = 0;
    std::jthread thread_;  ///< last member, so that the thread ends while the other members still exist
};

/// Runs one tick for each millisecond and passes a picture to the drawing thread every 16 ticks.
void paced_ticks(RenderScene& scene, Drawer& drawer, int count, std::vector<double>& samples) {
    using Clock = std::chrono::steady_clock;
    auto due = Clock::now();
    for (int i = 0; i < count; ++i) {
        due = std::max(due + std::chrono::milliseconds(1), Clock::now());
        std::this_thread::sleep_until(due);
        const auto start = Clock::now();
        scene.drawn->duel.match->tick(scene.drawn->duel.next_frame());
        samples.push_back(std::chrono::duration<double, std::micro>(Clock::now() - start).count());
        if (static_cast<Tick>(i) % between_pictures != 0) continue;
        game::take_picture(*scene.drawn->duel.match, scene.picture);
        drawer.hand_over(scene.picture);
    }
}

void tick_beside_pictures(RenderScene& scene, const Options& options, Report& report) {
    constexpr int slice = 250;  // ticks in a row with drawing on, or off, before it changes
    const int rounds = options.quick ? 12 : 60;
    const auto quality = render::first_quality(scene.renderer().device());
    scene.drawn->context.release_current();
    std::array<std::vector<double>, 2> samples;
    int drawn = 0;
    {
        Drawer drawer(scene, quality);
        for (int i = 0; i < 2 * rounds; ++i) {
            const bool drawing = i % 2 == 1;
            drawer.set_drawing(drawing);
            paced_ticks(scene, drawer, slice, samples[drawing ? 1 : 0]);
        }
        drawn = drawer.drawn();
    }
    scene.drawn->context.make_current();
    const double alone = percentile(samples[0], 0.99);
    for (const bool drawing : {false, true}) {
        const auto& own = samples[drawing ? 1 : 0];
        report.rows.push_back({.area = "render",
                               .name = "tick",
                               .setting = {{"drawing", std::string(drawing ? "beside" : "no")}},
                               .time_us = times(own),
                               .is_default = drawing,
                               .metrics = {{"ticks", static_cast<double>(own.size())},
                                           {"p99_to_alone", percentile(own, 0.99) / alone},
                                           {"pictures", drawing ? static_cast<double>(drawn) : 0.0}}});
    }
}

}  // namespace

void render(const Options& options, Report& report) {
    auto drawn = DrawnDuel::create();
    if (!there(drawn, "render")) return;
    RenderScene scene{.drawn = std::move(*drawn)};
    scene.drawn->duel.run(4000);
    std::vector<Contestant> contestants;
    for (const auto quality : {Quality::low, Quality::medium, Quality::high}) {
        contestants.push_back({.setup = [&scene] { scene.advance(); },
                               .run = [&scene, quality] { scene.draw(scene.picture, quality); }});
    }
    const auto samples = measure(contestants, {.seconds = options.quick ? 6.0 : 30.0, .least = 15});
    scene.advance();
    for (const auto quality : {Quality::low, Quality::medium, Quality::high}) {
        const auto best = picture_at(scene, Quality::high);
        auto row = row_of(scene, quality, samples[static_cast<std::size_t>(quality)], best);
        add_passes(scene, quality, row);
        report.rows.push_back(std::move(row));
    }
    tick_beside_pictures(scene, options, report);
    scene.drawn.reset();
    brew_pictures(options, report);
    scan_pictures(options, report);
}

}  // namespace thaum::bench

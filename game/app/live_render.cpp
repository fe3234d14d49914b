#include <algorithm>
#include <cmath>

#include "game/app/live_shared.h"
#include "render/pace.h"

namespace thaum::app {

using game::Picture;

namespace {

/// The picture shown lies so far back that the one after it is most often there already, ms.
constexpr double delay_ms = 6;

/// The last two pictures, and what lies between them now.
struct Film {
    Picture before = game::make_picture(), now = game::make_picture(), shown = game::make_picture();
    std::int64_t shown_due_ns = 0;  ///< all ticks due by then are in `shown`
    bool any = false;
};

void advance(Latest<Picture>& pictures, Film& film) {
    if (!pictures.take()) return;
    std::swap(film.before, film.now);
    film.now = pictures.newest();
    film.any = true;
}

const Picture& show(Film& film, double speed) {
    const auto& a = film.before;
    const auto& b = film.now;
    const double since_due_ms = static_cast<double>(monotonic_ns() - b.due_ns) * 1e-6;
    const double shown_tick = static_cast<double>(b.tick) + (since_due_ms - delay_ms) * speed;
    const bool follows = a.tick < b.tick;
    const double wanted =
        follows ? (shown_tick - static_cast<double>(a.tick)) / static_cast<double>(b.tick - a.tick) : 1;
    const double alpha = std::clamp(wanted, 0.0, 1.0);
    game::interpolate(a, b, alpha, film.shown);
    film.shown_due_ns = b.due_ns - std::llround((1 - alpha) * static_cast<double>(b.due_ns - a.due_ns));
    return film.shown;
}

game::HudSettings hud_settings(const LivePlan& plan, const LiveShared& shared, game::Watch watch) {
    return {.split = shared.split.load(),
            .watch = watch,
            .fov = plan.settings.fov,
            .text_scale = plan.settings.text_scale,
            .internal_scale = static_cast<float>(plan.settings.internal_scale),
            .can_play_again = true};
}

void draw_until_stopped(const LivePlan& plan, LiveShared& shared, game::Watch watch,
                        render::Renderer& renderer) {
    const auto court = game::make_court(renderer, plan.data->arena, plan.data->wizard);
    render::Pacer pacer(plan.settings.frames_per_second);
    Staller staller{plan.stall};
    Film film;
    game::FrameMemory memory;
    Timings times, inputs;
    shared.ready = true;
    while (!shared.stop) {
        pacer.wait();
        staller.pass(Stall::Thread::render);
        advance(shared.pictures, film);
        const auto size = shared.window.size();
        if (!film.any || shared.window.minimised() || size.width <= 0 || size.height <= 0) {
            shared.stamps.take_due(monotonic_ns(), [](const InputStamp&) {});  // nobody saw those
            continue;
        }
        const auto before = monotonic_ns();
        renderer.draw(
            game::make_frame(court, show(film, plan.speed), hud_settings(plan, shared, watch), size, memory));
        shared.window.present();
        const auto after = monotonic_ns();
        times.add(static_cast<double>(after - before) * 1e-6);
        shared.stamps.take_due(film.shown_due_ns, [&](const InputStamp& stamp) {
            inputs.add(static_cast<double>(after - stamp.came_ns) * 1e-6);
            ++shared.report.inputs;
        });
        ++shared.report.frames;
    }
    shared.report.frame_ms_median = times.at(0.5);
    shared.report.frame_ms_p99 = times.at(0.99);
    shared.report.input_ms_median = inputs.at(0.5);
    shared.report.input_ms_p99 = inputs.at(0.99);
}

}  // namespace

void run_render(const LivePlan& plan, LiveShared& shared, game::Watch watch) {
    shared.window.make_current();
    if (auto renderer = render::Renderer::create(plan.assets)) {
        draw_until_stopped(plan, shared, watch, *renderer);
    } else {
        shared.render_error = renderer.error();
        shared.stop = true;
        shared.window.wake();
    }
    shared.window.release_current();
}

}  // namespace thaum::app

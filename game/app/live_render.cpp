#include <algorithm>
#include <cmath>

#include "game/app/live_shared.h"
#include "render/pace.h"
#include "render/priority.h"

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

/// Calls f(stamp) for those that were due by then, and forgets them.
template <class Stamps, class F>
void take_due(Stamps& stamps, std::int64_t due_ns, F f) {
    for (const auto* stamp = stamps.front(); stamp != nullptr && stamp->due_ns <= due_ns;
         stamp = stamps.front()) {
        f(*stamp);
        stamps.pop();
    }
}

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

/// The preset that is set, or the one that `auto` has come to.
struct QualityChoice {
    render::Quality first{};
    render::AutoQuality found{};
    render::Size size{};

    render::Quality now(std::optional<render::Quality> set, render::Size window) {
        // Another size is another amount of work: what proved too slow may fit now.
        if (window != size) found = {.now = size == render::Size{} ? first : found.now};
        size = window;
        return set.value_or(found.now);
    }
};

/// Outside of a match, and in a pause, little moves, so few pictures do: a step of the court's camera is less than a pixel or two.
constexpr std::int64_t still_period_ns = 66'000'000;
constexpr double court_seconds_a_turn = 360;

double court_angle() { return 2 * pi * static_cast<double>(monotonic_ns()) * 1e-9 / court_seconds_a_turn; }

/// Everything that a picture is made from.
struct Studio {
    std::shared_ptr<const game::MatchData> scene;  ///< that the court was made from
    game::Court court;
    Film film{};
    game::FrameMemory memory{};
    QualityChoice quality{};
    std::int64_t next_still_ns = 0;
};

/// The menu that is open, with the match's caption where it has a note: nothing else stands over the views then.
game::MenuPicture menu_of(const Screen& screen, const Picture& shown) {
    auto menu = screen.menu;
    if (!screen.court && menu.note.empty()) menu.note = shown.caption.words;
    return menu;
}

const render::Frame& frame_of(Studio& studio, const Screen& screen, double speed, render::Size size) {
    auto hud = screen.hud;
    hud.quality = studio.quality.now(screen.quality, size);
    if (screen.court)
        game::make_court_frame(studio.court, studio.film.now, court_angle(), hud, size, studio.memory);
    else
        game::make_frame(studio.court, show(studio.film, speed), hud, size, studio.memory);
    game::add_menu(studio.memory.frame.overlay, menu_of(screen, studio.film.shown), size,
                   screen.hud.text_scale);
    return studio.memory.frame;
}

/// Is a picture due? Of a match that goes on always.
bool due(Studio& studio, const Screen& screen, bool changed) {
    const auto now = monotonic_ns();
    const bool still = screen.court || studio.film.now.paused;
    if (still && !changed && now < studio.next_still_ns) return false;
    studio.next_still_ns = now + still_period_ns;
    return true;
}

game::Court court_of(render::Renderer& renderer, const game::MatchData& data) {
    return game::make_court(renderer, data);
}

/// Do they make the same court?
bool same_scenery(const game::MatchData& a, const game::MatchData& b) {
    return a.arena.things == b.arena.things && a.arena.meshes == b.arena.meshes &&
           a.wizard.height == b.wizard.height;
}

/// The court of the newest scene. Meshes cannot be given back, so another court needs another renderer: that takes a moment, but
/// happens only when somebody writes an arena.
void follow_scene(const LivePlan& plan, LiveShared& shared, render::Renderer& renderer, Studio& studio) {
    if (!shared.scene.take()) return;
    const auto scene = shared.scene.newest();
    if (same_scenery(*scene, *studio.scene)) return;
    auto fresh = render::Renderer::create(plan.assets);
    if (!fresh) return;
    renderer = std::move(*fresh);
    studio.court = court_of(renderer, *scene);
    studio.scene = scene;
}

void draw_until_stopped(const LivePlan& plan, LiveShared& shared, render::Renderer& renderer) {
    Studio studio{.scene = plan.data, .court = court_of(renderer, *plan.data)};
    double frames_per_second = plan.settings.frames_per_second;
    render::Pacer pacer(frames_per_second);
    Staller staller{plan.stall};
    studio.quality.first = render::first_quality(renderer.device());
    Timings times, inputs;
    shared.ready = true;
    while (!shared.stop) {
        pacer.wait();
        staller.pass(Stall::Thread::render);
        advance(shared.pictures, studio.film);
        follow_scene(plan, shared, renderer, studio);
        const bool changed = shared.screen.take();
        const auto& screen = shared.screen.newest();
        if (screen.frames_per_second != frames_per_second)
            pacer = render::Pacer(frames_per_second = screen.frames_per_second);
        const auto size = shared.window.size();
        if (!studio.film.any || shared.window.minimised() || size.width <= 0 || size.height <= 0) {
            take_due(shared.stamps, monotonic_ns(), [](const InputStamp&) {});  // nobody saw those
            continue;
        }
        if (!due(studio, screen, changed)) continue;
        const auto before = monotonic_ns();
        renderer.draw(frame_of(studio, screen, plan.speed, size));
        shared.window.present();
        const auto after = monotonic_ns();
        const double frame_ms = static_cast<double>(after - before) * 1e-6;
        auto& quality = studio.quality;
        quality.found = render::after_frame(quality.found, frame_ms);
        shared.report.quality = studio.memory.frame.quality;
        times.add(frame_ms);
        take_due(shared.stamps, studio.film.shown_due_ns, [&](const InputStamp& stamp) {
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

void run_render(const LivePlan& plan, LiveShared& shared) {
    shared.window.make_current();
    if (auto renderer = render::Renderer::create(plan.assets)) {
        if (render::is_software(renderer->device())) render::draw_behind_others();
        draw_until_stopped(plan, shared, *renderer);
    } else {
        shared.render_error = renderer.error();
        shared.stop = true;
        shared.window.wake();
    }
    shared.window.release_current();
}

}  // namespace thaum::app

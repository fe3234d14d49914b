#include <algorithm>
#include <cmath>

#include "game/live/shared.h"
#include "render/pace.h"
#include "render/priority.h"

namespace thaum::game::inline live {

namespace {

/// Delay of the shown picture behind the newest one (ms). With it the next picture has usually arrived, so
/// that the shown one is interpolated between two.
constexpr double delay_ms = 6;

/// The last two pictures, and the picture interpolated between them for the present time.
struct InterpolationBuffer {
    Picture before = make_picture(), newest = make_picture(), shown = make_picture();
    /// how often each player has done what each prompt (a hint such as "[E] Stir") asks for, in all pictures
    /// so far
    PromptUses prompt_uses{};
    std::int64_t shown_due_ns = 0;  ///< all ticks due by this time are contained in `shown` (ns)
    bool any = false;
};

/// Calls f(stamp) for each stamp (the times of an input event) whose tick was due by `due_ns`, and removes
/// it.
template <class Stamps, class F>
void take_due(Stamps& stamps, std::int64_t due_ns, F f) {
    for (const auto* stamp = stamps.front(); stamp != nullptr && stamp->due_ns <= due_ns;
         stamp = stamps.front()) {
        f(*stamp);
        stamps.pop();
    }
}

void advance(TripleBuffer<Picture>& pictures, InterpolationBuffer& buffer) {
    if (!pictures.take()) return;
    std::swap(buffer.before, buffer.newest);
    buffer.newest = pictures.newest();
    count_uses(buffer.before, buffer.newest, buffer.prompt_uses);
    buffer.any = true;
}

const Picture& show(InterpolationBuffer& buffer, double speed) {
    const auto& a = buffer.before;
    const auto& b = buffer.newest;
    const double since_due_ms = static_cast<double>(monotonic_ns() - b.due_ns) * 1e-6;
    const double shown_tick = static_cast<double>(b.tick) + (since_due_ms - delay_ms) * speed;
    const bool follows = a.tick < b.tick;
    const double wanted =
        follows ? (shown_tick - static_cast<double>(a.tick)) / static_cast<double>(b.tick - a.tick) : 1;
    const double alpha = std::clamp(wanted, 0.0, 1.0);
    interpolate(a, b, alpha, buffer.shown);
    buffer.shown_due_ns = b.due_ns - std::llround((1 - alpha) * static_cast<double>(b.due_ns - a.due_ns));
    return buffer.shown;
}

/// Quality of the pictures: chosen in the settings or, for the setting `auto`, found by measured times.
struct QualityChoice {
    render::Quality first{};
    render::AutoQuality found{};
    render::Size size{};

    /// Sets quality and resolution of the next picture.
    void apply(std::optional<render::Quality> set, render::Size window, HudSettings& hud) {
        // A window of another size needs another amount of work, so a quality that was too slow may be fast
        // enough now.
        if (window != size) found = {.current = size == render::Size{} ? first : found.current};
        size = window;
        hud.quality = set.value_or(found.current);
        hud.resolution = set ? 1 : found.resolution;
    }
};

/// Period of pictures outside of a match and in a pause, when little moves (ns). The camera that circles the
/// arena moves the picture by less than two pixels in that time.
constexpr std::int64_t still_period_ns = 66'000'000;
constexpr double seconds_per_camera_turn = 360;

double camera_angle() {
    return 2 * pi * static_cast<double>(monotonic_ns()) * 1e-9 / seconds_per_camera_turn;
}

/// Everything that the render thread makes a picture from.
struct RenderState {
    std::shared_ptr<const MatchData> scene;  ///< data that the arena scene was made from
    ArenaScene arena_scene;
    InterpolationBuffer buffer{};
    FrameMemory memory{};
    QualityChoice quality{};
    /// number of picture qualities, counted from the lowest, whose shaders were used already; the first use
    /// of a shader is slow
    std::size_t warm_qualities = 0;
    std::int64_t next_still_ns = 0;
    FrameTimes frame_times{};  ///< times of the last pictures, kept while the screen shows these times
};

/// The open menu as it is drawn. The match's caption has no place under a menu, so it fills an empty menu
/// note.
MenuPicture menu_of(const Screen& screen, const Picture& shown) {
    auto menu = screen.menu;
    if (!screen.arena_scene && menu.note.empty()) menu.note = shown.caption.words;
    return menu;
}

const render::Frame& frame_of(RenderState& state, const Screen& screen, render::Size size) {
    auto hud = screen.hud;
    const double speed = hud.replay ? hud.replay->speed : 1;
    state.quality.apply(screen.quality, size, hud);
    hud.prompt_uses = state.buffer.prompt_uses;
    if (screen.frame_times) hud.frame_times = state.frame_times;
    if (screen.arena_scene)
        make_arena_frame(state.arena_scene, state.buffer.newest, camera_angle(), hud, size, state.memory);
    else
        make_frame(state.arena_scene, show(state.buffer, speed), hud, size, state.memory);
    add_menu(state.memory.frame.overlay, menu_of(screen, state.buffer.shown), size, screen.hud.text_scale);
    return state.memory.frame;
}

/// Tests whether a picture is due. A match or replay that goes on always needs one.
bool due(RenderState& state, const Screen& screen, bool changed) {
    const auto now = monotonic_ns();
    const auto& replay = screen.hud.replay;
    const bool stopped = replay && (replay->paused || state.buffer.newest.tick >= replay->length);
    const bool still = screen.arena_scene || state.buffer.newest.paused || stopped;
    if (still && !changed && now < state.next_still_ns) return false;
    state.next_still_ns = now + still_period_ns;
    return true;
}

ArenaScene arena_scene_of(render::Renderer& renderer, const MatchData& data) {
    return make_arena_scene(renderer, data);
}

/// Tests whether the same meshes show both lists of wands and their missiles.
bool same_looks(const std::vector<WandPresentation>& a, const std::vector<WandPresentation>& b) {
    return std::ranges::equal(a, b, {}, &WandPresentation::look, &WandPresentation::look);
}

/// Tests whether both data sets make the same arena scene.
bool same_scenery(const MatchData& a, const MatchData& b) {
    return a.arena.things == b.arena.things && a.arena.meshes == b.arena.meshes && a.look == b.look &&
           a.wizard.height == b.wizard.height && a.orb.has_value() == b.orb.has_value() &&
           a.crystal.has_value() == b.crystal.has_value() &&
           same_looks(a.presentation->wands, b.presentation->wands);
}

/// Makes the arena scene of the newest data. Meshes cannot be freed, so another arena needs another renderer.
/// That takes a moment, but happens only when somebody chooses another arena or edits one on the practice
/// range.
void follow_scene(const LivePlan& plan, LiveShared& shared, render::Renderer& renderer, RenderState& state) {
    if (!shared.scene.take()) return;
    const auto scene = shared.scene.newest();
    if (same_scenery(*scene, *state.scene)) return;
    auto fresh = render::Renderer::create(plan.assets);
    if (!fresh) return;
    renderer = std::move(*fresh);
    state.warm_qualities = 0;
    state.arena_scene = arena_scene_of(renderer, *scene);
    state.scene = scene;
}

/// Warms up the shaders of one quality after each of the first pictures. To do this for all qualities at once
/// would delay a picture.
void warm_up_next(render::Renderer& renderer, LiveShared& shared, RenderState& state) {
    if (state.warm_qualities == render::qualities) return;
    renderer.warm_up(static_cast<render::Quality>(state.warm_qualities++));
    if (state.warm_qualities == render::qualities) shared.say_started();
}

/// Times that the render thread reports when it ends.
struct RenderTimes {
    Timings frames;  ///< durations of drawing a picture (ms)
    Timings inputs;  ///< delays from an input event to its picture (ms)
};

/// Counts a picture that was just shown. Its duration decides on the quality of the next one.
void count_picture(std::int64_t begun_ns, const Screen& screen, LiveShared& shared, RenderState& state,
                   RenderTimes& times) {
    const auto shown_ns = monotonic_ns();
    const double frame_ms = static_cast<double>(shown_ns - begun_ns) * 1e-6;
    auto& quality = state.quality;
    // Pictures that do not decide on the quality: those whose parts are measured, which slows them down, and
    // those of a quality that was set, which is not the one found here.
    if (!screen.frame_times && !screen.quality) quality.found = render::after_frame(quality.found, frame_ms);
    shared.report.quality = state.memory.frame.quality;
    times.frames.add(frame_ms);
    take_due(shared.stamps, state.buffer.shown_due_ns, [&](const InputStamp& stamp) {
        times.inputs.add(static_cast<double>(shown_ns - stamp.came_ns) * 1e-6);
        ++shared.report.inputs;
    });
    ++shared.report.frames;
}

/// Makes a picture and shows it.
void show_picture(const Screen& screen, render::Size size, render::Window& window, render::Renderer& renderer,
                  RenderState& state) {
    const auto begun_ns = monotonic_ns();
    renderer.measure_passes(screen.frame_times);
    const auto& frame = frame_of(state, screen, size);
    const auto built_ns = monotonic_ns();
    renderer.draw(frame);
    const auto drawn_ns = monotonic_ns();
    window.present();
    if (!screen.frame_times) return;
    const auto ms = [](std::int64_t from, std::int64_t to) { return static_cast<double>(to - from) * 1e-6; };
    constexpr double weight = 0.05;  // the mean is over about 20 pictures
    approach(state.frame_times,
             {.building_ms = ms(begun_ns, built_ns),
              .passes = renderer.pass_times(),
              .showing_ms = ms(drawn_ns, monotonic_ns()),
              .quality = frame.quality,
              .resolution = frame.internal_scale},
             weight);
}

void draw_until_stopped(const LivePlan& plan, LiveShared& shared, render::Window& window,
                        render::Renderer& renderer) {
    RenderState state{.scene = plan.data, .arena_scene = arena_scene_of(renderer, *plan.data)};
    double frames_per_second = plan.settings.frames_per_second;
    render::Pacer pacer(frames_per_second);
    Staller staller{plan.stall};
    state.quality.first = render::first_quality(renderer.device());
    RenderTimes times;
    shared.ready = true;
    while (!shared.stop) {
        pacer.wait();
        staller.pass(Stall::Thread::render);
        advance(shared.pictures, state.buffer);
        follow_scene(plan, shared, renderer, state);
        const bool changed = shared.screen.take();
        const auto& screen = shared.screen.newest();
        if (screen.frames_per_second != frames_per_second)
            pacer = render::Pacer(frames_per_second = screen.frames_per_second);
        const auto size = window.size();
        if (!state.buffer.any || window.minimised() || size.width <= 0 || size.height <= 0) {
            // No picture is shown now, so nobody sees what these events did. Their delays are not counted.
            take_due(shared.stamps, monotonic_ns(), [](const InputStamp&) {});
            continue;
        }
        if (!due(state, screen, changed)) continue;
        const auto begun_ns = monotonic_ns();
        show_picture(screen, size, window, renderer, state);
        count_picture(begun_ns, screen, shared, state, times);
        warm_up_next(renderer, shared, state);
    }
    shared.report.frame_ms_median = times.frames.at(0.5);
    shared.report.frame_ms_p99 = times.frames.at(0.99);
    shared.report.input_ms_median = times.inputs.at(0.5);
    shared.report.input_ms_p99 = times.inputs.at(0.99);
}

}  // namespace

void run_render(const LivePlan& plan, LiveShared& shared, render::Window& window) {
    window.make_current();
    if (auto renderer = render::Renderer::create(plan.assets)) {
        if (render::is_software(renderer->device())) render::draw_behind_others();
        draw_until_stopped(plan, shared, window, *renderer);
    } else {
        shared.render_error = renderer.error();
        shared.stop = true;
        window.wake();
    }
    window.release_current();
}

}  // namespace thaum::game::inline live

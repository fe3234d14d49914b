// The lab in a window. One thread: what people do, steps of 16 ms as the clock has them, a picture. Where a step takes longer than
// it lasts the brew goes on more slowly, and says so; nothing here must be on time.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/clock.h"
#include "core/one_line.h"
#include "core/text.h"
#include "game/app/command.h"
#include "game/app/lab.h"
#include "game/app/lab_picture.h"
#include "game/app/settings.h"
#include "game/lab/lab_file.h"
#include "game/match/data.h"
#include "render/pace.h"

namespace thaum::app {
namespace {

using game::LabState;

constexpr int steps_of_a_frame = 4;  // beyond that time is let go
constexpr double note_s = 4, rate_s = 0.5;
constexpr double pour_m3 = 2e-3;  // in a step, while the key is held; at least once for each press
constexpr double above = 0.15;    // m, where a ladle is out of the brew
constexpr double dip_m = 0.04;    // in a step, up and down
constexpr double follow = 0.5, way_most = 0.12;  // m, in a step: how a ladle follows the mouse
constexpr double depth_step = 0.08;              // m
constexpr double within_walls = 0.93;            // of the basin's width
constexpr double turn_per_px = 0.008, nearer = 0.9;
constexpr double flat_view = 0.2;  // rad: seen from so low, the ladle goes up and down with the mouse
constexpr double frames_per_second = 60;

struct LabDesk {
    LabPlan plan;
    LabTrace trace;
    LabPage page{};
    game::LabFigures figures{};
    std::filesystem::path file{};  ///< to save to and load from

    std::optional<fvec2> cursor{};  ///< px
    bool stirring = false, turning = false, pouring = false;
    bool pour_is_due = false;                                ///< pressed since the last step
    bool wants_reset = false, leaves = false, anew = false;  ///< anew: the picture's bowl is another one
    double height{};                                         ///< m, of a ladle that stirs, below the level
    std::optional<vec3> ladle{};  ///< as the mouse leads it; also while it is lifted out
    std::int64_t note_until_ns = 0;
};

void note(LabDesk& desk, std::string_view words) {
    desk.page.note = in_one_line(words);
    desk.note_until_ns = monotonic_ns() + std::llround(note_s * 1e9);
}

// ---- the ladle ---------------------------------------------------------------------------------------------------------

/// Inside of the walls.
vec3 in_basin(const LabState& lab, vec3 place) {
    place.y = std::clamp(place.y, -0.95 * lab.basin.depth, above);
    const double width = within_walls * game::width_at(lab.basin, std::min(place.y, 0.0));
    const double far = std::sqrt(place.x * place.x + place.z * place.z);
    if (far > width) place *= vec3(width / far, 1, width / far);
    return place;
}

/// Where the mouse points: in the level plane that the ladle is in; seen from the side, in the upright one through the middle.
std::optional<vec3> pointed_at(const LabDesk& desk, render::Size size) {
    if (!desk.cursor || size.height <= 0) return std::nullopt;
    const auto camera = camera_of(desk.page.eye);
    const double tall = std::tan(double{camera.fov_y} / 2);
    const double half = 0.5 * size.height;
    const vec3 ray =
        quat(camera.orientation) * vec3(tall * (double{desk.cursor->x} - 0.5 * size.width) / half,
                                        tall * (half - double{desk.cursor->y}) / half, -1);
    const vec3 eye(camera.position);
    const bool flat = desk.page.eye.pitch < flat_view;
    const vec3 normal = flat ? quat(camera.orientation) * vec3(0, 0, 1) : vec3(0, 1, 0);
    const double slope = glm::dot(ray, normal);
    const double way = glm::dot(vec3(0, desk.height, 0) - eye, normal) / slope;
    if (!(std::abs(slope) > 1e-6) || !(way > 0)) return std::nullopt;
    return in_basin(desk.plan.lab, eye + way * ray);
}

/// One step further: it comes down where the mouse is, follows it, and is lifted out again.
void move_ladle(LabDesk& desk, render::Size size) {
    const auto target = desk.stirring ? pointed_at(desk, size) : std::nullopt;
    if (target && !desk.ladle) desk.ladle = vec3(target->x, above, target->z);
    if (!desk.ladle) return;
    vec3& at = *desk.ladle;
    if (target) {
        const vec3 way = limited(follow * vec3(target->x - at.x, 0, target->z - at.z), way_most);
        const double down = std::clamp(target->y - at.y, -dip_m, dip_m);
        at = in_basin(desk.plan.lab, at + way + vec3(0, down, 0));
    } else if (!desk.stirring) {
        at.y += dip_m;
        if (at.y > above) desk.ladle.reset();
    }
}

// ---- keys and mouse ----------------------------------------------------------------------------------------------------

void save_now(LabDesk& desk) {
    if (desk.file.empty()) return note(desk, "there is no home folder: --save FILE says where");
    std::error_code failed;
    if (desk.file.has_parent_path()) std::filesystem::create_directories(desk.file.parent_path(), failed);
    const auto saved = game::save_lab(desk.plan.lab, desk.file);
    note(desk, saved ? text("saved: ", desk.file.string()) : saved.error().message);
}

void load_now(LabDesk& desk) {
    auto lab = game::load_lab(desk.file, desk.plan.lab.rules);
    if (!lab) return note(desk, lab.error().message);
    desk.anew = lab->settings.room != desk.plan.lab.settings.room;
    desk.plan.lab = std::move(*lab);
    desk.page.hands.settings = desk.plan.lab.settings;
    desk.figures = game::figures_of(desk.plan.lab);
    note(desk, text("loaded: ", desk.file.string()));
}

void press(LabDesk& desk, std::string_view key) {
    if (game::turn_control(key, desk.page.hands, desk.plan.lab.rules)) return;
    if (key == "Esc") desk.leaves = true;
    if (key == "Space") desk.pour_is_due = true;
    if (key == "Backspace") desk.wants_reset = true;
    if (key == "F5") save_now(desk);
    if (key == "F9") load_now(desk);
    if (key == "PageUp") desk.height = std::min(0.0, desk.height + depth_step);
    if (key == "PageDown") desk.height = std::max(-0.9 * desk.plan.lab.basin.depth, desk.height - depth_step);
}

void cursor_moved(LabDesk& desk, fvec2 to) {
    if (desk.turning && desk.cursor) {
        const fvec2 way = to - *desk.cursor;
        desk.page.eye = turned(desk.page.eye, -turn_per_px * double{way.x}, turn_per_px * double{way.y}, 1);
    }
    desk.cursor = to;
}

render::WindowEvents lab_events(LabDesk& desk) {
    render::WindowEvents events;
    events.key = [&](int key, int, bool pressed) {
        const auto name = render::key_name(key);
        if (name == "Space") desk.pouring = pressed;
        if (pressed) press(desk, name);
    };
    events.mouse_button = [&](int button, bool pressed) {
        if (button == 0) desk.stirring = pressed;
        if (button == 1) desk.turning = pressed;
    };
    events.cursor = [&](double x, double y) { cursor_moved(desk, fvec2(vec2(x, y))); };
    events.wheel = [&](double steps) {
        desk.page.eye = turned(desk.page.eye, 0, 0, std::pow(nearer, steps));
    };
    events.focus = [&](bool focused) {
        if (!focused) desk.stirring = desk.turning = desk.pouring = false;
    };
    return events;
}

// ---- steps -------------------------------------------------------------------------------------------------------------

bool same_settings(const game::LabSettings& a, const game::LabSettings& b) {
    const auto same = [](const game::Ingredient& i, const game::Ingredient& j) {
        return i.name == j.name && i.substance.viscosity == j.substance.viscosity &&
               i.substance.weight == j.substance.weight && i.substance.diffusion == j.substance.diffusion;
    };
    return a.solver == b.solver && a.cells == b.cells && a.order == b.order && a.bowl == b.bowl &&
           a.no_slip == b.no_slip && a.viscosity == b.viscosity && a.gravity == b.gravity &&
           std::ranges::equal(a.substances, b.substances, same);
}

/// The script's, unless a hand does something.
game::LabInput input_now(LabDesk& desk, render::Size size) {
    auto& lab = desk.plan.lab;
    game::LabInput input = game::scripted_input(desk.plan.script, lab);
    move_ladle(desk, size);
    if (desk.ladle) input.ladle = desk.ladle;
    const bool pours = std::exchange(desk.pour_is_due, false) || desk.pouring;
    if (pours && desk.page.hands.chosen < lab.settings.substances.size())
        input.pours.push_back({desk.page.hands.chosen, pour_m3, game::place_to_pour(lab, input.ladle)});
    if (!same_settings(desk.page.hands.settings, lab.settings)) input.change = desk.page.hands.settings;
    input.reset = std::exchange(desk.wants_reset, false);
    return input;
}

void step_desk(LabDesk& desk, render::Size size, Jobs& jobs) {
    const auto input = input_now(desk, size);
    desk.figures = game::step_lab(desk.plan.lab, input, jobs);
    if (!desk.figures.refused.empty()) {
        note(desk, desk.figures.refused);
        desk.page.hands.settings = desk.plan.lab.settings;
    }
    desk.trace.add(desk.plan.lab, desk.figures);
}

/// Which steps are due, by the clock; and how many there are in a second.
struct LabClock {
    std::int64_t last_ns = monotonic_ns();
    double owed_s{}, counted_s{};
    int counted{};

    int due(double& steps_per_s) {
        const auto now = monotonic_ns();
        const double passed = static_cast<double>(now - last_ns) * 1e-9;
        last_ns = now;
        owed_s += passed;
        counted_s += passed;
        if (counted_s > rate_s) {
            steps_per_s = counted / counted_s;
            counted = 0;
            counted_s = 0;
        }
        const int steps = std::min(steps_of_a_frame, static_cast<int>(owed_s / game::lab_dt));
        owed_s = steps == steps_of_a_frame ? 0 : owed_s - steps * game::lab_dt;
        counted += steps;
        return steps;
    }
};

bool over(const LabDesk& desk, const render::Window& window, std::int64_t end) {
    return desk.leaves || window.should_close() || desk.plan.lab.steps >= end;
}

Expected<void> run(LabDesk& desk, render::Window& window, render::Renderer& renderer) {
    const auto events = lab_events(desk);
    std::optional<LabPicture> picture(std::in_place, renderer, desk.plan.lab);
    Jobs jobs(desk.plan.threads - 1);
    render::Pacer pacer(frames_per_second);
    LabClock clock;
    const auto end = desk.plan.seconds ? desk.plan.lab.steps + std::llround(*desk.plan.seconds / game::lab_dt)
                                       : std::numeric_limits<std::int64_t>::max();
    while (!over(desk, window, end)) {
        window.poll(events);
        const auto size = window.size();
        const auto before = desk.plan.lab.steps;
        const int due = clock.due(desk.page.steps_per_s);
        for (int i = 0; i < due && !desk.page.hands.paused && desk.plan.lab.steps < end; ++i)
            step_desk(desk, size, jobs);
        if (desk.note_until_ns < monotonic_ns()) desk.page.note.clear();
        if (std::exchange(desk.anew, false)) picture.emplace(renderer, desk.plan.lab);
        if (!window.minimised() && size.width > 0 && size.height > 0) {
            renderer.draw(picture->frame(desk.plan.lab, desk.figures, desk.page, size));
            if (desk.plan.shots && before / desk.plan.every != desk.plan.lab.steps / desk.plan.every) {
                if (auto put = write_lab_shot(*desk.plan.shots, desk.plan.lab.steps, renderer.read_pixels());
                    !put)
                    return put;
            }
            window.present();
        }
        pacer.wait();
    }
    return {};
}

Expected<void> end(LabDesk& desk) {
    if (auto closed = desk.trace.close(); !closed) return closed;
    return desk.plan.save ? game::save_lab(desk.plan.lab, *desk.plan.save) : Expected<void>();
}

}  // namespace

int run_lab_window(LabPlan plan) {
    const auto assets = game::find_assets();
    const auto settings = settings_to_play_with(settings_file(), assets);
    auto window = render::Window::create(
        {.title = "Thaum: the brew", .size = plan.size, .fullscreen = settings.fullscreen});
    if (!window) return refuse(window.error());
    auto trace = LabTrace::open(plan);
    if (!trace) return refuse(trace.error());
    if (auto made = make_lab_folder(plan); !made) return refuse(made.error());
    window->make_current();
    LabDesk desk{.plan = std::move(plan), .trace = std::move(*trace)};
    desk.file = desk.plan.save.value_or(
        matches_folder().empty() ? std::filesystem::path() : matches_folder().parent_path() / "lab.brew");
    desk.page.hands.settings = desk.plan.lab.settings;
    desk.page.text_scale = settings.text_scale;
    desk.height = -0.35 * desk.plan.lab.basin.depth;
    Expected<void> went;
    {
        auto renderer = render::Renderer::create(assets);
        went = renderer ? run(desk, *window, *renderer) : tl::unexpected(renderer.error());
    }
    window->release_current();
    if (!went) return refuse(went.error());
    if (auto ended = end(desk); !ended) return refuse(ended.error());
    return done;
}

}  // namespace thaum::app

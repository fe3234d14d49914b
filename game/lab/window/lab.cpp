// thaum lab: explores the cauldron's brew alone.
#include "game/lab/window/lab.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/clock.h"
#include "core/file.h"
#include "core/hash.h"
#include "core/text.h"
#include "game/command_line/arguments.h"
#include "game/command_line/command.h"
#include "game/data/match_data.h"
#include "game/lab/lab_file.h"
#include "game/lab/lab_trace.h"
#include "game/lab/window/volume_lab.h"
#include "game/live/end_watch.h"
#include "render/display.h"

namespace thaum::game::inline lab {

namespace {

constexpr std::string_view lab_help =
    R"(usage: thaum lab --fluid [OPTIONS]

The cauldron's brew alone, to stir and to measure: in a window, which lists its
keys, or with --headless faster than real time.

  --solver NAME    thaum (default), or classic: the paper's method, without a bowl
  --cells N        cells from wall to wall: 15, 16, 24, 32 (default), 48 or 64
  --order N        order of accuracy: 4 (default) or 2; with a bowl always 2
  --bowl, --box    the match's bowl (default), or the box round it
  --edges NAME     flow at the walls: no_slip (default) or free_slip
  --viscosity X    of the base fluid (m^2/s);  --gravity X  downwards (m/s^2, 9.81)
  --substance S    an ingredient, or NAME,VISCOSITY,WEIGHT,DIFFUSION; three at most
  --pour S,AT,L    at second AT, L litres of that substance (name or number); repeats
  --stir PATH      circle, figure8, none, or FILE.csv with time_s,x_m,y_m,z_m
                   (headless: circle; the window: the mouse)
  --load FILE      continues a saved state;  --save FILE  saves the state at the end,
                   replacing an older file, but not the loaded one; --trace too
  --trace FILE     CSV, one row a step of 16 ms;  --times  adds computing times (us)
  --shots DIR      pictures;  --every N  steps from picture to picture (25)
  --size WxH       size of the pictures or of the window in px (1280x720)
  --headless       no window;  --seconds S  length of the session (headless: 10)
  --threads N      1 (default) or 2; both give the same bits
)";

constexpr Option lab_options[] = {
    {"--fluid"},      {"--solver", 1},     {"--cells", 1},     {"--order", 1},   {"--bowl"},
    {"--box"},        {"--edges", 1},      {"--viscosity", 1}, {"--gravity", 1}, {"--substance", 1, true},
    {"--stir", 1},    {"--pour", 1, true}, {"--load", 1},      output("--save"), output("--trace"),
    {"--times"},      {"--shots", 1},      {"--every", 1},     {"--size", 1},    {"--headless"},
    {"--seconds", 1}, {"--threads", 1}};

/// Options of the command line that change settings of the lab.
constexpr std::array<std::string_view, 9> setting_words{"--solver",    "--cells",   "--order",
                                                        "--bowl",      "--box",     "--edges",
                                                        "--viscosity", "--gravity", "--substance"};

/// Index of the option's value in `names`; `fallback` if the option was not given.
Expected<std::size_t> one_of(const Arguments& arguments, std::string_view option,
                             std::array<std::string_view, 2> names, std::size_t fallback) {
    const auto word = arguments.value(option);
    if (!word) return fallback;
    const auto found = std::find(names.begin(), names.end(), *word);
    if (found == names.end())
        return fail(text(option, " '", *word, "': must be ", names[0], " or ", names[1]));
    return static_cast<std::size_t>(found - names.begin());
}

// ---- settings ---------------------------------------------------------------------------------------------

Expected<Ingredient> read_substance(const std::string& words, const CauldronRules& rules) {
    const auto parts = parts_of(words);
    const auto known = std::find_if(rules.ingredients.begin(), rules.ingredients.end(),
                                    [&](const Ingredient& i) { return i.name == parts[0]; });
    if (known == rules.ingredients.end()) {
        std::string names;
        for (const auto& i : rules.ingredients) names += (names.empty() ? "" : ", ") + i.name;
        return fail(text("--substance '", words, "': there are ", names));
    }
    auto result = *known;
    if (parts.size() == 1) return result;
    if (parts.size() != 4)
        return fail(text("--substance '", words, "': must be NAME or NAME,VISCOSITY,WEIGHT,DIFFUSION"));
    const std::array<double*, 3> numbers{&result.substance.viscosity, &result.substance.weight,
                                         &result.substance.diffusion};
    constexpr std::array<std::pair<double, double>, 3> ranges{{{0, fluid::max_viscosity}, {-1, 10}, {0, 1}}};
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const auto number = parse_number(parts[i + 1], "--substance", ranges[i].first, ranges[i].second);
        if (!number) return number.error();
        *numbers[i] = *number;
    }
    return result;
}

Expected<void> read_substances(const Arguments& arguments, const CauldronRules& rules,
                               LabSettings& settings) {
    const auto words = arguments.values("--substance");
    if (words.empty()) return {};
    if (words.size() > fluid::max_substances)
        return fail(text("--substance is given ", words.size(), " times: a brew has at most ",
                         fluid::max_substances, " substances"));
    settings.substances.clear();
    for (const auto& word : words) {
        auto substance = read_substance(word, rules);
        if (!substance) return substance.error();
        settings.substances.push_back(std::move(*substance));
    }
    return {};
}

Expected<void> read_cells(const Arguments& arguments, LabSettings& settings) {
    const auto word = arguments.value("--cells");
    if (!word) return {};
    for (const int cells : lab_cells) {
        if (*word != text(cells)) continue;
        settings.cells = cells;
        return {};
    }
    return fail(text("--cells '", *word,
                     "': must be 15, 16, 24, 32, 48 or 64, the number from wall to wall; cells are cubes"));
}

/// Settings after the changes of the command line.
Expected<LabSettings> read_settings(const Arguments& arguments, const CauldronRules& rules,
                                    LabSettings settings) {
    const auto solver =
        one_of(arguments, "--solver", {"thaum", "classic"}, settings.solver == fluid::Solver::thaum ? 0 : 1);
    if (!solver) return solver.error();
    const auto edges = one_of(arguments, "--edges", {"no_slip", "free_slip"}, settings.no_slip ? 0 : 1);
    if (!edges) return edges.error();
    const auto order = one_of(arguments, "--order", {"2", "4"}, settings.order == 2 ? 0 : 1);
    if (!order) return order.error();
    const auto viscosity = arguments.number("--viscosity", 0, fluid::max_viscosity, settings.viscosity);
    if (!viscosity) return viscosity.error();
    const auto gravity = arguments.number("--gravity", -100, 100, settings.gravity);
    if (!gravity) return gravity.error();
    if (arguments.has("--bowl") && arguments.has("--box")) return fail("--bowl and --box exclude each other");
    settings.solver = *solver == 0 ? fluid::Solver::thaum : fluid::Solver::classic;
    settings.no_slip = *edges == 0;
    settings.order = *order == 0 ? 2 : 4;
    settings.viscosity = *viscosity;
    settings.gravity = *gravity;
    if (arguments.has("--bowl")) settings.bowl = true;
    if (arguments.has("--box")) settings.bowl = false;
    if (auto read = read_cells(arguments, settings); !read) return read.error();
    if (auto read = read_substances(arguments, rules, settings); !read) return read.error();
    return settings;
}

/// State of a new or loaded session after the changes of the command line.
Expected<LabState> read_lab(const Arguments& arguments, const LabData& data) {
    const auto file = arguments.value("--load");
    if (!file) {
        const auto settings = read_settings(arguments, data.rules, lab_settings(data));
        if (!settings) return settings.error();
        return make_lab(data.rules, *settings);
    }
    auto lab = load_lab(*file, data.rules);
    if (!lab || std::none_of(setting_words.begin(), setting_words.end(),
                             [&](std::string_view word) { return arguments.has(word); }))
        return lab;
    const auto settings = read_settings(arguments, data.rules, lab->settings);
    if (!settings) return settings.error();
    if (auto changed = change_lab(*lab, *settings); !changed) return changed.error();
    return lab;
}

// ---- script -----------------------------------------------------------------------------------------------

Expected<std::size_t> read_slot(const std::string& word, const LabSettings& settings) {
    const auto& all = settings.substances;
    const auto named =
        std::find_if(all.begin(), all.end(), [&](const Ingredient& i) { return i.name == word; });
    if (named != all.end()) return static_cast<std::size_t>(named - all.begin());
    for (std::size_t i = 0; i < all.size(); ++i)
        if (word == text(i + 1)) return i;
    return fail(text("--pour '", word, "': the brew has no such substance"));
}

Expected<LabScript::Pour> read_pour(const std::string& words, const LabState& lab) {
    const auto parts = parts_of(words);
    if (parts.size() != 3) return fail(text("--pour '", words, "': must be SUBSTANCE,SECOND,LITRES"));
    const auto slot = read_slot(parts[0], lab.settings);
    if (!slot) return slot.error();
    const auto at = parse_number(parts[1], "--pour", lab.seconds(), 1e6);
    if (!at) return at.error();
    const auto litres = parse_number(parts[2], "--pour", 1e-6, 1e4);
    if (!litres) return litres.error();
    return LabScript::Pour{std::llround(*at / lab_dt), *slot, 1e-3 * *litres};
}

Expected<LabScript> read_script(const Arguments& arguments, const LabState& lab, bool headless) {
    LabScript script;
    auto path = stir_path(arguments.value("--stir").value_or(headless ? "circle" : "none"));
    if (!path) return path.error();
    script.path = std::move(*path);
    for (const auto& words : arguments.values("--pour")) {
        const auto pour = read_pour(words, lab);
        if (!pour) return pour.error();
        script.pours.push_back(*pour);
    }
    return script;
}

// ---- the whole plan ------------------------------------------------------------------------------------

Expected<LabPlan> read_plan(const Arguments& arguments) {
    if (!arguments.plain().empty()) return fail(text("lab --fluid takes no '", arguments.plain()[0], "'"));
    const bool headless = arguments.has("--headless");
    const auto data = load_lab_data(find_assets());
    if (!data) return data.error();
    auto lab = read_lab(arguments, *data);
    if (!lab) return lab.error();
    auto script = read_script(arguments, *lab, headless);
    if (!script) return script.error();
    LabPlan plan{.lab = std::move(*lab), .script = std::move(*script)};
    const auto seconds = arguments.number("--seconds", lab_dt, 36'000);
    if (!seconds) return seconds.error();
    plan.seconds = headless ? seconds->value_or(10) : *seconds;
    const auto threads = arguments.whole("--threads", 1, 2, 1);
    if (!threads) return threads.error();
    plan.threads = static_cast<unsigned>(*threads);
    auto outputs = read_lab_outputs(arguments, 25);
    if (!outputs) return outputs.error();
    plan.out = std::move(*outputs);
    plan.times = arguments.has("--times");
    if (plan.times && !plan.out.trace) return fail("--times needs --trace");
    return plan;
}

// ---- without a window -------------------------------------------------------------------------------------

void tell_end(const LabState& lab, const LabFigures& last, std::int64_t steps, double took_s) {
    const auto& s = lab.settings;
    std::printf("lab: %s s of the brew in %s s; %d cells across, %s, %s\n",
                fixed(lab_dt * static_cast<double>(steps), 2).c_str(), fixed(took_s, 2).c_str(), s.cells,
                s.solver == fluid::Solver::thaum ? "thaum" : "classic",
                lab.brew.fluid.settings.solid ? "bowl" : "box");
    std::printf("energy %s m^5/s^2, fastest %s m/s, divergence %s, mixing %s\n",
                fixed(last.fluid.energy, 4).c_str(), fixed(last.fluid.speed, 3).c_str(),
                text(static_cast<float>(last.fluid.divergence)).c_str(), fixed(last.mixing, 3).c_str());
    std::printf("state %s\n", hex(hash_bytes(save_lab(lab))).c_str());
}

int run_headless(LabPlan plan) {
    if (const auto free = plan.out.save ? check_output(*plan.out.save) : Expected<void>(); !free)
        return refuse(free.error());
    auto trace = LabTrace::open(plan.out.trace, lab_trace_header(plan.times));
    if (!trace) return refuse(trace.error());
    auto shots = LabShots::open(plan);
    if (!shots) return refuse(shots.error());
    Jobs jobs(plan.threads - 1);
    LabFigures figures;
    const auto start = monotonic_ns();
    const auto steps = std::llround(*plan.seconds / lab_dt);
    const EndWatch watch;
    std::int64_t i = 0;
    for (; i < steps && !EndWatch::asked(); ++i) {
        figures = step_lab(plan.lab, scripted_input(plan.script, plan.lab), jobs);
        trace->add([&](std::string& rows) { append_lab_row(plan.lab, figures, plan.times, rows); });
        if (auto put = shots->follow(plan.lab, figures); !put) return refuse(put.error());
    }
    const double took = static_cast<double>(monotonic_ns() - start) * 1e-9;
    if (auto closed = trace->close(); !closed) return refuse(closed.error());
    if (plan.out.save) {
        if (auto saved = save_lab(plan.lab, *plan.out.save); !saved) return refuse(saved.error());
    }
    tell_end(plan.lab, figures, i, took);
    tell_end_by_signal();
    return done;
}

int run_brew_lab(const std::vector<std::string>& words) {
    const auto arguments = Arguments::parse(words, lab_options);
    if (!arguments) return refuse(arguments.error());
    if (!arguments->has("--headless") && !render::display_there())
        return refuse({"lab needs a display; without one: thaum lab --fluid --headless"});
    auto plan = read_plan(*arguments);
    if (!plan) return refuse(plan.error());
    return arguments->has("--headless") ? run_headless(std::move(*plan)) : run_lab_window(std::move(*plan));
}

}  // namespace

int run_lab(const std::vector<std::string>& words) {
    const bool fluid = std::ranges::find(words, "--fluid") != words.end();
    if (asks_for_help(words)) {
        std::printf("%s", std::string(fluid ? lab_help : volume_lab_help()).c_str());
        return done;
    }
    return fluid ? run_brew_lab(words) : run_volume_lab(words);
}

}  // namespace thaum::game::inline lab

#include "game/lab/lab_file.h"

#include <algorithm>

#include "core/file.h"
#include "core/text.h"
#include "fluid/saved.h"

namespace thaum::game::inline lab {
namespace {

// Largest size of a saved session that is read (bytes). A session with 64 cells from wall to wall needs 5
// million.
constexpr std::size_t max_lab_file = 256U << 20U;
constexpr std::size_t max_name = 32;  // longest name of a substance (characters)
constexpr std::uint32_t kept_version = 1;
constexpr std::int64_t max_steps = std::int64_t{1} << 40;

template <class Room, class F>
void each_number(Room& room, F&& f) {
    f(room.size.radius), f(room.size.height), f(room.size.thickness), f(room.filled);
}

bool has_solids(const LabSettings& s) { return s.bowl && s.solver == fluid::Solver::thaum; }

/// Walls of the fluid's grid. They follow from the bowl and the number of cells.
fluid::NamedShape shape_of(const LabSettings& settings) {
    if (!has_solids(settings)) return {};
    fluid::NamedShape shape{.name = "bowl"};
    each_number(settings.room, [&](double number) { shape.numbers.push_back(number); });
    shape.numbers.push_back(settings.cells);
    return shape;
}

Expected<void> check(const LabBowl& room) {
    const auto& size = room.size;
    const bool sound = size.radius >= 0.1 && size.radius <= 100 && size.height >= 0.1 * size.radius &&
                       size.height <= 2 * size.radius && size.thickness >= 0.01 &&
                       size.thickness <= 0.25 * std::min(size.radius, size.height) && room.filled >= 0.3 &&
                       room.filled <= 1;
    if (!sound) return fail("no bowl can have its size");
    return {};
}

Expected<std::function<double(vec3)>> solid_of(const fluid::NamedShape& shape, CauldronRules rules) {
    if (shape.name != "bowl" || shape.numbers.size() != 5) return fail("its solids do not form a bowl");
    LabBowl room;
    std::size_t next = 0;
    each_number(room, [&](double& number) { number = shape.numbers[next++]; });
    if (auto sound = check(room); !sound) return sound.error();
    const bool known = std::ranges::any_of(lab_cells, [&](int n) { return n == shape.numbers[next]; });
    if (!known) return fail("its bowl has a number of cells that the lab has not");
    rules.cells_across = static_cast<int>(shape.numbers[next]);
    // The walls do not depend on the solver, and the tables of the solver `classic` are the quickest to
    // compute.
    rules.solver = fluid::Solver::classic;
    auto brew = make_brew(rules, basin_of(room.size, room.filled));
    if (!brew) return brew.error();
    return brew->fluid.settings.solid;
}

// ---- parts of the lab besides fluid and surface -----------------------------------------------------------

Bytes kept_of(const LabState& lab) {
    Bytes bytes;
    ByteWriter out(bytes);
    const auto& s = lab.settings;
    out.put(kept_version);
    out.put(lab.steps);
    out.put(static_cast<std::uint32_t>(lab.last_poured));
    out.put(lab.ladle.has_value());
    for (int axis = 0; axis < 3; ++axis) out.put(lab.ladle.value_or(vec3(0))[axis]);
    out.put(static_cast<std::int32_t>(s.cells));
    out.put(s.bowl);
    out.put(s.no_slip);
    out.put(s.gravity);
    each_number(s.room, [&](double number) { out.put(number); });
    for (const Ingredient& i : s.substances) {
        out.put_string(i.name);
        for (int c = 0; c < 3; ++c) out.put(i.colour[c]);
    }
    return bytes;
}

Expected<Ingredient> get_ingredient(ByteReader& in, const fluid::Substance& substance) {
    Ingredient result{.name = in.get_string(), .substance = substance};
    for (int c = 0; c < 3; ++c) result.colour[c] = in.get<double>();
    const bool plain =
        std::ranges::all_of(result.name, [](char c) { return c >= ' ' && c < 0x7f && c != ','; });
    if (result.name.empty() || result.name.size() > max_name || !plain)
        return fail("a substance has no name that could be one");
    for (int c = 0; c < 3; ++c)
        if (!(result.colour[c] >= 0 && result.colour[c] <= 1))
            return fail("a substance has a colour that is none");
    return result;
}

/// Reads the whole state of the lab except the brew.
Expected<LabState> get_kept(ByteReader& in, const fluid::Settings& fluid, const CauldronRules& rules) {
    LabState lab{.rules = rules};
    auto& s = lab.settings;
    if (in.get<std::uint32_t>() != kept_version)
        return fail("the lab's part of the file has another version");
    lab.steps = in.get<std::int64_t>();
    lab.last_poured = in.get<std::uint32_t>();
    const bool dips = in.get<bool>();
    vec3 ladle;
    for (int axis = 0; axis < 3; ++axis) ladle[axis] = in.get<double>();
    s.cells = in.get<std::int32_t>();
    s.bowl = in.get<bool>();
    s.no_slip = in.get<bool>();
    s.gravity = in.get<double>();
    each_number(s.room, [&](double& number) { number = in.get<double>(); });
    s.solver = fluid.solver;
    s.order = fluid.order;
    s.viscosity = fluid.viscosity;
    for (const fluid::Substance& substance : fluid.substances) {
        auto ingredient = get_ingredient(in, substance);
        if (!ingredient) return ingredient.error();
        s.substances.push_back(std::move(*ingredient));
    }
    if (!in.ok() || in.left() != 0) return fail("the lab's part of the file is cut off or too long");
    if (lab.steps < 0 || lab.steps > max_steps || !is_finite(ladle) ||
        lab.last_poured >= fluid::max_substances)
        return fail("the lab's part of the file has impossible values");
    if (dips) lab.ladle = ladle;
    return lab;
}

/// Whether the saved fluid and surface fit the brew that these settings make.
bool fits_settings(const fluid::SavedFluid& saved, const LabState& lab, const Brew& made) {
    const auto &a = saved.fluid.settings, &b = made.fluid.settings;
    return saved.shape == shape_of(lab.settings) && a.cells == b.cells && a.h == b.h && a.edges == b.edges &&
           a.gravity == b.gravity && a.lid == b.lid && a.no_slip_at_solids == b.no_slip_at_solids &&
           saved.surface.settings.side == made.surface.settings.side;
}

Error wrong(const Error& error) { return fail(text("saved lab: ", error.message)); }

Expected<LabState> with_name(const std::filesystem::path& file, Expected<LabState> lab) {
    if (lab) return lab;
    return fail(text(file.string(), ": ", lab.error().message));
}

}  // namespace

Bytes save_lab(const LabState& lab) {
    return fluid::save(lab.brew.fluid, lab.brew.surface, shape_of(lab.settings), kept_of(lab));
}

Expected<LabState> restore_lab(std::span<const std::byte> bytes, const CauldronRules& rules) {
    auto saved =
        fluid::restore(bytes, [&](const fluid::NamedShape& shape) { return solid_of(shape, rules); });
    if (!saved) return saved.error();
    ByteReader in(saved->caller_data);
    auto lab = get_kept(in, saved->fluid.settings, rules);
    if (!lab) return wrong(lab.error());
    if (auto sound = check(lab->settings.room); !sound) return wrong(sound.error());
    auto made = make_lab(rules, lab->settings);
    if (!made) return wrong(made.error());
    if (!fits_settings(*saved, *lab, made->brew)) return wrong({"its grid is not that of its bowl"});
    lab->basin = std::move(made->basin);
    lab->brew = std::move(made->brew);
    lab->brew.fluid = std::move(saved->fluid);
    lab->brew.surface = std::move(saved->surface);
    return std::move(*lab);
}

Expected<void> save_lab(const LabState& lab, const std::filesystem::path& file) {
    return write_file(file, save_lab(lab));
}

Expected<LabState> load_lab(const std::filesystem::path& file, const CauldronRules& rules) {
    const auto bytes = read_file(file, max_lab_file);
    if (!bytes) return bytes.error();
    return with_name(file, restore_lab(*bytes, rules));
}

}  // namespace thaum::game::inline lab

#include "game/lab/volume_lab.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "core/assert.h"
#include "core/config.h"
#include "core/file.h"
#include "core/hash.h"
#include "core/near_name.h"
#include "core/one_line.h"
#include "core/text.h"
#include "field/voxel_state.h"
#include "field/voxel_volume.h"

namespace thaum::game::inline lab {
namespace {

/// Share of the device's workspace that the volume fills.
constexpr double filled = 0.9;
/// Initial strength of a newly chosen mode, as a share of the device's continuous force.
constexpr double usual_strength = 0.8;
/// Depth at which the hand has broken through a wall (samples).
constexpr double reach_samples = 2;
/// Largest distance of a volume's middle from that of the workspace, along each axis (m).
constexpr double farthest_place = 1;
/// Displacement of a volume in one change of settings above which the servo, which computes the force, fades
/// to the new force instead of giving it at once (m).
constexpr double jump = 0.001;
constexpr std::int64_t device_file_version = 1;
constexpr std::size_t max_file_bytes = std::size_t{1} << 20U;

/// A volume in its present state as the input of filters. `version` is different for each volume and after
/// each of its changes.
field::FilterSource source_of(const field::Volume& volume, const LabSource& views, std::uint64_t version) {
    field::FilterSource source{.count = volume.count, .spacing = volume.spacing};
    if (volume.components == 1)
        source.field.scalar = field::field_of<field::Scalar>(views.density);
    else
        source.field.vector = field::field_of<field::Vector>(views.flow);
    source.version = version;
    return source;
}

haptics::SmoothGrid density_of(const field::Grid& grid, const field::BlockAverages& averages,
                               field::SampleRange range) {
    return {grid, averages.grid(grid), {range.low, range.high}, averages.coarse_steps};
}

/// Makes the views of all volumes, by which modes and filters read them, refer to the volumes' present
/// samples.
void refresh_views(VolumeLab& lab) {
    auto& views = *lab.views;
    if (lab.carvable()) {
        const field::Grid grid = lab.body.density_grid(field::Kernel::linear);
        field::update(views.averages, grid, lab.body.bricks);
        views.density = density_of(grid, views.averages, lab.range);
        views.placed_density = {field::field_of<field::Scalar>(views.density), lab.placement};
        views.materials = {lab.body.count, lab.body.spacing, lab.placement, lab.body.material};
    } else {
        views.flow = lab.source.vector_grid();
    }
    for (auto& volume : lab.beside) {
        if (volume->source.components == 1)
            volume->views.density =
                density_of(volume->source.grid(field::Kernel::linear), volume->views.averages, volume->range);
        else
            volume->views.flow = volume->source.vector_grid();
    }
}

/// Makes the views and the modes' fields, by which the volumes are read, refer to the present volumes.
/// Smoothed samples are recomputed only if something changed.
void refresh(VolumeLab& lab) {
    refresh_views(lab);
    for (std::size_t i = 0; i < lab.fields.size(); ++i) {
        LabField& f = *lab.fields[i];
        const LabMode& mode = lab.settings.modes[i];
        const bool first = mode.volume == 0;
        const auto volume = volume_of(lab, mode.volume);
        const auto source = source_of(
            volume.source, first ? *lab.views : lab.beside[mode.volume - 1]->views,
            (std::uint64_t{mode.volume} << 32U) + (first && lab.carvable() ? lab.body.bricks.newest : 1));
        if (!field::set_filters(f.filtered, source, mode.filters)) continue;
        field::place(f.placed, haptics::field_for(*haptics::find_mode(mode.name), f.filtered),
                     volume.placement);
    }
}

/// Turns a scan of a patient so that the patient stands upright and faces the user. The scan's axes point to
/// the patient's left, to the back and up (field/nrrd.h); the lab's axes point right, up and to the front.
const mat3 patient_stands{vec3(1, 0, 0), vec3(0, 0, -1), vec3(0, 1, 0)};

field::Placement fitted(const field::Volume& volume, vec3 workspace) {
    field::Placement placement;
    placement.turn = volume.is_of_patient ? patient_stands * volume.placement.turn : volume.placement.turn;
    const vec3 half = 0.5 * volume.extent();
    vec3 extent(0);
    for (int axis = 0; axis < 3; ++axis)
        for (int row = 0; row < 3; ++row) extent[row] += 2 * std::abs(placement.turn[axis][row]) * half[axis];
    placement.scale =
        filled * std::min({workspace.x / extent.x, workspace.y / extent.y, workspace.z / extent.z});
    return placement;
}

field::SampleRange lengths_of(const field::Volume& volume) {
    field::SampleRange range;
    for (std::size_t i = 0; i + 2 < volume.samples.size(); i += 3) {
        const double length =
            glm::length(vec3(volume.samples[i], volume.samples[i + 1], volume.samples[i + 2]));
        if (std::isfinite(length)) range.high = std::max(range.high, static_cast<float>(length));
    }
    return range;
}

/// Text with the names of all elements, separated by commas. `name_of` gives the name of an element of `all`.
template <class All, class Name = std::identity>
std::string listed(const All& all, Name name_of = {}) {
    std::string names;
    for (const auto& one : all) names += text(names.empty() ? "" : ", ", std::invoke(name_of, one));
    return names;
}

field::SampleRange sample_range(const field::Volume& volume) {
    return volume.components == 1 ? field::range_of(volume) : lengths_of(volume);
}

field::Placement placed(const field::Placement& fitted, const LabPlace& place) {
    return field::combined({place.origin, glm::mat3_cast(look_rotation(place.yaw, 0)), place.scale}, fitted);
}

/// Placement of a volume in the coordinate frame of its file; std::nullopt if the file has none.
std::optional<field::Placement> placement_in_file(const field::Volume& volume) {
    field::Placement placement = volume.placement;
    if (volume.has_place) return placement;
    if (!volume.file_axes || !volume.file_axes->middle) return {};
    placement.origin = *volume.file_axes->middle;
    return placement;
}

/// Placement of `part` in the frame of `whole`, given both placements in the same outer frame.
field::Placement relative(const field::Placement& whole, const field::Placement& part) {
    return {field::to_own(whole, part.origin), glm::transpose(whole.turn) * part.turn,
            part.scale / whole.scale};
}

/// Placement in the workspace of a volume in addition to the first one, before the person's own move of that
/// volume (LabPlace) is applied. A registered volume keeps its place relative to the first one, for which
/// both files must give a placement.
field::Placement fitted_beside(const VolumeLab& lab, const field::Volume& volume, bool registered) {
    const auto whole = placement_in_file(lab.source), part = placement_in_file(volume);
    if (!registered || !whole || !part) return fitted(volume, lab.data.device.workspace);
    return field::combined(lab.fitted, relative(*whole, *part));
}

Expected<void> check_places(const VolumeLab& lab, const std::vector<LabPlace>& places) {
    if (places.size() > lab.beside.size() + 1) return fail("there are more places than volumes");
    for (const auto& place : places) {
        const auto near = [](double x) { return std::abs(x) <= farthest_place; };
        const vec3 o = place.origin;
        if (!near(o.x) || !near(o.y) || !near(o.z) || !std::isfinite(place.yaw))
            return fail(text("a place must be within ", farthest_place, " m of the middle"));
        if (!(place.scale >= min_place_scale && place.scale <= max_place_scale))
            return fail(text("the scale of a place must be ", min_place_scale, " to ", max_place_scale));
    }
    return {};
}

/// Moves all volumes to their places. Returns whether any of them has turned, changed its size, or moved by
/// more than `jump`. The servo (the computation of the force) must then fade to the new force.
bool move_volumes(VolumeLab& lab, const std::vector<LabPlace>& places) {
    bool jumps = false;
    const auto place_of = [&](std::size_t n) { return n < places.size() ? places[n] : LabPlace{}; };
    const vec3 tip = haptics::measured_position(lab.device, lab.hand);
    const auto put = [&](const field::Placement& next, field::Placement& placement) {
        const vec3 there = field::to_parent(next, field::to_own(placement, tip));
        lab.moved = std::max(lab.moved, glm::distance(there, tip));
        jumps |= glm::distance(next.origin, placement.origin) > jump || next.turn != placement.turn ||
                 next.scale != placement.scale;
        placement = next;
    };
    put(placed(lab.fitted, place_of(0)), lab.placement);
    for (std::size_t i = 0; i < lab.beside.size(); ++i) {
        VolumeBeside& volume = *lab.beside[i];
        const auto own = placed(volume.fitted, place_of(i + 1));
        put(volume.registered ? placed(own, place_of(0)) : own, volume.placement);
    }
    return jumps;
}

/// Weight of a volume's feel at a position. It is 1 within the box of the volume's samples, and falls to 0
/// over the last half sample, so that no force jumps at the edge.
double share_within(const VolumeRef& volume, vec3 place) {
    const vec3 own = field::to_own(volume.placement, place), half = 0.5 * volume.source.extent();
    double share = 1;
    for (int axis = 0; axis < 3; ++axis)
        share = std::min(share, (half[axis] - std::abs(own[axis])) / (0.5 * volume.source.spacing[axis]));
    return std::max(share, 0.0);
}

void fill_primitives(VolumeLab& lab, vec3 tip, vec3 motion) {
    lab.model.primitives.clear();
    const haptics::ModeInput input{
        .proxy = lab.servo_state.primitives == 0 ? tip : lab.servo_state.proxy,
        .tip = tip,
        .stiffness = lab.model.coupling.stiffness,
        .motion = motion,
    };
    for (std::size_t i = 0; i < lab.fields.size(); ++i) {
        const LabMode& mode = lab.settings.modes[i];
        const haptics::ModeUse use{haptics::find_mode(mode.name), lab.fields[i]->placed.field, mode.settings};
        const std::size_t first = lab.model.primitives.items().size();
        haptics::add_modes(std::span(&use, 1), input, lab.model.primitives);
        if (!use.mode->ends_at_box)
            lab.model.primitives.weaken(first, share_within(volume_of(lab, mode.volume), input.proxy));
    }
    lab.model.viscosity = 0;
    if (lab.settings.feel.empty()) return;
    lab.feel.density = field::field_of<field::Scalar>(lab.views->placed_density);
    lab.feel.material = haptics::material_field_of(lab.views->materials);
    lab.feel.materials = &lab.material_table;
    lab.feel.share = share_within(volume_of(lab, 0), tip);
    lab.model.viscosity = haptics::add_volume_feel(lab.feel, input, lab.model.primitives).viscosity;
}

/// Computes the force on the hand once (N), by a servo step without the parts that count in ticks of
/// 1 ms: the safety stage, and the account of the energy that the forces give.
vec3 pure_step(VolumeLab& lab, vec3 tip) {
    // Displacement of the tip over the last whole tick. Over one short step, most of it would be the
    // quantisation of the device.
    const vec3 way = tip - lab.tips[static_cast<std::size_t>(lab.steps_per_tick) - 1];
    fill_primitives(lab, tip, way / static_cast<double>(lab.steps_per_tick));
    auto& state = lab.servo_state;
    const haptics::Spring spring{tip, lab.model.coupling.stiffness};
    const haptics::Balance found = haptics::balance(lab.model.primitives, spring);
    const bool usable = std::isfinite(found.residual);
    if (!usable || state.primitives == 0 || state.set_number != lab.model.set_number) state.settling = {};
    const vec3 before = state.primitives == 0 ? tip : state.proxy;
    state.primitives = usable ? static_cast<std::uint32_t>(lab.model.primitives.items().size()) : 0;
    state.set_number = lab.model.set_number;
    state.proxy = tip;
    if (usable)
        state.proxy = haptics::settle(
            state.settling, {before, found.proxy, tip, spring, spring.stiffness, lab.model.field_motion});
    const double drag = std::min(lab.model.viscosity, lab.servo.max_damping);
    std::shift_right(lab.tips.begin(), lab.tips.end(), 1);
    lab.tips[0] = tip;
    return limited(lab.model.coupling.stiffness * (state.proxy - tip) - drag / tick_seconds * way,
                   lab.device.peak_force);
}

/// Runs one tick of the forces (servo) and the simulated hand. `figures` gets tip and force at the tick's
/// start.
void feel_and_move(VolumeLab& lab, vec3 target, VolumeLabFigures& figures) {
    figures.tip = haptics::measured_position(lab.device, lab.hand);
    if (lab.steps_per_tick == 1) {
        fill_primitives(lab, figures.tip,
                        haptics::tip_motion(lab.servo_state, lab.data.device.position_quantum));
        figures.force = haptics::servo_step(lab.servo, lab.servo_state, lab.model, {figures.tip, 1});
        lab.hand = haptics::step(lab.device, lab.hand, target, figures.force);
        return;
    }
    const vec3 from = lab.hand.target;
    for (int i = 0; i < lab.steps_per_tick; ++i) {
        const vec3 force = pure_step(lab, haptics::measured_position(lab.device, lab.hand));
        if (i == 0) figures.force = force;
        const double share = static_cast<double>(i + 1) / lab.steps_per_tick;
        lab.hand = haptics::step(lab.device, lab.hand, glm::mix(from, target, share), force);
    }
}

/// Applies the carving tool where the hand touches the body (the proxy), if the tool is held and its next use
/// is due.
field::Edit use_tool(VolumeLab& lab, bool held, std::size_t tool) {
    if (!lab.carvable() || tool >= lab.data.tools.size()) return {};
    const vec3 place = field::to_own(lab.placement, lab.servo_state.proxy);
    if (held && !lab.carving) lab.last_dab = place;
    if (!held && lab.carving) field::end_step(lab.history, lab.body.view());
    lab.carving = held;
    if (!held || lab.tick % ticks_of_a_dab != 0) return {};
    const field::Dab dab{
        .place = place, .motion = place - lab.last_dab, .seconds = seconds(ticks_of_a_dab), .seed = lab.tick};
    lab.last_dab = place;
    return field::edit(lab.body.view(), lab.data.tools[tool], dab, lab.history);
}

/// Starts servo (the computation of the force) and hand anew with the device in lab.data. The hand rests at
/// the top of the workspace.
void take_up_device(VolumeLab& lab) {
    const auto& spec = lab.data.device;
    lab.device = haptics::simulated_device(spec, haptics::Hand{}, tick_seconds / lab.steps_per_tick);
    lab.servo = haptics::servo_of(spec, 1.0);
    lab.servo_state = {};
    lab.model.coupling = {.stiffness = spec.max_stiffness, .damping = 0.5 * spec.max_damping};
    ++lab.model.set_number;
    rest_hand(lab, {0, 0.5 * spec.workspace.y, 0});
}

/// Data files of a folder, sorted by name.
std::vector<std::filesystem::path> files_in(const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> files;
    std::error_code ignored;
    for (const auto& entry : std::filesystem::directory_iterator(folder, ignored))
        if (entry.path().extension() == ".toml") files.push_back(entry.path());
    std::ranges::sort(files);
    return files;
}

/// Opens a data file and reads it by `read`.
template <class Read>
auto read_config(const std::filesystem::path& path, std::int64_t version, Read read)
    -> decltype(read(std::declval<const Config&>())) {
    const auto words = read_text_file(path, max_file_bytes);
    if (!words) return words.error();
    const auto config = Config::parse(*words, path.string(), version);
    if (!config) return config.error();
    return read(*config);
}

}  // namespace

Expected<haptics::DeviceSpec> load_lab_device(const std::filesystem::path& assets, const std::string& name) {
    return read_config(assets / "devices" / (name + ".toml"), device_file_version, haptics::read_device);
}

Expected<VolumeLabData> load_volume_lab_data(const std::filesystem::path& assets, const std::string& device) {
    VolumeLabData data;
    for (const auto& file : files_in(assets / "devices")) data.devices.push_back(file.stem().string());
    if (std::ranges::find(data.devices, device) == data.devices.end())
        return fail(text("there is no device '", printable(device, 60), "'; there are ", listed(data.devices),
                         did_you_mean(device, data.devices)));
    auto materials =
        read_config(assets / "materials.toml", field::materials_file_version, field::read_materials);
    if (!materials) return materials.error();
    data.materials = std::move(*materials);
    auto spec = load_lab_device(assets, device);
    if (!spec) return spec.error();
    data.device = std::move(*spec);
    for (const auto& file : files_in(assets / "carving")) {
        auto tool = field::load_tool(file, data.materials);
        if (!tool) return tool.error();
        data.tools.push_back(std::move(*tool));
    }
    if (data.tools.empty()) return fail(text((assets / "carving").string(), ": has no tools"));
    return data;
}

Expected<VolumeLab> make_volume_lab(field::Volume volume, VolumeLabData data) {
    if (*std::ranges::min_element(volume.count) < 2)
        return fail("the volume needs two samples or more along each axis");
    VolumeLab lab;
    lab.data = std::move(data);
    lab.material_table = feel_of_materials(lab.data.materials);
    lab.fitted = lab.placement = fitted(volume, lab.data.device.workspace);
    lab.range = sample_range(volume);
    lab.usual_level = field::usual_level(volume);
    lab.source = std::move(volume);
    if (lab.carvable()) {
        auto body = field::voxels_of(std::move(lab.source));  // the source keeps all but its samples
        if (!body) return body.error();
        lab.body = std::move(*body);
        lab.history = field::make_history(lab.body.view());
        lab.views->averages =
            field::make_block_averages(lab.body.density_grid(field::Kernel::linear), &lab.body.bricks);
    }
    take_up_device(lab);
    return lab;
}

void rest_hand(VolumeLab& lab, vec3 place) {
    const vec3 half = 0.5 * lab.data.device.workspace;
    lab.hand = haptics::resting_at(glm::clamp(place, -half, half));
    lab.tips.fill(haptics::measured_position(lab.device, lab.hand));
}

void change_device(VolumeLab& lab, haptics::DeviceSpec device) {
    lab.data.device = std::move(device);
    take_up_device(lab);
    std::vector<double> grown;
    const auto fit = [&](field::Placement& old, const field::Placement& current) {
        grown.push_back(current.scale / old.scale);
        old = current;
    };
    fit(lab.fitted, fitted(lab.source, lab.data.device.workspace));
    for (auto& beside : lab.beside)
        fit(beside->fitted, fitted_beside(lab, beside->source, beside->registered));
    auto settings = lab.settings;
    for (LabMode& mode : settings.modes) {
        mode.settings.reach *= grown[mode.volume];
        mode.settings.pitch *= grown[mode.volume];
    }
    // These modes and places were valid with the old device, so the change cannot fail.
    const auto changed = change_volume_lab(lab, settings);
    THAUM_ASSERT(changed.has_value(), "settings that were in use");
}

void set_servo_rate(VolumeLab& lab, int steps_per_tick) {
    THAUM_ASSERT(steps_per_tick >= 1 && steps_per_tick <= max_steps_per_tick, "a rate that the lab offers");
    lab.steps_per_tick = steps_per_tick;
    lab.device = haptics::simulated_device(lab.data.device, haptics::Hand{}, tick_seconds / steps_per_tick);
    lab.tips.fill(haptics::measured_position(lab.device, lab.hand));
}

Expected<void> add_volume_beside(VolumeLab& lab, field::Volume volume, bool registered) {
    if (lab.beside.size() == max_volumes_beside)
        return fail(text("at most ", max_volumes_beside, " volumes lie beside the first one"));
    if (*std::ranges::min_element(volume.count) < 2)
        return fail("the volume needs two samples or more along each axis");
    if (registered && !(placement_in_file(lab.source) && placement_in_file(volume)))
        return fail(
            "it can be registered only if both files have a frame (space, space directions, space origin)");
    if (registered && volume.is_of_patient != lab.source.is_of_patient)
        return fail("it cannot be registered: only one of the two files lies in the frame of a patient");
    auto beside = std::make_unique<VolumeBeside>();
    beside->range = sample_range(volume);
    beside->usual_level = field::usual_level(volume);
    beside->registered = registered;
    beside->fitted = beside->placement = fitted_beside(lab, volume, registered);
    beside->source = std::move(volume);
    if (beside->source.components == 1)
        beside->views.averages = field::make_block_averages(beside->source.grid(field::Kernel::linear));
    lab.beside.push_back(std::move(beside));
    return {};
}

double VolumeRef::finest_spacing() const {
    const vec3 s = source.spacing;
    return placement.scale * std::min({s.x, s.y, s.z});
}

VolumeRef volume_of(const VolumeLab& lab, std::size_t number) {
    if (number == 0) return {lab.source, lab.range, lab.usual_level, lab.placement};
    const auto& beside = *lab.beside.at(number - 1);
    return {beside.source, beside.range, beside.usual_level, beside.placement};
}

haptics::FieldKind kind_of(const VolumeLab& lab) { return volume_of(lab, 0).kind(); }

double value_at(const VolumeLab& lab, vec3 place) {
    const vec3 own = field::to_own(lab.placement, place);
    if (lab.carvable())
        return density_of(lab.body.density_grid(field::Kernel::linear), {}, lab.range)(own).value;
    return glm::length(lab.source.vector_grid()(own).value);
}

Expected<LabMode> lab_mode(const VolumeLab& lab, const std::string& name, std::vector<field::Filter> filters,
                           std::size_t volume) {
    const haptics::Mode* mode = haptics::find_mode(name);
    if (volume > lab.beside.size()) return fail(text("mode '", name, "': there is no volume ", volume));
    const auto read = volume_of(lab, volume);
    const auto offers = haptics::mode_offers(read.kind());
    const auto offer = std::ranges::find(offers, mode, &haptics::ModeOffer::mode);
    if (mode == nullptr || (offer == offers.end() && filters.empty())) {
        return fail(text("mode '", name, "': there are ", listed(haptics::modes(), &haptics::Mode::name)));
    }
    if (filters.empty() && offer->through) filters.push_back({.kind = *offer->through});
    LabMode chosen{name, volume, std::move(filters), {}};
    chosen.settings.strength = field::constant(usual_strength * lab.data.device.continuous_force);
    chosen.settings.friction = field::constant(0.2);
    chosen.settings.level = read.usual_level;
    chosen.settings.reach = reach_samples * read.finest_spacing();
    chosen.settings.pitch = 4 * read.finest_spacing();
    return chosen;
}

Expected<void> change_volume_lab(VolumeLab& lab, const VolumeLabSettings& settings) {
    if (!settings.feel.empty() && !lab.carvable()) return fail("a flow has no body to feel");
    auto feel =
        feel_of_parts(settings.feel, settings.opacity, reach_samples * volume_of(lab, 0).finest_spacing());
    if (!feel) return feel.error();
    std::size_t needed = settings.feel.empty() ? 0 : haptics::primitives_of(*feel);
    for (const LabMode& chosen : settings.modes) {
        if (chosen.volume > lab.beside.size())
            return fail(text("mode '", chosen.name, "': there is no volume ", chosen.volume));
        const bool flow = volume_of(lab, chosen.volume).kind() == haptics::FieldKind::vector;
        const auto vector = field::checked_filters(chosen.filters, flow);
        if (!vector) return fail(text("mode '", chosen.name, "': ", vector.error().message));
        const haptics::Mode* mode = haptics::find_mode(chosen.name);
        const auto kind = *vector ? haptics::FieldKind::vector : haptics::FieldKind::scalar;
        if (mode == nullptr || mode->reads != kind)
            return fail(text("mode '", chosen.name, "' does not read ", *vector ? "vectors" : "scalars"));
        needed += mode->primitives;
    }
    if (needed > haptics::primitive_capacity)
        return fail(
            text("this feel needs ", needed, " primitives; there is room for ", haptics::primitive_capacity));
    if (auto sound = check_places(lab, settings.places); !sound) return sound;
    const bool same = settings.modes == lab.settings.modes && settings.feel == lab.settings.feel &&
                      settings.opacity == lab.settings.opacity;
    const bool jumped = move_volumes(lab, settings.places);
    lab.settings = settings;
    lab.feel = *feel;
    lab.fields.resize(settings.modes.size());
    for (auto& f : lab.fields)
        if (!f) f = std::make_unique<LabField>();
    if (!same || jumped) ++lab.model.set_number;
    return {};
}

VolumeLabFigures step_volume_lab(VolumeLab& lab, const VolumeLabInput& input) {
    VolumeLabFigures figures;
    if (input.change) {
        if (auto set = change_volume_lab(lab, *input.change); !set) figures.refused = set.error().message;
    }
    const std::uint32_t before = lab.body.bricks.newest;
    if (input.history != 0 && lab.carvable()) {
        if (input.history < 0) field::undo(lab.history, lab.body.view());
        if (input.history > 0) field::redo(lab.history, lab.body.view());
        lab.carving = false;
    }
    figures.edit = use_tool(lab, input.carve && input.history == 0, input.tool);
    lab.edited |= figures.edit.voxels > 0;
    // If the body under the hand has changed, the haptic model gets a new number. At a new number the servo
    // fades to the new force, so that the force does not jump.
    if (lab.carvable() && lab.body.bricks.newest != before) ++lab.model.set_number;
    refresh(lab);
    lab.model.field_motion = lab.moved;
    lab.moved = 0;
    feel_and_move(lab, input.target, figures);
    figures.proxy = lab.servo_state.proxy;
    figures.value = value_at(lab, figures.proxy);
    ++lab.tick;
    return figures;
}

field::Volume volume_now(const VolumeLab& lab) {
    if (!lab.carvable()) return lab.source;
    field::Volume current = field::density_volume(lab.body);
    if (!lab.edited) current.stored_as = lab.source.stored_as;
    field::lie_as(current, lab.source);
    current.name = lab.source.name;
    current.units = lab.source.units;
    return current;
}

std::uint64_t lab_hash(const VolumeLab& lab) {
    std::uint64_t hash = hash_value(lab.tips, hash_value(lab.hand, hash_value(lab.servo_state)));
    if (!lab.carvable()) return hash;
    field::Voxels body = lab.body;
    field::BrickHashes fresh;
    return hash_value(field::voxel_hash(body.view(), fresh), hash);
}

}  // namespace thaum::game::inline lab

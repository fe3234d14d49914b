#include "game/lab/volume_lab.h"

#include <algorithm>
#include <cmath>

#include "core/config.h"
#include "core/file.h"
#include "core/hash.h"
#include "core/text.h"
#include "field/voxel_state.h"
#include "field/voxel_volume.h"

namespace thaum::game {
namespace {

/// Share of the device's workspace that the volume fills.
constexpr double filled = 0.9;
/// Strength of a mode that was just chosen, as a share of the device's continuous force.
constexpr double usual_strength = 0.8;
/// Depth at which a wall lets the hand through (samples).
constexpr double reach_samples = 2;
constexpr std::int64_t device_file_version = 1;
constexpr std::size_t most_file_bytes = std::size_t{1} << 20U;

/// What filters read, as it is now.
field::FilterSource source_of(const VolumeLab& lab) {
    field::FilterSource source{.count = lab.source.count, .spacing = lab.source.spacing};
    if (lab.carvable()) {
        source.field.scalar = field::field_of<field::Scalar>(lab.views->density);
        source.version = lab.body.bricks.newest;
    } else {
        source.field.vector = field::field_of<field::Vector>(lab.views->flow);
        source.version = 1;
    }
    return source;
}

/// Points all views at the body or the flow as it is now. Smooths only if something changed.
void refresh(VolumeLab& lab) {
    auto& views = *lab.views;
    if (lab.carvable()) {
        views.density = {lab.body.density_grid(field::Kernel::linear)};
        views.placed_density = {field::field_of<field::Scalar>(views.density), lab.placement};
        views.materials = {lab.body.count, lab.body.spacing, lab.placement, lab.body.material};
    } else {
        views.flow = lab.source.vector_grid();
    }
    for (std::size_t i = 0; i < lab.fields.size(); ++i) {
        LabField& f = *lab.fields[i];
        const LabMode& mode = lab.settings.modes[i];
        if (!field::set_filters(f.filtered, source_of(lab), mode.filters)) continue;
        const auto& read = haptics::field_for(*haptics::find_mode(mode.name), f.filtered);
        f.scalar = {read.scalar, lab.placement};
        f.vector = {read.vector, lab.placement};
        f.placed = {};
        if (read.is_vector())
            f.placed.vector = field::field_of<field::Vector>(f.vector);
        else
            f.placed.scalar = field::field_of<field::Scalar>(f.scalar);
    }
}

/// Smallest distance between samples, in the lab's frame (m).
double finest_spacing(const VolumeLab& lab) {
    const vec3 s = lab.source.spacing;
    return lab.placement.scale * std::min({s.x, s.y, s.z});
}

/// A patient stands upright and faces the user: from left, back, up (field/nrrd.h) to right, up, front.
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

void fill_primitives(VolumeLab& lab, vec3 tip) {
    lab.model.primitives.clear();
    const haptics::ModeInput input{
        .proxy = lab.servo_state.primitives == 0 ? tip : lab.servo_state.proxy,
        .tip = tip,
        .stiffness = lab.model.coupling.stiffness,
    };
    for (std::size_t i = 0; i < lab.fields.size(); ++i) {
        const LabMode& mode = lab.settings.modes[i];
        const haptics::ModeUse use{haptics::find_mode(mode.name), lab.fields[i]->placed, mode.settings};
        haptics::add_modes(std::span(&use, 1), input, lab.model.primitives);
    }
    lab.model.viscosity = 0;
    if (lab.settings.feel.empty()) return;
    lab.feel.density = field::field_of<field::Scalar>(lab.views->placed_density);
    lab.feel.material = haptics::material_field_of(lab.views->materials);
    lab.feel.materials = &lab.material_table;
    lab.model.viscosity = haptics::add_volume_feel(lab.feel, input, lab.model.primitives).viscosity;
}

/// Uses the tool at the proxy if it is held and due.
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

/// Data files of a folder, sorted by name.
std::vector<std::filesystem::path> files_in(const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> files;
    std::error_code ignored;
    for (const auto& entry : std::filesystem::directory_iterator(folder, ignored))
        if (entry.path().extension() == ".toml") files.push_back(entry.path());
    std::ranges::sort(files);
    return files;
}

/// Reads a data file with its reader.
template <class Read>
auto read_config(const std::filesystem::path& path, std::int64_t version, Read read)
    -> decltype(read(std::declval<const Config&>())) {
    const auto words = read_text_file(path, most_file_bytes);
    if (!words) return tl::unexpected(words.error());
    const auto config = Config::parse(*words, path.string(), version);
    if (!config) return tl::unexpected(config.error());
    return read(*config);
}

}  // namespace

Expected<VolumeLabData> load_volume_lab_data(const std::filesystem::path& assets, const std::string& device) {
    VolumeLabData data;
    auto materials =
        read_config(assets / "materials.toml", field::materials_file_version, field::read_materials);
    if (!materials) return tl::unexpected(materials.error());
    data.materials = std::move(*materials);
    auto spec =
        read_config(assets / "devices" / (device + ".toml"), device_file_version, haptics::read_device);
    if (!spec) return tl::unexpected(spec.error());
    data.device = std::move(*spec);
    for (const auto& file : files_in(assets / "devices")) data.devices.push_back(file.stem().string());
    for (const auto& file : files_in(assets / "carving")) {
        auto tool = field::load_tool(file, data.materials);
        if (!tool) return tl::unexpected(tool.error());
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
    lab.placement = fitted(volume, lab.data.device.workspace);
    lab.range = volume.components == 1 ? field::range_of(volume) : lengths_of(volume);
    lab.source = std::move(volume);
    if (lab.carvable()) {
        auto body = field::voxels_of(lab.source);
        if (!body) return tl::unexpected(body.error());
        lab.body = std::move(*body);
        lab.history = field::make_history(lab.body.view());
        lab.source.samples = {};
    }
    lab.device = haptics::simulated_device(lab.data.device, haptics::Hand{});
    lab.servo = haptics::servo_of(lab.data.device, 1.0);
    lab.hand = haptics::resting_at({0, 0.5 * lab.data.device.workspace.y, 0});
    lab.model.coupling = {.stiffness = lab.data.device.max_stiffness,
                          .damping = 0.5 * lab.data.device.max_damping};
    lab.model.set_number = 1;
    return lab;
}

haptics::FieldKind kind_of(const VolumeLab& lab) {
    return lab.carvable() ? haptics::FieldKind::scalar : haptics::FieldKind::vector;
}

double value_at(const VolumeLab& lab, vec3 place) {
    const vec3 own = field::to_own(lab.placement, place);
    if (lab.carvable()) return haptics::SmoothGrid{lab.body.density_grid(field::Kernel::linear)}(own).value;
    return glm::length(lab.source.vector_grid()(own).value);
}

Expected<LabMode> lab_mode(const VolumeLab& lab, const std::string& name,
                           std::vector<field::Filter> filters) {
    const haptics::Mode* mode = haptics::find_mode(name);
    const auto offers = haptics::mode_offers(kind_of(lab));
    const auto offer = std::ranges::find(offers, mode, &haptics::ModeOffer::mode);
    if (mode == nullptr || (offer == offers.end() && filters.empty())) {
        std::string names;
        for (const auto& each : haptics::modes()) names += text(names.empty() ? "" : ", ", each.name);
        return fail(text("mode '", name, "': there are ", names));
    }
    if (filters.empty() && offer->through) filters.push_back({.kind = *offer->through});
    LabMode chosen{name, std::move(filters), {}};
    chosen.settings.strength = field::constant(usual_strength * lab.data.device.continuous_force);
    chosen.settings.friction = field::constant(0.2);
    chosen.settings.level = 0.5 * (double{lab.range.low} + double{lab.range.high});
    chosen.settings.reach = reach_samples * finest_spacing(lab);
    chosen.settings.pitch = 4 * finest_spacing(lab);
    return chosen;
}

Expected<void> change_volume_lab(VolumeLab& lab, const VolumeLabSettings& settings) {
    if (!settings.feel.empty() && !lab.carvable()) return fail("a flow has no body to feel");
    auto feel = feel_of_parts(settings.feel, settings.opacity, reach_samples * finest_spacing(lab));
    if (!feel) return tl::unexpected(feel.error());
    std::size_t needed = settings.feel.empty() ? 0 : haptics::primitives_of(*feel);
    for (const LabMode& chosen : settings.modes) {
        const auto vector = field::checked_filters(chosen.filters, !lab.carvable());
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
    lab.settings = settings;
    lab.feel = *feel;
    lab.fields.resize(settings.modes.size());
    for (auto& f : lab.fields)
        if (!f) f = std::make_unique<LabField>();
    ++lab.model.set_number;
    return {};
}

VolumeLabFigures step_volume_lab(VolumeLab& lab, const VolumeLabInput& input) {
    VolumeLabFigures figures;
    if (input.change) {
        if (auto set = change_volume_lab(lab, *input.change); !set) figures.refused = set.error().message;
    }
    if (input.history != 0 && lab.carvable()) {
        if (input.history < 0) field::undo(lab.history, lab.body.view());
        if (input.history > 0) field::redo(lab.history, lab.body.view());
        lab.carving = false;
    }
    figures.edit = use_tool(lab, input.carve && input.history == 0, input.tool);
    lab.edited |= figures.edit.voxels > 0;
    refresh(lab);
    figures.tip = haptics::measured_position(lab.device, lab.hand);
    fill_primitives(lab, figures.tip);
    figures.force = haptics::servo_step(lab.servo, lab.servo_state, lab.model, {figures.tip, 1});
    figures.proxy = lab.servo_state.proxy;
    figures.value = value_at(lab, figures.proxy);
    lab.hand = haptics::step(lab.device, lab.hand, input.target, figures.force);
    ++lab.tick;
    return figures;
}

field::Volume volume_now(const VolumeLab& lab) {
    if (!lab.carvable()) return lab.source;
    field::Volume now = field::density_volume(lab.body);
    if (!lab.edited) now.stored_as = lab.source.stored_as;
    now.placement = lab.source.placement;
    now.name = lab.source.name;
    now.units = lab.source.units;
    return now;
}

std::uint64_t lab_hash(const VolumeLab& lab) {
    std::uint64_t hash = hash_value(lab.hand, hash_value(lab.servo_state));
    if (!lab.carvable()) return hash;
    field::Voxels body = lab.body;
    field::BrickHashes fresh;
    return hash_value(field::voxel_hash(body.view(), fresh), hash);
}

}  // namespace thaum::game

#include "game/lab/window/volume_lab_picture.h"

#include <algorithm>
#include <cmath>

#include "core/text.h"
#include "render/colour.h"

namespace thaum::game::inline lab {
namespace {

// radii of the balls that show the device's tip and its proxy, the point that modes and walls hold or lead
// (m)
constexpr float tip_radius = 0.0012F, proxy_radius = 0.0022F;
constexpr float newton_m = 0.012F;       // length of the force arrow per newton (m/N)
constexpr float view_angle = 0.7F;       // vertical field of view (rad)
constexpr double filled_height = 0.7;    // share of the picture's height that a volume fills initially
constexpr float edge_radius = 0.00015F;  // radius of the lines that show the edges of the workspace (m)
// Number of layers along the diagonal of a volume, each of which has the opacity that the transfer function
// gives.
constexpr float layers = 60;

double diagonal(const VolumeLab& lab) { return lab.placement.scale * glm::length(lab.source.extent()); }

fmat4 at(vec3 place, double scale = 1) {
    fmat4 model(static_cast<float>(scale));
    model[3] = fvec4(fvec3(place), 1);
    return model;
}

fmat4 model_of(const field::Placement& placement) {
    fmat4 model(glm::mat3(placement.scale * placement.turn));
    model[3] = fvec4(fvec3(placement.origin), 1);
    return model;
}

/// Transform of a rod of length 1 m that shows the force on the hand as an arrow. `from`: start of the arrow.
fmat4 arrow(vec3 from, vec3 force) {
    const auto length = static_cast<float>(glm::length(force)) * newton_m;
    const fvec3 along = length > 0 ? fvec3(glm::normalize(force)) : fvec3(0, 1, 0);
    const fvec3 aside = glm::normalize(std::abs(along.y) < 0.9F ? glm::cross(along, fvec3(0, 1, 0))
                                                                : glm::cross(along, fvec3(1, 0, 0)));
    fmat4 model(1);
    model[0] = fvec4(aside, 0);
    model[1] = fvec4(along * length, 0);
    model[2] = fvec4(glm::cross(aside, along), 0);
    model[3] = fvec4(fvec3(from) + 0.5F * length * along, 1);
    return model;
}

/// Whether the hand's target is outside of the device's workspace.
bool at_the_edge(const VolumeLab& lab) {
    const vec3 free = 0.5 * lab.data.device.workspace - glm::abs(lab.hand.target);
    return std::min({free.x, free.y, free.z}) < 1e-6;
}

/// The twelve edges of the device's workspace, as instances of a rod of length 1 m along y.
void add_edges(vec3 workspace, render::MeshId rod, std::vector<render::Instance>& instances) {
    const fvec3 half(0.5 * workspace);
    for (int along = 0; along < 3; ++along) {
        const int a = (along + 1) % 3, b = (along + 2) % 3;
        for (const auto& [left, low] : {std::pair{-1, -1}, {-1, 1}, {1, -1}, {1, 1}}) {
            fmat4 model(0);
            model[0][a] = 1;
            model[1][along] = 2 * half[along];
            model[2][b] = 1;
            model[3][a] = static_cast<float>(left) * half[a];
            model[3][b] = static_cast<float>(low) * half[b];
            model[3][3] = 1;
            instances.push_back({.mesh = rod, .model = model, .glow = 0.5F});
        }
    }
}

/// Colours of the haze that shows a volume, from cool for the smallest value (`share` 0) to warm for the
/// largest one (1).
fvec3 ramp(float share) {
    const fvec3 low = render::colour(0x3E6FB0), middle = render::colour(0xE0A878),
                high = render::colour(0xFFF4E2);
    return share < 0.5F ? glm::mix(low, middle, 2 * share) : glm::mix(middle, high, 2 * share - 1);
}

/// Colours by speed of the stream ribbons of a flow: blue, green, red, to differ from the colours of the
/// haze.
fvec3 speed_ramp(float share) {
    const fvec3 slow = render::colour(0x2060FF), middle = render::colour(0x40E060),
                fast = render::colour(0xFF3B2E);
    return share < 0.5F ? glm::mix(slow, middle, 2 * share) : glm::mix(middle, fast, 2 * share - 1);
}

/// Light of a plain room: from above and from the user's left, on a dark background.
render::Environment lab_light() {
    render::Environment light;
    light.sun.direction = glm::normalize(fvec3(-0.5F, 0.8F, 0.6F));
    light.sun.colour = fvec3(1.3F);
    light.ambient = {.above = fvec3(0.35F, 0.37F, 0.42F), .below = fvec3(0.16F, 0.15F, 0.15F)};
    light.sky = {
        .zenith = fvec3(0.02F, 0.025F, 0.035F), .horizon = fvec3(0.05F, 0.055F, 0.07F), .sun_glow = fvec3(0)};
    light.fog = {.colour = fvec3(0.05F, 0.055F, 0.07F), .density = 0};
    return light;
}

void fill_table(const field::SampleRange& range, const VolumeView& view, render::ScanTable& table) {
    const double low = range.low, high = range.high;
    for (std::size_t i = 0; i < table.size(); ++i) {
        const double share = static_cast<double>(i) / 255.0;
        table[i].colour = ramp(static_cast<float>(share));
        table[i].opacity = static_cast<float>(std::clamp(view.opacity(low + share * (high - low)), 0.0, 1.0));
    }
}

VolumeView view_of(const VolumeRef& volume) {
    VolumeView view;
    const double low = volume.range.low, high = volume.range.high;
    view.level = volume.usual_level;
    view.opacity = field::window(low + 0.3 * (high - low), high, 0, 0.3);
    if (volume.kind() == haptics::FieldKind::scalar) return view;
    // A thin haze, through which the ribbons are seen.
    view.look = render::ScanLook::translucent;
    view.opacity = field::window(low + 0.3 * (high - low), high, 0, 0.06);
    return view;
}

/// Points that a picture should show (m, lab frame): those of the body within its surface, or the corners of
/// a flow's box.
std::vector<vec3> shown_places(const VolumeLab& lab, double level) {
    std::vector<vec3> places;
    const auto n = lab.carvable() ? lab.body.count : lab.source.count;
    const auto samples =
        static_cast<std::size_t>(n[0]) * static_cast<std::size_t>(n[1]) * static_cast<std::size_t>(n[2]);
    const auto wide = static_cast<std::size_t>(n[0]), high = static_cast<std::size_t>(n[1]);
    const int step = 1 + static_cast<int>(std::cbrt(static_cast<double>(samples)) / 48);
    for (int k = 0; lab.carvable() && k < n[2]; k += step)
        for (int j = 0; j < n[1]; j += step)
            for (int i = 0; i < n[0]; i += step) {
                const auto row = static_cast<std::size_t>(j) + high * static_cast<std::size_t>(k);
                if (double{lab.body.density[static_cast<std::size_t>(i) + wide * row]} >= level)
                    places.push_back(field::to_parent(lab.placement, lab.source.place(i, j, k)));
            }
    for (int corner = 0; corner < 8 && places.size() < 8; ++corner) {
        const std::array at{(corner & 1) != 0, (corner & 2) != 0, (corner & 4) != 0};
        places.push_back(field::to_parent(
            lab.placement,
            lab.source.place(at[0] ? n[0] - 1 : 0, at[1] ? n[1] - 1 : 0, at[2] ? n[2] - 1 : 0)));
    }
    return places;
}

std::vector<float> lengths_of(const field::VolumeSamples& vectors) {
    std::vector<float> lengths;
    lengths.reserve(vectors.size() / 3);
    for (std::size_t i = 0; i + 2 < vectors.size(); i += 3)
        lengths.push_back(glm::length(fvec3(vectors[i], vectors[i + 1], vectors[i + 2])));
    return lengths;
}

/// The samples as a scan shows them.
render::ScanSamples shown_samples(const field::VolumeSamples& samples) {
    return samples.visit([](const auto& all) { return render::ScanSamples(std::span(all)); });
}

/// Updates the scan of the first volume to the present body.
void show_body(const VolumeLab& lab, std::span<const render::ScanMaterial> materials, render::Scan& scan) {
    scan.version = lab.body.bricks.newest;
    scan.samples = std::span<const float>(lab.body.density);
    scan.brick_versions = lab.body.bricks.version;
    scan.colours = lab.body.colour;
    scan.materials = lab.body.material;
    scan.material_table = materials;
}

/// Adds text at the lower right: force, value, time, the reason why the hand stops, and the meaning of the
/// ribbons' colours.
void show_words(const VolumeLab& lab, const VolumeLabFigures& figures, bool blocked, render::Frame& frame) {
    auto& items = frame.overlay.items;
    const auto x = static_cast<float>(frame.width) - 16, y = static_cast<float>(frame.height) - 40;
    items.clear();
    items.push_back(render::TextItem{
        text(blocked ? "edge of the arm's workspace    " : "", "force ", fixed(glm::length(figures.force), 2),
             " N    value ", fixed(figures.value, 2), "    ", fixed(lab.seconds(), 2), " s"),
        {x, y},
        20,
        fvec4(1),
        render::Align::right});
    if (kind_of(lab) == haptics::FieldKind::scalar) return;
    items.push_back(render::TextItem{text("ribbons: blue 0, green ", fixed(0.5 * double{lab.range.high}, 2),
                                          ", red ", fixed(lab.range.high, 2)),
                                     {x, y - 30},
                                     16,
                                     fvec4(1),
                                     render::Align::right});
}

}  // namespace

void come_near(const VolumeLab& lab, VolumeView& view) {
    const auto places = shown_places(lab, view.level);
    vec3 low = places[0], high = places[0];
    for (const vec3 place : places) low = glm::min(low, place), high = glm::max(high, place);
    view.eye.aim = 0.5 * (low + high);
    const quat back = glm::conjugate(look_rotation(view.eye.yaw, -view.eye.pitch));
    const double tall = filled_height * std::tan(0.5 * double{view_angle});
    double away = 0;
    for (const vec3 place : places) {
        const vec3 seen = back * (place - view.eye.aim);
        away = std::max(away, std::max(std::abs(seen.y), std::abs(seen.x)) / tall + seen.z);
    }
    view.eye.away = std::clamp(away / diagonal(lab), 0.4, 8.0);
}

VolumeView usual_view(const VolumeLab& lab) {
    auto view = view_of(volume_of(lab, 0));
    come_near(lab, view);
    return view;
}

render::Camera camera_of(const VolumeEye& eye, const VolumeLab& lab) {
    const quat turn = look_rotation(eye.yaw, -eye.pitch);
    const double away = eye.away * diagonal(lab);
    render::Camera camera;
    camera.position = fvec3(eye.aim + turn * vec3(0, 0, away));
    camera.orientation = fquat(turn);
    camera.fov_y = view_angle;
    camera.near_plane = static_cast<float>(0.02 * away);
    camera.far_plane = static_cast<float>(20 * away);
    return camera;
}

VolumePicture::VolumePicture(render::Renderer& renderer, const VolumeLab& lab) : renderer_(&renderer) {
    for (std::size_t i = 0; i <= lab.beside.size(); ++i) {
        const auto volume = volume_of(lab, i);
        drawn_.push_back(std::make_unique<Drawn>());
        drawn_.back()->scan = renderer.make_scan();
        if (volume.kind() == haptics::FieldKind::vector)
            drawn_.back()->lengths = lengths_of(volume.source.samples);
    }
    tip_ = renderer.upload(render::sphere(tip_radius, 16, render::colour(0x9FB8D8)));
    proxy_ = renderer.upload(render::sphere(proxy_radius, 20, render::colour(0xFFB040)));
    edge_ = renderer.upload(render::cylinder(edge_radius, 1, 6, render::colour(0x8FA6C8)));
    rod_ = renderer.upload(render::cylinder(0.0006F, 1, 12, render::colour(0xFF5A3C)));
    for (std::size_t i = 0; i < colours_.size(); ++i)
        colours_[i] = speed_ramp(static_cast<float>(i) / 255.0F);
    for (const auto& material : lab.data.materials)
        materials_.push_back({.colour = fvec3(1), .opacity = static_cast<float>(material.opacity)});
    frame_.bloom = false;
    frame_.quality = render::first_quality(renderer.device());
}

void VolumePicture::add_ribbons(const VolumeRef& volume, Drawn& drawn, vec3 proxy, int count) {
    const vec3 half = 0.5 * volume.source.extent();
    seeds_.clear();
    seeds_.push_back(field::to_own(volume.placement, proxy));
    for (int i = 1; i <= count; ++i) {
        // Positions that fill a box evenly: multiples of a generalised golden ratio (Roberts 2018).
        const vec3 share =
            glm::fract(static_cast<double>(i) * vec3(0.8191725134, 0.6710436067, 0.5497004779));
        seeds_.push_back(half * (2.0 * share - 1.0));
    }
    const double size = glm::length(volume.source.extent());
    const auto flow = volume.source.vector_grid();
    const field::StreamlineSettings settings{.length = 0.25 * size,
                                             .tolerance = 1e-5 * size,
                                             .longest_step = 0.01 * size,
                                             .low = -half,
                                             .high = half};
    const render::RibbonLook look{.width = static_cast<float>(0.009 * size),
                                  .colours = &colours_,
                                  .slowest = 0,
                                  .fastest = std::max(double{volume.range.high}, 1e-9),
                                  .glow = 0.35F};
    drawn.ribbons.update(*renderer_, field::field_of<field::Vector>(flow), seeds_, settings, look, 1);
    const auto instances = drawn.ribbons.instances(model_of(volume.placement));
    instances_.insert(instances_.end(), instances.begin(), instances.end());
}

void VolumePicture::add_scan(const VolumeRef& volume, Drawn& drawn, const VolumeView& view) {
    fill_table(volume.range, view, drawn.table);
    const auto& range = volume.range;
    render::Scan scan;
    scan.id = drawn.scan;
    scan.count = volume.source.count;
    scan.low = range.low;
    scan.high = std::max(range.high, std::nextafter(range.low, range.high + 1));
    scan.spacing = fvec3(volume.source.spacing);
    scan.model = model_of(volume.placement);
    scan.look = view.look;
    scan.table = &drawn.table;
    scan.unit = static_cast<float>(glm::length(volume.source.extent())) / layers;
    scan.lit = volume.kind() == haptics::FieldKind::scalar;
    scan.colour = render::colour(0xE8DCC8);
    scan.level = static_cast<float>((view.level - double{scan.low}) / (double{scan.high} - double{scan.low}));
    scan.version = 1;
    scan.samples = shown_samples(volume.source.samples);
    if (!drawn.lengths.empty()) scan.samples = std::span<const float>(drawn.lengths);
    scans_.push_back(scan);
}

const render::Frame& VolumePicture::frame(const VolumeLab& lab, const VolumeLabFigures& figures,
                                          const VolumeView& view, render::Size size) {
    scans_.clear();
    instances_.clear();
    for (std::size_t i = 0; i < drawn_.size(); ++i) {
        const auto volume = volume_of(lab, i);
        add_scan(volume, *drawn_[i], i == 0 ? view : view_of(volume));
        if (i == 0 && lab.carvable()) show_body(lab, materials_, scans_.back());
        if (volume.kind() == haptics::FieldKind::vector)
            add_ribbons(volume, *drawn_[i], figures.proxy, view.ribbons);
    }
    const bool blocked = at_the_edge(lab);
    if (blocked) add_edges(lab.data.device.workspace, edge_, instances_);
    instances_.push_back({.mesh = tip_, .model = at(figures.tip)});
    instances_.push_back({.mesh = proxy_, .model = at(figures.proxy), .glow = 0.3F});
    if (glm::length(figures.force) > 0.01)
        instances_.push_back({.mesh = rod_, .model = arrow(figures.proxy, figures.force), .glow = 0.4F});
    frame_.width = size.width;
    frame_.height = size.height;
    frame_.internal_scale = render::internal_scale_of(frame_.quality, size.height);
    frame_.views = {{.camera = camera_of(view.eye, lab),
                     .viewport = {0, 0, size.width, size.height},
                     .instances = instances_,
                     .lights = {},
                     .environment = lab_light()}};
    frame_.views[0].scan_detail = view.still    ? render::ScanDetail::sharp
                                  : view.moving ? render::ScanDetail::quick
                                                : render::ScanDetail::automatic;
    frame_.views[0].scans = scans_;
    show_words(lab, figures, blocked, frame_);
    return frame_;
}

}  // namespace thaum::game::inline lab

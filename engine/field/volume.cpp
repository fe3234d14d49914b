#include "field/volume.h"

#include <algorithm>
#include <cmath>

#include "core/assert.h"
#include "core/random.h"
#include "core/text.h"
#include "field/analytic.h"

namespace thaum::field {
namespace {

/// Calls use(volume.place(i, j, k)) for each sample in the order of the samples.
template <class Use>
void for_each_place(const Volume& volume, Use use) {
    for (int k = 0; k < volume.count[2]; ++k) {
        for (int j = 0; j < volume.count[1]; ++j) {
            for (int i = 0; i < volume.count[0]; ++i) use(volume.place(i, j, k));
        }
    }
}

Volume empty_volume(std::array<int, 3> count, vec3 spacing, int components) {
    THAUM_ASSERT(*std::ranges::min_element(count) > 0, "a volume without samples");
    Volume volume{.count = count, .spacing = spacing, .components = components};
    std::size_t size = static_cast<std::size_t>(components);
    for (const int n : count) size *= static_cast<std::size_t>(n);
    THAUM_ASSERT(size <= max_samples, "a volume with too many samples");
    volume.samples.floats().reserve(size);
    return volume;
}

/// Share, 0 to 1, of the box of `size` (m) around `place` in which the field `depth` is above 0.
float share_inside(const ScalarField& depth, vec3 place, vec3 size) {
    const double here = depth(place).value, reach = 0.5 * glm::length(size);
    if (here > reach) return 1;
    if (here < -reach) return 0;
    constexpr int across = 4;
    int inside = 0;
    for (int n = 0; n < across * across * across; ++n) {
        const vec3 at(n % across, n / across % across, n / (across * across));
        if (depth(place + size * ((at + vec3(0.5)) / static_cast<double>(across) - vec3(0.5))).value > 0)
            ++inside;
    }
    return static_cast<float>(inside) / (across * across * across);
}

struct Maker {
    std::string_view name;
    std::string_view units;
    int components;
    Volume (*make)(std::array<int, 3> count, vec3 spacing, std::uint64_t seed);
};

Volume make_sphere(std::array<int, 3> count, vec3 spacing, std::uint64_t) {
    const Sphere sphere{.radius = 0.4 * made_extent};
    return scanned(field_of<Scalar>(sphere), count, spacing);
}

Volume make_gyroid(std::array<int, 3> count, vec3 spacing, std::uint64_t seed) {
    Random random = random_stream(seed, 0x6779726f);
    Gyroid gyroid{.period = made_extent / 2};
    for (int axis = 0; axis < 3; ++axis) gyroid.phase[axis] = random.uniform(0, gyroid.period);
    return sampled(field_of<Scalar>(gyroid), count, spacing);
}

Volume make_vortices(std::array<int, 3> count, vec3 spacing, std::uint64_t seed) {
    const VortexFlow flow = make_vortex_flow(made_extent, seed);
    return sampled(field_of<Vector>(flow), count, spacing);
}

Volume make_beltrami(std::array<int, 3> count, vec3 spacing, std::uint64_t) {
    const BeltramiFlow flow{.strength = {1, std::sqrt(2.0 / 3), std::sqrt(1.0 / 3)},
                            .wave = 2 * pi / made_extent};
    return sampled(field_of<Vector>(flow), count, spacing);
}

constexpr std::array makers{Maker{"sphere", "", 1, make_sphere}, Maker{"gyroid", "", 1, make_gyroid},
                            Maker{"vortices", "m/s", 3, make_vortices},
                            Maker{"beltrami", "m/s", 3, make_beltrami}};

constexpr auto names = [] {
    std::array<std::string_view, makers.size()> result{};
    for (std::size_t i = 0; i < makers.size(); ++i) result[i] = makers[i].name;
    return result;
}();

}  // namespace

Grid Volume::grid(Kernel kernel, int component) const {
    if (samples.empty() || component < 0 || component >= components) return {};
    const std::ptrdiff_t step = components, row = step * count[0], plane = row * count[1];
    return {.first = samples.from(static_cast<std::size_t>(component)),
            .count = count,
            .stride = {step, row, plane},
            .origin = -0.5 * extent(),
            .spacing = spacing,
            .kernel = kernel};
}

StaggeredGrid Volume::vector_grid(Kernel kernel) const {
    if (components != 3) return {};
    return {{grid(kernel, 0), grid(kernel, 1), grid(kernel, 2)}};
}

void lie_as(Volume& volume, const Volume& other) {
    volume.placement = other.placement;
    volume.is_of_patient = other.is_of_patient;
    volume.has_place = other.has_place;
    volume.file_axes = other.file_axes;
}

SampleRange range_of(const Volume& volume) {
    SampleRange range;
    bool any = false;
    volume.samples.visit([&](const auto& samples) {
        for (const auto stored : samples) {
            const auto sample = static_cast<float>(stored);
            if (!std::isfinite(sample)) continue;
            range.low = any ? std::min(range.low, sample) : sample;
            range.high = any ? std::max(range.high, sample) : sample;
            any = true;
        }
    });
    return range;
}

std::size_t not_finite(const Volume& volume) {
    const auto* floats = std::get_if<std::vector<float>>(&volume.samples.values);
    if (floats == nullptr) return 0;
    return static_cast<std::size_t>(
        std::ranges::count_if(*floats, [](float sample) { return !std::isfinite(sample); }));
}

Volume sampled(const ScalarField& field, std::array<int, 3> count, vec3 spacing) {
    Volume volume = empty_volume(count, spacing, 1);
    auto& samples = volume.samples.floats();
    for_each_place(volume, [&](vec3 at) { samples.push_back(static_cast<float>(field(at).value)); });
    return volume;
}

Volume sampled(const VectorField& field, std::array<int, 3> count, vec3 spacing) {
    Volume volume = empty_volume(count, spacing, 3);
    auto& samples = volume.samples.floats();
    for_each_place(volume, [&](vec3 at) {
        const vec3 value = field(at).value;
        for (int c = 0; c < 3; ++c) samples.push_back(static_cast<float>(value[c]));
    });
    return volume;
}

Volume scanned(const ScalarField& depth, std::array<int, 3> count, vec3 spacing) {
    Volume volume = empty_volume(count, spacing, 1);
    volume.stored_as = SampleType::uint8;
    auto& samples = volume.samples.floats();
    for_each_place(volume,
                   [&](vec3 at) { samples.push_back(std::round(255 * share_inside(depth, at, spacing))); });
    return volume;
}

std::span<const std::string_view> volume_names() { return names; }

Expected<Volume> make_volume(std::string_view name, int count, std::uint64_t seed) {
    const auto maker = std::ranges::find(makers, name, &Maker::name);
    if (maker == makers.end()) {
        std::string known;
        for (const std::string_view one : names) known += text(known.empty() ? "" : ", ", one);
        return fail(text("no volume is called '", name, "'; there are: ", known));
    }
    if (count < 2 || count > 512)
        return fail(text("a volume of ", count, " samples along each axis; take 2 to 512"));
    const std::size_t n = static_cast<std::size_t>(count);
    if (n * n * n * static_cast<std::size_t>(maker->components) > max_samples)
        return fail(text("'", name, "' with ", count, " samples along each axis is too large; take fewer"));
    Volume volume = maker->make({count, count, count}, vec3(made_extent / (count - 1)), seed);
    volume.name = name;
    volume.units = maker->units;
    return volume;
}

}  // namespace thaum::field

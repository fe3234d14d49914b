// tests/unit/scan_rig.h: pictures of scans in a world whose only light is what each test adds.
#pragma once
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "render/context.h"
#include "render/detail/shaders.h"
#include "render/renderer.h"
#include "unit/renderer_rig.h"

namespace thaum::render {

inline constexpr int picture_side = 120;  // width and height of a picture (px)
inline constexpr float colour_tolerance = 2.0F / 255;

/// Samples of a cube, `n` along each edge; 65,535 stands for a density of 1. `density` maps a position
/// (relative to the middle, in sample distances) to a density from 0 to 1.
template <class Density>
std::vector<std::uint16_t> sampled(int n, Density density) {
    std::vector<std::uint16_t> out;
    const float middle = 0.5F * static_cast<float>(n - 1);
    for (int z = 0; z < n; ++z) {
        for (int y = 0; y < n; ++y) {
            for (int x = 0; x < n; ++x) {
                const fvec3 at(static_cast<float>(x), static_cast<float>(y), static_cast<float>(z));
                out.push_back(static_cast<std::uint16_t>(
                    std::lround(65535 * glm::clamp(density(at - middle), 0.0F, 1.0F))));
            }
        }
    }
    return out;
}

/// Samples of a ball. The density is 0.5 at `radius` sample distances from the middle, and falls from 1 to 0
/// within 8 sample distances.
inline std::vector<std::uint16_t> ball_samples(int n, float radius) {
    return sampled(n, [&](fvec3 at) { return 0.5F + (radius - glm::length(at)) / 8; });
}

inline fvec3 pixel_of(const Image& image, int x, int y) {
    const auto i = 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                        static_cast<std::size_t>(x));
    return fvec3(image.rgb[i], image.rgb[i + 1], image.rgb[i + 2]) / 255.0F;
}

/// Greatest difference between two pictures in any channel (0 to 255).
inline int max_difference(const Image& a, const Image& b) {
    int most = a.rgb.size() == b.rgb.size() ? 0 : 256;
    for (std::size_t i = 0; i < a.rgb.size() && i < b.rgb.size(); ++i)
        most = std::max(most, std::abs(int{a.rgb[i]} - int{b.rgb[i]}));
    return most;
}

class ScanTest : public RendererTest<picture_side> {
protected:
    void SetUp() override {
        RendererTest::SetUp();
        if (IsSkipped() || HasFatalFailure()) return;
        camera = {.position = {0, 0, 3}, .fov_y = 0.8F};
        environment.sun.colour = fvec3(0);
        environment.ambient = {fvec3(1), fvec3(1)};
        environment.fog = {fvec3(0), 0};
        environment.sky = {fvec3(0), fvec3(0), fvec3(0)};
    }

    /// A scan of a cube of 2 m about the origin.
    static Scan scan_of(std::span<const std::uint16_t> samples, int n) {
        return {.id = renderer->make_scan(),
                .version = 1,
                .count = {n, n, n},
                .samples = samples,
                .high = 65535,
                .spacing = fvec3(2.0F / static_cast<float>(n - 1))};
    }
    static Scan surface_of(std::span<const std::uint16_t> samples, int n) {
        auto scan = scan_of(samples, n);
        scan.look = ScanLook::surface;
        return scan;
    }

    /// A table in which every density hides the same share of the light for each metre.
    static ScanTable uniform_table(fvec3 colour, float absorption) {
        ScanTable table;
        table.fill({colour, 1 - std::exp(-absorption * 0.01F)});
        return table;
    }

    Frame frame_of(std::span<const Scan> scans) const {
        ViewScene view;
        view.camera = camera;
        view.viewport = {0, 0, picture_side, picture_side};
        view.instances = instances;
        view.environment = environment;
        view.scans = scans;
        view.scan_detail = detail;
        view.blocks = blocks;
        return {.width = picture_side,
                .height = picture_side,
                .views = {view},
                .quality = quality,
                .bloom = false};
    }
    Image drawn(std::span<const Scan> scans) const {
        renderer->draw(frame_of(scans));
        return renderer->read_pixels();
    }
    Image drawn(const Scan& scan) const { return drawn({&scan, 1}); }
    Image drawn() const { return drawn(std::span<const Scan>()); }

    void stand(fvec3 at, fvec3 scale, fvec3 tint) {
        instances.push_back({.mesh = cube, .model = translated(at) * scaled(scale), .tint = tint});
    }
    /// Ray through the middle of a pixel, up to 1 m ahead.
    fvec3 ray_of(int x, int y) const {
        const float high = std::tan(camera.fov_y / 2) / (0.5F * picture_side);
        return camera.orientation * fvec3(high * (static_cast<float>(x) + 0.5F - 0.5F * picture_side),
                                          high * (0.5F * picture_side - static_cast<float>(y) - 0.5F), -1);
    }

    std::vector<Instance> instances;
    std::vector<Block> blocks;
    Camera camera;
    Environment environment;
    ScanDetail detail = ScanDetail::sharp;
    Quality quality = Quality::low;
};

}  // namespace thaum::render

// Compares drawn scans with closed forms: a sphere's silhouette, depth and normals, and the emission and
// absorption along rays of known length.
#include <epoxy/gl.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "unit/scan_rig.h"

namespace thaum::render {
namespace {

/// Distance ahead of the eye at which a ray meets a sphere, or a missing value.
std::optional<float> meets(fvec3 eye, fvec3 ray, fvec3 centre, float radius) {
    const fvec3 from = eye - centre;
    const float a = glm::dot(ray, ray), b = glm::dot(from, ray), c = glm::dot(from, from) - radius * radius;
    const float d = b * b - a * c;
    if (d < 0) return std::nullopt;
    return (-b - std::sqrt(d)) / a;
}

class ScanSurface : public ScanTest {
protected:
    static constexpr int n = 49;
    static constexpr float radius_samples = 18;
    /// Radius of the sphere (m). Its samples are 2 m / (n - 1) apart.
    static constexpr float radius = radius_samples * 2 / (n - 1);
    const std::vector<std::uint16_t> samples = ball_samples(n, radius_samples);

    /// Index of a pixel in `distances`, whose rows count from the bottom.
    static std::size_t number_of(int x, int y) {
        const auto row = static_cast<std::size_t>(picture_side - 1 - y);
        return row * picture_side + static_cast<std::size_t>(x);
    }
    /// Distances ahead of the eye, from the depth buffer of the last picture.
    std::vector<float> distances() const {
        auto depth = renderer->read_depths();
        const float near = 1 / camera.near_plane, far = 1 / camera.far_plane;
        for (auto& d : depth) d = 1 / (near - (near - far) * d);
        return depth;
    }
};

TEST_F(ScanSurface, HasTheSilhouetteAndDepthOfTheSphere) {
    const fvec3 centre(0.2F, -0.1F, -0.3F);
    auto scan = surface_of(samples, n);
    scan.model = translated(centre) * rotated(glm::normalize(fvec3(1, 2, 3)), 0.7F);
    camera.orientation = glm::angleAxis(0.1F, fvec3(0, 1, 0));
    const auto image = drawn(scan);
    const auto depth = distances();
    // Size of a pixel at the sphere's distance. The silhouette must be exact to half a pixel.
    const float pixel =
        2 * std::tan(camera.fov_y / 2) / picture_side * glm::distance(camera.position, centre);
    int hits = 0;
    for (int y = 0; y < picture_side; ++y) {
        for (int x = 0; x < picture_side; ++x) {
            const bool drawn_there = pixel_of(image, x, y).r > 0.1F;
            const auto ray = ray_of(x, y);
            if (meets(camera.position, ray, centre, radius - 0.5F * pixel)) {
                EXPECT_TRUE(drawn_there) << x << ", " << y;
            }
            if (!meets(camera.position, ray, centre, radius + 0.5F * pixel)) {
                EXPECT_FALSE(drawn_there) << x << ", " << y;
            }
            const auto hit = meets(camera.position, ray, centre, radius);
            if (!hit || !meets(camera.position, ray, centre, 0.95F * radius)) continue;
            ++hits;
            // Between samples the surface is drawn as a chord of the sphere, which lies up to 1 / (8 radius)
            // samples inside the sphere.
            const float there = depth[number_of(x, y)];
            EXPECT_NEAR(there, *hit, 0.05F * 2 / (n - 1)) << x << ", " << y;
        }
    }
    EXPECT_GT(hits, 1000);
}

TEST_F(ScanSurface, MeetsAPlaneWithinTheRoundingOfItsSamples) {
    // The density is linear, so trilinear interpolation within the cells is exact.
    const auto plane = sampled(n, [](fvec3 at) { return 0.5F + (0.3F * at.x + 0.2F * at.y - at.z) / 100; });
    const auto scan = surface_of(plane, n);
    (void)drawn(scan);
    const auto depth = distances();
    const float spacing = 2.0F / (n - 1);
    int hits = 0;
    for (int y = 0; y < picture_side; y += 3) {
        for (int x = 0; x < picture_side; x += 3) {
            const auto ray = ray_of(x, y);
            const fvec3 normal(0.3F, 0.2F, -1);
            const float expected = -glm::dot(camera.position, normal) / glm::dot(ray, normal);
            const fvec3 place = camera.position + expected * ray;
            if (glm::any(glm::greaterThan(glm::abs(place), fvec3(0.99F)))) continue;
            ++hits;
            // Tolerance for 16-bit samples and a 24-bit depth buffer.
            EXPECT_NEAR(depth[number_of(x, y)], expected, 4e-3F * spacing);
        }
    }
    EXPECT_GT(hits, 300);
}

TEST_F(ScanSurface, IsLitByItsNormal) {
    environment.ambient = {fvec3(0), fvec3(0)};
    environment.sun.colour = fvec3(1);
    environment.sun.direction = glm::normalize(fvec3(1, 1, 2));
    auto scan = surface_of(samples, n);
    // The scale differs between axes, so normals must be transformed by the inverse transpose, not like
    // directions.
    const fvec3 scale(1, 1.4F, 0.8F);
    scan.model = scaled(scale);
    const auto image = drawn(scan);
    int lit = 0;
    for (int y = 0; y < picture_side; y += 2) {
        for (int x = 0; x < picture_side; x += 2) {
            const auto ray = ray_of(x, y);
            const auto hit = meets(camera.position / scale, ray / scale, fvec3(0), radius);
            if (!hit || !meets(camera.position / scale, ray / scale, fvec3(0), 0.9F * radius)) continue;
            const fvec3 normal = glm::normalize((camera.position + *hit * ray) / (scale * scale));
            const float light = std::max(glm::dot(normal, environment.sun.direction), 0.0F);
            EXPECT_NEAR(pixel_of(image, x, y).r, detail::tone_mapped(fvec3(light)).r, 4.0F / 255);
            lit += light > 0.1F ? 1 : 0;
        }
    }
    EXPECT_GT(lit, 300);
}

class ScanLight : public ScanTest {
protected:
    static constexpr int n = 17;
    static constexpr float absorption = 1.2F;  // absorption of the matter (1/m)
    const std::vector<std::uint16_t> even = sampled(n, [](fvec3) { return 0.5F; });
    const int middle = picture_side / 2;

    /// Colour of a layer of matter of thickness `way` (m) in front of a background.
    static fvec3 over(fvec3 behind, fvec3 colour, float way) {
        const float cover = 1 - std::exp(-absorption * way);
        return detail::tone_mapped(colour) * cover + behind * (1 - cover);
    }
    static void expect_near(fvec3 seen, fvec3 expected) {
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(seen[c], expected[c], colour_tolerance);
    }
};

TEST_F(ScanLight, FollowsTheLawOfBeerAndLambert) {
    stand({0, 0, -3}, {8, 8, 1}, {0.2F, 0.1F, 0.05F});
    const auto behind = pixel_of(drawn(), middle, middle);
    ASSERT_GT(behind.r, 0.2F);
    const fvec3 colour(0.5F, 1, 0.1F);
    const auto table = uniform_table(colour, absorption);
    auto scan = scan_of(even, n);
    scan.table = &table;
    for (const auto q : {Quality::low, Quality::medium}) {
        quality = q;
        for (const float step : {0.3F, 0.5F, 1.0F, 2.3F}) {
            scan.step = step;
            for (const auto how : {ScanDetail::sharp, ScanDetail::quick}) {
                detail = how;
                expect_near(pixel_of(drawn(scan), middle, middle), over(behind, colour, 2));
            }
        }
    }
}

TEST_F(ScanLight, DependsOnTheLengthOfTheWayThroughTheTurnedBody) {
    stand({0, 0, -4}, {12, 12, 1}, {0.2F, 0.1F, 0.05F});
    const auto behind = pixel_of(drawn(), middle, middle);
    const auto table = uniform_table(fvec3(1), absorption);
    auto scan = scan_of(even, n);
    scan.table = &table;
    scan.model = rotated({0, 1, 0}, 0.3F);
    expect_near(pixel_of(drawn(scan), middle, middle), over(behind, fvec3(1), 2 / std::cos(0.3F)));
    // A scaled body looks the same, because absorption is defined in its own frame.
    scan.model = scaled(fvec3(0.5F));
    expect_near(pixel_of(drawn(scan), middle, middle), over(behind, fvec3(1), 2));
}

TEST_F(ScanLight, ShowsAToolInsideThroughThePartInFrontOfIt) {
    stand({0, 0, 0}, {0.5F, 0.5F, 0.5F}, {0.3F, 0.6F, 0.1F});  // a box whose front is at z = 0.25 m
    const auto tool = pixel_of(drawn(), middle, middle);
    const auto table = uniform_table(fvec3(0.4F), absorption);
    auto scan = scan_of(even, n);
    scan.table = &table;
    for (const auto how : {ScanDetail::sharp, ScanDetail::quick}) {
        detail = how;
        expect_near(pixel_of(drawn(scan), middle, middle), over(tool, fvec3(0.4F), 0.75F));
    }
    // A wall in front of the scan hides it.
    stand({0, 0, 1.5F}, {2, 2, 0.1F}, {0.3F, 0.6F, 0.1F});
    const auto wall = drawn();
    EXPECT_LE(max_difference(wall, drawn(scan)), 1);
}

TEST_F(ScanLight, CoversAnotherScanBehindItInEitherOrder) {
    stand({0, 0, -6}, {20, 20, 1}, {0.2F, 0.1F, 0.05F});
    const auto behind = pixel_of(drawn(), middle, middle);
    const auto red = uniform_table({1, 0, 0}, absorption), green = uniform_table({0, 1, 0}, absorption);
    auto near = scan_of(even, n), far = scan_of(even, n);
    near.table = &red;
    far.table = &green;
    far.model = translated({0, 0, -2.5F});
    const std::array one_way{near, far}, other_way{far, near};
    const auto expected = over(over(behind, {0, 1, 0}, 2), {1, 0, 0}, 2);
    expect_near(pixel_of(drawn(one_way), middle, middle), expected);
    expect_near(pixel_of(drawn(other_way), middle, middle), expected);
}

/// Emission and absorption by a table over density, integrated in a thousand steps per sample.
fvec4 marched(float from, float to, const ScanTable& table, float unit, auto density) {
    const int steps = 40'000;
    const float h = (to - from) / static_cast<float>(steps);
    fvec3 light(0);
    float clear = 1;
    for (int i = 0; i < steps; ++i) {
        const float at = 255 * density(from + (static_cast<float>(i) + 0.5F) * h);
        const auto low = static_cast<std::size_t>(std::clamp(at, 0.0F, 254.0F));
        const float part = at - static_cast<float>(low);
        const auto thick = [&](std::size_t k) { return -std::log(1 - table[k].opacity) / unit; };
        const float left = clear * std::exp(-h * ((1 - part) * thick(low) + part * thick(low + 1)));
        light += (clear - left) * ((1 - part) * table[low].colour + part * table[low + 1].colour);
        clear = left;
    }
    return {light, 1 - clear};
}

TEST_F(ScanLight, FollowsATableThroughARampUntilNothingArrives) {
    // Along the middle ray the density rises from 0 at the front to 1 at the back.
    const auto ramp = sampled(n, [](fvec3 at) { return 0.5F - at.z / (n - 1); });
    for (const float most : {0.02F, 0.1F, 0.9F}) {
        ScanTable table;
        for (std::size_t i = 0; i < table.size(); ++i) {
            const float d = static_cast<float>(i) / 255;
            table[i] = {{d, 1 - d, 0.5F}, d > 0.3F && d < 0.8F ? most * (d - 0.3F) : 0};
        }
        auto scan = scan_of(ramp, n);
        scan.table = &table;
        scan.step = 0.1F;
        quality = Quality::high;
        const auto expected = marched(0, 2, table, scan.unit, [](float way) { return way / 2; });
        expect_near(pixel_of(drawn(scan), middle, middle), detail::tone_mapped(fvec3(expected)));
    }
}

}  // namespace
}  // namespace thaum::render

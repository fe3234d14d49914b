// Tests of scans in pictures: skipped bricks (blocks of samples), edits, materials, detail, invalid input;
// and of the bricks themselves.
#include "render/scan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "render/detail/scan_bricks.h"
#include "unit/picture_part.h"
#include "unit/scan_rig.h"

namespace thaum::render {
namespace {

constexpr int scan_side = 33;
constexpr std::size_t all_bricks = 5 * 5 * 5;

/// Index of the sample at (x, y, z) of a scan with `wide` samples along x and `high` along y.
std::size_t sample_at(std::size_t wide, std::size_t high, int x, int y, int z) {
    return (static_cast<std::size_t>(z) * high + static_cast<std::size_t>(y)) * wide +
           static_cast<std::size_t>(x);
}

class ScanPicture : public ScanTest {
protected:
    void SetUp() override {
        ScanTest::SetUp();
        for (std::size_t i = 0; i < table.size(); ++i) {
            const float d = static_cast<float>(i) / 255;
            table[i] = {{1, d, 0.3F}, d > 0.5F ? 0.2F * (d - 0.5F) : 0};
        }
    }
    Scan translucent() const {
        auto scan = scan_of(samples, scan_side);
        scan.table = &table;
        return scan;
    }
    std::vector<std::uint16_t> samples = ball_samples(scan_side, 10);
    ScanTable table;
};

TEST_F(ScanPicture, IsTheSameWithAndWithoutLeaps) {
    // Thin shells far apart, so that most bricks are empty and rays enter and leave many others.
    samples = sampled(scan_side, [](fvec3 at) { return std::pow(std::sin(0.5F * glm::length(at)), 2.0F); });
    for (std::size_t i = 0; i < table.size(); ++i) table[i].opacity = i > 230 ? 0.2F : 0;
    camera.orientation = glm::angleAxis(0.05F, fvec3(1, 0, 0));
    for (const auto look : {ScanLook::translucent, ScanLook::surface}) {
        for (const bool lit : {false, true}) {
            auto scan = translucent();
            scan.look = look;
            scan.lit = lit;
            scan.level = 0.95F;
            scan.model = rotated(glm::normalize(fvec3(1, 1, 0)), 0.4F);
            const auto with = drawn(scan);
            scan.leaps = false;
            EXPECT_LE(max_difference(with, drawn(scan)), 1);
            EXPECT_GT(max_difference(with, drawn()), 100) << "something is drawn";
        }
    }
}

/// Smallest rectangle that holds all pixels that differ.
Rect changed_part(const Image& a, const Image& b) {
    int x0 = picture_side, y0 = picture_side, x1 = 0, y1 = 0;
    for (int y = 0; y < picture_side; ++y) {
        for (int x = 0; x < picture_side; ++x) {
            if (pixel_of(a, x, y) == pixel_of(b, x, y)) continue;
            x0 = std::min(x0, x), y0 = std::min(y0, y), x1 = std::max(x1, x + 1), y1 = std::max(y1, y + 1);
        }
    }
    return {x0, y0, x1 - x0, y1 - y0};
}

/// Makes a hole in brick (1, 2, 1), which has samples 8 to 15, 16 to 23 and 8 to 15 along the axes.
void make_hole(std::vector<std::uint16_t>& samples, std::vector<std::uint32_t>& versions) {
    for (int z = 8; z < 16; ++z) {
        for (int y = 16; y < 24; ++y) {
            for (int x = 8; x < 16; ++x) samples[sample_at(scan_side, scan_side, x, y, z)] = 0;
        }
    }
    ++versions[(1 * 5 + 2) * 5 + 1];
}

/// Pixel column at which a sample of the cube appears, if the cube is 2 m wide, its middle 3 m away and the
/// picture enlarged `nearer` times.
float pixel_of_sample(float sample, float nearer) {
    return 0.5F * picture_side * (1 + (sample - 16) / 16 * nearer / 3 / std::tan(0.4F));
}

TEST_F(ScanPicture, AnEditSendsItsBrickAndChangesItsPixels) {
    std::vector<std::uint32_t> versions(all_bricks, 1);
    samples = sampled(scan_side, [](fvec3 at) { return at.z < 0 ? 1.0F : 0.0F; });
    environment.fog = {fvec3(0), 0.3F};  // the floor of the hole looks darker
    for (const auto look : {ScanLook::translucent, ScanLook::surface}) {
        auto scan = translucent();
        scan.look = look;
        scan.brick_versions = versions;
        const auto before = drawn(scan);
        EXPECT_EQ(renderer->statistics().scan_bricks_sent, all_bricks);
        (void)drawn(scan);
        EXPECT_EQ(renderer->statistics().scan_bricks_sent, 0U);
        const auto kept = samples;
        make_hole(samples, versions);
        const auto unsent = drawn(scan);
        EXPECT_EQ(max_difference(before, unsent), 0) << "the version is the same";
        ++scan.version;
        const auto after = drawn(scan);
        EXPECT_EQ(renderer->statistics().scan_bricks_sent, 1U);
        // The picture must equal that of the whole scan sent again.
        auto anew = scan;
        anew.id = renderer->make_scan();
        EXPECT_EQ(max_difference(after, drawn(anew)), 0);
        const auto part = changed_part(before, after);
        EXPECT_GT(part.width, 10);
        EXPECT_GT(part.height, 10);
        // The nearest part of the hole is 2 m away.
        EXPECT_GE(static_cast<float>(part.x), pixel_of_sample(7, 1.5F) - 1);
        EXPECT_LE(static_cast<float>(part.x + part.width), pixel_of_sample(16, 1) + 1);
        samples = kept;
    }
}

TEST_F(ScanPicture, FillingAnEmptyBrickShowsIt) {
    std::vector<std::uint32_t> versions(all_bricks, 1);
    std::ranges::fill(samples, std::uint16_t{0});
    auto scan = translucent();
    scan.brick_versions = versions;
    const auto nothing = drawn();
    EXPECT_EQ(max_difference(nothing, drawn(scan)), 0);
    EXPECT_EQ(renderer->statistics().scans_drawn, 0U) << "no brick shows anything";
    for (int x = 16; x < 24; ++x) samples[sample_at(scan_side, scan_side, x, 18, 18)] = 65535;
    ++scan.version;
    ++versions[(2 * 5 + 2) * 5 + 2];
    EXPECT_GT(max_difference(nothing, drawn(scan)), 20);
    // After a change of the table from density to colour and opacity the hole is hidden again, although no
    // sample is sent.
    table.fill({});
    EXPECT_EQ(max_difference(nothing, drawn(scan)), 0);
    EXPECT_EQ(renderer->statistics().scan_bricks_sent, 0U);
}

TEST_F(ScanPicture, OfOtherSampleTypesIsTheSame) {
    std::vector<std::uint8_t> bytes;
    std::vector<std::uint16_t> same;
    std::vector<std::int16_t> shorts;
    std::vector<float> floats;
    for (const auto s : samples) {
        bytes.push_back(static_cast<std::uint8_t>(s / 257));
        same.push_back(static_cast<std::uint16_t>(257 * bytes.back()));
        shorts.push_back(static_cast<std::int16_t>(bytes.back() - 200));
        floats.push_back(-3 + 5 * static_cast<float>(bytes.back()) / 255);
    }
    auto scan = translucent();
    scan.samples = std::span<const std::uint16_t>(same);
    const auto sixteen = drawn(scan);
    ++scan.version;
    scan.samples = std::span<const std::uint8_t>(bytes);
    scan.high = 255;
    EXPECT_LE(max_difference(sixteen, drawn(scan)), 3);
    ++scan.version;
    scan.samples = std::span<const std::int16_t>(shorts);
    scan.low = -200, scan.high = 55;
    EXPECT_LE(max_difference(sixteen, drawn(scan)), 1);
    ++scan.version;
    scan.samples = std::span<const float>(floats);
    scan.low = -3, scan.high = 2;
    EXPECT_LE(max_difference(sixteen, drawn(scan)), 1);
    // Bytes with a range of their own, such as a mask of a few labels.
    std::vector<std::uint8_t> narrow;
    std::vector<std::int16_t> wide;
    for (const auto byte : bytes) {
        narrow.push_back(static_cast<std::uint8_t>(byte / 2 + 10));
        wide.push_back(static_cast<std::int16_t>(narrow.back()));
    }
    ++scan.version;
    scan.samples = std::span<const std::uint8_t>(narrow);
    scan.low = 10, scan.high = 137;
    const auto of_bytes = drawn(scan);
    ++scan.version;
    scan.samples = std::span<const std::int16_t>(wide);
    EXPECT_LE(max_difference(of_bytes, drawn(scan)), 1);
    ++scan.version;
    scan.samples = std::span<const float>(floats);
    scan.low = -3, scan.high = 2;
    // A NaN sample counts as the lowest value.
    ++scan.version;
    const auto mixed = floats;
    for (auto& f : floats) {
        if (f == -3) f = std::numeric_limits<float>::quiet_NaN();
    }
    EXPECT_LE(max_difference(sixteen, drawn(scan)), 1);
}

TEST_F(ScanPicture, MaterialsColourAndHideSurfaces) {
    std::vector<std::uint8_t> materials(samples.size(), 0);
    for (std::size_t i = 0; i < materials.size(); ++i) materials[i] = i % scan_side < scan_side / 2 ? 1 : 0;
    const std::vector<field::Rgb8> colours(samples.size(), {255, 128, 0});
    std::array<ScanMaterial, 2> kinds{};
    auto scan = translucent();
    scan.look = ScanLook::surface;
    scan.materials = materials;
    scan.colours = colours;
    scan.material_table = kinds;
    const int left = picture_side / 2 - 20, right = picture_side / 2 + 20, y = picture_side / 2;
    const auto both = drawn(scan);
    const float half = 128.0F / 255;
    const auto expected = detail::tone_mapped({1, half * half, 0});
    for (const int x : {left, right}) {
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(pixel_of(both, x, y)[c], expected[c], 0.02F);
    }
    kinds[1].opacity = 0;
    const auto one = drawn(scan);
    EXPECT_EQ(renderer->statistics().scan_bricks_sent, 0U);
    EXPECT_EQ(pixel_of(one, right, y), pixel_of(both, right, y));
    EXPECT_LT(pixel_of(one, left, y).r, 0.5F) << "the far side is dark or missing";
    scan.look = ScanLook::translucent;
    const auto through = drawn(scan);
    EXPECT_GT(pixel_of(through, right, y).r, 0.3F);
    EXPECT_EQ(pixel_of(through, left - 5, y).r, 0);
}

TEST_F(ScanPicture, SurfacesCrossEachOtherAndMeshes) {
    const auto other = ball_samples(scan_side, 10);
    auto near = scan_of(samples, scan_side), far = scan_of(other, scan_side);
    near.look = far.look = ScanLook::surface;
    near.colour = {1, 0, 0};
    far.colour = {0, 1, 0};
    near.model = translated({-0.3F, 0, 0});
    far.model = translated({0.3F, 0, 0});
    stand({0, 0.3F, 0.5F}, {0.2F, 0.2F, 0.5F}, {0, 0, 1});
    for (const auto how : {ScanDetail::sharp, ScanDetail::quick}) {
        detail = how;
        const std::array one_way{near, far}, other_way{far, near};
        const auto image = drawn(one_way);
        EXPECT_LE(max_difference(image, drawn(other_way)), 0);
        EXPECT_GT(pixel_of(image, picture_side / 2 - 8, picture_side / 2 + 4).r, 0.5F);
        EXPECT_GT(pixel_of(image, picture_side / 2 + 8, picture_side / 2 + 4).g, 0.5F);
        EXPECT_GT(pixel_of(image, picture_side / 2, picture_side / 2 - 15).b, 0.5F);
    }
}

TEST_F(ScanPicture, BecomesSharpWhenStillAndIsKept) {
    quality = Quality::medium;
    auto scan = translucent();
    const auto sharp = drawn(scan);
    detail = ScanDetail::automatic;
    scan.model = translated({0.01F, 0, 0});
    const auto moved = drawn(scan);
    scan.model = fmat4(1);
    const auto first = drawn(scan);
    EXPECT_EQ(renderer->statistics().scans_marched, 1U);
    EXPECT_GT(max_difference(sharp, first), 0) << "a quick picture while it moves";
    EXPECT_LT(max_difference(sharp, first), 60);
    EXPECT_EQ(max_difference(sharp, drawn(scan)), 0);
    EXPECT_EQ(renderer->statistics().scans_marched, 1U);
    EXPECT_EQ(max_difference(sharp, drawn(scan)), 0);
    EXPECT_EQ(renderer->statistics().scans_marched, 0U) << "the sharp picture is kept";
    // An object far from the scan does not make it less sharp, but may hide parts of it, so the rays are
    // computed again.
    stand({0.4F, 0, 2.2F}, {0.1F, 0.1F, 0.1F}, {0, 0, 1});
    (void)drawn(scan);
    EXPECT_EQ(renderer->statistics().scans_marched, 1U);
    const auto with_thing = drawn(scan);
    EXPECT_EQ(renderer->statistics().scans_marched, 0U);
    detail = ScanDetail::sharp;
    auto same = scan;
    same.id = renderer->make_scan();
    EXPECT_EQ(max_difference(with_thing, drawn(same)), 0);
}

TEST_F(ScanPicture, StandsInBothViewsAndEverySize) {
    const auto scan = translucent();
    for (const auto q : {Quality::low, Quality::high}) {
        quality = q;
        const auto views = split_window(picture_side, picture_side, Split::top_bottom);
        auto frame = frame_of({&scan, 1});
        frame.views.push_back(frame.views[0]);
        for (std::size_t i = 0; i < 2; ++i) frame.views[i].viewport = views[i];
        for (const float scale : {1.0F, 0.5F}) {
            frame.internal_scale = scale;
            renderer->draw(frame);
            EXPECT_EQ(renderer->statistics().scans_drawn, 2U);
            const auto image = renderer->read_pixels();
            EXPECT_EQ(max_difference(part_of(image, views[0]), part_of(image, views[1])), 0);
            EXPECT_GT(pixel_of(image, picture_side / 2, picture_side / 4).r, 0.5F);
            EXPECT_EQ(pixel_of(image, 2, picture_side / 4).r, 0);
        }
    }
}

TEST_F(ScanPicture, CostsNothingUnseen) {
    auto scan = translucent();
    const auto nothing = [&] {
        const auto& s = renderer->statistics();
        return s.scans_drawn == 0 && s.scans_marched == 0 && s.scan_bricks_sent == 0;
    };
    camera.orientation = glm::angleAxis(3.0F, fvec3(0, 1, 0));
    const auto without = drawn();
    const auto draws = renderer->statistics().draws;
    EXPECT_EQ(max_difference(without, drawn(scan)), 0);
    EXPECT_TRUE(nothing()) << "behind the eye";
    EXPECT_EQ(renderer->statistics().draws, draws);
    camera.orientation = {1, 0, 0, 0};
    blocks = {{vec3(-3, -3, 2), vec3(3, 3, 2.5)}};
    (void)drawn(scan);
    EXPECT_TRUE(nothing()) << "behind a block";
    blocks.clear();
    (void)drawn(scan);
    EXPECT_EQ(renderer->statistics().scans_drawn, 1U);
}

TEST_F(ScanPicture, AnInvalidScanIsNotDrawn) {
    const auto without = drawn();
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const auto refused = [&](auto spoil) {
        auto spoilt = translucent();
        spoil(spoilt);
        const bool same = max_difference(without, drawn(spoilt)) == 0;
        return same && renderer->statistics().scans_drawn == 0;
    };
    EXPECT_FALSE(refused([](Scan&) {}));
    EXPECT_TRUE(refused([](Scan& s) { s.count = {0, 0, 0}; }));
    EXPECT_TRUE(refused([](Scan& s) { s.count = {scan_side, scan_side, scan_side + 1}; }));
    EXPECT_TRUE(refused([](Scan& s) { s.count = {-scan_side, -scan_side, scan_side}; }));
    EXPECT_TRUE(refused([](Scan& s) { s.count = {scan_side * scan_side, 1, scan_side}; }));
    EXPECT_TRUE(refused([](Scan& s) { s.model = fmat4(0); }));
    EXPECT_TRUE(refused([](Scan& s) { s.model = scaled({1, 0, 1}); }));
    EXPECT_TRUE(refused([&](Scan& s) { s.model[3].x = nan; }));
    EXPECT_TRUE(refused([&](Scan& s) { s.spacing.y = nan; }));
    EXPECT_TRUE(refused([](Scan& s) { s.spacing.z = 0; }));
    EXPECT_TRUE(refused([](Scan& s) { s.table = nullptr; }));
    EXPECT_TRUE(refused([&](Scan& s) { s.unit = nan; }));
    EXPECT_TRUE(refused([](Scan& s) { s.step = 0; }));
    EXPECT_TRUE(refused([](Scan& s) { s.high = s.low; }));
    EXPECT_TRUE(refused([&](Scan& s) { s.look = ScanLook::surface, s.level = nan; }));
}

TEST_F(ScanPicture, HugeAndTinyPlacementsEndInAPicture) {
    for (const float scale : {1e-12F, 1e-6F, 1e4F, 1e6F, 1e12F}) {
        for (const auto look : {ScanLook::translucent, ScanLook::surface}) {
            auto scan = translucent();
            scan.look = look;
            scan.model = scaled(fvec3(scale));
            const auto image = drawn(scan);
            EXPECT_EQ(image.width, picture_side);
            scan.model = translated(fvec3(0, 0, -1000 * scale)) * scaled(fvec3(scale));
            (void)drawn(scan);
        }
    }
    // From inside a large body only its matter is visible.
    auto scan = translucent();
    scan.model = scaled(fvec3(1e2F));
    EXPECT_GT(pixel_of(drawn(scan), picture_side / 2, picture_side / 2).r, 0.5F);
}

// ---- bricks (blocks of samples) ---------------------------------------------------------------------------

TEST(ScanBricks, HaveTheRangeOfTheirCells) {
    std::vector<std::uint8_t> samples(12 * 9 * 8);
    std::iota(samples.begin(), samples.end(), std::uint8_t{0});
    const Scan scan{.count = {12, 9, 8}, .samples = std::span<const std::uint8_t>(samples), .high = 255};
    EXPECT_EQ(bricks_of(scan.count), (std::array{2, 2, 1}));
    for (int by = 0; by < 2; ++by) {
        for (int bx = 0; bx < 2; ++bx) {
            int low = 255, high = 0;
            for (int z = 0; z < 8; ++z) {
                for (int y = 8 * by; y < std::min(8 * by + 9, 9); ++y) {
                    for (int x = 8 * bx; x < std::min(8 * bx + 9, 12); ++x) {
                        const int s = samples[sample_at(12, 9, x, y, z)];
                        low = std::min(low, s), high = std::max(high, s);
                    }
                }
            }
            const auto range = detail::density_range(scan, {bx, by, 0});
            EXPECT_EQ(range.low, 257 * low);
            EXPECT_EQ(range.high, 257 * high);
        }
    }
}

TEST(ScanBricks, DistancesAreThoseOfAllPairs) {
    const std::array<int, 3> count{7, 5, 6};
    std::vector<std::uint8_t> shown(7 * 5 * 6, 0), found;
    shown[3] = shown[7 * 5 * 2 + 9] = shown[7 * 5 * 6 - 1] = 1;
    detail::find_distances(shown, count, found);
    const auto place = [&](std::size_t i) {
        return std::array{static_cast<int>(i % 7), static_cast<int>(i / 7 % 5), static_cast<int>(i / 35)};
    };
    for (std::size_t i = 0; i < shown.size(); ++i) {
        int least = 255;
        for (std::size_t k = 0; k < shown.size(); ++k) {
            if (shown[k] == 0) continue;
            int largest = 0;
            for (std::size_t axis = 0; axis < 3; ++axis)
                largest = std::max(largest, std::abs(place(i).at(axis) - place(k).at(axis)));
            least = std::min(least, largest);
        }
        EXPECT_EQ(found[i], least) << i;
    }
    std::ranges::fill(shown, std::uint8_t{0});
    detail::find_distances(shown, count, found);
    EXPECT_TRUE(std::ranges::all_of(found, [](auto d) { return d == 255; }));
}

TEST(ScanBricks, ChangesAreJoinedAlongX) {
    const std::vector<std::uint8_t> samples(32 * 16 * 16);
    std::vector<std::uint32_t> versions(4 * 2 * 2, 1), sent;
    Scan scan{.count = {32, 16, 16}, .samples = std::span<const std::uint8_t>(samples), .high = 255};
    scan.brick_versions = versions;
    auto runs = detail::changed_bricks(scan, sent);
    ASSERT_EQ(runs.size(), 1U);
    EXPECT_EQ(runs[0].count, (std::array{4, 2, 2}));
    EXPECT_TRUE(detail::changed_bricks(scan, sent).empty());
    versions[1] = versions[2] = versions[3] = versions[4] = versions[15] = 2;
    runs = detail::changed_bricks(scan, sent);
    ASSERT_EQ(runs.size(), 3U);
    EXPECT_EQ(runs[0].first, (std::array{1, 0, 0}));
    EXPECT_EQ(runs[0].count, (std::array{3, 1, 1}));
    EXPECT_EQ(runs[1].first, (std::array{0, 1, 0}));
    EXPECT_EQ(runs[2].first, (std::array{3, 1, 1}));
    scan.brick_versions = {};
    EXPECT_EQ(detail::changed_bricks(scan, sent).size(), 1U);
}

}  // namespace
}  // namespace thaum::render

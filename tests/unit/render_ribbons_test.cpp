// Tests of stream ribbons: their meshes, and which of them are traced again.
#include "render/ribbons.h"

#include <gtest/gtest.h>

#include <limits>

#include "unit/scan_rig.h"

namespace thaum::render {
namespace {

/// A flow that turns about z and moves along z.
struct Screw {
    field::Vector operator()(vec3 p) const {
        return {{-p.y, p.x, 0.2}, {vec3(0, -1, 0), vec3(1, 0, 0), vec3(0)}};
    }
};

constexpr double radius = 0.4;

std::vector<field::StreamPoint> helix() {
    std::vector<field::StreamPoint> line;
    const Screw flow;
    field::trace(field::field_of<field::Vector>(flow), {radius, 0, 0}, {.length = 2}, line);
    return line;
}

TEST(Ribbon, HasItsWidthOnBothSidesOfTheLine) {
    const auto line = helix();
    const auto mesh = ribbon(line, {.width = 0.05F});
    ASSERT_EQ(mesh.vertices.size(), 4 * line.size());
    EXPECT_EQ(mesh.indices.size(), 12 * (line.size() - 1));
    for (std::size_t i = 0; i < line.size(); ++i) {
        const auto &left = mesh.vertices[2 * i], &right = mesh.vertices[2 * i + 1];
        const fvec3 place(line[i].place);
        EXPECT_LT(glm::distance(0.5F * (left.position + right.position), place), 1e-6F);
        const bool middle = line[i].way > 0.05 && line[i].way < 1.95;
        if (middle) {
            EXPECT_NEAR(glm::distance(left.position, right.position), 0.05F, 1e-6F);
        }
        EXPECT_NEAR(glm::dot(left.normal, right.position - left.position), 0, 1e-6F);
    }
    EXPECT_LT(glm::distance(mesh.vertices[0].position, mesh.vertices[1].position), 1e-6F) << "pointed";
}

TEST(Ribbon, FacesTheWayOfItsNormals) {
    const auto mesh = ribbon(helix(), {.width = 0.05F});
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const auto &a = mesh.vertices[mesh.indices[i]], &b = mesh.vertices[mesh.indices[i + 1]],
                   &c = mesh.vertices[mesh.indices[i + 2]];
        const fvec3 normal = glm::cross(b.position - a.position, c.position - a.position);
        EXPECT_GE(glm::dot(normal, a.normal), -1e-9F);
    }
}

TEST(Ribbon, TakesItsColourFromTheSpeed) {
    SpeedColours colours;
    for (std::size_t i = 0; i < colours.size(); ++i) colours.at(i) = fvec3(static_cast<float>(i));
    std::vector<field::StreamPoint> line(5);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const std::array speeds{1.0, 2.0, 3.0, 9.0, nan};
    for (std::size_t i = 0; i < line.size(); ++i)
        line[i] = {.place = vec3(static_cast<double>(i), 0, 0),
                   .along = vec3(1, 0, 0),
                   .across = vec3(0, 1, 0),
                   .speed = speeds.at(i),
                   .way = static_cast<double>(i)};
    const auto mesh = ribbon(line, {.colours = &colours, .slowest = 1, .fastest = 3});
    EXPECT_EQ(mesh.vertices[0].colour.r, 0);
    EXPECT_EQ(mesh.vertices[2].colour.r, 128);
    EXPECT_EQ(mesh.vertices[4].colour.r, 255);
    EXPECT_EQ(mesh.vertices[6].colour.r, 255);
    EXPECT_EQ(mesh.vertices[8].colour.r, 0);
    EXPECT_TRUE(ribbon({line.data(), 1}, {}).indices.empty());
}

class RibbonPicture : public ScanTest {};

TEST_F(RibbonPicture, TracesOnlySeedsThatMoved) {
    const Screw flow;
    const auto field = field::field_of<field::Vector>(flow);
    const field::StreamlineSettings settings{.length = 2};
    Ribbons ribbons;
    std::vector<vec3> seeds{{0.4, 0, 0}, {0.2, 0, 0}, {0, 0.3, 0}};
    const auto update = [&](std::uint64_t version) {
        return ribbons.update(*renderer, field, seeds, settings, {.width = 0.1F}, version);
    };
    const auto picture = [&] {
        const auto all = ribbons.instances();
        instances.assign(all.begin(), all.end());
        return drawn();
    };
    EXPECT_EQ(update(1), 3U);
    EXPECT_EQ(update(1), 0U);
    const auto three = picture();
    EXPECT_GT(
        max_difference(three, Image{picture_side, picture_side, std::vector<std::uint8_t>(three.rgb.size())}),
        100);
    seeds[1] = {0.7, 0, 0};
    EXPECT_EQ(update(1), 1U);
    const auto moved = picture();
    EXPECT_GT(max_difference(three, moved), 100);
    seeds.pop_back();
    EXPECT_EQ(update(1), 0U);
    const auto two = picture();
    EXPECT_GT(max_difference(moved, two), 100);
    seeds.push_back({0, 0.3, 0});
    EXPECT_EQ(update(1), 1U);
    EXPECT_EQ(max_difference(moved, picture()), 0);
    EXPECT_EQ(update(2), 3U);
}

}  // namespace
}  // namespace thaum::render

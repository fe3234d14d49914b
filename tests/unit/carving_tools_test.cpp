// Tests of tool files: what the shipped tools do, and what is reported for each fault.
#include "field/carving_tools.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "core/file.h"
#include "unit/carving_rig.h"
#include "unit/message_of.h"

namespace thaum::field {
namespace {

Materials shipped_materials() {
    const auto file = read_text_file(THAUM_SOURCE_DIR "/assets/materials.toml", 1U << 20U);
    return *read_materials(*Config::parse(*file, "materials.toml", materials_file_version));
}

Expected<Tool> shipped(const std::string& name) {
    return load_tool(std::filesystem::path(THAUM_SOURCE_DIR) / "assets/carving" / (name + ".toml"),
                     shipped_materials());
}

Expected<Tool> tool_from(std::string_view toml) {
    const auto config = Config::parse(toml, "t.toml", tool_file_version);
    return config ? read_tool(*config, shipped_materials()) : config.error();
}

/// Message about a tool file whose only operation has the given lines, from line 4 of the file on.
std::string fault(std::string_view operation) {
    return message_of(tool_from("version = 1\nname = \"t\"\n[[operation]]\n" + std::string(operation)),
                      "no fault");
}

/// A body that is solid below layer 12, and the result of carving in its middle for half a second.
struct Carved {
    Voxels before = block({24, 24, 24}, 0), body;
    Edit done;

    explicit Carved(const Tool& tool) {
        std::fill_n(before.density.begin(), 24 * 24 * 12, 1.0F);
        body = before;
        done = edit(body.view(), tool, {.place = place_of(body, {12, 12, 11.5}), .seconds = 0.5});
    }
    bool same_density() const { return body.density == before.density; }
    bool same_colour() const { return body.colour == before.colour; }
    bool same_material() const { return body.material == before.material; }
};

TEST(CarvingTools, EachShippedToolChangesItsPropertiesAndNoOther) {
    struct Case {
        const char* name;
        Properties changes;
        bool adds;
        bool removes;
    };
    for (const Case& c :
         {Case{"melt", {true, false, false}, false, true},
          Case{"construct", {true, false, false}, true, false},
          Case{"paint", {false, true, false}, false, false}, Case{"stamp", {true, false, false}, true, false},
          Case{"invisibility", {false, false, true}, false, false},
          Case{"squirt", {true, true, true}, true, false},
          Case{"annotate", {false, true, true}, false, false},
          Case{"cut", {true, false, false}, false, true}}) {
        const auto tool = shipped(c.name).value();
        EXPECT_EQ(tool.name, c.name);
        const Carved carved(tool);
        EXPECT_GT(carved.done.voxels, 0U) << c.name;
        EXPECT_EQ(carved.same_density(), !c.changes.density) << c.name;
        EXPECT_EQ(carved.same_colour(), !c.changes.colour) << c.name;
        EXPECT_EQ(carved.same_material(), !c.changes.material) << c.name;
        EXPECT_EQ(carved.done.added > 0, c.adds) << c.name;
        EXPECT_EQ(carved.done.removed > 0, c.removes) << c.name;
    }
}

TEST(CarvingTools, EveryFileInTheFolderIsAToolOfItsName) {
    std::size_t count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(THAUM_SOURCE_DIR "/assets/carving")) {
        const auto tool = load_tool(entry.path(), shipped_materials()).value();
        EXPECT_EQ(tool.name, entry.path().stem().string());
        ++count;
    }
    EXPECT_EQ(count, 8U);
}

TEST(CarvingTools, ReadsEachValue) {
    const auto tool =
        tool_from(
            "version = 1\nname = \"t\"\n[[operation]]\nmethod = \"filter\"\nextent = \"gaussian\"\nradius = "
            "3\n"
            "properties = \"density\"\nfilter = \"construct\"\nrate = 7\ndensity = 0.63\n[[operation]]\n"
            "method = \"constant\"\nextent = \"box\"\nhalf_m = [0.1, 0.2, 0.3]\nproperties = \" material  "
            "colour\"\n"
            "material = \"bone\"\ncolour = [1, 2, 3]\n")
            .value();
    ASSERT_EQ(tool.operations.size(), 2U);
    const Operation &a = tool.operations[0], &b = tool.operations[1];
    EXPECT_EQ(a.method, Method::filter);
    EXPECT_EQ(a.extent.shape, ExtentShape::gaussian);
    EXPECT_EQ(a.extent.half, vec3(3));
    EXPECT_FALSE(a.extent.in_metres);
    EXPECT_EQ(a.changes, (Properties{.density = true}));
    EXPECT_EQ(a.rate, 7);
    EXPECT_EQ(a.density, 0.63);
    EXPECT_EQ(b.method, Method::constant);
    EXPECT_EQ(b.extent.half, vec3(0.1, 0.2, 0.3));
    EXPECT_TRUE(b.extent.in_metres);
    EXPECT_EQ(b.changes, (Properties{.colour = true, .material = true}));
    EXPECT_EQ(b.material, 5);
    EXPECT_EQ(b.colour, (Rgb8{1, 2, 3}));
}

TEST(CarvingTools, AStampHasTheProportionsOfItsCells) {
    const auto tool =
        tool_from(
            "version = 1\nname = \"t\"\n[[operation]]\nmethod = \"constant\"\nextent = \"stamp\"\nradius = "
            "4\n"
            "cells = [4, 2, 1]\nshape = '''\n.5#0\n9876'''\nproperties = \"density\"\ndensity = 1\n")
            .value();
    const Extent& extent = tool.operations[0].extent;
    EXPECT_EQ(extent.half, vec3(4, 2, 1));
    EXPECT_EQ(extent.stamp.weight, (std::vector<float>{0, 0.5F, 1, 0, 0.9F, 0.8F, 0.7F, 0.6F}));
}

TEST(CarvingTools, APropertyOfTwoOperationsIsReportedWithBoth) {
    const std::string melt =
        "[[operation]]\nmethod = \"filter\"\nextent = \"sphere\"\nradius = 3\nproperties = \"density\"\n"
        "filter = \"melt\"\nrate = 1\n";
    const std::string set =
        "[[operation]]\nmethod = \"constant\"\nextent = \"sphere\"\nradius = 3\n"
        "properties = \"colour density\"\ncolour = [0, 0, 0]\ndensity = 1\n";
    EXPECT_EQ(message_of(tool_from("version = 1\nname = \"t\"\n" + melt + set)),
              "t.toml:14: operations 1 and 2 both change density; keep one of them");
}

TEST(CarvingTools, AToolOnTheSurfaceCannotMoveTheSurface) {
    EXPECT_EQ(fault("method = \"constant\"\nextent = \"sphere\"\nradius = 3\nproperties = \"density\"\n"
                    "density = 1\nonly = \"surface\"\n"),
              "t.toml:2: a tool with only = \"surface\" cannot change density; make it two tools");
}

TEST(CarvingTools, FaultsNameTheLine) {
    const std::string start = "method = \"constant\"\nextent = \"sphere\"\nradius = 3\n";
    EXPECT_EQ(fault(start + "properties = \"density\"\ndensity = 1\nspeed = 3\n")
                  .find("t.toml:9: unknown key 'operation.speed'"),
              0U);
    EXPECT_EQ(fault(start + "properties = \"density\"\ndensity = 1\nrate = 3\n")
                  .find("t.toml:9: unknown key 'operation.rate'"),
              0U);
    EXPECT_EQ(fault(start + "properties = \"density\"\ndensity = 1.5\n"),
              "t.toml:8: 'density' is 1.5, must be from 0 to 1");
    EXPECT_EQ(fault(start + "properties = \"weight\"\n"),
              "t.toml:7: 'weight' is no property; use some of: density colour material");
    EXPECT_EQ(fault(start + "properties = \" \"\n"),
              "t.toml:7: 'properties' is empty; use some of: density colour material");
    EXPECT_EQ(fault(start + "radius_m = 1\nproperties = \"density\"\ndensity = 1\n"),
              "t.toml:6: 'radius' and 'radius_m' are both given; keep one");
    EXPECT_EQ(fault(start + "properties = \"material\"\nmaterial = \"cheese\"\n"),
              "t.toml:8: there is no material 'cheese'");
    EXPECT_EQ(fault("method = \"constant\"\nextent = \"sphere\"\nradius = 0\nproperties = \"density\"\n"),
              "t.toml:6: 'radius' is 0, must be from 1e-06 to 1000");
    EXPECT_EQ(
        fault("method = \"constant\"\nextent = \"cone\"\n"),
        "t.toml:5: 'extent' must be one of: sphere, box, gaussian, plate, stamp; it is the text \"cone\"");
    EXPECT_EQ(tool_from("version = 1\nname = \"t\"\n").error().message,
              "t.toml:2: the tool has no [[operation]]; add one");
    EXPECT_EQ(tool_from("version = 1\nname = \"\"\n").error().message, "t.toml:2: 'name' must not be empty");
}

TEST(CarvingTools, FiltersFitTheirProperties) {
    const std::string start = "method = \"filter\"\nextent = \"sphere\"\nradius = 3\nrate = 1\n";
    EXPECT_EQ(fault(start + "properties = \"material\"\nmaterial = \"bone\"\nfilter = \"melt\"\n"),
              "t.toml:10: 'melt' and 'construct' change density and nothing else");
    EXPECT_EQ(fault(start + "properties = \"density\"\nfilter = \"mix\"\n"),
              "t.toml:9: 'mix' changes colour and nothing else");
}

TEST(CarvingTools, FaultsOfAStampNameTheLine) {
    const std::string start =
        "method = \"constant\"\nextent = \"stamp\"\nradius = 3\nproperties = \"density\"\n"
        "density = 1\ncells = [2, 1, 1]\n";
    EXPECT_EQ(fault(start + "shape = \"#\"\n"), "t.toml:10: 'shape' has 1 cells instead of 2 as in cells");
    EXPECT_EQ(fault(start + "shape = \"#x\"\n"), "t.toml:10: 'x' is no weight; use . # or a digit");
    EXPECT_EQ(fault("method = \"constant\"\nextent = \"stamp\"\nradius = 3\ncells = [1.5, 1, 1]\n"
                    "shape = \"#\"\nproperties = \"density\"\ndensity = 1\n"),
              "t.toml:7: 'cells' must be three whole numbers");
}

TEST(CarvingTools, AMissingFileIsNamed) {
    const auto tool = load_tool("no/such/tool.toml", shipped_materials());
    ASSERT_FALSE(tool.has_value());
    EXPECT_NE(tool.error().message.find("no/such/tool.toml"), std::string::npos);
}

}  // namespace
}  // namespace thaum::field

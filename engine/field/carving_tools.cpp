#include "field/carving_tools.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "core/file.h"
#include "core/near_name.h"
#include "core/text.h"

namespace thaum::field {
namespace {

constexpr double max_extent = 1000;  // largest extent (voxels or m)
constexpr int max_stamp_edge = 64;   // largest number of cells along an edge of a stamp
constexpr double max_rate = 1e6;     // largest rate at which a property moves towards a constant (1/s)
constexpr std::array<std::string_view, 3> property_names{"density", "colour", "material"};

std::array<bool, 3> as_list(const Properties& p) { return {p.density, p.colour, p.material}; }

Properties read_properties(const ConfigTable& table) {
    Properties found;
    const std::array<bool*, 3> flags{&found.density, &found.colour, &found.material};
    const std::string words = table.string("properties");
    std::string_view remaining = words;
    while (!remaining.empty()) {
        const std::string_view word = remaining.substr(0, remaining.find(' '));
        remaining.remove_prefix(std::min(word.size() + 1, remaining.size()));
        if (word.empty()) continue;
        const auto name = std::ranges::find(property_names, word);
        if (name == property_names.end()) {
            table.report("properties",
                         text("'", word, "' is no property; use some of: density colour material"));
            return found;
        }
        *flags[static_cast<std::size_t>(name - property_names.begin())] = true;
    }
    if (found == Properties{})
        table.report("properties", "'properties' is empty; use some of: density colour material");
    return found;
}

/// Adds the cell for one character of a stamp. Returns false for a character that is not allowed.
bool add_cell(std::vector<float>& weights, char c) {
    if (c == ' ' || c == '\n' || c == '\t' || c == '\r') return true;
    if (c == '.') c = '0';
    if (c != '#' && (c < '0' || c > '9')) return false;
    weights.push_back(c == '#' ? 1.0F : static_cast<float>(c - '0') / 10);
    return true;
}

Stamp read_stamp(const ConfigTable& table) {
    Stamp stamp;
    const vec3 cells = table.vector("cells", {1, max_stamp_edge});
    const std::string shape = table.string("shape");
    std::size_t total = 1;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double n = cells[static_cast<int>(axis)];
        if (n != std::floor(n)) table.report("cells", "'cells' must be three whole numbers");
        stamp.cells[axis] = static_cast<int>(n);
        total *= static_cast<std::size_t>(n);
    }
    for (const char c : shape) {
        if (!add_cell(stamp.weight, c)) {
            table.report("shape", text("'", std::string_view(&c, 1), "' is no weight; use . # or a digit"));
            return stamp;
        }
    }
    if (stamp.weight.size() != total)
        table.report("shape",
                     text("'shape' has ", stamp.weight.size(), " cells instead of ", total, " as in cells"));
    return stamp;
}

Extent read_extent(const ConfigTable& table) {
    Extent extent;
    const auto shape = table.choice("extent", {"sphere", "box", "gaussian", "plate", "stamp"});
    extent.shape = static_cast<ExtentShape>(shape);
    const bool edges = extent.shape == ExtentShape::box || extent.shape == ExtentShape::plate;
    const std::string key = edges ? "half" : "radius";
    extent.in_metres = table.has(key + "_m");
    if (extent.in_metres && table.has(key))
        table.report(key, text("'", key, "' and '", key, "_m' are both given; keep one"));
    const std::string used = extent.in_metres ? key + "_m" : key;
    const Range range{1e-6, max_extent};
    extent.half = edges ? table.vector(used, range) : vec3(table.number(used, range));
    if (extent.shape == ExtentShape::stamp) {
        extent.stamp = read_stamp(table);
        const auto& cells = extent.stamp.cells;
        extent.half *=
            vec3(cells[0], cells[1], cells[2]) / static_cast<double>(*std::ranges::max_element(cells));
    }
    return extent;
}

/// Reads the keys of an operation of the method `filter`. The density towards which melting moves stays 0,
/// its default.
void read_filter(const ConfigTable& table, Operation& operation) {
    enum : std::size_t { melt, construct, mix };
    const auto filter = table.choice("filter", {"melt", "construct", "mix"});
    const Properties fits = filter == mix ? Properties{.colour = true} : Properties{.density = true};
    if (operation.changes != fits) {
        table.report("filter", filter == mix ? "'mix' changes colour and nothing else"
                                             : "'melt' and 'construct' change density and nothing else");
    }
    operation.rate = table.number("rate", {0, max_rate});
    if (filter == construct) operation.density = table.number("density", {0, 1});
}

void read_constants(const ConfigTable& table, const Materials& materials, Operation& operation) {
    const bool constant = operation.method == Method::constant;
    if (constant && operation.changes.density) operation.density = table.number("density", {0, 1});
    if (operation.changes.colour) operation.colour = read_colour(table, "colour");
    if (!operation.changes.material) return;
    const std::string name = table.string("material");
    const auto index = material_index(materials, name);
    if (!index)
        table.report("material", text("there is no material '", name, "'",
                                      did_you_mean(name, materials, &Material::name)));
    operation.material = index.value_or(0);
}

Operation read_operation(const ConfigTable& table, const Materials& materials) {
    Operation operation;
    operation.method = static_cast<Method>(table.choice("method", {"constant", "filter"}));
    operation.extent = read_extent(table);
    operation.changes = read_properties(table);
    if (operation.method == Method::filter) read_filter(table, operation);
    read_constants(table, materials, operation);
    if (table.has("only")) {
        operation.surface_only = true;
        table.choice("only", {"surface"});
    }
    return operation;
}

/// Reports a property that an earlier operation of the tool already changes.
void check_properties(const ConfigTable& table, const std::vector<Operation>& earlier,
                      const Operation& next) {
    const auto changes = as_list(next.changes);
    for (std::size_t i = 0; i < earlier.size(); ++i) {
        const auto taken = as_list(earlier[i].changes);
        for (std::size_t p = 0; p < property_names.size(); ++p) {
            if (!taken[p] || !changes[p]) continue;
            table.report("properties", text("operations ", i + 1, " and ", earlier.size() + 1,
                                            " both change ", property_names[p], "; keep one of them"));
        }
    }
}

/// Reports a tool in which one operation changes the density, and so the surface, while one is limited to
/// voxels at the surface: the result would depend on the order of its operations.
void check_surface(const ConfigTable& root, const std::vector<Operation>& operations) {
    const bool surface = std::ranges::any_of(operations, &Operation::surface_only);
    const bool density = std::ranges::any_of(operations, [](const auto& o) { return o.changes.density; });
    if (surface && density)
        root.report("name", "a tool with only = \"surface\" cannot change density; make it two tools");
}

}  // namespace

Expected<Tool> read_tool(const Config& config, const Materials& materials) {
    const auto root = config.root();
    Tool tool{.name = root.string("name")};
    if (tool.name.empty()) root.report("name", "'name' must not be empty");
    for (const auto& table : root.tables("operation")) {
        const Operation next = read_operation(table, materials);
        check_properties(table, tool.operations, next);
        tool.operations.push_back(next);
        // With more operations than properties, two of them change the same property, which has been
        // reported.
        if (tool.operations.size() > max_operations) break;
    }
    if (tool.operations.empty()) root.report("name", "the tool has no [[operation]]; add one");
    check_surface(root, tool.operations);
    if (auto good = config.check(); !good) return good.error();
    return tool;
}

Expected<Tool> load_tool(const std::filesystem::path& path, const Materials& materials) {
    const auto file = read_text_file(path, max_tool_bytes);
    if (!file) return file.error();
    const auto config = Config::parse(*file, path.string(), tool_file_version);
    if (!config) return config.error();
    return read_tool(*config, materials);
}

Stamp stamp_of(const VoxelView& body, const VoxelBox& box) {
    const VoxelBox inside = overlap(box, body.all());
    Stamp stamp;
    if (inside.empty()) return stamp;
    for (std::size_t axis = 0; axis < 3; ++axis) stamp.cells[axis] = inside.high[axis] - inside.low[axis];
    for_each_row(body, inside, [&](std::size_t first, std::size_t) {
        for (std::size_t i = 0; i < static_cast<std::size_t>(stamp.cells[0]); ++i) {
            const float solid = (body.density[first + i] - body.empty) / (body.full - body.empty);
            stamp.weight.push_back(std::isfinite(solid) ? std::clamp(solid, 0.0F, 1.0F) : 0.0F);
        }
    });
    return stamp;
}

}  // namespace thaum::field

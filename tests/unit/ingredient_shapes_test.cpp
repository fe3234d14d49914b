// Tests of the shapes of ingredients: they can be told apart without colours.
#include "game/scene/ingredient_shapes.h"

#include <bitset>
#include <set>

#include "core/file.h"
#include "core/text.h"
#include "unit/hud_rig.h"
#include "unit/message_of.h"

namespace thaum::game::hud_tests {
namespace {

constexpr int cells = 48, turns = 8;
constexpr float reach = 0.45F;  ///< half the side of the square in which outlines are compared (m)

/// Outline of a shape seen from the side, as covered cells.
using Outline = std::bitset<cells * cells>;

bool is_within(fvec2 p, const std::array<fvec2, 3>& corners) {
    std::array<float, 3> side{};
    for (std::size_t i = 0; i < 3; ++i) {
        const fvec2 a = corners[i], along = corners[(i + 1) % 3] - a, to = p - a;
        side[i] = along.x * to.y - along.y * to.x;
    }
    const auto [least, most] = std::minmax({side[0], side[1], side[2]});
    return least >= 0 || most <= 0;
}

Outline outline_of(IngredientShape shape, int turn) {
    const auto mesh = render::transformed(
        ingredient_mesh(shape), render::rotated({0, 1, 0}, 6.2832F * static_cast<float>(turn) / turns));
    Outline outline;
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        std::array<fvec2, 3> corners;
        for (std::size_t k = 0; k < 3; ++k) corners[k] = fvec2(mesh.vertices[mesh.indices[i + k]].position);
        for (int cell = 0; cell < cells * cells; ++cell) {
            const int row = cell / cells;
            const fvec2 at(static_cast<float>(cell % cells) + 0.5F, static_cast<float>(row) + 0.5F);
            if (is_within(reach * (2.0F / cells * at - 1.0F), corners))
                outline.set(static_cast<std::size_t>(cell));
        }
    }
    return outline;
}

/// Largest similarity of two shapes' outlines seen from any two sides: the overlap as a share of the area
/// that either covers.
double likeness(IngredientShape one, IngredientShape other) {
    double most = 0;
    for (int a = 0; a < turns; ++a) {
        const auto first = outline_of(one, a);
        for (int b = 0; b < turns; ++b) {
            const auto second = outline_of(other, b);
            most = std::max(most, static_cast<double>((first & second).count()) /
                                      static_cast<double>((first | second).count()));
        }
    }
    return most;
}

Config cauldron_file(std::string_view from = "", std::string_view to = "") {
    auto words = *read_text_file(assets / "cauldron.toml", 1U << 16U);
    if (!from.empty()) words.replace(words.find(from), from.size(), to);
    return *Config::parse(words, "cauldron.toml", 1);
}

TEST(IngredientShapes, DifferInOutlineFromEverySide) {
    for (std::size_t i = 0; i < ingredient_shapes; ++i) {
        for (std::size_t j = i + 1; j < ingredient_shapes; ++j) {
            const auto like = likeness(static_cast<IngredientShape>(i), static_cast<IngredientShape>(j));
            EXPECT_LT(like, 0.65) << "shapes " << i << " and " << j;
        }
    }
}

TEST(IngredientShapes, FillTheirPlaceAndNoMore) {
    for (std::size_t i = 0; i < ingredient_shapes; ++i) {
        const auto size = render::bounds(ingredient_mesh(static_cast<IngredientShape>(i)));
        EXPECT_LT(glm::length(size.centre) + size.radius, 0.52F) << i;
        EXPECT_GT(size.radius, 0.2F) << i;
    }
}

TEST(IngredientShapes, AreOneForEachShippedIngredient) {
    const auto rules = read_cauldron_rules(cauldron_file());
    std::set<IngredientShape> shapes;
    for (const auto& ingredient : rules.ingredients) shapes.insert(ingredient.shape);
    EXPECT_EQ(shapes.size(), rules.ingredients.size());
    EXPECT_EQ(shapes.size(), ingredient_shapes);
}

TEST(IngredientShapes, OfNichesAreInThePicture) {
    std::set<IngredientShape> shapes;
    for (const auto& niche : picture_of(*new_match()).niches) shapes.insert(niche.shape);
    EXPECT_EQ(shapes.size(), ingredient_shapes);
}

/// First fault in a file in which `from` is replaced by `to`.
std::string fault_of(std::string_view from, std::string_view to) {
    const auto file = cauldron_file(from, to);
    read_cauldron_rules(file);
    return message_of(file.check());
}

TEST(IngredientShapes, WrongWordIsReportedInOneLine) {
    EXPECT_EQ(
        fault_of("salt = \"crystals\"", "salt = \"cubes\""),
        "cauldron.toml:111: 'salt' must be one of: heap, crystals, ingots, drops, feathers, cloud, cushion; "
        "it is the text \"cubes\"");
    EXPECT_EQ(fault_of("salt = \"crystals\"", "gold = \"crystals\"")
                  .find("cauldron.toml:111: unknown key 'look.gold'"),
              0U);
    EXPECT_EQ(fault_of("salt = \"crystals\"", ""), "") << "the heap is the default";
}

}  // namespace
}  // namespace thaum::game::hud_tests

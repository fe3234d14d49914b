// game/scene/ingredient_shapes.h: the meshes of ingredients. Each shape has an outline of its own, so that
// ingredients are recognised without their colour.
#pragma once
#include "game/data/cauldron_rules.h"
#include "render/mesh.h"

namespace thaum::game::inline scene {

/// Mesh of an ingredient around its position, within 0.5 m: white, to be tinted with the ingredient's colour.
render::MeshData ingredient_mesh(IngredientShape shape);

/// Share of its own light with which a shape is drawn. Pale ingredients have little, so that their faces stay
/// visible.
float ingredient_glow(IngredientShape shape);

}  // namespace thaum::game::inline scene

// unit/audio_recipes.h: short sound recipes (texts from which sounds are computed) for tests.
#pragma once
#include <gtest/gtest.h>

#include "audio/synth.h"
#include "core/text.h"
#include "unit/message_of.h"

namespace thaum::audio {

/// The first lines of a sound recipe, before its parts.
inline std::string head(double seconds, bool loops = false) {
    return text("version = 1\ndescription = \"test\"\ngroup = \"effects\"\nseconds = ", seconds,
                "\nlevel = 0.8\nloops = ", loops, "\n");
}

inline std::string part(std::string_view kind, std::string_view keys) {
    return text("[[parts]]\nkind = \"", kind, "\"\n", keys, "\n");
}

inline Sound made(const std::string& toml) {
    const auto recipe = read_recipe(toml, "test");
    EXPECT_TRUE(recipe.has_value()) << (recipe ? "" : recipe.error().message);
    return recipe ? make_sound(*recipe) : Sound{};
}

/// Message of a refused sound recipe; empty: none.
inline std::string refusal(const std::string& toml) { return message_of(read_recipe(toml, "test")); }

}  // namespace thaum::audio

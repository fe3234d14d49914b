// structure/functions.h: finds the functions of a C++ source by the shape of its text, without a compiler.
#pragma once
#include <cstddef>
#include <string>
#include <vector>

namespace thaum::structure {

/// Place of a function in its file, from the first line of its signature to its closing brace.
struct FunctionExtent {
    std::size_t line;   ///< first line, counted from 1
    std::size_t count;  ///< number of lines
};

/// All functions at namespace and class scope, in order. Lambdas and local classes count as part of the
/// function around them. A lambda that initialises a variable at namespace scope counts as data.
std::vector<FunctionExtent> functions_in(const std::string& source);

}  // namespace thaum::structure

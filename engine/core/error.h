// core/error.h: errors as values, one clear line each, for a wrong file, device or option.
#pragma once
#include <string>
#include <tl/expected.hpp>
#include <utility>

namespace thaum {

/// One line for the user: what is wrong, where, and what to do. It has no trailing newline.
struct Error {
    std::string message;
};

/// Return type of functions that may fail. Faults from outside (files, devices, options) are Errors; our own
/// mistakes are assertions (core/assert.h).
template <class T>
using Expected = tl::expected<T, Error>;

inline tl::unexpected<Error> fail(std::string message) { return tl::unexpected(Error{std::move(message)}); }

}  // namespace thaum

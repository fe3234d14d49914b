// core/error.h: how a wrong file, device or option travels: as a value with one clear line.
#pragma once
#include <string>
#include <tl/expected.hpp>
#include <utility>

namespace thaum {

/// One line for the user: what is wrong, where, and what to do. No trailing newline.
struct Error {
    std::string message;
};

/// What loading returns. Our own mistakes are assertions (core/assert.h), the world's are Errors.
template <class T>
using Expected = tl::expected<T, Error>;

inline tl::unexpected<Error> fail(std::string message) { return tl::unexpected(Error{std::move(message)}); }

}  // namespace thaum

// core/error.h: errors as values, one clear line each, for a wrong file, device or option.
#pragma once
#include <concepts>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/assert.h"

namespace thaum {

/// One line for the user: what is wrong, where, and what to do. It has no trailing newline.
struct Error {
    std::string message;
    /// More lines about further faults of the same file or folder. Most users need only the first line.
    std::vector<std::string> more{};
};

template <class T>
class Expected;

/// A line of our sources. Clang 14 has no std::source_location.
struct CodeLine {
    const char* file;
    int line;
    /// As the default argument of a function, this gives the line of code that calls that function.
    static constexpr CodeLine here(const char* file = __builtin_FILE(), int line = __builtin_LINE()) {
        return {file, line};
    }
};

/// Prints "file:line: message" of the error to standard error and aborts.
[[noreturn]] void no_value(const Error& error, CodeLine asking);

/// ValueFor<U, T> holds if the value of an Expected<T> can be made from a U. For errors and for another
/// Expected it does not: they have constructors of their own.
template <class U, class T>
concept ValueFor = std::is_constructible_v<T, U> && std::is_convertible_v<U, T> &&
                   !std::is_same_v<std::remove_cvref_t<U>, Expected<T>> &&
                   !std::is_same_v<std::remove_cvref_t<U>, Error>;

/// Expected<T> holds either a value or an Error. It is the return type of functions that may fail. Faults
/// from outside (files, devices, options) are Errors. Our own mistakes, such as asking for a value where
/// there is an error, are assertions (core/assert.h), which print that error and the line that asked.
/// Expected has those parts of C++23's std::expected that we use, under the same names, and no more, because
/// it is compiled for two hundred types.
template <class T>
class [[nodiscard]] Expected {
public:
    Expected() requires std::default_initializable<T> : holds_(true) { std::construct_at(&value_); }
    template <ValueFor<T> U = T>
    Expected(U&& value)  // NOLINT(bugprone-forwarding-reference-overload)
        : value_(std::forward<U>(value)), holds_(true) {}
    Expected(Error error) : error_(std::move(error)), holds_(false) {}
    Expected(const Expected& other) requires std::copy_constructible<T> : holds_(other.holds_) {
        if (holds_)
            std::construct_at(&value_, other.value_);
        else
            std::construct_at(&error_, other.error_);
    }
    Expected(Expected&& other) noexcept : holds_(other.holds_) {
        if (holds_)
            std::construct_at(&value_, std::move(other.value_));
        else
            std::construct_at(&error_, std::move(other.error_));
    }
    Expected& operator=(const Expected& other) requires std::copy_constructible<T> {
        if (this != &other) *this = Expected(other);
        return *this;
    }
    Expected& operator=(Expected&& other) noexcept {
        if (this == &other) return *this;
        std::destroy_at(this);
        return *std::construct_at(this, std::move(other));
    }
    ~Expected() {
        if (holds_)
            std::destroy_at(&value_);
        else
            std::destroy_at(&error_);
    }

    /// Whether there is a value and no error.
    bool has_value() const { return holds_; }
    explicit operator bool() const { return holds_; }
    T& operator*() & { return value(); }
    const T& operator*() const& { return value(); }
    T&& operator*() && { return std::move(value()); }
    T* operator->() { return &value(); }
    const T* operator->() const { return &value(); }
    /// The value. Asking for it where there is an error is a defect of the caller, whose line the message
    /// names.
    T& value(CodeLine asking = CodeLine::here()) & { return check_value(asking), value_; }
    const T& value(CodeLine asking = CodeLine::here()) const& { return check_value(asking), value_; }
    T&& value(CodeLine asking = CodeLine::here()) && { return check_value(asking), std::move(value_); }
    /// The value, or `other` if there is an error.
    T value_or(T other) const& { return holds_ ? value_ : std::move(other); }
    T value_or(T other) && { return holds_ ? std::move(value_) : std::move(other); }
    Error& error() & { return check_error(), error_; }
    const Error& error() const& { return check_error(), error_; }
    Error&& error() && { return check_error(), std::move(error_); }

private:
    void check_value(CodeLine asking) const {
        if (!holds_) [[unlikely]]
            no_value(error_, asking);
    }
    void check_error() const { THAUM_ASSERT(!holds_, "an error that is not there"); }

    union {
        T value_;
        Error error_;
    };
    bool holds_;
};

/// Compares the value with another one. An error equals no value.
template <class T, class U>
requires requires(const T& value, const U& other) { value == other; }
bool operator==(const Expected<T>& expected, const U& other) {
    return expected.has_value() && *expected == other;
}

/// Expected<void> holds either nothing, which is success, or an Error.
template <>
class [[nodiscard]] Expected<void> {
public:
    Expected() = default;
    Expected(Error error) : error_(std::move(error)), holds_(false) {}

    /// Whether there is no error.
    bool has_value() const { return holds_; }
    explicit operator bool() const { return holds_; }
    /// The error. Asking for it where there is none is a defect of the caller.
    Error& error() & { return checked(), error_; }
    const Error& error() const& { return checked(), error_; }
    Error&& error() && { return checked(), std::move(error_); }

private:
    void checked() const { THAUM_ASSERT(!holds_, "an error that is not there"); }

    Error error_;
    bool holds_ = true;
};

/// Makes an error of one line.
inline Error fail(std::string message) { return {std::move(message)}; }

/// A data file that is left out because of its faults: its name, without folder and extension, and the
/// faults.
struct LeftOut {
    std::string name;
    Error fault;
};

/// All lines of an error: its message, then those on further faults.
std::vector<std::string> lines_of(const Error& error);

/// Adds the faults of `next` that `error` does not have yet.
void add_faults(std::optional<Error>& error, const Error& next);

}  // namespace thaum

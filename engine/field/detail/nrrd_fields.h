// field/detail/nrrd_fields.h: the lines of an NRRD header, and values in them.
#pragma once
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"
#include "core/maths.h"

namespace thaum::field {

/// The one key/value pair that is kept; NrrdFields gives its value by this name.
inline constexpr std::string_view key_of_save = "thaum save";

/// Fields of a header by name. Keeps the first fault, so that a reader asks for all values as if the header
/// were correct and checks once.
class NrrdFields {
public:
    /// `file` begins with the header. The error names `name`, which is the path, and the line.
    static Expected<NrrdFields> parse(std::string_view file, std::string name);

    /// Position behind the header and its empty line. std::nullopt: the file ends with the header.
    std::optional<std::size_t> end() const { return end_; }
    bool has(std::string_view field) const { return fields_.contains(field); }
    /// Text of a field; empty if the field is missing.
    std::string_view text_of(std::string_view field) const;

    /// Reads an integer within [low, high]; `fallback` if the field is missing.
    long integer(std::string_view field, long low, long high, long fallback);
    /// Reads words without blanks: 128 128 54.
    std::vector<std::string_view> words(std::string_view field) const;
    /// Reads numbers; NaN stands for a word that is no number. Reports a wrong count.
    std::vector<double> numbers(std::string_view field, std::size_t count);
    /// Reads words in quotes: "mm" "mm" "mm".
    std::vector<std::string> quoted(std::string_view field, std::size_t count);
    /// Reads vectors of three numbers: none (1,0,0) (0,1,0) (0,0,1). Reports a wrong count or form.
    std::vector<std::optional<vec3>> vectors(std::string_view field, std::size_t count);
    /// Reads one of the names in any case, and returns its index. Reports a missing field or another name.
    std::size_t choice(std::string_view field, std::string_view names_for_message,
                       const std::vector<std::vector<std::string_view>>& names);

    /// Reports a fault of a field; a missing one if the header lacks it.
    void report(std::string_view field, std::string_view message);
    Expected<void> check() const;

private:
    struct Line {
        std::string value;
        std::size_t number{};
        std::string name{};  ///< name of the field as the file writes it
    };
    explicit NrrdFields(std::string name) : name_(std::move(name)) {}
    Expected<void> add(std::string_view line, std::size_t number);
    Error at_line(std::size_t number, std::string_view message) const;

    std::string name_;
    std::map<std::string, Line, std::less<>> fields_;
    std::optional<std::size_t> end_;
    std::optional<Error> fault_;
};

}  // namespace thaum::field

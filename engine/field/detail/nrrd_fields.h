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

/// Longest header that is read (bytes). Key/value pairs of segmentations take hundreds of kilobytes.
inline constexpr std::size_t longest_header = std::size_t{4} << 20U;

/// Name of the only key/value pair that is read: files with the same value belong to one saved body.
/// NrrdFields treats the pair like a field of the header.
inline constexpr std::string_view key_of_save = "thaum save";

/// Fields of a header by name. Keeps the first fault, so that a reader can ask for all values as if the
/// header were correct and check once.
class NrrdFields {
public:
    /// `file` begins with the header. The error names `name`, which is the path, and the line.
    static Expected<NrrdFields> parse(std::string_view file, std::string name);

    /// Position after the header and its empty line. std::nullopt: the file ends with the header.
    std::optional<std::size_t> end() const { return end_; }
    bool has(std::string_view field) const { return fields_.contains(field); }
    /// Whether the header ends with "data file: LIST" and names of files.
    bool lists_files() const;
    /// A file of samples that the header names, and the line that names it.
    struct ListedFile {
        std::string name;
        std::size_t line{};
    };
    /// Files named in the lines after "data file: LIST".
    const std::vector<ListedFile>& listed_files() const { return listed_files_; }
    /// Number of the line of each field, by the field's name as the format writes it, such as "space
    /// directions".
    std::map<std::string, std::size_t, std::less<>> lines() const;
    /// Number of the line that holds a field; 0 if the field is missing.
    std::size_t line_of(std::string_view field) const;
    /// Text of a field; empty if the field is missing.
    std::string_view text_of(std::string_view field) const;

    /// Reads an integer within [low, high]; `fallback` if the field is missing.
    long integer(std::string_view field, long low, long high, long fallback);
    /// Reads words without blanks: 128 128 54.
    std::vector<std::string_view> words(std::string_view field) const;
    /// Reads numbers. "nan", "none" and "???" mean that a number is not given: std::nullopt. Reports a wrong
    /// count and a word that is no number.
    std::vector<std::optional<double>> numbers(std::string_view field, std::size_t count);
    /// Reads words in quotes: "mm" "mm" "mm".
    std::vector<std::string> quoted(std::string_view field, std::size_t count);
    /// Reads vectors of three numbers: none (1,0,0) (0,1,0) (0,0,1); (nan,nan,nan) is
    /// none. Reports a wrong count or form.
    std::vector<std::optional<vec3>> vectors(std::string_view field, std::size_t count);
    /// Reads one of the names in any case, and returns its index. Reports a missing field or another name.
    std::size_t choice(std::string_view field, std::string_view names_for_message,
                       const std::vector<std::vector<std::string_view>>& names);

    /// Reports a fault of a field, or that the field is missing if the header lacks it.
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
    std::vector<ListedFile> listed_files_;
    std::optional<std::size_t> end_;
    /// Number of the empty line that ends the header, or of the last line of the file.
    std::size_t last_line_{1};
    std::optional<Error> fault_;
};

/// Text with ASCII letters in lower case.
std::string in_lower_case(std::string_view s);

/// Reads a number that may begin with '+'; NaN for any other word.
double number_of(std::string_view word);

}  // namespace thaum::field

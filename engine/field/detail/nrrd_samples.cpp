#include "field/detail/nrrd_samples.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <utility>

#include "core/gzip.h"
#include "core/one_line.h"
#include "core/text.h"
#include "field/detail/nrrd_fields.h"
#include "field/detail/sample_file.h"
#include "field/detail/samples.h"

namespace thaum::field {
namespace {

/// Largest ratio of unpacked to packed bytes that a header may promise. Deflate packs at most 1,032 bytes
/// into one; this allows a little more.
constexpr std::size_t max_packed = 1040;
/// Largest number of unpacked bytes that may precede samples at the end of gzip data.
constexpr std::size_t max_before_end = std::size_t{64} << 20U;

using Path = std::filesystem::path;

std::string_view characters_of(std::span<const std::byte> bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// The stored samples of one file.
struct FileOfSamples {
    Path path;
    FileReader* file{};
    std::size_t begin{};    ///< position of the first byte after the header and the skipped lines
    std::size_t bytes{};    ///< number of bytes from `begin` to the end of the file
    Bytes start{};          ///< first bytes from `begin` on, at most `start_bytes`
    std::size_t samples{};  ///< number of samples that the header promises
};

/// Number of bytes at the start of the samples by which another encoding is recognised.
constexpr std::size_t start_bytes = 256;
/// Number of bytes that are read at once. So the bytes and the floats that they become stay in the cache.
constexpr std::size_t piece_bytes = std::size_t{1} << 17U;

/// Position after `lines` more lines of a file, or its end.
Expected<std::size_t> after_lines(FileReader& file, std::size_t position, std::size_t lines) {
    Bytes piece(lines > 0 ? piece_bytes : 0);
    file.go_to(position);
    while (lines > 0) {
        const auto count = file.read(piece);
        if (!count) return count.error();
        for (std::size_t i = 0; i < *count && lines > 0; ++i, ++position)
            if (piece[i] == std::byte{'\n'}) --lines;
        if (*count < piece.size()) break;
    }
    return position;
}

/// Notes that the samples begin at this position of the file, and reads the first bytes there.
Expected<void> begin_at(FileOfSamples& samples, std::size_t begin) {
    FileReader& file = *samples.file;
    samples.begin = std::min(begin, file.size());
    samples.bytes = file.size() - samples.begin;
    samples.start.resize(std::min(samples.bytes, start_bytes));
    file.go_to(samples.begin);
    const auto count = file.read(samples.start);
    if (!count) return count.error();
    samples.start.resize(*count);
    file.go_to(samples.begin);
    return {};
}

/// Name of the file in messages: "ball.raw" for a separate file of samples, "the file" for one that also
/// holds the header.
std::string name_in_message(const NrrdHeader& header, const FileOfSamples& file) {
    return header.data_files.empty() ? "the file" : file.path.filename().string();
}

// ---- bytes of another encoding ----------------------------------------------------------------------------

/// A format that can be recognised by the first bytes of a file, and advice if the header promises another
/// one.
struct Form {
    std::string_view begins;
    std::string_view name;
    std::string_view advice;
};
constexpr std::string_view as_gzip = "write 'encoding: gzip'";
constexpr std::string_view unpack_them = "unpack them and write 'encoding: raw'";
constexpr std::array forms{Form{"\x1f\x8b\x08", "gzip", as_gzip},
                           Form{"BZh", "bzip2", unpack_them},
                           Form{"PK\x03\x04", "zip", unpack_them},
                           Form{"\xfd"
                                "7zXZ",
                                "xz", unpack_them},
                           Form{"(\xb5/\xfd", "zstd", unpack_them},
                           Form{"\x78\x9c", "zlib", unpack_them},
                           Form{"\x78\xda", "zlib", unpack_them},
                           Form{"\x78\x01", "zlib", unpack_them}};

/// True if the bytes begin with several numbers in text.
bool begins_with_numbers(std::string_view bytes) {
    constexpr std::string_view of_numbers = "0123456789+-.eE", between = " \t\r\n,";
    constexpr std::size_t looked_at = 256, few = 4;
    const auto start = bytes.substr(0, looked_at);
    const auto within = [](std::string_view all) {
        return [all](char c) { return all.find(c) != std::string_view::npos; };
    };
    return start.size() >= few && std::ranges::any_of(start, within(between)) &&
           std::ranges::any_of(start, within("0123456789")) &&
           std::ranges::all_of(start, [&](char c) { return within(of_numbers)(c) || within(between)(c); });
}

/// True if the bytes begin with text only.
bool begins_with_text(std::string_view bytes) {
    return std::ranges::all_of(bytes.substr(0, 256), [](char c) {
        return (c >= ' ' && c <= '~') || c == '\t' || c == '\r' || c == '\n';
    });
}

/// Says what the bytes are and what to do, if their encoding clearly differs from the header's; else empty.
std::string other_encoding(const NrrdHeader& header, const FileOfSamples& file) {
    const auto bytes = characters_of(file.start);
    const auto is = [&](std::string_view what, std::string_view advice) {
        return text("the samples in ", name_in_message(header, file), " are ", what, "; ", advice);
    };
    const std::size_t skipped = header.skipped_bytes < 0 ? 0 : static_cast<std::size_t>(header.skipped_bytes);
    const bool may_be_plain = header.encoding != NrrdEncoding::raw && !begins_with_text(bytes);
    if (may_be_plain && file.bytes == skipped + size_of(header.type) * file.samples)
        return is("as many plain bytes as the sizes and the type promise", "write 'encoding: raw'");
    for (const Form& form : forms) {
        // A zlib stream is known by two bytes only, with which plain samples may begin, too. So these two
        // count only if the header promises gzip.
        const bool sure = form.begins.size() > 2 || header.encoding == NrrdEncoding::gzip;
        if (sure && bytes.starts_with(form.begins)) return is(text(form.name, " bytes"), form.advice);
    }
    if (header.encoding != NrrdEncoding::ascii && begins_with_numbers(bytes))
        return is("numbers in text", "write 'encoding: ascii'");
    return {};
}

/// Says how many bytes there are for each sample, if that is the size of another type than the header's; else
/// empty.
std::string other_type(const NrrdHeader& header, std::size_t samples, std::size_t there) {
    const std::size_t own = size_of(header.type);
    for (const std::size_t size : {1U, 2U, 4U, 8U})
        if (size != own && there == size * samples)
            return text("; there are ", size, " for each sample, but 'type' has ", own);
    return {};
}

Error too_few(const NrrdHeader& header, const FileOfSamples& file, std::string_view what,
              std::size_t promised, std::size_t there) {
    const auto in = header.data_files.empty() ? "" : text(" in ", file.path.filename().string());
    const auto type = what == "bytes" ? other_type(header, file.samples, there) : "";
    return fail_field(
        header, "sizes",
        text("the header promises ", promised, " ", what, " of samples, but there are ", there, in, type,
             "; correct ", type.empty() ? "the sizes" : "type or sizes", " or copy the file again"));
}

/// Says that the header seems to have an empty line too many, if the bytes after it begin with a line break;
/// else empty.
std::string_view line_too_many(const NrrdHeader& header, const FileOfSamples& file) {
    const auto bytes = characters_of(file.start);
    const bool begins_so = bytes.starts_with("\n") || bytes.starts_with("\r\n");
    return begins_so && header.data_files.empty() ? "; the header seems to have an empty line too many" : "";
}

void note_more(const NrrdHeader& header, const FileOfSamples& file, std::vector<std::string>& notes) {
    const auto where = header.data_files.empty() ? "" : text(file.path.filename().string(), ": ");
    const auto type =
        header.encoding == NrrdEncoding::raw ? other_type(header, file.samples, file.bytes) : "";
    // If at most two bytes are too many, they may be a line break before the samples, which would shift all
    // of them.
    const bool one_line_more =
        header.encoding == NrrdEncoding::raw && file.bytes <= size_of(header.type) * file.samples + 2;
    const auto ends = one_line_more ? line_too_many(header, file) : "";
    notes.push_back(in_one_line(text(where, "what follows the samples is left out", type, ends)));
}

// ---- reading ----------------------------------------------------------------------------------------------

/// Reads `count` bytes in pieces by read(span), which returns how many it has read. Passes them to the
/// decoder, or skips them if it is null. Returns how many there were.
template <class Read>
Expected<std::size_t> pass_on(std::size_t count, SampleDecoder* decoder, Read read) {
    Bytes piece(std::min(count, piece_bytes));
    std::size_t done = 0;
    while (done < count) {
        const auto wanted = std::span(piece).first(std::min(piece.size(), count - done));
        const Expected<std::size_t> n = read(wanted);
        if (!n) return n.error();
        done += *n;
        if (*n < wanted.size()) break;
        if (decoder != nullptr) decoder->take(wanted);
    }
    return done;
}

/// Reads the bytes of a file unpacked, from the file's position on.
GzipReader unpacked(FileReader& file) {
    return {[&file](std::span<std::byte> out) { return file.read(out); }, GzipReader::Rest::ignored};
}

Error gzip_fault(const FileOfSamples& file, const Error& error) {
    return fail(in_one_line(text(file.path.string(), ": ", error.message)));
}

Expected<std::size_t> skip_unpacked(const FileOfSamples& file, GzipReader& reader, std::size_t count) {
    auto skipped = pass_on(count, nullptr, [&](std::span<std::byte> out) { return reader.read(out); });
    if (!skipped) return gzip_fault(file, skipped.error());
    return skipped;
}

/// Number of unpacked bytes that lie before the samples, which are at the end of the data.
Expected<std::size_t> bytes_before(const NrrdHeader& header, const FileOfSamples& file,
                                   std::size_t promised) {
    GzipReader reader = unpacked(*file.file);
    const auto all = skip_unpacked(file, reader, promised + max_before_end);
    if (!all) return all.error();
    if (*all < promised) return too_few(header, file, "bytes", promised, *all);
    const auto more = skip_unpacked(file, reader, 1);
    if (!more) return more.error();
    if (*more > 0 || reader.is_followed())
        return fail_field(header, "byte skip",
                          text("more than ", max_before_end, " bytes are packed before the samples"));
    file.file->go_to(file.begin);
    return *all - promised;
}

/// Refuses bytes that are no gzip data, or are too few for the samples that the header promises.
Expected<void> check_packed(const NrrdHeader& header, const FileOfSamples& file, std::size_t promised) {
    if (!characters_of(file.start).starts_with("\x1f\x8b")) {
        if (const auto other = other_encoding(header, file); !other.empty())
            return fail_field(header, "encoding", other);
        return fail_field(header, "encoding",
                          text("the samples in ", name_in_message(header, file), " are no gzip bytes",
                               line_too_many(header, file)));
    }
    if (promised / max_packed > file.bytes)
        return fail_field(header, "sizes",
                          text("the header promises ", promised, " bytes of samples, but ", file.bytes,
                               " bytes cannot hold them; copy the file again"));
    return {};
}

/// Unpacks gzip data and leaves out the skipped bytes, which are counted after unpacking.
Expected<void> decode_packed(const NrrdHeader& header, const FileOfSamples& file, SampleDecoder& decoder,
                             std::vector<std::string>& notes) {
    const std::size_t promised = size_of(header.type) * file.samples;
    if (auto fits = check_packed(header, file, promised); !fits) return fits;
    const auto before = header.skipped_bytes < 0
                            ? bytes_before(header, file, promised)
                            : Expected<std::size_t>(static_cast<std::size_t>(header.skipped_bytes));
    if (!before) return before.error();
    GzipReader reader = unpacked(*file.file);
    const auto skipped = skip_unpacked(file, reader, *before);
    if (!skipped) return skipped.error();
    const auto count =
        pass_on(promised, &decoder, [&](std::span<std::byte> out) { return reader.read(out); });
    if (!count) return gzip_fault(file, count.error());
    if (*count < promised) return too_few(header, file, "bytes", promised, *count);
    const auto more = skip_unpacked(file, reader, 1);
    if (!more) return more.error();
    if (*more > 0 || reader.is_followed()) note_more(header, file, notes);
    return {};
}

/// Decodes bytes that are stored as they are.
Expected<void> decode_plain(const NrrdHeader& header, FileOfSamples file, SampleDecoder& decoder,
                            std::vector<std::string>& notes) {
    const std::size_t promised = size_of(header.type) * file.samples;
    const std::size_t before = header.skipped_bytes >= 0 ? static_cast<std::size_t>(header.skipped_bytes)
                               : file.bytes > promised   ? file.bytes - promised
                                                         : 0;
    if (auto begun = begin_at(file, file.begin + before); !begun) return begun;
    if (file.bytes != promised) {
        if (const auto other = other_encoding(header, file); !other.empty())
            return fail_field(header, "encoding", other);
    }
    const auto count = file.bytes < promised ? Expected<std::size_t>(file.bytes)
                                             : decode_bytes(*file.file, promised, decoder);
    if (!count) return Error{in_one_line(count.error().message)};
    if (*count < promised) return too_few(header, file, "bytes", promised, *count);
    if (file.bytes > promised) note_more(header, file, notes);
    return {};
}

/// Truncates a number to an integer and limits it to the range of the type.
double whole_number(double value, SampleType type) {
    const auto [low, high] = limits_of(type);
    return std::clamp(std::trunc(value), low, high);
}

constexpr std::string_view between_numbers = " \t\r\n,";

/// Reads a word of a text as a number, which may also be NaN.
Expected<double> value_of(const FileOfSamples& file, std::string_view word, std::size_t place) {
    const double value = number_of(word);
    if (!std::isnan(value) || in_lower_case(word).find("nan") != std::string::npos) return value;
    return fail(in_one_line(
        text(file.path.string(), ": '", printable(word, 40), "' at place ", place, " is no number",
             word.find(';') == std::string_view::npos ? "" : "; write points, and blanks between")));
}

/// Decodes the numbers at the start of `remaining`, as doubles. They are separated by blanks or commas.
Expected<void> decode_numbers(const NrrdHeader& header, const FileOfSamples& file,
                              std::string_view& remaining, SampleDecoder& decoder,
                              std::vector<std::string>& notes) {
    std::vector<double> waiting;
    const auto pass_on_waiting = [&] {
        decoder.take(std::as_bytes(std::span(waiting)));
        waiting.clear();
    };
    bool changed = false;
    for (std::size_t n = 0; n < file.samples; ++n) {
        remaining.remove_prefix(std::min(remaining.size(), remaining.find_first_not_of(between_numbers)));
        const auto word = remaining.substr(0, remaining.find_first_of(between_numbers));
        if (word.empty()) return too_few(header, file, "numbers", file.samples, n);
        const auto number = value_of(file, word, n + 1);
        if (!number) return number.error();
        double value = *number;
        if (header.type < SampleType::float32) {
            value = whole_number(value, header.type);
            if (value != *number && !changed)
                notes.push_back(
                    in_one_line(text("samples such as ", printable(word, 40), " are no numbers of the type '",
                                     name_of(header.type), "', and are made so")));
            changed = changed || value != *number;
        }
        waiting.push_back(value);
        if (waiting.size() * sizeof(double) == piece_bytes) pass_on_waiting();
        remaining.remove_prefix(word.size());
    }
    pass_on_waiting();
    return {};
}

/// Decodes numbers written as text.
Expected<void> decode_text(const NrrdHeader& header, const FileOfSamples& file, SampleDecoder& decoder,
                           std::vector<std::string>& notes) {
    Bytes all(file.bytes);
    const auto count = file.file->read(all);
    if (!count) return Error{in_one_line(count.error().message)};
    const auto skipped = std::min(*count, static_cast<std::size_t>(header.skipped_bytes));
    std::string_view remaining = characters_of(std::span(all).first(*count).subspan(skipped));
    if (auto done = decode_numbers(header, file, remaining, decoder, notes); !done) {
        const auto encoding = other_encoding(header, file);
        return encoding.empty() ? done.error() : fail_field(header, "encoding", encoding);
    }
    const auto more = remaining.find_first_not_of(between_numbers);
    if (more != std::string_view::npos && remaining.find(',') != std::string_view::npos)
        return fail_field(header, "sizes",
                          text("there are more than the ", file.samples,
                               " numbers that the header promises; numbers have points, not commas"));
    if (more != std::string_view::npos) note_more(header, file, notes);
    return {};
}

/// Decodes the samples of one file, which begin at `position` or behind skipped lines.
Expected<void> decode_file(const NrrdHeader& header, FileOfSamples file, std::size_t position,
                           SampleDecoder& decoder, std::vector<std::string>& notes) {
    const auto begin = after_lines(*file.file, position, header.skipped_lines);
    if (!begin) return Error{in_one_line(begin.error().message)};
    if (auto begun = begin_at(file, *begin); !begun) return Error{in_one_line(begun.error().message)};
    switch (header.encoding) {
        case NrrdEncoding::ascii: return decode_text(header, file, decoder, notes);
        case NrrdEncoding::gzip: return decode_packed(header, file, decoder, notes);
        case NrrdEncoding::raw: return decode_plain(header, std::move(file), decoder, notes);
    }
    return {};
}

/// Opens one of the files that a header names, and adds its path to the volume. A file of more than
/// `max_bytes` is refused unless the header says where its samples end.
Expected<FileReader> open_named(const NrrdHeader& header, const Path& path, const NrrdDataFile& named,
                                std::size_t max_bytes, Volume& volume) {
    const auto place = sample_file(path, named.name);
    std::error_code ignored;
    if (!std::filesystem::exists(place, ignored))
        return fail(in_one_line(text(header.path, ":", named.line, ": field 'data file': there is no file '",
                                     printable(named.name, 200), "'; put it beside the header, or name one (",
                                     place.lexically_normal().string(), " was looked for)")));
    if (const auto note = note_on_place(path, named.name, place); !note.empty() && volume.files.size() == 1)
        volume.notes.push_back(note);
    const bool ends_known =
        header.encoding == NrrdEncoding::raw && header.skipped_lines == 0 && header.skipped_bytes >= 0;
    auto file = ends_known ? FileReader::open(place) : FileReader::open(place, max_bytes);
    if (!file)
        return Error{
            in_one_line(text(header.path, ":", named.line, ": field 'data file': ", file.error().message))};
    volume.files.push_back(place);
    return file;
}

}  // namespace

Expected<std::size_t> decode_bytes(FileReader& file, std::size_t count, SampleDecoder& decoder) {
    return pass_on(count, &decoder, [&](std::span<std::byte> out) { return file.read(out); });
}

Expected<void> read_nrrd_samples(const NrrdHeader& header, const Path& path, FileReader& file,
                                 std::size_t max_bytes, SampleDecoder& decoder, Volume& volume) {
    volume.files = {path};
    if (header.data_files.empty())
        return decode_file(header, {.path = path, .file = &file, .samples = header.stored}, header.data_at,
                           decoder, volume.notes);
    for (const auto& named : header.data_files) {
        auto data = open_named(header, path, named, max_bytes, volume);
        if (!data) return data.error();
        const FileOfSamples one{
            .path = volume.files.back(), .file = &*data, .samples = header.stored / header.data_files.size()};
        if (auto done = decode_file(header, one, 0, decoder, volume.notes); !done) return done;
    }
    return {};
}

}  // namespace thaum::field

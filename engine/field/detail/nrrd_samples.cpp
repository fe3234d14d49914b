#include "field/detail/nrrd_samples.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/file.h"
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

std::span<const std::byte> bytes_of(std::string_view s) { return std::as_bytes(std::span(s)); }

std::string_view characters_of(std::span<const std::byte> bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// The stored samples of one file.
struct FileOfSamples {
    Path path;
    std::span<const std::byte> bytes;  ///< bytes after the header, if the samples are in the same file
    std::size_t samples{};             ///< number of samples that the header promises
    std::size_t not_read{};            ///< number of bytes at the end of the file that were not read
};

/// Returns the bytes after the lines that the header says to skip.
std::span<const std::byte> behind_lines(std::span<const std::byte> data, std::size_t lines) {
    for (; lines > 0 && !data.empty(); --lines) {
        const auto end = std::ranges::find(data, std::byte{'\n'});
        data = data.subspan(std::min(data.size(), static_cast<std::size_t>(end - data.begin()) + 1));
    }
    return data;
}

/// Name of the file in messages: "ball.raw" for a separate file of samples, "the file" for one that also
/// holds the header.
std::string name_in_message(const NrrdHeader& header, const FileOfSamples& file) {
    return header.data_files.empty() ? "the file" : file.path.filename().string();
}

// ---- bytes of another encoding ----------------------------------------------------------------------------

/// A format that the first bytes of a file reveal, and advice if the header promises another one.
struct Form {
    std::string_view begins;
    std::string_view name;
    std::string_view advice;
};
constexpr std::string_view as_gzip = "write 'encoding: gzip'";
constexpr std::string_view unpack = "unpack them and write 'encoding: raw'";
constexpr std::array forms{Form{"\x1f\x8b\x08", "gzip", as_gzip},
                           Form{"BZh", "bzip2", unpack},
                           Form{"PK\x03\x04", "zip", unpack},
                           Form{"\xfd"
                                "7zXZ",
                                "xz", unpack},
                           Form{"(\xb5/\xfd", "zstd", unpack},
                           Form{"\x78\x9c", "zlib", unpack},
                           Form{"\x78\xda", "zlib", unpack},
                           Form{"\x78\x01", "zlib", unpack}};

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
    const auto bytes = characters_of(file.bytes);
    const auto is = [&](std::string_view what, std::string_view advice) {
        return text("the samples in ", name_in_message(header, file), " are ", what, "; ", advice);
    };
    const std::size_t skipped = header.skipped_bytes < 0 ? 0 : static_cast<std::size_t>(header.skipped_bytes);
    const bool may_be_plain = header.encoding != NrrdEncoding::raw && !begins_with_text(bytes);
    if (may_be_plain && bytes.size() == skipped + size_of(header.type) * file.samples)
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
    const auto bytes = characters_of(file.bytes);
    const bool begins_so = bytes.starts_with("\n") || bytes.starts_with("\r\n");
    return begins_so && header.data_files.empty() ? "; the header seems to have an empty line too many" : "";
}

void note_more(const NrrdHeader& header, const FileOfSamples& file, std::vector<std::string>& notes) {
    const auto where = header.data_files.empty() ? "" : text(file.path.filename().string(), ": ");
    const auto type = header.encoding == NrrdEncoding::raw
                          ? other_type(header, file.samples, file.bytes.size() + file.not_read)
                          : "";
    // If at most two bytes are too many, they may be a line break before the samples, which would shift all
    // of them.
    const bool one_line_more =
        header.encoding == NrrdEncoding::raw && file.bytes.size() <= size_of(header.type) * file.samples + 2;
    const auto ends = one_line_more ? line_too_many(header, file) : "";
    notes.push_back(in_one_line(text(where, "what follows the samples is left out", type, ends)));
}

// ---- reading ----------------------------------------------------------------------------------------------

/// Unpacks gzip data and leaves out the skipped bytes, which are counted after unpacking.
Expected<std::string> unpacked(const NrrdHeader& header, const FileOfSamples& file, std::size_t promised,
                               std::vector<std::string>& notes) {
    if (!characters_of(file.bytes).starts_with("\x1f\x8b")) {
        if (const auto other = other_encoding(header, file); !other.empty())
            return fail_field(header, "encoding", other);
        return fail_field(header, "encoding",
                          text("the samples in ", name_in_message(header, file), " are no gzip bytes",
                               line_too_many(header, file)));
    }
    if (promised / max_packed > file.bytes.size())
        return fail_field(header, "sizes",
                          text("the header promises ", promised, " bytes of samples, but ", file.bytes.size(),
                               " bytes cannot hold them; copy the file again"));
    const bool from_end = header.skipped_bytes < 0;
    const std::size_t skipped = from_end ? 0 : static_cast<std::size_t>(header.skipped_bytes);
    auto start = unpack_gzip_start(file.bytes, promised + (from_end ? max_before_end : skipped));
    if (!start) return fail(in_one_line(text(file.path.string(), ": ", start.error().message)));
    if (start->bytes.size() < promised + skipped)
        return too_few(header, file, "bytes", promised,
                       start->bytes.size() - std::min(start->bytes.size(), skipped));
    if (from_end && start->goes_on)
        return fail_field(header, "byte skip",
                          text("more than ", max_before_end, " bytes are packed before the samples"));
    start->bytes.erase(0, from_end ? start->bytes.size() - promised : skipped);
    if (start->goes_on) note_more(header, file, notes);
    return std::move(start->bytes);
}

/// The samples of one file as bytes of the header's type: a part of the file, or unpacked into `from_gzip`.
Expected<std::span<const std::byte>> bytes_in(const NrrdHeader& header, FileOfSamples file,
                                              std::string& from_gzip, std::vector<std::string>& notes) {
    const std::size_t promised = size_of(header.type) * file.samples;
    if (header.encoding == NrrdEncoding::gzip) {
        auto words = unpacked(header, file, promised, notes);
        if (!words) return words.error();
        from_gzip = std::move(*words);
        return bytes_of(from_gzip).first(promised);
    }
    if (header.skipped_bytes >= 0) {
        file.bytes =
            file.bytes.subspan(std::min(file.bytes.size(), static_cast<std::size_t>(header.skipped_bytes)));
    } else if (file.bytes.size() > promised) {
        file.bytes = file.bytes.last(promised);
    }
    if (file.bytes.size() == promised) return file.bytes;
    if (const auto other = other_encoding(header, file); !other.empty())
        return fail_field(header, "encoding", other);
    if (file.bytes.size() < promised) return too_few(header, file, "bytes", promised, file.bytes.size());
    note_more(header, file, notes);
    return file.bytes.first(promised);
}

/// Truncates a number to an integer and limits it to the range of the type.
double whole_number(double value, SampleType type) {
    const auto [low, high] = limits_of(type);
    return std::clamp(std::trunc(value), low, high);
}

/// Appends numbers written as text, separated by blanks or commas, as the bytes of doubles.
Expected<void> append_numbers(const NrrdHeader& header, const FileOfSamples& file, Bytes& out,
                              std::vector<std::string>& notes) {
    const auto skipped = std::min(file.bytes.size(), static_cast<std::size_t>(header.skipped_bytes));
    std::string_view remaining = characters_of(file.bytes.subspan(skipped));
    const auto fault = [&](Error other) {
        const auto encoding = other_encoding(header, file);
        return encoding.empty() ? std::move(other) : fail_field(header, "encoding", encoding);
    };
    constexpr std::string_view between = " \t\r\n,";
    std::size_t changed = 0;
    for (std::size_t n = 0; n < file.samples; ++n) {
        remaining.remove_prefix(std::min(remaining.size(), remaining.find_first_not_of(between)));
        const auto word = remaining.substr(0, remaining.find_first_of(between));
        if (word.empty()) return fault(too_few(header, file, "numbers", file.samples, n));
        double value = number_of(word);
        if (std::isnan(value) && in_lower_case(word).find("nan") == std::string::npos)
            return fault(fail(in_one_line(
                text(file.path.string(), ": '", printable(word, 40), "' at place ", n + 1, " is no number",
                     word.find(';') == std::string_view::npos ? "" : "; write points, and blanks between"))));
        if (header.type < SampleType::float32) {
            const double whole = whole_number(value, header.type);
            if (whole != value && changed++ == 0)
                notes.push_back(
                    in_one_line(text("samples such as ", printable(word, 40), " are no numbers of the type '",
                                     name_of(header.type), "', and are made so")));
            value = whole;
        }
        const auto bytes = std::as_bytes(std::span(&value, 1));
        out.insert(out.end(), bytes.begin(), bytes.end());
        remaining.remove_prefix(word.size());
    }
    const auto more = remaining.find_first_not_of(between);
    if (more != std::string_view::npos && remaining.find(',') != std::string_view::npos)
        return fail_field(header, "sizes",
                          text("there are more than the ", file.samples,
                               " numbers that the header promises; numbers have points, not commas"));
    if (more != std::string_view::npos) note_more(header, file, notes);
    return {};
}

/// Reads as much of a file as its samples can occupy, and one byte more to notice a longer file.
Expected<Bytes> read_part(const NrrdHeader& header, const Path& path, std::size_t samples,
                          std::size_t max_bytes) {
    const bool ends_known =
        header.encoding == NrrdEncoding::raw && header.skipped_lines == 0 && header.skipped_bytes >= 0;
    if (!ends_known) return read_file(path, max_bytes);
    return read_start(path,
                      static_cast<std::size_t>(header.skipped_bytes) + samples * size_of(header.type) + 1);
}

/// Number of bytes of a file after the first `read` bytes.
std::size_t rest_of(const Path& path, std::size_t read) {
    std::error_code error;
    const auto size = std::filesystem::file_size(path, error);
    return error || size < read ? 0 : static_cast<std::size_t>(size) - read;
}

/// Reads one of the files that a header names, and adds its path to the volume.
Expected<Bytes> read_named(const NrrdHeader& header, const Path& path, const NrrdDataFile& named,
                           std::size_t max_bytes, Volume& volume) {
    const auto place = sample_file(path, named.name);
    std::error_code ignored;
    if (!std::filesystem::exists(place, ignored))
        return fail(in_one_line(text(header.path, ":", named.line, ": field 'data file': there is no file '",
                                     printable(named.name, 200), "'; put it beside the header, or name one (",
                                     place.lexically_normal().string(), " was looked for)")));
    if (const auto note = note_on_place(path, named.name, place); !note.empty() && volume.files.size() == 1)
        volume.notes.push_back(note);
    auto bytes = read_part(header, place, header.stored / header.data_files.size(), max_bytes);
    if (!bytes)
        return Error{
            in_one_line(text(header.path, ":", named.line, ": field 'data file': ", bytes.error().message))};
    volume.files.push_back(place);
    return bytes;
}

}  // namespace

Expected<void> read_nrrd_samples(const NrrdHeader& header, const Path& path, std::size_t max_bytes,
                                 NrrdSamples& out, Volume& volume) {
    const auto take = [&](const Path& from, std::span<const std::byte> bytes, std::size_t samples,
                          std::size_t not_read) -> Expected<void> {
        const FileOfSamples one{from, behind_lines(bytes, header.skipped_lines), samples, not_read};
        if (header.encoding == NrrdEncoding::ascii)
            return append_numbers(header, one, out.joined, volume.notes);
        const auto part = bytes_in(header, one, out.from_gzip, volume.notes);
        if (!part) return part.error();
        if (samples == header.stored)
            out.all = *part;  // not copied, because a scan may be large
        else
            out.joined.insert(out.joined.end(), part->begin(), part->end());
        return {};
    };
    volume.files = {path};
    if (header.data_files.empty()) {
        const auto data =
            std::span<const std::byte>(out.file).subspan(std::min(header.data_at, out.file.size()));
        if (auto done = take(path, data, header.stored, 0); !done) return done;
    }
    for (const auto& named : header.data_files) {
        auto bytes = read_named(header, path, named, max_bytes, volume);
        if (!bytes) return bytes.error();
        out.file = std::move(*bytes);
        const auto& place = volume.files.back();
        if (auto done = take(place, out.file, header.stored / header.data_files.size(),
                             rest_of(place, out.file.size()));
            !done)
            return done;
    }
    if (out.all.empty()) out.all = out.joined;
    return {};
}

}  // namespace thaum::field

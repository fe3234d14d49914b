// tests/unit/xml.h: a small strict parser that tests whether our output is well-formed XML. It knows
// elements, attributes in double quotes and the five entities, but no declarations, comments or CDATA
// sections, which our output does not use.
#pragma once
#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "core/text.h"

namespace thaum::test {

class XmlReader {
public:
    explicit XmlReader(std::string_view xml) : remaining_(xml), whole_(xml.size()) {}

    /// First fault and its position (bytes); empty: the text is well-formed.
    std::string fault() {
        while (!remaining_.empty() && fault_.empty()) {
            if (remaining_.front() == '<') {
                read_tag();
            } else {
                read_words(remaining_.find('<'), open_.empty());
            }
        }
        if (fault_.empty() && !open_.empty()) blame("an element is never closed");
        if (fault_.empty() && roots_ != 1) blame("there must be one root");
        return fault_;
    }

private:
    void blame(std::string_view what) { fault_ = text(what, " at byte ", whole_ - remaining_.size()); }

    static bool is_name(char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
               c == '_';
    }

    std::string_view take(std::size_t n) {
        const auto taken = remaining_.substr(0, n);
        remaining_.remove_prefix(taken.size());
        return taken;
    }

    std::string_view take_name() {
        std::size_t n = 0;
        while (n < remaining_.size() && is_name(remaining_[n])) ++n;
        if (n == 0) blame("a name is missing");
        return take(n);
    }

    void skip_space() { take(std::min(remaining_.find_first_not_of(" \n"), remaining_.size())); }

    void read_words(std::size_t length, bool space_only) {
        const auto words = remaining_.substr(0, length);
        for (std::size_t i = 0; i < words.size(); ++i) {
            const auto c = static_cast<unsigned char>(words[i]);
            if ((c < 0x20 && c != '\n') || c == '<') return blame("a character that XML forbids");
            if (words.substr(i).starts_with("\xEF\xBF\xBF")) return blame("a character that XML forbids");
            if (space_only && c != ' ' && c != '\n') return blame("words outside the root");
            if (c == '&' && !is_entity(words.substr(i))) return blame("a bare ampersand");
        }
        take(words.size());
    }

    static bool is_entity(std::string_view at) {
        for (const auto* entity : {"&amp;", "&lt;", "&gt;", "&quot;", "&apos;"}) {
            if (at.starts_with(entity)) return true;
        }
        return false;
    }

    void read_tag() {
        take(1);
        if (remaining_.starts_with('/')) return read_end();
        const auto name = take_name();
        if (open_.empty()) ++roots_;
        std::vector<std::string_view> attributes;
        for (skip_space(); fault_.empty() && !remaining_.starts_with('>') && !remaining_.starts_with("/>");
             skip_space())
            read_attribute(attributes);
        if (!fault_.empty()) return;
        if (take(1) == "/") {
            take(1);
        } else {
            open_.push_back(name);
        }
    }

    void read_attribute(std::vector<std::string_view>& seen) {
        const auto name = take_name();
        if (!fault_.empty()) return;
        for (const auto other : seen) {
            if (other == name) return blame("an attribute is given twice");
        }
        seen.push_back(name);
        if (take(2) != "=\"") return blame("an attribute without a value");
        read_words(std::min(remaining_.find('"'), remaining_.size()), false);
        if (fault_.empty() && take(1) != "\"") blame("quotes that do not end");
    }

    void read_end() {
        take(1);
        const auto name = take_name();
        if (open_.empty() || open_.back() != name || take(1) != ">")
            return blame("an end that closes nothing");
        open_.pop_back();
    }

    std::string_view remaining_;
    std::size_t whole_;
    std::vector<std::string_view> open_;
    std::size_t roots_ = 0;
    std::string fault_;
};

inline std::string xml_fault(std::string_view xml) { return XmlReader(xml).fault(); }

}  // namespace thaum::test

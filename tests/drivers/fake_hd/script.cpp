#include "drivers/fake_hd/script.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>

namespace thaum::fake_hd {
namespace {

std::vector<Place> read_path(const std::string& file) {
    std::vector<Place> path;
    std::ifstream in(file);
    for (std::string line; std::getline(in, line);) {
        Place p;
        std::istringstream words(line);
        if (words >> p.ms >> p.target.x >> p.target.y >> p.target.z >> p.buttons) {
            p.target *= 1e-3;
            path.push_back(p);
        }
    }
    return path;
}

}  // namespace

bool Script::is(const char* word, const char* value) const {
    const auto found = words.find(word);
    return found != words.end() && found->second == value;
}

std::uint64_t Script::number(const char* word) const {
    const auto found = words.find(word);
    return found == words.end() ? 0 : std::strtoull(found->second.c_str(), nullptr, 10);
}

std::string Script::of(const char* word) const {
    const auto found = words.find(word);
    return found == words.end() ? "" : found->second;
}

Script script_of(const std::string& text) {
    Script script;
    std::istringstream words(text);
    for (std::string word; std::getline(words, word, ',');) {
        const auto is = word.find('=');
        script.words[word.substr(0, is)] = is == std::string::npos ? "" : word.substr(is + 1);
    }
    if (script.has("path")) script.path = read_path(script.words["path"]);
    return script;
}

Script read_script() {
    const char* told = std::getenv("FAKE_HD");
    return script_of(told != nullptr ? told : "");
}

Script read_second_script() {
    const char* told = std::getenv("FAKE_HD_SECOND");
    return script_of(told != nullptr ? told : "absent");
}

Place place_at(const std::vector<Place>& path, double ms) {
    if (path.empty()) return {};
    const auto next = std::find_if(path.begin(), path.end(), [&](const Place& p) { return p.ms > ms; });
    if (next == path.begin()) return path.front();
    if (next == path.end()) return path.back();
    const auto& before = *(next - 1);
    const double share = (ms - before.ms) / (next->ms - before.ms);
    return {ms, before.target + share * (next->target - before.target), before.buttons};
}

}  // namespace thaum::fake_hd

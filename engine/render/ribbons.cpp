#include "render/ribbons.h"

#include <algorithm>
#include <cmath>

namespace thaum::render {
namespace {

fvec3 colour_of(double speed, const RibbonLook& look) {
    if (look.colours == nullptr) return fvec3(1);
    const double share = (speed - look.slowest) / (look.fastest - look.slowest);
    // A NaN fails this form of the test and gives the first colour.
    const double index = share > 0 ? std::min(255 * share, 255.0) : 0.0;
    return look.colours->at(static_cast<std::size_t>(std::lround(index)));
}

void add_side(std::span<const field::StreamPoint> line, const RibbonLook& look, float facing, MeshData& out) {
    const auto first = static_cast<std::uint32_t>(out.vertices.size());
    for (const auto& point : line) {
        const auto to_end = std::min(point.way, line.back().way - point.way);
        const float half = 0.5F * std::min(look.width, static_cast<float>(to_end));
        const fvec3 place(point.place), across(point.across);
        const fvec3 normal = facing * fvec3(glm::cross(point.along, point.across));
        const fvec3 colour = colour_of(point.speed, look);
        for (const float side : {-1.0F, 1.0F})
            out.vertices.push_back(
                {.position = place + side * half * across, .normal = normal, .colour = colour});
    }
    for (std::uint32_t i = first; i + 3 < out.vertices.size(); i += 2) {
        const std::uint32_t left = i + (facing > 0 ? 0U : 1U), right = i + (facing > 0 ? 1U : 0U);
        out.indices.insert(out.indices.end(), {left, left + 2, right, right, left + 2, right + 2});
    }
}

}  // namespace

MeshData ribbon(std::span<const field::StreamPoint> line, const RibbonLook& look) {
    MeshData out;
    if (line.size() < 2) return out;
    add_side(line, look, 1, out);
    add_side(line, look, -1, out);
    return out;
}

std::size_t Ribbons::update(Renderer& renderer, const field::VectorField& field, std::span<const vec3> seeds,
                            const field::StreamlineSettings& settings, const RibbonLook& look,
                            std::uint64_t version) {
    const bool anew = version != version_;
    std::size_t traced = 0;
    for (std::size_t i = 0; i < std::max(seeds.size(), used_); ++i) {
        if (i >= seeds.size()) {
            renderer.replace(all_[i].mesh, {});
            continue;
        }
        if (!anew && i < used_ && all_[i].seed == seeds[i]) continue;
        field::trace(field, seeds[i], settings, line_);
        const auto mesh = ribbon(line_, look);
        if (i == all_.size())
            all_.push_back({renderer.upload(mesh), seeds[i]});
        else
            renderer.replace(all_[i].mesh, mesh);
        all_[i].seed = seeds[i];
        ++traced;
    }
    used_ = seeds.size();
    version_ = version;
    glow_ = look.glow;
    return traced;
}

std::span<const Instance> Ribbons::instances(const fmat4& model) {
    instances_.clear();
    for (std::size_t i = 0; i < used_; ++i)
        instances_.push_back({.mesh = all_[i].mesh, .model = model, .glow = glow_});
    return instances_;
}

}  // namespace thaum::render

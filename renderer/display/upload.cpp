#include "display/upload.h"

#include <algorithm>
#include <glm/vec2.hpp>
#include <vector>

namespace brewster {
namespace {

/// Sends the next elements of `texels`, as far as `bytes` go, and takes them off both accounts.
template <class Texel>
void send(const std::vector<Texel>& texels, TexelArray& target, std::size_t& done, std::size_t& bytes) {
    static_assert(sizeof(Texel) == 8 || sizeof(Texel) == 16);
    const std::size_t count = std::min(texels.size() - done, bytes / sizeof(Texel));
    target.write(done, count, texels.data() + done);
    done += count;
    bytes -= count * sizeof(Texel);
}

}  // namespace

BinUpload::BinUpload(TexelStorage storage) : sides_{Side(storage), Side(storage)} {}

void BinUpload::submit(std::shared_ptr<const Snapshot> bins) {
    const std::shared_ptr<const Snapshot>& newest = waiting_ ? waiting_ : arriving_ ? arriving_ : drawn_;
    if (newest != bins) waiting_ = std::move(bins);
}

void BinUpload::begin() {
    arriving_ = std::move(waiting_);
    waiting_ = nullptr;
    nodes_done_ = leaves_done_ = gloss_nodes_done_ = gloss_leaves_done_ = 0;
    Side& side = sides_[1 - drawn_side_];
    side.nodes.reserve(arriving_->nodes.size());
    side.leaves.reserve(arriving_->leaves.size());
    std::vector<glm::uvec2> roots;
    const std::vector<std::uint32_t>& gloss = arriving_->gloss.roots;
    for (std::size_t i = 0; i < arriving_->charts.size(); ++i) {
        roots.emplace_back(arriving_->charts[i].direct_root, arriving_->charts[i].indirect_root);
        roots.emplace_back(i < gloss.size() ? gloss[i] : no_root, 0u);
    }
    side.gloss_nodes.reserve(std::max<std::size_t>(1, arriving_->gloss.nodes.size()));
    side.gloss_leaves.reserve(std::max<std::size_t>(1, arriving_->gloss.leaves.size()));
    side.roots.reserve(roots.size());
    side.roots.write(0, roots.size(), roots.data());
}

bool BinUpload::advance(std::size_t bytes) {
    if (!arriving_ && !waiting_) return false;
    if (!arriving_) begin();
    Side& side = sides_[1 - drawn_side_];
    send(arriving_->nodes, side.nodes, nodes_done_, bytes);
    send(arriving_->leaves, side.leaves, leaves_done_, bytes);
    send(arriving_->gloss.nodes, side.gloss_nodes, gloss_nodes_done_, bytes);
    send(arriving_->gloss.leaves, side.gloss_leaves, gloss_leaves_done_, bytes);
    if (nodes_done_ < arriving_->nodes.size() || leaves_done_ < arriving_->leaves.size() ||
        gloss_nodes_done_ < arriving_->gloss.nodes.size() || gloss_leaves_done_ < arriving_->gloss.leaves.size())
        return false;
    drawn_ = std::move(arriving_);
    arriving_ = nullptr;
    drawn_side_ = 1 - drawn_side_;
    return true;
}

glm::uvec2 BinUpload::world_offsets(int world) const {
    return drawn_ ? glm::uvec2(drawn_->direct_offset(world), drawn_->indirect_offset(world)) : glm::uvec2(0u);
}

void BinUpload::bind(const Program& program, int first_unit) const {
    const Side& side = sides_[drawn_side_];
    int unit = first_unit;
    for (const auto& [name, texels] :
         {std::pair("bin_nodes", &side.nodes), std::pair("bin_leaves", &side.leaves),
          std::pair("chart_roots", &side.roots), std::pair("gloss_nodes", &side.gloss_nodes),
          std::pair("gloss_leaves", &side.gloss_leaves)}) {
        if (program.has(name)) texels->bind(program, name, unit);
        ++unit;
    }
}

}  // namespace brewster
